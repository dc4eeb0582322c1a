"""The table: level, endless, at height 0, perhaps with a turning plate let into it."""

from __future__ import annotations

from dataclasses import dataclass

from trs80arm.arm.contact.bodies import NOWHERE
from trs80arm.arm.shapes import Vector

TABLE = "\x01the table"
"""No name that anybody can give begins with an unprintable character."""


@dataclass(slots=True)
class Plate:
    """A round plate let into the table, that turns.

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

    def surface(self, point: Vector, seconds: float) -> Vector:
        """Velocity at which the table's surface carries a point in a step, inches a second."""
        x, y = point[0] - self.x, point[1] - self.y
        if x * x + y * y > self.radius * self.radius:
            return NOWHERE
        return carried(x, y, self.spin, seconds)


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
