"""The command level: READY, the `>` and what a typed line leads to.

It is the bottom of the interpreter's stack. Programs, LIST, errors and BREAK all come back to it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from trs80arm.basic.activity import Waiting
from trs80arm.basic.control import DIRECT
from trs80arm.basic.dialogue import auto, line_range
from trs80arm.basic.dialogue.edit import Edit
from trs80arm.basic.dialogue.home import Home, return_to_command
from trs80arm.basic.dialogue.line_input import Line, LineInput
from trs80arm.basic.errors import Code

if TYPE_CHECKING:
    from trs80arm.basic.interpreter import Interpreter

__all__ = ["CommandLevel", "return_to_command"]

_PORT: Final = 0xFF
_PORT_FLAG: Final = 0x403D
_NO_MOTOR: Final = 0xFB
_SYNTAX_ERROR: Final = (Code.SN - 1) * 2
"""What 409AH holds after an SN error."""
_T_READY: Final = 2400
"""T-states from the end of a command to the R of READY, and between READY and the `>`."""


class CommandLevel(Home):
    """Says READY, asks for a line, gives it to the interpreter, and again."""

    def __init__(self) -> None:
        super().__init__()
        self._number: int | None = None
        """The line that AUTO asks for."""

    def advance(self, basic: Interpreter) -> None:
        """Print READY, or a prompt, and ask for a line."""
        if self._ready:
            basic.newline_if_needed()
            self._switch_recorder_off(basic)
            basic.host.clock.now += _T_READY
            basic.print_text(b"READY\r")
            self._ready = False
            self._edit_after_syntax_error(basic)
        elif auto.is_on(basic):
            self._number = auto.prompt(basic)
            basic.begin(LineInput(Waiting.AUTO))
        else:
            basic.host.console.put(ord(">"))
            basic.begin(LineInput(Waiting.COMMAND))

    def resumed(self, basic: Interpreter, result: Any) -> None:
        """A line was typed, or what it began has ended."""
        number, self._number = self._number, None
        if not isinstance(result, Line):
            self._ready = True
        elif number is not None:
            self._numbered(basic, number, result.text)
        elif result.text is not None and result.text.strip(line_range.BLANKS):
            # An error in storing the line, as any, leads to READY.
            self._ready = True
            self._ready = basic.enter_line(result.text)

    @staticmethod
    def _switch_recorder_off(basic: Interpreter) -> None:
        """The flag of 403DH without the motor's bit goes to the port (01F8H), at each READY."""
        value = basic.memory.ram[_PORT_FLAG] & _NO_MOTOR
        basic.memory.ram[_PORT_FLAG] = value
        basic.host.ports.write(_PORT, value)

    def _edit_after_syntax_error(self, basic: Interpreter) -> None:
        """EDIT on its line when the last error was SN, also one that a program has trapped."""
        control = basic.control
        if control.error == _SYNTAX_ERROR:
            control.error = 0
            if control.error_line != DIRECT:
                basic.begin(Edit(control.error_line))

    def _numbered(self, basic: Interpreter, number: int, line: bytes | None) -> None:
        """A line typed at AUTO's number; BREAK, or a next number too large, ends AUTO."""
        self._ready = True
        if line is None or not auto.go_on(basic, number):
            auto.switch_off(basic)
        else:
            basic.store_line(number, line)
            self._ready = False
