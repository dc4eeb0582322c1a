"""Whose finger is on which key: one picture of the TRS-80's keyboard from four sources.

Keys are held by the physical keyboard (where the terminal reports releases), by the timer (where it
does not), by the latch, and by the mouse on the matrix. The app asks `changes` at every frame and
hands them to the rig. Nothing here knows Textual or looks at a clock: both times are given.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Hashable
from dataclasses import dataclass, field
from itertools import islice

from trs80arm.options import TerminalSettings
from trs80arm.rig import Key

HOLD = 0.060
"""Virtual seconds for which a typed key is down at least: the debounce pause is 51 ms."""
PERIOD = 0.070
"""Virtual seconds from one typed key to the next: the pause and the echo."""
LIFT = 0.040
"""Virtual seconds for which a key is up before it is typed again, so that a scan sees it up."""
GLANCE = 0.250
"""Virtual seconds after ENTER until keys go on to a machine that has not asked for more."""
TOUCH = 0.020
"""Virtual seconds for which a key is down at least in manual mode: two steps at any speed."""
MOST_ALIKE = 60
"""Strokes of one key in a row that may wait; more than that were auto-repeat, not typing."""
MOST_QUEUED = 4096
"""Strokes that may wait: some program types, at its own pace, for which the ROM takes minutes."""

Keys = tuple[Key, ...]


@dataclass
class _Stroke:
    """One key of the host going down, and up if its terminal says so."""

    keys: Keys
    source: Hashable | None
    """Whose release ends it; None for a tap, which ends by itself."""
    since: float = 0.0
    up: bool = False
    """Whether the finger has left the key; the matrix may have to wait a little longer."""


@dataclass
class HeldKeys:
    """The keys that are held down, and those that wait for their turn.

    Attributes:
        tap_seconds: how long a key is held after a press without releases, in seconds of the wall.
        repeat_seconds: how long it is held after each repeat.
    """

    tap_seconds: float = TerminalSettings.tap_ms / 1000
    repeat_seconds: float = TerminalSettings.repeat_ms / 1000
    _queue: deque[_Stroke] = field(default_factory=deque)
    _strokes: list[_Stroke] = field(default_factory=list)
    _timed: dict[Keys, float] = field(default_factory=dict)
    _last_timed: Keys | None = None
    _latched: set[Key] = field(default_factory=set)
    _pointed: set[Key] = field(default_factory=set)
    _down: frozenset[Key] = frozenset()
    _last_stroke: float = -PERIOD
    _lifted: dict[Key, float] = field(default_factory=dict)
    _after_enter: bool = False

    @property
    def busy(self) -> bool:
        """Whether any key is down or waits for its turn."""
        return bool(self._queue or self._strokes or self._timed or self._down or self._wanted())

    @property
    def waiting(self) -> int:
        """How many strokes wait for their turn."""
        return len(self._queue)

    # -- the four sources -------------------------------------------------------------------------

    def key_down(self, source: Hashable, keys: Keys) -> None:
        """A finger goes down on a key of the host that is `keys` on the TRS-80."""
        if not any(stroke.source == source for stroke in (*self._strokes, *self._queue)):
            self._add(_Stroke(keys, source))

    def key_up(self, source: Hashable) -> None:
        """The finger of that press leaves it. A release without a press is nothing."""
        for stroke in (*self._strokes, *self._queue):
            if stroke.source == source:
                stroke.up = True
                stroke.source = None

    def tap(self, keys: Keys) -> None:
        """A key is typed: down, and up again by itself."""
        self._add(_Stroke(keys, None, up=True))

    def _add(self, stroke: _Stroke) -> None:
        if Key.BREAK in stroke.keys:
            self._queue.clear()
        last = list(islice(reversed(self._queue), MOST_ALIKE))
        repeated = len(last) == MOST_ALIKE and all(each.keys == stroke.keys for each in last)
        if not repeated and len(self._queue) < MOST_QUEUED:
            self._queue.append(stroke)

    def hold_a_while(self, keys: Keys, wall: float) -> None:
        """A press or a repeat came from a terminal without releases; the timer holds the key."""
        repeated = keys == self._last_timed
        self._timed[keys] = wall + (self.repeat_seconds if repeated else self.tap_seconds)
        self._last_timed = keys

    def latch(self, keys: Keys) -> None:
        """Turn a key on, or off if it was."""
        held = set(keys)
        if held <= self._latched:
            self._latched -= held
        else:
            self._latched |= held

    def unlatch(self) -> None:
        """Turn all latched keys off."""
        self._latched.clear()

    def point(self, key: Key) -> None:
        """The mouse goes down on a key of the matrix."""
        self._pointed.add(key)

    def unpoint(self) -> None:
        """The mouse lets go."""
        self._pointed.clear()

    def release_all(self) -> None:
        """Take every finger off: the window lost the focus, or a dialog opened.

        What was typed before is typed still.
        """
        self._strokes = [stroke for stroke in self._strokes if stroke.source is None]
        for stroke in self._queue:
            stroke.up = True
            stroke.source = None
        self._timed.clear()
        self._last_timed = None
        self._latched.clear()
        self._pointed.clear()

    @property
    def down(self) -> frozenset[Key]:
        """The keys whose switches are closed."""
        return self._down

    @property
    def latched(self) -> frozenset[Key]:
        """The keys that the latch holds."""
        return frozenset(self._latched)

    # -- what the machine sees --------------------------------------------------------------------

    def changes(
        self, now: float, wall: float, *, manual: bool, ready: bool
    ) -> list[tuple[Key, bool]]:
        """The switches to open and close now, in this order: releases, SHIFT, presses.

        Args:
            now: virtual seconds since power-on.
            wall: seconds of the wall's clock.
            manual: whether the machine is in manual mode, where keys are held together and nothing
                waits; elsewhere they are typed one after the other, at the pace of the ROM's scan.
            ready: whether the machine waits for the operator.
        """
        self._lift(now, manual)
        self._take_turns(now, manual, ready)
        self._timed = {keys: until for keys, until in self._timed.items() if until > wall}
        down = self._wanted()
        for key in self._down - down:
            self._lifted[key] = now
        changes = [(key, False) for key in sorted(self._down - down)]
        pressed = sorted(down - self._down, key=lambda key: (key is not Key.SHIFT, key))
        changes += [(key, True) for key in pressed]
        self._down = down
        return changes

    def start_afresh(self) -> None:
        """The machine was switched off and on, or is another one: none of its keys is down."""
        self.release_all()
        self._queue.clear()
        self._strokes.clear()
        self._down = frozenset()
        self._lifted.clear()
        self._last_stroke = -PERIOD
        self._after_enter = False

    def _lift(self, now: float, manual: bool) -> None:
        least = TOUCH if manual else HOLD
        self._strokes = [
            stroke for stroke in self._strokes if not stroke.up or now < stroke.since + least
        ]

    def _take_turns(self, now: float, manual: bool, ready: bool) -> None:
        if manual or (ready and now >= self._last_stroke + HOLD):
            self._after_enter = False
        while self._queue:
            stroke = self._queue[0]
            if not manual and not self._may_type(stroke, now):
                return
            self._queue.popleft()
            stroke.since = now
            self._strokes.append(stroke)
            self._last_stroke = now
            self._after_enter = Key.ENTER in stroke.keys and not manual

    def _may_type(self, stroke: _Stroke, now: float) -> bool:
        if Key.BREAK in stroke.keys:
            return True
        if now < self._last_stroke + PERIOD:
            return False
        if self._after_enter and now < self._last_stroke + GLANCE:
            return False
        again = set(stroke.keys) - {Key.SHIFT} - self._latched - self._pointed
        # An older finger gives way to the key being typed again, and the switch opens in between.
        self._strokes = [older for older in self._strokes if again.isdisjoint(older.keys)]
        if not again.isdisjoint(self._down):
            return False
        return all(now >= self._lifted.get(key, -LIFT) + LIFT for key in again)

    def _wanted(self) -> frozenset[Key]:
        down = self._latched | self._pointed
        for keys in self._timed:
            down.update(keys)
        for stroke in self._strokes:
            down.update(key for key in stroke.keys if key is not Key.SHIFT)
        # SHIFT goes with the newest key: on today's keyboard it belongs to a sign, not to a time.
        if self._strokes and Key.SHIFT in self._strokes[-1].keys:
            down.add(Key.SHIFT)
        return frozenset(down)
