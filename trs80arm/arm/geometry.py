"""Kinematics of the MiniMover 5: rotor positions to joint angles to places, and back.

Cables couple the joints so that shoulder, forearm and hand are all driven in angles to the
horizontal, which makes the forward solution three sums; the inverse is the article's Table 4
subroutine, tests and all. `MiniMover` and the figures use it; programs that want to plan a
motion can too.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum

SHOULDER_HEIGHT = 8.1
"""H: shoulder above the table, inches (article, Table 4, line 101)."""
LINK = 7.0
"""L: shoulder to elbow and elbow to wrist, inches (Table 4, line 102)."""
HAND_LENGTH = 3.5
"""LL: wrist to fingertip, inches (Table 4, line 103)."""
REACH = LINK + LINK + HAND_LENGTH
"""17.5 inches from the shoulder (article, Table 1)."""

BASE_SHOULDER_STEPS = 937.8
"""S1: half-steps per radian of base and of shoulder (Table 4, line 121)."""
ELBOW_STEPS = 551.4
"""S3: half-steps per radian of the forearm (Table 4, line 122)."""
WRIST_STEPS = 203.7
"""S4: half-steps per radian of each wrist gear (Table 4, line 123)."""
HAND_STEPS = 618
"""S6: half-steps per inch of hand opening (Table 4, line 124)."""
HAND_RANGE = 3.0
"""Widest opening, inches (Table 1)."""

BASE_LIMIT = math.radians(90)
SHOULDER_LIMITS = (math.radians(-35), math.radians(144))
ELBOW_LIMITS = (math.radians(-149), 0.0)
"""Forearm relative to the upper arm (Table 1; the article's note on joint 3)."""
PITCH_LIMIT = math.radians(90)
"""Hand relative to the forearm (article, on joints 4 and 5)."""
GEAR_LIMIT = math.radians(270)
"""Each wrist gear, from the horizontal (article, on joints 4 and 5)."""

Point = tuple[float, float, float]


class Motor(IntEnum):
    """The six motors, numbered from 0 in the order of ARMBASIC's J1 to J6 and of the latches."""

    BASE = 0
    SHOULDER = 1
    ELBOW = 2
    LEFT_WRIST = 3
    RIGHT_WRIST = 4
    HAND = 5


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

    @property
    def left_gear(self) -> float:
        """Left wrist gear, P + R, radians from the horizontal."""
        return self.pitch + self.roll

    @property
    def right_gear(self) -> float:
        """Right wrist gear, P - R, radians from the horizontal."""
        return self.pitch - self.roll


@dataclass(frozen=True, slots=True)
class Pose:
    """Where the fingertip is and how the hand is turned.

    Attributes:
        x: inches forward of the base axis.
        y: inches to the arm's left.
        z: inches above the table.
        pitch: degrees from the horizontal, -90 pointing straight down.
        roll: degrees about the pointing vector as Table 4 counts them with R1=1: the base angle
            is taken out, so that with the hand pointing down a part keeps its turn on the table
            when only x and y change.
        opening: inches between the fingers.
    """

    x: float
    y: float
    z: float
    pitch: float
    roll: float
    opening: float = 0.0


@dataclass(frozen=True, slots=True)
class ArmPoints:
    """The joints as points (x, y, z in inches), and the axes of the hand (unit vectors).

    Attributes:
        shoulder: on the base axis, 8.1 inches up.
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


START_POSE = Pose(5.0, 0.0, 0.0, -90.0, 0.0, 0.0)
"""Table 4's initialization point, data line 10000."""


def forward(angles: JointAngles) -> ArmPoints:
    """Places of the joints for drawing and for contact.

    Args:
        angles: joint angles in radians.
    """
    c1, s1 = math.cos(angles.base), math.sin(angles.base)
    c2, s2 = math.cos(angles.shoulder), math.sin(angles.shoulder)
    c3, s3 = math.cos(angles.elbow), math.sin(angles.elbow)
    cp, sp = math.cos(angles.pitch), math.sin(angles.pitch)
    cr, sr = math.cos(angles.roll), math.sin(angles.roll)
    r2, z2 = LINK * c2, SHOULDER_HEIGHT + LINK * s2
    r3, z3 = r2 + LINK * c3, z2 + LINK * s3
    r4, z4 = r3 + HAND_LENGTH * cp, z3 + HAND_LENGTH * sp
    # With roll 0 the fingers lie left and right; rolling lifts the left one.
    return ArmPoints(
        (0.0, 0.0, SHOULDER_HEIGHT),
        (r2 * c1, r2 * s1, z2),
        (r3 * c1, r3 * s1, z3),
        (r4 * c1, r4 * s1, z4),
        (cp * c1, cp * s1, sp),
        (-cr * s1 - sr * sp * c1, cr * c1 - sr * sp * s1, sr * cp),
    )


def pose_of(angles: JointAngles, opening: float) -> Pose:
    """The pose that these joint angles give.

    Args:
        angles: joint angles in radians.
        opening: hand opening in inches, carried over.
    """
    x, y, z = forward(angles).fingertip
    return Pose(
        x,
        y,
        z,
        math.degrees(angles.pitch),
        math.degrees(angles.roll - angles.base),
        opening,
    )


def inverse(
    x: float, y: float, z: float, pitch: float, roll: float, r1: float = 1.0
) -> JointAngles:
    """Joint angles for a fingertip place, as Table 4's subroutine at line 5000 finds them.

    Args:
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
    p, r = pitch / degree, roll / degree
    rr = math.sqrt(x * x + y * y)
    if rr < 0.25:
        raise OutOfReach(f"the fingertip is {rr:.2f} in from the base axis, nearer than .25")
    t1 = math.copysign(math.pi / 2, y) if x == 0 else math.atan(y / x)
    if x < 0:
        raise OutOfReach(f"x = {x:g} is behind the base axis")
    t4 = p + r + r1 * t1
    t5 = p - r - r1 * t1
    for name, gear in (("left", t4), ("right", t5)):
        if abs(gear) > 270 / degree:
            raise OutOfReach(f"the {name} wrist gear would be at {gear * degree:.1f} degrees")
    r0 = rr - HAND_LENGTH * math.cos(p)
    z0 = z - HAND_LENGTH * math.sin(p) - SHOULDER_HEIGHT
    if r0 < 0.25:
        raise OutOfReach(f"the wrist would be {r0:.2f} in from the base axis, nearer than .25")
    g = math.atan(z0 / r0)
    a = 4 * LINK * LINK / (r0 * r0 + z0 * z0) - 1
    if a < 0:
        raise OutOfReach("the wrist is farther from the shoulder than the two links are long")
    a = math.atan(math.sqrt(a))
    t2, t3 = a + g, g - a
    if t2 > 144 / degree or t2 < -127 / degree:
        raise OutOfReach(f"the upper arm would be at {t2 * degree:.1f} degrees")
    if t2 - t3 < 0 or t2 - t3 > 149 / degree:
        raise OutOfReach(f"the elbow would be bent by {(t2 - t3) * degree:.1f} degrees")
    return JointAngles(t1, t2, t3, (t4 + t5) / 2, (t4 - t5) / 2)


@dataclass(frozen=True, slots=True)
class CableDrive:
    """The cables between rotors and joints: which count turns what, and how far.

    Rotor positions are half-steps from the position in which the arm was switched on, so the
    drive is told where that was. Signs are those of Table 4's @STEP (facts 4): a positive count
    turns the base counter-clockwise, lowers the upper arm, raises the forearm, lowers the left
    gear, raises the right one, opens the hand.

    Attributes:
        home: joint angles at rotor positions 0.
        home_cable: half-steps of hand cable paid out at rotor positions 0, counted from an
            empty hand that has just closed.
    """

    home: JointAngles
    home_cable: int = 0

    @classmethod
    def from_pose(cls, pose: Pose) -> CableDrive:
        """The cables of an arm that is switched on in a pose.

        Raises:
            OutOfReach: if it cannot take it.
        """
        angles = inverse(pose.x, pose.y, pose.z, pose.pitch, pose.roll)
        return cls(angles, round(pose.opening * HAND_STEPS))

    def angles(self, rotors: Sequence[int]) -> JointAngles:
        """Joint angles (radians) for rotor positions (half-steps)."""
        home = self.home
        left = home.pitch + home.roll - rotors[3] / WRIST_STEPS
        right = home.pitch - home.roll + rotors[4] / WRIST_STEPS
        return JointAngles(
            home.base + rotors[0] / BASE_SHOULDER_STEPS,
            home.shoulder - rotors[1] / BASE_SHOULDER_STEPS,
            home.elbow + rotors[2] / ELBOW_STEPS,
            (left + right) / 2,
            (left - right) / 2,
        )

    def cable(self, rotors: Sequence[int]) -> int:
        """Half-steps of hand cable paid out: raising the forearm pays out like the hand motor."""
        return self.home_cable + rotors[5] + rotors[2]

    def rotors(self, angles: JointAngles, cable: int) -> tuple[int, ...]:
        """Rotor positions nearest to joint angles (radians) and hand cable (half-steps)."""
        home = self.home
        elbow = round((angles.elbow - home.elbow) * ELBOW_STEPS)
        return (
            round((angles.base - home.base) * BASE_SHOULDER_STEPS),
            round((home.shoulder - angles.shoulder) * BASE_SHOULDER_STEPS),
            elbow,
            round((home.left_gear - angles.left_gear) * WRIST_STEPS),
            round((angles.right_gear - home.right_gear) * WRIST_STEPS),
            cable - self.home_cable - elbow,
        )
