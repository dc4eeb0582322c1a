"""How far two convex solids are apart, by the algorithm of Gilbert, Johnson and Keerthi (1988).

The distance itself and not a bound from some axes: when a solid moves by so much, its distance from
anything changes by no more. That is what lets an arm go on for a while without being looked at.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from trs80arm.arm.contact.manifold import Placed
from trs80arm.arm.shapes import Vector, cross, dot, minus, plus

CLOSE_ENOUGH = 1e-7
"""Inches by which a distance may be too small."""
_MOST_ROUNDS = 40


def distance(a: Placed, b: Placed, enough: float = math.inf) -> float:
    """Inches between two solids; 0 where they touch or overlap.

    Args:
        a: the first.
        b: the second.
        enough: if they are farther apart than so many inches, it need not be known by how much.
    """
    return _least(a.vertices, b.vertices, enough)[0]


def separation(
    a: Sequence[Vector], b: Sequence[Vector], enough: float = math.inf
) -> tuple[float, Vector]:
    """How far two solids are apart, and along which way.

    Args:
        a: corners of the first.
        b: corners of the second.
        enough: if they are farther apart than so many inches, it need not be known by how much.

    Returns:
        Inches, 0 where they touch or overlap; and a vector of length 1 along which the first is
        beyond the second by so much (any vector where they are not apart).
    """
    return _least(a, b, enough)


def distance_to(solid: Placed, *points: Vector) -> float:
    """Inches from a point, or from all that lies between some, to a solid; 0 inside."""
    return _least(solid.vertices, points)[0]


def boxes_apart(a: Placed, b: Placed) -> float:
    """Inches between the upright boxes around two solids: at most as much as between them."""
    total = 0.0
    for low, high, other_low, other_high in zip(a.low, a.high, b.low, b.high, strict=True):
        gap = max(low - other_high, other_low - high)
        if gap > 0:
            total += gap * gap
    return math.sqrt(total)


def _least(
    ours: Sequence[Vector], theirs: Sequence[Vector], enough: float = math.inf
) -> tuple[float, Vector]:
    """Distance of the origin from all differences of two sets of corners and what is between.

    And the way along which they are that far from it.
    """
    nearest = minus(ours[0], theirs[0])
    simplex = [nearest]
    bound, way = 0.0, (0.0, 0.0, 1.0)
    for _ in range(_MOST_ROUNDS):
        length = math.sqrt(dot(nearest, nearest))
        if length <= CLOSE_ENOUGH:
            return 0.0, way
        corner = minus(_farthest(ours, nearest, -1.0), _farthest(theirs, nearest, 1.0))
        out = dot(nearest, corner) / length
        if out > bound:
            bound, way = out, (nearest[0] / length, nearest[1] / length, nearest[2] / length)
        if bound >= enough or length - bound <= CLOSE_ENOUGH or corner in simplex:
            break
        simplex.append(corner)
        nearest, simplex = _nearest(simplex)
        if len(simplex) == 4:
            return 0.0, way
    return bound, way


def _farthest(corners: Sequence[Vector], way: Vector, sign: float) -> Vector:
    x, y, z = way[0] * sign, way[1] * sign, way[2] * sign
    best, found = -math.inf, corners[0]
    for corner in corners:
        out = x * corner[0] + y * corner[1] + z * corner[2]
        if out > best:
            best, found = out, corner
    return found


def _nearest(simplex: list[Vector]) -> tuple[Vector, list[Vector]]:
    """The point of a simplex nearest to the origin, and the corners between which it lies."""
    if len(simplex) == 2:
        return _on_edge(simplex[0], simplex[1])
    if len(simplex) == 3:
        return _on_triangle(simplex[0], simplex[1], simplex[2])
    a, b, c, d = simplex
    best: tuple[Vector, list[Vector]] | None = None
    for p, q, r, other in ((a, b, c, d), (a, b, d, c), (a, c, d, b), (b, c, d, a)):
        normal = cross(minus(q, p), minus(r, p))
        inwards, outside = dot(normal, minus(other, p)), -dot(normal, p)
        if inwards * outside > 0:
            continue
        found = _on_triangle(p, q, r)
        if best is None or dot(found[0], found[0]) < dot(best[0], best[0]):
            best = found
    return ((0.0, 0.0, 0.0), simplex) if best is None else best


def _on_edge(a: Vector, b: Vector) -> tuple[Vector, list[Vector]]:
    along = minus(b, a)
    square = dot(along, along)
    t = -dot(a, along) / square if square > 0 else 0.0
    if t <= 0:
        return a, [a]
    if t >= 1:
        return b, [b]
    return plus(a, along, t), [a, b]


def _on_triangle(a: Vector, b: Vector, c: Vector) -> tuple[Vector, list[Vector]]:
    ab, ac = minus(b, a), minus(c, a)
    normal = cross(ab, ac)
    square = dot(normal, normal)
    if square > 0:
        # The origin's shadow on the triangle's plane, in parts of its corners.
        v = -dot(cross(a, ac), normal) / square
        w = dot(cross(a, ab), normal) / square
        if v > 0 and w > 0 and v + w < 1:
            return plus(plus(a, ab, v), ac, w), [a, b, c]
    edges = (_on_edge(a, b), _on_edge(a, c), _on_edge(b, c))
    return min(edges, key=lambda found: dot(found[0], found[0]))
