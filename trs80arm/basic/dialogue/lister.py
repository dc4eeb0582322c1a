"""LIST, LLIST and DELETE: looking at the program by line numbers and taking lines out.

All three end a running program, as in the ROM.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from trs80arm.basic import costs, cruncher
from trs80arm.basic.activity import Activity
from trs80arm.basic.dialogue import line_range, wait
from trs80arm.basic.dialogue.home import return_to_command
from trs80arm.basic.dialogue.line_range import LineRange
from trs80arm.basic.dialogue.pause import Pause
from trs80arm.basic.errors import BasicError, Code

if TYPE_CHECKING:
    from trs80arm.basic.interpreter import Interpreter

_NEWLINE = 13
_T_LINE: Final = 5670
"""T-states of finding a line and turning its number into digits."""
_T_CHARACTER: Final = 41
"""T-states of the loop that prints a line, per character."""
_T_DELETE: Final = 6600


class Listing(Activity):
    """A program being listed, a line at a time; the keyboard is looked at before each.

    Args:
        lines: which lines.
        printer: whether they go to the printer.
    """

    def __init__(self, lines: LineRange, *, printer: bool) -> None:
        self._next = lines.first
        self._last = lines.last
        self._printer = printer

    def advance(self, basic: Interpreter) -> None:
        """List lines until the range is done or BREAK is pressed."""
        clock = basic.host.clock
        while clock.now < clock.limit:
            if not self._find(basic):
                basic.end()
                return
            code = wait.look_for_break(basic)
            if code == wait.BREAK:
                self._break(basic)
                return
            if code == wait.SHIFT_AT:
                basic.begin(Pause())
                return
            self._list_one(basic)

    def resumed(self, basic: Interpreter, result: Any) -> None:
        """A key ended the pause; BREAK ends the listing too."""
        if result == wait.BREAK:
            self._break(basic)

    def _break(self, basic: Interpreter) -> None:
        basic.newline_if_needed()
        basic.print_text(b"Break\r")
        basic.end()

    def _find(self, basic: Interpreter) -> bool:
        """Go to the next line of the range, if there is one."""
        numbers = basic.program.numbers()
        place = basic.program.place(self._next)
        if place >= len(numbers) or numbers[place] > self._last:
            return False
        self._next = numbers[place]
        return True

    def _list_one(self, basic: Interpreter) -> None:
        number = self._next
        clock = basic.host.clock
        text = basic.program.text(number) or b""
        basic.control.dot = number
        clock.now += _T_LINE + costs.spelling(text)
        put = basic.host.printer.put if self._printer else basic.host.console.put
        for code in b"%d " % number + cruncher.spell(text):
            clock.now += _T_CHARACTER
            put(code)
        put(_NEWLINE)
        self._next = number + 1


def list_lines(basic: Interpreter, rest: bytes) -> None:
    """`LIST`: the lines of a range on the screen.

    Raises:
        BasicError: SN for what is no range.
    """
    _begin(basic, rest, printer=False)


def llist(basic: Interpreter, rest: bytes) -> None:
    """`LLIST`: the same on the printer.

    Raises:
        BasicError: SN for what is no range.
    """
    _begin(basic, rest, printer=True)


def _begin(basic: Interpreter, rest: bytes, *, printer: bool) -> None:
    lines = line_range.parse(basic, rest)
    return_to_command(basic)
    basic.begin(Listing(lines, printer=printer))


def delete(basic: Interpreter, rest: bytes) -> None:
    """`DELETE`: take the lines of a range out; the last line named must exist.

    Raises:
        BasicError: SN for what is no range, FC if the last line is not there or before the first.
    """
    lines = line_range.parse(basic, rest)
    if lines.first > lines.last or basic.program.find(lines.last) is None:
        raise BasicError(Code.FC)
    basic.host.clock.now += _T_DELETE
    basic.program.delete_range(lines.first, lines.last)
    basic.clear_all()
    basic.print_text(b"READY\r")
    return_to_command(basic, ready=False)
