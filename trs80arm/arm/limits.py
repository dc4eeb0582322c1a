"""How far and how heavily: the stops of the joints and the loads on the motors.

`MiniMover` asks before each half-step whether a joint is at its stop, and how much of a motor's
full load the part in the hand puts on it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from trs80arm.arm.geometry import (
    BASE_LIMIT,
    ELBOW_LIMITS,
    GEAR_LIMIT,
    HAND_LENGTH,
    HAND_RANGE,
    HAND_STEPS,
    LINK,
    PITCH_LIMIT,
    REACH,
    SHOULDER_LIMITS,
    CableDrive,
    JointAngles,
)

FULL_LOAD = 8.0
"""Ounces at full extension (Table 1)."""
FULL_GRIP = 3.0
"""Pounds at which the hand motor gives up (Table 1)."""

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


def load_fraction(motor: int, turn: int, angles: JointAngles, weight: float, force: float) -> float:
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
        force: of the grip, pounds.
    """
    if motor == 5:
        return force / FULL_GRIP if turn < 0 else 0.0
    if weight <= 0:
        return 0.0
    part = weight / FULL_LOAD
    if motor == 0:
        reach = (
            LINK * math.cos(angles.shoulder)
            + LINK * math.cos(angles.elbow)
            + HAND_LENGTH * math.cos(angles.pitch)
        )
        return part * abs(reach) / REACH
    if motor == 1:
        lever, up = math.cos(angles.shoulder), -turn
    elif motor == 2:
        lever, up = math.cos(angles.elbow), turn
    else:
        lever, up = math.cos(angles.pitch), -turn if motor == 3 else turn
    return max(0.0, part * lever * (1 if up > 0 else -1))
