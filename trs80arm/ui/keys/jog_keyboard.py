"""The pendant's keys: those of manual mode, held by finger, timer, latch or mouse as ever.

The keyboard's way of a press is used as it is; where the machine's matrix would be stands the
pendant, to which it looks as if the machine were in `@SET` all the time.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from trs80arm.desk.session import Session
from trs80arm.machine.jog_keys import JogKeys
from trs80arm.rig import Key, Waiting
from trs80arm.ui.keys.held_keys import HeldKeys
from trs80arm.ui.keys.host_keys import trs80_keys
from trs80arm.ui.keys.keyboard import Keyboard

HELD_AFTER = 0.3
"""Seconds of the wall after which a press is no tap any more: steps follow the first one."""


class Jogged(Protocol):
    """What is jogged: a pendant."""

    def press(self, axis: int, way: int) -> None:
        """A button goes down: of an axis, 0 to 5, and one way or the other, 1 or -1."""

    def hold(self, axis: int, way: int) -> None:
        """It has been down for long."""

    def release(self, axis: int, way: int) -> None:
        """It goes up."""


class _Buttons:
    """The pendant as a machine with nothing but the keys of manual mode."""

    def __init__(self, session: Session, pendant: Jogged, wall: Callable[[], float]) -> None:
        self._session = session
        self._pendant = pendant
        self._wall = wall
        self._since: dict[Key, float] = {}

    @property
    def rig(self) -> _Buttons:
        """The machine that is meant."""
        return self

    @property
    def jog_keys(self) -> JogKeys:
        """The keys that it has."""
        return self._session.jog_keys

    @property
    def time(self) -> float:
        """Virtual seconds since power-on."""
        return self._session.time

    @property
    def waiting(self) -> Waiting:
        """It takes keys to be held, always."""
        return Waiting.SET

    def press(self, key: Key) -> None:
        """A key goes down."""
        if (way := self.way(key)) is not None:
            self._since[key] = self._wall()
            self._pendant.press(*way)

    def hold(self) -> None:
        """The keys that have been down for long are held."""
        for key, since in self._since.items():
            if self._wall() >= since + HELD_AFTER and (way := self.way(key)) is not None:
                self._pendant.hold(*way)

    def release(self, key: Key) -> None:
        """A key goes up."""
        self._since.pop(key, None)
        if (way := self.way(key)) is not None:
            self._pendant.release(*way)

    def stop_typing(self) -> None:
        """BREAK: nothing is typed here."""

    def way(self, key: Key) -> tuple[int, int] | None:
        """The axis and the way of a key; None if it has none."""
        keys = self.jog_keys
        if key in keys.positive:
            return keys.positive.index(key), 1
        if key in keys.negative:
            return keys.negative.index(key), -1
        return None


class JogKeyboard:
    """What the hands do on the pendant.

    Args:
        session: the machine; its settings say which keys jog.
        pendant: what is jogged.
        held: the fingers.
        like: the machine's own keyboard; keys are read as there.
        wall: the wall's clock in seconds.

    Attributes:
        keyboard: the way of a press.
    """

    def __init__(
        self,
        session: Session,
        pendant: Jogged,
        held: HeldKeys,
        like: Keyboard,
        wall: Callable[[], float],
    ) -> None:
        self._buttons = _Buttons(session, pendant, wall)
        self._like = like
        self.keyboard = Keyboard(self._buttons, held, like.mode, wall)
        session.watch_machine(self._start_afresh)

    def _start_afresh(self) -> None:
        self.keyboard.let_go()
        self.keyboard.start_afresh()

    def feed(self) -> None:
        """Press, hold and let go what is due."""
        self.keyboard.feed()
        self._buttons.hold()

    def take_up(self) -> None:
        """Read keys as the machine's keyboard does now."""
        self.keyboard.mode = self._like.mode
        self.keyboard.reports_releases = self._like.reports_releases

    def jogs(self, name: str, text: str | None) -> bool:
        """Whether a key of the terminal is one that jogs."""
        keys = trs80_keys(name, text)
        return keys is not None and any(self._buttons.way(key) for key in keys)

    @property
    def down(self) -> frozenset[Key]:
        """The keys that are down."""
        return self.keyboard.held.down
