"""A whole burst in one stride: free motion, for next to nothing a write.

`MiniMover` asks here first. Nothing is computed for single writes but which way each motor turns
and when; that nothing can happen follows from bounds: the longest time that a motor may need for
a half-step, the stops, and that on none of the world's ticks anything has to be looked at. From
where it has to, it goes on write by write. Where the other bounds are not enough `burst` looks more
closely.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from trs80arm.arm.ahead import Ahead, look_ahead
from trs80arm.arm.bearing import period_at
from trs80arm.arm.contact.clock import TICK_STATES
from trs80arm.arm.forces import BY_THEMSELVES, nearest_and_farthest
from trs80arm.arm.model import BASE, ELBOW, HAND, LEFT_WRIST, SHOULDER
from trs80arm.arm.motors import RING, ROWS
from trs80arm.arm.peaks import note_stride
from trs80arm.pulses import NOTHING, Burst

if TYPE_CHECKING:
    from collections.abc import Sequence

    from trs80arm.arm.minimover import MiniMover

Span = tuple[float, float]


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
    low, high = list(arm.rotors), list(arm.rotors)
    for turning in ahead.turnings:
        low[turning.latch] += turning.low
        high[turning.latch] += turning.high
    paid = ahead.together(arm.model.pays_out)
    pitched = ahead.together(arm.model.gears(1))
    spans = _spans(arm, low, high)
    if not (
        _hand_stays(arm, paid, stop)
        and _load_stays(arm, ahead, pitched)
        and _within_stops(arm, spans, pitched)
        and (torques := _in_time(arm, ahead, spans, paid[0])) is not None
    ):
        return None
    rest: Burst = NOTHING
    look = arm.world.first_look(ahead)
    if look is not None:
        before, rest = burst.until(look)
        if not before:
            return burst
        found = look_ahead(arm.motors, before)
        assert found is not None
        ahead = found
    note_stride(arm, ahead, torques, (*spans[1:3], _pitches(arm, pitched)))
    _arrive(arm, ahead)
    return rest


def _hand_stays(arm: MiniMover, paid: tuple[int, int], stop: tuple[int, int] | None) -> bool:
    """Whether neither stop nor switch nor grip of the hand can come into play."""
    model, grip = arm.model, arm.grip
    now = arm.drive.cable(arm.rotors)
    least, most = paid
    hand = model.hand
    squeeze = max(0, grip.contact - now - least)
    if squeeze > hand.most_squeeze - 2 or now + most > hand.range * model.hand_steps - 2:
        return False
    return stop is None or not (squeeze >= hand.switch_steps or 0b1111 & stop[0] == stop[1])


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


def _spans(arm: MiniMover, low: Sequence[int], high: Sequence[int]) -> tuple[Span, ...]:
    """The angles that each driven joint comes to, from the least to the greatest, radians."""
    one, other = arm.drive.driven(low), arm.drive.driven(high)
    return tuple([(a, b) if a < b else (b, a) for a, b in zip(one, other, strict=True)])


def _pitches(arm: MiniMover, pitched: tuple[int, int]) -> Span:
    """The least and the greatest pitch, radians."""
    *_, left, right = arm.drive.driven(arm.rotors)
    here = (left + right) / 2
    per_radian = 2 * arm.model.drives[arm.model.latch(LEFT_WRIST)].steps
    return here + pitched[0] / per_radian, here + pitched[1] / per_radian


def _within_stops(arm: MiniMover, spans: Sequence[Span], pitched: tuple[int, int]) -> bool:
    """Whether no joint can come to its end."""
    limits = arm.model.limits
    base, shoulder, elbow, left, right = spans
    lowest, highest = _pitches(arm, pitched)
    return (
        max(-base[0], base[1]) < limits.base
        and shoulder[0] > limits.shoulder[0]
        and shoulder[1] < limits.shoulder[1]
        and elbow[0] - shoulder[1] > limits.elbow[0]
        and elbow[1] - shoulder[0] < limits.elbow[1]
        and max(highest - elbow[0], elbow[1] - lowest) < limits.pitch
        and max(-left[0], left[1], -right[0], right[1]) < limits.gear
    )


def _in_time(
    arm: MiniMover, ahead: Ahead, spans: Sequence[Span], least: int
) -> dict[int, float] | None:
    """By latch, the torque that motors turn against at most, where all are sure to keep up.

    That is where every rotor is done with each half-step before the next is asked of it.
    """
    found = {}
    strength, margin = arm.strength, arm.settings.speed_margin
    burdens = arm.world.burdens()
    for turning in ahead.turnings:
        drive = arm.model.drives[turning.latch]
        turns = drive.turns
        if turning.first < arm.motors[turning.latch].done:
            return None
        if turns is HAND:
            squeeze = max(0, arm.grip.contact - arm.drive.cable(arm.rotors) - least)
            against = 16 * (squeeze / arm.model.hand.pound_steps)
        elif turns is SHOULDER or turns is ELBOW:
            against = strength.most(turns, burdens)
            if turning.way:
                level, steep = nearest_and_farthest(*spans[turns])
                up = turning.way * drive.sign > 0
                against = max(0.0, against * (level if up else -steep))
        else:
            against = strength.most(turns, burdens)
        if turning.gap < strength.curves[turns].period(against, margin):
            return None
        found[turning.latch] = against
    return found


def _arrive(arm: MiniMover, ahead: Ahead) -> None:
    """Leave the arm as the burst leaves it."""
    turnings = ahead.turnings
    here, there, loaded = list(arm.rotors), list(arm.rotors), bool(arm.world.burdens())
    for turning in turnings:
        there[turning.latch] += turning.net
    for order, turning in enumerate(turnings):
        # Where every rotor stood just before the last step of this one, whose time hangs on it.
        stood, kind = list(there), arm.motor_kinds[turning.latch]
        if kind in BY_THEMSELVES:
            stood[turning.latch] -= turning.turn
        elif turning.turn < 0 if kind is HAND else loaded or kind is not BASE:
            for each, turned in zip(turnings, ahead.turned_at_last(order), strict=True):
                stood[each.latch] = here[each.latch] + turned
        motor = arm.motors[turning.latch]
        steps = turning.steps
        motor.asked(ahead.moments(order, max(0, steps - RING - 1), steps), turning.turn)
        motor.follow(steps)
        motor.moved = turning.last
        motor.done = turning.last + period_at(arm, turning.latch, turning.turn, stood)
        motor.field = (motor.field if motor.row >= 0 else motor.rotor) + turning.net
        motor.rotor += turning.net
        motor.row = ROWS[turning.nibble]
        motor.coils = turning.nibble
    # And where they all stood on the last tick.
    ticked = list(here)
    tick = ahead.ends // TICK_STATES * TICK_STATES
    for turning, turned in zip(turnings, ahead.turned_before(tick), strict=True):
        ticked[turning.latch] += turned
    arm.arrive(there, ticked, ahead.ends)
