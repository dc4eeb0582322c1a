"""How often the program looks at the machine: at every tick while something goes on, seldom if not.

At READY with nobody at the keyboard, and in a pause, nothing happens but that the cursor blinks and
the clock goes on. Anything that comes from outside wakes the program at once.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from textual.app import App
from textual.timer import Timer

from trs80arm.desk.pacing import TICK

REST = 0.25
"""Seconds of the wall between two looks while nothing goes on: two to each half of a blink."""
AWAKE = 0.5
"""Seconds for which the program stays awake after something came from outside."""


class Heartbeat:
    """Calls the program's tick.

    Args:
        tick: looks at the machine.
        busy: whether something goes on.
        wall: the wall's clock in seconds.
    """

    def __init__(
        self, tick: Callable[[], None], busy: Callable[[], bool], wall: Callable[[], float]
    ) -> None:
        self._tick = tick
        self._busy = busy
        self._wall = wall
        self._awake_until = 0.0
        self._quick: Timer | None = None
        self.resting = False

    def begin(self, app: App[Any]) -> None:
        """Let time begin."""
        self._quick = app.set_interval(TICK, self.beat)
        app.set_interval(REST, self.look)

    def wake(self) -> None:
        """Something came from outside: look at every tick, for a while at least.

        A program that rested is brought up to now first, so that what woke it happens now.
        """
        self._awake_until = self._wall() + AWAKE
        if self.resting:
            self._rest(False)
            self._tick()

    def beat(self) -> None:
        """A tick; the last one for now if nothing goes on."""
        self._tick()
        if self._wall() >= self._awake_until and not self._busy():
            self._rest(True)

    def look(self) -> None:
        """One of the few looks while nothing goes on; if something does, ticks follow."""
        if self.resting:
            self._tick()
            self._rest(not self._busy())

    def _rest(self, resting: bool) -> None:
        if resting is self.resting:
            return
        self.resting = resting
        if self._quick is not None:
            (self._quick.pause if resting else self._quick.resume)()
