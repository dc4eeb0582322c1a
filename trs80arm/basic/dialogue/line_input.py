"""The line editor: what happens between a prompt and ENTER, at `>`, at INPUT and at AUTO's numbers.

It is the ROM's routine at 5D9H with its buffer at the address in 40A7H. Whoever wants a line begins
a `LineInput` and gets a `Line` as its result.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from trs80arm.basic.activity import Activity, Waiting
from trs80arm.basic.dialogue import wait

if TYPE_CHECKING:
    from trs80arm.basic.interpreter import Interpreter

LINE_LENGTH: Final = 240
"""Characters that a typed line holds; further keys are ignored (facts, Typing)."""
BUFFER_POINTER: Final = 0x40A7
"""Two bytes, low first: where the line is kept while it is typed (41E8H)."""

_BREAK, _LEFT, _RIGHT, _DOWN, _ENTER = 1, 8, 9, 10, 13
_SHIFT_LEFT, _SHIFT_RIGHT, _CLEAR = 24, 25, 31
_WIDE, _HOME, _ERASE = 23, 28, 31
_BLANK = 32
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

    def __init__(self, waiting: Waiting) -> None:
        self._waiting = waiting
        self._line = bytearray()
        self._begun = False

    @property
    def waiting(self) -> Waiting:
        """What the line is for, once the cursor is on."""
        return self._waiting if self._begun else Waiting.NOTHING

    def advance(self, basic: Interpreter) -> None:
        """Take keys until ENTER or BREAK."""
        console = basic.host.console
        if not self._begun:
            console.show_cursor(True)
            wait.latch(basic, 0)
            self._begun = True
            return
        code = wait.next_key(basic)
        if not code:
            return
        basic.host.clock.now += _T_KEY
        if code in (_ENTER, _BREAK):
            console.echo(_ENTER)
            console.show_cursor(False)
            basic.host.clock.now += _T_FINISH
            self._keep(basic)
            basic.end(Line(None if code == _BREAK else bytes(self._line)))
        else:
            self._key(basic, code)

    def _key(self, basic: Interpreter, code: int) -> None:
        """Do what a key other than ENTER and BREAK does."""
        console, line = basic.host.console, self._line
        if code >= _BLANK or code == _DOWN:
            if len(line) < LINE_LENGTH:
                line.append(code)
                console.echo(code)
        elif code == _LEFT:
            self._delete(basic)
        elif code == _SHIFT_LEFT:
            while self._delete(basic):
                pass
        elif code == _RIGHT:
            for _ in range(_TAB - console.column % _TAB):
                if len(line) < LINE_LENGTH:
                    line.append(_BLANK)
                    console.echo(_BLANK)
        elif code == _SHIFT_RIGHT:
            console.echo(_WIDE)
        elif code == _CLEAR:
            console.echo(_HOME)
            console.echo(_ERASE)
            line.clear()

    def _delete(self, basic: Interpreter) -> bool:
        """Take the last character back; not at the start, nor across a line feed."""
        line = self._line
        if not line or line[-1] == _DOWN:
            return False
        line.pop()
        basic.host.console.echo(_LEFT)
        return True

    def _keep(self, basic: Interpreter) -> None:
        """Leave the line in the buffer with a zero behind it, where the ROM leaves it."""
        ram = basic.host.memory.ram
        start = ram[BUFFER_POINTER] | ram[BUFFER_POINTER + 1] << 8
        for place, code in enumerate((*self._line, 0)):
            basic.host.memory.poke(start + place & 0xFFFF, code)
