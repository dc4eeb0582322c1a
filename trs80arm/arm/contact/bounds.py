"""Bounds: how far or fast something can be at most, for what need not be looked at closely."""

from __future__ import annotations

import math
from collections.abc import Sequence

from trs80arm.arm.contact.bodies import Body
from trs80arm.arm.contact.manifold import Manifold, Placed, between
from trs80arm.arm.shapes import Vector, dot, minus

NEARBY = 0.5
"""Inches from all that is concerned in a tick to all that is not, at least."""


def greatest_speed(speed: Sequence[float], radius: float) -> float:
    """A bound on the speed of any point of a body, inches a second.

    Args:
        speed: velocity and spin.
        radius: of the sphere around it.
    """
    a, b, c, d, e, f = speed
    return math.sqrt(a * a + b * b + c * c) + radius * math.sqrt(d * d + e * e + f * f)


def spheres_within(body: Body, other: Body, margin: float) -> bool:
    """Whether the spheres around two bodies are within a margin of each other."""
    d = minus(body.place, other.place)
    reach = body.shape.radius + other.shape.radius + margin
    return dot(d, d) <= reach * reach


def met(first: Placed, second: Placed, margin: float) -> Manifold | None:
    """How two solids touch, if they are near."""
    return between(first, second, margin) if first.near(second, margin) else None


def overlap(first: Placed, second: Placed) -> float:
    """How deep two solids are in each other, inches; 0 if they are not."""
    found = met(first, second, 0.0)
    return 0.0 if found is None else max(0.0, -min(gap for _, gap in found.points))


def box_around(solids: Sequence[Placed], margin: float) -> tuple[Vector, Vector]:
    """The upright box around some solids, wider by a margin: least and greatest x, y, z."""
    xs, ys, zs = zip(*(solid.low for solid in solids), strict=True)
    us, vs, ws = zip(*(solid.high for solid in solids), strict=True)
    low = (min(xs) - margin, min(ys) - margin, min(zs) - margin)
    return low, (max(us) + margin, max(vs) + margin, max(ws) + margin)


def spheres_around(solids: Sequence[Placed], margins: Sequence[float]) -> tuple[Vector, Vector]:
    """An upright box around spheres about some solids, each wider by a margin of its own.

    Wider than `box_around`, and found without asking where any corner is.
    """
    a = b = c = math.inf
    d = e = f = -math.inf
    for solid, margin in zip(solids, margins, strict=True):
        x, y, z = solid.middle
        r = solid.solid.radius + margin
        a = x - r if x - r < a else a
        b = y - r if y - r < b else b
        c = z - r if z - r < c else c
        d = x + r if x + r > d else d
        e = y + r if y + r > e else e
        f = z + r if z + r > f else f
    return (a, b, c), (d, e, f)


def outside(body: Body, around: tuple[Vector, Vector]) -> bool:
    """Whether the sphere around a body is outside an upright box."""
    (a, b, c), (d, e, f) = around
    x, y, z = body.place
    r = body.shape.radius
    return x + r < a or x - r > d or y + r < b or y - r > e or z + r < c or z - r > f


def within(mine: Placed, solid: Placed | None, margin: float) -> bool:
    """Whether a solid is within a margin of another, or of the table."""
    if solid is None:
        return mine.middle[2] <= mine.radius + margin and mine.low[2] <= margin
    return mine.near(solid, margin) and _gap(mine, solid, margin) <= margin


def _gap(a: Placed, b: Placed, margin: float) -> float:
    """Least gap of two solids, inches; more than the margin if they are farther apart."""
    found = between(a, b, margin)
    return math.inf if found is None else min(gap for _, gap in found.points)
