"""The operator's hands: with its motors off an arm is put wherever they want it."""

from __future__ import annotations

import math
from dataclasses import fields, replace
from typing import TYPE_CHECKING

from trs80arm.arm.geometry import JointAngles
from trs80arm.arm.limits import beyond_any_stop

if TYPE_CHECKING:
    from trs80arm.arm.minimover import MiniMover

TURNED_BY_HAND = (*(angle.name for angle in fields(JointAngles)), "hand")
"""What the operator's hands can turn one by one."""
STRONGEST = 1000.0
"""Ounces that an operator pulls by at most."""


class MotorsOn(Exception):  # noqa: N818 (says what is, like OutOfReach)
    """The arm cannot be moved by hand while a motor holds it."""


class InTheWay(Exception):  # noqa: N818 (says what is, like OutOfReach)
    """Something on the bench is where the arm was to be moved by hand."""


def turned(arm: MiniMover, joint: str, value: float) -> tuple[JointAngles, int]:
    """Angles and hand cable of an arm once one joint has been turned.

    Args:
        arm: as it stands.
        joint: one of `TURNED_BY_HAND`.
        value: degrees, or inches of the hand's opening.

    Raises:
        ValueError: if the joint does not go that far, or there is no such joint.
    """
    if not math.isfinite(value):
        raise ValueError(f"{value} is nowhere")
    angles, cable = arm.drive.angles(arm.rotors), arm.drive.cable(arm.rotors)
    if joint == "hand":
        return angles, cable_for(arm, value)
    if joint not in TURNED_BY_HAND:
        raise ValueError(f"no joint {joint}: {', '.join(TURNED_BY_HAND[:-1])} or hand")
    return replace(angles, **{joint: math.radians(value)}), cable


def cable_for(arm: MiniMover, opening: float) -> int:
    """Half-steps of hand cable for an opening in inches.

    Raises:
        ValueError: if the hand does not open that far.
    """
    widest = arm.model.hand.range
    if not 0 <= opening <= widest:
        raise ValueError(f"the hand opens from 0 to {widest:g} in, not {opening:g}")
    return round(opening * arm.model.hand_steps)


def placed(arm: MiniMover, angles: JointAngles, cable: int) -> list[int]:
    """Rotors where the operator's hands have put joints and hand cable; the world is told.

    Raises:
        MotorsOn: while any motor carries current.
        InTheWay: if something on the bench is there.
        ValueError: if that is beyond a stop.
    """
    if any(motor.energised for motor in arm.motors):
        raise MotorsOn("the motors are on: @RESET turns them off")
    rotors = list(arm.drive.rotors(angles, cable))
    stop = beyond_any_stop(arm.drive, rotors)
    if stop is not None:
        raise ValueError(f"that is beyond a stop: {stop}")
    name = arm.world.place(arm.rotors, rotors)
    if name is not None:
        raise InTheWay(f"{name} is in the way")
    return rotors
