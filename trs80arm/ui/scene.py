"""What there is to draw of the arm and its bench, in inches and without any screen.

`side_scene` is the plane in which the arm stands: x is the distance from the base's axis, y the
height above the table. `top_scene` looks from above: x is forward, y to the arm's left. The views
fit a window to a scene and draw it on a canvas (`ui/viewport.py`).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import atan2, cos, degrees, hypot, radians, sin
from typing import TypeAlias

from trs80arm.arm.geometry import (
    ELBOW_LIMITS,
    HAND_LENGTH,
    LINK,
    REACH,
    SHOULDER_HEIGHT,
    SHOULDER_LIMITS,
    forward,
)
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.shapes import Box
from trs80arm.ui.canvas_ascii import Point
from trs80arm.ui.readings import Kind, Posture, Readings, Thing
from trs80arm.ui.rows import Ink

PALM_HALF_WIDTH = 0.76
"""Half the distance of the fingers' roots, inches: they are parallel at 1.52 (arm facts, 7)."""
FINGER_LENGTH = ArmSettings().finger_length
NARROW = 0.4
"""Opening up to which the fingers, seen from above, are marked by one glyph as well, inches."""
FINGER_THICKNESS = 0.8
"""How far a finger reaches outwards from its pad, seen from above, inches. Not on record."""
UPPER_ARM_DEPTH = 1.5
FOREARM_DEPTH = 1.1
"""Height of the links' side plates, inches. Not on record; drawn so where there is room."""
TOP_LEFT = -3.5
"""How much of the base behind its axis must be seen from above, inches."""
NEAR = 0.6
"""How far beside the arm's plane a thing may stand and still be drawn as in it, inches."""

QUARTER = radians(90)
SQUARE = 0.05
"""Sine times cosine of a turn below which a thing is drawn square to the table."""

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
class Trace:
    """Single points, marked by the first glyph in a cell's upper half and the second below."""

    points: tuple[Point, ...]
    ink: Ink
    glyphs: str


Shape: TypeAlias = Stroke | Joint | Block | Trace


@dataclass(frozen=True)
class Scene:
    """Shapes from the back to the front, and what a window must show of them.

    Attributes:
        shapes: in inches, y upwards.
        bounds: what belongs into the picture.
        focus: what a closer look is centred on: the middle of the hand.
    """

    shapes: tuple[Shape, ...]
    bounds: Bounds
    focus: Point


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


def along(start: Point, angle: float, length: float) -> Point:
    """The point `length` inches from `start` at an angle, in radians, from the x axis."""
    return start[0] + length * cos(angle), start[1] + length * sin(angle)


def skeleton(posture: Posture) -> tuple[Point, Point, Point, Point]:
    """Shoulder, elbow, wrist and fingertip in the arm's plane, inches."""
    points = forward(posture.angles)
    c, s = cos(posture.angles.base), sin(posture.angles.base)

    def beside(place: tuple[float, float, float]) -> Point:
        return place[0] * c + place[1] * s, place[2]

    return (
        beside(points.shoulder),
        beside(points.elbow),
        beside(points.wrist),
        beside(points.fingertip),
    )


def trail_point(posture: Posture) -> TrailPoint:
    """The fingertip of a posture, for a trail."""
    x, y, _ = forward(posture.angles).fingertip
    return TrailPoint(skeleton(posture)[3], (x, y))


def side_scene(readings: Readings, extras: Extras = PLAINLY) -> Scene:
    """The plane in which the arm stands, seen from its right.

    The hand is drawn turned so that its opening can be seen; the top view shows its roll. Things
    that stand beside the plane are faint and filled with `:`.
    """
    posture, fittings = readings.posture, readings.fittings
    base = posture.angles.base
    points = skeleton(posture)
    inside = [thing for thing in readings.things if _in_the_plane(thing, base)]
    beside = [thing for thing in readings.things if not _in_the_plane(thing, base)]
    # What stands further away, on the arm's left, is drawn first.
    beside.sort(key=lambda thing: -_turned(thing.box.center, base)[1])
    bounds = _around(
        [(-fittings.base_rear - 0.4, -0.5), (12.5, 12.5), *points]
        + [corner for thing in inside for corner in _side_corners(thing, base)]
    )
    shapes: list[Shape] = []
    if extras.envelope:
        outline = side_envelope()
        bounds = _around([*_corners(bounds), *outline])
        shapes.append(Trace(outline, Ink.FAINT, "++"))
    shapes += [Block(*_side_corners(thing, base), Ink.FAINT, ":") for thing in beside]
    shapes += _pedestal(base, fittings)
    shapes.append(Stroke((-99.0, 0.0), (99.0, 0.0), Ink.FURNITURE))
    shapes += [_side_block(thing, base) for thing in inside if not thing.held]
    shapes.append(Trace(tuple(point.side for point in extras.trail), Ink.TRAIL, "'."))
    if readings.believed:
        shapes += _side_ghost(readings.believed)
    shapes += [_side_block(thing, base) for thing in inside if thing.held]
    shapes += _side_arm(posture)
    # However small the picture is, a part in the hand can be seen.
    shapes += [
        Joint((_turned(thing.box.center, base)[0], thing.box.center[2]), Ink.PART, "#", small=True)
        for thing in inside
        if thing.held
    ]
    return Scene(tuple(shapes), bounds, _middle(points[2], points[3]))


def _pedestal(base: float, fittings: ArmSettings) -> list[Shape]:
    """The base plate, which stays, and the body on it, which turns with the arm."""
    half = fittings.base_width / 2
    corners = [
        _turned((x, y), base)[0]
        for x in (-fittings.base_rear, fittings.base_front)
        for y in (-half, half)
    ]
    radius, top, height = fittings.body_radius, fittings.base_height, SHOULDER_HEIGHT
    left, right = min(corners), max(corners)
    return [
        Stroke((left, 0.0), (left, top), Ink.FURNITURE),
        Stroke((right, 0.0), (right, top), Ink.FURNITURE),
        Stroke((left, top), (right, top), Ink.FURNITURE),
        Stroke((-radius, top), (-radius * 0.6, height), Ink.FURNITURE),
        Stroke((radius, top), (radius * 0.6, height), Ink.FURNITURE),
    ]


def _side_arm(posture: Posture) -> list[Shape]:
    shoulder, elbow, wrist, _ = skeleton(posture)
    return [
        Stroke(shoulder, elbow, Ink.ARM, UPPER_ARM_DEPTH),
        Stroke(elbow, wrist, Ink.ARM, FOREARM_DEPTH),
        *_hand(wrist, posture, dotted=False),
        Joint(shoulder, Ink.ARM, "O"),
        Joint(elbow, Ink.ARM),
        Joint(wrist, Ink.HAND),
    ]


def _side_ghost(posture: Posture) -> list[Shape]:
    shoulder, elbow, wrist, _ = skeleton(posture)
    return [
        Stroke(shoulder, elbow, Ink.GHOST, dotted=True),
        Stroke(elbow, wrist, Ink.GHOST, dotted=True),
        *_hand(wrist, posture, dotted=True),
    ]


def _hand(wrist: Point, posture: Posture, dotted: bool) -> list[Shape]:
    """The hand in its own plane: palm, cross-piece, and two fingers that show the opening."""
    ink = Ink.GHOST if dotted else Ink.HAND
    pitch = posture.angles.pitch
    left = pitch + QUARTER
    palm = along(wrist, pitch, HAND_LENGTH - FINGER_LENGTH)
    tip = along(wrist, pitch, HAND_LENGTH)
    roots = [along(palm, left, side * PALM_HALF_WIDTH) for side in (-1, 1)]
    ends = [along(tip, left, side * posture.opening / 2) for side in (-1, 1)]
    return [
        Stroke(wrist, palm, ink, dotted=dotted),
        Stroke(roots[0], roots[1], ink, dotted=dotted),
        Stroke(roots[0], ends[0], ink, dotted=dotted),
        Stroke(roots[1], ends[1], ink, dotted=dotted),
    ]


def _turned(place: Sequence[float], base: float) -> Point:
    """A place on the table as distance along the arm's plane and distance to its left."""
    c, s = cos(base), sin(base)
    return place[0] * c + place[1] * s, place[1] * c - place[0] * s


def _half_along(box: Box, angle: float) -> float:
    """Half of what a box covers along a level direction, inches."""
    c, s = cos(angle), sin(angle)
    return sum(
        half * abs(axis[0] * c + axis[1] * s) for half, axis in zip(box.half, box.axes, strict=True)
    )


def _in_the_plane(thing: Thing, base: float) -> bool:
    ahead, across = _turned(thing.box.center, base)
    return thing.held or (
        ahead > 0 and abs(across) <= _half_along(thing.box, base + QUARTER) + NEAR
    )


def _side_corners(thing: Thing, base: float) -> tuple[Point, Point]:
    box = thing.box
    ahead, _ = _turned(box.center, base)
    half = box.half[0] if thing.kind is Kind.TURNTABLE else _half_along(box, base)
    return (ahead - half, box.bottom), (ahead + half, box.top)


def _side_block(thing: Thing, base: float) -> Shape:
    return Block(*_side_corners(thing, base), _INK[thing.kind], _FILL[thing.kind])


_FILL = {
    Kind.PART: "#",
    Kind.FEEDER: "=",
    Kind.TRAY: "_",
    Kind.OBSTACLE: "X",
    Kind.TURNTABLE: "@",
    Kind.SENSOR: "?",
}
_INK = {kind: Ink.PART if kind is Kind.PART else Ink.FURNITURE for kind in Kind}


def _around(points: Iterable[Point]) -> Bounds:
    xs, ys = zip(*points, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def _corners(bounds: Bounds) -> tuple[Point, Point]:
    return bounds[:2], bounds[2:]


def _middle(a: Point, b: Point) -> Point:
    return (a[0] + b[0]) / 2, (a[1] + b[1]) / 2


def top_scene(readings: Readings, extras: Extras = PLAINLY) -> Scene:
    """Table, base and arm from above, the arm's front to the right and its left side up."""
    posture, fittings = readings.posture, readings.fittings
    points = forward(posture.angles)
    flat = [point[:2] for point in (points.elbow, points.wrist, points.fingertip)]
    corners = [corner for thing in readings.things for corner in _top_corners(thing)]
    bounds = _around([(TOP_LEFT, -4.5), (12.0, 4.5), *flat, *corners])
    shapes: list[Shape] = []
    if extras.envelope:
        outline = top_envelope()
        bounds = _around([*_corners(bounds), *outline])
        shapes.append(Trace(outline, Ink.FAINT, "++"))
    loose = sorted((thing for thing in readings.things if not thing.held), key=_upper_side)
    shapes += _rectangle(
        (-fittings.base_rear, -fittings.base_width / 2),
        (fittings.base_front, fittings.base_width / 2),
    )
    for thing in loose:
        shapes += _top_block(thing)
    shapes.append(Trace(tuple(point.top for point in extras.trail), Ink.TRAIL, "'."))
    if readings.believed:
        ghost = forward(readings.believed.angles)
        shapes.append(Stroke((0.0, 0.0), ghost.fingertip[:2], Ink.GHOST, dotted=True))
    for thing in readings.things:
        if thing.held:
            shapes += _top_block(thing)
    shapes += _top_arm(posture)
    shapes += [
        Joint(thing.box.center[:2], Ink.PART, "#", small=True)
        for thing in readings.things
        if thing.held
    ]
    return Scene(tuple(shapes), bounds, _middle(flat[1], flat[2]))


def _upper_side(thing: Thing) -> float:
    return thing.box.top


def _top_corners(thing: Thing) -> tuple[Point, Point]:
    x, y, _ = thing.box.center
    half_x, half_y = _half_along(thing.box, 0.0), _half_along(thing.box, QUARTER)
    return (x - half_x, y - half_y), (x + half_x, y + half_y)


def _top_block(thing: Thing) -> list[Shape]:
    """A thing from above: as an upright box, or, when large and turned, as its four edges."""
    ink, box = _INK[thing.kind], thing.box
    if thing.kind is Kind.TURNTABLE:
        return _plate(box)
    (ux, uy, _), (vx, vy, _), _ = box.axes
    if abs(ux * uy) < SQUARE or max(box.half[:2]) < 1 or thing.kind is Kind.PART:
        return [Block(*_top_corners(thing), ink, _FILL[thing.kind])]
    (x, y, _), (a, b, _) = box.center, box.half
    corners = [
        (x + i * a * ux + j * b * vx, y + i * a * uy + j * b * vy)
        for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))
    ]
    edges: list[Shape] = [Stroke(corners[place - 1], corners[place], ink) for place in range(4)]
    return [*edges, Joint((x, y), ink, _FILL[thing.kind], small=True)]


def _plate(box: Box) -> list[Shape]:
    """A turntable: its rim, and a spoke that shows how far it has turned."""
    middle, radius = (box.center[0], box.center[1]), box.half[0]
    turn = atan2(box.axes[0][1], box.axes[0][0])
    rim = [along(middle, radians(angle), radius) for angle in range(0, 361, 30)]
    edges = [Stroke(a, b, Ink.FURNITURE) for a, b in pairwise(rim)]
    return [*edges, Stroke(middle, along(middle, turn, radius), Ink.FURNITURE)]


def _rectangle(corner: Point, opposite: Point) -> list[Shape]:
    (left, bottom), (right, top) = corner, opposite
    return [
        Stroke((left, bottom), (left, top), Ink.FURNITURE),
        Stroke((right, bottom), (right, top), Ink.FURNITURE),
        Stroke((left, top), (right, top), Ink.FURNITURE),
        Stroke((left, bottom), (right, bottom), Ink.FURNITURE),
    ]


def _top_arm(posture: Posture) -> list[Shape]:
    """The arm as one line; the fingers, two bars with the opening between, where roll puts them."""
    points = forward(posture.angles)
    centre = (0.0, 0.0)
    elbow, wrist, tip = points.elbow[:2], points.wrist[:2], points.fingertip[:2]
    across = points.across[:2]
    shapes: list[Shape] = [
        Stroke(centre, elbow, Ink.ARM),
        Stroke(elbow, wrist, Ink.ARM),
        Joint(centre, Ink.ARM, "O"),
        Joint(elbow, Ink.ARM),
    ]
    if hypot(tip[0] - wrist[0], tip[1] - wrist[1]) > HAND_LENGTH / 2:
        palm = _part_way(wrist, tip, 1 - FINGER_LENGTH / HAND_LENGTH)
        for side in (-1, 1):
            root = _beside(palm, across, side * PALM_HALF_WIDTH)
            shapes.append(Stroke(wrist, root, Ink.HAND))
            shapes.append(Stroke(root, _beside(tip, across, side * posture.opening / 2), Ink.HAND))
        return [*shapes, Joint(wrist, Ink.HAND)]
    # The hand points down or up: the wrist is hidden by it, or would hide the opening.
    for side in (-1, 1):
        pad = _beside(tip, across, side * posture.opening / 2)
        back = _beside(tip, across, side * (posture.opening / 2 + FINGER_THICKNESS))
        shapes.append(Stroke(pad, back, Ink.HAND))
    if posture.opening < NARROW:
        # The bars are too short to show which way they lie where the picture is small.
        shapes.append(Joint(tip, Ink.HAND, _lying(across), small=True))
    return shapes


def _part_way(a: Point, b: Point, share: float) -> Point:
    return a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])


def _beside(place: Point, direction: Point, distance: float) -> Point:
    return place[0] + distance * direction[0], place[1] + distance * direction[1]


def _lying(direction: Point) -> str:
    """The glyph that lies the way of a direction of the table."""
    eighth = round(degrees(atan2(direction[1], direction[0])) / 45) % 4
    return "-/|\\"[eighth]


def side_envelope() -> tuple[Point, ...]:
    """The outline that the fingertip can reach in the arm's plane with the hand straight."""
    low, high = (round(degrees(limit)) for limit in SHOULDER_LIMITS)
    fold = round(-degrees(ELBOW_LIMITS[0]))
    postures = (
        [(shoulder, 0) for shoulder in range(low, high + 1, 4)]
        + [(high, bend) for bend in range(0, fold, 7)]
        + [(shoulder, fold) for shoulder in range(high, low, -12)]
        + [(low, bend) for bend in range(0, fold, 7)]
    )
    points: list[Point] = []
    for shoulder, bend in postures:
        elbow = along((0.0, SHOULDER_HEIGHT), radians(shoulder), LINK)
        tip = along(elbow, radians(shoulder - bend), LINK + HAND_LENGTH)
        if tip[1] > 0:
            points.append(tip)
    return tuple(points)


def top_envelope() -> tuple[Point, ...]:
    """The furthest that the fingertip reaches over the table, seen from above."""
    return tuple(along((0.0, 0.0), radians(angle), REACH) for angle in range(-90, 91, 4))
