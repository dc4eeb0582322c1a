"""What is recorded in a sound: pulses to bits, bits to recordings, each with what is wrong with it.

A recording is listened to in several ways, by each channel and around more than one frequency, but
only as long as something is wrong with it; of each recording the best hearing counts.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from trs80arm.machine import cassette
from trs80arm.machine.audio import bits, cells, pulses, speeds, wav
from trs80arm.machine.audio.cells import Cells
from trs80arm.machine.cassette import FileFormatError, Recording

CELL: Final = 2.0e-3
"""Seconds of a bit at 500 baud."""


@dataclass(frozen=True)
class Heard:
    """A recording that was heard.

    Attributes:
        start: when its sync byte began, in seconds from the start of the sound.
        stop: when its last byte ended.
        data: its bytes behind the sync byte.
        times: when each of them began.
        recording: what it is; of a damaged one the part before the damage, or None.
        fault: what is wrong with it; None if it is whole.
        doubtful: when bits came that might as well be the other.
        lost: when bits came that were not heard at all.
    """

    start: float
    stop: float
    data: bytes
    times: NDArray[np.float64]
    recording: Recording | None
    fault: FileFormatError | None
    doubtful: tuple[float, ...]
    lost: tuple[float, ...]

    @property
    def is_damaged(self) -> bool:
        """Whether some of it is missing."""
        return self.fault is not None or bool(self.lost)

    @property
    def is_good(self) -> bool:
        """Whether it was heard whole and without a doubt."""
        return not self.is_damaged and not self.doubtful

    def quality(self) -> tuple[bool, bool, int, int]:
        """What makes a hearing better than another, the greater the better."""
        return self.fault is None, not self.lost, -len(self.doubtful), len(self.data)

    def time_of(self, offset: int | None) -> float:
        """When a byte came; of what is no byte, the end."""
        known = offset is not None and 0 <= offset < len(self.times)
        return float(self.times[offset]) if known else self.stop

    @property
    def remarks(self) -> tuple[str, ...]:
        """What is to be said of it, each in a few words with the time."""
        said = []
        if self.fault is not None:
            # Nothing is known of how it would have gone on.
            where = "" if self.breaks_off else f" at {clock_time(self.time_of(self.fault.offset))}"
            off = f", the sound is lost at {clock_time(self.stop)}" if self.breaks_off else ""
            said.append(self.fault.message + where + off)
        if self.lost:
            said.append(f"{_bits(self.lost)} not heard, the first at {clock_time(self.lost[0])}")
        if self.doubtful:
            when = clock_time(self.doubtful[0])
            said.append(f"{_bits(self.doubtful)} in doubt, the first at {when}")
        return tuple(said)

    @property
    def breaks_off(self) -> bool:
        """Whether its end is missing."""
        fault = self.fault
        if fault is None:
            return False
        beyond = fault.offset is None or fault.offset >= len(self.data)
        return beyond or fault.message.endswith(cassette.NO_END)


@dataclass(frozen=True)
class Hearing:
    """What a sound holds.

    Attributes:
        heard: its recordings, in order; at least one.
        seconds: how long it is.
    """

    heard: tuple[Heard, ...]
    seconds: float

    @property
    def content(self) -> bytes:
        """The recordings as the bytes of a cassette."""
        head = cassette.LEADER + bytes((cassette.SYNC,))
        return b"".join(head + each.data for each in self.heard)


def listen(data: bytes) -> Hearing:
    """Hear what a WAV file holds.

    Raises:
        FileFormatError: it is no such file, or nothing of this machine's is heard in it.
    """
    sound = wav.read(data)
    found: list[Heard] = []
    first: pulses.Pulses | None = None
    for channel, centre in _ways(sound):
        tops = pulses.find(sound, channel, centre)
        first = tops if first is None else first
        found += _hear(tops)
        best = _best(found)
        if best and all(each.is_good for each in best):
            break
    best = _best(found)
    if not best:
        raise FileFormatError(speeds.why_nothing(sound, first))
    return Hearing(tuple(best), sound.seconds)


def _ways(sound: wav.Sound) -> Iterator[tuple[int, float]]:
    """The ways of listening: every channel at the usual frequency first, then at the others."""
    channels = _different_channels(sound)
    for centre in pulses.CENTRES:
        for channel in channels:
            yield channel, centre


def _different_channels(sound: wav.Sound) -> list[int]:
    """The channels that are worth listening to, the loudest first."""
    kept: list[tuple[float, int, wav.Samples]] = []
    step = max(1, sound.length // 16)
    for channel in range(sound.form.channels):
        looks = [
            sound.channel(channel, start, min(start + 4096, sound.length))
            for start in range(0, sound.length, step)
        ]
        sample = np.concatenate(looks) if looks else np.zeros(0, np.float32)
        if any(np.array_equal(sample, other) for _, _, other in kept):
            continue
        loudness = float(np.std(np.diff(sample))) if len(sample) > 1 else 0.0
        kept.append((loudness, channel, sample))
    return [channel for _, channel, _ in sorted(kept, key=lambda each: -each[0])]


def _hear(tops: pulses.Pulses) -> list[Heard]:
    heard: list[Heard] = []
    for stretch in cells.follow_all(tops, CELL):
        heard += _recordings(stretch)
    return heard


def _best(found: list[Heard]) -> list[Heard]:
    """Of hearings of the same stretch of tape the best one."""
    chosen: list[Heard] = []
    for each in sorted(found, key=Heard.quality, reverse=True):
        if all(each.stop <= other.start or each.start >= other.stop for other in chosen):
            chosen.append(each)
    return sorted(chosen, key=lambda each: each.start)


def _recordings(stretch: Cells) -> Iterator[Heard]:
    """The recordings in bits that were heard without a break."""
    for found in bits.recordings(stretch.bits):
        doubtful = _between(stretch.doubtful, found.sync, found.end)
        lost = _between(stretch.lost, found.sync, found.end)
        whole = found.end < len(stretch.times)
        yield Heard(
            start=float(stretch.times[found.sync]),
            stop=float(stretch.times[found.end]) if whole else stretch.stop,
            data=found.data,
            times=stretch.times[found.begin : found.end : 8],
            recording=found.recording,
            fault=found.fault,
            doubtful=tuple(stretch.times[doubtful].tolist()),
            lost=tuple(stretch.times[lost].tolist()),
        )


def _between(places: NDArray[np.intp], start: int, stop: int) -> NDArray[np.intp]:
    return places[(places >= start) & (places < stop)]


def _bits(times: tuple[float, ...]) -> str:
    return "1 bit was" if len(times) == 1 else f"{len(times)} bits were"


def clock_time(seconds: float) -> str:
    """A place in a sound: `1:04.25`, minutes and seconds."""
    hundredths = round(seconds * 100)
    minutes, rest = divmod(hundredths, 6000)
    return f"{minutes}:{rest // 100:02d}.{rest % 100:02d}"
