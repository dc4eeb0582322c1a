"""Figure 11: the keys that move the arm in `@SET`, in the upper left corner of the keyboard.

The driver reads them straight from the matrix, all at once; the front end labels them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from trs80arm.machine.keys import KEYBOARD_START, MATRIX, Key


class KeyMatrix(Protocol):
    """The keyboard, as a program sees it."""

    def peek(self, address: int) -> int:
        """The byte at 3800H plus the selected rows' bits: 1 for each key that is down."""


@dataclass(frozen=True)
class KeysDown:
    """One look at the keyboard.

    Attributes:
        rows: what each row of the matrix that was looked at reads.
    """

    rows: dict[int, int]

    def __contains__(self, key: Key) -> bool:
        """Whether a key is down."""
        row, bit = MATRIX[key]
        return bool(self.rows[row] >> bit & 1)


@dataclass(frozen=True)
class JogKeys:
    """Which key moves which joint which way, and which ends manual mode.

    The figure itself is lost. Six pairs of the top two rows, with 0 to leave, are what the
    Armdroid's TRS-80 program had (arm facts, section 3); digits as positive are a choice.

    Attributes:
        positive: the keys that count J1 to J6 up.
        negative: the keys that count them down.
        leave: the key that ends `@SET`.
    """

    positive: tuple[Key, ...] = (Key.N1, Key.N2, Key.N3, Key.N4, Key.N5, Key.N6)
    negative: tuple[Key, ...] = (Key.Q, Key.W, Key.E, Key.R, Key.T, Key.Y)
    leave: Key = Key.N0

    def __post_init__(self) -> None:
        keys = (*self.positive, *self.negative, self.leave)
        if len(self.positive) != 6 or len(self.negative) != 6:
            raise ValueError("manual mode needs six keys for each direction")
        if len(set(keys)) != len(keys) or Key.BREAK in keys:
            raise ValueError("the keys of manual mode must differ from each other and from BREAK")

    def look(self, matrix: KeyMatrix) -> KeysDown:
        """Read every row that has one of these keys, or BREAK, in it, each once."""
        keys = (*self.positive, *self.negative, self.leave, Key.BREAK)
        rows = dict.fromkeys(MATRIX[key][0] for key in keys)
        return KeysDown({row: matrix.peek(KEYBOARD_START | 1 << row) for row in rows})

    def directions(self, down: KeysDown) -> tuple[int, ...]:
        """Where each of the six joints is to go: 1, -1, or 0 for no key or both keys of a pair."""
        pairs = zip(self.positive, self.negative, strict=True)
        return tuple((plus in down) - (minus in down) for plus, minus in pairs)
