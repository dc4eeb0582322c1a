"""LIST, LLIST and DELETE: looking at the program by line numbers and taking lines out.

All three end a running program, as in the ROM.
"""

from __future__ import annotations

from typing import Any, Final

from trs80arm.basic import cruncher, editing, editing_costs, keyboard
from trs80arm.basic.dialogue import line_range
from trs80arm.basic.dialogue.line_range import LineRange
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.pause import Pause
from trs80arm.basic.state import Activity, State

_NEWLINE = 13
_T_LINE: Final = 2500
"""T-states of beginning a line, beside its number's digits."""
_T_CHARACTER: Final = 75
"""T-states of the loop that prints a line, per character."""
_T_DELETE: Final = 3600
"""T-states of DELETE, beside finding, taking out and linking."""


class Listing(Activity):
    """A program being listed, a line at a time; the keyboard is looked at before each.

    Args:
        lines: which lines.
        printer: whether they go to the printer.
    """

    _next: int
    _last: int
    _printer: bool

    def __init__(self, lines: LineRange, *, printer: bool) -> None:
        self._next = lines.first
        self._last = lines.last
        self._printer = printer

    def advance(self, state: State) -> None:
        """List lines until the range is done or BREAK is pressed."""
        clock = state.clock
        while clock.now < clock.limit:
            if not self._find(state):
                state.end()
                return
            code = keyboard.look_for_break(state)
            if code == keyboard.BREAK:
                self._break(state)
                return
            if code == keyboard.SHIFT_AT:
                state.begin(Pause())
                return
            self._list_one(state)

    def resumed(self, state: State, result: Any) -> None:
        """A key ended the pause; BREAK ends the listing too."""
        if result == keyboard.BREAK:
            self._break(state)

    def _break(self, state: State) -> None:
        state.output.newline_if_needed()
        state.output.show(b"Break\r")
        state.end()

    def _find(self, state: State) -> bool:
        """Go to the next line of the range, if there is one."""
        numbers = state.program.numbers()
        place = state.program.place(self._next)
        if place >= len(numbers) or numbers[place] > self._last:
            return False
        self._next = numbers[place]
        return True

    def _list_one(self, state: State) -> None:
        number = self._next
        clock = state.clock
        text = state.program.text(number) or b""
        state.control.dot = number
        clock.now += _T_LINE + editing_costs.number_text(number) + cruncher.spelling_cost(text)
        put = state.host.printer.put if self._printer else state.host.console.put
        for code in b"%d " % number + cruncher.spell(text):
            clock.now += _T_CHARACTER
            put(code)
        put(_NEWLINE)
        self._next = number + 1


def list_lines(state: State, rest: bytes) -> None:
    """`LIST`: the lines of a range on the screen.

    Raises:
        BasicError: SN for what is no range.
    """
    _begin(state, rest, printer=False)


def llist(state: State, rest: bytes) -> None:
    """`LLIST`: the same on the printer.

    Raises:
        BasicError: SN for what is no range.
    """
    _begin(state, rest, printer=True)


def _begin(state: State, rest: bytes, *, printer: bool) -> None:
    lines = line_range.parse(state, rest)
    state.clock.now += editing_costs.search(state.program, lines.first)
    state.return_to_command()
    state.begin(Listing(lines, printer=printer))


def delete(state: State, rest: bytes) -> None:
    """`DELETE`: take the lines of a range out; the last line named must exist.

    Raises:
        BasicError: SN for what is no range, FC if the last line is not there or before the first.
    """
    program, clock = state.program, state.clock
    lines = line_range.parse(state, rest)
    clock.now += editing_costs.search(program, lines.first)
    clock.now += editing_costs.search(program, lines.last)
    if lines.first > lines.last or program.find(lines.last) is None:
        raise BasicError(Code.FC)
    clock.now += _T_DELETE
    editing.delete_range(state, lines.first, lines.last)
    clock.now += editing_costs.link(program, lines.first)
    state.clear_all()
    state.output.show(b"READY\r")
    state.return_to_command(ready=False)
