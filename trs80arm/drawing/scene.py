"""What there is to draw of the arm and its bench, in inches and without any screen.

A scene is shapes in a plane. `ui/side_scene.py` makes that of the plane in which the arm stands,
`ui/top_scene.py` that of the table from above; the views fit a window to it and draw it on a canvas
(`ui/viewport.py`).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import cos, dist, radians, sin
from typing import TypeAlias

from trs80arm.arm.shapes import Box
from trs80arm.drawing.canvas_ascii import Point
from trs80arm.drawing.readings import Kind, Posture, Readings, Thing
from trs80arm.drawing.rows import Ink

PALM_HALF_WIDTH = 0.76
"""Half the distance of the fingers' roots, inches: they are parallel at 1.52 (arm facts, 7)."""
QUARTER = radians(90)
SQUARE = 0.03
"""Inches by which the corners of a thing may be off those of an upright box drawn for it."""

Bounds: TypeAlias = tuple[float, float, float, float]
"""Left, bottom, right and top, inches."""


@dataclass(frozen=True)
class Stroke:
    """A straight line, or two rails `width` inches apart where the scale has room for them.

    A dotted stroke is a row of single marks that never covers anything.
    """

    start: Point
    end: Point
    ink: Ink
    width: float = 0.0
    dotted: bool = False


@dataclass(frozen=True)
class Joint:
    """A joint or another single place, marked by a glyph; a small one is never drawn as a disc."""

    place: Point
    ink: Ink
    glyph: str = "o"
    small: bool = False


@dataclass(frozen=True)
class Block:
    """An upright box between two corners; `fill` is its glyph inside, `_` leaves it hollow."""

    corner: Point
    opposite: Point
    ink: Ink
    fill: str


@dataclass(frozen=True)
class Facet:
    """A convex outline, counter-clockwise or clockwise; `fill` is its glyph inside."""

    corners: tuple[Point, ...]
    ink: Ink
    fill: str


@dataclass(frozen=True)
class Trace:
    """Single points, marked by the first glyph in a cell's upper half and the second below."""

    points: tuple[Point, ...]
    ink: Ink
    glyphs: str


Shape: TypeAlias = Stroke | Joint | Block | Facet | Trace


@dataclass(frozen=True)
class Scene:
    """Shapes from the back to the front, and what a window must show of them.

    Attributes:
        shapes: in inches, y upwards.
        bounds: what belongs into the picture.
        focus: what a closer look is centred on: the middle of the hand.
        resting: the height at which the hand holds what lies on the table, None where no table is
            seen from the side; whatever is higher is drawn above the table's row.
    """

    shapes: tuple[Shape, ...]
    bounds: Bounds
    focus: Point
    resting: float | None = None


@dataclass(frozen=True)
class TrailPoint:
    """Where the fingertip was: in the arm's plane of that moment, and seen from above."""

    side: Point
    top: Point


@dataclass(frozen=True)
class Extras:
    """What is drawn on request: the envelope of the fingertip, and where it has been."""

    envelope: bool = False
    trail: Sequence[TrailPoint] = ()


PLAINLY = Extras()
"""Nothing on request."""

FILL = {
    Kind.PART: "#",
    Kind.FEEDER: "=",
    Kind.TRAY: "_",
    Kind.OBSTACLE: "X",
    Kind.TURNTABLE: "@",
    Kind.CONVEYOR: ":",
    Kind.MACHINE: "%",
    Kind.SENSOR: "?",
}
"""The glyph of each kind of thing."""
ANSWERS = "!"
"""The glyph of a sensor that answers."""
INK = {kind: Ink.PART if kind is Kind.PART else Ink.FURNITURE for kind in Kind}
"""The ink of each kind of thing."""


def fill(thing: Thing, heading: float) -> str:
    """The glyph of a thing: of its kind, or of what it does.

    Args:
        thing: as it is.
        heading: angle in the picture of its first axis, radians, for what moves along that.
    """
    if thing.kind is Kind.SENSOR and thing.on:
        return ANSWERS
    if thing.moving:
        return ">^<v"[round(heading / QUARTER + (2 if thing.moving < 0 else 0)) % 4]
    return FILL[thing.kind]


def along(start: Point, angle: float, length: float) -> Point:
    """The point `length` inches from `start` at an angle, in radians, from the x axis."""
    return start[0] + length * cos(angle), start[1] + length * sin(angle)


def root_from_middle(opening: float) -> float:
    """How far from the middle of the hand a finger begins, inches.

    A hand that is opened wider than the palm has fingers that stay parallel: seen leading inwards
    they would go through what is between them.
    """
    return max(PALM_HALF_WIDTH, opening / 2)


def skeleton(posture: Posture) -> tuple[Point, Point, Point, Point]:
    """Shoulder, elbow, wrist and fingertip in the arm's plane, inches."""
    points = posture.points
    c, s = cos(posture.angles.base), sin(posture.angles.base)

    def beside(place: tuple[float, float, float]) -> Point:
        return place[0] * c + place[1] * s, place[2]

    return (
        beside(points.shoulder),
        beside(points.elbow),
        beside(points.wrist),
        beside(points.fingertip),
    )


SHOWS = 0.15
"""Inches by which the arm must be elsewhere in a picture to be shown where it was told to be."""


def differs_from_the_side(readings: Readings) -> bool:
    """Whether the arm seen from the side is elsewhere than it was told to be."""
    told, posture = readings.believed, readings.posture
    return told is not None and (
        abs(told.opening - posture.opening) > SHOWS
        or any(
            dist(one, other) > SHOWS
            for one, other in zip(skeleton(told), skeleton(posture), strict=True)
        )
    )


def differs_from_above(readings: Readings) -> bool:
    """Whether the fingertip seen from above is elsewhere than it was told to be."""
    told = readings.believed
    here = readings.posture.points.fingertip
    return told is not None and dist(told.points.fingertip[:2], here[:2]) > SHOWS


def trail_point(posture: Posture) -> TrailPoint:
    """The fingertip of a posture, for a trail."""
    x, y, _ = posture.points.fingertip
    return TrailPoint(skeleton(posture)[3], (x, y))


def turned(place: Sequence[float], base: float) -> Point:
    """A place on the table as distance along the arm's plane and distance to its left."""
    c, s = cos(base), sin(base)
    return place[0] * c + place[1] * s, place[1] * c - place[0] * s


def half_along(box: Box, angle: float) -> float:
    """Half of what a box covers along a level direction, inches."""
    c, s = cos(angle), sin(angle)
    return sum(
        half * abs(axis[0] * c + axis[1] * s) for half, axis in zip(box.half, box.axes, strict=True)
    )


def outline(points: Iterable[Point]) -> tuple[Point, ...]:
    """The convex outline of some points, counter-clockwise, without points that lie on an edge."""
    ordered = sorted(set(points))
    halves = []
    for way in (ordered, ordered[::-1]):
        half: list[Point] = []
        for point in way:
            while len(half) > 1 and _turn(half[-2], half[-1], point) <= _STRAIGHT:
                half.pop()
            half.append(point)
        halves.append(half[:-1])
    return (*halves[0], *halves[1])


_STRAIGHT = 1e-6


def _turn(a: Point, b: Point, c: Point) -> float:
    """Twice the area of a triangle, positive counter-clockwise."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def solid(points: Iterable[Point], ink: Ink, fill: str) -> Block | Facet:
    """What some corners cover: an upright box if it is one, else its outline."""
    corners = outline(points)
    left, bottom, right, top = around(corners)
    square = all(
        min(abs(x - left), abs(x - right)) < SQUARE and min(abs(y - bottom), abs(y - top)) < SQUARE
        for x, y in corners
    )
    if square:
        return Block((left, bottom), (right, top), ink, fill)
    return Facet(corners, ink, fill)


def around(points: Iterable[Point]) -> Bounds:
    """The bounds that hold all points."""
    xs, ys = zip(*points, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def middle(a: Point, b: Point) -> Point:
    """The point half way between two."""
    return (a[0] + b[0]) / 2, (a[1] + b[1]) / 2
