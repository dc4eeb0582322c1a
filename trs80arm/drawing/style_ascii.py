r"""Solids in plain ASCII: filled with a ramp from `:` to `@`, their edges in strokes that fit.

A cell has 2 x 4 samples. Where what is nearest covers all of it, the brightness chooses the
character; where it ends within the cell, the shape of what is covered does.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from trs80arm.drawing.cells import NO_INK, Cells, Samples, levels, nearest_but
from trs80arm.drawing.materials import GHOST, SHADOW
from trs80arm.drawing.rows import LEVELS

SAMPLES = (2, 4)
RAMP = ":;-=+*xo#%&@"
"""Characters from the darkest to the brightest."""
SHADE = ":"
"""What is in the shadow on the table, and what is not there but was told to be."""
GROUND = 0.5
"""How bright what is behind a character is, to what is seen."""
DIMMEST = 0.45
"""How bright a character is at least, to be told from what is behind it."""

_SHAPES = {
    # Flat edges: what is below, and what is above them.
    "_": "00000011",
    ".": "00000001 00000010",
    "-": "00001111 00111100",
    '"': "11000000 11110000",
    "'": "01000000 10000000",
    # Upright ones.
    "|": "10101010 01010101",
    # Slopes, what is covered below or above them.
    "/": "00010111 00010101 01011111 00011111 01010111 "
    "11101000 10101000 11111010 11111000 11101010",
    "\\": "00101011 00101010 10101111 00101111 10101011 "
    "11010100 01010100 11110101 11110100 11010101",
    ",": "00000101 00000110 00001010",
    "`": "01010000 10100000",
}


def _table() -> npt.NDArray[np.uint32]:
    """The character of each pattern of eight samples; 0 where the ramp is to fill the cell.

    It is the one whose shape differs least: where they differ, and how far their middles are apart.
    """
    pairs = [(glyph, shape) for glyph, shapes in _SHAPES.items() for shape in shapes.split()]
    codes = np.array([ord(glyph) for glyph, _ in pairs], dtype=np.uint32)
    shapes = np.array([[int(bit) for bit in shape] for _, shape in pairs])
    bits = np.unpackbits(np.arange(256, dtype=np.uint8)[:, None], axis=1).astype(np.int64)
    differ = np.abs(bits[:, None] - shapes).sum(2)
    apart = np.abs(_middles(bits)[:, None] - _middles(shapes)).sum(2)
    table: npt.NDArray[np.uint32] = codes[(differ + _APART * apart).argmin(1)]
    table[bits.sum(1) >= _NEARLY_ALL] = 0
    table[0] = 0
    return table


_PLACES = np.array([(place % 2, place // 2 / 1.5) for place in range(8)])
_APART = 1.5
"""How much the distance of the middles counts, to a sample that differs."""
_NEARLY_ALL = 7


def _middles(bits: npt.NDArray[np.int64]) -> npt.NDArray[np.float64]:
    """Where the middles of patterns are."""
    middles: npt.NDArray[np.float64] = bits @ _PLACES / np.maximum(bits.sum(1), 1)[:, None]
    return middles


_GLYPHS = _table()
_RAMP = np.array([ord(glyph) for glyph in RAMP], dtype=np.uint32)
_ORDER = np.array([3, 4, 2, 5, 1, 6, 0, 7])
"""Samples of a cell from its middle outwards."""
_BITS = 1 << np.arange(7, -1, -1)
"""The bit of each sample of a cell in the number of a pattern."""


def draw(samples: Samples) -> Cells:
    """The cells of a picture."""
    _, height, width = samples.shape
    cells = Cells(height, width)
    # Most cells are all table, all one face or all nothing: their first sample says everything.
    first = samples.first()
    ink, light, body = first.ink[0], first.light[0], first.body[0]
    mixed = samples.mixed()
    several = samples.of(mixed)
    every = np.arange(len(mixed))
    body[mixed] = nearest = several.body[several.nearness.argmax(0), every]
    same = several.body == nearest
    light[mixed] = (several.light * same).sum(0) / same.sum(0)
    ink[mixed] = several.ink[_ORDER[same[_ORDER].argmax(0)], every]
    shape = np.zeros(body.shape, dtype=np.uint32)
    shape[mixed] = _GLYPHS[_BITS @ same]
    solid = body > 0
    ghost = ink == GHOST
    level = levels(light)
    fill = np.where(ghost, np.uint32(ord(SHADE)), _RAMP[level])
    glyphs = np.where(solid, np.where(shape == 0, fill, shape), np.uint32(32))
    inks = np.where(solid, ink, NO_INK)
    bright = np.where(solid, levels(DIMMEST + (1 - DIMMEST) * light), 0)
    shaded = ~solid & (ink == SHADOW)
    glyphs[shaded], inks[shaded], bright[shaded] = ord(SHADE), SHADOW, LEVELS // 2
    # Behind the character: the same thing, darker, or what is next behind it.
    under = np.where(ghost, NO_INK, ink)
    lit = np.where(body == 0, light, light * GROUND)
    partly = np.flatnonzero(solid[mixed] & (shape[mixed] != 0))
    behind = nearest_but(several.nearness[:, partly], same[:, partly]), partly
    under[mixed[partly]] = several.ink[behind]
    dim = several.light[behind]
    lit[mixed[partly]] = np.where(several.body[behind] == 0, dim, dim * GROUND)
    cells.glyphs, cells.ink, cells.level, cells.free, cells.under, cells.under_level = (
        values.reshape(height, width)
        for values in (
            glyphs,
            inks,
            bright,
            ~solid,
            under,
            np.where(under == NO_INK, 0, levels(lit)),
        )
    )
    return cells
