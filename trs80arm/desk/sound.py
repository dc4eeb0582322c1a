"""Sound of the line to the cassette recorder: programs of the period made music on it by OUT 255.

When the line's level changes is known to a T-state, so the sound is the machine's own, in virtual
time. It is heard by the terminal's bell, which says no more than that there is a sound, or through
the computer's loudspeaker, if the library `sounddevice` is there (extra `sound`). Nothing waits for
it: what comes faster than it can be heard is left out.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from typing import Any, Protocol

import numpy as np

from trs80arm.desk.asking import Say
from trs80arm.desk.session import Session
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.options import Sound
from trs80arm.rig import Rig

RATE = 22_050
"""Samples a second."""
LOUDNESS = 6000
"""Of 32,767."""
PRESSURE = (0, LOUDNESS, -LOUDNESS, 0)
"""The sample for each level of the line: 0.46, 0.85 and 0 volts, and 0.46 again."""
LULL = 0.3
"""Virtual seconds without a change after which the line is silent."""
MOST_AHEAD = RATE // 2
"""Samples that wait to be heard at most."""

Change = tuple[float, int]
"""A virtual second, and the level from then on."""


class Loudspeaker(Protocol):
    """What makes the line's changes heard."""

    def play(self, changes: Sequence[Change], until: float) -> None:
        """Take the changes since the last call, up to a virtual second."""

    def close(self) -> None:
        """Be silent from now on."""


class BellRinger:
    """Rings where a sound begins.

    Args:
        ring: the terminal's bell.
    """

    def __init__(self, ring: Callable[[], object]) -> None:
        self._ring = ring
        self._last = -LULL

    def play(self, changes: Sequence[Change], until: float) -> None:
        """Ring if there is sound after a silence."""
        for time, _ in changes:
            if time - self._last >= LULL:
                self._ring()
            self._last = time

    def close(self) -> None:
        """A bell has nothing to close."""


class Samples:
    """Turns the line's changes into samples, which whoever plays them takes when he likes.

    Those that come faster than they are heard are left out, the oldest first.
    """

    def __init__(self) -> None:
        self._level = 0
        self._from = 0.0
        self._last = -LULL
        self._waiting = bytearray()
        self._lock = threading.Lock()

    def play(self, changes: Sequence[Change], until: float) -> None:
        """Add the samples from the last call until then; none while the line is silent."""
        if not changes and until - self._last > LULL:
            self._level, self._from = 0, until
            return
        if changes and changes[0][0] - self._last > LULL:
            self._from = changes[0][0]
        times = [self._from, *(time for time, _ in changes), until]
        levels = [self._level, *(level for _, level in changes)]
        edges = np.round(np.asarray(times) * RATE).astype(np.int64)
        counts = np.maximum(np.diff(edges), 0)
        pressures = np.asarray(PRESSURE, dtype="<i2")[np.asarray(levels)]
        self._add(np.repeat(pressures, counts).tobytes())
        if changes:
            self._last, self._level = changes[-1]
        self._from = until

    def _add(self, samples: bytes) -> None:
        with self._lock:
            self._waiting += samples
            excess = len(self._waiting) - 2 * MOST_AHEAD
            if excess > 0:
                del self._waiting[:excess]

    def take(self, count: int) -> bytes:
        """The next samples, 16 bits each with the low byte first; silence where there are none."""
        with self._lock:
            taken = bytes(self._waiting[: 2 * count])
            del self._waiting[: 2 * count]
        return taken.ljust(2 * count, b"\0")


class SampledSound:
    """The computer's loudspeaker, through `sounddevice`.

    It is opened beside the program, for that may take seconds.

    Args:
        failed: is told why there is no sound.
    """

    def __init__(self, failed: Callable[[str], object]) -> None:
        self.samples = Samples()
        self._failed = failed
        self._stream: Any = None
        self._closed = False
        threading.Thread(target=self._open, daemon=True).start()

    def _open(self) -> None:
        try:
            import sounddevice

            stream = sounddevice.RawOutputStream(
                samplerate=RATE, channels=1, dtype="int16", callback=self._fill
            )
            stream.start()
        except ImportError:
            self._failed("sounddevice is not installed (extra `sound`)")
        except Exception as error:
            # Whatever the system's sound has to say: no library, no device, a busy one.
            self._failed(str(error))
        else:
            self._stream = stream
            if self._closed:
                self.close()

    def _fill(self, out: Any, frames: int, time: object, status: object) -> None:
        out[:] = self.samples.take(frames)

    def play(self, changes: Sequence[Change], until: float) -> None:
        """Hand the changes on."""
        self.samples.play(changes, until)

    def close(self) -> None:
        """Be silent from now on."""
        self._closed = True
        stream, self._stream = self._stream, None
        if stream is not None:
            stream.abort()
            stream.close()


class LineSound:
    """Lets a session's machine be heard.

    Args:
        session: whose machine.
        ring: the terminal's bell.
        say: tells its user when there is no sound.
        sound: how it is heard.
        far: whether its user sits elsewhere, at a browser, and not by this computer's loudspeaker.
    """

    def __init__(
        self,
        session: Session,
        ring: Callable[[], object],
        say: Say,
        sound: Sound = Sound.OFF,
        *,
        far: bool = False,
    ) -> None:
        self._session = session
        self._ring = ring
        self._say = say
        self._far = far
        self._rig: Rig | None = None
        self._stop: Callable[[], None] = lambda: None
        self._changes: list[Change] = []
        self._loudspeaker: Loudspeaker | None = None
        self._trouble: str | None = None
        self.sound = Sound.OFF
        self.use(sound)

    def use(self, sound: Sound) -> None:
        """Be heard in another way from now on, or not at all."""
        if self._loudspeaker is not None:
            self._loudspeaker.close()
        self._loudspeaker = None
        self.sound = sound
        if sound is Sound.BELL:
            self._loudspeaker = BellRinger(self._ring)
        elif sound is Sound.SAMPLES and self._far:
            self._loudspeaker = BellRinger(self._ring)
            self._failed("the loudspeaker is at the other computer")
        elif sound is Sound.SAMPLES:
            self._loudspeaker = SampledSound(self._failed)
        self._changes.clear()
        self._listen()

    def _failed(self, why: str) -> None:
        """Told from beside the program; `go_on` says it."""
        self._trouble = why

    def _listen(self) -> None:
        """Listen to the machine on the desk, if anything is to be heard."""
        wanted = self._session.rig if self._loudspeaker is not None else None
        if wanted is not self._rig:
            self._stop()
            self._rig = wanted
            self._stop = wanted.watch_line(self._changed) if wanted else (lambda: None)

    def _changed(self, time: int, level: int) -> None:
        self._changes.append((time / T_STATES_PER_SECOND, level))

    def go_on(self) -> None:
        """Let what the machine did since the last call be heard."""
        if self._loudspeaker is None:
            return
        self._listen()
        trouble, self._trouble = self._trouble, None
        if trouble is not None:
            self._say(f"No sound: {trouble}. The bell rings instead.", error=True)
            self.use(Sound.BELL)
            return
        changes, self._changes = self._changes, []
        self._loudspeaker.play(changes, self._session.time)
