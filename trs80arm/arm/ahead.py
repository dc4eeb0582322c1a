"""What a burst will do to each motor: which way, how far, how fast, without its single writes.

For trains of pulses that follows from a few numbers; for columns of writes it takes arrays. Only
half-steps count: where a write is anything else, nothing is known ahead.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple, Protocol

import numpy as np
import numpy.typing as npt

from trs80arm.arm.contact.recurrence import question
from trs80arm.arm.forces import NEVER
from trs80arm.arm.model import Signs
from trs80arm.arm.motors import PHASES, RING, ROWS, StepperMotor
from trs80arm.pulses import Burst, Columns, Pulses, Train

Array = npt.NDArray[np.int64]

UNEVEN = 3
"""Half-steps by which the sum of two trains strays from a straight course, at most: each is within
one of its own, and in one tick the one writes before the other."""

_ROWS = np.array(ROWS, dtype=np.int8)


class Turning(NamedTuple):
    """What a burst does to one motor.

    Attributes:
        latch: of the motor.
        steps: half-steps.
        way: that of all of them, 1 or -1, or 0 where they differ.
        net: half-steps by which it is turned in the end.
        low, high: the least and the greatest of these on the way, 0 among them.
        first, last: T-states of the first half-step and the last.
        gap: T-states between two of them, at least.
        turn: which way the last one goes.
        nibble: the pattern that its latch then holds.
    """

    latch: int
    steps: int
    way: int
    net: int
    low: int
    high: int
    first: int
    last: int
    gap: int
    turn: int
    nibble: int


class Ahead(Protocol):
    """A burst that is half-steps only."""

    @property
    def turnings(self) -> Sequence[Turning]:
        """Of the motors that turn."""

    @property
    def ends(self) -> int:
        """T-state of the last write."""

    @property
    def repeats(self) -> bytes | None:
        """What is the same in bursts that do the same, whenever they begin; None if not known."""

    def together(self, signs: Signs, *, instants: bool = False) -> tuple[int, int]:
        """How far a sum of positions goes below and above where it is, at most.

        Args:
            signs: of the sum.
            instants: whether only what holds when all writes of one time are done counts.
        """

    def is_all(self, since: int, until: int) -> bool:
        """Whether what comes between two T-states is as good as all of it: its bounds are the same.

        Args:
            since: T-state.
            until: T-state.
        """

    def together_between(self, signs: Signs, since: int, until: int) -> tuple[int, int]:
        """How low and how high, at most, a sum of half-steps is between two T-states.

        Args:
            signs: of the sum.
            since: T-state; what comes before it is done.
            until: T-state, before which all that matters is done.
        """

    def between(self, since: int, until: int) -> list[tuple[int, int]]:
        """Between what half-steps each of the motors is in between two T-states."""

    def turned(self, times: Array) -> list[Array]:
        """Half-steps by which each of the motors is turned by the writes before some T-states."""

    def turned_before(self, time: int) -> list[int]:
        """Half-steps by which each of the motors is turned by the writes before a T-state."""

    def turned_at_last(self, order: int) -> list[int]:
        """Half-steps by which each of the motors is turned just before the last write to one.

        Args:
            order: of that one among the turnings.
        """

    def moments(self, order: int, first: int, end: int) -> list[int]:
        """T-states of some of one motor's half-steps, as many as there are.

        Args:
            order: of the motor among the turnings.
            first: the first of them, counted from 0.
            end: the one after the last.
        """

    def closest(self, order: int) -> int:
        """T-states that a ring of one motor's half-steps takes at least; `NEVER` if it has none."""

    def half_steps(self, order: int) -> tuple[Array, Array]:
        """All half-steps of one motor: their T-states, and which way each goes."""

    def before_each(self, order: int, places: Sequence[int]) -> list[Array]:
        """Half-steps by which some motors are turned just before each of one motor's.

        Args:
            order: of that one among the turnings.
            places: of the others.
        """


def look_ahead(motors: Sequence[StepperMotor], burst: Burst) -> Ahead | None:
    """What a burst, of at least one write, will do to six motors; None if that is not known."""
    if isinstance(burst, Pulses):
        return PulsesAhead.of(motors, burst)
    return ColumnsAhead.of(motors, burst.columns().arrays())


def _starts(motor: StepperMotor) -> int:
    """Place in the ring from which the next pattern turns a motor's field."""
    return (motor.field if motor.row >= 0 else motor.rotor) & 7


def _moving(turnings: Sequence[Turning], signs: Signs) -> list[tuple[Turning, int]]:
    """The motors of a sum that turn, with how they count in it."""
    return [(each, sign) for each in turnings for latch, sign in signs if each.latch == latch]


def _ends_only(moving: Sequence[tuple[Turning, int]]) -> tuple[int, int] | None:
    """`Ahead.together` where it follows from each motor's own course."""
    if not moving:
        return 0, 0
    if len(moving) == 1:
        ((turning, sign),) = moving
        one, other = sign * turning.low, sign * turning.high
        return (one, other) if one < other else (other, one)
    ways = {sign * turning.way for turning, sign in moving}
    if len(ways) == 1 and 0 not in ways:
        # All go the same way.
        net = sum([sign * turning.net for turning, sign in moving])
        return min(0, net), max(0, net)
    return None


class PulsesAhead:
    """A burst of trains."""

    def __init__(self, pulses: Pulses, trains: Sequence[Train]) -> None:
        self._pulses = pulses
        self._trains = trains
        self._lasts = [train.tick(train.end - 1) for train in trains]
        self._last = max(self._lasts)
        self.ends = pulses.time(self._last)
        self._sums: dict[tuple[Signs, bool], tuple[int, int]] = {}
        self._repeats: bytes | None = None
        self.turnings = [
            self._turning(train, last) for train, last in zip(trains, self._lasts, strict=True)
        ]

    @property
    def repeats(self) -> bytes | None:
        """As in `Ahead`."""
        if self._repeats is None:
            pulses, trains = self._pulses, self._trains
            numbers = [
                (
                    each.motor,
                    each.direction,
                    each.begin,
                    each.end,
                    each.phase,
                    each.over,
                    each.under,
                )
                for each in trains
            ]
            self._repeats = question(pulses.over, pulses.under, numbers)
        return self._repeats

    @classmethod
    def of(cls, motors: Sequence[StepperMotor], pulses: Pulses) -> PulsesAhead | None:
        """`look_ahead`."""
        if pulses.ring != PHASES:
            return None
        trains = [train for train in pulses.trains if train]
        for train in trains:
            if train.motor > 5 or (_starts(motors[train.motor]) ^ pulses.rows[train.motor]) & 7:
                return None
        return cls(pulses, trains)

    def _turning(self, train: Train, last: int) -> Turning:
        pulses, way, count = self._pulses, train.direction, train.end - train.begin
        net = way * count
        return Turning(
            train.motor,
            count,
            way,
            net,
            *((0, net) if net > 0 else (net, 0)),
            pulses.time(train.tick(train.begin)),
            pulses.time(last),
            # Steps come every so many ticks at least, and these after so many T-states.
            train.over // train.under * pulses.over // pulses.under if count > 1 else NEVER,
            way,
            pulses.ring[(pulses.rows[train.motor] + net) & 7],
        )

    def together(self, signs: Signs, *, instants: bool = False) -> tuple[int, int]:
        """As in `Ahead`."""
        key = signs, instants
        if key not in self._sums:
            moving = _moving(self.turnings, signs)
            found = _ends_only(moving)
            if found is None and instants and self._in_step(signs):
                net = sum([sign * turning.net for turning, sign in moving])
                found = min(0, net), max(0, net)
            if found is None:
                found = self._course(signs, 0, self._last + 1)
            self._sums[key] = found
        return self._sums[key]

    def _in_step(self, signs: Signs) -> bool:
        """Whether motors make their half-steps at the same times, up to the end."""
        latches = [latch for latch, _ in signs]
        trains = [train for train in self._trains if train.motor in latches]
        return len({(each.end, each.phase, each.over, each.under) for each in trains}) == 1

    def together_between(self, signs: Signs, since: int, until: int) -> tuple[int, int]:
        """As in `Ahead`."""
        if self.is_all(since, until):
            return self.together(signs)
        first, last = self._pulses.first_tick_from(since), self._pulses.first_tick_from(until)
        return self._course(signs, first, last)

    def _course(self, signs: Signs, first: int, last: int) -> tuple[int, int]:
        """How low and how high at most a sum is from one tick to another."""
        trains = [
            (train, sign * train.direction)
            for train in self._trains
            for latch, sign in signs
            if train.motor == latch
        ]
        if not trains:
            return 0, 0
        ticks, stray = [first, last], 0
        if any(way != trains[0][1] for _, way in trains):
            # Where a train begins or ends the course of the sum may bend; between, it is straight.
            bends = [
                at for each, _ in trains for at in (each.tick(each.begin), each.tick(each.end))
            ]
            ticks += [tick for tick in bends if first < tick < last]
            stray = UNEVEN
        sums = [sum([way * train.before(tick) for train, way in trains]) for tick in ticks]
        return min(sums) - stray, max(sums) + stray

    def between(self, since: int, until: int) -> list[tuple[int, int]]:
        """As in `Ahead`."""
        if self.is_all(since, until):
            return [(turning.low, turning.high) for turning in self.turnings]
        ends = zip(self.turned_before(since), self.turned_before(until), strict=True)
        return [(one, other) if one < other else (other, one) for one, other in ends]

    def is_all(self, since: int, until: int) -> bool:
        """As in `Ahead`: its bounds need not be narrower."""
        return 4 * (until - since) >= 3 * (self.ends - min([each.first for each in self.turnings]))

    def turned(self, times: Array) -> list[Array]:
        """As in `Ahead`."""
        pulses = self._pulses
        ticks = -((pulses.start - times) * pulses.under // pulses.over)
        return [train.direction * train.before_each(ticks) for train in self._trains]

    def turned_before(self, time: int) -> list[int]:
        """As in `Ahead`."""
        tick = self._pulses.first_tick_from(time)
        return [train.direction * train.before(tick) for train in self._trains]

    def turned_at_last(self, order: int) -> list[int]:
        """As in `Ahead`."""
        tick = self._lasts[order]
        if tick < self._last:
            return [
                train.direction * train.before(tick + 1 if place < order else tick)
                for place, train in enumerate(self._trains)
            ]
        # It is in the very last tick: all have been done but those of its tick that come later.
        return [
            turning.net - (turning.way if place >= order and last == tick else 0)
            for place, (turning, last) in enumerate(zip(self.turnings, self._lasts, strict=True))
        ]

    def moments(self, order: int, first: int, end: int) -> list[int]:
        """As in `Ahead`."""
        train, pulses = self._trains[order], self._pulses
        start, over, under = pulses.start, pulses.over, pulses.under
        phase, rise, parts = train.phase, train.over, train.under
        steps = range(train.begin + first, min(train.begin + end, train.end))
        return [start + (phase + step * rise) // parts * over // under for step in steps]

    def closest(self, order: int) -> int:
        """As in `Ahead`."""
        train, pulses = self._trains[order], self._pulses
        if len(train) <= RING:
            return NEVER
        return RING * train.over // train.under * pulses.over // pulses.under

    def half_steps(self, order: int) -> tuple[Array, Array]:
        """As in `Ahead`."""
        pulses, mine = self._pulses, self._trains[order]
        ticks = mine.tick_array()
        times = pulses.start + ticks * pulses.over // pulses.under
        return times, np.full(len(ticks), mine.direction, dtype=np.int64)

    def before_each(self, order: int, places: Sequence[int]) -> list[Array]:
        """As in `Ahead`."""
        ticks, trains = self._trains[order].tick_array(), self._trains
        return [
            trains[place].direction
            * trains[place].before_each(ticks + 1 if place < order else ticks)
            for place in places
        ]


class ColumnsAhead:
    """A burst of single writes."""

    def __init__(
        self,
        times: Array,
        places: Sequence[Array],
        turns: Sequence[npt.NDArray[np.int8]],
        turnings: Sequence[Turning],
    ) -> None:
        self._times = times
        self._places = places
        self._turns = turns
        self.turnings = turnings
        self.ends = int(times[-1])

    @property
    def repeats(self) -> bytes | None:
        """As in `Ahead`."""
        return None

    @classmethod
    def of(cls, motors: Sequence[StepperMotor], columns: Columns) -> ColumnsAhead | None:
        """`look_ahead`."""
        times, nibbles = np.asarray(columns.times), np.asarray(columns.nibbles)
        rows = _ROWS.take(nibbles & 15)
        latches = np.asarray(columns.latches).astype(np.int8)
        if rows.min() < 0 or latches.min() < 0 or latches.max() > 5:
            return None
        all_places, all_turns, turnings = [], [], []
        for latch, motor in enumerate(motors):
            places = (latches == latch).nonzero()[0]
            if not len(places):
                continue
            mine = rows.take(places)
            turns = np.empty_like(mine)
            np.subtract(mine[1:], mine[:-1], out=turns[1:])
            turns[0] = mine[0] - _starts(motor)
            turns += 3
            turns &= 7
            turns -= 3
            if not bool((np.abs(turns) == 1).all()):
                return None
            when = times.take(places)
            all_places.append(places)
            all_turns.append(turns)
            turnings.append(_turning(latch, turns, when, int(nibbles[places[-1]]) & 15))
        return cls(times, all_places, all_turns, turnings)

    def together(self, signs: Signs, *, instants: bool = False) -> tuple[int, int]:
        """As in `Ahead`."""
        found = _ends_only(_moving(self.turnings, signs))
        if found is not None:
            return found
        times, counts = self._times, dict(signs)
        steps = np.zeros(len(times), dtype=np.int8)
        for turning, places, turns in zip(self.turnings, self._places, self._turns, strict=True):
            steps[places] = counts.get(turning.latch, 0) * turns
        path = np.cumsum(steps)
        if instants:
            path = path[np.append(times[1:] != times[:-1], True)]
        return min(0, int(path.min())), max(0, int(path.max()))

    def is_all(self, since: int, until: int) -> bool:
        """As in `Ahead`."""
        return False

    def together_between(self, signs: Signs, since: int, until: int) -> tuple[int, int]:
        """As in `Ahead`."""
        return self.together(signs)

    def between(self, since: int, until: int) -> list[tuple[int, int]]:
        """As in `Ahead`."""
        ends = zip(self.turned_before(since), self.turned_before(until), strict=True)
        return [
            (min(one, other), max(one, other)) if turning.way else (turning.low, turning.high)
            for turning, (one, other) in zip(self.turnings, ends, strict=True)
        ]

    def turned(self, times: Array) -> list[Array]:
        """As in `Ahead`."""
        return self._turned(self._times.searchsorted(times))

    def turned_before(self, time: int) -> list[int]:
        """As in `Ahead`."""
        return [int(turned[0]) for turned in self.turned(np.array([time]))]

    def turned_at_last(self, order: int) -> list[int]:
        """As in `Ahead`."""
        return [int(turned[0]) for turned in self._turned(self._places[order][-1:])]

    def moments(self, order: int, first: int, end: int) -> list[int]:
        """As in `Ahead`."""
        found: list[int] = self._times[self._places[order][first:end]].tolist()
        return found

    def closest(self, order: int) -> int:
        """As in `Ahead`."""
        when = self._times[self._places[order]]
        return int((when[RING:] - when[:-RING]).min()) if len(when) > RING else NEVER

    def half_steps(self, order: int) -> tuple[Array, Array]:
        """As in `Ahead`."""
        return self._times[self._places[order]], self._turns[order].astype(np.int64)

    def before_each(self, order: int, places: Sequence[int]) -> list[Array]:
        """As in `Ahead`."""
        turned = self._turned(self._places[order])
        return [turned[place] for place in places]

    def _turned(self, writes: Array) -> list[Array]:
        """Half-steps by which each motor is turned by so many writes."""
        found: list[Array] = []
        for turning, places, turns in zip(self.turnings, self._places, self._turns, strict=True):
            done = places.searchsorted(writes)
            if turning.way:
                found.append(turning.way * done)
            else:
                found.append(np.concatenate(([0], np.cumsum(turns, dtype=np.int64)))[done])
        return found


def _turning(latch: int, turns: npt.NDArray[np.int8], when: Array, nibble: int) -> Turning:
    """What single half-steps do to a motor."""
    count, way = len(turns), int(turns[0])
    if bool((turns == way).all()):
        net = way * count
        low, high = min(0, net), max(0, net)
    else:
        way, path = 0, np.cumsum(turns, dtype=np.int64)
        net, low, high = int(path[-1]), min(0, int(path.min())), max(0, int(path.max()))
    gap = int((when[1:] - when[:-1]).min()) if count > 1 else NEVER
    first, last = int(when[0]), int(when[-1])
    return Turning(latch, count, way, net, low, high, first, last, gap, int(turns[-1]), nibble)
