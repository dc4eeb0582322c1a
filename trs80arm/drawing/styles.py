"""The styles in which solids are drawn: how finely they look, and who makes the cells."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from trs80arm.drawing import style_ascii, style_braille
from trs80arm.drawing.cells import Cells, Samples
from trs80arm.drawing.style_blocks import HALVES, SEXTANTS
from trs80arm.options import ArmStyle


@dataclass(frozen=True)
class SolidStyle:
    """A style.

    Attributes:
        samples: a cell, across and down.
        draw: makes cells of the samples.
    """

    samples: tuple[int, int]
    draw: Callable[[Samples], Cells]


SOLID_STYLES: Mapping[ArmStyle, SolidStyle] = {
    ArmStyle.ASCII: SolidStyle(style_ascii.SAMPLES, style_ascii.draw),
    ArmStyle.HALF: SolidStyle(HALVES.samples, HALVES.draw),
    ArmStyle.SEXTANT: SolidStyle(SEXTANTS.samples, SEXTANTS.draw),
    ArmStyle.BRAILLE: SolidStyle(style_braille.SAMPLES, style_braille.draw),
    ArmStyle.PIXELS: SolidStyle(HALVES.samples, HALVES.draw),
}
"""All of them but the bare outlines, which are drawn on a canvas of their own.

Where pixels are wanted and cannot be shown, behind a dialog, there are half blocks in their place.
"""
