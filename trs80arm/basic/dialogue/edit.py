"""EDIT: changing one line with single keys.

Begun by the word EDIT, or by the machine itself on a line with a syntax error. It works on the line
as LIST spells it and hands the result back to be crunched again.
"""

from __future__ import annotations

from enum import Enum
from typing import Final

from trs80arm.basic import addresses, characters, cruncher, editing, editing_costs, keyboard
from trs80arm.basic.activity import Waiting
from trs80arm.basic.characters import EXCLAMATION
from trs80arm.basic.dialogue import line_range
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.state import Activity, State

LINE_LENGTH: Final = 255
"""Characters that a line being edited holds; I ignores keys beyond."""
_BACK, _ENTER, _SHIFT_UP = 8, 13, 27

# T-states observed on the ROM with single keys on lines of 3, 24 and 49 characters.
_T_KEY: Final = 212
"""From a key to what it does, beside display and keyboard."""
_T_DIGIT: Final = 504
_T_COMMAND: Final = {
    "\b": 319, " ": 273, "L": 807, "I": 965, "X": 994, "H": 1163, "C": 999, "S": 824, "K": 1029,
    "A": 1224, "E": 560, "Q": 0, "D": 956, "\r": 0,
}  # fmt: skip
_T_OTHER: Final = 926
"""A digit of a count, a command, and a key that is none: what it takes beside what it does, and the
look at the keyboard after it."""
_T_CHARACTER: Final = 59
"""One character printed, or gone back."""
_T_LENGTH: Final = 25
"""One character of the line when L or A begins it again."""
_T_MOVED: Final = 69
"""One character behind one that is deleted, moved down."""
_T_DELETED: Final = 195
_T_INSERT, _T_INSERT_END, _T_INSERT_BACK = 1150, 354, 437
_T_CHANGE: Final = 680
_T_SEARCH, _T_SEARCHED = 854, 98
_T_KILL, _T_KILLED = 764, 240
_T_FINISH: Final = 350
_T_COUNTED: Final = 33
"""One character of the line when EDIT begins."""
_T_NUMBER: Final = 1540
"""T-states of beginning to show the line, beside its number's digits."""


class _Mode(Enum):
    """What the next key is."""

    BEGIN = "none yet"
    COMMAND = "a command or a digit of its count"
    INSERT = "a character to insert"
    CHANGE = "a character that takes another's place"
    SEARCH = "the character to search for"
    KILL = "the character to delete up to"


def _ten_times(count: int) -> int:
    """A count in a register that is rotated: what leaves it on the left comes back on the right."""
    fourfold = (count << 2 | count >> 6) & 0xFF
    fivefold = fourfold + count & 0xFF
    return (fivefold << 1 | fivefold >> 7) & 0xFF


class Edit(Activity):
    """One line being edited.

    Args:
        number: the line; it must exist when the activity begins, else ?UL.
    """

    _number: int
    _line: bytearray
    _place: int
    _count: int
    _mode: _Mode

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

    def advance(self, state: State) -> None:
        """Print the number and take keys."""
        if self._mode is _Mode.BEGIN:
            self._begin(state)
            return
        code = keyboard.next_key(state)
        if not code:
            return
        state.clock.now += _T_KEY
        if self._mode is _Mode.COMMAND:
            self._command(state, code)
        elif self._mode is _Mode.INSERT:
            self._insert(state, code)
        elif self._mode is _Mode.CHANGE:
            self._change(state, code)
        else:
            self._search(state, code)

    def _begin(self, state: State) -> None:
        """Spell the line out and go to its start."""
        state.clock.now += editing_costs.search(state.program, self._number)
        text = state.program.text(self._number)
        if text is None:
            raise BasicError(Code.UL)
        state.control.dot = self._number
        self._line = bytearray(cruncher.spell(text))
        state.clock.now += cruncher.spelling_cost(text) + _T_COUNTED * len(self._line)
        self._again(state)

    def _again(self, state: State) -> None:
        state.clock.now += _T_NUMBER + editing_costs.number_text(self._number)
        state.output.show(b"%d " % self._number)
        state.host.console.show_cursor(True)
        self._place = 0
        self._take_command()

    def _take_command(self) -> None:
        self._mode = _Mode.COMMAND
        self._count = 0

    def _show(self, state: State, count: int) -> None:
        """Print up to `count` characters from the place on and go behind them."""
        for code in self._line[self._place : self._place + count]:
            state.host.console.put(code)
            state.clock.now += _T_CHARACTER
            self._place += 1

    def _show_rest(self, state: State) -> None:
        self._show(state, len(self._line))

    def _command(self, state: State, code: int) -> None:
        clock = state.clock
        if characters.is_digit(code):
            clock.now += _T_DIGIT
            self._count = _ten_times(self._count) + code - characters.ZERO & 0xFF
            return
        count = self._count or 1
        self._count = 0
        key = chr(code).upper() if code < 128 else ""
        clock.now += _T_COMMAND.get(key, _T_OTHER)
        if code == _BACK:
            for _ in range(min(count, self._place)):
                self._place -= 1
                clock.now += _T_CHARACTER
                state.host.console.put(_BACK)
        elif code == _ENTER:
            self._show_rest(state)
            self._finish(state)
        elif key == " ":
            self._show(state, count)
        elif key == "L":
            self._show_rest(state)
            state.output.show(b"\r")
            clock.now += _T_LENGTH * len(self._line)
            self._again(state)
        elif key == "I":
            self._mode = _Mode.INSERT
        elif key == "X":
            self._show_rest(state)
            self._mode = _Mode.INSERT
        elif key == "H":
            del self._line[self._place :]
            self._mode = _Mode.INSERT
        elif key == "D":
            self._delete(state, count)
        elif key == "C":
            if self._place < len(self._line):
                self._mode, self._count = _Mode.CHANGE, count
        elif key == "S":
            self._mode, self._count = _Mode.SEARCH, count
        elif key == "K":
            self._mode, self._count = _Mode.KILL, count
        elif key == "A":
            state.output.show(b"\r")
            self._begin(state)
        elif key == "E":
            self._finish(state)
        elif key == "Q":
            state.host.console.show_cursor(False)
            state.return_to_command()

    def _delete(self, state: State, count: int) -> None:
        """Take characters out and show them between two marks."""
        if self._place == len(self._line):
            return
        console = state.host.console
        console.put(EXCLAMATION)
        for _ in range(min(count, len(self._line) - self._place)):
            console.put(self._line.pop(self._place))
            state.clock.now += _T_DELETED + self._moved_down()
        console.put(EXCLAMATION)

    def _moved_down(self) -> int:
        """T-states to close the gap that a character has left at the place."""
        return _T_MOVED * (len(self._line) - self._place)

    def _insert(self, state: State, code: int) -> None:
        console = state.host.console
        clock = state.clock
        if code == _ENTER:
            self._show_rest(state)
            self._finish(state)
        elif code == _SHIFT_UP:
            clock.now += _T_INSERT_END
            self._take_command()
        elif code == _BACK:
            clock.now += _T_INSERT_BACK
            if self._place:
                self._place -= 1
                del self._line[self._place]
                clock.now += self._moved_down()
                console.put(_BACK)
        elif len(self._line) < LINE_LENGTH:
            here = addresses.INPUT_BUFFER + self._place
            rest = len(self._line) - self._place
            clock.now += _T_INSERT + editing_costs.moved_up(here, here + rest)
            self._line.insert(self._place, code)
            self._place += 1
            console.put(code)

    def _change(self, state: State, code: int) -> None:
        state.clock.now += _T_CHANGE
        self._line[self._place] = code
        self._place += 1
        state.host.console.put(code)
        self._count -= 1
        if not self._count or self._place == len(self._line):
            self._take_command()

    def _search(self, state: State, code: int) -> None:
        """Go, or delete, up to the n-th place behind this one that has the character."""
        console, line = state.host.console, self._line
        kill = self._mode is _Mode.KILL
        clock = state.clock
        clock.now += _T_KILL if kill else _T_SEARCH
        if kill:
            console.put(EXCLAMATION)
        while self._count and self._place < len(line):
            console.put(line[self._place])
            if kill:
                del line[self._place]
                clock.now += _T_KILLED + self._moved_down()
            else:
                self._place += 1
                clock.now += _T_SEARCHED
            if self._place < len(line) and line[self._place] == code:
                self._count -= 1
        if kill:
            console.put(EXCLAMATION)
        self._take_command()

    def _finish(self, state: State) -> None:
        """End the edit: the line is stored as it is now, or deleted when nothing is left."""
        state.output.show(b"\r")
        state.host.console.show_cursor(False)
        state.clock.now += _T_FINISH
        state.return_to_command()  # Where an error in storing the line leads to.
        editing.store_line(state, self._number, bytes(self._line))
        state.return_to_command(ready=False)


def edit(state: State, rest: bytes) -> None:
    """The command: `EDIT n` or `EDIT .`; it ends a running program.

    Raises:
        BasicError: SN for anything else, UL if there is no such line.
    """
    number, position = line_range.line_or_dot(state, rest, 0)
    if not line_range.at_end(rest, position):
        raise BasicError(Code.SN)
    if state.program.find(number) is None:
        raise BasicError(Code.UL)
    state.return_to_command()
    state.begin(Edit(number))
