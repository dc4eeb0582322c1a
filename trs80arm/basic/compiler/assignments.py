"""Statements that give variables values: LET, DIM, READ, INPUT, CLEAR and the DEF words."""

from __future__ import annotations

from dataclasses import dataclass

from trs80arm.basic import characters, costs, room, tokens
from trs80arm.basic.characters import COMMA, OPEN
from trs80arm.basic.compiler import pieces
from trs80arm.basic.compiler.draft import Draft, Mistake
from trs80arm.basic.compiler.expressions import ExpressionCompiler, listed, to_subscript
from trs80arm.basic.compiler.values import Expression
from trs80arm.basic.control import DIRECT
from trs80arm.basic.errors import Code
from trs80arm.basic.kinds import SIZES, STRING, Kind
from trs80arm.basic.variables import Key
from trs80arm.basic.words import Word


@dataclass(frozen=True)
class Target:
    """A variable or an element that a statement gives a value.

    Attributes:
        kind: its type.
        text: what stands left of `=` in Python; for a string the descriptor.
        reference: Python text that makes an object to assign to later (INPUT).
    """

    kind: Kind
    text: str
    reference: str


class AssignmentCompiler:
    """Assignments.

    Args:
        draft: the statement.
        expressions: who reads the values.
        line: the number of the line that is compiled, 65535 for a direct one.
        program_start: where the program begins; literals behind it stay where they stand.
    """

    def __init__(
        self, draft: Draft, expressions: ExpressionCompiler, line: int, program_start: int
    ) -> None:
        self._draft = draft
        self._program_start = program_start
        self._reader = draft.reader
        self._out = draft.out
        self._scope = draft.scope
        self._expressions = expressions
        self._line = line

    # -- targets ------------------------------------------------------------------------------

    def target(self, *, arrays: bool = True) -> Target:
        """The variable that stands here, made if it does not exist (260DH).

        Args:
            arrays: whether it may be an element.
        """
        key = self._expressions.name()
        if arrays and self._reader.code == OPEN:
            return self._element_target(key)
        return self._scalar_target(key)

    def _scalar_target(self, key: Key) -> Target:
        scalar = self._scope.scalar(key)
        self._out.cost += costs.VARIABLE + self._scope.search(scalar)
        name = self._out.constant(key)
        if not self._scope.exists(key):
            self._out.emit(f"create({name})")
        text = self._out.cell(self._scope.cell_name(key), scalar.cell, stored=key[1] != STRING)
        return Target(key[1], text, f"scalar_reference({name})")

    def _element_target(self, key: Key) -> Target:
        array, subscripts = self._expressions.subscripts(key)
        name = self._out.constant(key)
        if array is None:
            place = self._out.keep(f"place({name}, {listed(subscripts)})")
            text = f"{place}[0][{place}[1]]"
            return Target(key[1], text, f"element_reference({name}, {place}[1])")
        index = self._expressions.index(array, subscripts)
        place = index.text if index.simple else self._out.keep(index.text)
        text = f"{self._expressions.array(key)}[{place}]"
        return Target(key[1], text, f"element_reference({name}, {place})")

    def store(self, target: Target, value: Expression) -> None:
        """Assign; TM between numbers and strings."""
        if (target.kind == STRING) != (value.kind == STRING):
            raise self._draft.mistake(Code.TM, value)
        if target.kind == STRING:
            self._out.cost += costs.STORE_STRING
            self._draft.paced = True
            piece = value.piece
            if piece is not None and piece.stored:
                pieces.store(self._out, target.text, piece)
            elif piece is not None and piece.place > self._program_start:
                pieces.point_to(self._out, target.text, piece)
            else:
                self._out.emit(f"assign({target.text}, {value.text})")
            self._out.know_string(target.text, piece.text if piece and piece.certain else None)
            return
        self._out.cost += costs.store(target.kind, value.held)
        converted = self._expressions.convert.to_kind(value, target.kind)
        self._out.emit(f"{target.text} = {converted.text}")

    # -- statements ---------------------------------------------------------------------------

    def let(self, word: Word) -> None:
        """`variable = expression`."""
        self._out.cost += word.work
        target = self.target()
        self._draft.expect(tokens.EQUAL)
        with self._draft.deeper(room.LET):
            value = self._expressions.expression()
        self.store(target, value)

    def dim(self, word: Word) -> None:
        """DIM: arrays of given size; simple variables are made too."""
        while True:
            self._out.cost += word.work
            key = self._expressions.name()
            if self._reader.code == OPEN:
                sizes = self._expressions.subscript_list(of_dim=True)
                self._out.cost += costs.ARRAY + self._scope.array_search(key)
                sizes = [to_subscript(size) for size in sizes]
                self._out.emit(f"{word.calls}({self._out.constant(key)}, {listed(sizes)})")
            else:
                self._scalar_target(key)
            if self._reader.at_end:
                return
            self._draft.expect(COMMA)

    def read(self, word: Word) -> None:
        """READ: the next DATA items into variables; only then are they used up."""
        self._out.emit("begin_read()")
        while True:
            self._out.cost += word.work
            target = self.target()
            if target.kind == STRING:
                self._out.emit(f"assign({target.text}, read_string())")
                self._out.know_string(target.text, None)
            else:
                kind = self._out.constant(target.kind)
                self._out.emit(f"{target.text} = read_number({kind})")
            self._out.emit("end_item()")
            if self._reader.code != COMMA:
                break
            self._reader.advance()
        self._out.emit("end_read()")

    def input(self, _word: Word) -> None:
        """INPUT: leave the asking to the dialogue, the variables are looked up when it answers."""
        reader = self._reader
        if reader.code == characters.NUMBER_SIGN:
            self._input_tape()
            return
        self._not_direct()
        prompt = "b''"
        if reader.code == characters.QUOTE:
            length, address = reader.string_literal()
            prompt = f"text_at({length}, {self._out.address(address)})"
            self._draft.expect(characters.SEMICOLON)
        self._out.charge()
        self._out.emit(f"begin_input({prompt}, {self._out.address(reader.address)})")

    def _not_direct(self) -> None:
        if self._line == DIRECT:
            raise Mistake(Code.ID)

    def _input_tape(self) -> None:
        unit = self.tape_unit()
        self._not_direct()
        self._out.charge()
        self._out.emit(f"begin_tape_input({unit}, {self._out.address(self._reader.address)})")

    def tape_unit(self) -> str:
        """`#-1,` or `#-2,`; FC for another number."""
        self._reader.advance()
        unit = self._out.keep(self._expressions.integer().text)
        self._draft.expect(COMMA)
        self._out.emit(f"tape_unit({unit})")
        return unit

    def define(self, word: Word) -> bool:
        """DEFINT and so on: the type of names by their first letter, from now on."""
        self._out.cost += word.work
        assert word.gives is not None
        size = SIZES[word.gives]
        reader = self._reader
        while True:
            first = last = self._letter()
            if reader.code == tokens.MINUS:
                reader.advance()
                last = self._letter()
            if last < first:
                raise Mistake(Code.SN)
            self._out.emit(f"{word.calls}({size}, {first}, {last})")
            if reader.code != COMMA:
                break
            reader.advance()
        self._out.charge()
        self._out.emit(f"leave({self._out.address(reader.address)})")
        return False

    def _letter(self) -> int:
        code = self._reader.code
        if not characters.is_letter(code):
            raise Mistake(Code.SN)
        self._reader.advance()
        return code

    def clear(self, word: Word) -> None:
        """CLEAR [n]: forget all variables; n bytes of string space."""
        self._out.cost += word.work
        if self._reader.at_end:
            self._out.emit("clear_all()")
            return
        size = self._out.keep(self._expressions.whole().text)
        self._reader.skip()
        if self._reader.at_end:
            self._out.emit(f"clear_strings({size})")
