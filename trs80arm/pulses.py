"""What goes down the arm's cable: bursts of latch writes.

A motion of a stepper motor is a train of pulses, evenly spread over ticks, and a few numbers say as
much of it as thousands of writes. So software sends bursts as trains, the card hands them on as
they are, and who must see the single writes has them as columns. This is all that card and arm
know of each other.

None of these is changed once it is made, though nothing forbids it: frozen ones take four times as
long to make, and one is made for each write that is sent alone.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Protocol, TypeAlias

import numpy as np
import numpy.typing as npt

Series: TypeAlias = Sequence[int] | npt.NDArray[np.int64]
"""A column of a burst: a plain sequence for a few writes, an array for many."""

_ARRAY_FROM = 48
"""Writes from which arrays are quicker than a plain loop."""
_FEW = 16
"""Writes up to which it is quicker to look at each."""


class Burst(Protocol):
    """Latch writes in order, their times not falling."""

    def __len__(self) -> int:
        """How many writes they are."""

    @property
    def begins(self) -> int:
        """T-state of the first write."""

    @property
    def ends(self) -> int:
        """T-state of the last write."""

    def only(self, latch: int) -> bool:
        """Whether all writes are to one latch."""

    def columns(self) -> Columns:
        """The writes one by one."""

    def split(self, count: int) -> tuple[Burst, Burst]:
        """So many writes, and the rest of them."""

    def first(self, count: int) -> tuple[Columns, Burst]:
        """So many writes one by one, and the rest of them."""

    def until(self, time: int) -> tuple[Burst, Burst]:
        """The writes that come before a T-state, and the rest of them."""

    def before_pause(self, pause: int) -> Burst:
        """The writes before the first that comes so many T-states or more after the one before.

        The burst itself, if there is none.
        """

    def held(self) -> Iterable[tuple[int, int]]:
        """What latches hold after it, as (latch, nibble); those that are not written are not in it.

        A latch may be in it several times: the last one counts.
        """


@dataclass(slots=True)
class Columns:
    """A burst as its single writes.

    Attributes:
        times: T-states.
        latches: 0 to 6.
        nibbles: patterns, phi1 as bit 3.
    """

    times: Series
    latches: Series
    nibbles: Series

    def __len__(self) -> int:
        return len(self.times)

    @property
    def begins(self) -> int:
        """As in `Burst`."""
        return int(self.times[0])

    @property
    def ends(self) -> int:
        """As in `Burst`."""
        return int(self.times[-1])

    def only(self, latch: int) -> bool:
        """As in `Burst`."""
        if isinstance(self.latches, np.ndarray):
            return bool((self.latches == latch).all())
        return all(each == latch for each in self.latches)

    def columns(self) -> Columns:
        """As in `Burst`."""
        return self

    def split(self, count: int) -> tuple[Columns, Columns]:
        """As in `Burst`."""
        times, latches, nibbles = self.times, self.latches, self.nibbles
        return (
            Columns(times[:count], latches[:count], nibbles[:count]),
            Columns(times[count:], latches[count:], nibbles[count:]),
        )

    def first(self, count: int) -> tuple[Columns, Columns]:
        """As in `Burst`."""
        return self.split(count)

    def until(self, time: int) -> tuple[Columns, Columns]:
        """As in `Burst`."""
        return self.split(int(np.searchsorted(self.times, time)))

    def before_pause(self, pause: int) -> Columns:
        """As in `Burst`."""
        pauses = (np.diff(self.times) >= pause).nonzero()[0]
        return self.split(int(pauses[0]) + 1)[0] if len(pauses) else self

    def held(self) -> Iterable[tuple[int, int]]:
        """As in `Burst`."""
        if not isinstance(self.latches, np.ndarray):
            return zip(self.latches, self.nibbles, strict=True)
        # Of several assignments to one place the last one stays.
        last = np.full(int(self.latches.max()) + 1, -1)
        last[self.latches] = np.arange(len(self.latches))
        places = last.tolist()
        return [(latch, int(self.nibbles[at])) for latch, at in enumerate(places) if at >= 0]

    def arrays(self) -> Columns:
        """The same with arrays for columns."""
        times, latches, nibbles = (
            np.asarray(each, dtype=np.int64) for each in (self.times, self.latches, self.nibbles)
        )
        return Columns(times, latches, nibbles)


NOTHING = Columns((), (), ())
"""No writes."""


@dataclass(slots=True)
class Train:
    """Some steps of one motor in one direction: step i comes at tick `(phase + i * over) // under`.

    Attributes:
        motor: 0 for the base to 5 for the hand, and what hangs on the auxiliary latch.
        direction: 1 or -1.
        begin: the first step i of the train.
        end: the step after the last.
        phase: parts of a tick by which all steps are later.
        over: ticks between steps, as a fraction, above the line; no less than `under`.
        under: the same, below the line: how many parts a tick has.
    """

    motor: int
    direction: int
    begin: int
    end: int
    phase: int = 0
    over: int = 1
    under: int = 1

    def __len__(self) -> int:
        return self.end - self.begin

    def steps(self, count: int) -> range:
        """The first steps, so many at most."""
        return range(self.begin, min(self.end, self.begin + count))

    def tick(self, step: int) -> int:
        """The tick of a step i."""
        return (self.phase + step * self.over) // self.under

    def ticks(self) -> list[int]:
        """The tick of each step."""
        phase, over, under = self.phase, self.over, self.under
        return [(phase + i * over) // under for i in range(self.begin, self.end)]

    def tick_array(self) -> npt.NDArray[np.int64]:
        """The same, for long trains."""
        steps = np.arange(self.begin, self.end, dtype=np.int64)
        if self.over == self.under:
            return self.phase // self.under + steps
        return (self.phase + steps * self.over) // self.under

    def before(self, tick: int) -> int:
        """How many of its steps come before a tick."""
        step = -((self.phase - tick * self.under) // self.over)
        if step >= self.end:
            return self.end - self.begin
        return step - self.begin if step > self.begin else 0

    def before_each(self, ticks: npt.NDArray[np.int64]) -> npt.NDArray[np.int64]:
        """How many of its steps come before each of some ticks."""
        steps = -((self.phase - ticks * self.under) // self.over)
        return np.minimum(np.maximum(steps, self.begin), self.end) - self.begin

    def rest(self, count: int) -> Train:
        """It without so many of its steps."""
        begin = self.begin + count
        return Train(self.motor, self.direction, begin, self.end, self.phase, self.over, self.under)

    def cut(self, count: int) -> tuple[Train, Train]:
        """So many of its steps, and the rest of them."""
        at, spacing = self.begin + count, (self.phase, self.over, self.under)
        return (
            Train(self.motor, self.direction, self.begin, at, *spacing),
            Train(self.motor, self.direction, at, self.end, *spacing),
        )


@dataclass(slots=True)
class Pulses:
    """A burst as trains of pulses: tick k is at the T-state `start + k * over // under`.

    In one tick motors step in the order of the trains.

    Attributes:
        start: the T-state of tick 0.
        over: T-states of a tick, as a fraction, above the line.
        under: the same, below the line.
        trains: not more than one a motor; some may have no steps.
        rows: by motor, the place in the ring of the pattern before the first step.
        ring: the patterns that turn a motor when they are written in turn.
    """

    start: int
    over: int
    under: int
    trains: tuple[Train, ...]
    rows: Sequence[int]
    ring: Sequence[int]

    def __len__(self) -> int:
        return sum([train.end - train.begin for train in self.trains])

    def time(self, tick: int) -> int:
        """The T-state of a tick."""
        return self.start + tick * self.over // self.under

    def first_tick_from(self, time: int) -> int:
        """The first tick that does not come before a T-state."""
        return max(0, -((self.start - time) * self.under // self.over))

    @property
    def begins(self) -> int:
        """As in `Burst`."""
        return self.time(min([train.tick(train.begin) for train in self.trains if train]))

    @property
    def ends(self) -> int:
        """As in `Burst`."""
        return self.time(max([train.tick(train.end - 1) for train in self.trains if train]))

    def only(self, latch: int) -> bool:
        """As in `Burst`."""
        return all(train.motor == latch for train in self.trains if train)

    def columns(self) -> Columns:
        """As in `Burst`."""
        if len(self) < _ARRAY_FROM:
            return self._plain_columns()
        trains = [train for train in self.trains if train]
        ticks = np.concatenate([train.tick_array() for train in trains])
        motors = np.repeat([train.motor for train in trains], [len(train) for train in trains])
        rows = np.concatenate(
            [
                np.arange(1, len(train) + 1) * train.direction + self.rows[train.motor]
                for train in trains
            ]
        )
        order = np.argsort(ticks, kind="stable")
        times = self.start + ticks[order] * self.over // self.under
        nibbles = np.array(self.ring, dtype=np.int64)[rows[order] % len(self.ring)]
        return Columns(times, motors[order], nibbles)

    def _plain_columns(self) -> Columns:
        """`columns` for a few writes."""
        return self._columns_of(self._first(len(self)))

    def _first(self, count: int) -> list[tuple[int, int, int]]:
        """The first writes: the tick, which train's, and the place in the ring that is written."""
        writes: list[tuple[int, int, int]] = []
        for order, train in enumerate(self.trains):
            row, way = self.rows[train.motor], train.direction
            phase, over, under = train.phase, train.over, train.under
            writes += [
                ((phase + step * over) // under, order, row + way * number)
                for number, step in enumerate(train.steps(count), start=1)
            ]
        writes.sort()
        return writes[:count]

    def _columns_of(self, writes: Sequence[tuple[int, int, int]]) -> Columns:
        """Some of its writes, as `_first` has them."""
        ring, round_it = self.ring, len(self.ring)
        return Columns(
            [self.time(tick) for tick, _, _ in writes],
            [self.trains[order].motor for _, order, _ in writes],
            [ring[row % round_it] for _, _, row in writes],
        )

    def split(self, count: int) -> tuple[Pulses, Pulses]:
        """As in `Burst`."""
        if len(self.trains) == 1:
            return self._cut([count])
        if count <= _FEW:
            first = [order for _, order, _ in self._first(count)]
            return self._cut([first.count(order) for order in range(len(self.trains))])
        # The tick of the last write that belongs to the first part, and what comes before it.
        low, high = 0, max([train.tick(train.end - 1) for train in self.trains if train], default=0)
        while low < high:
            middle = (low + high) // 2
            if sum([train.before(middle + 1) for train in self.trains]) < count:
                low = middle + 1
            else:
                high = middle
        done = [train.before(low) for train in self.trains]
        for order, train in enumerate(self.trains):
            if sum(done) < count and train.before(low + 1) > done[order]:
                done[order] += 1
        return self._cut(done)

    def first(self, count: int) -> tuple[Columns, Pulses]:
        """As in `Burst`."""
        if count > _FEW:
            near, rest = self.split(count)
            return near.columns(), rest
        if len(self.trains) == 1:
            return self._first_of_one(self.trains[0], count)
        writes = self._first(count)
        done = [0] * len(self.trains)
        for _, order, _ in writes:
            done[order] += 1
        trains = [train.rest(steps) for train, steps in zip(self.trains, done, strict=True)]
        return self._columns_of(writes), self._with(trains, self._rows_after(done))

    def _first_of_one(self, train: Train, count: int) -> tuple[Columns, Pulses]:
        """`first` of a burst that is one train."""
        start, over, under = self.start, self.over, self.under
        phase, rise, parts = train.phase, train.over, train.under
        motor, way, ring = train.motor, train.direction, self.ring
        row, round_it, steps = self.rows[motor], len(ring), train.steps(count)
        done = len(steps)
        writes = Columns(
            [start + (phase + step * rise) // parts * over // under for step in steps],
            [motor] * done,
            [ring[(row + way * number) % round_it] for number in range(1, done + 1)],
        )
        return writes, self._with([train.rest(done)], self._rows_after([done]))

    def until(self, time: int) -> tuple[Pulses, Pulses]:
        """As in `Burst`."""
        tick = self.first_tick_from(time)
        return self._cut([train.before(tick) for train in self.trains])

    def before_pause(self, pause: int) -> Pulses:
        """As in `Burst`."""
        if self._even(pause):
            return self
        count = len(self.columns().before_pause(pause))
        return self if count == len(self) else self.split(count)[0]

    def _even(self, pause: int) -> bool:
        """Whether its longest train alone leaves no pause in it."""
        train = max(self.trains, key=len)
        apart = -(-train.over // train.under) * self.over // self.under + 1
        first, last = self.time(train.tick(train.begin)), self.time(train.tick(train.end - 1))
        return max(apart, first - self.begins, self.ends - last) < pause

    def _cut(self, done: Sequence[int]) -> tuple[Pulses, Pulses]:
        """So many writes of each train, and the rest of them."""
        pieces = [train.cut(count) for train, count in zip(self.trains, done, strict=True)]
        return (
            self._with([first for first, _ in pieces], self.rows),
            self._with([rest for _, rest in pieces], self._rows_after(done)),
        )

    def _rows_after(self, done: Sequence[int]) -> list[int]:
        """`rows` after so many writes of each train."""
        rows = list(self.rows)
        for train, count in zip(self.trains, done, strict=True):
            rows[train.motor] += train.direction * count
        return rows

    def _with(self, trains: Sequence[Train], rows: Sequence[int]) -> Pulses:
        return Pulses(self.start, self.over, self.under, tuple(trains), rows, self.ring)

    def held(self) -> Iterable[tuple[int, int]]:
        """As in `Burst`."""
        for train in self.trains:
            if train:
                row = self.rows[train.motor] + train.direction * len(train)
                yield train.motor, self.ring[row % len(self.ring)]
