"""The table: level, endless, at height 0, perhaps with turning plates let into it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from trs80arm.arm.contact.bodies import NOWHERE
from trs80arm.arm.shapes import Vector

TABLE = "\x01the table"
"""No name that anybody can give begins with an unprintable character."""


@dataclass(slots=True)
class Plate:
    """A round plate let into the table, that turns; no two overlap.

    Attributes:
        x: of its axis.
        y: of its axis.
        radius: inches.
        spin: radians a second, counter-clockwise from above.
    """

    x: float
    y: float
    radius: float
    spin: float = 0.0

    def covers(self, point: Vector) -> bool:
        """Whether a point of the table is on it."""
        x, y = point[0] - self.x, point[1] - self.y
        return x * x + y * y <= self.radius * self.radius


def surface(plates: Iterable[Plate], point: Vector, seconds: float) -> Vector:
    """Velocity at which the table's surface carries a point in a step, inches a second.

    Args:
        plates: those that turn.
        point: of the table.
        seconds: length of the step.
    """
    for plate in plates:
        if plate.covers(point):
            return carried(point[0] - plate.x, point[1] - plate.y, plate.spin, seconds)
    return NOWHERE


def carried(x: float, y: float, spin: float, seconds: float) -> Vector:
    """Velocity at which a surface that turns carries a point in a step: along the arc's chord.

    With the velocity at the beginning everything would drift outwards.

    Args:
        x: from its axis, inches.
        y: likewise.
        spin: radians a second, counter-clockwise from above.
        seconds: length of the step.
    """
    half = spin * seconds / 2
    rate = spin / (1 + half * half)
    return -rate * (y + half * x), rate * (x - half * y), 0.0
