"""Kinematics: rotor positions to joint angles to places, and back, for any `ArmModel`.

Cables couple the joints so that shoulder, forearm and hand are all driven in angles to the
horizontal, which makes the forward solution three sums; the inverse is the article's Table 4
subroutine, tests and all. The arm and the figures use it; programs that want to plan a motion
can too.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from trs80arm.arm.model import SHOULDER, ArmModel, Motor, Pose, Rotors
from trs80arm.arm.trigonometry import arc_tangent, sin_cos

Point = tuple[float, float, float]


class OutOfReach(ValueError):  # noqa: N818 (the article's words)
    """The pose cannot be taken up; the text says which of Table 4's tests failed."""


@dataclass(frozen=True, slots=True)
class JointAngles:
    """Angles of the joints in radians.

    Attributes:
        base: T1, from the x axis, counter-clockwise from above.
        shoulder: T2, upper arm from the horizontal.
        elbow: T3, forearm from the horizontal.
        pitch: hand from the horizontal.
        roll: hand about its pointing vector, relative to the arm; 0 has the fingers side by
            side, positive turns clockwise seen from behind the hand (facts 4).
    """

    base: float
    shoulder: float
    elbow: float
    pitch: float
    roll: float

    @classmethod
    def of_gears(
        cls, base: float, shoulder: float, elbow: float, left: float, right: float
    ) -> JointAngles:
        """The angles with the wrist gears at P + R (left) and P - R (right)."""
        pitch, roll = pitch_and_roll(left, right)
        return cls(base, shoulder, elbow, pitch, roll)

    @property
    def driven(self) -> tuple[float, float, float, float, float]:
        """What the motors turn: base, upper arm, forearm, left gear, right gear, radians."""
        return self.base, self.shoulder, self.elbow, self.left_gear, self.right_gear

    @property
    def left_gear(self) -> float:
        """Left wrist gear, P + R, radians from the horizontal."""
        return self.pitch + self.roll

    @property
    def right_gear(self) -> float:
        """Right wrist gear, P - R, radians from the horizontal."""
        return self.pitch - self.roll


def pitch_and_roll(left: float, right: float) -> tuple[float, float]:
    """Of the hand, with its wrist gears at P + R (left) and P - R (right)."""
    return (left + right) / 2, (left - right) / 2


class ArmPoints(NamedTuple):
    """The joints as points (x, y, z in inches), and the axes of the hand (unit vectors).

    Attributes:
        shoulder: on the base axis.
        elbow: end of the upper arm.
        wrist: end of the forearm.
        fingertip: midway between the fingertips.
        pointing: along the hand.
        across: from the right finger to the left one, the way the hand closes.
    """

    shoulder: Point
    elbow: Point
    wrist: Point
    fingertip: Point
    pointing: Point
    across: Point


def forward(model: ArmModel, angles: JointAngles) -> ArmPoints:
    """Places of the joints for drawing and for contact.

    Args:
        model: of the arm.
        angles: joint angles in radians.
    """
    return forward_by(
        model,
        sin_cos(angles.base),
        sin_cos(angles.shoulder),
        sin_cos(angles.elbow),
        sin_cos(angles.pitch),
        sin_cos(angles.roll),
    )


SinCos = tuple[float, float]
"""Sine and cosine of an angle."""


def forward_by(
    model: ArmModel, base: SinCos, shoulder: SinCos, elbow: SinCos, pitch: SinCos, roll: SinCos
) -> ArmPoints:
    """`forward`, for who has sines and cosines of the joint angles.

    Args:
        model: of the arm.
        base: of that joint's angle, and so on.
        shoulder: as `base`.
        elbow: as `base`.
        pitch: as `base`.
        roll: as `base`.
    """
    (s1, c1), (s2, c2), (s3, c3), (sp, cp), (sr, cr) = base, shoulder, elbow, pitch, roll
    height, link, hand = model.shoulder_height, model.link, model.hand_length
    r2, z2 = link * c2, height + link * s2
    r3, z3 = r2 + link * c3, z2 + link * s3
    r4, z4 = r3 + hand * cp, z3 + hand * sp
    # With roll 0 the fingers lie left and right; rolling lifts the left one.
    return ArmPoints(
        (0.0, 0.0, height),
        (r2 * c1, r2 * s1, z2),
        (r3 * c1, r3 * s1, z3),
        (r4 * c1, r4 * s1, z4),
        (cp * c1, cp * s1, sp),
        (-cr * s1 - sr * sp * c1, cr * c1 - sr * sp * s1, sr * cp),
    )


def pose_of(model: ArmModel, angles: JointAngles, opening: float) -> Pose:
    """The pose that these joint angles give.

    Args:
        model: of the arm.
        angles: joint angles in radians.
        opening: hand opening in inches, carried over.
    """
    x, y, z = forward(model, angles).fingertip
    return Pose(
        x,
        y,
        z,
        math.degrees(angles.pitch),
        math.degrees(angles.roll - angles.base),
        opening,
    )


def inverse(
    model: ArmModel, x: float, y: float, z: float, pitch: float, roll: float, r1: float = 1.0
) -> JointAngles:
    """Joint angles for a fingertip place, as Table 4's subroutine at line 5000 finds them.

    Args:
        model: of the arm, whose H, L and LL are put into lines 101 to 103.
        x: inches forward.
        y: inches to the left.
        z: inches above the table.
        pitch: degrees.
        roll: degrees.
        r1: 1 for a roll in world coordinates, 0 for a roll relative to the arm (line 113).

    Returns:
        Angles in radians; the elbow is always the upper of the two solutions.

    Raises:
        OutOfReach: where the subroutine prints OUT OF REACH. Its tests are kept as printed,
            the shoulder's -127 degrees (the stop is at -35) and the .25 inches among them.
    """
    degree = 180 / math.pi
    link, hand = model.link, model.hand_length
    p, r = pitch / degree, roll / degree
    rr = math.sqrt(x * x + y * y)
    if rr < 0.25:
        raise OutOfReach(f"the fingertip is {rr:.2f} in from the base axis, nearer than .25")
    t1 = math.copysign(math.pi / 2, y) if x == 0 else arc_tangent(y / x)
    if x < 0:
        raise OutOfReach(f"x = {x:g} is behind the base axis")
    t4 = p + r + r1 * t1
    t5 = p - r - r1 * t1
    for name, gear in (("left", t4), ("right", t5)):
        if abs(gear) > 270 / degree:
            raise OutOfReach(f"the {name} wrist gear would be at {gear * degree:.1f} degrees")
    sine, cosine = sin_cos(p)
    r0 = rr - hand * cosine
    z0 = z - hand * sine - model.shoulder_height
    if r0 < 0.25:
        raise OutOfReach(f"the wrist would be {r0:.2f} in from the base axis, nearer than .25")
    g = arc_tangent(z0 / r0)
    a = 4 * link * link / (r0 * r0 + z0 * z0) - 1
    if a < 0:
        raise OutOfReach("the wrist is farther from the shoulder than the two links are long")
    a = arc_tangent(math.sqrt(a))
    t2, t3 = a + g, g - a
    if t2 > 144 / degree or t2 < -127 / degree:
        raise OutOfReach(f"the upper arm would be at {t2 * degree:.1f} degrees")
    if t2 - t3 < 0 or t2 - t3 > 149 / degree:
        raise OutOfReach(f"the elbow would be bent by {(t2 - t3) * degree:.1f} degrees")
    return JointAngles(t1, t2, t3, (t4 + t5) / 2, (t4 - t5) / 2)


@dataclass(frozen=True, slots=True)
class CableDrive:
    """The cables between rotors and joints of an arm that was switched on somewhere.

    Rotor positions are half-steps from the position in which the arm was switched on, so this
    knows where that was; how far and which way a count turns what is the model's.

    Attributes:
        model: of the arm.
        home: joint angles at rotor positions 0.
        home_cable: half-steps of hand cable paid out at rotor positions 0, counted from an
            empty hand that has just closed.
    """

    model: ArmModel
    home: JointAngles
    home_cable: int = 0

    @classmethod
    def from_pose(cls, model: ArmModel, pose: Pose) -> CableDrive:
        """The cables of an arm that is switched on in a pose.

        Raises:
            OutOfReach: if it cannot take it.
        """
        angles = inverse(model, pose.x, pose.y, pose.z, pose.pitch, pose.roll)
        return cls(model, angles, round(pose.opening * model.hand_steps))

    def driven(self, rotors: Rotors) -> tuple[Any, Any, Any, Any, Any]:
        """Radians of base, upper arm, forearm, left and right gear; arrays for arrays."""
        a, b, c, d, e = self.model.turned(rotors)
        home = self.home
        pitch, roll = home.pitch, home.roll
        return (
            home.base + a,
            home.shoulder + b,
            home.elbow + c,
            pitch + roll + d,
            pitch - roll + e,
        )

    def lifted(self, motor: Motor, rotors: Rotors) -> Any:
        """Radians of upper arm or forearm alone, as `driven` has them; arrays for arrays."""
        home = self.home.shoulder if motor is SHOULDER else self.home.elbow
        return home + self.model.turned_alone(motor, rotors)

    def angles(self, rotors: Sequence[int]) -> JointAngles:
        """Joint angles (radians) for rotor positions (half-steps)."""
        return JointAngles.of_gears(*self.driven(rotors))

    def cable(self, rotors: Rotors) -> Any:
        """Half-steps of hand cable paid out, by the hand's motor and by the forearm.

        An `int` for one position, an array for arrays.
        """
        return self.home_cable + self.model.paid_out(rotors)

    def rotors(self, angles: JointAngles, cable: int) -> tuple[int, ...]:
        """Rotor positions nearest to joint angles (radians) and hand cable (half-steps)."""
        turns = [to - at for to, at in zip(angles.driven, self.home.driven, strict=True)]
        counts = (*self.model.counts(turns), 0)
        return (*counts[:5], cable - self.cable(counts))
