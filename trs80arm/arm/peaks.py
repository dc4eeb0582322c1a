"""The greatest use that whole motions make of each motor, to the last half-step.

A stride does not look at single half-steps. What each can be at most follows from the stride's own
bounds; only where that is more than the greatest so far is it worked out for every one of them, so
that a peak is the same however a motion is cut. What came before matters to the first ring of
half-steps alone; the rest is the same whenever a burst begins.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from trs80arm.arm.ahead import Ahead
from trs80arm.arm.forces import BY_THEMSELVES, cosines
from trs80arm.arm.loads import per_cent
from trs80arm.arm.model import BASE, HAND
from trs80arm.arm.motors import RING
from trs80arm.arm.passage import PER_RING, Passage, Uses

if TYPE_CHECKING:
    from trs80arm.arm.minimover import MiniMover

Array = npt.NDArray[np.int64]


def note_stride(arm: MiniMover, ahead: Ahead, burst: Ahead, passage: Passage) -> None:
    """Keep the greatest use of each motor in a stride that is about to be done.

    Args:
        arm: the arm.
        ahead: the stride.
        burst: that it is, or of which it is the beginning.
        passage: of the burst.
    """
    torques = passage.torques
    assert torques is not None
    margin = arm.settings.speed_margin
    for order, turning in enumerate(ahead.turnings):
        latch, gap, pulses = turning.latch, turning.gap, arm.motors[turning.latch].pulses
        curve = arm.strength.curves[arm.motor_kinds[latch]]
        # Rings of pulses that the stride begins and ends, and those that end in it.
        if passage.shares[latch] > arm.peaks[latch]:
            used = _known(arm, burst, passage, latch).within
            if used > arm.peaks[latch] and ahead is not burst:
                used = _worked_out(arm, ahead, order).within
            arm.note_use(latch, used)
        spans = [turning.first + k * gap - pulses[k + 1] for k in range(min(RING, turning.steps))]
        rate = PER_RING / max(1, min(spans)) / margin
        if per_cent(curve.used(torques[latch], rate)) <= arm.peaks[latch]:
            continue
        moments = ahead.moments(order, 0, RING)
        began = _known(arm, burst, passage, latch).began
        for now, before, torque in zip(moments, pulses[1:], began, strict=False):
            rate = PER_RING / max(1, now - before) / margin
            arm.note_use(latch, per_cent(curve.used(torque, rate)))


def _known(arm: MiniMover, burst: Ahead, passage: Passage, latch: int) -> Uses:
    """What one motor's half-steps take in a burst; a program that goes round repeats it."""
    if latch not in passage.uses:
        order = [turning.latch for turning in burst.turnings].index(latch)
        passage.uses[latch] = _worked_out(arm, burst, order)
    return passage.uses[latch]


def _worked_out(arm: MiniMover, ahead: Ahead, order: int) -> Uses:
    """The same, found anew."""
    latch = ahead.turnings[order].latch
    times, turns = ahead.half_steps(order)
    rotors = np.empty((6, len(times)), dtype=np.int64)
    if arm.motor_kinds[latch] in BY_THEMSELVES:
        rotors[latch] = np.cumsum(turns) - turns + arm.rotors[latch]
    else:
        rotors[:] = np.array(arm.rotors)[:, None]
        for other, by in zip(ahead.turnings, ahead.before_each(order), strict=True):
            rotors[other.latch] += by
    torques = against(arm, latch, turns, rotors)
    within = 0
    if len(times) > RING:
        curve = arm.strength.curves[arm.motor_kinds[latch]]
        spans = np.maximum(1, times[RING:] - times[:-RING])
        shares = curve.uses(torques[RING:], PER_RING / spans / arm.settings.speed_margin)
        within = per_cent(float(shares.max()))
    return Uses(within, torques[:RING].tolist())


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
