"""The demonstration: the article's pick and place, with captions, until a key is pressed.

A list of scenes; each says something, does something, and goes on when something has happened or
some virtual time has passed.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from trs80arm.bundled import along
from trs80arm.desk.session import Session
from trs80arm.rig import Key, Waiting

PROGRAM = "table4.bas"


@dataclass(frozen=True)
class Scene:
    """One thing of the demonstration.

    Attributes:
        caption: what is said.
        do: what is done when it begins.
        until: what it waits for; None for its time alone.
        seconds: virtual seconds that it lasts at least.
    """

    caption: str
    do: Callable[[Session], None] = lambda session: None
    until: Callable[[Session], bool] | None = None
    seconds: float = 0.0


def _type(text: str) -> Callable[[Session], None]:
    return lambda session: session.rig.type(text)


def _hold(keys: tuple[Key, ...], seconds: float) -> Callable[[Session], None]:
    return lambda session: session.rig.hold(keys, seconds)


def _waits(what: Waiting) -> Callable[[Session], bool]:
    return lambda session: session.rig.waiting is what and not session.rig.typing


def _holds(session: Session) -> bool:
    return session.rig.state.held is not None


def _holds_nothing(session: Session) -> bool:
    return session.rig.state.held is None


SCENES: tuple[Scene, ...] = (
    Scene("A TRS-80 with ARMBASIC, and the MiniMover 5 of 1980. Any key ends this.", seconds=4),
    Scene(
        "Its own printed program, Table 4: pick and place by X, Y, Z.",
        _type("LIST 10-120\r"),
        _waits(Waiting.COMMAND),
        5,
    ),
    Scene(
        "RUN: first it works out the joints for every point.",
        _type("RUN\r"),
        _waits(Waiting.SET),
        2,
    ),
    Scene(
        "@SET: keys move the joints while held. 6 opens the hand.",
        _hold((Key.N6,), 1.0),
        seconds=2.5,
    ),
    Scene(
        "1 and W together: base and shoulder at once...", _hold((Key.N1, Key.W), 0.6), seconds=1.8
    ),
    Scene("...and Q and 2 take them back.", _hold((Key.Q, Key.N2), 0.6), seconds=1.8),
    Scene("0 ends manual mode, and the task begins.", _hold((Key.N0,), 0.1), seconds=3),
    Scene("Down to the part. @CLOSE closes the hand until its switch feels it.", until=_holds),
    Scene("All joints start and end together: every @STEP is one sweep.", until=_holds_nothing),
    Scene("The hand opens: the tray takes the part, the feeder brings the next one.", seconds=6),
    Scene("Registers count what was commanded; beside them, where the joints are.", seconds=10),
    Scene("The arm has no sensors but the grip switch: a step that slips is lost.", seconds=10),
    Scene("It goes on like this. Press a key, and the machine is yours.", seconds=3600),
)


class Demo:
    """A demonstration on a session.

    Args:
        session: the machine; it gets the program and its bench.

    Attributes:
        caption: what is to be shown now.
        over: whether the last scene has ended.
    """

    def __init__(self, session: Session) -> None:
        program = along(PROGRAM)
        session.set_bench(program.with_suffix(".toml"))
        session.load(program)
        self._session = session
        self._next = 0
        self._began = session.time
        self.caption = ""
        self.over = False
        self._begin()

    def _begin(self) -> None:
        scene = SCENES[self._next]
        self._began = self._session.time
        self.caption = scene.caption
        scene.do(self._session)

    def go_on(self) -> None:
        """Begin the next scene if this one has ended."""
        scene = SCENES[self._next]
        if self._session.time < self._began + scene.seconds:
            return
        if scene.until is not None and not scene.until(self._session):
            return
        if self._next + 1 == len(SCENES):
            self.over = True
            return
        self._next += 1
        self._begin()

    def stop(self) -> None:
        """Leave it: nothing more is typed, and every key is let go."""
        self._session.rig.stop_typing()
        self._session.rig.release_all()
        self.over = True
