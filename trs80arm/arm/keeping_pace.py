"""How a motor keeps up with a motion, half-step for half-step, as `StepperMotor.keep_pace` has it.

Under its load a motor may need longer for a half-step than it is given and not drop out of step
yet: it falls behind, and catches up after.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from trs80arm.arm.ahead import Ahead
from trs80arm.arm.forces import BY_THEMSELVES, cosines
from trs80arm.arm.model import BASE, ELBOW, HAND, LEFT_WRIST, RIGHT_WRIST, SHOULDER, Motor

if TYPE_CHECKING:
    from trs80arm.arm.minimover import MiniMover

BEARS_BY: Mapping[Motor, Sequence[Motor]] = {
    BASE: (SHOULDER, ELBOW, LEFT_WRIST, RIGHT_WRIST),
    LEFT_WRIST: (LEFT_WRIST, RIGHT_WRIST),
    RIGHT_WRIST: (LEFT_WRIST, RIGHT_WRIST),
    HAND: (ELBOW, HAND),
}
"""By where which motors stand what bears on one that does not bear its load by itself."""

Array = npt.NDArray[np.int64]
Floats = npt.NDArray[np.float64]


def done_with(times: Array, work: Array, done: int) -> Array:
    """T-states at which a motor is done with each of some writes.

    Args:
        times: of the writes.
        work: T-states that each takes it.
        done: T-state at which it is with all before.
    """
    total = np.cumsum(work)
    start = np.maximum.accumulate(times - (total - work))
    found: Array = total + np.maximum(start, done)
    return found


def behind(arm: MiniMover, ahead: Ahead, order: int) -> int | None:
    """T-states after the last half-step of a motor at which it is done with it.

    Args:
        arm: the arm, nothing but its own weight and load bearing on it.
        ahead: the burst.
        order: of the motor among its turnings.

    Returns:
        None if it drops out of step on the way.
    """
    times, torques = half_steps(arm, ahead, order)
    latch, settings = ahead.turnings[order].latch, arm.settings
    curve = arm.strength.curves[arm.motor_kinds[latch]]
    periods = curve.periods(torques, settings.speed_margin)
    late = done_with(times, periods, arm.motors[latch].done) - times
    if bool((late > settings.pull_out_lag * periods).any()):
        return None
    return int(late[-1])


def half_steps(arm: MiniMover, ahead: Ahead, order: int) -> tuple[Array, Floats]:
    """When each half-step of a motor comes in a burst, and the torque that it turns against.

    Args:
        arm: the arm, as for `against`.
        ahead: the burst.
        order: of the motor among its turnings.
    """
    latch = ahead.turnings[order].latch
    kind = arm.motor_kinds[latch]
    times, turns = ahead.half_steps(order)
    rotors = np.empty((6, len(times)), dtype=np.int64)
    if kind in BY_THEMSELVES:
        rotors[latch] = np.cumsum(turns) - turns + arm.rotors[latch]
    else:
        rotors[:] = np.array(arm.rotors)[:, None]
        places = [
            place
            for place, other in enumerate(ahead.turnings)
            if arm.motor_kinds[other.latch] in BEARS_BY[kind]
        ]
        for place, by in zip(places, ahead.before_each(order, places), strict=True):
            rotors[ahead.turnings[place].latch] += by
    return times, against(arm, latch, turns, rotors)


def against(
    arm: MiniMover,
    latch: int,
    turns: npt.NDArray[Any],
    before: Array,
) -> npt.NDArray[np.float64]:
    """Torque that a motor turns against at many half-steps of free motion, at least 0.

    The same as a single write finds, to the last bit.

    Args:
        arm: the arm, nothing but its own weight and load bearing on it.
        latch: of the motor.
        turns: half-steps by which its field is turned, signed.
        before: positions of all rotors before each of them, 6 x half-steps; of no others than its
            own for a motor that bears its load by itself.
    """
    drive = arm.model.drives[latch]
    if drive.turns is HAND:
        squeeze = np.maximum(0, arm.grip.contact - arm.drive.cable(before))
        pressed: npt.NDArray[np.float64] = 16 * (squeeze / arm.model.hand.pound_steps)
        return np.where(turns < 0, pressed, 0.0)
    burdens = arm.world.burdens()
    if drive.turns in BY_THEMSELVES:
        lifted = arm.drive.lifted(drive.turns, before)
        torque = arm.strength.level(drive.turns, burdens) * cosines(lifted)
    else:
        torque = arm.strength.weight(drive.turns, arm.drive.driven(before), burdens, cosines)
    if drive.turns is not BASE:
        torque = np.where(turns * drive.sign > 0, torque, -torque)
    return np.where(turns == 0, 0.0, np.maximum(0.0, torque))
