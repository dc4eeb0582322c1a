"""AUTO: numbers typed for the operator, line after line.

Its state is in memory where the ROM has it, so it is on while the byte at 40E1H is not zero; the
command level asks here what to prompt with.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from trs80arm.basic import cruncher
from trs80arm.basic.dialogue import line_range
from trs80arm.basic.dialogue.home import return_to_command
from trs80arm.basic.errors import BasicError, Code

if TYPE_CHECKING:
    from trs80arm.basic.interpreter import Interpreter

FLAG: Final = 0x40E1
CURRENT: Final = 0x40E2
STEP: Final = 0x40E4
_DEFAULT = 10
_T_PROMPT: Final = 3330
"""T-states of finding and printing the number, beside the display's own."""


def _word(basic: Interpreter, address: int) -> int:
    ram = basic.host.memory.ram
    return ram[address] | ram[address + 1] << 8


def _set_word(basic: Interpreter, address: int, value: int) -> None:
    basic.host.memory.ram[address] = value & 0xFF
    basic.host.memory.ram[address + 1] = value >> 8


def is_on(basic: Interpreter) -> bool:
    """Whether the next prompt is a line number."""
    return bool(basic.host.memory.ram[FLAG])


def switch_off(basic: Interpreter) -> None:
    """No more numbers."""
    basic.host.memory.ram[FLAG] = 0


def auto(basic: Interpreter, rest: bytes) -> None:
    """The command: `AUTO [start][,[step]]`; a comma alone keeps the step of the last AUTO.

    Raises:
        BasicError: SN for what is no line number, FC for step 0.
    """
    start, step = _DEFAULT, _DEFAULT
    position = line_range.skip_blanks(rest, 0)
    if not line_range.at_end(rest, position):
        start, position = line_range.line_or_dot(basic, rest, position)
        if not line_range.at_end(rest, position):
            if rest[position] != ord(","):
                raise BasicError(Code.SN)
            step = _word(basic, STEP)
            position = line_range.skip_blanks(rest, position + 1)
            if not line_range.at_end(rest, position):
                number, position = cruncher.line_number(rest, position)
                step = number or 0
                if not line_range.at_end(rest, line_range.skip_blanks(rest, position)):
                    raise BasicError(Code.SN)
    if not step:
        raise BasicError(Code.FC)
    _set_word(basic, STEP, step)
    _set_word(basic, CURRENT, start)
    basic.host.memory.ram[FLAG] = 1
    return_to_command(basic, ready=False)


def prompt(basic: Interpreter) -> int:
    """Print the number that is due, with `*` if there is such a line."""
    number = _word(basic, CURRENT)
    basic.host.clock.now += _T_PROMPT
    basic.print_text(str(number).encode("ascii"))
    basic.host.console.put(ord(" " if basic.program.find(number) is None else "*"))
    return number


def go_on(basic: Interpreter, number: int) -> bool:
    """Set the number behind `number`; False if it would be too large."""
    following = number + _word(basic, STEP)
    if following > cruncher.LAST_LINE:
        return False
    _set_word(basic, CURRENT, following)
    return True
