"""An arm command under way: `@STEP` and `@CLOSE` moving, `@SET` in manual mode.

The driver behind `ArmCommands` does the moving; here the program waits for it, and BREAK ends it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from trs80arm.basic.activity import Activity, Waiting
from trs80arm.basic.host import Progress

if TYPE_CHECKING:
    from trs80arm.basic.interpreter import Interpreter


class ArmMotion(Activity):
    """A motion that was begun on `Host.arm`.

    Args:
        manual: whether it is `@SET`, which waits for the operator.
    """

    def __init__(self, *, manual: bool = False) -> None:
        self._manual = manual

    @property
    def waiting(self) -> Waiting:
        """SET in manual mode; a machine that moves the arm waits for nobody."""
        return Waiting.SET if self._manual else Waiting.NOTHING

    def advance(self, basic: Interpreter) -> None:
        """Carry on with the motion up to the clock's limit."""
        arm = basic.host.arm
        progress = Progress.DONE if arm is None else arm.advance()
        if progress is Progress.BUSY:
            return
        if self._manual or progress is Progress.BREAK:
            # The key that ended it is still down and must not be typed into what comes next.
            while basic.host.console.scan():
                pass
        if progress is Progress.BREAK:
            basic.break_()
        else:
            basic.end()
