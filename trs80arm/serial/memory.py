"""The TeachMover's memory for a program: rows of eight numbers, as `@QDUMP` has them.

A row is sixteen bytes, two to a number, the first the low one. How a move lies in them is known
from TeachMover Virtual Command, which writes such rows: the number of the step, 0, its kind,
255 - SP, then the low bytes of the six positions and the high ones.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TypeAlias

Row: TypeAlias = tuple[int, int, int, int, int, int, int, int]
"""Eight numbers, each 0 to 65535."""

STEPS = 53
"""Rows that the memory holds, steps 1 to 53: chosen, for 1 K of RAM with some left over."""
WORD = 0xFFFF
MOVE = 1
"""The kind of a row that is a move to a position."""


def row_of(numbers: Sequence[int | None]) -> Row | None:
    """Eight numbers as a row; None if they are not eight, or one does not fit into two bytes."""
    given = [number for number in numbers if number is not None and 0 <= number <= WORD]
    if len(numbers) != 8 or len(given) != 8:
        return None
    a, b, c, d, e, f, g, h = given
    return a, b, c, d, e, f, g, h


def number_of(row: Row) -> int:
    """The step that a row is: its first byte."""
    return row[0] & 0xFF


def kind_of(row: Row) -> int:
    """What kind of step it is: its third byte, `MOVE` or another."""
    return row[1] & 0xFF


@dataclass(frozen=True)
class Move:
    """A row that is a move.

    Attributes:
        speed: SP, 0 to 255.
        position: the six registers where it ends, -32768 to 32767.
    """

    speed: int
    position: tuple[int, int, int, int, int, int]

    def row(self, number: int) -> Row:
        """It as the row of a step, 0 to 255."""
        words = [count & WORD for count in self.position]
        low = [word & 0xFF for word in words]
        high = [word >> 8 for word in words]
        pairs = [
            second << 8 | first
            for half in (low, high)
            for first, second in zip(half[::2], half[1::2], strict=True)
        ]
        c, d, e, f, g, h = pairs
        return number, (255 - self.speed) << 8 | MOVE, c, d, e, f, g, h

    @classmethod
    def of(cls, row: Row) -> Move:
        """The move that a row is."""
        halves = [half for word in row[2:] for half in (word & 0xFF, word >> 8)]
        counts = [low | high << 8 for low, high in zip(halves[:6], halves[6:], strict=True)]
        j1, j2, j3, j4, j5, j6 = ((count ^ 0x8000) - 0x8000 for count in counts)
        return cls(255 - (row[1] >> 8), (j1, j2, j3, j4, j5, j6))


class TeachMemory:
    """The store itself: a row to each step, in the order of the steps.

    Attributes:
        rows: the rows by step, 1 to `STEPS`.
    """

    def __init__(self) -> None:
        self.rows: dict[int, Row] = {}

    def __len__(self) -> int:
        return len(self.rows)

    def __iter__(self) -> Iterator[Row]:
        return iter(self.dump())

    def dump(self) -> list[Row]:
        """All rows, by step."""
        return [self.rows[number] for number in sorted(self.rows)]

    def read(self, number: int) -> Row | None:
        """The row of a step; None if there is none."""
        return self.rows.get(number)

    def write(self, row: Row) -> bool:
        """Put a row at the step that it names, in the place of what was there.

        Returns:
            Whether there is such a step; if not, nothing is changed.
        """
        number = number_of(row)
        if not 1 <= number <= STEPS:
            return False
        self.rows[number] = row
        return True

    def erase(self, number: int) -> None:
        """Take away the row of a step, if there is one."""
        self.rows.pop(number, None)

    @property
    def possible(self) -> bool:
        """Whether it holds what it can: one from outside may not."""
        return all(
            1 <= number <= STEPS and row_of(row) == row and number_of(row) == number
            for number, row in self.rows.items()
        )

    def clear(self) -> None:
        """Take all rows away."""
        self.rows.clear()
