"""Statements that give variables values: LET, DIM, READ, INPUT, CLEAR and the DEF words."""

from __future__ import annotations

from dataclasses import dataclass

from trs80arm.basic import costs, room, tokens
from trs80arm.basic.compiler.functions import FunctionCompiler
from trs80arm.basic.compiler.values import Expression
from trs80arm.basic.control import DIRECT
from trs80arm.basic.errors import Code
from trs80arm.basic.variables import SIZES, STRING, Key


@dataclass(frozen=True)
class Target:
    """A variable or an element that a statement gives a value.

    Attributes:
        text: what stands left of `=` in Python; for a string the descriptor.
        reference: Python text that makes an object to assign to later (INPUT).
    """

    kind: str
    text: str
    reference: str


class AssignmentCompiler(FunctionCompiler):
    """Assignments.

    Attributes:
        line: the number of the line that is compiled, 65535 for a direct one.
    """

    line: int

    def target(self, arrays: bool = True) -> Target:
        """The variable that stands here, made if it does not exist (260DH)."""
        key = self.name()
        if arrays and self.reader.code == 0x28:
            return self._element_target(key)
        return self._scalar_target(key)

    def _scalar_target(self, key: Key) -> Target:
        scalar = self.scope.scalar(key)
        self.out.cost += costs.VARIABLE + self.scope.search(scalar)
        if not self.scope.exists(key):
            self.out.emit(f"create({key!r})")
        name = self.out.cell(self.scope.cell_name(key), scalar.cell, stored=key[1] != STRING)
        return Target(key[1], name, f"scalar_reference({key!r})")

    def _element_target(self, key: Key) -> Target:
        array, subscripts = self.subscripts(key)
        if array is None:
            place = self.out.keep(f"place({key!r}, {', '.join(subscripts)})")
            text = f"{place}[0][{place}[1]]"
            return Target(key[1], text, f"element_reference({key!r}, {place}[1])")
        name = self.out.cell(self.scope.array_name(key), self.scope.array_cell(key))
        index = self.index(array, subscripts)
        if not index.isdigit():
            index = self.out.keep(index)
        return Target(key[1], f"{name}[{index}]", f"element_reference({key!r}, {index})")

    def store(self, target: Target, value: Expression) -> None:
        """Assign; TM between numbers and strings."""
        if (target.kind == STRING) != (value.kind == STRING):
            self.pending.append(value.text)
            raise self.mistake(Code.TM)
        if target.kind == STRING:
            self.out.cost += costs.STORE_STRING
            self.plain = False
            self.out.emit(f"assign({target.text}, {value.text})")
            return
        self.out.cost += costs.store(target.kind, value.held)
        self.out.emit(f"{target.text} = {self.to_kind(value, target.kind)}")

    def let(self) -> None:
        """`variable = expression`."""
        self.out.cost += costs.STATEMENT_WORK["LET"]
        target = self.target()
        self.expect(tokens.EQUAL)
        self.deepen(room.LET)
        value = self.expression()
        self.deepen(-room.LET)
        self.store(target, value)

    def dim(self) -> None:
        """DIM: arrays of given size; simple variables are made too."""
        while True:
            self.out.cost += costs.STATEMENT_WORK["DIM"]
            key = self.name()
            if self.reader.code == 0x28:
                self._dimension(key)
            else:
                self._scalar_target(key)
            if self.reader.at_end:
                return
            self.expect(0x2C)

    def _dimension(self, key: Key) -> None:
        sizes: list[str] = []
        while True:
            self.reader.advance()
            sizes.append(f"subscript({self.number().text})")
            self.pending.append(sizes[-1])
            self.out.cost += costs.SUBSCRIPT
            if self.reader.code != 0x2C:
                break
        if self.reader.code not in (0x29, 0x5D):
            raise self.mistake(Code.SN)
        self.reader.advance()
        self.pending.clear()
        self.out.cost += costs.ARRAY + self.scope.array_search(key)
        self.out.emit(f"dimension({key!r}, {', '.join(sizes)})")

    def read(self) -> None:
        """READ: the next DATA items into variables; only then are they used up."""
        self.out.emit("begin_read()")
        while True:
            self.out.cost += costs.STATEMENT_WORK["READ"]
            target = self.target()
            if target.kind == STRING:
                self.out.emit(f"assign({target.text}, read_string())")
            else:
                self.out.emit(f"{target.text} = read_number({target.kind!r})")
            if self.reader.code != 0x2C:
                break
            self.reader.advance()
        self.out.emit("end_read()")

    def input(self) -> None:
        """INPUT: leave the asking to the dialogue, the variables are looked up when it answers."""
        reader = self.reader
        if reader.code == 0x23:
            self._input_tape()
            return
        self._not_direct()
        prompt = "b''"
        if reader.code == 0x22:
            length, address = reader.string_literal()
            prompt = f"text_at({length}, {address})"
            self.expect(0x3B)
        self.out.charge()
        self.out.emit(f"begin_input({prompt}, {reader.address})")

    def _not_direct(self) -> None:
        if self.line == DIRECT:
            raise self.mistake(Code.ID)

    def _input_tape(self) -> None:
        unit = self.tape_unit()
        self._not_direct()
        self.out.charge()
        self.out.emit(f"begin_tape_input({unit}, {self.reader.address})")

    def tape_unit(self) -> str:
        """`#-1,` or `#-2,`; FC for another number."""
        self.reader.advance()
        unit = self.out.keep(self.integer())
        self.expect(0x2C)
        self.out.emit(f"tape_unit({unit})")
        return unit

    def targets(self) -> list[str]:
        """Python text for the references of INPUT's variables, each found in its turn."""
        references = []
        while True:
            target = self.target()
            references.append(self.out.keep(target.reference))
            if self.reader.code != 0x2C:
                return references
            self.reader.advance()

    def define(self, kind: str) -> None:
        """DEFINT and so on: the type of names by their first letter, from now on."""
        self.out.cost += costs.STATEMENT_WORK["DEF"]
        reader = self.reader
        while True:
            if not 0x41 <= reader.code <= 0x5A:
                raise self.mistake(Code.SN)
            first = last = reader.code
            if reader.advance() == tokens.MINUS:
                reader.advance()
                if not 0x41 <= reader.code <= 0x5A:
                    raise self.mistake(Code.SN)
                last = reader.code
                reader.advance()
            if last < first:
                raise self.mistake(Code.SN)
            self.out.emit(f"define({SIZES[kind]}, {first}, {last})")
            if reader.code != 0x2C:
                break
            reader.advance()
        self.leave()

    def clear(self) -> None:
        """CLEAR [n]: forget all variables; n bytes of string space."""
        self.out.cost += costs.STATEMENT_WORK["CLEAR"]
        if self.reader.at_end:
            self.out.emit("clear_all()")
            return
        size = self.out.keep(f"subscript({self.number().text})")
        self.reader.skip()
        if self.reader.at_end:
            self.out.emit(f"clear_strings({size})")

    def leave(self) -> None:
        """Go on at the next statement after the statement loop has looked around."""
        self.out.charge()
        self.out.emit(f"leave({self.reader.address})")
