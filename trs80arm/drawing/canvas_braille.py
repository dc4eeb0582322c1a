"""Line drawing in braille: every cell holds 2 x 4 nearly square dots.

The finer brother of `canvas_ascii`, with the same methods in the same cells, for terminals whose
font has braille. Pure Python, as the measurements ask for (terminal facts, section 2.3).
"""

from __future__ import annotations

from collections.abc import Iterable
from math import ceil, floor

from trs80arm.drawing.canvas_ascii import Point
from trs80arm.drawing.rows import Ink, Row, inked

_DOTS = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))
"""The bit of each dot of a cell: four rows of two (Unicode, braille patterns)."""
_BRAILLE = 0x2800


class BrailleCanvas:
    """A sheet of `width` x `height` cells, blank at first."""

    def __init__(self, width: int, height: int) -> None:
        self.width = width
        self.height = height
        self._dots = [[0] * width for _ in range(height)]
        self._inks = [[Ink.PLAIN] * width for _ in range(height)]
        self._texts: list[tuple[int, int, str, Ink]] = []

    def _set(self, x: int, y: int, ink: Ink) -> None:
        column, row = x >> 1, y >> 2
        if 0 <= column < self.width and 0 <= row < self.height:
            self._dots[row][column] |= _DOTS[y & 3][x & 1]
            self._inks[row][column] = ink

    def line(self, start: Point, end: Point, ink: Ink) -> None:
        """Draw a straight line of dots."""
        x, y = 2 * start[0], 4 * start[1]
        dx, dy = 2 * end[0] - x, 4 * end[1] - y
        count = max(1, ceil(max(abs(dx), abs(dy))))
        for place in range(count + 1):
            self._set(floor(x + dx * place / count), floor(y + dy * place / count), ink)

    def dots(self, points: Iterable[Point], ink: Ink, glyphs: str) -> None:
        """Mark points with single dots; a cell that is drawn already keeps its ink."""
        for x, y in points:
            column, row = floor(x), floor(y)
            if 0 <= column < self.width and 0 <= row < self.height:
                held = self._inks[row][column] if self._dots[row][column] else ink
                self._set(floor(2 * x), floor(4 * y), held)

    def write(self, column: int, row: int, text: str, ink: Ink) -> None:
        """Write text into cells; blanks of it leave what is there."""
        self._texts.append((column, row, text, ink))

    def box(self, corner: Point, opposite: Point, ink: Ink, fill: str) -> None:
        """Draw a box, filled with dots as densely as the glyph `fill` looks."""
        left, right = sorted((floor(2 * corner[0]), floor(2 * opposite[0])))
        top, bottom = sorted((floor(4 * corner[1]), floor(4 * opposite[1])))
        right, bottom = max(left, right - 1), max(top, bottom - 1)
        right, bottom = min(right, 2 * self.width), min(bottom, 4 * self.height)
        solid = fill == "#"
        for y in range(max(top, -1), bottom + 1):
            for x in range(max(left, -1), right + 1):
                edge = x in (left, right) or y in (top, bottom)
                if edge or solid or (fill == ":" and not (x + y) & 1):
                    self._set(x, y, ink)

    def joint(self, centre: Point, ink: Ink, glyph: str, *, round_it: bool) -> None:
        """Mark a joint by a small diamond, or a ring if there is room for one."""
        x, y = floor(2 * centre[0]), floor(4 * centre[1])
        ring = ((-1, -2), (0, -2), (1, -2), (2, -1), (2, 0), (2, 1), (1, 2), (0, 2), (-1, 2))
        marks = (*ring, (-2, 1), (-2, 0), (-2, -1)) if round_it else ()
        for dx, dy in marks or ((0, 0), (1, 0), (-1, 0), (0, 1), (0, -1)):
            self._set(x + dx, y + dy, ink)

    def rows(self) -> list[Row]:
        """The drawing, one row for each line of cells."""
        cells = [[chr(_BRAILLE + dots) if dots else " " for dots in row] for row in self._dots]
        for start, row, text, ink in self._texts:
            for column, glyph in enumerate(text, start):
                if glyph != " " and 0 <= column < self.width and 0 <= row < self.height:
                    cells[row][column] = glyph
                    self._inks[row][column] = ink
        return [inked(row, inks) for row, inks in zip(cells, self._inks, strict=True)]
