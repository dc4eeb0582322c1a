"""The scales of the side view, in inches: along the table's edge, and up the left side."""

from __future__ import annotations

from functools import lru_cache
from math import ceil, floor

import numpy as np

from trs80arm.drawing.cells import Cells, Marks, SheetShape, Text, apart
from trs80arm.drawing.materials import INKS, SHADOW
from trs80arm.drawing.rows import Ink
from trs80arm.drawing.viewport import ASPECT, Window

_TABLE = INKS.index(Ink.TABLE)
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
    glyphs = cells.glyphs[row]
    plain = cells.free[row] & ((glyphs == ord(" ")) | (glyphs == ord(":")))
    dark = cells.under[row] == SHADOW
    lines = np.where(dark, ord("="), ord("-")), np.where(dark, SHADOW, _TABLE)
    places = plain.nonzero()[0]
    cells.mark(Marks(row * width + places, lines[0][places], lines[1][places]))
    cells.mark(_figures(window, row, (height, width)))


def rule_height(cells: Cells, window: Window) -> None:
    """Write heights above the table at the left edge, every five inches."""
    cells.mark(_heights(window, cells.glyphs.shape))


@lru_cache(16)
def _figures(window: Window, row: int, shape: SheetShape) -> Marks:
    """The marks and figures of the inches."""
    _, width = shape
    columns = window.scale * ASPECT
    first, last = ceil(window.left), floor(window.left + width / columns)
    inches = sorted(range(first, last + 1), key=abs)
    fives = [inch for inch in inches if inch % _EVERY == 0]
    figured = inches if columns >= _ROOM else fives

    def at(inch: int, sign: str) -> Text:
        column = floor(window.cell((inch, 0.0))[0]) - (len(sign) - 1) // 2
        return column, row, sign, Ink.LABEL

    marks = [at(inch, "+") for inch in inches] if _LEAST <= columns < _ROOM else []
    figures = apart(at(inch, str(abs(inch))) for inch in figured)
    return Marks.written([*marks, *(figure for figure in figures if figure[0] >= 0)], shape)


@lru_cache(16)
def _heights(window: Window, shape: SheetShape) -> Marks:
    """The figures of the heights."""
    heights = range(_EVERY, ceil(window.top) + 1, _EVERY)
    return Marks.written(
        [(0, floor(window.cell((0.0, inch))[1]), f"{inch}-", Ink.LABEL) for inch in heights],
        shape,
    )
