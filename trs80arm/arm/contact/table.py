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

    def surface(self, point: Vector) -> Vector:
        """Velocity of the table's surface at a point, inches a second."""
        x, y = point[0] - self.x, point[1] - self.y
        if x * x + y * y > self.radius * self.radius:
            return NOWHERE
        return (-self.spin * y, self.spin * x, 0.0)
