"""Solids in blocks: half a cell, or a sixth, a colour; two colours a cell."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from trs80arm.drawing.cells import NO_INK, Cells, Samples, levels, nearest_but
from trs80arm.machine.video import sextant

LIKE = 0.13
"""How much two samples of one ink may differ in brightness to be drawn as one."""


@dataclass(frozen=True, eq=False)
class Blocks:
    """A set of blocks.

    Attributes:
        samples: how many blocks a cell has across and down.
        glyphs: the character of each pattern, the first block of a row as the lowest bit.
    """

    samples: tuple[int, int]
    glyphs: npt.NDArray[np.uint32]

    def draw(self, samples: Samples) -> Cells:
        """The cells of a picture: what is nearest, before what is next behind it."""
        height, width, count = samples.ink.shape
        cells = Cells(height, width)
        nearest = samples.nearness.argmax(2)[..., None]
        ink = np.take_along_axis(samples.ink, nearest, 2)
        light = np.take_along_axis(samples.light, nearest, 2)
        same = (samples.ink == ink) & (np.abs(samples.light - light) < LIKE)
        pattern = (same << np.arange(count)).sum(2)
        full = pattern == (1 << count) - 1
        shown = ink[..., 0] != NO_INK
        cells.glyphs = np.where(shown, self.glyphs[pattern], np.uint32(32))
        cells.ink = np.where(shown, ink[..., 0], NO_INK)
        cells.level = np.where(shown, levels((samples.light * same).sum(2) / same.sum(2)), 0)
        partly = (shown & ~full).nonzero()
        same, inks, lights = same[partly], samples.ink[partly], samples.light[partly]
        others = nearest_but(samples.nearness[partly], same)
        behind = np.take_along_axis(inks, others, 1)
        alike = ~same & (inks == behind)
        cells.under[partly] = behind[:, 0]
        lit = levels((lights * alike).sum(1) / alike.sum(1))
        cells.under_level[partly] = np.where(behind[:, 0] == NO_INK, 0, lit)
        # A mark takes all of its cell, so that at the table's edge there is no room for one.
        table = np.take_along_axis(samples.body, nearest, 2)[..., 0] == 0
        cells.free = ~shown | (full & table)
        return cells


def _codes(glyphs: str) -> npt.NDArray[np.uint32]:
    return np.array([ord(glyph) for glyph in glyphs], dtype=np.uint32)


HALVES = Blocks((1, 2), _codes(" ▀▄█"))
SEXTANTS = Blocks((2, 3), _codes("".join(map(sextant, range(64)))))
