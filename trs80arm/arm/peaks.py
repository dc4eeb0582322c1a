"""The greatest use that whole motions make of each motor, to the last half-step.

A stride does not look at single half-steps. What each can be at most follows from the stride's own
bounds; only where that is more than the greatest so far is it worked out for every one of them, so
that a peak is the same however a motion is cut.
"""

from __future__ import annotations

from itertools import starmap
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from trs80arm.arm.ahead import Ahead
from trs80arm.arm.contact.recurrence import question
from trs80arm.arm.forces import BY_THEMSELVES, Vector, cosines, nearest_and_farthest
from trs80arm.arm.loads import per_cent
from trs80arm.arm.model import BASE, HAND
from trs80arm.arm.motors import RING
from trs80arm.arm.passage import PER_RING, Passage

if TYPE_CHECKING:
    from trs80arm.arm.minimover import MiniMover

Array = npt.NDArray[np.int64]


def note_stride(
    arm: MiniMover,
    ahead: Ahead,
    passage: Passage,
) -> None:
    """Keep the greatest use of each motor in a stride that is about to be done.

    Args:
        arm: the arm.
        ahead: the stride.
        passage: of it, or of a burst of which it is the beginning.
    """
    margin, torques = arm.settings.speed_margin, passage.torques
    assert torques is not None
    level: Vector | None = None
    for order, turning in enumerate(ahead.turnings):
        latch = turning.latch
        kind, motor, peak = arm.motor_kinds[latch], arm.motors[latch], arm.peaks[latch]
        gap, steps, pulses = turning.gap, turning.steps, motor.pulses
        if passage.shares[latch] <= peak and turning.first - pulses[-1] >= RING * gap:
            continue
        curve, torque = arm.strength.curves[kind], torques[latch]
        # Rings of pulses that begin before the stride, and those that do not.
        begin = [turning.first + k * gap - pulses[k + 1] for k in range(min(RING, steps))]
        span = max(1, min(RING * gap, *begin))
        if 100 * curve.used(torque, PER_RING / span / margin) <= peak:
            continue
        first = zip(ahead.moments(order, 0, RING), pulses[1:], strict=False)
        span = max(1, min(ahead.closest(order), *(now - before for now, before in first)))
        if kind is HAND:
            torque = 0.0 if turning.way > 0 else torque
        else:
            if level is None:
                upper, fore, hand = (
                    max(a, -b) for a, b in starmap(nearest_and_farthest, passage.tilted)
                )
                level = upper, fore, hand
            torque = min(torque, arm.strength.most(kind, arm.world.burdens(), level))
        if per_cent(curve.used(torque, PER_RING / span / margin)) <= peak:
            continue
        arm.note_use(latch, _known(arm, ahead, order))


def _known(arm: MiniMover, ahead: Ahead, order: int) -> int:
    """The greatest share that one motor's half-steps take; a program that goes round repeats it."""
    turning, repeats = ahead.turnings[order], ahead.repeats
    if repeats is None:
        return _worked_out(arm, ahead, order)
    motor = arm.motors[turning.latch]
    since = tuple([turning.first - pulse for pulse in motor.pulses])
    asked = question(turning.latch, repeats, arm.rotors, since, *arm.world.bearing)
    used = arm.known_uses.get(asked)
    if used is None:
        used = arm.known_uses.keep(asked, _worked_out(arm, ahead, order))
    return used


def _worked_out(arm: MiniMover, ahead: Ahead, order: int) -> int:
    """The greatest share that one motor's half-steps take, per cent, rounded up."""
    latch = ahead.turnings[order].latch
    times, turns = ahead.half_steps(order)
    rotors = np.empty((6, len(times)), dtype=np.int64)
    if arm.motor_kinds[latch] in BY_THEMSELVES:
        rotors[latch] = np.cumsum(turns) - turns + arm.rotors[latch]
    else:
        rotors[:] = np.array(arm.rotors)[:, None]
        for other, by in zip(ahead.turnings, ahead.before_each(order), strict=True):
            rotors[other.latch] += by
    bearing = against(arm, latch, turns, rotors)
    return greatest(arm, latch, times, np.abs(turns), bearing)


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


def greatest(
    arm: MiniMover,
    latch: int,
    times: Array,
    asked: Array,
    torque: npt.NDArray[np.float64],
) -> int:
    """The greatest share of what a motor has that writes take, per cent, rounded up.

    Args:
        arm: the arm, its motor not yet told of them.
        latch: of the motor.
        times: of the writes, T-states.
        asked: half-steps that each asks for.
        torque: what each of them turns against.
    """
    before = np.array(arm.motors[latch].pulses, dtype=np.int64)
    pulses = np.concatenate((before, np.repeat(times, asked)))
    place = np.cumsum(asked)
    span = np.maximum(1, pulses[place + RING] - pulses[place])
    rate = PER_RING / span / arm.settings.speed_margin
    curve = arm.strength.curves[arm.model.drives[latch].turns]
    shares = curve.uses(torque, rate)[asked > 0]
    return per_cent(float(shares.max())) if len(shares) else 0
