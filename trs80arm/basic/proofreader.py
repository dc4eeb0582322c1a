"""Reads a program in memory as the compiler does, without running it: what would be an error there.

Every statement is compiled and thrown away. What the compiler found wrong in the text is certain to
be that error if the statement is reached; what depends on values shows only in a run.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Final

from trs80arm.basic import addresses, characters, tokens, words
from trs80arm.basic.characters import AT, COLON, COMMA, FIRST_LETTER
from trs80arm.basic.compiler.emitter import Emitter, TooDeep
from trs80arm.basic.compiler.reader import Reader
from trs80arm.basic.compiler.scope import Scope
from trs80arm.basic.compiler.statements import StatementCompiler
from trs80arm.basic.errors import Code
from trs80arm.basic.kinds import SIZES
from trs80arm.basic.program import LINE_HEAD
from trs80arm.basic.state import State

_DEFINES: Final = {
    token: SIZES[word.gives]
    for token, word in words.BY_TOKEN.items()
    if word.parser == "assignments.define" and word.gives is not None
}
_ASKING: Final = ("begin_input(", "begin_tape_input(")
"""With what generated text begins that has the variables of an INPUT looked up later."""
_WITH_TEXT: Final = re.compile(r"\w+\(text_at\(")
"""Generated text that hands the rest of the line on: LIST and so on."""
_MINUS = re.escape(bytes((tokens.MINUS,)))
_RANGE: Final = re.compile(rb"([A-Z])(?: *" + _MINUS + rb" *([A-Z]))?")


@dataclass(frozen=True, order=True)
class Misprint:
    """Something wrong in the text of a program.

    Attributes:
        line: the number of its line.
        position: how much of the line's crunched text stands before the place.
        code: the error that it is when the statement is reached.
        target: the line that a jump does not find; None where no number stands.
        too_many: a value stands there that `@STEP` does not take.
    """

    line: int
    position: int
    code: Code
    target: int | None = None
    too_many: bool = False


class _Reader(Reader):
    """A reader that remembers the line number that it read last."""

    number: int | None = None

    def digits(self) -> int | None:
        """A line number."""
        self.number = super().digits()
        return self.number


class _Proof(Emitter):
    """Takes down the errors of one statement; the function itself is never made."""

    def __init__(self, state: State, line: int, link: int) -> None:
        super().__init__()
        self._ram = state.memory.ram
        self._line = line
        first = link + LINE_HEAD
        self._first = first
        self.start = first
        self.reader = _Reader(b"", first, self)
        self.found: set[Misprint] = set()
        self.lists: list[int] = []
        self._left: object = None

    def read_from(self, start: int, text: bytes) -> _Reader:
        """The reader of the statement that begins at an address."""
        self.start = start
        self.reader = _Reader(text, start, self)
        self.reader.skip()
        return self.reader

    def fail(self, code: Code) -> None:
        """Take an error down, at the place that was read last."""
        reader = self.reader
        target = reader.number if code is Code.UL else None
        statement = reader.text[: reader.position]
        arm = bytes((AT, tokens.STEP)) in statement.replace(b" ", b"")
        too_many = arm and code is Code.SN and reader.code == COMMA
        self._take(code, reader.address, target, too_many)

    def emit(self, text: str) -> None:
        """See which statements leave what stands behind them to be read in the run."""
        if text.startswith(_ASKING):
            self._left = _ASKING
        elif _WITH_TEXT.match(text):
            self._left = _WITH_TEXT

    def go(self, address: int) -> None:
        """Control goes on at an address, where a statement has to end."""
        left, self._left = self._left, None
        if left is _ASKING:
            self.lists.append(address)
        elif left is None and self._ram[address] not in (characters.END, COLON):
            self._take(Code.SN, address)

    def _take(
        self, code: Code, address: int, target: int | None = None, too_many: bool = False
    ) -> None:
        self.found.add(Misprint(self._line, address - self._first, code, target, too_many))


def misprints(state: State) -> list[Misprint]:
    """What is wrong in the text of the program in memory, in its order.

    The types of names by DEFSTR and so on depend on the way that a run takes: what is an error with
    some of them only is not told.
    """
    found: set[Misprint] | None = None
    for types in _type_tables(state):
        errors = set(_with_types(state, types))
        found = errors if found is None else found & errors
    return sorted(found or ())


def _with_types(state: State, types: bytes) -> Iterator[Misprint]:
    program = state.program
    scope = Scope(state.variables, {}, types)
    for number in program.numbers():
        link = program.find(number)
        if link is None:
            continue
        for start in _statements(state, link + LINE_HEAD):
            proof = _Proof(state, number, link)

            def compiler_from(
                address: int, proof: _Proof = proof, line: int = number
            ) -> StatementCompiler:
                reader = proof.read_from(address, program.text_from(address))
                return StatementCompiler(reader, proof, scope, program, line, [], state.armbasic)

            try:
                if compiler_from(start).compile():
                    proof.go(proof.reader.address)
                for address in proof.lists:
                    _read_list(proof, compiler_from, address)
            except TooDeep:
                # Nested as no person writes; a run tells of it.
                continue
            yield from proof.found


def _read_list(
    proof: _Proof, compiler_from: Callable[[int], StatementCompiler], address: int
) -> None:
    """The variables of an INPUT, which looks them up when it is answered."""
    while True:
        before = len(proof.found)
        compiler_from(address).compile_target()
        if len(proof.found) > before:
            return
        if proof.reader.code != COMMA:
            proof.go(proof.reader.address)
            return
        proof.reader.advance()
        address = proof.reader.address


def _statements(state: State, first: int) -> Iterator[int]:
    """Where the statements of a line begin; what follows an ELSE belongs to its IF."""
    ram, start = state.memory.ram, first
    while True:
        code = _code(ram, start)
        if code == tokens.REM:
            return
        if code != tokens.ELSE:
            yield start
        end = state.program.statement_end(start)
        if ram[end] != COLON:
            return
        start = end + 1


def _code(ram: bytearray, address: int) -> int:
    while ram[address] in characters.BLANKS:
        address += 1
    return ram[address]


def _type_tables(state: State) -> list[bytes]:
    """The tables of types by first letter, after each DEFSTR, DEFINT and so on of the text."""
    ram = state.memory.ram
    start = addresses.TYPE_TABLE
    table = bytearray(ram[start : start + addresses.LETTERS])
    tables = {bytes(table): None}
    for _, text in state.program.lines():
        for part in text.split(b":"):
            size = _DEFINES.get(part.strip()[0]) if part.strip() else None
            if size is None:
                continue
            for first, last in _RANGE.findall(part):
                low, high = first[0], (last or first)[0]
                for letter in range(low, high + 1):
                    table[letter - FIRST_LETTER] = size
            tables[bytes(table)] = None
    return list(tables)
