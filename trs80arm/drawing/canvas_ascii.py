r"""Line drawing in plain ASCII: a sheet of cells on which links are drawn with `_ . - ' / \ |`.

The views draw on it in cells, x to the right and y downwards, fractions allowed. A cell is taken to
be twice as high as wide, as in nearly every terminal. Where two things meet in a cell the later one
stays, so views draw from the back to the front.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import floor
from typing import TypeAlias

from trs80arm.drawing.rows import Ink, Row, inked

Point: TypeAlias = tuple[float, float]

_LEVELS = "'-._"
"""Glyphs of a flat line from the top of a cell to its bottom."""
_COARSE_LEVELS = "'."
"""The same for a line that climbs more than two rows in five columns."""
_STEEP = 1.4
"""Columns a row from which a line counts as flat and is drawn column by column."""


def _covered(one: float, other: float, least: float) -> tuple[int, int]:
    """The first and last cell of which at least so much lies between two places."""
    start, stop = sorted((one, other))
    first, last = floor(start + least), floor(stop - least)
    if last < first:
        first = last = floor((start + stop) / 2)
    return first, last


class AsciiCanvas:
    """A sheet of `width` x `height` cells, blank at first."""

    def __init__(self, width: int, height: int) -> None:
        self.width = width
        self.height = height
        self._cells = [[" "] * width for _ in range(height)]
        self._inks = [[Ink.PLAIN] * width for _ in range(height)]

    def _put(self, column: int, row: int, glyph: str, ink: Ink) -> None:
        if 0 <= column < self.width and 0 <= row < self.height:
            self._cells[row][column] = glyph
            self._inks[row][column] = ink

    def line(self, start: Point, end: Point, ink: Ink) -> None:
        r"""Draw a line: flat ones with `'-._`, steep ones with `|`, `/` and `\`."""
        if abs(end[0] - start[0]) >= _STEEP * abs(end[1] - start[1]):
            left, right = sorted((start, end))
            self._flat(left, right, ink)
        else:
            top, bottom = sorted((start, end), key=lambda point: point[1])
            self._steep(top, bottom, ink)

    def _flat(self, left: Point, right: Point, ink: Ink) -> None:
        (x0, y0), (x1, y1) = left, right
        slope = (y1 - y0) / (x1 - x0) if x1 > x0 else 0.0
        levels = _COARSE_LEVELS if abs(slope) > 0.4 else _LEVELS
        level = abs(slope) < 0.02
        first, last = floor(x0), floor(x1)
        for column in range(max(0, first), min(self.width - 1, last) + 1):
            middle = min(max(column + 0.5, x0), x1)
            row, part = divmod(floor(len(levels) * (y0 + slope * (middle - x0))), len(levels))
            glyph = "-" if level else levels[part]
            self._put(column, row, glyph, ink)

    def _steep(self, top: Point, bottom: Point, ink: Ink) -> None:
        (x0, y0), (x1, y1) = top, bottom
        slope = (x1 - x0) / (y1 - y0) if y1 > y0 else 0.0
        leaning = "\\" if slope > 0 else "/"
        first, last = floor(y0), floor(y1)

        def column_at(row: int) -> int:
            return floor(x0 + slope * (min(max(row + 0.5, y0), y1) - y0))

        for row in range(max(0, first), min(self.height - 1, last) + 1):
            column = column_at(row)
            # A line that stands nearly upright bends only where it changes its column.
            moves = row < last and column_at(row + 1) != column
            self._put(column, row, leaning if moves or abs(slope) > 0.6 else "|", ink)

    def dots(self, points: Iterable[Point], ink: Ink, glyphs: str) -> None:
        """Mark points by the first glyph in a cell's upper half and the second in its lower half.

        Only where the sheet is still blank.
        """
        for x, y in points:
            column, row = floor(x), floor(y)
            if (
                0 <= column < self.width
                and 0 <= row < self.height
                and self._cells[row][column] == " "
            ):
                self._put(column, row, glyphs[y - row >= 0.5], ink)

    def write(self, column: int, row: int, text: str, ink: Ink) -> None:
        """Write text into cells; blanks of it leave what is there."""
        for place, glyph in enumerate(text, column):
            if glyph != " ":
                self._put(place, row, glyph, ink)

    def box(self, corner: Point, opposite: Point, ink: Ink, fill: str) -> None:
        """Draw a box of `[` and `]`, `fill` between; a single cell is the fill alone.

        A box has the cells whose middles it covers, and if there is none, the one in which its own
        middle is, as a joint there would have. One filled with `_` is hollow where it has room.
        """
        first, last = _covered(corner[0], opposite[0], 0.25)
        high, low = _covered(corner[1], opposite[1], 0.5)
        hollow = fill == "_" and low - high >= 2
        for row in range(max(0, high), min(low, self.height - 1) + 1):
            if hollow:
                edge, glyph = ("." if row == high else "'"), "-"
                if high < row < low:
                    edge, glyph = "|", ""
            else:
                edge, glyph = "", fill
            if glyph:
                for column in range(max(0, first), min(last, self.width - 1) + 1):
                    self._put(column, row, glyph, ink)
            if last > first:
                self._put(first, row, edge or "[", ink)
                self._put(last, row, edge or "]", ink)

    def joint(self, centre: Point, ink: Ink, glyph: str, *, round_it: bool) -> None:
        """Mark a joint with its glyph, in parentheses for a disc."""
        column, row = floor(centre[0]), floor(centre[1])
        self._put(column, row, glyph, ink)
        if round_it:
            self._put(column - 1, row, "(", ink)
            self._put(column + 1, row, ")", ink)

    def rows(self) -> list[Row]:
        """The drawing, one row for each line of cells."""
        return [inked(cells, inks) for cells, inks in zip(self._cells, self._inks, strict=True)]
