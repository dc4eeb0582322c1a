"""How far solids are apart: the distance itself, whatever their shapes and turns."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trs80arm.arm.contact.distance import boxes_apart, distance, distance_to
from trs80arm.arm.contact.manifold import Placed, between
from trs80arm.arm.contact.rotations import IDENTITY, matrix, oriented
from trs80arm.arm.contact.solids import Solid, box, cylinder
from trs80arm.arm.shapes import Vector, minus

ANGLE = st.floats(-180, 180)
PLACE = st.floats(-4, 4)
SHAPE = st.sampled_from([box((1.0, 2.0, 0.5)), box((0.2, 0.6, 1.7)), cylinder(0.7, 1.2)])
STILL = Placed(box((1.0, 1.0, 1.0)), (0.0, 0.0, 0.0), IDENTITY)


@pytest.mark.parametrize(
    ("at", "apart"),
    [
        ((3.0, 0.2, 0.1), 2.0),
        ((3.0, 3.0, 0.1), math.hypot(2, 2)),
        ((3.0, -3.0, 3.0), math.sqrt(12)),
        ((0.9, 0.0, 0.0), 0.0),
    ],
)
def test_cubes_are_apart_by_faces_edges_and_corners(at: Vector, apart: float) -> None:
    other = Placed(box((1.0, 1.0, 1.0)), at, IDENTITY)
    assert distance(STILL, other) == pytest.approx(apart, abs=1e-6)


def test_a_point_in_a_solid_is_no_way_from_it() -> None:
    assert distance_to(STILL, (0.1, 0.2, 0.3)) == 0
    assert distance_to(STILL, (0.1, 0.2, 1.5)) == pytest.approx(1.0, abs=1e-6)


@given(SHAPE, SHAPE, st.tuples(PLACE, PLACE, PLACE), st.tuples(ANGLE, ANGLE, ANGLE))
def test_distance_agrees_with_what_contact_finds(
    one: Solid, other: Solid, at: Vector, angles: Vector
) -> None:
    a = Placed(one, (0.0, 0.0, 0.0), IDENTITY)
    b = Placed(other, at, matrix(oriented(*angles)))
    apart = distance(a, b)
    assert apart == pytest.approx(distance(b, a), abs=3e-7)
    assert boxes_apart(a, b) <= apart + 3e-7
    met = between(a, b, 0.0)
    if apart > 1e-5:
        assert met is None
    elif met is not None:
        assert min(gap for _, gap in met.points) <= 1e-6


@given(SHAPE, st.tuples(PLACE, PLACE, PLACE), st.tuples(PLACE, PLACE, PLACE))
def test_what_moves_comes_no_nearer_than_it_moves(solid: Solid, at: Vector, to: Vector) -> None:
    before = distance(STILL, Placed(solid, at, IDENTITY))
    after = distance(STILL, Placed(solid, to, IDENTITY))
    assert abs(before - after) <= math.hypot(*minus(to, at)) + 3e-7
