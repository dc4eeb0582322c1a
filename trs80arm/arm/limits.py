"""How far and how heavily: the stops of the joints and the loads on the motors.

`MiniMover` asks before each half-step whether a joint is at its stop, and how much of a motor's
full load the part in the hand puts on it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from trs80arm.arm.geometry import CableDrive, JointAngles
from trs80arm.arm.model import ArmModel, Motor
from trs80arm.arm.trigonometry import sin_cos

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
    model = drive.model
    limits, turned = model.limits, model.drives[motor]
    turns, up = turned.turns, step * turned.sign
    if turns is Motor.HAND:
        over = drive.cable(rotors) > model.hand.range * model.hand_steps + slack
        return f"hand 0 to {model.hand.range:g} in" if up > 0 and over else None
    a = drive.angles(rotors)
    hair = _HAIR + slack / 200.0
    if turns is Motor.BASE:
        return f"base +-{_degrees(limits.base)}" if a.base * up > limits.base + hair else None
    if turns is Motor.SHOULDER:
        low, high = limits.shoulder
        if up > 0 and a.shoulder > high + hair:
            return f"shoulder {_degrees(high):+}"
        if up < 0 and a.shoulder < low - hair:
            return f"shoulder {_degrees(low):+}"
    if turns in (Motor.SHOULDER, Motor.ELBOW):
        low, high = limits.elbow
        bend = a.elbow - a.shoulder
        # Raising the upper arm bends the elbow as lowering the forearm does.
        opening = up if turns is Motor.ELBOW else -up
        if opening > 0 and bend > high + hair:
            return f"elbow {_degrees(high)}"
        if opening < 0 and bend < low - hair:
            return f"elbow {_degrees(low)}"
        if turns is Motor.SHOULDER:
            return None
        if (a.pitch - a.elbow) * up < -limits.pitch - hair:
            return f"pitch +-{_degrees(limits.pitch)}"
        return None
    gear = a.left_gear if turns is Motor.LEFT_WRIST else a.right_gear
    if gear * up > limits.gear + hair:
        return f"wrist gear +-{_degrees(limits.gear)}"
    if (a.pitch - a.elbow) * up > limits.pitch + hair:
        return f"pitch +-{_degrees(limits.pitch)}"
    return None


def _degrees(radians: float) -> int:
    """Whole degrees, as stops are called."""
    return round(math.degrees(radians))


def beyond_any_stop(drive: CableDrive, rotors: Sequence[int]) -> str | None:
    """Description of a stop that the arm is more than a half-step beyond, or None."""
    for motor in range(5):
        for step in (-1, 1):
            stop = beyond_stop(motor, step, drive, rotors, slack=1)
            if stop is not None:
                return stop
    return None


def load_fraction(
    motor: int, turn: int, model: ArmModel, angles: JointAngles, weight: float, squeeze: int
) -> float:
    """Torque on a motor as a fraction of its full load; 0 where the load helps.

    By virtual work a weight at the hand resists the shoulder and the elbow drive with 7 inches
    times the cosine of the link's angle, which is why half extension carries twice as much
    (Table 1); the wrist with 3.5 inches. The base has no weight to lift, but inertia to turn:
    its load is the weight times its distance from the base axis.

    Args:
        motor: 0 base to 5 hand.
        turn: direction of the field, positive down Figure 8.
        model: of the arm.
        angles: of the joints, radians.
        weight: in the hand, ounces.
        squeeze: half-steps of cable taken up since the fingers met.
    """
    drive = model.drives[motor]
    if drive.turns is Motor.HAND:
        return squeeze / model.hand.most_squeeze if turn < 0 else 0.0
    if weight <= 0 or turn == 0:
        return 0.0
    part = weight / model.full_load
    if drive.turns is Motor.BASE:
        upper, fore = _cosine(angles.shoulder), _cosine(angles.elbow)
        reach = model.link * upper + model.link * fore + model.hand_length * _cosine(angles.pitch)
        return part * abs(reach) / model.reach
    turns = drive.turns
    angle = (
        angles.shoulder
        if turns is Motor.SHOULDER
        else angles.elbow
        if turns is Motor.ELBOW
        else angles.pitch
    )
    return max(0.0, part * _cosine(angle) * (drive.sign if turn > 0 else -drive.sign))


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
    model, home = drive.model, drive.home
    moved = model.drives[motor]
    if moved.turns is Motor.HAND:
        return np.where(turns < 0, squeeze / model.hand.most_squeeze, 0.0)
    if weight <= 0:
        return np.zeros(len(turns))
    part = weight / model.full_load
    _, b, c, d, e = model.turned(rotors.T)
    shoulder, elbow = home.shoulder + b, home.elbow + c
    pitch = ((home.left_gear + d) + (home.right_gear + e)) / 2
    if moved.turns is Motor.BASE:
        reach = (
            model.link * _cosines(shoulder)
            + model.link * _cosines(elbow)
            + model.hand_length * _cosines(pitch)
        )
        return np.where(turns == 0, 0.0, part * np.abs(reach) / model.reach)
    angle = (
        shoulder
        if moved.turns is Motor.SHOULDER
        else elbow
        if moved.turns is Motor.ELBOW
        else pitch
    )
    load = part * _cosines(angle) * np.where(turns > 0, moved.sign, -moved.sign)
    return np.where(turns == 0, 0.0, np.maximum(0.0, load))


# A table instead of math.cos and numpy.cos, which differ in the last bit on some machines.
_TURN = 4096
_COSINES = tuple(sin_cos(2 * math.pi * i / _TURN)[1] for i in range(_TURN))
_COSINE_ARRAY = np.array(_COSINES)
_PER_RADIAN = _TURN / (2 * math.pi)


def _cosine(angle: float) -> float:
    """Cosine to about a thousandth, the same for one angle and for arrays."""
    return _COSINES[math.floor(angle * _PER_RADIAN + 0.5) % _TURN]


def _cosines(angles: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """`_cosine` of many angles."""
    index = np.floor(angles * _PER_RADIAN + 0.5).astype(np.int64) % _TURN
    return _COSINE_ARRAY[index]
