"""Vectors, and boxes in space: where fixtures stand, and what is drawn around parts.

Nothing here knows what the boxes are. Inches, radians.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

Vector = tuple[float, float, float]

UP: Vector = (0.0, 0.0, 1.0)
SKIN = 1e-6
"""Things that share less than this much depth touch but do not overlap, inches."""


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


def length(x: float, y: float, z: float = 0.0) -> float:
    """Of a vector; a rounded square root of sums, the same on every platform."""
    return math.sqrt(x * x + y * y + z * z)


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

    def point(self, along: float, across: float, up: float) -> Vector:
        """A point so many inches from its middle along its three axes."""
        out = self.center
        for axis, by in zip(self.axes, (along, across, up), strict=True):
            out = plus(out, axis, by)
        return out

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
