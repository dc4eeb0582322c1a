"""What a burst asks of an arm that stands somewhere, whenever it begins: bounds on all of its way.

A program that goes round asks the same of the arm over and over, so that is found once for each
burst, place and load, and remembered.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import starmap
from typing import TYPE_CHECKING, NamedTuple

from trs80arm.arm.ahead import Ahead
from trs80arm.arm.bearing import period_at
from trs80arm.arm.contact.clock import T_STATES_PER_SECOND
from trs80arm.arm.contact.recurrence import question
from trs80arm.arm.forces import BY_THEMSELVES, nearest_and_farthest
from trs80arm.arm.keeping_pace import behind
from trs80arm.arm.loads import per_cent
from trs80arm.arm.model import BASE, ELBOW, HAND, LEFT_WRIST, SHOULDER
from trs80arm.arm.motors import RING

if TYPE_CHECKING:
    from trs80arm.arm.minimover import MiniMover

PER_RING = RING * T_STATES_PER_SECOND
"""Half-steps per second that a ring of them makes in one T-state."""

Span = tuple[float, float]


class Uses(NamedTuple):
    """What the half-steps of a motor take of what it has, however long ago the last was before.

    Attributes:
        within: the greatest share at any of them that comes after a ring of others; per cent,
            rounded up.
        began: torques that those before turn against.
    """

    within: int
    began: Sequence[float]


@dataclass(slots=True)
class Passage:
    """What a burst asks of an arm.

    Attributes:
        pitched: the least and the greatest sum of half-steps by which the hand is pitched.
        torques: by latch, the most that motors turn against, at most; None where it is not sure
            that they stay in step, that no joint comes to its end, and that the hand neither opens
            nor closes as far as it can.
        shares: by latch, what `Uses.within` is at most.
        rings: by latch, T-states that a ring of half-steps takes at least; of motors that make more
            half-steps than that.
        uses: by latch, of those that were asked for.
        hurried: latches of motors that may fall behind, or are when it begins.
        late: T-states after its last half-step at which each turning motor is done with it; None as
            long as nobody has asked.
        tails: of each turning motor, how many T-states before its last half-step those of the last
            ring and one were; None as long as nobody has asked.
    """

    pitched: tuple[int, int]
    torques: Mapping[int, float] | None
    shares: Mapping[int, int]
    rings: Mapping[int, int] = field(default_factory=dict)
    hurried: Sequence[int] = ()
    uses: dict[int, Uses] = field(default_factory=dict)
    late: list[int] | None = None
    tails: list[list[int]] | None = None


def known_passage(arm: MiniMover, ahead: Ahead, stop: tuple[int, int] | None) -> Passage:
    """The passage of a burst, remembered where it is one of trains.

    Args:
        arm: the arm, every motor of it settled.
        ahead: the burst.
        stop: as for `MiniMover.follow`, the grip switch only.
    """
    repeats = ahead.repeats
    if repeats is None:
        return _passage(arm, ahead, stop)
    halt = None if stop is None else (*stop,)
    asked = question(repeats, arm.rotors, halt, _still_at_it(arm, ahead), *arm.world.bearing)
    known = arm.known_passages.get(asked)
    if known is None:
        known = arm.known_passages.keep(asked, _passage(arm, ahead, stop))
    return known


def _still_at_it(arm: MiniMover, ahead: Ahead) -> list[int]:
    """T-states for which each turning motor is busy with what came before when a burst begins."""
    return [max(0, arm.motors[each.latch].done - each.first) for each in ahead.turnings]


def _passage(arm: MiniMover, ahead: Ahead, stop: tuple[int, int] | None) -> Passage:
    """The same, found anew."""
    low, high = list(arm.rotors), list(arm.rotors)
    for turning in ahead.turnings:
        low[turning.latch] += turning.low
        high[turning.latch] += turning.high
    paid = ahead.together(arm.model.pays_out)
    pitched = ahead.together(arm.model.gears(1))
    spans = _spans(arm, low, high)
    if not (_hand_stays(arm, paid, stop) and _within_stops(arm, spans, pitched)):
        return Passage(pitched, None, {})
    torques, hurried = _torques(arm, ahead, spans, paid[0])
    for order, turning in enumerate(ahead.turnings):
        if turning.latch in hurried and behind(arm, ahead, order) is None:
            return Passage(pitched, None, {})
    shares, rings = {}, {}
    margin, burdens = arm.settings.speed_margin, arm.world.burdens()
    ends = starmap(nearest_and_farthest, (*spans[1:3], _pitches(arm, pitched)))
    upper, fore, hand = (max(a, -b) for a, b in ends)
    for order, turning in enumerate(ahead.turnings):
        latch, kind, torque = turning.latch, arm.motor_kinds[turning.latch], torques[turning.latch]
        if kind is HAND:
            torque = 0.0 if turning.way > 0 else torque
        else:
            torque = min(torque, arm.strength.most(kind, burdens, (upper, fore, hand)))
        torques[latch], shares[latch] = torque, 0
        if turning.steps > RING:
            rings[latch] = ahead.closest(order)
            rate = PER_RING / max(1, rings[latch]) / margin
            shares[latch] = per_cent(arm.strength.curves[kind].used(torque, rate))
    return Passage(pitched, torques, shares, rings, hurried)


def late(arm: MiniMover, ahead: Ahead, passage: Passage) -> list[int]:
    """T-states after its last half-step at which each turning motor is done with it.

    Args:
        arm: the arm.
        ahead: the burst, or the beginning of it.
        passage: of the burst.
    """
    turnings = ahead.turnings
    here, there, loaded = arm.rotors, list(arm.rotors), bool(arm.world.burdens())
    for turning in turnings:
        there[turning.latch] += turning.net
    found = []
    for order, turning in enumerate(turnings):
        if turning.latch in passage.hurried:
            after = behind(arm, ahead, order)
            assert after is not None
            found.append(after)
            continue
        # Where every rotor stood just before that step; but a base that carries nothing and a hand
        # that opens bear nothing anywhere.
        stood, kind = list(there), arm.motor_kinds[turning.latch]
        if kind in BY_THEMSELVES:
            stood[turning.latch] -= turning.turn
        elif turning.turn < 0 if kind is HAND else loaded or kind is not BASE:
            for each, turned in zip(turnings, ahead.turned_at_last(order), strict=True):
                stood[each.latch] = here[each.latch] + turned
        found.append(period_at(arm, turning.latch, turning.turn, stood))
    return found


def tails(ahead: Ahead) -> list[list[int]]:
    """As in `Passage`."""
    return [
        [turning.last - at for at in ahead.moments(k, max(0, steps - RING - 1), steps)]
        for k, turning in enumerate(ahead.turnings)
        for steps in (turning.steps,)
    ]


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


def _torques(
    arm: MiniMover, ahead: Ahead, spans: Sequence[Span], least: int
) -> tuple[dict[int, float], list[int]]:
    """By latch, the torque that motors turn against at most; and those that may fall behind.

    All others are done with each half-step before the next is asked of them.
    """
    found, hurried = {}, []
    strength, margin = arm.strength, arm.settings.speed_margin
    burdens = arm.world.burdens()
    for turning in ahead.turnings:
        drive = arm.model.drives[turning.latch]
        turns = drive.turns
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
        begun = turning.first < arm.motors[turning.latch].done
        if begun or turning.gap < strength.curves[turns].period(against, margin):
            hurried.append(turning.latch)
        found[turning.latch] = against
    return found, hurried
