"""How a program or a command ends: error messages, `Break in n`, and back to the command level."""

from __future__ import annotations

from trs80arm.basic.control import DIRECT
from trs80arm.basic.errors import Code
from trs80arm.basic.outcome import Ending, Outcome
from trs80arm.basic.state import State


def report(state: State, code: Code, line: int | None) -> None:
    """Print an error message and go to command level; ?SN in a line goes on to EDIT."""
    state.outcome = Outcome(Ending.ERROR, code, line)
    state.strings.temporaries.clear()
    _message(state, b"?" + code.letters.encode("ascii") + b" Error", line)


def stop(state: State, line: int, resume: int, ending: Ending) -> None:
    """The program stops (BREAK, STOP, END); CONT would go on at `resume`.

    Args:
        state: the machine.
        line: the line that was executed, 65535 in direct mode.
        resume: the separator of the statement where CONT goes on.
        ending: what ended it.
    """
    number = None if line == DIRECT else line
    if number is not None:
        state.control.resume_line = line
        state.control.resume_address = resume
    state.strings.temporaries.clear()
    state.outcome = Outcome(ending, None, number)
    if ending is Ending.END:
        state.output.leave_printer()
        state.return_to_command()
    else:
        _message(state, b"Break", number)


def _message(state: State, text: bytes, line: int | None) -> None:
    """A message with the line where it happened, and to command level."""
    state.output.leave_printer()
    state.output.newline_if_needed()
    where = b"" if line is None else b" in %d" % line
    state.output.show(text + where + b"\r")
    state.return_to_command()
