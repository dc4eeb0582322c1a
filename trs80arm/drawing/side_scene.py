"""The arm from the side: the plane in which it stands, with what stands in and beside it.

x is the distance from the base's axis along the arm, y the height above the table, in inches. The
plane turns with the base.
"""

from __future__ import annotations

from math import degrees, radians

from trs80arm.arm.model import ArmModel
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.shapes import dot, minus
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
    differs_from_the_side,
    fill,
    half_along,
    middle,
    root_from_middle,
    skeleton,
    solid,
    turned,
)

UPPER_ARM_DEPTH = 1.5
FOREARM_DEPTH = 1.1
"""Height of the links' side plates, inches. Not on record; drawn so where there is room."""
RESTING = 0.5
"""Height of the middle of a part an inch high that stands on the table, inches."""
NEAR = 0.6
"""How far beside the arm's plane a thing may stand and still be drawn as in it, inches."""


def side_scene(readings: Readings, extras: Extras = PLAINLY) -> Scene:
    """The plane in which the arm stands, seen from its right.

    The hand is drawn turned so that its opening can be seen; the top view shows its roll. Things
    that stand beside the plane are faint and filled with `:`.
    """
    posture, fittings = readings.posture, readings.fittings
    base = posture.angles.base
    inside = [thing for thing in readings.things if _in_the_plane(thing, base)]
    beside = [thing for thing in readings.things if not _in_the_plane(thing, base)]
    # What stands further away, on the arm's left, is drawn first.
    beside.sort(key=lambda thing: -turned(thing.box.center, base)[1])
    bounds, focus = side_frame(readings, extras)
    shapes: list[Shape] = []
    if extras.envelope:
        shapes.append(Trace(side_envelope(posture.model), Ink.FAINT, "++"))
    shapes += [_side_outline(thing, base, Ink.FAINT, ":") for thing in beside]
    shapes += _pedestal(base, fittings)
    shapes.append(Stroke((-99.0, 0.0), (99.0, 0.0), Ink.FURNITURE))
    shapes += [_side_block(thing, base) for thing in inside if not thing.held]
    shapes.append(Trace(tuple(point.side for point in extras.trail), Ink.TRAIL, "`,"))
    if readings.believed and differs_from_the_side(readings):
        shapes += _side_ghost(readings.believed)
    shapes += [_in_the_hand(thing, posture) for thing in inside if thing.held]
    shapes += _side_arm(posture)
    # However small the picture is, a part in the hand can be seen.
    shapes += [
        Joint((turned(thing.box.center, base)[0], thing.box.center[2]), Ink.PART, "#", small=True)
        for thing in inside
        if thing.held
    ]
    return Scene(tuple(shapes), bounds, focus, RESTING)


def side_frame(readings: Readings, extras: Extras = PLAINLY) -> tuple[Bounds, Point]:
    """What belongs into the picture from the side, and what a closer look is centred on."""
    posture, fittings = readings.posture, readings.fittings
    base = posture.angles.base
    points = skeleton(posture)
    corners = [
        corner
        for thing in readings.things
        if _in_the_plane(thing, base)
        for corner in _side_corners(thing, base)
    ]
    if extras.envelope:
        corners += side_envelope(posture.model)
    bounds = around([(-fittings.base_rear - 0.4, -0.5), (12.5, 12.5), *points, *corners])
    return bounds, middle(points[2], points[3])


def _pedestal(base: float, fittings: ArmSettings) -> list[Shape]:
    """The base plate, which stays, and the body on it, which turns with the arm."""
    half = fittings.base_width / 2
    corners = [
        turned((x, y), base)[0]
        for x in (-fittings.base_rear, fittings.base_front)
        for y in (-half, half)
    ]
    radius, top, height = (
        fittings.body_radius,
        fittings.base_height,
        fittings.arm_model.shoulder_height,
    )
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
    length = posture.model.hand_length
    palm = along(wrist, pitch, length - posture.model.hand.finger_length)
    tip = along(wrist, pitch, length)
    roots = [along(palm, left, side * root_from_middle(posture.opening)) for side in (-1, 1)]
    ends = [along(tip, left, side * posture.opening / 2) for side in (-1, 1)]
    return [
        Stroke(wrist, palm, ink, dotted=dotted),
        Stroke(roots[0], roots[1], ink, dotted=dotted),
        Stroke(roots[0], ends[0], ink, dotted=dotted),
        Stroke(roots[1], ends[1], ink, dotted=dotted),
    ]


def _in_the_plane(thing: Thing, base: float) -> bool:
    ahead, across = turned(thing.box.center, base)
    return thing.held or (ahead > 0 and abs(across) <= half_along(thing.box, base + QUARTER) + NEAR)


def _side_corners(thing: Thing, base: float) -> tuple[Point, Point]:
    box = thing.box
    ahead, _ = turned(box.center, base)
    half = box.half[0] if thing.kind is Kind.TURNTABLE else half_along(box, base)
    return (ahead - half, box.bottom), (ahead + half, box.top)


def _side_block(thing: Thing, base: float) -> Shape:
    """A thing as it is seen from the side, with the glyph of what it is or does."""
    x, y, _ = thing.box.axes[0]
    heading = 0.0 if turned((x, y), base)[0] >= 0 else 2 * QUARTER
    return _side_outline(thing, base, INK[thing.kind], fill(thing, heading))


def _side_outline(thing: Thing, base: float, ink: Ink, glyph: str) -> Shape:
    """What a thing covers seen from the side, tilted as it is."""
    if thing.kind is Kind.TURNTABLE:
        return Block(*_side_corners(thing, base), ink, glyph)
    corners = [(turned(corner, base)[0], corner[2]) for corner in thing.corners]
    return solid(corners, ink, glyph)


def _in_the_hand(thing: Thing, posture: Posture) -> Shape:
    """A held part, turned into the picture as the hand is: between its fingers."""
    points, pitch = posture.points, posture.angles.pitch
    tip = skeleton(posture)[3]
    corners = []
    for corner in thing.corners:
        from_tip = minus(corner, points.fingertip)
        ahead = along(tip, pitch, dot(from_tip, points.pointing))
        corners.append(along(ahead, pitch + QUARTER, dot(from_tip, points.across)))
    return solid(corners, INK[thing.kind], FILL[thing.kind])


def side_envelope(model: ArmModel) -> tuple[Point, ...]:
    """The outline that the fingertip can reach in the arm's plane with the hand straight."""
    low, high = (round(degrees(limit)) for limit in model.limits.shoulder)
    fold = round(-degrees(model.limits.elbow[0]))
    postures = (
        [(shoulder, 0) for shoulder in range(low, high + 1, 4)]
        + [(high, bend) for bend in range(0, fold, 7)]
        + [(shoulder, fold) for shoulder in range(high, low, -12)]
        + [(low, bend) for bend in range(0, fold, 7)]
    )
    points: list[Point] = []
    for shoulder, bend in postures:
        elbow = along((0.0, model.shoulder_height), radians(shoulder), model.link)
        tip = along(elbow, radians(shoulder - bend), model.link + model.hand_length)
        if tip[1] > 0:
            points.append(tip)
    return tuple(points)
