"""What can stand on the bench besides the table: parts, feeders, trays, obstacles, sensors.

Plain values and small counters; `bench` gives them their physics and `benchfile` reads them
from a file. Inches, ounces; turns in radians counter-clockwise from above.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from trs80arm.arm.shapes import Box, Vector, interval, overlap, plus, upright


@dataclass
class Part:
    """A box that can be picked up.

    Attributes:
        name: unique on its bench.
        size: along its own x, y, z when it was made, inches.
        weight: ounces.
        box: where it is now; its size there is as it lies now.
        held: whether the hand carries it.
    """

    name: str
    size: Vector
    weight: float
    box: Box
    held: bool = False


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
    """

    name: str
    x: float
    y: float
    turn: float
    size: Vector
    weight: float
    count: int | None = None
    given: int = 0

    @property
    def place(self) -> Box:
        """Where the next part will stand."""
        return upright(self.x, self.y, 0.0, self.size, self.turn)

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

    def under(self, box: Box) -> bool:
        """Whether a part stands in it: its middle, on or near the table."""
        return (
            abs(box.center[0] - self.x) <= self.width / 2
            and abs(box.center[1] - self.y) <= self.depth / 2
            and box.bottom < 0.01
        )


@dataclass(frozen=True)
class Obstacle:
    """A box that nothing moves.

    Attributes:
        name: of the obstacle.
        box: where it stands.
    """

    name: str
    box: Box


@dataclass(frozen=True)
class Proximity:
    """A sensor that answers when a part or the hand comes near it.

    Attributes:
        bit: of the input nibble, 1 to 3.
        place: of the sensor, inches.
        range: distance at which it answers, inches.
    """

    bit: int
    place: Vector
    range: float

    def answers(self, boxes: list[Box], segments: list[tuple[Vector, Vector]]) -> bool:
        """Whether any box or segment is within range."""
        limit = self.range**2
        return any(_to_box(self.place, box) <= limit for box in boxes) or any(
            _to_segment(self.place, a, b) <= limit for a, b in segments
        )


PRESSED: Vector = (0.0, 0.0, -0.001)
"""How far what stands on a pad presses it in, inches."""


@dataclass(frozen=True)
class Tactile:
    """A pad that answers when something rests or presses on it.

    Attributes:
        bit: of the input nibble, 1 to 3.
        pad: the pad as a box of no great height.
    """

    bit: int
    pad: Box

    def answers(self, boxes: list[Box], segments: list[tuple[Vector, Vector]]) -> bool:
        """Whether a box stands on the pad or the arm touches it."""
        if any(overlap(box.moved(PRESSED), self.pad, 0.0) for box in boxes):
            return True
        return any(interval(self.pad, a, b) is not None for a, b in segments)


@dataclass(frozen=True)
class LightBeam:
    """A beam that answers when something is in it.

    Attributes:
        bit: of the input nibble, 1 to 3.
        start: of the beam, inches.
        end: of the beam, inches.
    """

    bit: int
    start: Vector
    end: Vector

    def answers(self, boxes: list[Box], segments: list[tuple[Vector, Vector]]) -> bool:
        """Whether a box, or a link or finger half an inch thick, is in the beam."""
        if any(interval(box, self.start, self.end) is not None for box in boxes):
            return True
        return any(_apart(self.start, self.end, a, b) < 0.25**2 for a, b in segments)


Sensor = Proximity | Tactile | LightBeam


@dataclass
class Turntable:
    """A round plate let into the table, turned by a stepper motor on the auxiliary latch.

    Attributes:
        x: of its axis, inches.
        y: of its axis, inches.
        radius: inches.
        steps: half-steps per turn of the plate.
        rotor: half-steps that it has been turned, positive counter-clockwise.
    """

    x: float
    y: float
    radius: float
    steps: int
    rotor: int = field(default=0)

    def under(self, box: Box) -> bool:
        """Whether the plate carries this box, alone or in a stack."""
        return (box.center[0] - self.x) ** 2 + (box.center[1] - self.y) ** 2 <= self.radius**2


def _to_box(point: Vector, box: Box) -> float:
    """Squared distance from a point to a box."""
    d = tuple(p - c for p, c in zip(point, box.center, strict=True))
    total = 0.0
    for axis, half in zip(box.axes, box.half, strict=True):
        out = abs(sum(a * b for a, b in zip(d, axis, strict=True))) - half
        if out > 0:
            total += out * out
    return total


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
