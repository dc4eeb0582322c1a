"""What touches what: things that move, the sides of a contact, its points and its normal."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from trs80arm.arm.contact.rotations import IDENTITY, Matrix, apply_back
from trs80arm.arm.contact.sixes import Six
from trs80arm.arm.shapes import Vector, cross, minus, plus

Key = tuple[str, str, int]
"""Of a contact: the two things' names, and which of their solids."""
SOLIDS = 64
"""The first thing's solid's number is multiplied by this in a key, and the second's added."""


@dataclass(slots=True)
class Mobile:
    """What the solver knows of something that moves.

    Attributes:
        speed: six velocities, in the end those found: of a body, velocity and spin; of the arm, the
            rates of its coordinates.
        place: of a body's centre of mass; unused for the arm.
        turn: of a body's frame; unused for the arm.
        mass: of a body.
        inertia: of a body, in the world's frame.
        inertias: of each of the arm's coordinates; None for a body.
        before: velocities from which to begin looking; those of `speed` unless given.
    """

    speed: list[float]
    place: Vector
    mass: float = 0.0
    inertia: Matrix | None = None
    inertias: Six | None = None
    before: tuple[float, ...] | None = None
    turn: Matrix = IDENTITY

    def within(self, point: Vector) -> Vector:
        """Where a point is in the frame of a body; of the arm, in the world's."""
        return apply_back(self.turn, minus(point, self.place))


class Side(NamedTuple):
    """One side of a contact: what is touched there, and how it moves.

    Attributes:
        mobile: what moves, or None for what stands fast.
        screws: of the arm's link.
    """

    mobile: Mobile | None
    screws: tuple[tuple[Vector, Vector], ...] | None = None

    @property
    def motion(self) -> Motion | None:
        """How it moves now; None for what stands fast."""
        mobile = self.mobile
        if mobile is None:
            return None
        if self.screws is not None:
            spin, velocity = total(self.screws, mobile.speed)
            return Motion(velocity, spin, (0.0, 0.0, 0.0))
        u, v, w, p, q, r = mobile.speed
        return Motion((u, v, w), (p, q, r), mobile.place)


class Motion(NamedTuple):
    """Velocity of one of a thing's points, the thing's spin in radians a second, and the point."""

    velocity: Vector
    spin: Vector
    about: Vector

    def at(self, point: Vector) -> Vector:
        """Velocity at another point."""
        return plus(self.velocity, cross(self.spin, minus(point, self.about)))


def total(screws: Sequence[tuple[Vector, Vector]], rates: Sequence[float]) -> tuple[Vector, Vector]:
    """Spin of a link, and velocity at the world's origin."""
    p = q = r = u = v = w = 0.0
    for ((a, b, c), (d, e, f)), rate in zip(screws, rates, strict=True):
        if rate:
            p, q, r = p + rate * a, q + rate * b, r + rate * c
            u, v, w = u + rate * d, v + rate * e, w + rate * f
    return (p, q, r), (u, v, w)


@dataclass(slots=True)
class Contact:
    """Where two things touch, or are about to: an area, an edge or a point, with one normal.

    Attributes:
        key: the two things' names, and which of their solids; for finding it again.
        points: of contact, in the world, and the gap at each: inches, negative for an overlap.
        normal: from the first side into the second.
        first: side that the normal leaves.
        second: side that it enters; it moves.
        friction: coefficient.
        surface: velocity of the first side there, if it stands fast but its surface moves.
        pressures: impulse along the normal at each: as it was a tick before, then as found.
        pressure: the whole of all points, as found; 0 before.
        apart: inches by which the two are apart along the normal, whole solids and not points.
    """

    key: Key
    points: list[tuple[Vector, float]]
    normal: Vector
    first: Side
    second: Side
    friction: float
    surface: Vector | None = None
    pressures: list[float] = field(default_factory=list)
    pressure: float = 0.0
    apart: float = -math.inf

    def press(self, pressures: list[float]) -> None:
        """Take note of what was found to press at each point."""
        total = 0.0
        for pressure in pressures:
            total += pressure
        self.pressures, self.pressure = pressures, total

    @property
    def gap(self) -> float:
        """The least of all points."""
        return min([gap for _, gap in self.points])
