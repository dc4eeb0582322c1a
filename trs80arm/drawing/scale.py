"""The scales of the side view, in inches: along the table's edge, and up the left side."""

from __future__ import annotations

from math import ceil, floor

import numpy as np

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
    plain = cells.free[row] & np.isin(cells.glyphs[row], (ord(" "), ord(":")))
    dark = cells.under[row] == SHADOW
    for glyph, ink, where in (("-", Ink.TABLE, plain & ~dark), ("=", Ink.SHADOW, plain & dark)):
        places = np.flatnonzero(where) + 0.5
        cells.mark(places, np.full(len(places), row + 0.5), 2 * glyph, ink)
    columns = window.scale * ASPECT
    first, last = ceil(window.left), floor(window.left + width / columns)
    text = [" "] * width
    for inch in range(first, last + 1):
        figure = str(abs(inch)) if inch % _EVERY == 0 or columns >= _ROOM else "+"
        begin = floor(window.cell((inch, 0.0))[0]) - (len(figure) - 1) // 2
        if begin >= 0 and (figure != "+" or columns >= _LEAST):
            text[begin : begin + len(figure)] = figure
    cells.write(0, row, "".join(text[:width]), Ink.LABEL)


def rule_height(cells: Cells, window: Window) -> None:
    """Write heights above the table at the left edge, every five inches."""
    height, _ = cells.glyphs.shape
    for inch in range(_EVERY, ceil(window.top) + 1, _EVERY):
        row = floor(window.cell((0.0, inch))[1])
        if 0 <= row < height:
            cells.write(0, row, f"{inch}-", Ink.LABEL)
