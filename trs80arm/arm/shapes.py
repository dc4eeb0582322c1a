"""Boxes and line segments in space: the geometry of contact.

Everything on the bench is a box, and the arm meets it with the segments of its links and
fingers. `bench` and `contact` use these; nothing here knows what the boxes are. Inches, radians.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

Vector = tuple[float, float, float]

UP: Vector = (0.0, 0.0, 1.0)
SKIN = 1e-6
"""Boxes that share less than this much depth touch but do not overlap, inches."""


def dot(a: Vector, b: Vector) -> float:
    """Scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    """Vector product."""
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def plus(a: Vector, b: Vector, factor: float = 1.0) -> Vector:
    """`a` plus `factor` times `b`."""
    return (a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2])


def minus(a: Vector, b: Vector) -> Vector:
    """`a` less `b`."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


@dataclass(frozen=True)
class Box:
    """A box anywhere in space.

    Attributes:
        center: of the box, inches.
        axes: three unit vectors along its edges, right-handed.
        half: half its size along each axis, inches.
    """

    center: Vector
    axes: tuple[Vector, Vector, Vector]
    half: Vector

    @cached_property
    def radius(self) -> float:
        """Of the sphere around it, inches."""
        return math.sqrt(dot(self.half, self.half))

    @cached_property
    def rise(self) -> float:
        """From its centre to its highest corner, inches."""
        return sum(h * abs(axis[2]) for h, axis in zip(self.half, self.axes, strict=True))

    @cached_property
    def bottom(self) -> float:
        """Height of its lowest corner, inches."""
        return self.center[2] - self.rise

    @cached_property
    def top(self) -> float:
        """Height of its highest corner, inches."""
        return self.center[2] + self.rise

    def __getstate__(self) -> tuple[object, ...]:
        # What has been worked out along the way is no part of the box.
        return self.center, self.axes, self.half

    def __setstate__(self, state: tuple[object, ...]) -> None:
        for name, value in zip(("center", "axes", "half"), state, strict=True):
            object.__setattr__(self, name, value)

    def distance(self, place: Vector) -> float:
        """From a place to the nearest point of the box, inches; 0 inside."""
        away = minus(place, self.center)
        return math.sqrt(
            sum(
                max(abs(dot(away, axis)) - half, 0.0) ** 2
                for axis, half in zip(self.axes, self.half, strict=True)
            )
        )

    def gap(self, start: Vector, end: Vector) -> float:
        """How far a segment is from the box at least; negative where it may be inside."""
        a, b = minus(start, self.center), minus(end, self.center)
        gaps = []
        for axis, half in zip(self.axes, self.half, strict=True):
            p, q = dot(a, axis), dot(b, axis)
            gaps.append((p if p < q else q) - half if p + q > 0 else -(p if p > q else q) - half)
        return max(gaps)

    def distance_around(self, place: Vector) -> float:
        """The same if the box were turned about the z axis to wherever it is nearest; at least."""
        here = math.hypot(place[0], place[1])
        there = math.hypot(self.center[0], self.center[1])
        away = max(abs(here - there) - self.radius, 0.0)
        above = max(place[2] - self.top, self.bottom - place[2], 0.0)
        return math.sqrt(away * away + above * above)

    def moved(self, by: Vector) -> Box:
        """The same box elsewhere."""
        return Box(plus(self.center, by), self.axes, self.half)

    def corners(self) -> list[Vector]:
        """Its eight corners."""
        out = [self.center]
        for axis, half in zip(self.axes, self.half, strict=True):
            out = [plus(point, axis, sign * half) for point in out for sign in (-1.0, 1.0)]
        return out


def upright(x: float, y: float, bottom: float, size: Vector, turn: float) -> Box:
    """A box standing on its base.

    Args:
        x: of its centre, inches.
        y: of its centre, inches.
        bottom: height of its base, inches.
        size: along its own x, y and z, inches.
        turn: about the vertical, radians counter-clockwise.
    """
    c, s = math.cos(turn), math.sin(turn)
    half = (size[0] / 2, size[1] / 2, size[2] / 2)
    return Box((x, y, bottom + half[2]), ((c, s, 0.0), (-s, c, 0.0), UP), half)


def overlap(a: Box, b: Box, skin: float = SKIN) -> bool:
    """Whether two boxes share more than a touch."""
    return depth(a, b, skin) > skin


def depth(a: Box, b: Box, skin: float = 0.0) -> float:
    """How far one box would have to be moved to be clear of another, inches.

    Args:
        a: one box.
        b: the other.
        skin: a depth below which the caller does not care.

    Returns:
        The depth (separating axes), or some number that is no more than the skin.
    """
    d = minus(b.center, a.center)
    if abs(d[2]) >= a.rise + b.rise - skin:
        return skin
    reach = a.radius + b.radius - skin
    if reach <= 0 or dot(d, d) >= reach * reach:
        return skin
    axes = [*a.axes, *b.axes]
    if not (a.axes[2] == UP and b.axes[2] == UP):
        for one in a.axes:
            for other in b.axes:
                axis = cross(one, other)
                length = math.sqrt(dot(axis, axis))
                if length > 1e-6:
                    axes.append((axis[0] / length, axis[1] / length, axis[2] / length))
    least = math.inf
    for axis in axes:
        least = min(least, _span(a, axis) + _span(b, axis) - abs(dot(d, axis)))
        if least <= skin:
            return skin
    return least


def _span(box: Box, axis: Vector) -> float:
    """Half the shadow of a box on a line."""
    h, (u, v, w) = box.half, box.axes
    return h[0] * abs(dot(u, axis)) + h[1] * abs(dot(v, axis)) + h[2] * abs(dot(w, axis))


def interval(box: Box, start: Vector, end: Vector, skin: float = 0.0) -> tuple[float, float] | None:
    """The part of a segment inside a box.

    Args:
        box: the box.
        start: of the segment.
        end: of the segment.
        skin: depth by which the box is taken smaller on every side.

    Returns:
        From and to, as fractions of the segment between 0 and 1, or None if it misses.
    """
    low, high = 0.0, 1.0
    cx, cy, cz = box.center
    px, py, pz = start[0] - cx, start[1] - cy, start[2] - cz
    vx, vy, vz = end[0] - start[0], end[1] - start[1], end[2] - start[2]
    # The vertical first: most segments pass above most things.
    for i in (2, 0, 1):
        ax, ay, az = box.axes[i]
        half = box.half[i] - skin
        if half <= 0:
            return None
        p = px * ax + py * ay + pz * az
        v = vx * ax + vy * ay + vz * az
        if -1e-12 < v < 1e-12:
            if p >= half or p <= -half:
                return None
            continue
        if v > 0:
            t0, t1 = (-half - p) / v, (half - p) / v
        else:
            t0, t1 = (half - p) / v, (-half - p) / v
        if t0 > low:
            low = t0
        if t1 < high:
            high = t1
        if low >= high:
            return None
    return low, high


def footprint(box: Box) -> list[tuple[float, float]]:
    """Corners of an upright box's base, counter-clockwise."""
    (x, y, _), (u, v, _), (hx, hy, _) = box.center, box.axes, box.half
    return [
        (x + a * hx * u[0] + b * hy * v[0], y + a * hx * u[1] + b * hy * v[1])
        for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))
    ]


def common_ground(a: Box, b: Box) -> list[tuple[float, float]]:
    """Corners of the area that the bases of two upright boxes share; empty if none."""
    area = footprint(a)
    edge = footprint(b)
    for i in range(4):
        (x0, y0), (x1, y1) = edge[i], edge[(i + 1) % 4]
        inside = [(x1 - x0) * (y - y0) - (y1 - y0) * (x - x0) for x, y in area]
        kept: list[tuple[float, float]] = []
        for j, point in enumerate(area):
            k = (j + 1) % len(area)
            if inside[j] >= 0:
                kept.append(point)
            if inside[j] * inside[k] < 0:
                t = inside[j] / (inside[j] - inside[k])
                kept.append(
                    (
                        point[0] + t * (area[k][0] - point[0]),
                        point[1] + t * (area[k][1] - point[1]),
                    )
                )
        area = kept
        if not area:
            return []
    return area


def surrounds(points: list[tuple[float, float]], x: float, y: float) -> bool:
    """Whether (x, y) lies within the hull of points: some of them in every direction."""
    bearings = sorted(
        math.atan2(py - y, px - x) for px, py in points if abs(px - x) + abs(py - y) > 1e-9
    )
    if len(bearings) < len(points):
        return True
    if len(bearings) < 3:
        return False
    gaps = [b - a for a, b in pairwise(bearings)]
    gaps.append(bearings[0] + 2 * math.pi - bearings[-1])
    return max(gaps) < math.pi
