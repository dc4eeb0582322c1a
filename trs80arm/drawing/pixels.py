"""A picture in pixels, for terminals that show them: inks and light, sample by sample.

Colours belong to a theme; who has one turns the samples into a picture with `coloured`. Scales and
marks stay characters, a sheet of cells, and are written over it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from trs80arm.drawing.cells import Cells, Samples
from trs80arm.drawing.materials import INKS, SHADOW
from trs80arm.drawing.rows import DARKEST, LIGHT, Ink

Triplet: TypeAlias = tuple[int, int, int]


@dataclass(frozen=True)
class Colours:
    """The colours of a theme, each as red, green and blue.

    Attributes:
        ground: of what shows nothing.
        inks: of each ink in full light.
    """

    ground: Triplet
    inks: Mapping[Ink, Triplet]


SHADES = 64
"""How many shades an ink has."""
SHADOW_ON_LIGHT = 0.42
"""How much ink a shadow has on a light ground."""


@dataclass(frozen=True, slots=True, eq=False)
class Pixels:
    """A picture, rows x columns of samples.

    Attributes:
        ink: index of each sample's ink, or `NO_INK`.
        light: how bright it is, 0 to 1.
        words: what is written over it: cells, of which the blank ones show the picture.
    """

    ink: npt.NDArray[np.int8]
    light: npt.NDArray[np.float32]
    words: Cells

    @classmethod
    def of(cls, samples: Samples, grain: tuple[int, int]) -> Pixels:
        """The picture of samples that are gathered by cells.

        Args:
            samples: of a picture.
            grain: how many a cell has across and down.
        """
        _, height, width = samples.shape
        words = Cells(height, width)
        words.free[:] = (samples.body <= 0).all(0)
        return cls(_spread(samples.ink, grain), _spread(samples.light, grain), words)

    def written(self) -> Iterator[tuple[int, int, str, Ink]]:
        """What is written over it: column and row of the cell, character, ink."""
        for row, column in np.argwhere(self.words.glyphs != ord(" ")).tolist():
            cell = row, column
            yield column, row, chr(self.words.glyphs[cell]), INKS[self.words.ink[cell]]

    def coloured(self, colours: Colours) -> npt.NDArray[np.uint8]:
        """Red, green and blue of each sample, in the colours of a theme."""
        ground = np.array(colours.ground, dtype=np.float64)
        # `NO_INK` is -1: the last row is the ground's.
        inks = np.array([*(colours.inks[ink] for ink in INKS), colours.ground]) - ground
        shares = DARKEST + (1 - DARKEST) * np.arange(SHADES) / (SHADES - 1)
        table = np.zeros((len(inks), SHADES, 4))
        table[..., :3] = ground + inks[:, None] * shares[:, None]
        if ground.sum() > LIGHT:
            table[SHADOW, :, :3] = ground + inks[SHADOW] * SHADOW_ON_LIGHT
        # Looked up as one number, which is much quicker than as three.
        numbers = np.rint(table).astype(np.uint8).view(np.uint32).ravel()
        code = self.ink % len(inks) * np.int16(SHADES)
        code += (np.clip(self.light, 0.0, 1.0) * (SHADES - 1)).astype(np.int16)
        colours_of: npt.NDArray[np.uint8] = numbers[code].view(np.uint8)
        return colours_of.reshape(*code.shape, 4)[..., :3]


def _spread(values: npt.NDArray[Any], grain: tuple[int, int]) -> npt.NDArray[Any]:
    """Values gathered by cells as the rows and columns of a picture."""
    _, height, width = values.shape
    across, down = grain
    cells = values.reshape(down, across, height, width).transpose(2, 0, 3, 1)
    return cells.reshape(height * down, width * across)
