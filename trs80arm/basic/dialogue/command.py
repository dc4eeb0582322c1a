"""The command level: READY, the `>` and what a typed line leads to.

It is the bottom of the interpreter's stack. Programs, LIST, errors and BREAK all come back to it.
"""

from __future__ import annotations

from typing import Any, Final

from trs80arm.basic import costs, cruncher, editing, execution
from trs80arm.basic.activity import Waiting
from trs80arm.basic.characters import BLANKS
from trs80arm.basic.control import DIRECT
from trs80arm.basic.dialogue import auto
from trs80arm.basic.dialogue.edit import Edit
from trs80arm.basic.dialogue.line_input import Line, LineInput
from trs80arm.basic.errors import Code
from trs80arm.basic.state import Home, State

_PORT: Final = 0xFF
_PORT_FLAG: Final = 0x403D
_NO_MOTOR: Final = 0xFB
_SYNTAX_ERROR: Final = (Code.SN - 1) * 2
"""What 409AH holds after an SN error."""
_T_READY: Final = 2400
"""T-states from the end of a command to the R of READY, and between READY and the `>`."""
_T_EDIT_AFTER_ERROR: Final = 4600
"""T-states by which the way into EDIT from a syntax error is longer than from the word EDIT."""


class CommandLevel(Home):
    """Says READY, asks for a line, stores or executes it, and again."""

    _number: int | None

    def __init__(self) -> None:
        super().__init__()
        self._number = None
        """The line that AUTO asks for."""

    def advance(self, state: State) -> None:
        """Print READY, or a prompt, and ask for a line."""
        if self._ready:
            state.output.newline_if_needed()
            self._switch_recorder_off(state)
            state.clock.now += _T_READY
            state.output.show(b"READY\r")
            self._ready = False
            self._edit_after_syntax_error(state)
        elif auto.is_on(state):
            self._number = auto.prompt(state)
            state.begin(LineInput(Waiting.AUTO))
        else:
            state.host.console.put(ord(">"))
            state.begin(LineInput(Waiting.COMMAND))

    def resumed(self, state: State, result: Any) -> None:
        """A line was typed, or what it began has ended."""
        number, self._number = self._number, None
        if not isinstance(result, Line):
            self._ready = True
        elif number is not None:
            self._numbered(state, number, result.text)
        elif result.text is not None and result.text.strip(BLANKS):
            # An error in storing the line, as any, leads to READY.
            self._ready = True
            self._ready = self._enter(state, result.text)

    @staticmethod
    def _enter(state: State, text: bytes) -> bool:
        """Store or execute a line; whether READY comes after it.

        Raises:
            BasicError: SN for a line number above 65529, OM when a line does not fit.
        """
        number, rest = cruncher.split_line(text)
        if number is None:
            crunched, cost = cruncher.crunch(rest)
            state.clock.now += cost
            execution.execute_direct(state, crunched)
            return True
        state.clock.now += costs.TYPED_NUMBER + costs.TYPED_DIGIT * len(str(number))
        editing.store_line(state, number, rest)
        return False

    @staticmethod
    def _switch_recorder_off(state: State) -> None:
        """The flag of 403DH without the motor's bit goes to the port (01F8H), at each READY."""
        value = state.memory.ram[_PORT_FLAG] & _NO_MOTOR
        state.memory.ram[_PORT_FLAG] = value
        state.host.ports.write(_PORT, value)

    def _edit_after_syntax_error(self, state: State) -> None:
        """EDIT on its line when the last error was SN, also one that a program has trapped."""
        control = state.control
        if control.error == _SYNTAX_ERROR:
            control.error = 0
            if control.error_line != DIRECT:
                state.clock.now += _T_EDIT_AFTER_ERROR
                state.begin(Edit(control.error_line))

    def _numbered(self, state: State, number: int, line: bytes | None) -> None:
        """A line typed at AUTO's number; BREAK, or a next number too large, ends AUTO."""
        self._ready = True
        if line is None or not auto.go_on(state, number):
            auto.switch_off(state)
        else:
            editing.store_line(state, number, line)
            self._ready = False
