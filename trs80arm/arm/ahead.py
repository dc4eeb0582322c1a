"""What a burst will do to each motor: which way, how far, how fast, without its single writes.

For trains of pulses that follows from a few numbers; for columns of writes it takes arrays. Only
half-steps count: where a write is anything else, nothing is known ahead.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
import numpy.typing as npt

from trs80arm.arm.forces import NEVER
from trs80arm.arm.motors import PHASES, RING, ROWS, StepperMotor
from trs80arm.pulses import Burst, Columns, Pulses, Train

Array = npt.NDArray[np.int64]

UNEVEN = 3
"""Half-steps by which the sum of two trains strays from a straight course, at most: each is within
one of its own, and in one tick the one writes before the other."""

_ROWS = np.array(ROWS, dtype=np.int8)


@dataclass(frozen=True, slots=True)
class Turning:
    """What a burst does to one motor.

    Attributes:
        latch: of the motor.
        count: half-steps.
        way: that of all of them, 1 or -1, or 0 where they differ.
        net: half-steps by which it is turned in the end.
        low, high: the least and the greatest of these on the way, 0 among them.
        first, last: T-states of the first half-step and the last.
        gap: T-states between two of them, at least.
        turn: which way the last one goes.
        nibble: the pattern that its latch then holds.
    """

    latch: int
    count: int
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

    def together(self, signs: Mapping[int, int], *, instants: bool = False) -> tuple[int, int]:
        """How far a sum of positions goes below and above where it is, at most.

        Args:
            signs: how the motors count in the sum, by latch.
            instants: whether only what holds when all writes of one time are done counts.
        """

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

    def half_steps(self, order: int) -> tuple[Array, Array, list[Array]]:
        """All half-steps of one motor: their T-states, which way each goes, and all motors' before.

        The last are the half-steps by which each of the motors is turned just before each of them.
        """


def look_ahead(motors: Sequence[StepperMotor], burst: Burst) -> Ahead | None:
    """What a burst, of at least one write, will do to six motors; None if that is not known."""
    if isinstance(burst, Pulses):
        return PulsesAhead.of(motors, burst)
    return ColumnsAhead.of(motors, burst.columns().arrays())


def _starts(motor: StepperMotor) -> int:
    """Place in the ring from which the next pattern turns a motor's field."""
    return (motor.field if motor.row >= 0 else motor.rotor) & 7


def _ends_only(moving: Sequence[tuple[Turning, int]]) -> tuple[int, int] | None:
    """`Ahead.together` where it follows from each motor's own course."""
    if not moving:
        return 0, 0
    if len(moving) == 1:
        ((turning, sign),) = moving
        one, other = sign * turning.low, sign * turning.high
        return (one, other) if one < other else (other, one)
    if len({sign * turning.way for turning, sign in moving} | {0}) == 2:
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
        self.ends = pulses.time(max(self._lasts))
        self.turnings = [
            self._turning(train, last) for train, last in zip(trains, self._lasts, strict=True)
        ]

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
            min(0, net),
            max(0, net),
            pulses.time(train.tick(train.begin)),
            pulses.time(last),
            # Steps come every so many ticks at least, and these after so many T-states.
            train.over // train.under * pulses.over // pulses.under if count > 1 else NEVER,
            way,
            pulses.ring[(pulses.rows[train.motor] + net) & 7],
        )

    def together(self, signs: Mapping[int, int], *, instants: bool = False) -> tuple[int, int]:
        """As in `Ahead`."""
        moving = [(each, signs[each.latch]) for each in self.turnings if each.latch in signs]
        found = _ends_only(moving)
        if found is not None:
            return found
        trains = [train for train in self._trains if train.motor in signs]
        if (
            instants
            and len({(each.end, each.phase, each.over, each.under) for each in trains}) == 1
        ):
            # In step with each other up to the end.
            net = sum([sign * turning.net for turning, sign in moving])
            return min(0, net), max(0, net)
        # Where a train begins or ends the course of the sum may bend; between, it is straight.
        bends = [tick for each in trains for tick in (each.tick(each.begin), each.tick(each.end))]
        sums = [
            sum([signs[each.motor] * each.direction * each.before(tick) for each in trains])
            for tick in (*bends, max(self._lasts) + 1)
        ]
        return min(0, *sums) - UNEVEN, max(0, *sums) + UNEVEN

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
        return [
            train.direction * train.before(tick + 1 if place < order else tick)
            for place, train in enumerate(self._trains)
        ]

    def moments(self, order: int, first: int, end: int) -> list[int]:
        """As in `Ahead`."""
        train, time = self._trains[order], self._pulses.time
        begin, end = train.begin + first, min(train.begin + end, train.end)
        return [time(train.tick(step)) for step in range(begin, end)]

    def closest(self, order: int) -> int:
        """As in `Ahead`."""
        train, pulses = self._trains[order], self._pulses
        if len(train) <= RING:
            return NEVER
        return RING * train.over // train.under * pulses.over // pulses.under

    def half_steps(self, order: int) -> tuple[Array, Array, list[Array]]:
        """As in `Ahead`."""
        pulses, mine = self._pulses, self._trains[order]
        ticks = mine.tick_array()
        return (
            pulses.start + ticks * pulses.over // pulses.under,
            np.full(len(ticks), mine.direction, dtype=np.int64),
            [
                train.direction * train.before_each(ticks + 1 if place < order else ticks)
                for place, train in enumerate(self._trains)
            ],
        )


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

    def together(self, signs: Mapping[int, int], *, instants: bool = False) -> tuple[int, int]:
        """As in `Ahead`."""
        moving = [(each, signs[each.latch]) for each in self.turnings if each.latch in signs]
        found = _ends_only(moving)
        if found is not None:
            return found
        times = self._times
        steps = np.zeros(len(times), dtype=np.int8)
        for turning, places, turns in zip(self.turnings, self._places, self._turns, strict=True):
            steps[places] = signs.get(turning.latch, 0) * turns
        path = np.cumsum(steps)
        if instants:
            path = path[np.append(times[1:] != times[:-1], True)]
        return min(0, int(path.min())), max(0, int(path.max()))

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

    def half_steps(self, order: int) -> tuple[Array, Array, list[Array]]:
        """As in `Ahead`."""
        places = self._places[order]
        return self._times[places], self._turns[order].astype(np.int64), self._turned(places)

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
