"""A whole burst in one stride: free motion, for next to nothing a write.

`MiniMover` asks here first. Nothing is computed for single writes but which way each motor turns
and when; that nothing can happen follows from bounds: the longest time that a motor may need for
a half-step, the stops, and that on none of the world's ticks anything has to be looked at. Only for
a motor that may fall behind is every half-step gone through. From where something has to be looked
at, it goes on write by write. Where the other bounds are not enough `burst` looks more closely.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from trs80arm.arm.ahead import Ahead, look_ahead
from trs80arm.arm.model import HAND, LEFT_WRIST
from trs80arm.arm.motors import ROWS
from trs80arm.arm.passage import known_passage, late, tails
from trs80arm.arm.peaks import note_stride
from trs80arm.pulses import NOTHING, Burst

if TYPE_CHECKING:
    from collections.abc import Sequence

    from trs80arm.arm.minimover import MiniMover


def stride(arm: MiniMover, burst: Burst, stop: tuple[int, int] | None) -> Burst | None:
    """Do a burst at once, or the beginning of it in which it is certain that nothing happens.

    Args:
        arm: the arm, every motor of it settled.
        burst: of one write at least.
        stop: as for `MiniMover.follow`, the grip switch only.

    Returns:
        What comes after, from the write on before which something on the bench has to be looked
        at; None where the bounds on everything else are not enough.
    """
    ahead = look_ahead(arm.motors, burst)
    if arm.world.gripped and (ahead is None or any(each.latch != HAND for each in ahead.turnings)):
        return burst
    if ahead is None or (arm.world.homes and not all(each.way for each in ahead.turnings)):
        # A home switch has to see where its joint turns back.
        return None
    passage = known_passage(arm, ahead, stop)
    if passage.torques is None or not _load_stays(arm, ahead, passage.pitched):
        return None
    rest: Burst = NOTHING
    whole = ahead
    look = arm.world.first_look(ahead)
    if look is not None:
        before, rest = burst.until(look)
        if not before:
            return burst
        found = look_ahead(arm.motors, before)
        assert found is not None
        ahead = found
        behind, ends = late(arm, ahead, passage), tails(ahead)
    else:
        behind = passage.late = passage.late or late(arm, ahead, passage)
        ends = passage.tails = passage.tails or tails(ahead)
    note_stride(arm, ahead, whole, passage)
    _arrive(arm, ahead, behind, ends)
    return rest


def _load_stays(arm: MiniMover, ahead: Ahead, pitched: tuple[int, int]) -> bool:
    """Whether what rests in the hand goes on doing so: neither squeezed nor tilted otherwise."""
    world = arm.world
    # Something may lie on the hand that is not between its fingers.
    if not arm.grip.contact and not arm.bench.scene.carried:
        return True
    if world.gripped:
        return True
    # A step of the elbow and the hand's that makes up for it are one instant.
    least, most = ahead.together(arm.model.pays_out, instants=True)
    now = arm.drive.cable(arm.rotors)
    low, high = world.held_cables()
    if not (world.burdens() and low <= now + least and now + most <= high):
        return False
    rolled = ahead.together(arm.model.gears(-1))
    if not any(pitched) and not any(rolled):
        return True
    per_radian = 2 * arm.model.drives[arm.model.latch(LEFT_WRIST)].steps
    *_, left, right = arm.drive.driven(arm.rotors)
    level = abs(math.cos((left + right) / 2))
    turned = max(-pitched[0], pitched[1]) + level * max(-rolled[0], rolled[1])
    return turned / per_radian < world.tilt()


def _arrive(
    arm: MiniMover, ahead: Ahead, late: Sequence[int], ends: Sequence[Sequence[int]]
) -> None:
    """Leave the arm as the burst leaves it.

    Args:
        arm: the arm.
        ahead: the burst.
        late: T-states after its last half-step at which each turning motor is done with it.
        ends: how long before that the last ones of each were.
    """
    turnings = ahead.turnings
    here, there = arm.rotors, list(arm.rotors)
    for turning, after, pulses in zip(turnings, late, ends, strict=True):
        there[turning.latch] += turning.net
        motor, last = arm.motors[turning.latch], turning.last
        motor.asked([last - by for by in pulses], turning.turn)
        motor.follow(turning.steps)
        motor.moved = last
        motor.done = last + after
        motor.field = (motor.field if motor.row >= 0 else motor.rotor) + turning.net
        motor.rotor += turning.net
        motor.row = ROWS[turning.nibble]
        motor.coils = turning.nibble
    # And where they all stood on the last tick.
    ticked = list(here)
    tick = arm.bench.scene.last_tick(ahead.ends)
    for turning, turned in zip(turnings, ahead.turned_before(tick), strict=True):
        ticked[turning.latch] += turned
    arm.arrive(there, ticked, ahead.ends)
