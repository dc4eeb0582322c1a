"""The arm as solids: what its model says of the room that each link takes up, made to look like it.

The MiniMover's links are two plates with cables between, its joints axles through both, its fingers
bars that stay parallel. The boxes of `ArmModel.solids` say how large each is; what is drawn stays
in them, and the fingers' bars lead from the palm to where the fingertips are.
"""

from __future__ import annotations

from functools import lru_cache
from math import cos, sin, sqrt

import numpy as np

from trs80arm.arm.model import ArmModel, Link
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.shapes import Vector, cross, minus, plus
from trs80arm.drawing.materials import Material
from trs80arm.drawing.readings import Posture
from trs80arm.drawing.solids import (
    NOTHING,
    Articulated,
    Solids,
    box,
    cylinder,
    prism,
    rounded,
)

BASE, BODY, UPPER_ARM, FOREARM, HAND, LEFT_FINGER, RIGHT_FINGER = range(1, 8)
"""The numbers of the arm's own bodies; 0 is the table's."""

_PLATE = 0.3
"""Thickness of a link's side plates, inches. This and the rest of the look is not on record."""
_BEVEL = 0.14
_AXLE = 0.4
_CABLE = 0.06
_TIP = 0.8
"""Length of the block at a finger's end, inches."""
BAR = 0.22
"""Thickness of the bars of the fingers."""
_BAR_LENGTH = 1.8
FINGER = Material.FINGER


def arm_solids(posture: Posture) -> Solids:
    """Links, hand and fingers where they are."""
    model, angles = posture.model, posture.angles
    points = posture.points
    level = (-sin(angles.base), cos(angles.base), 0.0)
    upper = _unit(minus(points.elbow, points.shoulder))
    fore = _unit(minus(points.wrist, points.elbow))
    pointing, across = points.pointing, points.across
    over = cross(pointing, across)
    hand = (pointing, across, over)
    axes = np.array(hand)
    frames = [
        (points.shoulder, (upper, level, cross(upper, level))),
        (points.elbow, (fore, level, cross(fore, level))),
        (points.wrist, hand),
    ]
    for left in (True, False):
        for place, turn in _finger_frames(model, posture.opening, left=left):
            frames.append((np.array(place) @ axes + points.wrist, np.array(turn) @ axes))
    return _pieces(model).placed_each([place for place, _ in frames], [turn for _, turn in frames])


def pedestal(settings: ArmSettings, base: float) -> Solids:
    """The base plate, which stays, and the body on it, which turns with the arm."""
    c, s = cos(base), sin(base)
    turned = ((c, s, 0.0), (-s, c, 0.0), (0.0, 0.0, 1.0))
    return Solids.joined((_plate(settings), _body(settings).placed((0.0, 0.0, 0.0), turned)))


def _unit(v: Vector) -> Vector:
    length = sqrt(v[0] ** 2 + v[1] ** 2 + v[2] ** 2) or 1.0
    return v[0] / length, v[1] / length, v[2] / length


def _room(model: ArmModel, link: Link) -> tuple[Vector, Vector]:
    """The lowest and the highest corner of the room that a link takes up, in its frame."""
    solid = next(solid for solid in model.solids if solid.link is link)
    return minus(solid.center, solid.half), plus(solid.center, solid.half)


@lru_cache(8)
def _plate(settings: ArmSettings) -> Solids:
    half = settings.base_width / 2
    if not settings.base_height:
        return NOTHING
    rear, front, height = -settings.base_rear, settings.base_front, settings.base_height
    return prism(
        ((rear, -half), (front, -half), (front, half), (rear, half)),
        0.0,
        height,
        Material.BASE,
        BASE,
        bevel=(0.0, min(0.2, height / 3)),
    )


@lru_cache(8)
def _body(settings: ArmSettings) -> Solids:
    if not settings.body_radius:
        return NOTHING
    low, high = settings.base_height, settings.arm_model.shoulder_height
    wide, top = settings.body_radius, settings.body_radius * 0.55
    deep = settings.body_radius * 0.75
    corners = [
        (x, y, z)
        for z, a, b in ((low, wide, deep), (high + 0.35, top, deep * 0.95))
        for x, y in ((-a, -b), (a, -b), (a, b), (-a, b))
    ]
    faces = [(3, 2, 1, 0), (4, 5, 6, 7)] + [
        (i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4) for i in range(4)
    ]
    shell = Solids.of(corners, faces, Material.BODY, BODY)
    motors = [
        cylinder((z, x), 0.5, side * wide, 0.0, Material.MOTOR, BODY, along=1)
        if side < 0
        else cylinder((z, x), 0.5, 0.0, wide, Material.MOTOR, BODY, along=1)
        for side in (-1, 1)
        for z, x in ((low + 1.0, -0.6), (low + 1.0, 0.6), (low + 2.3, 0.0))
    ]
    return Solids.joined((shell, *motors))


def _link(model: ArmModel, link: Link, body: int) -> Solids:
    """Two plates, what joins them, the axles, and the cables that run along."""
    (near, right, down), (far, outer, up) = _room(model, link)
    # The plates reach to the axle at their end, however little of them can touch anything.
    outline = rounded((down, near), (up, max(far, model.link + _PLATE)), (up - down) * 0.45)
    inner = outer - _PLATE
    plates = [
        prism(outline, low, high, Material.ARM, body, along=1, bevel=bevel)
        for low, high, bevel in ((right, -inner, (_BEVEL, 0.0)), (inner, outer, (0.0, _BEVEL)))
    ]
    web = box((1.0, -inner, down * 0.6), (model.link - 1.0, inner, down * 0.3), Material.ARM, body)
    axle = cylinder((0.0, 0.0), _AXLE, right - 0.08, outer + 0.08, Material.JOINT, body, along=1)
    cables = [
        cylinder(
            (y, up * 0.5), _CABLE, 0.4, model.link - 0.4, Material.CABLE, body, along=0, sides=4
        )
        for y in (-inner * 0.5, inner * 0.5)
    ]
    pieces = [*plates, web, *cables, axle]
    if link is Link.UPPER_ARM:
        elbow = (0.0, model.link)
        pieces.append(
            cylinder(elbow, _AXLE, right - 0.08, outer + 0.08, Material.JOINT, body, along=1)
        )
    return Solids.joined(pieces)


@lru_cache(8)
def _pieces(model: ArmModel) -> Articulated:
    """Upper arm, forearm, hand, and bar and block of the left and the right finger."""
    return Articulated(
        (
            _link(model, Link.UPPER_ARM, UPPER_ARM),
            _link(model, Link.FOREARM, FOREARM),
            _palm(model),
            *_finger_pieces(model, left=True),
            *_finger_pieces(model, left=False),
        )
    )


def _palm(model: ArmModel) -> Solids:
    low, high = _room(model, Link.HAND)
    gear = _room(model, Link.FOREARM)[1][1] - _PLATE
    palm = prism(
        rounded((low[1], low[2]), (high[1], high[2]), 0.15),
        low[0] + 0.5,
        high[0],
        Material.HAND,
        HAND,
        along=0,
        bevel=(0.0, 0.12),
    )
    wheel = cylinder((0.0, 0.0), high[2] * 1.1, 0.2, 0.5, Material.JOINT, HAND, along=0)
    neck = cylinder(
        (0.0, 0.0), high[2] * 0.5, 0.5, low[0] + 0.5, Material.JOINT, HAND, along=0, sides=8
    )
    axle = cylinder((0.0, 0.0), _AXLE, -gear, gear, Material.JOINT, HAND, along=1)
    return Solids.joined((axle, wheel, neck, palm))


def _finger_frames(
    model: ArmModel, opening: float, *, left: bool
) -> tuple[tuple[Vector, tuple[Vector, Vector, Vector]], ...]:
    """Where in the hand's frame a finger's bar is, which leads from the palm, and its block."""
    side = 1.0 if left else -1.0
    _, palm = _room(model, Link.HAND)
    _, finger = _room(model, Link.LEFT_FINGER)
    inner = side * opening / 2
    root = (palm[0] - 0.15, side * palm[1] * 0.6)
    end = (model.hand_length - _TIP * 0.6, inner + side * finger[1] * 0.6)
    x, y = root[0] - end[0], root[1] - end[1]
    length = sqrt(x * x + y * y)
    x, y = x / length, y / length
    up = (0.0, 0.0, 1.0)
    return (
        ((*end, 0.0), ((x, y, 0.0), (-y, x, 0.0), up)),
        ((model.hand_length, inner, 0.0), ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), up)),
    )


def _finger_pieces(model: ArmModel, *, left: bool) -> tuple[Solids, Solids]:
    """The bar from where it holds the block on into the palm, and the block from the fingertip."""
    body = LEFT_FINGER if left else RIGHT_FINGER
    low, high = _room(model, Link.LEFT_FINGER if left else Link.RIGHT_FINGER)
    wide, thick = high[2], high[1] - low[1]
    pad = thick * 0.35
    bar = box((0.0, -BAR / 2, -wide * 0.8), (_BAR_LENGTH, BAR / 2, wide * 0.8), FINGER, body)
    inner, outer = ((low[1], low[1] + pad), (low[1] + pad, high[1]))
    if not left:
        inner, outer = (high[1] - pad, high[1]), (low[1], high[1] - pad)
    block = Solids.joined(
        (
            box((-_TIP, inner[0], -wide), (0.0, inner[1], wide), Material.PAD, body),
            box((-_TIP, outer[0], -wide), (0.0, outer[1], wide), FINGER, body),
        )
    )
    return bar, block
