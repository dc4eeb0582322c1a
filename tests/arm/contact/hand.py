"""A hand on slides, for trying contact without an arm: x, y, z, turn, tilt, opening.

At turn 0 and tilt 0 it points straight down and closes along y. Its fingers are those of the
arm's hand: 1.7 in long, 0.6 wide, 0.12 thick outside the inner face.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from trs80arm.arm.contact.bodies import Link, Screw
from trs80arm.arm.contact.solids import Solid, box
from trs80arm.arm.shapes import Vector, cross

FINGER = (1.7, 0.12, 0.6)
PALM = (1.8, 1.2, 0.7)
PER_INCH = 16 / 52 * 618
"""Ounces of squeeze for an inch of cable: a pound in 52 half-steps of 618 to the inch."""


class SlidingHand:
    """Six springs: three slides, two pivots at the fingertip, the opening."""

    names = ("left finger", "right finger", "palm")
    frictions = (0.75, 0.75, 0.3)
    stiffness = (2000.0, 2000.0, 2000.0, 20000.0, 20000.0, PER_INCH)
    hand = 2

    solids: Sequence[Solid] = (
        box(FINGER).moved((-FINGER[0] / 2, FINGER[1] / 2, 0.0)),
        box(FINGER).moved((-FINGER[0] / 2, -FINGER[1] / 2, 0.0)),
        box(PALM).moved((-2.9, 0.0, 0.0)),
    )

    def links(self, joints: Sequence[float]) -> list[Link]:
        x, y, z, turn, tilt, opening = joints
        c, s, p, q = math.cos(turn), math.sin(turn), math.sin(tilt), math.cos(tilt)
        along: Vector = (p * c, p * s, -q)
        across: Vector = (-s, c, 0.0)
        up = cross(along, across)
        frame = (along[0], across[0], up[0], along[1], across[1], up[1], along[2], across[2], up[2])
        still: Screw = ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
        down = (-across[0], -across[1], -across[2])
        tip = (x, y, z)
        common: tuple[Screw, ...] = (
            ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0)),
            ((0.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
            ((0.0, 0.0, 0.0), (0.0, 0.0, 1.0)),
            ((0.0, 0.0, 1.0), cross(tip, (0.0, 0.0, 1.0))),
            (down, cross(tip, down)),
        )
        out = []
        for side in (0.5, -0.5):
            place = (x + side * opening * across[0], y + side * opening * across[1], z)
            open_by: Screw = ((0.0, 0.0, 0.0), (side * across[0], side * across[1], 0.0))
            out.append(Link(place, frame, (*common, open_by)))
        out.append(Link(tip, frame, (*common, still)))
        return out
