"""An arm command under way: `@STEP` and `@CLOSE` moving, `@SET` in manual mode.

The driver behind `ArmCommands` does the moving; here the program waits for it, and BREAK ends it.
"""

from __future__ import annotations

from trs80arm.basic.activity import Waiting
from trs80arm.basic.execution import break_
from trs80arm.basic.host import Progress
from trs80arm.basic.state import Activity, State


class ArmMotion(Activity):
    """A motion that was begun on `Host.arm`.

    Args:
        manual: whether it is `@SET`, which waits for the operator.
    """

    _manual: bool

    def __init__(self, *, manual: bool = False) -> None:
        self._manual = manual

    @property
    def waiting(self) -> Waiting:
        """SET in manual mode; a machine that moves the arm waits for nobody."""
        return Waiting.SET if self._manual else Waiting.NOTHING

    def advance(self, state: State) -> None:
        """Carry on with the motion up to the clock's limit."""
        arm = state.host.arm
        progress = Progress.DONE if arm is None else arm.advance()
        if progress is Progress.BUSY:
            return
        if self._manual or progress is Progress.BREAK:
            # The key that ended it is still down and must not be typed into what comes next.
            while state.host.console.scan():
                pass
        if progress is Progress.BREAK:
            break_(state)
        else:
            state.end()
