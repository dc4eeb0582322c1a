"""What the machine is doing: a stack of activities, the topmost of which runs.

Nothing in the language blocks. Waiting for a line, for a key in EDIT, listing a program, running
one, or watching a motion of the arm are all activities: small picklable objects whose `advance`
works until the clock's limit and returns. When one ends it leaves the stack and the one below is
told.
"""

from __future__ import annotations

from enum import Enum
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from trs80arm.basic.interpreter import Interpreter


class Waiting(Enum):
    """What the machine waits for, as a person at the keyboard would put it."""

    NOTHING = "nothing"
    MEMORY_SIZE = "memory size"
    COMMAND = "command"
    AUTO = "auto"
    INPUT = "input"
    EDIT = "edit"
    PAUSE = "pause"
    SET = "manual mode"
    SYSTEM = "system"


class Activity:
    """One thing that the machine is doing."""

    @property
    def waiting(self) -> Waiting:
        """What this activity waits for; NOTHING while it works."""
        return Waiting.NOTHING

    def advance(self, basic: Interpreter) -> None:
        """Work until the clock reaches its limit, or until another activity is on top.

        An activity that waits for a key moves `Clock.now` straight on to the limit when
        `Console.quiet`. It must make progress: either time passes or the stack changes.
        """
        raise TypeError(f"{type(self).__name__} does not say how it advances")

    def resumed(self, basic: Interpreter, result: Any) -> None:
        """The activity above has ended, with its result."""
