"""The keys of a rig that are about to go down and up."""

from __future__ import annotations

import heapq
from collections.abc import Iterable

from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.machine.keys import Key
from trs80arm.works.devices import KeyEvent, Works


class KeyEvents:
    """What is about to happen to the keys of works, in the order of time.

    Args:
        works: they have the events, as a snapshot does.
    """

    def __init__(self, works: Works) -> None:
        self._works = works

    @property
    def next_time(self) -> int | None:
        """The T-state of the next event; None if nothing is to come."""
        events = self._works.events
        return events[0].time if events else None

    @property
    def typed(self) -> int:
        """How many characters that the typist gave out are still to come."""
        return sum(
            event.typed and event.down and event.key is not Key.SHIFT
            for event in self._works.events
        )

    def add(self, time: int, key: Key, down: bool, *, typed: bool = False) -> None:
        """Let a key go down or up at a T-state; `typed` if the typist does it."""
        works = self._works
        works.order += 1
        heapq.heappush(works.events, KeyEvent(time, works.order, key, down, typed))

    def hold(self, keys: Iterable[Key], seconds: float) -> None:
        """Let keys go down together now, and up after `seconds` of virtual time."""
        now = self._works.clock.now
        end = now + round(seconds * T_STATES_PER_SECOND)
        for key in keys:
            self.add(now, key, True)
            self.add(end, key, False)

    def move(self) -> None:
        """Let the keys go down and up whose time has come."""
        works = self._works
        events = works.events
        if events:
            now, matrix = works.clock.now, works.matrix
            while events and events[0].time <= now:
                event = heapq.heappop(events)
                (matrix.press if event.down else matrix.release)(event.key)

    def release_all(self) -> None:
        """Let every key go, also those that were still to be pressed."""
        self._works.events.clear()
        self._works.matrix.release_all()

    def stop_typing(self) -> None:
        """Forget what is still to be typed, in the middle of a line too."""
        works = self._works
        works.typist.clear(works.clock.now)
        to_come = {event.key for event in works.events if event.typed and not event.down}
        # A key that is down already goes up once more; all else that was typed is void.
        up = dict.fromkeys(to_come & works.matrix.held, True)
        works.events = [
            event
            for event in sorted(works.events)
            if not event.typed or (not event.down and up.pop(event.key, False))
        ]
