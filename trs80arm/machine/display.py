"""The ROM's display driver: what happens when a program prints a code.

It keeps its state where the ROM does, in the device control block at 401DH and the flag at 403DH,
so that PEEK and POKE see and move the cursor. Every code costs the T-states that the ROM's routine
takes, sums of the Z-80's instructions on the way through it; `tests/machine/golden` has what the
ROM took.
"""

from __future__ import annotations

from trs80arm.machine.clock import Clock
from trs80arm.machine.memory import Memory
from trs80arm.machine.video import BLANK, CELLS, COLUMNS, FIRST_GRAPHIC, VIDEO_START, Video

CONTROL_BLOCK = 0x401D
_CONTROL_BLOCK = bytes((0x07, 0x58, 0x04, 0x00, 0x3C, 0x00, 0x44, 0x4F))
"""Display: type 7, driver at 458H, cursor 3C00H, cursor off, then its name, "DO"."""
CURSOR = 0x4020
"""Two bytes, low first: the cursor's address in video memory."""
COVERED = 0x4022
"""The code under the cursor while the `_` is on, 0 while it is off."""
VIDEO_FLAG = 0x403D
"""The byte last sent to port FFH: bit 3 is 32-column mode."""
COLUMN = 0x40A6
"""The cursor's column as PRINT, TAB and POS count it."""

_WIDE_BIT = 0b1000
_CURSOR_SIGN = 0x5F
_FIRST_BLANKS = 0xC0
_NEWLINES = range(10, 14)

# T-states. From the call of the output routine at 32AH to the driver and back, without the driver;
# and the part of that which is the routine at 33H, as the line editor calls it.
_T_PRINT_CALL = 251 + 277
_T_DEVICE_CALL = 277
_T_WIDE_COLUMN = 6
# In the driver: up to the test for a control code, and from 480H to the end.
_T_HEAD, _T_HEAD_CURSOR = 101, 103
_T_TAIL, _T_TAIL_CURSOR = 116, 140
_T_SIGN, _T_CAPITAL, _T_SMALL, _T_GRAPHIC = 33, 54, 56, 38
_T_STORE, _T_STORE_WIDE = 84, 1
_T_BLANKS, _T_NO_BLANKS, _T_ONE_BLANK = 58, 52, 20
_T_WRAP = 26
_T_SCROLL = 67 + 960 * 21 - 5
_T_NEWLINE, _T_NEXT_LINE, _T_LAST_LINE = 58, 17, 12
_T_ERASE_LINE, _T_ERASE_SCREEN, _T_ERASE_SCROLLED = 48, 21, 10
_T_ERASE_CELL, _T_ERASE_LAST_PAGE, _T_ERASE_END = 36, 15, 15
# To find each control code among the others, and what it does itself.
_T_FIND = {8: 40, 14: 73, 15: 87, 23: 101, 24: 115, 25: 129, 26: 143, 27: 157, 28: 171}
_T_FIND |= {29: 183, 30: 202, 31: 216}
_T_FIND |= dict.fromkeys(_NEWLINES, 66)
_T_FIND_LOW, _T_FIND_NOTHING = 53, 221
_T_DO = {8: 58, 14: 36, 15: 45, 23: 75, 24: 58, 25: 28, 26: 31, 27: 31, 28: 64, 29: 25}
_T_EDGE, _T_TWICE = 25, 35


class Display:
    """The display driver of one machine, and the plotting of SET, RESET and POINT."""

    def __init__(self, clock: Clock, memory: Memory, video: Video) -> None:
        """Connect the driver and write its device control block; the cursor is home and off."""
        self._clock = clock
        self._memory = memory
        self._ram = memory.ram
        self.video = video
        self._ram[CONTROL_BLOCK : CONTROL_BLOCK + len(_CONTROL_BLOCK)] = _CONTROL_BLOCK
        self._ram[VIDEO_FLAG] = 0
        self._ram[COLUMN] = 0

    @property
    def cursor(self) -> int:
        """The text cursor, 0 to 1023; setting it moves PRINT's column along, as PRINT @ does."""
        return (self._ram[CURSOR] | self._ram[CURSOR + 1] << 8) & CELLS - 1

    @cursor.setter
    def cursor(self, position: int) -> None:
        self._move(position & CELLS - 1)
        self._ram[COLUMN] = position % COLUMNS

    @property
    def cursor_on(self) -> bool:
        """Whether the cursor's `_` is shown; the ROM then keeps the character that it covers."""
        return bool(self._ram[COVERED])

    @property
    def column(self) -> int:
        """The cursor's column as PRINT, TAB and POS count it, 0 to 63."""
        return self._ram[COLUMN] & COLUMNS - 1

    @property
    def wide(self) -> bool:
        """Whether the driver is in 32-column mode."""
        return bool(self._ram[VIDEO_FLAG] & _WIDE_BIT)

    def put(self, code: int) -> None:
        """Print one character or control code, 0 to 255, as PRINT does (routine 32AH)."""
        self._clock.now += self._drive(code) + (
            _T_PRINT_CALL + _T_WIDE_COLUMN if self.wide else _T_PRINT_CALL
        )

    def echo(self, code: int) -> None:
        """The same, as the line editor and EDIT do it (routine 33H)."""
        self._clock.now += _T_DEVICE_CALL + self._drive(code)

    def point(self, x: int, y: int) -> bool:
        """Whether the block x 0..127, y 0..47 is lit; text is not."""
        position, bit = _block(x, y)
        code = self.video.cells[position]
        return code >= FIRST_GRAPHIC and bool(code & bit)

    def plot(self, x: int, y: int, lit: bool) -> None:
        """Light or clear a block; a cell with text becomes an empty graphic first.

        The clock is not charged: the time of SET and RESET is the statement's.
        """
        position, bit = _block(x, y)
        code = max(self.video.cells[position], FIRST_GRAPHIC)
        self.video.store(position, code | bit if lit else code & ~bit)

    def _drive(self, code: int) -> int:
        """Do what a code says; the T-states in the driver."""
        ram, video = self._ram, self.video
        covered = ram[COVERED]
        position = self.cursor
        spent = _T_HEAD
        if covered:
            video.store(position, covered)
            spent = _T_HEAD_CURSOR
        if code < BLANK:
            position, took = self._control(code, position)
        elif code < FIRST_GRAPHIC:
            # The ROM takes 40H, then 20H away until a letter's code fits in five bits.
            stored, decoding = code, _T_SIGN
            if code >= 0x60:
                stored, decoding = code - 0x60, _T_SMALL
            elif code >= 0x40:
                stored, decoding = code - 0x40, _T_CAPITAL
            position, took = self._store(stored, position)
            took += decoding
        elif code < _FIRST_BLANKS:
            position, took = self._store(code, position)
            took += _T_GRAPHIC
        else:
            count = code - _FIRST_BLANKS
            took = _T_BLANKS if count else _T_NO_BLANKS
            for _ in range(count):
                position, one = self._store(BLANK, position)
                took += one + _T_ONE_BLANK
        self._move(position)
        if ram[COVERED]:
            ram[COVERED] = video.cells[position]
            video.store(position, _CURSOR_SIGN)
            took += _T_TAIL_CURSOR
        else:
            took += _T_TAIL
        if self.wide:
            ram[COLUMN] = position >> 1 & 31
        else:
            ram[COLUMN] = position & 63
        return spent + took

    def _move(self, position: int) -> None:
        address = VIDEO_START + position
        self._ram[CURSOR] = address & 0xFF
        self._ram[CURSOR + 1] = address >> 8

    def _store(self, code: int, position: int) -> tuple[int, int]:
        """Put a code at a place; the place after it and the T-states, scrolling included."""
        self.video.store(position, code)
        spent = _T_STORE
        position += 1
        if self.wide:
            position += 1
            spent += _T_STORE_WIDE
        if position < CELLS:
            return position, spent
        # Past the last cell: one line back, and the picture one line up.
        return position - COLUMNS, spent + _T_WRAP + self._scroll()

    def _scroll(self) -> int:
        self.video.scroll()
        return _T_SCROLL + _T_ERASE_SCROLLED + _erasing(CELLS - COLUMNS, CELLS)

    def _erase(self, start: int, stop: int) -> int:
        self.video.fill(start, stop)
        return _erasing(start, stop)

    def _control(self, code: int, position: int) -> tuple[int, int]:
        """Obey a control code; the new place of the cursor and the T-states."""
        column = position % COLUMNS
        line = position - column
        spent = _T_FIND.get(code, _T_FIND_LOW if code < 10 else _T_FIND_NOTHING) + _T_DO.get(
            code, 0
        )
        step = 2 if self.wide else 1
        if code in _NEWLINES:
            position, took = self._newline(line)
            spent += took
        elif code == 8:
            spent += (step - 1) * _T_STORE_WIDE
            position = (position - step) % CELLS
            self.video.store(position, BLANK)
        elif code == 14:
            self._ram[COVERED] = self.video.cells[position]
        elif code == 15:
            self._ram[COVERED] = 0
        elif code == 23:
            self._switch(wide=True)
            position = position + 1 & CELLS - 2
        elif code == 24:
            spent += (column < step) * _T_EDGE + (step - 1) * _T_TWICE
            position = line + (column - step) % COLUMNS
        elif code == 25:
            # One cell, in 32-column mode too.
            spent += (column == COLUMNS - 1) * _T_EDGE
            position = line + (column + 1) % COLUMNS
        elif code == 26:
            position = (position + COLUMNS) % CELLS
        elif code == 27:
            position = (position - COLUMNS) % CELLS
        elif code == 28:
            self._switch(wide=False)
            position = 0
        elif code == 29:
            position = line
        elif code == 30:
            spent += _T_ERASE_LINE + self._erase(position, line + COLUMNS)
        elif code == 31:
            spent += _T_ERASE_SCREEN + self._erase(position, CELLS)
        return position, spent

    def _newline(self, line: int) -> tuple[int, int]:
        """The start of the next line, which is erased, or of the last after scrolling."""
        if line + COLUMNS < CELLS:
            line += COLUMNS
            took = _T_NEXT_LINE + _T_ERASE_LINE + self._erase(line, line + COLUMNS)
        else:
            took = _T_LAST_LINE + self._scroll()
        return line, _T_NEWLINE + took

    def _switch(self, *, wide: bool) -> None:
        flag = self._ram[VIDEO_FLAG]
        self._ram[VIDEO_FLAG] = flag | _WIDE_BIT if wide else flag & ~_WIDE_BIT
        self.video.switch(wide)


def _block(x: int, y: int) -> tuple[int, int]:
    """The cell and the bit of a graphics block."""
    row, third = divmod(y, 3)
    return row * COLUMNS + (x >> 1), 1 << (third * 2 + (x & 1))


def _erasing(start: int, stop: int) -> int:
    """The T-states of the ROM's erasing loop, which looks closer in the last page of 256."""
    # It compares after counting on, so the cell before the page has the closer look too.
    in_last_page = stop - max(start, (stop & ~0xFF) - 1)
    return (stop - start) * _T_ERASE_CELL + in_last_page * _T_ERASE_LAST_PAGE + _T_ERASE_END
