"""One statement on its way through the compiler: what all parts of the statement compiler share."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Final

from trs80arm.basic import room
from trs80arm.basic.compiler.emitter import Emitter
from trs80arm.basic.compiler.reader import Reader
from trs80arm.basic.compiler.scope import Scope
from trs80arm.basic.compiler.values import Expression
from trs80arm.basic.errors import Code

MOST_RAM: Final = 0xC000
"""Bytes of RAM of the largest machine."""


class Mistake(Exception):  # noqa: N818 - a way of leaving, not a failure of ours
    """The text is wrong from here on: the rest of the statement is this error."""

    def __init__(self, code: Code) -> None:
        super().__init__(code.name)
        self.code = code


class Draft:
    """The state of one statement's compilation.

    The ROM evaluates while it reads, so a mistake in the text shows only when what stands before it
    has been evaluated. What was read but is in the function nowhere yet is pending; on a mistake it
    is written out, and then the error.

    Attributes:
        reader: the place in the text.
        out: the function under construction.
        scope: the variables that exist, and what was assumed about them.
        observes: whether the statement looks at the machine.
        plain: whether the statement may stand in a block.
        paced: whether it may take any time.
        depth: how deeply nested the expression at work is.
        stack_bytes: what the expression at work takes on the Z-80's stack.
    """

    def __init__(self, reader: Reader, out: Emitter, scope: Scope) -> None:
        self.reader = reader
        self.out = out
        self.scope = scope
        self.observes = False
        self.plain = True
        self.paced = False
        self.depth = 0
        self.stack_bytes = 0
        self._deepest = 0
        self._pending: list[Expression] = []

    def expect(self, code: int) -> None:
        """A character that must stand here (RST 8); SN if another one does."""
        if self.reader.code != code:
            raise Mistake(Code.SN)
        self.reader.advance()

    # -- what is pending ----------------------------------------------------------------------

    @contextmanager
    def pending(self, *values: Expression) -> Iterator[None]:
        """Values that were read, while what stands behind them is read."""
        count = len(self._pending)
        self._pending += values
        yield  # A mistake goes through: then they stay pending, for `flush`.
        del self._pending[count:]

    def mistake(self, code: Code, *values: Expression) -> Mistake:
        """The exception to raise for an error that shows when some values were evaluated."""
        self._pending += values
        return Mistake(code)

    def flush(self) -> None:
        """Write what was read of a statement that turned out to be wrong."""
        for value in self._pending:
            if not value.simple:
                self.out.emit(value.text)
        self._pending.clear()

    def fail(self, mistake: Mistake) -> None:
        """The rest of the statement, or of this branch of an IF, is an error."""
        self.flush()
        self.out.fail(mistake.code)
        self.depth = self.stack_bytes = 0

    # -- the Z-80's stack ---------------------------------------------------------------------

    @contextmanager
    def deeper(self, size: int) -> Iterator[None]:
        """What is read meanwhile finds so many bytes more of the Z-80's stack taken.

        OM if no machine has so much memory; whether this one has is seen when it runs.
        """
        self.stack_bytes += size
        if self.stack_bytes > MOST_RAM:
            raise Mistake(Code.OM)
        self._deepest = max(self._deepest, self.stack_bytes)
        yield
        self.stack_bytes -= size

    def need_room(self, size: int) -> None:
        """An expression is complete: it looks for room on the stack, where that may be missing."""
        if self.scope.tight or size + self._deepest > room.TIGHT:
            self.out.emit(f"room({size + self._deepest})")
        self._deepest = 0
