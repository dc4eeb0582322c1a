"""EDIT: changing one line with single keys.

Begun by the word EDIT, or by the machine itself on a line with a syntax error. It works on the line
as LIST spells it and hands the result back to be crunched again.
"""

from __future__ import annotations

from enum import Enum
from typing import TYPE_CHECKING, Final

from trs80arm.basic import costs, cruncher
from trs80arm.basic.activity import Activity, Waiting
from trs80arm.basic.dialogue import line_range, wait
from trs80arm.basic.dialogue.home import return_to_command
from trs80arm.basic.errors import BasicError, Code

if TYPE_CHECKING:
    from trs80arm.basic.interpreter import Interpreter

LINE_LENGTH: Final = 255
"""Characters that a line being edited holds; I ignores keys beyond."""
_BACK, _ENTER, _SHIFT_UP = 8, 13, 27
_MARK = ord("!")

_T_KEY: Final = 311
"""T-states from a key to what it does, beside display and keyboard."""
_T_CHARACTER: Final = 44
"""T-states of the loop that prints the rest of the line, per character."""
_T_FINISH: Final = 1430
_T_BEGIN: Final = 530
"""T-states of EDIT itself, beside spelling out the line."""
_T_NUMBER: Final = 5085
"""T-states of turning the line's number into digits."""


class _Mode(Enum):
    """What the next key is."""

    BEGIN = "none yet"
    COMMAND = "a command or a digit of its count"
    INSERT = "a character to insert"
    CHANGE = "a character that takes another's place"
    SEARCH = "the character to search for"
    KILL = "the character to delete up to"


class Edit(Activity):
    """One line being edited.

    Args:
        number: the line; it must exist when the activity begins, else ?UL.
    """

    def __init__(self, number: int) -> None:
        self._number = number
        self._line = bytearray()
        self._place = 0
        self._count = 0
        self._mode = _Mode.BEGIN

    @property
    def waiting(self) -> Waiting:
        """EDIT, once the number is out."""
        return Waiting.NOTHING if self._mode is _Mode.BEGIN else Waiting.EDIT

    def advance(self, basic: Interpreter) -> None:
        """Print the number and take keys."""
        if self._mode is _Mode.BEGIN:
            self._begin(basic)
            return
        code = wait.next_key(basic)
        if not code:
            return
        basic.host.clock.now += _T_KEY
        if self._mode is _Mode.COMMAND:
            self._command(basic, code)
        elif self._mode is _Mode.INSERT:
            self._insert(basic, code)
        elif self._mode is _Mode.CHANGE:
            self._change(basic, code)
        else:
            self._search(basic, code)

    def _begin(self, basic: Interpreter) -> None:
        """Spell the line out and go to its start."""
        text = basic.program.text(self._number)
        if text is None:
            raise BasicError(Code.UL)
        basic.control.dot = self._number
        self._line = bytearray(cruncher.spell(text))
        basic.host.clock.now += _T_BEGIN + costs.spelling(text)
        self._again(basic)

    def _again(self, basic: Interpreter) -> None:
        basic.host.clock.now += _T_NUMBER
        basic.print_text(b"%d " % self._number)
        basic.host.console.show_cursor(True)
        self._place = 0
        self._take_command()

    def _take_command(self) -> None:
        self._mode = _Mode.COMMAND
        self._count = 0

    def _show(self, basic: Interpreter, count: int) -> None:
        """Print up to `count` characters from the place on and go behind them."""
        for code in self._line[self._place : self._place + count]:
            basic.host.console.put(code)
            basic.host.clock.now += _T_CHARACTER
            self._place += 1

    def _show_rest(self, basic: Interpreter) -> None:
        self._show(basic, len(self._line))

    def _command(self, basic: Interpreter, code: int) -> None:
        if ord("0") <= code <= ord("9"):
            self._count = (self._count * 10 + code - ord("0")) & 0xFF
            return
        count = self._count or 1
        self._count = 0
        key = chr(code).upper() if code < 128 else ""
        if code == _BACK:
            for _ in range(min(count, self._place)):
                self._place -= 1
                basic.host.console.put(_BACK)
        elif code == _ENTER:
            self._show_rest(basic)
            self._finish(basic)
        elif key == " ":
            self._show(basic, count)
        elif key == "L":
            self._show_rest(basic)
            basic.print_text(b"\r")
            self._again(basic)
        elif key == "I":
            self._mode = _Mode.INSERT
        elif key == "X":
            self._show_rest(basic)
            self._mode = _Mode.INSERT
        elif key == "H":
            del self._line[self._place :]
            self._mode = _Mode.INSERT
        elif key == "D":
            self._delete(basic, count)
        elif key == "C":
            if self._place < len(self._line):
                self._mode, self._count = _Mode.CHANGE, count
        elif key == "S":
            self._mode, self._count = _Mode.SEARCH, count
        elif key == "K":
            self._mode, self._count = _Mode.KILL, count
        elif key == "A":
            basic.print_text(b"\r")
            self._begin(basic)
        elif key == "E":
            self._finish(basic)
        elif key == "Q":
            basic.host.console.show_cursor(False)
            return_to_command(basic)

    def _delete(self, basic: Interpreter, count: int) -> None:
        """Take characters out and show them between two marks."""
        if self._place == len(self._line):
            return
        console = basic.host.console
        console.put(_MARK)
        for _ in range(min(count, len(self._line) - self._place)):
            console.put(self._line.pop(self._place))
        console.put(_MARK)

    def _insert(self, basic: Interpreter, code: int) -> None:
        console = basic.host.console
        if code == _ENTER:
            self._show_rest(basic)
            self._finish(basic)
        elif code == _SHIFT_UP:
            self._take_command()
        elif code == _BACK:
            if self._place:
                self._place -= 1
                del self._line[self._place]
                console.put(_BACK)
        elif len(self._line) < LINE_LENGTH:
            self._line.insert(self._place, code)
            self._place += 1
            console.put(code)

    def _change(self, basic: Interpreter, code: int) -> None:
        self._line[self._place] = code
        self._place += 1
        basic.host.console.put(code)
        self._count -= 1
        if not self._count or self._place == len(self._line):
            self._take_command()

    def _search(self, basic: Interpreter, code: int) -> None:
        """Go, or delete, up to the n-th place behind this one that has the character."""
        console, line = basic.host.console, self._line
        kill = self._mode is _Mode.KILL
        if kill:
            console.put(_MARK)
        while self._count and self._place < len(line):
            console.put(line[self._place])
            if kill:
                del line[self._place]
            else:
                self._place += 1
            if self._place < len(line) and line[self._place] == code:
                self._count -= 1
        if kill:
            console.put(_MARK)
        self._take_command()

    def _finish(self, basic: Interpreter) -> None:
        """End the edit: the line is stored as it is now, or deleted when nothing is left."""
        basic.print_text(b"\r")
        basic.host.console.show_cursor(False)
        basic.host.clock.now += _T_FINISH
        return_to_command(basic)  # Where an error in storing the line leads to.
        basic.store_line(self._number, bytes(self._line))
        return_to_command(basic, ready=False)


def edit(basic: Interpreter, rest: bytes) -> None:
    """The command: `EDIT n` or `EDIT .`; it ends a running program.

    Raises:
        BasicError: SN for anything else, UL if there is no such line.
    """
    number, position = line_range.line_or_dot(basic, rest, 0)
    if not line_range.at_end(rest, position):
        raise BasicError(Code.SN)
    if basic.program.find(number) is None:
        raise BasicError(Code.UL)
    return_to_command(basic)
    basic.begin(Edit(number))
