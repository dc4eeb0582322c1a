"""The wall's clock and the machine's: how much virtual time each slice of the event loop gets.

The app calls `Pacer.advance` from a timer. It owes the machine the wall's time times the speed,
pays in small slices until its budget is used up, carries a little over and drops the rest visibly.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

TICK = 1 / 60
"""Seconds of the wall between two calls of the timer."""
BUDGET = 0.004
"""Seconds of the wall that one call may use at the machine's own speed."""
FAST_BUDGET = 0.007
"""The same when the machine is to go faster, or as fast as it can."""
SLICE = 0.004
"""Virtual seconds in one slice at the start; slices grow and shrink with what they cost."""
LONGEST_SLICE = 0.25
SHORTEST_SLICE = 0.0005
LEAST_OWED = 0.0001
"""Virtual seconds that are too few to be paid now."""
MOST_OWED = 0.5
"""Seconds of the wall that may be owed; after a suspend the rest is forgotten."""
FARTHEST = 2.0
"""Virtual seconds that one call lets pass in a hurry."""
ACHIEVED_OVER = 1.0
"""Seconds of the wall over which the achieved speed is told."""


class Machine(Protocol):
    """What is paced: the rig, or a session that feeds it recorded keys."""

    @property
    def time(self) -> float:
        """Virtual seconds since power-on."""

    @property
    def busy(self) -> bool:
        """Whether it works by itself, instead of waiting for somebody."""

    def run_for(self, seconds: float) -> None:
        """Let virtual time pass."""


class Pacer:
    """Paces one machine.

    Args:
        machine: what is paced.
        wall: the wall's clock in seconds; a test gives its own.
        hurry: whether something goes on that nobody wants to wait for.

    Attributes:
        speed: virtual seconds per second of the wall; None is flat out.
        turbo: whether the machine goes flat out for now, whatever its speed.
        hurries: whether it does so when there is a hurry.
        paused: whether no time passes at all.
        achieved: what was reached of the speed lately, as virtual seconds per second of the wall.
        behind: whether there was more to do than the last call had time for.
    """

    def __init__(
        self,
        machine: Machine,
        wall: Callable[[], float],
        speed: float | None,
        hurry: Callable[[], bool] = lambda: False,
    ) -> None:
        self._wall = wall
        self._hurry = hurry
        self.turbo = False
        self.hurries = True
        self.machine = machine
        self.speed = speed
        self.paused = False
        self.achieved = speed or 1.0
        self.behind = False
        self._slice = SLICE
        self._target = self._left_at = machine.time
        self._last = wall()
        self._measured = (self._last, machine.time)

    @property
    def _budget(self) -> float:
        return BUDGET if self.speed == 1 else FAST_BUDGET

    def set_speed(self, speed: float | None) -> None:
        """Go at another speed from now on; nothing is owed from before."""
        self.speed = speed
        self.achieved = speed or 1.0
        self.forgive()

    def pause(self, paused: bool) -> None:
        """Stop time, or let it go on."""
        self.paused = paused
        self.forgive()

    def forgive(self) -> None:
        """Begin anew from here: after a suspend, or at another speed."""
        self._last = self._wall()
        self._target = self._left_at = self.machine.time
        self._measured = (self._last, self.machine.time)

    def advance(self) -> None:
        """Give the machine its time; never longer than the budget of the wall."""
        now = self._wall()
        passed, self._last = min(now - self._last, MOST_OWED), now
        # What others let pass since the last call, a single step, a whole command or the way to a
        # saved state, is neither owed nor speed.
        by_others = self.machine.time - self._left_at
        self._target += by_others
        self._measured = (self._measured[0], self._measured[1] + by_others)
        self._left_at = self.machine.time
        self.behind = False
        if self.paused:
            return
        self.turbo = self.hurries and self.speed is not None and self._hurry()
        if self.turbo:
            self._hurry_on(now)
        elif self.speed is None:
            self._flat_out(now, passed)
        else:
            self._target += passed * self.speed
            self._pay(now + self._budget)
            # What cannot be made up soon is dropped; the achieved speed tells it.
            self._target = max(self._target, self.machine.time - MOST_OWED)
            self._target = min(self._target, self.machine.time + MOST_OWED * self.speed)
        self._left_at = self.machine.time
        self._measure(now)

    def _flat_out(self, now: float, passed: float) -> None:
        """As fast as can be while it works; while it waits for a person, at a person's speed."""
        machine = self.machine
        self._target = machine.time + passed
        end = now + self._budget
        while machine.busy:
            if not self._one_slice(self._slice) or self._wall() >= end:
                self.behind = True
                return
        self._pay(end)

    def _hurry_on(self, now: float) -> None:
        """As fast as can be until there is no more hurry; nothing is owed for it."""
        machine = self.machine
        end, far = now + FAST_BUDGET, machine.time + FARTHEST
        while self._hurry() and self._wall() < end and machine.time < far:
            self._one_slice(self._slice)
        self.behind = True
        self._target = machine.time

    def _pay(self, end: float) -> None:
        machine = self.machine
        while (owed := self._target - machine.time) > LEAST_OWED:
            if not self._one_slice(min(owed, self._slice)) or self._wall() >= end:
                self.behind = True
                return

    def _one_slice(self, seconds: float) -> bool:
        """Let some time pass; whether any has: not in a machine that a debugger has stopped."""
        began, before = self._wall(), self.machine.time
        self.machine.run_for(seconds)
        cost = self._wall() - began
        # Long slices are cheaper: a motion of many steps is computed as one array.
        budget = self._budget
        if cost > budget * 0.75:
            self._slice = max(self._slice / 2, SHORTEST_SLICE)
        elif cost < budget * 0.4 and seconds >= self._slice:
            self._slice = min(self._slice * 1.5, LONGEST_SLICE)
        return self.machine.time != before

    def _measure(self, now: float) -> None:
        began, virtual = self._measured
        if now - began >= ACHIEVED_OVER:
            self.achieved = (self.machine.time - virtual) / (now - began)
            self._measured = (now, self.machine.time)
