"""Solids in braille: edges in dots, and between them as many as the brightness asks for."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from trs80arm.drawing.cells import NO_INK, Cells, Samples, levels
from trs80arm.drawing.materials import SHADOW
from trs80arm.drawing.rows import LEVELS

SAMPLES = (2, 4)
_BLANK = 0x2800
_DOTS = np.array([0x01, 0x08, 0x02, 0x10, 0x04, 0x20, 0x40, 0x80])
"""The bit of each dot of a cell: four rows of two (Unicode, braille patterns)."""
_BRIGHTER = np.array([0.06, 0.56, 0.81, 0.31, 0.19, 0.69, 0.94, 0.44], dtype=np.float32)[
    :, None, None
]
"""Brightness from which each sample of a cell is a dot: ordered dither over 2 x 4."""
SHADE = 0x2805
"""What is in the shadow on the table."""
FULL = 0.85
"""How much of the dots the brightest face has."""


def draw(samples: Samples) -> Cells:
    """The cells of a picture."""
    _, height, width = samples.shape
    cells = Cells(height, width)
    nearest = samples.nearness.argmax(0)[None]
    ink = np.take_along_axis(samples.ink, nearest, 0)[0]
    same = samples.body == np.take_along_axis(samples.body, nearest, 0)
    dots = samples.light * np.float32(FULL) > _BRIGHTER
    dots |= _edges(samples.body) & same
    dots &= samples.body > 0
    pattern = np.tensordot(_DOTS, dots, 1)
    shown = pattern > 0
    cells.glyphs = np.where(shown, _BLANK + pattern, 32).astype(np.uint32)
    cells.ink = np.where(shown, ink, NO_INK)
    light = (samples.light * same).sum(0) / same.sum(0)
    # The dots say how bright it is; the ink says it a second time, less loudly.
    cells.level = np.where(shown, levels(0.45 + 0.55 * light), 0)
    cells.free = ~shown
    shaded = ~shown & ((samples.ink == SHADOW).sum(0) > len(_DOTS) // 2)
    cells.glyphs[shaded] = SHADE
    cells.ink[shaded] = SHADOW
    cells.level[shaded] = LEVELS // 2
    return cells


def _edges(body: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """Samples next to another thing than their own, in their cell or in the next."""
    _, height, width = body.shape
    sheet = body.reshape(4, 2, height, width).transpose(2, 0, 3, 1).reshape(4 * height, 2 * width)
    edge = np.zeros(sheet.shape, dtype=bool)
    across, down = sheet[:, 1:] != sheet[:, :-1], sheet[1:] != sheet[:-1]
    edge[:, 1:] |= across
    edge[:, :-1] |= across
    edge[1:] |= down
    edge[:-1] |= down
    return edge.reshape(height, 4, width, 2).transpose(1, 3, 0, 2).reshape(body.shape)
