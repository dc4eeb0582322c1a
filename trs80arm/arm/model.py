"""What an arm is, as data: links, drives, ranges, weights and hand of one make of arm.

Everything that tells one arm from another stands in an `ArmModel`; kinematics, stops, motors,
forces and hand take it, and no figure of any arm is named outside `models/`. Here is also the one
way from rotors to joints and back, for one position and for arrays of them.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from enum import IntEnum
from typing import Any

import numpy as np
import numpy.typing as npt

Rotors = Sequence[int] | npt.NDArray[np.int64]
"""Half-steps of six motors; or six arrays of them, as one array."""
Signs = tuple[tuple[int, int], ...]
"""Latches, each with how its half-steps count in a sum."""


class Motor(IntEnum):
    """What the six latches' motors turn, in the order of the MiniMover's J1 to J6."""

    BASE = 0
    SHOULDER = 1
    ELBOW = 2
    LEFT_WRIST = 3
    RIGHT_WRIST = 4
    HAND = 5


BASE, SHOULDER, ELBOW, LEFT_WRIST, RIGHT_WRIST, HAND = Motor
"""The same for what asks at every write: a class of enumeration takes long to say who is who."""


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
class Drive:
    """One motor with its gearing and cable.

    Attributes:
        turns: what it turns. Its place in `ArmModel.drives` is its latch.
        steps: half-steps per radian; per inch of opening for the hand.
        sign: 1 where a positive count raises the angle (counter-clockwise, up) or opens the
            hand, -1 where it lowers it.
        no_load_rate: half-steps per second that it is listed to make with nothing in the hand.
        full_load_rate: the same with the arm's full load at full extension; the hand's against
            its greatest force.
        winds: inches of cable that its drum winds with a half-step.
    """

    turns: Motor
    steps: float
    sign: int
    no_load_rate: float
    full_load_rate: float
    winds: float

    @property
    def pulley(self) -> float:
        """The radius of the joint's pulley, inches; for the hand, inches of cable per inch."""
        return self.steps * self.winds


@dataclass(frozen=True, slots=True)
class Limits:
    """How far the joints go, radians.

    Attributes:
        base: either way from the x axis.
        shoulder: lowest and highest angle to the horizontal.
        elbow: of the forearm, relative to the upper arm.
        pitch: of the hand, either way from the forearm.
        gear: of each wrist gear, either way from the horizontal.
    """

    base: float
    shoulder: tuple[float, float]
    elbow: tuple[float, float]
    pitch: float
    gear: float


@dataclass(frozen=True, slots=True)
class Hand:
    """The hand and its cable.

    Attributes:
        range: widest opening, inches.
        pound_steps: half-steps of cable per pound of gripping force.
        full_grip: pounds at which its motor gives up.
        switch_force: pounds at which the tension switch closes.
        finger_length: fingertip to finger root along the hand, inches.
    """

    range: float
    pound_steps: float
    full_grip: float
    switch_force: float
    finger_length: float

    @property
    def most_squeeze(self) -> int:
        """Half-steps of cable from the first touch to the full grip."""
        return round(self.full_grip * self.pound_steps)

    @property
    def switch_steps(self) -> int:
        """Half-steps of cable from the first touch to the closing of the switch."""
        return math.ceil(self.switch_force * self.pound_steps)


class Link(IntEnum):
    """The pieces of an arm that take up room."""

    UPPER_ARM = 0
    FOREARM = 1
    HAND = 2
    LEFT_FINGER = 3
    RIGHT_FINGER = 4


@dataclass(frozen=True, slots=True)
class LinkSolid:
    """A box that is part of a link.

    Attributes:
        name: what it is called where it touches something.
        link: of which it is part.
        center: in the link's frame, inches: along the link from its joint (for a finger, from the
            fingertip), across to its left, and up. A finger's frame lies on its inner face.
        half: half its size along the same axes, inches.
    """

    name: str
    link: Link
    center: tuple[float, float, float]
    half: tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Weights:
    """What the moving links weigh.

    Attributes:
        upper_arm, forearm, hand: ounces.
        upper_arm_at, forearm_at, hand_at: their centres of mass, inches along the link from
            shoulder, elbow and wrist.
    """

    upper_arm: float
    upper_arm_at: float
    forearm: float
    forearm_at: float
    hand: float
    hand_at: float


@dataclass(frozen=True)
class ArmModel:
    """One make of arm.

    Attributes:
        name: by which it is chosen.
        title: what people call it.
        sources: where each figure comes from, by attribute.
        shoulder_height: H, of the shoulder axis above the table, inches.
        link: L, shoulder to elbow and elbow to wrist, inches.
        hand_length: LL, wrist to fingertip, inches.
        drives: of the six motors, in the order of their latches: base, shoulder, elbow, the two
            wrist gears in whichever order, hand.
        elbow_pays_out: half-steps of hand cable that a positive half-step of the elbow's motor
            pays out; negative where it pulls in.
        compensated: whether the arm's language takes the hand along with the elbow by itself.
        limits: where the joints end.
        hand: the gripper.
        full_load: ounces that it carries at full extension.
        static_force: ounces that it bears at the hand, standing with its motors on.
        weights: of the links.
        stiffness: of the cables, by `Motor`: ounce-inches per radian, ounces per inch of opening.
        solids: the room that the links take up.
        start: the pose in which it is switched on.
    """

    name: str
    title: str
    shoulder_height: float
    link: float
    hand_length: float
    drives: tuple[Drive, ...]
    elbow_pays_out: int
    compensated: bool
    limits: Limits
    hand: Hand
    full_load: float
    static_force: float
    weights: Weights
    stiffness: tuple[float, float, float, float, float, float]
    solids: tuple[LinkSolid, ...]
    start: Pose
    sources: tuple[tuple[str, str], ...] = ()
    _motor_of: tuple[int, ...] = field(init=False, repr=False, compare=False)
    _scales: tuple[tuple[int, int, float], ...] = field(init=False, repr=False, compare=False)
    _pays_out: Signs = field(init=False, repr=False, compare=False)
    _gears: Mapping[int, Signs] = field(init=False, repr=False, compare=False)
    _names: tuple[str, ...] = field(init=False, repr=False, compare=False)
    _finest: float = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        turned = [drive.turns for drive in self.drives]
        wrists = {Motor.LEFT_WRIST, Motor.RIGHT_WRIST}
        arm = [Motor.BASE, Motor.SHOULDER, Motor.ELBOW]
        if turned[:3] != arm or {*turned[3:5]} != wrists or turned[5:] != [Motor.HAND]:
            raise ValueError(
                f"{self.name}: the drives are base, shoulder, elbow, both wrists, hand: "
                "@STEP counts them so, and @CLOSE drives the sixth"
            )
        order = tuple(
            next(latch for latch, drive in enumerate(self.drives) if drive.turns is motor)
            for motor in Motor
        )
        object.__setattr__(self, "_motor_of", order)
        scales = tuple((m, self.drives[m].sign, self.drives[m].steps) for m in order[:5])
        object.__setattr__(self, "_scales", scales)
        pays_out = (self.latch(Motor.HAND), 1), (self.latch(Motor.ELBOW), self.elbow_pays_out)
        object.__setattr__(self, "_pays_out", pays_out)
        left, right = self.latch(Motor.LEFT_WRIST), self.latch(Motor.RIGHT_WRIST)
        signs = self.drives[left].sign, self.drives[right].sign
        both = {side: ((left, signs[0]), (right, side * signs[1])) for side in (1, -1)}
        object.__setattr__(self, "_gears", both)
        names = tuple(drive.turns.name.lower().replace("_", " ") for drive in self.drives)
        object.__setattr__(self, "_names", names)
        object.__setattr__(self, "_finest", min(drive.steps for drive in self.drives[:5]))

    @property
    def reach(self) -> float:
        """From the shoulder to the fingertip of the stretched arm, inches."""
        return self.link + self.link + self.hand_length

    @property
    def motor_names(self) -> tuple[str, ...]:
        """What people call the six motors, in the order of their latches."""
        return self._names

    @property
    def finest_steps(self) -> float:
        """Half-steps a radian of the motor that turns its joint farthest with one."""
        return self._finest

    @property
    def hand_per_elbow(self) -> int:
        """Half-steps that @STEP gives the hand with each one of the elbow, uncounted."""
        return -self.elbow_pays_out if self.compensated else 0

    def latch(self, motor: Motor) -> int:
        """The latch of the motor that turns something."""
        return self._motor_of[motor]

    @property
    def hand_steps(self) -> float:
        """Half-steps of cable per inch of opening."""
        return self.drives[HAND].steps

    @property
    def pays_out(self) -> Signs:
        """How half-steps count in the hand's cable, by latch."""
        return self._pays_out

    def gears(self, side: int) -> Signs:
        """How half-steps of the wrist's gears count in twice what they turn the hand by, by latch.

        Args:
            side: 1 for pitch, -1 for roll.
        """
        return self._gears[side]

    # Rotors and joints

    def turned(self, rotors: Rotors) -> tuple[Any, Any, Any, Any, Any]:
        """How far counts of half-steps turn the joints.

        Args:
            rotors: half-steps of the six motors; or arrays of them, one array a motor.

        Returns:
            Radians of base, upper arm, forearm (both to the horizontal), left and right wrist
            gear; arrays for arrays, equal to the last bit.
        """
        (a, i, s), (b, j, t), (c, k, u), (d, m, v), (e, n, w) = self._scales
        return (
            i * rotors[a] / s,
            j * rotors[b] / t,
            k * rotors[c] / u,
            m * rotors[d] / v,
            n * rotors[e] / w,
        )

    def turned_alone(self, motor: Motor, rotors: Rotors) -> Any:
        """What `turned` has for one motor of the arm."""
        latch, sign, steps = self._scales[motor]
        return sign * rotors[latch] / steps

    def counts(self, turns: Sequence[float]) -> tuple[int, int, int, int, int]:
        """The inverse of `turned`: counts of the five arm motors nearest to some radians."""
        counts = [0] * 5
        for (latch, sign, steps), turn in zip(self._scales, turns, strict=True):
            counts[latch] = sign * round(turn * steps)
        one, two, three, four, five = counts
        return one, two, three, four, five

    def paid_out(self, rotors: Rotors) -> Any:
        """Half-steps of hand cable that counts of the motors pay out; arrays for arrays."""
        return rotors[HAND] + self.elbow_pays_out * rotors[ELBOW]
