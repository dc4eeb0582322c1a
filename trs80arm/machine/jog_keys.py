"""Figure 11: the keys that move the arm in `@SET`, in the upper left corner of the keyboard.

The driver reads them straight from the matrix, all at once; the front end labels them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

from trs80arm.machine.keys import MATRIX, Key

_MATRIX_START = 0x3800


class KeyMatrix(Protocol):
    """The keyboard, as a program sees it."""

    def peek(self, address: int) -> int:
        """The byte at 3800H plus the selected rows' bits: 1 for each key that is down."""


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

    def directions(self, matrix: KeyMatrix) -> tuple[int, ...]:
        """Where each of the six joints is to go: 1, -1, or 0 for no key or both keys of a pair."""
        up, down = _are_down(matrix, self.positive), _are_down(matrix, self.negative)
        return tuple(plus - minus for plus, minus in zip(up, down, strict=True))


def is_down(matrix: KeyMatrix, key: Key) -> bool:
    """Whether a key is down, as the matrix reads."""
    row, bit = MATRIX[key]
    return bool(matrix.peek(_MATRIX_START | 1 << row) >> bit & 1)


def _are_down(matrix: KeyMatrix, keys: Sequence[Key]) -> list[bool]:
    return [is_down(matrix, key) for key in keys]
