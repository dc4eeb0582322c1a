"""The video memory and the character generator: 1024 cells of seven bits at 3C00H.

The CPU writes eight bits and reads back seven and a made-up one: bit 6 has no chip, and what is
read in its place is 1 where bits 5 and 7 are both 0. The display driver and POKE write here; a
front end asks which rows changed and what the tube shows.
"""

from __future__ import annotations

from typing import Any

COLUMNS = 64
ROWS = 16
CELLS = COLUMNS * ROWS
VIDEO_START = 0x3C00
VIDEO_STOP = 0x4000
BLANK = 0x20
FIRST_GRAPHIC = 0x80


def _read_back(value: int) -> int:
    kept = value & 0b1011_1111
    return kept if kept & 0b1010_0000 else kept | 0b0100_0000


READ_BACK = bytes(_read_back(value) for value in range(256))
"""What each byte stored reads back as: 1 is 65, 97 is 33, 192 is 128 (Level II facts, point 16)."""

_ALL_ROWS = (1 << ROWS) - 1
_POWER_ON = READ_BACK[0]
_GRAPHICS = dict.fromkeys(range(FIRST_GRAPHIC, FIRST_GRAPHIC + 64), " ")
_ARROWS = {0x5B: "↑", 0x5C: "↓", 0x5D: "←", 0x5E: "→"}


def glyph(code: int) -> str:
    """The character that the tube shows for a code read from video memory.

    Codes 5BH to 5EH are the four arrows of the Model I's character generator; graphics codes, 128
    to 191, give a blank here, for their blocks are for the front end to draw.
    """
    return _ARROWS.get(code) or _GRAPHICS.get(code) or chr(code)


def sextant(pattern: int) -> str:
    """The Unicode character of a 2x3 block pattern, 0 to 63: the machine's own order of bits."""
    special = {0: " ", 21: "▌", 42: "▐", 63: "█"}
    if pattern in special:
        return special[pattern]
    return chr(0x1FB00 + pattern - 1 - (pattern > 21) - (pattern > 42))


class Video:
    """The 1024 cells, and the switch for 32 characters a line.

    Attributes:
        cells: the cells as the CPU reads them back, row by row. To be changed through `poke`,
            `fill`, `scroll` and `store` only.
        wide: whether the tube shows every other cell at double width (bit 3 of port FFH).
    """

    def __init__(self) -> None:
        self.cells = bytearray((_POWER_ON,)) * CELLS
        self.wide = False
        self._dirty = _ALL_ROWS

    def peek(self, address: int) -> int:
        """The cell at an address, 3C00H to 3FFFH, with its made-up bit 6."""
        return self.cells[address & 0x3FF]

    def poke(self, address: int, value: int) -> None:
        """Store a byte, 0 to 255, at an address, 3C00H to 3FFFH."""
        self.store(address & 0x3FF, value)

    def store(self, position: int, value: int) -> None:
        """Store a byte, 0 to 255, in a cell, 0 to 1023."""
        self.cells[position] = READ_BACK[value]
        self._dirty |= 1 << (position >> 6)

    def fill(self, start: int, stop: int) -> None:
        """Blank the cells `start` to `stop` - 1, 0 to 1024."""
        if stop > start:
            self.cells[start:stop] = bytes((BLANK,)) * (stop - start)
            first, last = start >> 6, (stop - 1) >> 6
            self._dirty |= (2 << last) - (1 << first)

    def scroll(self) -> None:
        """Move all rows up by one; the last row blank."""
        del self.cells[:COLUMNS]
        self.cells.extend(bytes((BLANK,)) * COLUMNS)
        self._dirty = _ALL_ROWS

    def switch(self, wide: bool) -> None:
        """Show 32 wide characters a line, or 64."""
        if wide is not self.wide:
            self.wide = wide
            self._dirty = _ALL_ROWS

    def take_dirty(self) -> list[int]:
        """The rows, 0 to 15, that changed since the last call."""
        dirty, self._dirty = self._dirty, 0
        return [row for row in range(ROWS) if dirty >> row & 1]

    def row(self, number: int) -> bytes:
        """The 64 codes of a row, 0 to 15."""
        return bytes(self.cells[number * COLUMNS : (number + 1) * COLUMNS])

    def lines(self) -> list[str]:
        """The 16 rows as text: each code as the CPU reads it back, trailing blanks removed.

        Graphics codes stand for themselves (U+0080 to U+00BF); small letters are capitals.
        """
        return [self.row(number).decode("latin-1").rstrip(" ") for number in range(ROWS)]

    def __getstate__(self) -> dict[str, Any]:
        # What a front end has drawn is no part of the machine: a restored screen is all new.
        return self.__dict__ | {"_dirty": _ALL_ROWS}
