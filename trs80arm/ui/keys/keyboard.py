"""The way of a key press from the terminal to the TRS-80's keyboard matrix.

Decides what a press is: a key that really is held, a key for the timer or the latch to hold in
manual mode, or a typed one. `HeldKeys` then says when which switch closes.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from trs80arm.machine.jog_keys import JogKeys
from trs80arm.options import KeyMode
from trs80arm.rig import Key, Waiting
from trs80arm.ui.keys.held_keys import HeldKeys
from trs80arm.ui.keys.host_keys import trs80_keys


class Machine(Protocol):
    """The rig, as far as its keyboard goes."""

    @property
    def time(self) -> float:
        """Virtual seconds since power-on."""

    @property
    def waiting(self) -> Waiting:
        """What the machine waits for."""

    def press(self, key: Key) -> None:
        """Close a switch."""

    def release(self, key: Key) -> None:
        """Open a switch."""

    def stop_typing(self) -> None:
        """Forget what is still to be typed."""


class Desk(Protocol):
    """Where the machine stands; it may be put away for another one."""

    @property
    def rig(self) -> Machine:
        """The machine that stands there now."""

    @property
    def jog_keys(self) -> JogKeys:
        """Its keys of manual mode."""


class Keyboard:
    """The operator's hands.

    Args:
        desk: whose keyboard it is.
        held: the fingers.
        mode: how presses become held keys; AUTO follows what the terminal tells.
        wall: the wall's clock in seconds.
    """

    def __init__(
        self, desk: Desk, held: HeldKeys, mode: KeyMode, wall: Callable[[], float]
    ) -> None:
        self._desk = desk
        self.held = held
        self.mode = mode
        self.reports_releases = mode is KeyMode.EVENTS
        self._wall = wall
        self._was_manual = False

    @property
    def _leave(self) -> Key:
        """The key that ends manual mode, which neither timer nor latch holds."""
        return self._desk.jog_keys.leave

    @property
    def in_use(self) -> KeyMode:
        """The mode that is really in use: EVENTS, REPEAT or LATCH."""
        if self.mode is KeyMode.LATCH:
            return KeyMode.LATCH
        if self.mode is KeyMode.REPEAT or not self.reports_releases:
            return KeyMode.REPEAT
        return KeyMode.EVENTS

    @property
    def manual(self) -> bool:
        """Whether the machine is in manual mode, where keys move joints while they are down."""
        return self._desk.rig.waiting is Waiting.SET

    def went_down(self, base: str, name: str, text: str | None) -> None:
        """A key went down, and the terminal will tell when it goes up."""
        keys = trs80_keys(name, text)
        if keys is None:
            return
        if self.in_use is KeyMode.LATCH:
            self._latch_or_tap(keys)
        else:
            self._before(keys)
            self.held.key_down(base, keys)
        self.feed()

    def told(self, releases: bool) -> None:
        """The terminal told whether it reports releases; a user who insists knows better."""
        if self.mode is not KeyMode.EVENTS:
            self.reports_releases = releases

    def went_up(self, base: str) -> None:
        """A key went up."""
        self.held.key_up(base)
        self.feed()

    def typed(self, name: str, text: str | None) -> None:
        """A key came from a terminal that does not tell when it goes up."""
        if self.reports_releases and self.mode is not KeyMode.REPEAT:
            return
        keys = trs80_keys(name, text)
        if keys is None:
            return
        if self.in_use is KeyMode.LATCH:
            self._latch_or_tap(keys)
        elif self.manual and self._leave not in keys and Key.BREAK not in keys:
            self.held.hold_a_while(keys, self._wall())
        else:
            self._before(keys)
            self.held.tap(keys)
        self.feed()

    def _latch_or_tap(self, keys: tuple[Key, ...]) -> None:
        if not self.manual or self._leave in keys:
            self.held.unlatch()
            self._before(keys)
            self.held.tap(keys)
        elif keys in ((Key.SPACE,), (Key.BREAK,)) and self.held.latched:
            self.held.unlatch()
        elif Key.BREAK in keys:
            self.held.tap(keys)
        else:
            self.held.latch(keys)

    def _before(self, keys: tuple[Key, ...]) -> None:
        """BREAK also ends a paste that is being typed."""
        if Key.BREAK in keys:
            self._desk.rig.stop_typing()

    def tap(self, *keys: Key) -> None:
        """Type a key, as a command of the program does."""
        self._before(keys)
        self.held.tap(keys)
        self.feed()

    def point(self, key: Key) -> None:
        """The mouse holds a key."""
        self.held.point(key)
        self.feed()

    def unpoint(self) -> None:
        """The mouse lets go."""
        self.held.unpoint()
        self.feed()

    def latch(self, key: Key) -> None:
        """The mouse turns a key on, or off if it was."""
        self.held.latch((key,))
        self.feed()

    def let_go(self) -> None:
        """Take all hands off: the focus is gone."""
        self.held.release_all()
        self.feed()

    def start_afresh(self) -> None:
        """The machine was switched off and on, or is another one."""
        self.held.start_afresh()
        self._was_manual = False

    def feed(self) -> None:
        """Close and open the switches that are due: at every frame, and at every event."""
        machine = self._desk.rig
        waiting = machine.waiting
        if self._was_manual and not self.manual:
            self.held.unlatch()
        self._was_manual = self.manual
        changes = self.held.changes(
            machine.time,
            self._wall(),
            manual=waiting is Waiting.SET,
            ready=waiting is not Waiting.NOTHING,
        )
        for key, down in changes:
            if down:
                machine.press(key)
            else:
                machine.release(key)
