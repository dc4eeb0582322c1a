"""Pictures in pixels: the same scene as in characters, sample by sample."""

from __future__ import annotations

import numpy as np
import pytest

from tests.drawing import samples
from trs80arm.drawing.materials import INKS
from trs80arm.drawing.picture import FROM_ABOVE, FROM_THE_SIDE, IN_SPACE, Picture, Subject
from trs80arm.drawing.pixels import Colours, Pixels
from trs80arm.drawing.rows import Ink

GRAIN = (10, 20)
GROUND = (7, 19, 10)
DARK = Colours(GROUND, {ink: (200, 100 + place, 40) for place, ink in enumerate(Ink)})
PAPER = Colours((250, 246, 236), {ink: (20, 40 + place, 60) for place, ink in enumerate(Ink)})


def pixels(subject: Subject, width: int = 40, height: int = 16) -> Pixels:
    return Picture(subject).pixels(samples.readings(), width, height, GRAIN)


@pytest.mark.parametrize("subject", [FROM_THE_SIDE, FROM_ABOVE, IN_SPACE])
def test_every_view_shows_arm_table_and_parts(subject: Subject) -> None:
    drawn = pixels(subject)
    assert drawn.ink.shape == (16 * 20, 40 * 10)
    seen = {INKS[ink] for ink in np.unique(drawn.ink) if ink >= 0}
    assert {Ink.ARM, Ink.TABLE, Ink.PART, Ink.FURNITURE, Ink.METAL} <= seen


def test_the_scales_are_written_over_it() -> None:
    written = list(pixels(FROM_THE_SIDE).written())
    bottom = "".join(sign for _, row, sign, _ in written if row == 15)
    assert "5" in bottom


def test_nothing_is_written_where_something_stands() -> None:
    drawn = pixels(FROM_ABOVE)
    arm = drawn.ink == INKS.index(Ink.ARM)
    for column, row, _, _ in drawn.written():
        assert not arm[row * 20 : row * 20 + 20, column * 10 : column * 10 + 10].any()


def test_what_shows_nothing_has_the_colour_of_the_ground() -> None:
    drawn = pixels(FROM_THE_SIDE)
    assert drawn.ink[0, 0] == -1
    assert tuple(drawn.coloured(DARK)[0, 0]) == GROUND


def test_an_ink_goes_from_near_the_ground_to_its_own_colour() -> None:
    drawn = pixels(FROM_THE_SIDE)
    arm = drawn.ink == INKS.index(Ink.ARM)
    greens = drawn.coloured(DARK)[arm][:, 1]
    assert GROUND[1] < greens.min() < greens.max() <= DARK.inks[Ink.ARM][1]
    assert len(np.unique(greens)) > 3


def test_a_shadow_is_darker_than_the_table_on_any_ground() -> None:
    drawn = pixels(FROM_ABOVE)
    shadow, table = (drawn.ink == INKS.index(ink) for ink in (Ink.SHADOW, Ink.TABLE))
    for colours in (DARK, PAPER):
        shown = drawn.coloured(colours).astype(int).sum(2)
        assert shown[shadow].mean() < shown[table].mean()
