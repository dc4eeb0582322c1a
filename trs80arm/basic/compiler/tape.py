"""Statements that reach the cassette recorder: CSAVE, CLOAD, SYSTEM and PRINT#-1."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from trs80arm.basic import tokens
from trs80arm.basic.characters import COMMA, SEMICOLON
from trs80arm.basic.compiler.assignments import AssignmentCompiler
from trs80arm.basic.compiler.draft import Draft, Mistake
from trs80arm.basic.compiler.expressions import ExpressionCompiler
from trs80arm.basic.kinds import STRING
from trs80arm.basic.words import Word


class TapeCompiler:
    """Statements of the tape.

    Args:
        draft: the statement.
        expressions: who reads names and items.
        assignments: who reads the recorder's number.
    """

    def __init__(
        self, draft: Draft, expressions: ExpressionCompiler, assignments: AssignmentCompiler
    ) -> None:
        self._draft = draft
        self._reader = draft.reader
        self._out = draft.out
        self._expressions = expressions
        self._assignments = assignments

    @contextmanager
    def _data(self) -> Iterator[None]:
        """What goes to the tape is evaluated into `data`; an error goes in its place.

        The ROM records the leader before it evaluates, so the error is only raised behind it.
        """
        out = self._out
        out.emit("try:")
        out.indent += 1
        try:
            yield
        except Mistake as mistake:
            self._draft.fail(mistake)
        out.indent -= 1
        out.emit("except BasicError as error:")
        out.emit("  data = error")
        out.charge()

    def print(self) -> None:
        """PRINT#-1, items."""
        self._assignments.tape_unit()
        out, reader = self._out, self._reader
        with self._data():
            out.emit("data = b''")
            newline = True
            while not reader.at_end:
                newline = reader.code not in (COMMA, SEMICOLON)
                if not newline:
                    if reader.code == COMMA:
                        out.emit("data += b','")
                    reader.advance()
                    continue
                value = self._expressions.expression()
                function = "tape_string" if value.kind == STRING else "tape_number"
                out.emit(f"data += {function}({value.text})")
            if newline:
                out.emit("data += b'\\r'")
        out.emit(f"begin_tape_print(data, {out.address(reader.address)})")

    def csave(self, word: Word) -> None:
        """CSAVE name."""
        with self._data():
            self._name()
        self._out.emit(f"{word.calls}(data, {self._out.address(self._reader.address)})")

    def _name(self) -> None:
        """A program's name into `data`."""
        self._out.emit(f"data = tape_string({self._expressions.string().text})")

    def cload(self, word: Word) -> None:
        """CLOAD [name] and CLOAD? [name]."""
        verify = self._reader.code == tokens.PRINT
        if verify:
            self._reader.advance()
        if self._reader.at_end:
            self._out.charge()
            self._out.emit("data = None")
        else:
            with self._data():
                self._name()
        self._out.emit(f"{word.calls}(data, {verify}, {self._out.address(self._reader.address)})")

    def system(self, word: Word) -> None:
        """SYSTEM; what stands behind it is not looked at."""
        self._reader.position = len(self._reader.text)
        self._out.charge()
        self._out.emit(f"{word.calls}()")
