"""The arm behind a serial line without a screen: what `trs80arm serial` does."""

from __future__ import annotations

import contextlib
import os
import select
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TextIO

from trs80arm.arm.bench import BenchError
from trs80arm.benches import BenchFile
from trs80arm.reasons import one_line
from trs80arm.rig import Rig, RigSettings
from trs80arm.serial import pendant_words
from trs80arm.serial.attendant import Attendant, Logged
from trs80arm.serial.endpoints import Port, open_port
from trs80arm.serial.pendant import DIGITS
from trs80arm.serial.pendant_keys import FunctionKey, JointKey, key_named
from trs80arm.shown import message

STEADY = 0.01
"""Seconds between two looks at an arm that is at work."""
REST = 0.1
"""The same for one at rest."""
SLICE = 0.25
"""Virtual seconds that pass at once when the arm is to be as fast as it can."""
MOST_OWED = 0.5
"""Seconds that are made up; after a suspend the rest is forgotten."""
TAP = 0.1
"""Virtual seconds for which a key of the pendant that moves the arm is held."""
_OF_DIGIT = {str(digit): key.name for key, digit in DIGITS.items()}
_NUMBERS = frozenset(map(str, range(1000)))
MOST_TYPED = 4096
"""Bytes of a line that is typed."""


class ServingError(Exception):
    """The arm cannot be served; one clear line."""


@dataclass(frozen=True)
class Serving:
    """What is asked of `trs80arm serial`.

    Attributes:
        settings: of the machine; it must have a controller.
        bench: the bench file, None for the standard bench.
        tcp: the number of a TCP port; None for a pseudo-terminal.
        speed: virtual seconds a second; None is as fast as can be while the arm is at work.
        log: whether every line is printed.
    """

    settings: RigSettings
    bench: Path | None = None
    tcp: int | None = None
    speed: float | None = 1.0
    log: bool = False


def serve(serving: Serving) -> None:
    """Serve the arm until Ctrl+C, its stop key being ENTER.

    Raises:
        ServingError: the bench is none for the arm.
        EndpointError: the line cannot be had.
    """
    try:
        bench = BenchFile.read(serving.bench).bench if serving.bench else None
        rig = Rig(serving.settings, bench)
    except BenchError as error:
        raise ServingError(one_line(error)) from None
    port = open_port(serving.tcp)
    try:
        print(port.name, flush=True)
        server = Server(rig, port, serving.speed, log=_print if serving.log else None)
        server.run(Keys(sys.stdin))
    except KeyboardInterrupt:
        pass
    finally:
        port.close()


def _print(line: Logged) -> None:
    print(line, flush=True)


class Server:
    """Lets an arm's time pass with the wall's, and attends to its line.

    Args:
        rig: the machine; it must have a controller.
        port: where clients are.
        speed: virtual seconds a second; None is as fast as can be while the arm is at work.
        log: told every line.
        wall: the wall's clock in seconds.
    """

    def __init__(
        self,
        rig: Rig,
        port: Port,
        speed: float | None,
        *,
        log: Callable[[Logged], None] | None = None,
        wall: Callable[[], float] = time.monotonic,
    ) -> None:
        self.rig = rig
        self.port = port
        self.attendant = Attendant(port, rig, log)
        self._speed = speed
        self._wall = wall
        self._last = wall()

    def run(self, keys: Keys) -> None:
        """Serve for good."""
        while True:
            self.turn()
            self.port.wait(self.rest, keys.watched, sending=self.attendant.unsent)
            for name in keys.lines():
                self.press(name)

    def turn(self) -> None:
        """Let the time pass that has passed, and attend to the line."""
        now = self._wall()
        passed, self._last = min(now - self._last, MOST_OWED), now
        if self._speed is not None:
            self.rig.run_for(passed * self._speed)
        elif self.hurried:
            while self.hurried and self._wall() < now + STEADY:
                self.rig.run_until(lambda rig: not self.hurried, SLICE)
        else:
            self.rig.run_for(passed)
        self.attendant.attend()

    @property
    def hurried(self) -> bool:
        """Whether the arm is at work, and nobody's hands are needed for it."""
        controller = self.rig.controller
        return controller is not None and controller.works_alone

    @property
    def _working(self) -> bool:
        controller = self.rig.controller
        return controller is not None and controller.busy

    @property
    def rest(self) -> float:
        """Seconds until the next look, if nothing comes before."""
        if self._speed is None and self.hurried:
            return 0.0
        return STEADY if self._working else REST

    def press(self, name: str) -> None:
        """Press a key of the pendant for a moment, and say what it shows then.

        Args:
            name: what is typed: the name of a key, a number that the pendant asks for, or nothing
                for the stop key.
        """
        word = name.strip().upper() or FunctionKey.STOP.name
        base = self.rig.controller
        if base is not None and base.pendant.asks is not None and word in _NUMBERS:
            words = [*(_OF_DIGIT[digit] for digit in word), FunctionKey.RUN.name]
        else:
            words = [word]
        try:
            for each in words:
                self.rig.press_pendant(each)
                if isinstance(key_named(each), JointKey):
                    self.rig.run_for(TAP)
                self.rig.release_pendant(each)
        except ValueError as error:
            print(f"trs80arm: {message(error)}", file=sys.stderr, flush=True)
            return
        if base is not None:
            shows = (pendant_words.state(base), pendant_words.message(base))
            print("   ".join(filter(None, shows)), flush=True)


class Keys:
    """Lines that are typed at a stream, looked at without waiting for them.

    A stream that nobody types at, as that of a program in the background, has none; nor has
    Windows' console, which cannot be asked so.

    Args:
        stream: where they are typed.
    """

    def __init__(self, stream: TextIO) -> None:
        self._begun = b""
        self._descriptor: int | None = None
        if sys.platform != "win32":
            with contextlib.suppress(OSError, ValueError):
                self._descriptor = stream.fileno()

    @property
    def watched(self) -> tuple[int, ...]:
        """The file descriptor that has something to read when a line was typed."""
        if self._descriptor is None or not _in_front(self._descriptor):
            return ()
        return (self._descriptor,)

    def lines(self) -> list[str]:
        """What was typed since, line by line."""
        for descriptor in self.watched:
            ready, _, _ = select.select([descriptor], [], [], 0)
            if not ready:
                return []
            try:
                typed = os.read(descriptor, MOST_TYPED)
            except OSError:
                typed = b""
            if not typed:
                self._descriptor = None
            *whole, self._begun = (self._begun + typed)[-MOST_TYPED:].split(b"\n")
            return [line.decode("utf-8", errors="replace") for line in whole]
        return []


def _in_front(descriptor: int) -> bool:
    """Whether a terminal is this program's to read: who is in the background would be stopped."""
    try:
        return os.tcgetpgrp(descriptor) == os.getpgrp()
    except OSError:
        return True
