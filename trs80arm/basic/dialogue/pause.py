"""The pause of SHIFT+@: a program or a listing stands still until another key is pressed.

That key is what INKEY$ gets next; whoever began the pause looks whether it is BREAK (Level II
facts, Typing).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from trs80arm.basic.activity import Activity, Waiting
from trs80arm.basic.dialogue import wait

if TYPE_CHECKING:
    from trs80arm.basic.interpreter import Interpreter


class Pause(Activity):
    """Waits for a key and gives its code as its result."""

    @property
    def waiting(self) -> Waiting:
        """PAUSE."""
        return Waiting.PAUSE

    def advance(self, basic: Interpreter) -> None:
        """Wait."""
        code = wait.next_key(basic)
        if code:
            wait.latch(basic, code)
            basic.end(code)
