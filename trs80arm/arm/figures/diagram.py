"""A figure that is no chart: drawn on a sheet, and arranged as plain text beside it."""

from __future__ import annotations

from dataclasses import dataclass

from trs80arm.arm.figures.sheet import Sheet

WIDTH = 79
"""Columns that a diagram in text takes, at most."""


class Page:
    """Plain characters, put where they belong."""

    def __init__(self) -> None:
        self._rows: list[list[str]] = []

    def put(self, row: int, column: int, text: str) -> None:
        """Write something, over what stands there; blanks of it leave that alone."""
        while len(self._rows) <= row:
            self._rows.append([" "] * WIDTH)
        for place, character in enumerate(text, column):
            if character != " " and 0 <= place < WIDTH:
                self._rows[row][place] = character

    @property
    def lines(self) -> list[str]:
        """All of it, a line a row."""
        return ["".join(row).rstrip() for row in self._rows]


@dataclass(frozen=True)
class Diagram:
    """A drawing of parts and what belongs to them.

    Attributes:
        lines: in plain characters, as they stand below each other.
        sheet: the same drawn.
    """

    lines: tuple[str, ...]
    sheet: Sheet
