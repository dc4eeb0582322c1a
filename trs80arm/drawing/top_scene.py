"""The arm from above: the table with all that lies on it, and how the hand is turned.

x is forward of the base's axis and drawn to the right, y to the arm's left and drawn upwards, in
inches.
"""

from __future__ import annotations

from itertools import pairwise
from math import atan2, degrees, hypot, radians

from trs80arm.arm.model import ArmModel
from trs80arm.arm.shapes import Box
from trs80arm.drawing.canvas_ascii import Point
from trs80arm.drawing.readings import Kind, Posture, Readings, Thing
from trs80arm.drawing.rows import Ink
from trs80arm.drawing.scene import (
    FILL,
    INK,
    PLAINLY,
    QUARTER,
    Block,
    Bounds,
    Extras,
    Joint,
    Scene,
    Shape,
    Stroke,
    Trace,
    along,
    around,
    differs_from_above,
    fill,
    half_along,
    middle,
    root_from_middle,
    solid,
)

NARROW = 0.4
"""Opening up to which the fingers, seen from above, are marked by one glyph as well, inches."""
FINGER_THICKNESS = 0.8
"""How far a finger reaches outwards from its pad, seen from above, inches. Not on record."""
TOP_LEFT = -1.8
"""How much of the base behind its axis must be seen from above, inches."""
TURNED = 0.05
"""Sine times cosine of a turn below which a thing is drawn square to the table."""


def top_scene(readings: Readings, extras: Extras = PLAINLY) -> Scene:
    """Table, base and arm from above, the arm's front to the right and its left side up."""
    posture, fittings = readings.posture, readings.fittings
    bounds, focus = top_frame(readings, extras)
    shapes: list[Shape] = []
    if extras.envelope:
        shapes.append(Trace(top_envelope(posture.model), Ink.FAINT, "++"))
    loose = sorted((thing for thing in readings.things if not thing.held), key=_upper_side)
    shapes += _rectangle(
        (-fittings.base_rear, -fittings.base_width / 2),
        (fittings.base_front, fittings.base_width / 2),
    )
    for thing in loose:
        shapes += _top_block(thing)
    shapes.append(Trace(tuple(point.top for point in extras.trail), Ink.TRAIL, "`,"))
    if readings.believed and differs_from_above(readings):
        ghost = readings.believed.points
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
    return Scene(tuple(shapes), bounds, focus)


def top_frame(readings: Readings, extras: Extras = PLAINLY) -> tuple[Bounds, Point]:
    """What belongs into the picture from above, and what a closer look is centred on."""
    posture = readings.posture
    points = posture.points
    flat = [point[:2] for point in (points.elbow, points.wrist, points.fingertip)]
    corners = [corner for thing in readings.things for corner in _top_corners(thing)]
    if extras.envelope:
        corners += top_envelope(posture.model)
    bounds = around([(TOP_LEFT, -3.2), (12.0, 3.2), *flat, *corners])
    return bounds, middle(flat[1], flat[2])


def _upper_side(thing: Thing) -> float:
    return thing.box.top


def _top_corners(thing: Thing) -> tuple[Point, Point]:
    x, y, _ = thing.box.center
    half_x, half_y = half_along(thing.box, 0.0), half_along(thing.box, QUARTER)
    return (x - half_x, y - half_y), (x + half_x, y + half_y)


def _top_block(thing: Thing) -> list[Shape]:
    """A thing from above: its outline; furniture as a box, or, large and turned, as its edges."""
    ink, box = INK[thing.kind], thing.box
    if thing.kind is Kind.TURNTABLE:
        return _plate(box)
    (ux, uy, _), (vx, vy, _), _ = box.axes
    if thing.kind in (Kind.PART, Kind.OBSTACLE):
        return [solid([corner[:2] for corner in thing.corners], ink, FILL[thing.kind])]
    glyph = fill(thing, atan2(uy, ux))
    if abs(ux * uy) < TURNED or max(box.half[:2]) < 1:
        return [Block(*_top_corners(thing), ink, glyph)]
    (x, y, _), (a, b, _) = box.center, box.half
    corners = [
        (x + i * a * ux + j * b * vx, y + i * a * uy + j * b * vy)
        for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))
    ]
    edges: list[Shape] = [Stroke(corners[place - 1], corners[place], ink) for place in range(4)]
    return [*edges, Joint((x, y), ink, glyph, small=True)]


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
    points = posture.points
    centre = (0.0, 0.0)
    elbow, wrist, tip = points.elbow[:2], points.wrist[:2], points.fingertip[:2]
    across = points.across[:2]
    shapes: list[Shape] = [
        Stroke(centre, elbow, Ink.ARM),
        Stroke(elbow, wrist, Ink.ARM),
        Joint(centre, Ink.ARM, "O"),
        Joint(elbow, Ink.ARM),
    ]
    length = posture.model.hand_length
    if hypot(tip[0] - wrist[0], tip[1] - wrist[1]) > length / 2:
        palm = _part_way(wrist, tip, 1 - posture.model.hand.finger_length / length)
        for side in (-1, 1):
            root = _beside(palm, across, side * root_from_middle(posture.opening))
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


def top_envelope(model: ArmModel) -> tuple[Point, ...]:
    """The furthest that the fingertip reaches over the table, seen from above."""
    return tuple(along((0.0, 0.0), radians(angle), model.reach) for angle in range(-90, 91, 4))
