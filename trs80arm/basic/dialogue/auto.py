"""AUTO: numbers typed for the operator, line after line.

Its state is in memory where the ROM has it, so it is on while the byte at 40E1H is not zero; the
command level asks here what to prompt with.
"""

from __future__ import annotations

from typing import Final

from trs80arm.basic import cruncher, editing_costs
from trs80arm.basic.addresses import set_word, word
from trs80arm.basic.characters import COMMA
from trs80arm.basic.dialogue import line_range
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.state import State

FLAG: Final = 0x40E1
CURRENT: Final = 0x40E2
STEP: Final = 0x40E4
_DEFAULT = 10
_T_PROMPT: Final = 2240
"""T-states of a prompt, beside looking for the line, its number's digits and the display."""


def is_on(state: State) -> bool:
    """Whether the next prompt is a line number."""
    return bool(state.memory.ram[FLAG])


def switch_off(state: State) -> None:
    """No more numbers."""
    state.memory.ram[FLAG] = 0


def auto(state: State, rest: bytes) -> None:
    """The command: `AUTO [start][,[step]]`; a comma alone keeps the step of the last AUTO.

    Raises:
        BasicError: SN for what is no line number, FC for step 0.
    """
    start, step = _DEFAULT, _DEFAULT
    position = line_range.skip_blanks(rest, 0)
    if not line_range.at_end(rest, position):
        start, position = line_range.line_or_dot(state, rest, position)
        if not line_range.at_end(rest, position):
            if rest[position] != COMMA:
                raise BasicError(Code.SN)
            step = word(state.memory.ram, STEP)
            position = line_range.skip_blanks(rest, position + 1)
            if not line_range.at_end(rest, position):
                number, position = cruncher.line_number(rest, position)
                step = number or 0
                if not line_range.at_end(rest, line_range.skip_blanks(rest, position)):
                    raise BasicError(Code.SN)
    if not step:
        raise BasicError(Code.FC)
    set_word(state.memory.ram, STEP, step)
    set_word(state.memory.ram, CURRENT, start)
    state.memory.ram[FLAG] = 1
    state.return_to_command(ready=False)


def prompt(state: State) -> int:
    """Print the number that is due, with `*` if there is such a line."""
    number = word(state.memory.ram, CURRENT)
    state.clock.now += _T_PROMPT + editing_costs.number_text(number)
    state.clock.now += editing_costs.search(state.program, number)
    state.output.show(str(number).encode("ascii"))
    state.host.console.put(ord(" " if state.program.find(number) is None else "*"))
    return number


def go_on(state: State, number: int) -> bool:
    """Set the number behind `number`; False if it would be too large."""
    following = number + word(state.memory.ram, STEP)
    if following > cruncher.LAST_LINE:
        return False
    set_word(state.memory.ram, CURRENT, following)
    return True
