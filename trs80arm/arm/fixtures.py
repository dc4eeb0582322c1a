"""What can stand on the bench besides the table: parts, feeders, trays, obstacles, turntable.

Plain values and small counters; `bench` gives them their physics and `benchfile` reads them
from a file. Inches, ounces; turns in radians counter-clockwise from above.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, fields
from functools import cached_property
from typing import Any

from trs80arm.arm.contact.bodies import NOWHERE, Body, Shape
from trs80arm.arm.contact.manifold import Placed
from trs80arm.arm.contact.rotations import IDENTITY, about, apply, matrix, quaternion
from trs80arm.arm.contact.solids import Solid, box
from trs80arm.arm.shapes import SKIN, Box, Vector, plus, upright

ON_THE_TABLE = 0.02
"""Height of its lowest corner up to which something stands on the table, inches."""


Polyhedron = tuple[tuple[Vector, ...], tuple[tuple[int, ...], ...]]
"""Corners in inches, and faces as indices of them, counter-clockwise as seen from outside."""


@dataclass(slots=True)
class Part(Body):
    """A body that can be picked up.

    Attributes:
        held: whether the fingers have it in their grip.
        began: its place and its own vertical where it last was at rest, or was let go; None while
            it has never been.
    """

    held: bool = False
    began: tuple[Vector, Vector] | None = None

    @property
    def weight(self) -> float:
        """Ounces."""
        return self.shape.mass

    @property
    def box(self) -> Box:
        """The box around it, turned as it is."""
        low, high = self.shape.low, self.shape.high
        m = matrix(self.turn)
        middle = apply(m, ((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2))
        half = ((high[0] - low[0]) / 2, (high[1] - low[1]) / 2, (high[2] - low[2]) / 2)
        axes = ((m[0], m[3], m[6]), (m[1], m[4], m[7]), (m[2], m[5], m[8]))
        return Box(plus(self.place, middle), axes, half)

    @property
    def polyhedra(self) -> tuple[Polyhedron, ...]:
        """Its solids where they stand; none if it is a box."""
        (solid, *more), low, high = self.shape.solids, self.shape.low, self.shape.high
        if not more and all(
            value - least < SKIN or most - value < SKIN
            for corner in solid.vertices
            for value, least, most in zip(corner, low, high, strict=True)
        ):
            return ()
        return _polyhedra(self.placed)

    @property
    def upwards(self) -> Vector:
        """Its own vertical in the world's frame."""
        m = matrix(self.turn)
        return m[2], m[5], m[8]

    @property
    def bottom(self) -> float:
        """Height of its lowest corner, inches."""
        return min(solid.low[2] for solid in self.placed)

    @property
    def top(self) -> float:
        """Height of its highest corner, inches."""
        return max(solid.high[2] for solid in self.placed)


@dataclass
class Feeder:
    """A place where the next part appears when one has been taken away.

    Attributes:
        name: parts are called by it and a number.
        x: of the place, inches.
        y: of the place, inches.
        turn: of the parts.
        size: of the parts, inches.
        weight: of the parts, ounces.
        count: how many parts it has in all; None for an unending supply.
        given: how many it has given so far.
        solids: that make up each part, around its middle; a box of that size unless given.
        friction: coefficient of their surface; the table's unless given.
        bottom: height of the place, inches.
        commanded: whether it gives a part only when told.
    """

    name: str
    x: float
    y: float
    turn: float
    size: Vector
    weight: float
    count: int | None = None
    given: int = 0
    solids: tuple[Solid, ...] = ()
    friction: float | None = None
    bottom: float = 0.0
    commanded: bool = False
    _placed: list[Placed] | None = field(default=None, init=False, repr=False, compare=False)
    _shape: Shape | None = field(default=None, init=False, repr=False, compare=False)

    def __getstate__(self) -> dict[str, Any]:
        # Its part's form, and where it will stand, follow from the rest.
        gone = {"_placed": None, "_shape": None}
        return {each.name: getattr(self, each.name) for each in fields(self)} | gone

    @property
    def radius(self) -> float:
        """Of the sphere around the next part's box, inches."""
        a, b, c = self.size[0] / 2, self.size[1] / 2, self.size[2] / 2
        return math.sqrt(a * a + b * b + c * c)

    @property
    def place(self) -> Box:
        """Where the next part will stand."""
        return upright(self.x, self.y, self.bottom, self.size, self.turn)

    @property
    def shape(self) -> Shape:
        """Of each part."""
        if self._shape is None:
            self._shape = Shape.of(self.solids or (box(self.size),), self.weight)
        return self._shape

    @property
    def placed(self) -> list[Placed]:
        """The next part's solids where it will stand."""
        if self._placed is None:
            solids = self.solids or (box(self.size),)
            turn = about((0.0, 0.0, 1.0), math.degrees(self.turn))
            low = min(z for solid in solids for _, _, z in solid.vertices)
            self._placed = [
                Placed(solid, (self.x, self.y, self.bottom - low), matrix(turn)) for solid in solids
            ]
        return self._placed

    @property
    def empty(self) -> bool:
        """Whether it has given all its parts."""
        return self.count is not None and self.given >= self.count


@dataclass
class Tray:
    """A place from which parts are taken away as soon as they stand there, let go.

    Attributes:
        name: of the tray.
        x: of its centre, inches.
        y: of its centre, inches.
        width: along x, inches.
        depth: along y, inches.
        taken: how many parts it has taken.
    """

    name: str
    x: float
    y: float
    width: float
    depth: float
    taken: int = 0

    def under(self, part: Part) -> bool:
        """Whether a part stands in it: its middle, on or near the table."""
        x, y, _ = part.place
        inside = abs(x - self.x) <= self.width / 2 and abs(y - self.y) <= self.depth / 2
        return inside and part.bottom < ON_THE_TABLE


@dataclass(frozen=True)
class Obstacle:
    """Something that nothing moves.

    Attributes:
        name: of the obstacle.
        box: where it stands: the box itself, or the one around it.
        solids: of which it is made, where they stand, if it is no box.
    """

    name: str
    box: Box
    solids: tuple[Solid, ...] = ()

    @cached_property
    def standing(self) -> tuple[Solid, ...]:
        """Its solids where they stand."""
        return self.solids or (box_at(self.box),)

    @cached_property
    def placed(self) -> list[Placed]:
        """The same with all that follows."""
        return [Placed(solid, NOWHERE, IDENTITY) for solid in self.standing]

    @cached_property
    def polyhedra(self) -> tuple[Polyhedron, ...]:
        """Its solids; none if it is a box."""
        corners = self.box.corners()
        if len(self.placed) == 1 and all(
            min(math.dist(vertex, corner) for corner in corners) < SKIN
            for vertex in self.placed[0].vertices
        ):
            return ()
        return _polyhedra(self.placed)

    def __getstate__(self) -> dict[str, Any]:
        return {each.name: getattr(self, each.name) for each in fields(self)}


def _polyhedra(placed: Sequence[Placed]) -> tuple[Polyhedron, ...]:
    """Solids as corners and faces."""
    return tuple((tuple(solid.vertices), solid.faces) for solid in placed)


def box_at(place: Box) -> Solid:
    """A box as a solid in the world's frame."""
    a, b, c = place.axes
    turn = quaternion((a[0], b[0], c[0], a[1], b[1], c[1], a[2], b[2], c[2]))
    h = place.half
    return box((2 * h[0], 2 * h[1], 2 * h[2])).moved(place.center, turn)
