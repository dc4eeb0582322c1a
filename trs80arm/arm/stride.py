"""A whole burst in one stride: free motion, for next to nothing a write.

`MiniMover` asks here first. Nothing is computed for single writes but which way each motor turns
and when; that nothing can happen follows from bounds: the longest time that a motor may need for
a half-step, the stops, and that on none of the world's ticks anything has to be looked at. From
where it has to, it goes on write by write. Where the other bounds are not enough `burst` looks more
closely.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from trs80arm.arm.contact.clock import TICK_STATES
from trs80arm.arm.forces import nearest_and_farthest
from trs80arm.arm.model import Motor
from trs80arm.arm.motors import ROWS

if TYPE_CHECKING:
    from collections.abc import Sequence

    from trs80arm.arm.minimover import MiniMover

Array = npt.NDArray[np.int64]

Span = tuple[float, float]

_GEARS = (Motor.LEFT_WRIST, Motor.RIGHT_WRIST)
_ROWS = np.array(ROWS, dtype=np.int8)


@dataclass(slots=True)
class _Train:
    """The writes to one motor.

    Attributes:
        latch: of the motor.
        places: which writes of the burst they are.
        turns: half-steps that each turns the field, 1 or -1.
        way: that of all of them, if it is the same; else 0.
        end: the rotor's position after the last.
        low, high: the least and the greatest position that it comes to.
    """

    latch: int
    places: Array
    turns: npt.NDArray[np.int8]
    way: int
    end: int
    low: int
    high: int


def stride(
    arm: MiniMover,
    times: Array,
    latches: Array,
    nibbles: Array,
    stop: tuple[int, int] | None,
) -> int | None:
    """Do a burst at once, or the beginning of it in which it is certain that nothing happens.

    Args:
        arm: the arm, every motor of it settled.
        times: T-states.
        latches: 0 to 6.
        nibbles: coil patterns.
        stop: as for `MiniMover.apply`, the grip switch only.

    Returns:
        How many writes were done before something on the bench has to be looked at; None where the
        bounds on everything else are not enough.
    """
    if arm.world.gripped and (latches != Motor.HAND).any():
        return 0
    trains = _trains(arm, latches, nibbles) if len(times) else []
    if not trains:
        return None
    low, high = list(arm.rotors), list(arm.rotors)
    for train in trains:
        low[train.latch], high[train.latch] = train.low, train.high
    pays = ((Motor.HAND, 1), (Motor.ELBOW, arm.model.elbow_pays_out))
    gears = [(one, arm.model.drives[arm.model.latch(one)].sign) for one in _GEARS]
    paid = _together(arm, trains, dict(pays), times)
    pitched = _together(arm, trains, dict(gears), times)
    if not (
        _hand_stays(arm, paid, stop)
        and _load_stays(arm, trains, dict(pays), times, pitched)
        and _within_stops(arm, low, high, pitched)
        and _in_time(arm, trains, times, low, high, paid[0])
    ):
        return None
    count = len(times)
    ticks = arm.world.ticks_until(int(times[-1]))
    clear = len(ticks)
    if clear and not arm.world.far(*_gone(arm, low, high, paid, pitched)):
        clear = arm.world.ticks_clear(_on_ticks(arm, trains, times, ticks))
    if clear < len(ticks):
        count = int(np.searchsorted(times, ticks[clear]))
        if not count:
            return 0
        trains = _trains(arm, latches[:count], nibbles[:count])
    _arrive(arm, trains, times[:count], nibbles[:count])
    return count


def _trains(arm: MiniMover, latches: Array, nibbles: Array) -> list[_Train]:
    """The writes motor by motor; none where one of them is not a half-step of a motor."""
    rows = _ROWS.take(nibbles & 15)
    latches = latches.astype(np.int8)
    if rows.min() < 0 or latches.min() < 0 or latches.max() > 5:
        return []
    trains = []
    for latch, motor in enumerate(arm.motors):
        places = (latches == latch).nonzero()[0]
        if not len(places):
            continue
        mine = rows.take(places)
        turns = np.empty_like(mine)
        np.subtract(mine[1:], mine[:-1], out=turns[1:])
        turns[0] = mine[0] - ((motor.field if motor.row >= 0 else motor.rotor) & 7)
        turns += 3
        turns &= 7
        turns -= 3
        way = int(turns[0])
        if abs(way) != 1:
            return []
        if bool((turns == way).all()):
            end = motor.rotor + way * len(places)
            low, high = sorted((motor.rotor + way, end))
        else:
            way = 0
            if not bool((np.abs(turns) == 1).all()):
                return []
            path = np.cumsum(turns)
            end = motor.rotor + int(path[-1])
            low, high = motor.rotor + int(path.min()), motor.rotor + int(path.max())
        trains.append(
            _Train(latch, places, turns, way, end, min(low, motor.rotor), max(high, motor.rotor))
        )
    return trains


def _hand_stays(arm: MiniMover, paid: tuple[int, int], stop: tuple[int, int] | None) -> bool:
    """Whether neither stop nor switch nor grip of the hand can come into play."""
    model, grip = arm.model, arm.grip
    now = arm.drive.cable(arm.rotors)
    least, most = paid
    hand = model.hand
    squeezes = max(0, grip.contact - now - most), max(0, grip.contact - now - least)
    if squeezes[1] > hand.most_squeeze - 2 or now + most > hand.range * model.hand_steps - 2:
        return False
    return stop is None or not (squeezes[1] >= hand.switch_steps or 0b1111 & stop[0] == stop[1])


def _load_stays(
    arm: MiniMover,
    trains: list[_Train],
    pays: dict[Motor, int],
    times: Array,
    pitched: tuple[int, int],
) -> bool:
    """Whether what rests in the hand goes on doing so: neither squeezed nor tilted otherwise."""
    world = arm.world
    # Something may lie on the hand that is not between its fingers.
    if not arm.grip.contact and not arm.bench.scene.carried:
        return True
    if world.gripped:
        return True
    # A step of the elbow and the hand's that makes up for it are one instant.
    least, most = _together(arm, trains, pays, times, instants=True)
    now = arm.drive.cable(arm.rotors)
    low, high = world.held_cables()
    if not (world.burdens() and low <= now + least and now + most <= high):
        return False
    against = {
        one: arm.model.drives[arm.model.latch(one)].sign * side
        for one, side in zip(_GEARS, (1, -1), strict=True)
    }
    rolled = _together(arm, trains, against, times)
    per_radian = 2 * arm.model.drives[arm.model.latch(Motor.LEFT_WRIST)].steps
    *_, left, right = arm.drive.driven(arm.rotors)
    level = abs(math.cos((left + right) / 2))
    turned = max(-pitched[0], pitched[1]) + level * max(-rolled[0], rolled[1])
    return turned / per_radian < world.tilt()


def _together(
    arm: MiniMover,
    trains: list[_Train],
    signs: dict[Motor, int],
    times: Array,
    *,
    instants: bool = False,
) -> tuple[int, int]:
    """How far a sum of two motors' positions goes below and above where it is.

    Args:
        arm: the arm.
        trains: the writes motor by motor.
        signs: how the motors count in the sum.
        times: of the burst's writes.
        instants: whether only what holds when all writes of one time are done counts.
    """
    moving = [(train, signs[kind]) for train, kind in _kinds(arm, trains) if kind in signs]
    if not moving:
        return 0, 0
    if len(moving) == 1:
        ((train, sign),) = moving
        here = arm.rotors[train.latch]
        ends = sign * (train.low - here), sign * (train.high - here)
        return min(ends), max(ends)
    if len({sign * train.way for train, sign in moving} - {0}) == 1 and all(
        train.way for train, _ in moving
    ):
        # All go the same way.
        end = sum(sign * train.way * len(train.places) for train, sign in moving)
        return min(0, end), max(0, end)
    steps = np.zeros(len(times), dtype=np.int8)
    for train, sign in moving:
        steps[train.places] = sign * train.turns
    path = np.cumsum(steps)
    if instants:
        path = path[np.append(times[1:] != times[:-1], True)]
    return min(0, int(path.min())), max(0, int(path.max()))


def _kinds(arm: MiniMover, trains: list[_Train]) -> list[tuple[_Train, Motor]]:
    """Each motor's writes with what it turns."""
    return [(train, arm.model.drives[train.latch].turns) for train in trains]


def _pitches(arm: MiniMover, pitched: tuple[int, int]) -> Span:
    """The least and the greatest pitch, radians."""
    drive = arm.model.drives[arm.model.latch(Motor.LEFT_WRIST)]
    *_, left, right = arm.drive.driven(arm.rotors)
    here = (left + right) / 2
    return here + pitched[0] / (2 * drive.steps), here + pitched[1] / (2 * drive.steps)


def _within_stops(
    arm: MiniMover, low: Sequence[int], high: Sequence[int], pitched: tuple[int, int]
) -> bool:
    """Whether no joint can come to its end."""
    limits = arm.model.limits
    base, shoulder, elbow, left, right = _spans(arm, low, high)
    pitch = _pitches(arm, pitched)
    return (
        max(-base[0], base[1]) < limits.base
        and shoulder[0] > limits.shoulder[0]
        and shoulder[1] < limits.shoulder[1]
        and elbow[0] - shoulder[1] > limits.elbow[0]
        and elbow[1] - shoulder[0] < limits.elbow[1]
        and max(pitch[1] - elbow[0], elbow[1] - pitch[0]) < limits.pitch
        and max(-left[0], left[1], -right[0], right[1]) < limits.gear
    )


def _spans(arm: MiniMover, low: Sequence[int], high: Sequence[int]) -> tuple[Span, ...]:
    """The angles that each driven joint comes to, from the least to the greatest, radians."""
    one, other = arm.drive.driven(low), arm.drive.driven(high)
    return tuple((min(a, b), max(a, b)) for a, b in zip(one, other, strict=True))


def _in_time(
    arm: MiniMover,
    trains: list[_Train],
    times: Array,
    low: Sequence[int],
    high: Sequence[int],
    least: int,
) -> bool:
    """Whether every rotor is done with each half-step before the next is asked of it."""
    strength, margin = arm.strength, arm.settings.speed_margin
    burdens = arm.world.burdens()
    spans = _spans(arm, low, high)
    for train in trains:
        drive, motor = arm.model.drives[train.latch], arm.motors[train.latch]
        turns = drive.turns
        if turns is Motor.HAND:
            squeeze = max(0, arm.grip.contact - arm.drive.cable(arm.rotors) - least)
            against = 16 * (squeeze / arm.model.hand.pound_steps)
        elif turns in (Motor.SHOULDER, Motor.ELBOW):
            level, steep = nearest_and_farthest(*spans[turns])
            weight = strength.most(turns, burdens)
            up = bool(train.turns[0] * drive.sign > 0)
            against = max(0.0, weight * (level if up else -steep)) if train.way else weight
        else:
            against = strength.most(turns, burdens)
        period = strength.curves[turns].period(against, margin)
        when = times.take(train.places)
        if int(when[0]) < motor.done:
            return False
        if len(when) > 1 and int((when[1:] - when[:-1]).min()) < period:
            return False
    return True


def _gone(
    arm: MiniMover,
    low: Sequence[int],
    high: Sequence[int],
    paid: tuple[int, int],
    pitched: tuple[int, int],
) -> tuple[list[float], float]:
    """How far each coordinate goes at most, and both gears together."""
    model, now = arm.model, arm.rotors
    gone = []
    for motor in list(Motor)[:5]:
        latch = model.latch(motor)
        most = max(high[latch] - now[latch], now[latch] - low[latch])
        gone.append(most / model.drives[latch].steps)
    gone.append(max(-paid[0], paid[1]) / model.hand_steps)
    gear = model.drives[model.latch(Motor.LEFT_WRIST)].steps
    return gone, max(-pitched[0], pitched[1]) / gear


def _on_ticks(
    arm: MiniMover, trains: Sequence[_Train], times: Array, ticks: Array
) -> npt.NDArray[np.int64]:
    """Positions of all rotors on some ticks, ticks x 6."""
    rotors = np.empty((len(ticks), 6), dtype=np.int64)
    rotors[:] = arm.rotors
    before = times.searchsorted(ticks)
    for train in trains:
        done = train.places.searchsorted(before)
        if train.way:
            rotors[:, train.latch] += train.way * done
        else:
            rotors[:, train.latch] += np.concatenate(([0], np.cumsum(train.turns)))[done]
    return rotors


def _arrive(arm: MiniMover, trains: list[_Train], times: Array, nibbles: Array) -> None:
    """Leave the arm as the burst leaves it."""
    ends = [int(train.places[-1]) for train in trains]
    # Where every rotor stood just before the last step of each motor, whose time hangs on it.
    stood = [list(arm.rotors) for _ in trains]
    rotors = list(arm.rotors)
    ticked = list(rotors)
    # And where it stood on the last tick.
    stood.append(ticked)
    tick = int(times[-1]) // TICK_STATES * TICK_STATES
    writes = np.array([*ends, int(np.searchsorted(times, tick))])
    for train in trains:
        begun = train.places.searchsorted(writes)
        for there, steps in zip(stood, begun.tolist(), strict=True):
            there[train.latch] += steps * train.way if train.way else int(train.turns[:steps].sum())
    for train, end, before in zip(trains, ends, stood, strict=False):
        motor = arm.motors[train.latch]
        turned = train.end - motor.rotor
        time, nibble = int(times[end]), int(nibbles[end]) & 15
        motor.follow(len(train.places))
        motor.moved = time
        motor.done = time + arm.period_at(train.latch, int(train.turns[-1]), before)
        motor.field = (motor.field if motor.row >= 0 else motor.rotor) + turned
        motor.rotor = train.end
        motor.row = ROWS[nibble]
        motor.coils = nibble
        rotors[train.latch] = train.end
    arm.arrive(rotors, ticked, int(times[-1]))
