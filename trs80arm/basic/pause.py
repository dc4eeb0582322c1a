"""The pause of SHIFT+@: a program or a listing stands still until another key is pressed.

That key is what INKEY$ gets next; whoever began the pause looks whether it is BREAK (Level II
facts, Typing).
"""

from __future__ import annotations

from trs80arm.basic import keyboard
from trs80arm.basic.activity import Waiting
from trs80arm.basic.state import Activity, State


class Pause(Activity):
    """Waits for a key and gives its code as its result."""

    @property
    def waiting(self) -> Waiting:
        """PAUSE."""
        return Waiting.PAUSE

    def advance(self, state: State) -> None:
        """Wait."""
        code = keyboard.next_key(state)
        if code:
            keyboard.latch(state, code)
            state.end(code)
