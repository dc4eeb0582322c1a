"""Weight, load, pushing and pressing as torque at the rotors.

Torques are taken at the joints, in ounce-inches (ounces at the fingers for the hand), and by
virtual work: a force does on a drive what it does along the way that the drive moves its point.
The cables make that simple. Shoulder, forearm and hand are driven in angles to the horizontal, so
the shoulder carries what hangs beyond the elbow on 7 inches wherever it hangs.

A motor turns against a torque at a rate up to where its torque, which falls with the square of
the rate, is used up; standing, it holds more, and without current the friction of its gears does.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from trs80arm.arm.contact.clock import T_STATES_PER_SECOND
from trs80arm.arm.geometry import JointAngles, forward
from trs80arm.arm.model import BASE, ELBOW, HAND, LEFT_WRIST, SHOULDER, ArmModel, Link, Motor
from trs80arm.arm.trigonometry import sin_cos

NEVER = 1 << 40
"""Period, in T-states, of a motor whose load is more than it can move."""
BY_THEMSELVES = (SHOULDER, ELBOW)
"""What bears its load at its own angle, wherever the others are."""

Vector = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Burden:
    """Something that rests in the hand.

    Attributes:
        weight: ounces.
        place: its centre of mass from the fingertip, along the hand's axes (pointing, across, and
            their product), inches.
    """

    weight: float
    place: Vector


@dataclass(frozen=True, slots=True)
class Curve:
    """What a motor has at its rate: torque falls with the square of the rate.

    Attributes:
        idle: half-steps per second, squared, that it makes against no torque at all.
        fall: by how much the square of the rate falls with each unit of torque.
        stall: torque at which it cannot turn any more.
        holds: torque that it holds, standing, with its current on.
        friction: torque that its gears hold without current.
    """

    idle: float
    fall: float
    stall: float
    holds: float
    friction: float

    def period(self, torque: float, margin: float) -> int:
        """T-states that it needs for a half-step.

        Args:
            torque: that it turns against; 0 where the torque helps it.
            margin: multiple of the rate at which it drops out.
        """
        square = self.idle - self.fall * torque
        rate = margin * math.sqrt(square) if square > 1.0 else 0.0
        return int(T_STATES_PER_SECOND / rate) if rate > 1.0 else NEVER

    def has(self, rate: float) -> float:
        """Torque that it has at a rate, half-steps per second; at least 0."""
        return min(self.stall, max(0.0, (self.idle - rate * rate) / self.fall))

    def used(self, torque: float, rate: float) -> float:
        """Which share of what it has a torque and a rate take together.

        At 1 it just keeps up: `period` is then the time from pulse to pulse, or the torque is all
        that it can turn.

        Args:
            torque: that it turns against; 0 where the torque helps it.
            rate: half-steps per second, as a motor of no other than the listed speed would make.
        """
        share, of_stall = (self.fall * torque + rate * rate) / self.idle, torque / self.stall
        return share if share > of_stall else of_stall

    def uses(
        self, torques: npt.NDArray[np.float64], rates: npt.NDArray[np.float64]
    ) -> npt.NDArray[np.float64]:
        """`used` for arrays, equal to the last bit."""
        shares = (self.fall * torques + rates * rates) / self.idle
        return np.maximum(shares, torques / self.stall)

    def periods(self, torques: npt.NDArray[np.float64], margin: float) -> npt.NDArray[np.int64]:
        """`period` for an array of torques, equal to the last T-state."""
        square = self.idle - self.fall * torques
        rate = margin * np.sqrt(np.maximum(square, 0.0))
        able = (square > 1.0) & (rate > 1.0)
        periods = np.full(len(torques), NEVER, dtype=np.int64)
        periods[able] = (T_STATES_PER_SECOND / rate[able]).astype(np.int64)
        return periods


@dataclass(frozen=True, slots=True)
class Strength:
    """What an arm's motors can do, and what its own weight asks of them, by `Motor`.

    Attributes:
        model: of the arm.
        own: torque of the arm's own weight with every link level.
        curves: of the motors.
    """

    model: ArmModel
    own: tuple[float, ...]
    curves: tuple[Curve, ...]

    @classmethod
    def of(cls, model: ArmModel) -> Strength:
        """Work it out from the model: its weights, and the two listed rates of each motor.

        The rate without load is the one with the arm's own weight at full extension, the other
        with the full load beside it; the base, which lifts nothing, has the shoulder's motor and
        gearing, hence its stalling torque.
        """
        weights, link = model.weights, model.link
        beyond = weights.forearm + weights.hand
        own = (
            0.0,
            weights.upper_arm * weights.upper_arm_at + beyond * link,
            weights.forearm * weights.forearm_at + weights.hand * link,
            weights.hand * weights.hand_at / 2,
            weights.hand * weights.hand_at / 2,
            0.0,
        )
        levers = (0.0, link, link, model.hand_length / 2, model.hand_length / 2, 0.0)
        curves: dict[Motor, Curve] = {}
        for motor in (SHOULDER, BASE, *list(Motor)[2:]):
            drive = model.drives[model.latch(motor)]
            free, full = drive.no_load_rate**2, drive.full_load_rate**2
            if motor is BASE:
                shoulder = curves[SHOULDER]
                load = shoulder.stall * (free - full) / free
                holds, friction = shoulder.holds, shoulder.friction
                fall = (free - full) / load
                curves[motor] = Curve(free, fall, free / fall, holds, friction)
                continue
            load = model.full_load * levers[motor]
            if motor is HAND:
                load = 16 * model.hand.full_grip
            fall = (free - full) / load
            idle = free + fall * own[motor]
            stall = idle / fall
            holds = own[motor] + model.static_force * levers[motor]
            if motor is HAND:
                holds = stall = 16 * model.hand.full_grip
                curves[motor] = Curve(idle, fall, stall, holds, holds)
                continue
            curves[motor] = Curve(idle, fall, stall, holds, holds - stall)
        return cls(model, own, tuple(curves[motor] for motor in Motor))

    @property
    def base_drag(self) -> float:
        """Torque on the base for each ounce-inch of load and distance from its axis."""
        base = self.curves[BASE]
        drive = self.model.drives[self.model.latch(BASE)]
        full = (drive.no_load_rate**2 - drive.full_load_rate**2) / base.fall
        return full / (self.model.full_load * self.model.reach)

    def weight(
        self,
        motor: Motor,
        driven: Sequence[Any],
        burdens: Sequence[Burden],
        cosine: Callable[[Any], Any],
    ) -> Any:
        """Torque with which own weight and load pull a motor's angle down.

        For the base, which has nothing to lift: the drag of what it carries, either way.

        Args:
            motor: that bears it.
            driven: angles of base, upper arm, forearm, left and right gear in radians; or arrays
                of them.
            burdens: what is in the hand.
            cosine: `cosine`, or `cosines` for arrays.
        """
        if motor is HAND or (motor is BASE and not burdens):
            return 0.0 * driven[0]
        loads = sum(burden.weight for burden in burdens)
        link = self.model.link
        if motor in (SHOULDER, ELBOW):
            return self.level(motor, burdens) * cosine(driven[motor])
        pitch = (driven[3] + driven[4]) / 2
        if motor is BASE:
            reach = link * cosine(driven[1]) + link * cosine(driven[2])
            return self.base_drag * loads * abs(reach + self.model.hand_length * cosine(pitch))
        torque = self.own[motor] * cosine(pitch)
        if not burdens:
            return torque
        roll = (driven[3] - driven[4]) / 2
        side = 0.5 if motor is LEFT_WRIST else -0.5
        sp, cp = cosine(pitch - _QUARTER), cosine(pitch)
        sr, cr = cosine(roll - _QUARTER), cosine(roll)
        for burden in burdens:
            ahead, across, up = burden.place
            pitching = (self.model.hand_length + ahead) * cp - (across * sr + up * cr) * sp
            rolling = (across * cr - up * sr) * cp
            torque = torque + burden.weight * (0.5 * pitching + side * rolling)
        return torque

    def level(self, motor: Motor, burdens: Sequence[Burden]) -> float:
        """Torque of own weight and load on shoulder or elbow with the link level."""
        if not burdens:
            return self.own[motor]
        return self.own[motor] + sum([burden.weight for burden in burdens]) * self.model.link

    def most(
        self, motor: Motor, burdens: Sequence[Burden], level: Vector = (1.0, 1.0, 1.0)
    ) -> float:
        """The most that `weight` can be, either way.

        Args:
            motor: that bears it.
            burdens: what is in the hand.
            level: the greatest cosine, either way, that the angles of upper arm, forearm and hand
                to the horizontal have.
        """
        upper, fore, hand = level
        loads = sum(burden.weight for burden in burdens)
        model = self.model
        if motor is BASE:
            reach = model.link * (upper + fore) + model.hand_length * hand
            return self.base_drag * loads * reach
        if motor is HAND:
            return 0.0
        if motor in (SHOULDER, ELBOW):
            return self.level(motor, burdens) * (upper if motor is SHOULDER else fore)
        torque = self.own[motor] * hand
        for burden in burdens:
            ahead, across, up = (abs(value) for value in burden.place)
            pitching = 0.5 * (model.hand_length + ahead) * hand
            torque += burden.weight * (pitching + 0.5 * (across + up) * (1 + hand))
        return torque


def torques(
    model: ArmModel, angles: JointAngles, link: Link, place: Vector, force: Vector
) -> tuple[float, float, float, float, float, float]:
    """What a force on the arm does to its motors, by virtual work.

    Args:
        model: of the arm.
        angles: of the joints, radians.
        link: on which it acts.
        place: where, inches.
        force: ounces.

    Returns:
        Ounce-inches by `Motor`, 0 for the hand's; positive where it pushes the angle up.
    """
    points = forward(model, angles)
    s, c = sin_cos(angles.base)
    ahead_force = force[0] * c + force[1] * s

    def about(joint: Vector, end: Vector) -> float:
        # A turn in the arm's own plane about a joint: what is ahead of it goes up.
        ahead = (end[0] - joint[0]) * c + (end[1] - joint[1]) * s
        return force[2] * ahead - ahead_force * (end[2] - joint[2])

    base = force[1] * place[0] - force[0] * place[1]
    if link is Link.UPPER_ARM:
        return base, about(points.shoulder, place), 0.0, 0.0, 0.0, 0.0
    # A link swings what hangs on its end about without turning it.
    shoulder = about(points.shoulder, points.elbow)
    if link is Link.FOREARM:
        return base, shoulder, about(points.elbow, place), 0.0, 0.0, 0.0
    elbow = about(points.elbow, points.wrist)
    pitch = about(points.wrist, place)
    ux, uy, uz = points.pointing
    wx, wy, wz = points.wrist
    dx, dy, dz = place[0] - wx, place[1] - wy, place[2] - wz
    roll = (
        force[0] * (uy * dz - uz * dy)
        + force[1] * (uz * dx - ux * dz)
        + force[2] * (ux * dy - uy * dx)
    )
    return base, shoulder, elbow, (pitch + roll) / 2, (pitch - roll) / 2, 0.0


# A table instead of polynomials: a load need not be known better, and one lookup is quick.
_TURN = 4096
_COARSE = math.pi / _TURN
_QUARTER = math.pi / 2
_TURNED = 2 * math.pi
_COSINES = tuple(sin_cos(2 * math.pi * i / _TURN)[1] for i in range(_TURN))
_COSINE_ARRAY = np.array(_COSINES)
_PER_RADIAN = _TURN / (2 * math.pi)


def nearest_and_farthest(low: float, high: float) -> tuple[float, float]:
    """The greatest and the least `cosine` of the angles from low to high, or a little beyond."""
    low, high = low - _COARSE, high + _COARSE
    ends = sin_cos(low)[1], sin_cos(high)[1]
    greatest, least = max(ends), min(ends)
    if math.floor(low / _TURNED) != math.floor(high / _TURNED):
        greatest = 1.0
    if math.floor((low + math.pi) / _TURNED) != math.floor((high + math.pi) / _TURNED):
        least = -1.0
    return greatest, least


def cosine(angle: float) -> float:
    """Cosine to about a thousandth, the same for one angle and for arrays."""
    return _COSINES[math.floor(angle * _PER_RADIAN + 0.5) % _TURN]


def cosines(angles: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """`cosine` of many angles."""
    index = np.floor(angles * _PER_RADIAN + 0.5).astype(np.int64) % _TURN
    return _COSINE_ARRAY[index]
