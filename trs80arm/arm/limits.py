"""How far and how heavily: the stops of the joints and the loads on the motors.

`MiniMover` asks before each half-step whether a joint is at its stop, and how much of a motor's
full load the part in the hand puts on it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from trs80arm.arm.geometry import (
    BASE_LIMIT,
    BASE_SHOULDER_STEPS,
    ELBOW_LIMITS,
    ELBOW_STEPS,
    GEAR_LIMIT,
    HAND_LENGTH,
    HAND_RANGE,
    HAND_STEPS,
    LINK,
    PITCH_LIMIT,
    REACH,
    SHOULDER_LIMITS,
    WRIST_STEPS,
    CableDrive,
    JointAngles,
)
from trs80arm.arm.motors import POUND_STEPS

FULL_LOAD = 8.0
"""Ounces at full extension (Table 1)."""
FULL_GRIP = 3.0
"""Pounds at which the hand motor gives up (Table 1)."""
MOST_SQUEEZE = round(FULL_GRIP * POUND_STEPS)
"""The same in half-steps of cable."""

_HAIR = 1e-9


def beyond_stop(
    motor: int, step: int, drive: CableDrive, rotors: Sequence[int], slack: int = 0
) -> str | None:
    """Whether a motor has turned a joint past its stop.

    Only stops that the motor moves towards count: a joint may always come back. The limits of
    the forearm are relative to the upper arm, so the shoulder meets them too (article, joint 3).

    Args:
        motor: that moves, 0 to 5.
        step: its direction, 1 or -1.
        drive: the cables.
        rotors: positions after the move.
        slack: half-steps that are forgiven.

    Returns:
        The stop's description, or None.
    """
    if motor == 5:
        over = drive.cable(rotors) > HAND_RANGE * HAND_STEPS + slack
        return "hand 0 to 3 in" if step > 0 and over else None
    a = drive.angles(rotors)
    hair = _HAIR + slack / 200.0
    if motor == 0:
        return "base +-90" if a.base * step > BASE_LIMIT + hair else None
    if motor == 1:
        if step < 0 and a.shoulder > SHOULDER_LIMITS[1] + hair:
            return "shoulder +144"
        if step > 0 and a.shoulder < SHOULDER_LIMITS[0] - hair:
            return "shoulder -35"
    if motor in (1, 2):
        bend = a.elbow - a.shoulder
        if step > 0 and bend > ELBOW_LIMITS[1] + hair:
            return "elbow 0"
        if step < 0 and bend < ELBOW_LIMITS[0] - hair:
            return "elbow -149"
        if motor == 1:
            return None
        bend = a.pitch - a.elbow
        if bend * step < -PITCH_LIMIT - hair:
            return "pitch +-90"
        return None
    gear = a.left_gear if motor == 3 else a.right_gear
    up = -step if motor == 3 else step
    if gear * up > GEAR_LIMIT + hair:
        return "wrist gear +-270"
    if (a.pitch - a.elbow) * up > PITCH_LIMIT + hair:
        return "pitch +-90"
    return None


def beyond_any_stop(drive: CableDrive, rotors: Sequence[int]) -> str | None:
    """Description of a stop that the arm is more than a half-step beyond, or None."""
    for motor in range(5):
        for step in (-1, 1):
            stop = beyond_stop(motor, step, drive, rotors, slack=1)
            if stop is not None:
                return stop
    return None


def load_fraction(motor: int, turn: int, angles: JointAngles, weight: float, squeeze: int) -> float:
    """Torque on a motor as a fraction of its full load; 0 where the load helps.

    By virtual work a weight at the hand resists the shoulder and the elbow drive with 7 inches
    times the cosine of the link's angle, which is why half extension carries twice as much
    (Table 1); the wrist with 3.5 inches. The base has no weight to lift, but inertia to turn:
    its load is the weight times its distance from the base axis.

    Args:
        motor: 0 base to 5 hand.
        turn: direction of the field, positive down Figure 8.
        angles: of the joints, radians.
        weight: in the hand, ounces.
        squeeze: half-steps of cable taken up since the fingers met.
    """
    if motor == 5:
        return squeeze / MOST_SQUEEZE if turn < 0 else 0.0
    if weight <= 0 or turn == 0:
        return 0.0
    part = weight / FULL_LOAD
    if motor == 0:
        upper, fore = _cosine(angles.shoulder), _cosine(angles.elbow)
        reach = LINK * upper + LINK * fore + HAND_LENGTH * _cosine(angles.pitch)
        return part * abs(reach) / REACH
    angle = angles.shoulder if motor == 1 else angles.elbow if motor == 2 else angles.pitch
    return max(0.0, part * _cosine(angle) * (_LIFTS[motor] if turn > 0 else -_LIFTS[motor]))


def load_fractions(
    motor: int,
    turns: npt.NDArray[np.int64],
    drive: CableDrive,
    rotors: npt.NDArray[np.int64],
    weight: float,
    squeeze: npt.NDArray[np.int64],
) -> npt.NDArray[np.float64]:
    """`load_fraction` for many writes to one motor, equal to the last bit.

    Args:
        motor: 0 base to 5 hand.
        turns: directions, one for each write.
        drive: the cables.
        rotors: positions before each write, shape (writes, 6).
        weight: in the hand, ounces.
        squeeze: half-steps taken up before each write.
    """
    if motor == 5:
        return np.where(turns < 0, squeeze / MOST_SQUEEZE, 0.0)
    if weight <= 0:
        return np.zeros(len(turns))
    home = drive.home
    part = weight / FULL_LOAD
    shoulder = home.shoulder - rotors[:, 1] / BASE_SHOULDER_STEPS
    elbow = home.elbow + rotors[:, 2] / ELBOW_STEPS
    left = home.pitch + home.roll - rotors[:, 3] / WRIST_STEPS
    right = home.pitch - home.roll + rotors[:, 4] / WRIST_STEPS
    pitch = (left + right) / 2
    if motor == 0:
        reach = LINK * _cosines(shoulder) + LINK * _cosines(elbow) + HAND_LENGTH * _cosines(pitch)
        return np.where(turns == 0, 0.0, part * np.abs(reach) / REACH)
    angle = shoulder if motor == 1 else elbow if motor == 2 else pitch
    load = part * _cosines(angle) * np.where(turns > 0, _LIFTS[motor], -_LIFTS[motor])
    return np.where(turns == 0, 0.0, np.maximum(0.0, load))


_LIFTS = (0, -1, 1, -1, 1)
"""Whether a positive count raises (1) or lowers (-1) what the motor moves (facts 4)."""

# A table instead of math.cos and numpy.cos, which differ in the last bit on some machines.
_TURN = 4096
_COSINES = tuple(math.cos(2 * math.pi * i / _TURN) for i in range(_TURN))
_COSINE_ARRAY = np.array(_COSINES)
_PER_RADIAN = _TURN / (2 * math.pi)


def _cosine(angle: float) -> float:
    """Cosine to about a thousandth, the same for one angle and for arrays."""
    return _COSINES[math.floor(angle * _PER_RADIAN + 0.5) % _TURN]


def _cosines(angles: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """`_cosine` of many angles."""
    index = np.floor(angles * _PER_RADIAN + 0.5).astype(np.int64) % _TURN
    return _COSINE_ARRAY[index]
