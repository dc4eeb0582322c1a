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
        count, height, width = samples.shape
        # Most cells show one thing in one light: their first sample says everything.
        first = samples.first()
        ink, light, body = first.ink[0], first.light[0], first.body[0]
        mixed = samples.mixed()
        several = samples.of(mixed)
        nearest = several.nearness.argmax(0), np.arange(len(mixed))
        ink[mixed], body[mixed] = several.ink[nearest], several.body[nearest]
        same = several.ink == several.ink[nearest]
        same &= np.abs(several.light - several.light[nearest]) < LIKE
        light[mixed] = (several.light * same).sum(0) / same.sum(0)
        pattern = np.full(ink.shape, (1 << count) - 1)
        pattern[mixed] = (1 << np.arange(count)) @ same
        full = pattern == (1 << count) - 1
        shown = ink != NO_INK
        # In the rest of the cell, what is nearest there.
        under = np.full(ink.shape, NO_INK, dtype=np.int64)
        under_level = np.zeros(ink.shape, dtype=np.int64)
        partly = np.flatnonzero((shown & ~full)[mixed])
        some, same = several.of(partly), same[:, partly]
        behind = some.ink[nearest_but(some.nearness, same), np.arange(len(partly))]
        alike = ~same & (some.ink == behind)
        lit = levels((some.light * alike).sum(0) / alike.sum(0))
        under[mixed[partly]] = behind
        under_level[mixed[partly]] = np.where(behind == NO_INK, 0, lit)
        cells = Cells(height, width)
        cells.glyphs, cells.ink, cells.level, cells.under, cells.under_level, cells.free = (
            values.reshape(height, width)
            for values in (
                np.where(shown, self.glyphs[pattern], np.uint32(32)),
                np.where(shown, ink, NO_INK),
                np.where(shown, levels(light), 0),
                under,
                under_level,
                # A mark takes all of its cell: at the table's edge there is no room for one.
                ~shown | (full & (body == 0)),
            )
        )
        return cells


def _codes(glyphs: str) -> npt.NDArray[np.uint32]:
    return np.array([ord(glyph) for glyph in glyphs], dtype=np.uint32)


HALVES = Blocks((1, 2), _codes(" ▀▄█"))
SEXTANTS = Blocks((2, 3), _codes("".join(map(sextant, range(64)))))
