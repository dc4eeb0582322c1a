"""The keyboard: a matrix of switches at 3800H, and the ROM's way of looking at it.

Front ends and scripts press and release keys of the `Matrix`; PEEK and the arm's driver read its
rows; the `KeyboardDriver` is the ROM's scan (02BH), which turns a switch that has closed into one
code, and keeps what it saw in the work area at 4036H.
"""

from __future__ import annotations

from typing import Any

from trs80arm.machine.clock import Clock
from trs80arm.machine.keys import KEYBOARD_START, MATRIX, Key
from trs80arm.machine.memory import Memory

WORK_AREA = 0x4036
"""Seven bytes: rows 0 to 6 as the last scan saw them."""
SCANNED_ROWS = 7
"""The scan goes through rows 0 to 6; SHIFT, row 7, is only looked at with another key."""
CONTROL_BLOCK = 0x4015
_CONTROL_BLOCK = bytes((0x01, 0xE3, 0x03, 0x00, 0x00, 0x00, 0x4B, 0x49))
"""Keyboard: type 1, driver at 3E3H, then its name, "KI"."""

_ROW_OF = {1 << row: row for row in range(8)}
"""What selects a row and no other."""
_SHIFT_ROW, _ = MATRIX[Key.SHIFT]
_DOWN_ROW, _DOWN_BIT = MATRIX[Key.DOWN]

# Codes of row 6, plain and shifted, bit by bit (Level II facts, Typing).
_ROW_6 = ((13, 13), (31, 31), (1, 1), (91, 27), (10, 26), (8, 24), (9, 25), (32, 32))

# T-states of the scan: a look at a row costs 62, and the pause is 3500 turns of a loop of 26. A run
# that gets two keys takes 90983 longer than one that gets a single key (cases
# keys-inkey-latched and keys-inkey-latched-last): these sums, and 52 in the statement loop.
# `tests/machine/golden` has what the ROM's scan took for other keys.
_T_ROW = 62
_T_HIT = 41 + 31 + 20
_T_BIT = 39
_T_SHIFT_READ = 17
_T_PAUSE = 4 + 10 + 17 + 3500 * 26 - 5 + 10 + 4 + 7 + 11
_T_IDLE = SCANNED_ROWS * _T_ROW + 10
_T_LETTER, _T_SMALL_LETTER, _T_CONTROL = 45, 79, 101
_T_FIGURE, _T_FIGURE_TURNED, _T_FIGURE_SHIFTED = 90, 2, 14
_T_NAMED, _T_NAMED_SHIFTED = 112, 111
_T_BREAK = 35
_BREAK = 1


class Matrix:
    """Which keys are down, and what that reads as.

    Attributes:
        ghosting: whether the matrix shows phantom keys, as it does without diodes: with three
            corners of a rectangle down the fourth reads as down too.
    """

    def __init__(self, *, ghosting: bool = False) -> None:
        self.ghosting = ghosting
        self._held: set[Key] = set()
        self._rows = bytearray(8)
        self._image = bytes(SCANNED_ROWS)
        self._readings: dict[int, int] = {}

    @property
    def held(self) -> frozenset[Key]:
        """The keys that are down."""
        return frozenset(self._held)

    @property
    def rows(self) -> bytes:
        """The eight rows, a bit for each key that is down."""
        return bytes(self._rows)

    @property
    def image(self) -> bytes:
        """Rows 0 to 6, each as a scan reads it now."""
        return self._image

    def press(self, key: Key) -> None:
        """Close a key's switch; nothing changes if it is closed."""
        if key not in self._held:
            self._held.add(key)
            row, bit = MATRIX[key]
            self._rows[row] |= 1 << bit
            self._changed()

    def release(self, key: Key) -> None:
        """Open a key's switch; nothing changes if it is open."""
        if key in self._held:
            self._held.remove(key)
            row, bit = MATRIX[key]
            self._rows[row] &= ~(1 << bit)
            self._changed()

    def release_all(self) -> None:
        """Take all hands off the keyboard."""
        self._held.clear()
        self._rows = bytearray(8)
        self._changed()

    def read(self, address: int) -> int:
        """The byte at an address, 3800H to 3BFFH: each of its low eight bits selects a row.

        The rows selected are OR-ed; bits 8 and 9 of the address are not decoded, so the matrix
        is seen four times (Level II facts, Typing).
        """
        select = address & 0xFF
        reading = self._readings.get(select)
        if reading is None:
            reading = self._readings[select] = self._sense(select)
        return reading

    def peek(self, address: int) -> int:
        """The same, for the memory map."""
        return self.read(address)

    def poke(self, address: int, value: int) -> None:
        """Stored nowhere: there are only switches here."""

    def _changed(self) -> None:
        self._readings.clear()
        self._image = bytes(self._rows[:SCANNED_ROWS])
        if self.ghosting:
            self._image = bytes(self._sense(1 << row) for row in range(SCANNED_ROWS))

    def _sense(self, select: int) -> int:
        if not self.ghosting and select in _ROW_OF:
            return self._rows[_ROW_OF[select]]
        columns = 0
        for row, bits in enumerate(self._rows):
            if select >> row & 1:
                columns |= bits
        while self.ghosting:
            # Current goes from a live column through another closed switch into a row that is
            # not selected, and out through that row's other closed switches.
            reached = columns
            for bits in self._rows:
                if bits & reached:
                    reached |= bits
            if reached == columns:
                break
            columns = reached
        return columns

    def __getstate__(self) -> dict[str, Any]:
        # Sorted, so that equal machines have equal snapshots.
        return self.__dict__ | {"_held": sorted(self._held), "_readings": {}}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._held = set(state["_held"])


class KeyboardDriver:
    """The ROM's keyboard scan."""

    def __init__(self, clock: Clock, memory: Memory, matrix: Matrix) -> None:
        """Connect the driver and write its device control block and an empty work area."""
        self._clock = clock
        self._ram = memory.ram
        self._matrix = matrix
        self._ram[CONTROL_BLOCK : CONTROL_BLOCK + len(_CONTROL_BLOCK)] = _CONTROL_BLOCK
        self._ram[WORK_AREA : WORK_AREA + SCANNED_ROWS] = bytes(SCANNED_ROWS)

    @property
    def quiet(self) -> bool:
        """Whether `scan` would return 0 and change nothing until the next key event."""
        return self._ram[WORK_AREA : WORK_AREA + SCANNED_ROWS] == self._matrix.image

    def scan(self) -> int:
        """Look at the keyboard once: the code of one key newly down, or 0.

        A key counts when it goes down, never again while it is held. Rows are looked at in order
        up to the first with a new key: later rows keep theirs for the next scan, but of two new
        keys in one row the higher bit is lost. A key accepted costs the debounce pause, 51 ms.

        The clock is charged with what an accepted key takes more than a scan that finds nothing;
        that one is part of the cost of whatever looks at the keyboard.
        """
        ram = self._ram
        image = self._matrix.image
        if ram[WORK_AREA : WORK_AREA + SCANNED_ROWS] == image:
            return 0
        for row, now in enumerate(image):
            before = ram[WORK_AREA + row]
            if now == before:
                continue
            ram[WORK_AREA + row] = now
            new = now & ~before
            if new:
                bit = (new & -new).bit_length() - 1
                code, decoding = self._decode(row, bit)
                if code == _BREAK:
                    decoding += _T_BREAK  # by the vector at 400CH, which only returns
                self._clock.now += (
                    row * _T_ROW + _T_HIT + bit * _T_BIT + decoding + _T_PAUSE - _T_IDLE
                )
                return code
        return 0

    def _decode(self, row: int, bit: int) -> tuple[int, int]:
        """The code of a key and the T-states that decoding takes, with SHIFT as it is now."""
        shift = bool(self._matrix.read(KEYBOARD_START | 1 << _SHIFT_ROW) & 1)
        place = row * 8 + bit
        if row < 4:
            if not shift:
                return 0x40 + place, _T_SHIFT_READ + _T_LETTER
            if self._matrix.image[_DOWN_ROW] >> _DOWN_BIT & 1:
                # SHIFT and the down arrow make a control key of the two.
                return place, _T_SHIFT_READ + _T_CONTROL
            return 0x60 + place, _T_SHIFT_READ + _T_SMALL_LETTER
        if row < 6:
            code, decoding = 0x10 + place, _T_SHIFT_READ + _T_FIGURE
            if code >= 0x3C:
                code, decoding = code ^ 0x10, decoding + _T_FIGURE_TURNED
            if shift:
                code, decoding = code ^ 0x10, decoding + _T_FIGURE_SHIFTED
            return code, decoding
        return _ROW_6[bit][shift], _T_SHIFT_READ + (_T_NAMED_SHIFTED if shift else _T_NAMED)
