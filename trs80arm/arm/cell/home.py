"""Home switches: a cam on the drum of a joint's drive, by which a program finds the joint again.

The cam turns with the drum, so it shows where the joint truly stands, whatever was commanded and
however many steps were lost. Registers it knows nothing of.
"""

from __future__ import annotations

from dataclasses import dataclass

from trs80arm.arm.cell.seen import Seen
from trs80arm.arm.model import Motor
from trs80arm.arm.shapes import UP, Box, Vector, plus

JOINTS: dict[str, Motor] = {
    "base": Motor.BASE,
    "shoulder": Motor.SHOULDER,
    "elbow": Motor.ELBOW,
    "left wrist": Motor.LEFT_WRIST,
    "right wrist": Motor.RIGHT_WRIST,
}
"""The joints that have one, as bench files call them; the hand has its grip switch."""


@dataclass
class HomeSwitch:
    """A switch that is closed where its joint stands at a mark or beyond, to the positive side.

    Being a snap switch it has play: once closed it opens only where the joint has gone back a
    little farther than the mark. It repeats to the half-step.

    Attributes:
        name: of the sensor.
        bit: of the input nibble, 1 to 3.
        bank: of the selector.
        motor: what turns its joint.
        mark: angle at which it closes, radians: of the base to the left; of upper arm, forearm and
            wrist gears to the horizontal.
        play: radians.
        closed: whether it is.
    """

    name: str
    bit: int
    bank: int
    motor: Motor
    mark: float
    play: float
    closed: bool = False

    def begin(self, angle: float) -> None:
        """Stand at an angle to which nobody knows how the joint came."""
        self.closed = angle >= self.mark

    def turn(self, angle: float) -> None:
        """Follow the joint to an angle, without turning back on the way."""
        self.closed = angle >= (self.mark - self.play if self.closed else self.mark)

    def answers(self, seen: Seen) -> bool:
        """Whether it is closed."""
        return self.closed

    def shown(self, seen: Seen) -> Box:
        """Where drawings have it: beside its drum, on the body that turns with the base."""
        ahead, left = seen.facing
        x, y, z = _BESIDE[self.motor]
        place = plus(plus((0.0, 0.0, z), ahead, x), left, y)
        return Box(place, (ahead, left, UP), (_HALF, _HALF, _HALF))


_HALF = 0.1
_LOW, _HIGH, _SIDE, _FORE = 2.25, 3.55, 1.65, 0.6
_BESIDE: dict[Motor, Vector] = {
    Motor.BASE: (_FORE, _SIDE, _LOW),
    Motor.SHOULDER: (_FORE, -_SIDE, _LOW),
    Motor.ELBOW: (-_FORE, _SIDE, _LOW),
    Motor.LEFT_WRIST: (-_FORE, -_SIDE, _LOW),
    Motor.RIGHT_WRIST: (0.0, _SIDE, _HIGH),
}
"""Inches ahead of the base's axis, to its left, and up. Of the drives no more is on record than
that the motors sit on both sides of the body in turn."""
