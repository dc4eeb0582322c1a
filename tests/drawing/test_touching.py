"""What touches is drawn touching: part, fingers and table are rounded to cells in one way.

The sizes are those of the views in windows of 80 x 24 and 100 x 30, while the tube leads and while
the arm does.
"""

from __future__ import annotations

from collections.abc import Callable
from math import floor

import pytest

from tests.drawing import samples
from trs80arm.arm.geometry import inverse
from trs80arm.arm.models import MINIMOVER5
from trs80arm.arm.shapes import upright
from trs80arm.drawing.picture import FROM_ABOVE, FROM_THE_SIDE, Picture, Subject
from trs80arm.drawing.readings import Kind, Posture, Readings, Thing
from trs80arm.drawing.rows import Ink, Paint, Row
from trs80arm.drawing.studio import top_shot
from trs80arm.drawing.top_scene import top_scene
from trs80arm.drawing.viewport import Viewport, Window
from trs80arm.options import ArmStyle

Cells = set[tuple[int, int]]
OF_CHARACTERS = [style for style in ArmStyle if style is not ArmStyle.PIXELS]
SIDES = [(48, 6), (48, 15), (66, 10), (66, 20)]
TOPS = [(32, 6), (32, 15), (34, 11)]
PLACES = [(8.0, side * (2.5 + 0.17 * n)) for side in (-1, 1) for n in range(15)]


def reaching(x: float, y: float, z: float) -> Posture:
    """The hand straight down at a place, an inch open, across the table."""
    return Posture(MINIMOVER5, inverse(MINIMOVER5, x, y, z, -90.0, 90.0), 1.0)


def with_part(stands: Posture, place: tuple[float, float, float], *, held: bool) -> Readings:
    """An inch of a part, its middle at a place."""
    x, y, z = place
    box = upright(x, y, z - 0.5, (1.0, 1.0, 1.0), 0.0)
    return samples.readings(stands, things=(Thing(Kind.PART, "it", box, held=held),))


def drawn(subject: Subject, style: ArmStyle, readings: Readings, size: tuple[int, int]) -> Cells:
    """Column and row of every cell in which the part is seen."""
    picture = Picture(subject)
    picture.style, picture.labels = style, False
    return of_the_part(picture.draw(readings, *size))


def of_the_part(rows: list[Row]) -> Cells:
    cells = set()
    for y, row in enumerate(rows):
        x = 0
        for text, ink in row:
            if Ink.PART in ((ink.ink, ink.under) if isinstance(ink, Paint) else (ink,)):
                cells |= {(x + place, y) for place in range(len(text))}
            x += len(text)
    return cells


def from_above(style: ArmStyle) -> Callable[[Readings, int, int], Window]:
    """The window that a picture from above has."""
    seen = top_scene if style is ArmStyle.OUTLINE else top_shot
    return lambda readings, width, height: Viewport().window(seen(readings), width, height)


@pytest.mark.parametrize("style", OF_CHARACTERS)
@pytest.mark.parametrize("size", TOPS)
def test_a_part_seen_from_above_is_in_its_place(size: tuple[int, int], style: ArmStyle) -> None:
    for x, y in PLACES:
        readings = with_part(samples.STRETCHED_OUT, (x, y, 0.5), held=False)
        column, row = from_above(style)(readings, *size).cell((x, y))
        assert (floor(column), floor(row)) in drawn(FROM_ABOVE, style, readings, size)


@pytest.mark.parametrize("style", OF_CHARACTERS)
@pytest.mark.parametrize(
    ("subject", "size"),
    [*((FROM_THE_SIDE, size) for size in SIDES), *((FROM_ABOVE, size) for size in TOPS)],
)
def test_a_part_is_in_the_same_place_held_and_put_down_there(
    subject: Subject, size: tuple[int, int], style: ArmStyle
) -> None:
    for x in (6.0, 7.3, 8.6, 9.9):
        stands = reaching(x, 0.0, 0.5)
        place = stands.points.fingertip
        held, loose = (
            drawn(subject, style, with_part(stands, place, held=held), size)
            for held in (True, False)
        )
        # Fingers hide some of what stands between them and is not held.
        assert loose <= held
        # The palm is above it.
        assert held or (subject is FROM_ABOVE and style is not ArmStyle.OUTLINE)


@pytest.mark.parametrize("style", OF_CHARACTERS)
@pytest.mark.parametrize("size", [(48, 15), (66, 20)])
def test_a_part_lifted_to_an_inch_and_a_half_is_off_the_table(
    size: tuple[int, int], style: ArmStyle
) -> None:
    def lowest(height: float) -> int:
        stands = reaching(8.0, 0.0, height)
        readings = with_part(stands, stands.points.fingertip, held=True)
        return max(row for _, row in drawn(FROM_THE_SIDE, style, readings, size))

    assert lowest(1.5) < lowest(0.5)
