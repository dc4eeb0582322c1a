"""Sensors that the arm carries: pads on its fingers and links, an eye in its palm, cable tension.

They sense what contact does to the arm and where it truly is.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from trs80arm.arm.cell.seen import Seen
from trs80arm.arm.contact.distance import distance_to
from trs80arm.arm.model import Link
from trs80arm.arm.shapes import Box, Vector, dot, plus

FACING = 0.7
"""Cosine to the way straight at a face from which what presses there presses on it."""
THICK = 0.04
"""Inches that a pad is drawn thick."""


class Face(Enum):
    """Where on a finger a pad is."""

    TIP = "tip"
    INNER = "inner"
    OUTER = "outer"


class Tension(Enum):
    """Which cable's tension a force sensor senses."""

    BASE = "base"
    SHOULDER = "shoulder"
    ELBOW = "elbow"
    WRIST = "wrist"
    GRIP = "grip"


@dataclass(frozen=True)
class TactilePad:
    """A pad on a finger's face, or on a whole link; answers when enough presses on it.

    Attributes:
        name: of the sensor.
        bit: of the input nibble, 1 to 3.
        bank: of the selector.
        on: the link.
        face: of a finger; None for whatever presses on the link from whichever side.
        threshold: ounces at which it answers.
    """

    name: str
    bit: int
    bank: int
    on: Link
    face: Face | None
    threshold: float

    def answers(self, seen: Seen) -> bool:
        """Whether at least the threshold presses on it."""
        return self.force(seen) >= self.threshold

    def force(self, seen: Seen) -> float:
        """Ounces that press on it."""
        if self.face is Face.INNER and seen.squeeze:
            return seen.squeeze
        pushes = seen.pushes(self.on)
        if self.face is None:
            return sum(force for _, force in pushes)
        along, across, _ = seen.frame(self.on)
        # What presses on a face pushes the finger away from it.
        out = 1.0 if self.on is Link.LEFT_FINGER else -1.0
        ways = {Face.TIP: (along, -1.0), Face.INNER: (across, out), Face.OUTER: (across, -out)}
        axis, sign = ways[self.face]
        return sum(force for way, force in pushes if sign * dot(way, axis) >= FACING)

    def shown(self, seen: Seen) -> Box:
        """Where drawings have it: the face; of a whole link its upper side."""
        solid = seen.solid(self.on)
        (x, y, z), (a, b, c) = solid.center, solid.half
        out = 1.0 if self.on is Link.LEFT_FINGER else -1.0
        at, half = {
            None: ((x, y, z + c), (a, b, THICK)),
            Face.TIP: ((x + a, y, z), (THICK, b, c)),
            Face.INNER: ((x, y - out * b, z), (a, THICK, c)),
            Face.OUTER: ((x, y + out * b, z), (a, THICK, c)),
        }[self.face]
        return _in_frame(seen, self.on, at, half)


@dataclass(frozen=True)
class PalmProximity:
    """A light and an eye in the palm that look out between the fingers.

    Attributes:
        name: of the sensor.
        bit: of the input nibble, 1 to 3.
        bank: of the selector.
        range: inches from the palm within which it sees something straight ahead.
    """

    name: str
    bit: int
    bank: int
    range: float

    def answers(self, seen: Seen) -> bool:
        """Whether a part, the table or anything else is straight ahead within range."""
        eye = self.eye(seen)
        along, _, _ = seen.frame(Link.HAND)
        end = plus(eye, along, self.range)
        if min(eye[2], end[2]) <= 0.0:
            return True
        return any(distance_to(solid, eye, end) == 0 for solid in (*seen.parts, *seen.standing))

    def eye(self, seen: Seen) -> Vector:
        """Where it is, inches."""
        solid = seen.solid(Link.HAND)
        along, _, _ = seen.frame(Link.HAND)
        return plus(seen.place(Link.HAND), along, solid.center[0] + solid.half[0])

    def shown(self, seen: Seen) -> Box:
        """Where drawings have it."""
        solid = seen.solid(Link.HAND)
        at = (solid.center[0] + solid.half[0] + THICK, 0.0, 0.0)
        return _in_frame(seen, Link.HAND, at, (THICK, 0.15, 0.15))


@dataclass(frozen=True)
class ForceSensor:
    """A switch on a cable, as the grip switch is one: answers when enough strains the cable.

    The arm's own weight does not; what hangs in the hand, pushes or presses does.

    Attributes:
        name: of the sensor.
        bit: of the input nibble, 1 to 3.
        bank: of the selector.
        on: whose cable.
        threshold: ounces at which it answers: at the end of the joint's link across it, or of
            grip.
    """

    name: str
    bit: int
    bank: int
    on: Tension
    threshold: float

    def answers(self, seen: Seen) -> bool:
        """Whether at least the threshold strains the cable."""
        return self.force(seen) >= self.threshold

    def force(self, seen: Seen) -> float:
        """Ounces at the end of the link, or between the fingers."""
        if self.on is Tension.GRIP:
            return seen.grip_force
        base, shoulder, elbow, left, right = seen.strains
        model = seen.model
        torque, lever = {
            Tension.BASE: (base, model.reach),
            Tension.SHOULDER: (shoulder, model.link),
            Tension.ELBOW: (elbow, model.link),
            Tension.WRIST: (left + right, model.hand_length),
        }[self.on]
        return abs(torque) / lever

    def shown(self, seen: Seen) -> Box:
        """Where drawings have it: at the joint, or in the palm."""
        link, at = {
            Tension.BASE: (Link.UPPER_ARM, (0.0, 0.0, -1.0)),
            Tension.SHOULDER: (Link.UPPER_ARM, (0.0, 0.0, 0.0)),
            Tension.ELBOW: (Link.FOREARM, (0.0, 0.0, 0.0)),
            Tension.WRIST: (Link.HAND, (0.0, 0.0, 0.0)),
            Tension.GRIP: (Link.HAND, (1.15, 0.0, 0.4)),
        }[self.on]
        solid = seen.solid(link)
        return _in_frame(seen, link, at, (0.1, solid.half[1] + 0.1, 0.1))


def _in_frame(seen: Seen, link: Link, at: Vector, half: Vector) -> Box:
    """A box that is said in a link's frame, where that stands."""
    axes = seen.frame(link)
    center = seen.place(link)
    for axis, by in zip(axes, at, strict=True):
        center = plus(center, axis, by)
    return Box(center, axes, half)
