"""Words that end a program or work on it: END, CONT, NEW, TRON, LIST; and REM and DATA, passed."""

from __future__ import annotations

from trs80arm.basic.compiler.draft import Draft
from trs80arm.basic.words import Word


class CommandCompiler:
    """Commands.

    Args:
        draft: the statement.
    """

    def __init__(self, draft: Draft) -> None:
        self._draft = draft
        self._reader = draft.reader
        self._out = draft.out

    def end(self, _word: Word) -> None:
        """END: to command level; CONT goes on behind it."""
        if self._reader.at_end:
            self._out.charge()
            self._out.emit(f"end_program({self._out.address(self._reader.address)})")

    def stop(self, _word: Word) -> None:
        """STOP: `Break in n`."""
        if self._reader.at_end:
            self._out.charge()
            self._out.emit(f"stop_program({self._out.address(self._reader.address)})")

    def cont(self, word: Word) -> bool:
        """CONT; what stands behind it is not looked at."""
        self._out.go_to_found(f"{word.calls}()")
        return False

    def new(self, word: Word) -> None:
        """NEW."""
        if self._reader.at_end:
            self._out.charge()
            self._out.emit(f"{word.calls}()")

    def trace_on(self, word: Word) -> None:
        """TRON."""
        self._trace(word, on=True)

    def trace_off(self, word: Word) -> None:
        """TROFF."""
        self._trace(word, on=False)

    def _trace(self, word: Word, *, on: bool) -> None:
        self._out.emit(f"{word.calls}({on})")
        self._out.charge()
        self._out.emit(f"leave({self._out.address(self._reader.address)})")

    def with_text(self, word: Word) -> None:
        """A command that reads the rest of the line by itself."""
        self._out.charge()
        length = len(self._reader.text) - self._reader.position
        self._out.emit(
            f"{word.calls}(text_at({length}, {self._out.address(self._reader.address)}))"
        )

    # -- passed -------------------------------------------------------------------------------

    def remark(self, word: Word) -> None:
        """REM and ELSE: the rest of the line is nothing."""
        self._out.cost += word.work
        self._reader.skip_rest()

    def data(self, _word: Word) -> None:
        """DATA met in passing."""
        self._reader.skip_statement()
