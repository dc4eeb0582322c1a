"""The line editor: what happens between a prompt and ENTER, at `>`, at INPUT and at AUTO's numbers.

It is the ROM's routine at 5D9H with its buffer where 40A7H points. Whoever wants a line begins
a `LineInput` and gets a `Line` as its result.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from trs80arm.basic import addresses, keyboard
from trs80arm.basic.activity import Waiting
from trs80arm.basic.addresses import word
from trs80arm.basic.characters import BLANK
from trs80arm.basic.state import Activity, State

LINE_LENGTH: Final = 240
"""Characters that a typed line holds; further keys are ignored (facts, Typing)."""

_BREAK, _LEFT, _RIGHT, _DOWN, _ENTER = 1, 8, 9, 10, 13
_SHIFT_LEFT, _SHIFT_RIGHT, _CLEAR = 24, 25, 31
_WIDE, _HOME, _ERASE = 23, 28, 31
_TAB = 8

# T-states of the editor beside display and keyboard, measured from key to key.
_T_FINISH: Final = 1210
_T_KEY: Final = 155


@dataclass(frozen=True)
class Line:
    """What was typed: the characters, or None when BREAK ended it."""

    text: bytes | None


class LineInput(Activity):
    """One line being typed.

    Args:
        waiting: what the machine waits for meanwhile.
    """

    _waiting: Waiting
    _line: bytearray
    _begun: bool

    def __init__(self, waiting: Waiting) -> None:
        self._waiting = waiting
        self._line = bytearray()
        self._begun = False

    @property
    def waiting(self) -> Waiting:
        """What the line is for, once the cursor is on."""
        return self._waiting if self._begun else Waiting.NOTHING

    def advance(self, state: State) -> None:
        """Take keys until ENTER or BREAK."""
        console = state.host.console
        if not self._begun:
            console.show_cursor(True)
            keyboard.latch(state, 0)
            self._begun = True
            return
        code = keyboard.next_key(state)
        if not code:
            return
        state.clock.now += _T_KEY
        if code in (_ENTER, _BREAK):
            console.echo(_ENTER)
            console.show_cursor(False)
            state.clock.now += _T_FINISH
            self._keep(state)
            state.end(Line(None if code == _BREAK else bytes(self._line)))
        else:
            self._key(state, code)

    def _key(self, state: State, code: int) -> None:
        """Do what a key other than ENTER and BREAK does."""
        console, line = state.host.console, self._line
        if code >= BLANK or code == _DOWN:
            if len(line) < LINE_LENGTH:
                line.append(code)
                console.echo(code)
        elif code == _LEFT:
            self._delete(state)
        elif code == _SHIFT_LEFT:
            while self._delete(state):
                pass
        elif code == _RIGHT:
            for _ in range(_TAB - console.column % _TAB):
                if len(line) < LINE_LENGTH:
                    line.append(BLANK)
                    console.echo(BLANK)
        elif code == _SHIFT_RIGHT:
            console.echo(_WIDE)
        elif code == _CLEAR:
            console.echo(_HOME)
            console.echo(_ERASE)
            line.clear()

    def _delete(self, state: State) -> bool:
        """Take the last character back; not at the start, nor across a line feed."""
        line = self._line
        if not line or line[-1] == _DOWN:
            return False
        line.pop()
        state.host.console.echo(_LEFT)
        return True

    def _keep(self, state: State) -> None:
        """Leave the line in the buffer with a zero behind it, where the ROM leaves it."""
        ram = state.memory.ram
        start = word(ram, addresses.LINE_POINTER)
        for place, code in enumerate((*self._line, 0)):
            state.memory.poke(start + place & 0xFFFF, code)
