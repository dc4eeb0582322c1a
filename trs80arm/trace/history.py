"""What the latches and the arm did lately, kept in memory: a logic analyser's and a recorder's.

A `History` is clipped on to a rig's card. It keeps the last writes and the last looks at the arm,
so many of each and no more, for whoever wants to look back: the scope of the terminal.
"""

from __future__ import annotations

from collections.abc import Callable
from math import degrees
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
import numpy.typing as npt

from trs80arm.arm.model import Motor
from trs80arm.machine.card import Card, Latch, Observer
from trs80arm.machine.clock import T_STATES_PER_SECOND, Clock
from trs80arm.pulses import Series

if TYPE_CHECKING:
    from trs80arm.arm.minimover import MiniMover
    from trs80arm.arm.state import ArmState

WRITES = 1 << 16
"""How many latch writes are kept: some minutes of one motor, half a minute of six."""
LOOKS = 1 << 14
"""How many looks at the arm are kept: four minutes of motion at sixty a second."""
LEAST = T_STATES_PER_SECOND // 250
"""T-states between two looks, at least."""
Times = npt.NDArray[np.int64]


class Watched(Protocol):
    """What a history is kept of: a rig."""

    @property
    def card(self) -> Card:
        """The card whose latches are watched."""

    @property
    def clock(self) -> Clock:
        """The clock that the card's writes are timed by."""

    @property
    def state(self) -> ArmState:
        """Where the arm is."""

    @property
    def arm(self) -> MiniMover:
        """The arm, for what its motors bear."""

    def watch_latches(self, observer: Observer) -> Callable[[], None]:
        """Clip an analyser on the card; the function returned takes it off."""


class _Ring:
    """The last rows of a table with times, as arrays of a fixed size."""

    def __init__(self, size: int, columns: int, kind: type) -> None:
        # What is behind the end is never looked at.
        self.times: Times = np.empty(2 * size, dtype=np.int64)
        self.rows: npt.NDArray[Any] = np.empty((2 * size, columns), dtype=kind)
        self._size = size
        self._end = 0

    def add(self, times: npt.ArrayLike, rows: npt.NDArray[np.generic]) -> None:
        """Add rows at the end; the oldest go when it is full."""
        count = len(rows)
        if count > self._size:
            times, rows, count = np.asarray(times)[-self._size :], rows[-self._size :], self._size
        if self._end + count > len(self.times):
            kept = slice(self._end - self._size, self._end)
            self.times[: self._size], self.rows[: self._size] = self.times[kept], self.rows[kept]
            self._end = self._size
        place = slice(self._end, self._end + count)
        self.times[place], self.rows[place] = times, rows
        self._end += count

    def clear(self) -> None:
        self._end = 0

    @property
    def last(self) -> slice:
        """Where the rows that are kept stand."""
        return slice(max(0, self._end - self._size), self._end)


class History:
    """What happened lately, until it is closed.

    Args:
        rig: what to watch.
    """

    each_step = False

    def __init__(self, rig: Watched) -> None:
        self._rig = rig
        self._writes = _Ring(WRITES, 2, np.int8)
        self._looks = _Ring(LOOKS, len(_COLUMNS), np.float64)
        self._held = list(rig.card.latches)
        self._start = rig.clock.now
        self.close = rig.watch_latches(self)
        self._look(self._start)

    def wrote(self, times: Series, latches: Series, nibbles: Series) -> None:
        """Note a burst of writes, and how the arm stands after it (the card calls this)."""
        first, last = int(times[0]), int(times[-1])
        if first < self._latest:
            self._begin_again(first)
        moments = np.asarray(times, dtype=np.int64)
        self._writes.add(moments, np.stack((latches, nibbles), axis=1))
        looked = self._looks.times[self._looks.last][-1]
        if last - looked >= LEAST:
            if first - looked > 2 * LEAST:
                # It stood still from the last look to this burst.
                self._looks.add([first], self._looks.rows[self._looks.last][-1:])
            self._look(last)

    def _look(self, time: int) -> None:
        self._looks.add([time], np.array([_look(self._rig.state, self._rig.arm)]))

    @property
    def _latest(self) -> int:
        times = self._writes.times[self._writes.last]
        return int(times[-1]) if len(times) else self._start

    def _begin_again(self, time: int) -> None:
        """The clock went back: the machine was switched off, or an earlier state restored."""
        self._writes.clear()
        self._looks.clear()
        self._start = time
        self._held = [0] * len(Latch)
        self._look(time)

    @property
    def begin(self) -> int:
        """The T-state from which on all is known."""
        writes = self._writes.last
        return int(self._writes.times[writes.start]) if writes.start else self._start

    @property
    def now(self) -> int:
        """The T-state up to which all is known."""
        return self._rig.clock.now

    @property
    def end(self) -> int:
        """The T-state of the last write."""
        return self._latest

    def nibbles(self, latch: int, times: Times) -> npt.NDArray[np.int64]:
        """What a latch held at some T-states, phi1 as bit 3."""
        moments, values = self.changes(latch)
        place = np.searchsorted(moments, times, side="right")
        return np.concatenate(([self._first(latch)], values))[place]

    def changes(self, latch: int) -> tuple[Times, npt.NDArray[np.int64]]:
        """All writes to a latch that are kept: their T-states and nibbles."""
        times, rows = self._writes.times[self._writes.last], self._writes.rows[self._writes.last]
        mine = rows[:, 0] == latch
        return times[mine], rows[mine, 1].astype(np.int64)

    def _first(self, latch: int) -> int:
        """What a latch held before the writes that are kept, as far as it is known."""
        return self._held[latch] if self._writes.last.start == 0 else 0

    def quantity(self, name: str, times: Times) -> npt.NDArray[np.float64]:
        """One of the recorder's quantities at some T-states.

        Args:
            name: `rotor 1` to `rotor 6` (half-steps); `angle 1` to `angle 6` (degrees of a
                joint or wrist gear; inches of opening); `torque 1` to `torque 6` (ounce-inches at
                the joint, ounces at the hand); `force` (pounds).
            times: T-states.
        """
        column = _COLUMNS.index(name)
        last = self._looks.last
        values = self._looks.rows[last, column]
        return np.asarray(np.interp(times, self._looks.times[last], values))

    def speed(self, joint: int, times: Times) -> npt.NDArray[np.float64]:
        """How fast a joint, 1 to 6, was turned at some T-states, degrees (inches) a second."""
        return _rate(self.quantity(f"angle {joint}", times), times)

    def margin(self, joint: int, times: Times) -> npt.NDArray[np.float64]:
        """The share of its torque that a motor had left at some T-states, per cent; 0 is too much.

        A moving motor has the less the faster it goes, and what helps it counts for nothing; a
        standing one has what it holds.
        """
        drive = self._rig.arm.model.drives[joint - 1]
        curve = self._rig.arm.strength.curves[drive.turns]
        rate = _rate(self.quantity(f"rotor {joint}", times), times)
        rate /= self._rig.arm.settings.speed_margin
        torque = self.quantity(f"torque {joint}", times)
        way = 1.0 if drive.turns is Motor.BASE else np.sign(rate) * drive.sign
        moving = 1 - curve.uses(np.maximum(0.0, torque * way), rate)
        left: npt.NDArray[np.float64] = 100 * np.where(
            np.abs(rate) < 1, 1 - np.abs(torque) / curve.holds, moving
        )
        return left


def _rate(values: npt.NDArray[np.float64], times: Times) -> npt.NDArray[np.float64]:
    """How fast something changes, a second."""
    if len(times) < 2:
        return np.zeros(len(times))
    return np.gradient(values, times / T_STATES_PER_SECOND)


_COLUMNS = (
    *(f"rotor {joint}" for joint in range(1, 7)),
    *(f"angle {joint}" for joint in range(1, 7)),
    *(f"torque {joint}" for joint in range(1, 7)),
    "force",
)


def _look(state: ArmState, arm: MiniMover) -> tuple[float, ...]:
    """The numbers of `_COLUMNS`."""
    turns = dict(zip(list(Motor)[:5], map(degrees, state.angles.driven), strict=True))
    angles = [turns.get(drive.turns, state.pose.opening) for drive in arm.model.drives]
    return (*state.rotors, *angles, *arm.borne(), state.force)
