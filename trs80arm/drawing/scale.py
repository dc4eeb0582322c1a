"""The scales of the side view, in inches: along the table's edge, and up the left side."""

from __future__ import annotations

from math import ceil, floor

from trs80arm.drawing.cells import Cells
from trs80arm.drawing.materials import SHADOW
from trs80arm.drawing.rows import Ink
from trs80arm.drawing.viewport import ASPECT, Window

_EVERY = 5
"""Inches from one figure to the next."""
_ROOM = 5
"""Columns an inch from which every inch has its figure."""
_LEAST = 1.5
"""Columns an inch below which inches have no marks."""
_BELOW = 0.02
"""How far below the table's surface its edge is looked for, inches."""


def rule_table(cells: Cells, window: Window) -> None:
    """Draw a scale along the table's edge: a mark an inch, a figure every five."""
    height, width = cells.glyphs.shape
    row = floor(window.cell((0.0, -_BELOW))[1])
    if not 0 <= row < height:
        return
    for column in range(width):
        glyph = cells.glyphs[row, column]
        if glyph in (ord(" "), ord(":")):
            dark = cells.under[row, column] == SHADOW
            cells.write(column, row, "=" if dark else "-", Ink.SHADOW if dark else Ink.TABLE)
    columns = window.scale * ASPECT
    first, last = ceil(window.left), floor(window.left + width / columns)
    for inch in range(first, last + 1):
        column = floor(window.cell((inch, 0.0))[0])
        if inch % _EVERY == 0 or columns >= _ROOM:
            text = str(abs(inch))
            cells.write(column - (len(text) - 1) // 2, row, text, Ink.LABEL)
        elif columns >= _LEAST:
            cells.write(column, row, "+", Ink.LABEL)


def rule_height(cells: Cells, window: Window) -> None:
    """Write heights above the table at the left edge, every five inches."""
    height, _ = cells.glyphs.shape
    for inch in range(_EVERY, ceil(window.top) + 1, _EVERY):
        row = floor(window.cell((0.0, inch))[1])
        if 0 <= row < height:
            cells.write(0, row, f"{inch}-", Ink.LABEL)
