"""The rasteriser's geometry, where it can be known without it."""

from __future__ import annotations

from collections.abc import Callable
from math import inf, pi, radians

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from trs80arm.drawing import style_ascii
from trs80arm.drawing.camera import Camera
from trs80arm.drawing.cells import NO_INK, Cells, Looks, Samples
from trs80arm.drawing.raster import NOWHERE, Raster
from trs80arm.drawing.solids import Solids, box, cylinder, prism, rounded
from trs80arm.drawing.style_blocks import HALVES, SEXTANTS
from trs80arm.drawing.viewport import Window

WINDOW = Window(-4.0, 4.0, 4.0)
FROM_ABOVE = Camera((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))


def taken(solids: Solids, camera: Camera) -> Raster:
    """64 x 32 cells, 2 x 4 samples each: eight inches each way, sixteen samples an inch."""
    raster = Raster(64, 32, (2, 4), WINDOW)
    raster.draw(solids, camera.sees(solids))
    return raster


def area(raster: Raster) -> float:
    """Square inches of the picture that show something."""
    return float((raster.seen.face != NOWHERE).sum()) / 256


def test_a_box_covers_what_it_measures() -> None:
    assert area(taken(box((-1, -2, 0), (2, 2, 1)), FROM_ABOVE)) == pytest.approx(12.0)


def test_a_round_thing_from_its_end_is_a_disc() -> None:
    disc = cylinder((0.5, 0.5), 2.0, 0.0, 1.0, sides=48)
    assert area(taken(disc, FROM_ABOVE)) == pytest.approx(pi * 4, rel=0.02)


def test_what_is_nearer_hides_what_is_behind() -> None:
    low, high = box((-2, -2, 0), (2, 2, 1)), box((-1, -1, 2), (1, 1, 3))
    for order in ((low, high), (high, low)):
        solids = Solids.joined(order)
        raster = taken(solids, FROM_ABOVE)
        middle = raster.seen.face[64, 64]
        assert solids.normals[middle][2] == pytest.approx(1.0)
        assert solids.offsets[middle] == pytest.approx(3.0)


def test_a_far_thing_is_smaller_in_perspective_and_not_without() -> None:
    square = box((-1, -1, -10.0), (1, 1, -9.9))
    eye = Camera((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), distance=10.0)
    assert area(taken(square, FROM_ABOVE)) == pytest.approx(4.0)
    assert area(taken(square, eye)) == pytest.approx(4.0 * (10 / 19.9) ** 2, rel=0.1)


def test_a_point_is_drawn_where_the_camera_says_it_is() -> None:
    for distance in (inf, 30.0):
        camera = Camera.around((1.0, 0.5, 0.0), radians(-50), radians(30), distance)
        place = np.array([[2.0, 1.0, 0.5]])
        x, y, _ = camera.points(place)[0]
        speck = box(place[0] - 0.06, place[0] + 0.06)
        rows, columns = np.nonzero(taken(speck, camera).seen.face != NOWHERE)
        assert abs(-4.0 + (columns.mean() + 0.5) / 16 - x) < 0.06
        assert abs(4.0 - (rows.mean() + 0.5) / 16 - y) < 0.06


def test_the_shadow_of_a_thing_lies_away_from_the_sun_by_its_height() -> None:
    raster = Raster(64, 32, (2, 4), WINDOW)
    plate = box((-1, -1, 1.9), (1, 1, 2.0))
    sun = (-0.6, 0.0, 0.8)
    covered = raster.covered(plate, FROM_ABOVE.shades(plate, sun), np.ones(6, dtype=bool))
    _, columns = np.nonzero(covered)
    assert -4.0 + (columns.mean() + 0.5) / 16 == pytest.approx(1.95 * 0.6 / 0.8, abs=0.1)


def test_a_tilted_eye_sees_the_shadow_where_a_thing_lying_there_is_seen() -> None:
    for distance in (inf, 25.0):
        camera = Camera.around((0.0, 0.0, 0.0), radians(-70), radians(35), distance)
        raster = Raster(64, 32, (2, 4), WINDOW)
        plate = box((-1, -1, 1.95), (1, 1, 2.0))
        covered = raster.covered(
            plate, camera.shades(plate, (-0.6, 0.0, 0.8)), np.ones(6, dtype=bool)
        )
        lying = box((0.46, -1, -0.01), (2.5, 1, 0.0))
        shown = taken(lying, camera).seen.face != NOWHERE
        assert (covered ^ shown).sum() < 0.08 * shown.sum()


@settings(max_examples=40, deadline=None)
@given(st.floats(-pi, pi), st.floats(0.0, 1.5), st.sampled_from([inf, 20.0, 48.0]))
def test_a_turned_prism_shows_no_holes(turn: float, tilt: float, distance: float) -> None:
    link = prism(rounded((-0.5, -1.5), (0.5, 1.5), 0.3), -1.0, 1.0, along=1, bevel=(0.2, 0.1))
    shown = taken(link, Camera.around((0.0, 0.0, 0.0), turn, tilt, distance)).seen.face != NOWHERE
    for row in shown[shown.any(1)]:
        columns = np.flatnonzero(row)
        assert len(columns) == columns[-1] - columns[0] + 1


@pytest.mark.parametrize("draw", [style_ascii.draw, HALVES.draw, SEXTANTS.draw])
@pytest.mark.parametrize("upper", [True, False])
def test_a_cell_that_a_thing_half_covers_shows_nothing_behind_it(
    draw: Callable[[Samples], Cells], upper: bool
) -> None:
    grain = {style_ascii.draw: (2, 4), HALVES.draw: (1, 2), SEXTANTS.draw: (2, 3)}[draw]
    raster = Raster(1, 1, grain, Window(0.0, 1.0, 1.0))
    low, high = (0.5, 2.0) if upper else (-1.0, 0.5)
    block = box((-1.0, low, -6.0), (2.0, high, -5.0))
    raster.draw(block, FROM_ABOVE.sees(block))
    seen = raster.gathered_seen
    looks = Looks(
        np.array([4] * 6 + [NO_INK], dtype=np.int8),
        np.array([0.7] * 6 + [0.0], dtype=np.float32),
        np.array([3] * 6 + [-1], dtype=np.int16),
    )
    cell = Samples(seen.face, seen, looks)
    drawn = draw(cell)
    assert drawn.ink.tolist() == [[4]]
    assert drawn.under.tolist() == [[NO_INK]]


def test_of_faces_as_near_as_each_other_the_first_is_seen() -> None:
    raster = Raster(64, 32, (2, 4), WINDOW)
    cube = box((-1, -1, 0), (1, 1, 2))
    for _ in range(2):
        raster.draw(cube, FROM_ABOVE.sees(cube))
    assert raster.seen.face.max() < 6


def test_what_is_sent_back_hides_nothing_that_is_drawn_later() -> None:
    raster = Raster(64, 32, (2, 4), WINDOW)
    high, low = box((-1, -1, 5), (1, 1, 6)), box((-1, -1, 0), (1, 1, 1))
    raster.draw(high, FROM_ABOVE.sees(high))
    raster.send_back(-1000.0)
    raster.draw(low, FROM_ABOVE.sees(low))
    assert raster.seen.face.max() >= 6
    assert raster.seen.nearness[64, 64] == 1.0
    assert raster.seen.nearness[0, 0] == -inf


@given(turn=st.floats(0, 2 * pi), tilt=st.floats(-pi, pi))
@settings(deadline=None, max_examples=25)
def test_a_thickened_box_is_thicker_by_as_much_however_it_is_turned(
    turn: float, tilt: float
) -> None:
    c, s, d, h = np.cos(turn), np.sin(turn), np.cos(tilt), np.sin(tilt)
    axes = np.array([[c, s, 0.0], [-s * d, c * d, h], [s * h, -c * h, d]])
    thicker = box((-1, -1, -1), (1, 1, 1), body=3).placed((0, 0, 0), axes).thickened([3], 0.5)
    assert np.allclose(np.abs(thicker.corners @ axes.T), 1.5)
    assert np.allclose(thicker.offsets, 1.5)


@given(turn=st.integers(0, 7), high=st.integers(-12, 12))
@settings(deadline=None, max_examples=25)
def test_edges_on_the_samples_leave_no_face_out(turn: int, high: int) -> None:
    angle = turn * pi / 4
    axes = [[np.cos(angle), np.sin(angle), 0.0], [-np.sin(angle), np.cos(angle), 0.0], [0, 0, 1]]
    disc = cylinder((0.0, 0.0), 1.03125, 0.0, 1.0, sides=24)
    many = Solids.joined([disc.placed((place / 4, high / 32, 0.0), axes) for place in range(-4, 5)])
    assert area(taken(many, FROM_ABOVE)) == pytest.approx(2 * 2 * 1.03125 + 3.3, abs=0.2)
