"""Why nothing was heard in a sound: what was recorded at another speed is told by name."""

from __future__ import annotations

from typing import Final

import numpy as np

from trs80arm.machine.audio import cells
from trs80arm.machine.audio.bits import SYNC_BITS
from trs80arm.machine.audio.pulses import Pulses
from trs80arm.machine.audio.wav import Samples, Sound

_SLOW_CELL, _FAST_CELL = 4.0e-3, 1.0e-3
_LONG_WAVE, _SHORT_WAVE = (620e-6, 900e-6), (310e-6, 450e-6)
"""Seconds of a zero's wave and of a one's at 1500 baud: 1320 and 2680 Hz."""
_LEADER: Final = 100
"""Zeros in a row that are called one."""
_STRETCH: Final = 0.5
"""Seconds of sound that are looked at together."""
_ALMOST_ALL, _SOME = 0.8, 0.15


def why_nothing(sound: Sound, pulses: Pulses | None) -> str:
    """One line that says what a sound is in which no recording was found."""
    length = _length(sound.seconds)
    if pulses is None or not len(pulses.times) or float(pulses.strengths.max()) < 1e-4:
        return f"nothing but silence in {length} of sound"
    for cell, whose in (
        (_SLOW_CELL, "250 baud, as Level I BASIC does; Level II reads 500"),
        (_FAST_CELL, "1000 baud, which takes a program of its own to read; Level II reads 500"),
    ):
        when = _synced(pulses, cell)
        if when is not None:
            return f"recorded at {whose} (at {_time(when)})"
    when = _high_speed(sound)
    if when is not None:
        return f"recorded at 1500 baud, as a Model III does; Level II reads 500 (at {_time(when)})"
    leaders = (each for each in cells.follow_all(pulses, 2e-3) if _is_leader(each))
    when = next((each.stop for each in leaders), None)
    if when is not None:
        return f"a leader but no sync byte A5H behind it (at {_time(when)})"
    return f"no recording of a TRS-80 in {length} of sound"


def _is_leader(stretch: cells.Cells) -> bool:
    return len(stretch.bits) >= _LEADER and stretch.bits.count(0) > 0.9 * len(stretch.bits)


def _synced(pulses: Pulses, cell: float) -> float | None:
    """When a leader with a sync byte behind it begins, in cells of such a length."""
    for stretch in cells.follow_all(pulses, cell):
        if bytes(16) + SYNC_BITS in stretch.bits:
            return float(stretch.times[0])
    return None


def _high_speed(sound: Sound) -> float | None:
    """When waves of two lengths begin that follow each other without a pause."""
    rate = sound.form.rate
    size = int(rate * _STRETCH)
    for start in range(0, sound.length - size, size):
        waves = _waves(sound.channel(0, start, start + size), rate)
        if len(waves) < _STRETCH / _LONG_WAVE[1] / 2:
            continue
        long = np.mean((waves > _LONG_WAVE[0]) & (waves < _LONG_WAVE[1]))
        short = np.mean((waves > _SHORT_WAVE[0]) & (waves < _SHORT_WAVE[1]))
        if long + short > _ALMOST_ALL and min(long, short) > _SOME:
            return start / rate
    return None


def _waves(samples: Samples, rate: int) -> Samples:
    """How long each wave is, in seconds, from one rise through the middle to the next."""
    around = max(1, int(rate * 1.5e-3))
    middle = np.convolve(samples, np.full(around, 1 / around, np.float32), "same")
    level = samples - middle
    high = 0.25 * float(np.sqrt(np.mean(level * level)))
    side = np.where(level > high, 1, np.where(level < -high, -1, 0))
    places = np.flatnonzero(side)
    rises = places[1:][(side[places[1:]] == 1) & (side[places[:-1]] == -1)]
    lengths: Samples = (np.diff(rises) / rate).astype(np.float32)
    return lengths


def _length(seconds: float) -> str:
    return f"{seconds:.1f} seconds" if seconds < 60 else f"{seconds / 60:.1f} minutes"


def _time(seconds: float) -> str:
    return f"{int(seconds) // 60}:{int(seconds) % 60:02d}"
