"""Convex solids: volume, centre of mass, moments, and where two of them touch."""

from __future__ import annotations

import math

import pytest

from trs80arm.arm.contact.bodies import Shape
from trs80arm.arm.contact.forms import holed, peg_board, standing, tray
from trs80arm.arm.contact.manifold import Placed, between, on_table
from trs80arm.arm.contact.rotations import IDENTITY, STRAIGHT, about, apply, matrix, oriented
from trs80arm.arm.contact.solids import box, cylinder, moments, prism
from trs80arm.arm.shapes import Vector, dot

ORIGIN: Vector = (0.0, 0.0, 0.0)


def test_a_box_has_a_boxs_moments() -> None:
    found = moments([box((1.0, 2.0, 3.0))])
    assert found.volume == pytest.approx(6)
    assert found.inertia[0] == pytest.approx(6 * (4 + 9) / 12)
    assert found.inertia[8] == pytest.approx(6 * (1 + 4) / 12)
    assert found.inertia[1] == pytest.approx(0)


def test_a_cylinder_has_as_much_in_it_as_a_round_one() -> None:
    found = moments([cylinder(0.5, 2.0)])
    assert found.volume == pytest.approx(math.pi / 2)
    assert found.inertia[8] == pytest.approx(math.pi / 2 * 0.125, rel=0.001)


def test_moments_of_two_solids_are_about_the_middle_of_both() -> None:
    halves = [box((1.0, 1.0, 1.0)).moved((x, 0.0, 0.0)) for x in (2.5, 3.5)]
    both, whole = moments(halves), moments([box((2.0, 1.0, 1.0))])
    assert both.middle == pytest.approx((3, 0, 0))
    assert both.inertia == pytest.approx(whole.inertia)


def test_an_outline_that_is_not_convex_is_no_prism() -> None:
    with pytest.raises(ValueError, match="convex"):
        prism([(0, 0), (2, 0), (1, 0.5), (0, 2)], 1.0)
    with pytest.raises(ValueError, match="counter-clockwise"):
        prism([(0, 0), (0, 1), (1, 1), (1, 0)], 1.0)


@pytest.mark.parametrize("degrees", [0, 17, 90, 133.7, -45, 360, 7200, -1000])
def test_turning_agrees_with_the_librarys_sine(degrees: float) -> None:
    x, y, _ = apply(matrix(about((0.0, 0.0, 1.0), degrees)), (1.0, 0.0, 0.0))
    assert (x, y) == pytest.approx(
        (math.cos(math.radians(degrees)), math.sin(math.radians(degrees))), abs=1e-13
    )


def test_a_box_on_a_box_touches_at_four_corners() -> None:
    low = Placed(box((2.0, 2.0, 1.0)), ORIGIN, IDENTITY)
    high = Placed(box((1.0, 1.0, 1.0)), (0.2, 0.0, 1.001), IDENTITY)
    met = between(low, high, 0.01)
    assert met is not None
    assert met.normal == pytest.approx((0, 0, 1))
    assert len(met.points) == 4
    assert all(gap == pytest.approx(0.001) for _, gap in met.points)


def test_crossed_edges_touch_at_one_point() -> None:
    roof = Placed(box((4.0, 1.0, 1.0)), ORIGIN, matrix(oriented(0, 0, 45)))
    ridge = Placed(box((1.0, 4.0, 1.0)), (0.3, 0.0, math.sqrt(2)), matrix(oriented(0, 45, 0)))
    met = between(roof, ridge, 0.01)
    assert met is not None
    ((point, gap),) = met.points
    assert point == pytest.approx((0.3, 0, math.sqrt(0.5)))
    assert gap == pytest.approx(0, abs=1e-9)


def test_what_is_farther_apart_than_the_margin_does_not_touch() -> None:
    one = Placed(box((1.0, 1.0, 1.0)), ORIGIN, IDENTITY)
    other = Placed(box((1.0, 1.0, 1.0)), (1.2, 1.2, 0.0), matrix(oriented(45)))
    assert between(one, other, 0.05) is None


def test_two_lying_cylinders_touch_along_a_line() -> None:
    turn = matrix(oriented(90, 90))
    one = Placed(cylinder(0.5, 2.0), (0.0, 0.0, 0.5), turn)
    other = Placed(cylinder(0.5, 2.0), (1.0, 0.0, 0.5), turn)
    met = between(one, other, 0.02)
    assert met is not None
    assert abs(met.normal[0]) == pytest.approx(1, abs=0.02)
    assert {round(abs(point[1]), 6) for point, _ in met.points} == {1.0}


def test_a_standing_disc_touches_the_table_all_round() -> None:
    met = on_table(Placed(cylinder(1.0, 0.2), (3.0, 4.0, 0.1), IDENTITY), 0.01)
    assert met is not None
    bearings = {
        math.floor(math.atan2(y - 4, x - 3) / math.pi * 4 + 4.01) for (x, y, _), _ in met.points
    }
    assert len(bearings) == 8


@pytest.mark.parametrize("tilt", [90.0, 89.0, 85.0])
def test_a_lying_cylinder_may_touch_at_both_ends_however_it_is_tilted(tilt: float) -> None:
    lying = Placed(cylinder(0.7, 1.4), (0.0, 0.0, 0.65), matrix(oriented(30.0, tilt, 0.0)))
    met = on_table(lying, 0.5)
    assert met is not None
    along = [x * math.sqrt(0.75) + y / 2 for (x, y, _), _ in met.points]
    assert min(along) < -0.6
    assert max(along) > 0.6
    deepest = [min(gap for (x, _, _), gap in met.points if x * side > 0) for side in (1, -1)]
    lowest = [min(z for x, _, z in lying.vertices if x * side > 0) for side in (1, -1)]
    assert deepest == lowest


def test_a_tray_a_holed_block_and_a_peg_board_have_the_volume_that_is_left() -> None:
    assert moments(tray((2.0, 3.0, 1.0), 0.25)).volume == pytest.approx(6 - 1.5 * 2.5 * 0.75)
    assert moments(holed((2.0, 3.0, 1.0), (0.5, 1.0))).volume == pytest.approx(5.5)
    pegs = peg_board((2.0, 2.0, 0.5), [(0.5, 0.5), (-0.5, 0)], 0.2, 1.0)
    assert moments(pegs).volume == pytest.approx(2 + 2 * math.pi * 0.04)


def test_a_body_is_stood_by_its_lowest_point_and_its_middle() -> None:
    shape = Shape.of(tray((2.0, 2.0, 1.0), 0.25), 3.0)
    place, turn = standing(shape, 8.0, 1.0, 0.5, STRAIGHT)
    low = min(place[2] + v[2] for solid in shape.solids for v in solid.vertices)
    assert low == pytest.approx(0.5)
    assert place[:2] == pytest.approx((8, 1))
    assert turn == STRAIGHT


def test_where_faces_all_but_lie_on_each_other_their_edges_say_which_way_they_press() -> None:
    wall = Placed(box((1.0, 4.0, 4.0)), ORIGIN, IDENTITY)
    board = Placed(box((0.2, 3.0, 3.0)), (0.95, 1.8, 2.9), matrix(oriented(10.0, 10.0, 0.0)))
    met = between(wall, board, 0.1)
    assert met is not None
    assert 0.98 < met.normal[0] < 0.99
    assert len(met.points) > 1
    beyond = [min(dot(met.normal, v) for v in board.vertices)]
    beyond += [-max(dot(met.normal, v) for v in wall.vertices)]
    assert met.apart == pytest.approx(sum(beyond))
    assert min(gap for _, gap in met.points) == met.apart
