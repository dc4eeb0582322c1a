"""Parts are drawn in their true outline and tilt, and between the fingers that hold them."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from trs80arm.arm import benchfile
from trs80arm.arm.geometry import JointAngles
from trs80arm.arm.models.minimover5 import MINIMOVER5
from trs80arm.arm.shapes import Box, upright
from trs80arm.drawing.bench_solids import solids_of
from trs80arm.drawing.canvas_ascii import AsciiCanvas
from trs80arm.drawing.readings import Kind, Posture, Readings, Thing, things_of
from trs80arm.drawing.rows import Ink, text_of
from trs80arm.drawing.scene import Block, Facet, Scene, Stroke, outline
from trs80arm.drawing.side_scene import side_scene
from trs80arm.drawing.top_scene import top_scene
from trs80arm.drawing.viewport import Window, draw


def tilted(degrees: float) -> Box:
    """A 4 by 1 by 0.5 plank at (8, 0), 2 in up, its far end down."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return Box((8.0, 0.0, 2.0), ((c, 0.0, -s), (0.0, 1.0, 0.0), (s, 0.0, c)), (2.0, 0.5, 0.25))


def drawn(scene: Scene) -> list[Block | Facet]:
    """What of a scene is a part."""
    return [
        shape
        for shape in scene.shapes
        if isinstance(shape, Block | Facet) and shape.ink is Ink.PART
    ]


def test_a_leaning_plank_is_seen_leaning_from_the_side() -> None:
    (plank,) = drawn(side_scene(Readings(things=(Thing(Kind.PART, "plank", tilted(28)),))))
    assert isinstance(plank, Facet)
    assert len(plank.corners) == 4
    (low_x, low_y), (high_x, high_y) = min(plank.corners), max(plank.corners)
    assert math.degrees(math.atan2(low_y - high_y, high_x - low_x)) > 15


def test_what_leans_beside_the_arms_plane_is_seen_leaning_too() -> None:
    readings = Readings(
        things=(Thing(Kind.PART, "plank", replace(tilted(28), center=(8.0, 5.0, 2.0))),)
    )
    (plank,) = (shape for shape in side_scene(readings).shapes if isinstance(shape, Facet))
    (inside,) = drawn(side_scene(Readings(things=(Thing(Kind.PART, "plank", tilted(28)),))))
    assert plank == replace(inside, ink=Ink.FAINT, fill=":")


def test_a_ramp_is_seen_sloping_from_the_side_and_a_pillar_round_from_above() -> None:
    bench = benchfile.parse(
        "[[obstacle]]\nname = 'ramp'\nat = [9, 0]\nsize = [4, 2, 0.4]\ntilt = 20\n"
        "[[obstacle]]\nname = 'pillar'\nshape = 'cylinder'\nat = [8, 6]\ndiameter = 2\nheight = 3"
    )
    readings = Readings(things=tuple(things_of(bench)))
    (ramp,) = (shape for shape in side_scene(readings).shapes if isinstance(shape, Facet))
    (x, y), (far_x, far_y) = max(ramp.corners, key=lambda corner: corner[1]), max(ramp.corners)
    assert math.degrees(math.atan2(y - far_y, far_x - x)) == pytest.approx(20)
    (pillar,) = (shape for shape in top_scene(readings).shapes if isinstance(shape, Facet))
    assert len(pillar.corners) == 24


def test_a_turned_part_is_seen_turned_from_above() -> None:
    box = upright(8.0, 0.0, 0.0, (4.0, 0.5, 0.5), math.radians(30))
    (bar,) = drawn(top_scene(Readings(things=(Thing(Kind.PART, "bar", box),))))
    assert isinstance(bar, Facet)
    assert len(bar.corners) == 4


def test_a_can_is_round_from_above_and_square_from_the_side() -> None:
    bench = benchfile.parse(
        "[[part]]\nname = 'can'\nshape = 'cylinder'\nat = [8, 0]\ndiameter = 2\nheight = 1"
    )
    readings = Readings(things=tuple(things_of(bench)))
    (round_one,) = drawn(top_scene(readings))
    assert isinstance(round_one, Facet)
    assert len(round_one.corners) == 24
    (beside,) = drawn(side_scene(readings))
    assert isinstance(beside, Block)
    (thing,) = readings.things
    assert len(solids_of(thing, 10).corners) == 48


def test_a_tray_is_drawn_with_its_walls() -> None:
    bench = benchfile.parse(
        "[[part]]\nname = 'tray'\nshape = 'tray'\nat = [8, 0]\nsize = [3, 2, 1]\nwall = 0.1"
    )
    (thing,) = things_of(bench)
    assert len(thing.solids) == 5
    assert len(solids_of(thing, 10).corners) == 5 * 8


def test_an_upright_part_is_an_upright_box() -> None:
    box = upright(8.0, 0.0, 0.0, (1.0, 1.0, 2.0), 0.0)
    readings = Readings(things=(Thing(Kind.PART, "block", box),))
    assert all(isinstance(part, Block) for part in drawn(side_scene(readings)))
    assert all(isinstance(part, Block) for part in drawn(top_scene(readings)))


def test_the_fingers_are_outside_of_what_they_hold() -> None:
    # Two inches across y, half an inch along x: held over its two inches.
    angles = JointAngles(0.0, 0.4, -1.35, -math.pi / 2, 0.0)
    posture = Posture(MINIMOVER5, angles, 2.0)
    x, y, z = posture.points.fingertip
    box = upright(x, y, z - 0.5, (0.5, 2.0, 1.0), 0.0)
    things = (Thing(Kind.PART, "bar", box, held=True),)
    scene = side_scene(replace(Readings(things=things), posture=posture))
    (part,) = drawn(scene)
    assert isinstance(part, Block)
    fingers = [
        shape.end[0]
        for shape in scene.shapes
        if isinstance(shape, Stroke) and shape.ink is Ink.HAND and abs(shape.end[1] - z) < 0.01
    ]
    left, right = sorted((part.corner[0], part.opposite[0]))
    assert min(fingers) <= left + 1e-6
    assert max(fingers) >= right - 1e-6


@pytest.mark.parametrize("opening", [0.3, 1.5, 2.0, 3.0])
def test_a_finger_goes_through_nothing_that_reaches_up_to_the_palm(opening: float) -> None:
    angles = JointAngles(0.0, 0.4, -1.35, -math.pi / 2, 0.0)
    down = Posture(MINIMOVER5, angles, opening)
    ahead = Posture(MINIMOVER5, replace(angles, pitch=0.0), opening)
    for scene, which, level, middle in (
        (side_scene(Readings(posture=down)), slice(2, None), 0, down.points.fingertip[0]),
        (top_scene(Readings(posture=ahead)), slice(1, None, 2), 1, 0.0),
    ):
        strokes = [each for each in scene.shapes if isinstance(each, Stroke)]
        fingers = [each for each in strokes if each.ink is Ink.HAND][which]
        assert len(fingers) == 2
        for finger in fingers:
            assert abs(finger.end[level] - middle) == pytest.approx(opening / 2)
            assert abs(finger.start[level] - middle) >= opening / 2 - 1e-9


def test_the_outline_of_a_box_from_aside_has_six_corners() -> None:
    box = Box((0.0, 0.0, 0.0), tilted(28).axes, (1.0, 1.0, 1.0))
    c, s = math.cos(0.5), math.sin(0.5)
    assert len(outline((x * c + y * s, z) for x, y, z in box.corners())) == 6


def test_a_leaning_part_on_the_sheet() -> None:
    canvas = AsciiCanvas(32, 9)
    plank = Facet(((1.0, 1.0), (6.5, 3.4), (6.0, 4.2), (0.6, 1.9)), Ink.PART, "#")
    draw(Scene((plank,), (0.0, 0.0, 8.0, 5.0), (4.0, 2.0)), Window(0.0, 5.0, 1.8), canvas)
    assert [text_of(row).rstrip() for row in canvas.rows()] == [
        "",
        "                   _.-",
        "              _..-'###\\_",
        "          _.-'####_..-'",
        "     _.-''####_.-'",
        "  \\-'####_.--'",
        "  \\##_.-'",
        "   \\'",
        "",
    ]
