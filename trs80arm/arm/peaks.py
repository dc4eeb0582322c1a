"""The greatest use that whole motions make of each motor, to the last half-step.

A stride does not look at single half-steps. What each can be at most follows from the stride's own
bounds; only where that is more than the greatest so far is it worked out for every one of them, so
that a peak is the same however a motion is cut. What came before matters to the first ring of
half-steps alone; the rest is the same whenever a burst begins.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from trs80arm.arm.ahead import Ahead
from trs80arm.arm.keeping_pace import half_steps
from trs80arm.arm.loads import per_cent
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
        # Rings of pulses that the stride begins and ends, and those that end in it.
        seldom = passage.shares[latch] <= arm.peaks[latch]
        ring = passage.rings.get(latch)
        if seldom and ring is not None and turning.first - pulses[-1] >= ring:
            # Between the motions it stood for longer than a ring takes.
            continue
        if not seldom:
            used = _known(arm, burst, passage, latch).within
            if used > arm.peaks[latch] and ahead is not burst:
                used = _worked_out(arm, ahead, order).within
            arm.note_use(latch, used)
        curve = arm.strength.curves[arm.motor_kinds[latch]]
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
    times, torques = half_steps(arm, ahead, order)
    within = 0
    if len(times) > RING:
        curve = arm.strength.curves[arm.motor_kinds[latch]]
        spans = np.maximum(1, times[RING:] - times[:-RING])
        shares = curve.uses(torques[RING:], PER_RING / spans / arm.settings.speed_margin)
        within = per_cent(float(shares.max()))
    return Uses(within, torques[:RING].tolist())


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
