"""How often the program looks at the machine: once a frame while something goes on, seldom if not.

Each look costs as much again as what is done in it: who was asleep finds the processor's caches
full of other things. So there are two looks a frame only where a finger is on a key, or where the
machine is to do more than it gets done. At READY with nobody at the keyboard, and in a pause,
nothing happens but that the cursor blinks and the clock goes on. Anything that comes from outside
wakes the program at once.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from textual.app import App
from textual.timer import Timer

from trs80arm.desk.pacing import TICK

STEADY = 1 / 30
"""Seconds of the wall between two looks while something goes on by itself."""
REST = 0.25
"""Seconds of the wall between two looks while nothing goes on: two to each half of a blink."""
AWAKE = 0.5
"""Seconds for which the program stays awake after something came from outside."""


class Heartbeat:
    """Calls the program's tick.

    Args:
        tick: looks at the machine.
        busy: whether something goes on.
        hurried: whether it is to be looked at every `TICK`.
        wall: the wall's clock in seconds.

    Attributes:
        every: seconds of the wall to the next look.
    """

    def __init__(
        self,
        tick: Callable[[], None],
        busy: Callable[[], bool],
        hurried: Callable[[], bool],
        wall: Callable[[], float],
    ) -> None:
        self._tick = tick
        self._busy = busy
        self._hurried = hurried
        self._wall = wall
        self._awake_until = 0.0
        self._timers: dict[float, Timer] = {}
        self.every = TICK

    @property
    def resting(self) -> bool:
        """Whether nothing goes on."""
        return self.every == REST

    def begin(self, app: App[Any]) -> None:
        """Let time begin."""
        for every in (TICK, STEADY, REST):
            self._timers[every] = app.set_interval(every, self.beat, pause=every != self.every)

    def wake(self) -> None:
        """Something came from outside: look often, for a while at least.

        A program that rested is brought up to now first, so that what woke it happens now.
        """
        self._awake_until = self._wall() + AWAKE
        if self.resting:
            self._go_on(TICK)
            self._tick()

    def stay_awake(self) -> None:
        """Something came that was found by looking: look often, for a while at least."""
        self._awake_until = self._wall() + AWAKE

    def beat(self) -> None:
        """Look, and see when to look again."""
        self._tick()
        awake = self._wall() < self._awake_until or self._busy()
        self._go_on(REST if not awake else TICK if self._hurried() else STEADY)

    def _go_on(self, every: float) -> None:
        if every == self.every:
            return
        for one in (self.every, every):
            if one in self._timers:
                (self._timers[one].resume if one == every else self._timers[one].pause)()
        self.every = every
