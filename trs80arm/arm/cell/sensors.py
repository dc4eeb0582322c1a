"""Sensors that stand on the table: proximity, tactile pads, light beams.

Each sees true places, those of parts and of the arm, and says whether it answers.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from trs80arm.arm.cell.seen import Seen
from trs80arm.arm.contact.distance import distance, distance_to
from trs80arm.arm.contact.manifold import Placed
from trs80arm.arm.contact.rotations import IDENTITY
from trs80arm.arm.contact.solids import box
from trs80arm.arm.shapes import Box, Vector, interval, plus, upright

TOUCHED = 0.005
"""A pad feels what is within this of it, inches."""
DRAWN = 0.1
"""Inches that what has no size of its own is drawn wide and high."""


@dataclass(frozen=True)
class Proximity:
    """A sensor that answers when a part or the hand comes near it.

    Attributes:
        bit: of the input nibble, 1 to 3.
        place: of the sensor, inches.
        range: distance at which it answers, inches.
        name: of the sensor.
        bank: of the selector.
    """

    bit: int
    place: Vector
    range: float
    name: str = ""
    bank: int = 0

    def answers(self, seen: Seen) -> bool:
        """Whether anything of a part, or a segment, is within range."""
        return any(
            _outside(self.place, solid) <= self.range
            and distance_to(solid, self.place) <= self.range
            for solid in seen.parts
        ) or any(_to_segment(self.place, a, b) <= self.range**2 for a, b in seen.segments)

    def shown(self, seen: Seen) -> Box:
        """Where drawings have it."""
        x, y, z = self.place
        return upright(x, y, z - DRAWN / 2, (DRAWN, DRAWN, DRAWN), 0.0)


@dataclass(frozen=True)
class Tactile:
    """A pad that answers when something rests or presses on it.

    Attributes:
        bit: of the input nibble, 1 to 3.
        pad: the pad as a box of no great height.
        name: of the sensor.
        bank: of the selector.
    """

    bit: int
    pad: Box
    name: str = ""
    bank: int = 0

    def answers(self, seen: Seen) -> bool:
        """Whether a part stands on the pad or the arm touches it."""
        size = (2 * self.pad.half[0], 2 * self.pad.half[1], 2 * self.pad.half[2])
        pad = Placed(box(size), self.pad.center, IDENTITY)
        return any(
            solid.near(pad, TOUCHED) and distance(solid, pad) <= TOUCHED for solid in seen.parts
        ) or any(interval(self.pad, a, b) is not None for a, b in seen.segments)

    def shown(self, seen: Seen) -> Box:
        """Where drawings have it."""
        return self.pad


@dataclass(frozen=True)
class LightBeam:
    """A beam that answers when something is in it.

    Attributes:
        bit: of the input nibble, 1 to 3.
        start: of the beam, inches.
        end: of the beam, inches.
        name: of the sensor.
        bank: of the selector.
    """

    bit: int
    start: Vector
    end: Vector
    name: str = ""
    bank: int = 0

    def answers(self, seen: Seen) -> bool:
        """Whether a part, or a link or finger half an inch thick, is in the beam."""
        return any(distance_to(solid, self.start, self.end) == 0 for solid in seen.parts) or any(
            _near(self.start, self.end, a, b, 0.25) and _apart(self.start, self.end, a, b) < 0.25**2
            for a, b in seen.segments
        )

    def shown(self, seen: Seen) -> Box:
        """Where drawings have it: all that the beam may go through."""
        (x0, y0, z0), (x1, y1, z1) = self.start, self.end
        size = (abs(x1 - x0) + DRAWN, abs(y1 - y0) + DRAWN, abs(z1 - z0) + DRAWN)
        return upright((x0 + x1) / 2, (y0 + y1) / 2, min(z0, z1) - DRAWN / 2, size, 0.0)


def _outside(point: Vector, solid: Placed) -> float:
    """Inches from a point to the upright box around a solid."""
    total = 0.0
    for p, low, high in zip(point, solid.low, solid.high, strict=True):
        out = max(low - p, p - high)
        if out > 0:
            total += out * out
    return math.sqrt(total)


def _to_segment(point: Vector, a: Vector, b: Vector) -> float:
    """Squared distance from a point to a segment."""
    along = (b[0] - a[0], b[1] - a[1], b[2] - a[2])
    length = sum(v * v for v in along)
    t = 0.0
    if length > 0:
        t = sum((p - q) * v for p, q, v in zip(point, a, along, strict=True)) / length
        t = min(1.0, max(0.0, t))
    nearest = plus(a, along, t)
    return sum((p - q) ** 2 for p, q in zip(point, nearest, strict=True))


def _near(a: Vector, b: Vector, c: Vector, d: Vector, reach: float) -> bool:
    """Whether spheres around two segments come within reach of each other."""
    apart = math.dist(plus(a, b), plus(c, d)) / 2
    return apart <= (math.dist(a, b) + math.dist(c, d)) / 2 + reach


def _apart(a: Vector, b: Vector, c: Vector, d: Vector) -> float:
    """Squared distance between two segments, to well under their thickness."""
    # The distance to a segment is convex along the other one, so halving thirds finds it.
    low, high = 0.0, 1.0
    along = (b[0] - a[0], b[1] - a[1], b[2] - a[2])
    for _ in range(40):
        one, two = low + (high - low) / 3, high - (high - low) / 3
        if _to_segment(plus(a, along, one), c, d) < _to_segment(plus(a, along, two), c, d):
            high = two
        else:
            low = one
    return _to_segment(plus(a, along, (low + high) / 2), c, d)
