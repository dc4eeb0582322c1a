"""From sound to pulses: where on the tape something like a pulse is, and how strong it is.

A pulse went through a recorder twice and may come back upside down, with its halves drawn out into
three or four waves. What is left in any case is a quarter of a millisecond of sound around 3 kHz,
and that is what is listened for: a short filter with two kernels, a quarter of a wave apart, whose
strengths together do not depend on the wave's shape. The kernels are blind to a constant and to a
slope, and so to hum. No threshold is set here: every top of that strength counts, and who comes
next compares it with its neighbours.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from trs80arm.machine.audio.wav import Samples, Sound

CENTRES: Final = (2_800.0, 1_900.0, 4_200.0)
"""Hertz to listen at: the usual, for dull recordings, and for sharp ones."""
_WINDOW: Final = 700e-6
"""Seconds of the kernels from end to end."""
_APART: Final = 300e-6
"""Seconds: the lesser of two tops closer than that is a part of the other."""
_ENOUGH: Final = 20_000
"""Looks a second that pulses are found with."""
_BLOCK: Final = 1 << 19
"""Samples of a stretch that is worked on at a time."""
_FLOOR: Final = 0.04
"""Tops below this part of the strongest around are left out."""
_AROUND: Final = 0.02
"""Seconds to each side that this means."""


@dataclass(frozen=True)
class Pulses:
    """What may be pulses.

    Attributes:
        times: seconds from the start of the sound, in order.
        strengths: how strong each is, of 1.
    """

    times: NDArray[np.float64]
    strengths: NDArray[np.float32]


def find(sound: Sound, channel: int, centre: float) -> Pulses:
    """Find what may be pulses in a channel, listening at a frequency in Hertz."""
    times, strengths = [], []
    for stretch in _stretches(sound, channel, centre):
        tops = _tops(stretch.loud, stretch.rate)
        wanted = tops[(tops >= stretch.first) & (tops < stretch.last)]
        middles = _middles(stretch.loud, wanted, stretch.rate)
        times.append(stretch.start + (middles - stretch.first) / stretch.rate)
        strengths.append(stretch.loud[wanted])
    if not times:
        return Pulses(np.zeros(0), np.zeros(0, np.float32))
    together = np.concatenate(times)
    order = np.argsort(together, kind="stable")
    return Pulses(together[order], np.concatenate(strengths)[order])


@dataclass(frozen=True)
class _Stretch:
    """How loud it is in a stretch of sound, with some of what is before and behind.

    Attributes:
        loud: one look after the other.
        rate: looks a second.
        first: the first look that belongs to it.
        last: the one behind the last.
        start: when the first was, in seconds.
    """

    loud: NDArray[np.float32]
    rate: float
    first: int
    last: int
    start: float


def _stretches(sound: Sound, channel: int, centre: float) -> Iterator[_Stretch]:
    """How loud it is around a frequency, stretch by stretch."""
    rate = sound.form.rate
    together = max(1, rate // (_ENOUGH + 4_000))
    slow = rate / together
    between = max(1, int(np.ceil(_ENOUGH / slow)))
    centre = min(centre, 0.3 * slow)
    reach = int(np.ceil(_WINDOW / 2 * slow)) + 1
    kernels = [_kernel(slow, centre, phase / between, reach) for phase in range(between)]
    margin = (reach + int(_AROUND * slow)) * together
    block = _BLOCK // together * together
    for begin in range(0, sound.length, block):
        first = max(0, begin - margin) // together * together
        last = min(sound.length, begin + block + margin)
        samples = _slower(sound.channel(channel, first, last), together)
        if not len(samples):
            return
        padded = np.pad(samples, reach, mode="edge")
        loud = np.empty((len(samples), between), np.float32)
        for phase, (even, odd) in enumerate(kernels):
            one = np.convolve(padded, even, "valid")
            other = np.convolve(padded, odd, "valid")
            loud[:, phase] = np.sqrt(one * one + other * other)
        first = (begin - first) // together * between
        last = first + block // together * between
        yield _Stretch(loud.ravel(), slow * between, first, last, begin / rate)


def _tops(loud: NDArray[np.float32], rate: float) -> NDArray[np.intp]:
    """Where it is louder than anywhere near; of a flat top its first look."""
    high = _widest(loud, int(_APART * rate))
    floor = _widest(loud, int(_AROUND * rate)) * np.float32(_FLOOR)
    found = np.flatnonzero((loud >= high) & (loud > floor))
    apart = np.diff(found, prepend=-(1 << 30)) > _APART * rate - 0.5
    kept: NDArray[np.intp] = found[apart]
    return kept


def _middles(loud: NDArray[np.float32], tops: NDArray[np.intp], rate: float) -> NDArray[np.float64]:
    """The middle of what is loud around each top: a long pulse has its top anywhere."""
    reach = int(_APART * rate)
    offsets = np.arange(-reach, reach + 1)
    power = loud[np.clip(tops[:, None] + offsets, 0, len(loud) - 1)] ** 2
    total = np.maximum(power.sum(axis=1), 1e-30)
    middles: NDArray[np.float64] = tops + power @ offsets.astype(np.float32) / total
    return middles


def _widest(values: NDArray[np.float32], around: int) -> NDArray[np.float32]:
    """The greatest of the values within so many places to each side."""
    wide, reach = values, 0
    while reach < around:
        step = min(max(reach, 1), around - reach)
        padded = np.pad(wide, step, mode="edge")
        wide = np.maximum(np.maximum(padded[: -2 * step], padded[2 * step :]), wide)
        reach += step
    return wide


def _slower(samples: Samples, together: int) -> Samples:
    """So many samples together as one, their mean."""
    if together == 1:
        return samples
    whole = len(samples) // together * together
    means: Samples = samples[:whole].reshape(-1, together).mean(axis=1, dtype=np.float32)
    return means


def _kernel(
    rate: float, centre: float, phase: float, reach: int
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Two kernels a quarter of a wave apart, for the strength `phase` of a sample later."""
    times = (np.arange(-reach, reach + 1) - phase) / rate
    window = np.where(
        np.abs(times) < _WINDOW / 2, 0.5 + 0.5 * np.cos(2 * np.pi * times / _WINDOW), 0.0
    )
    blind, _ = np.linalg.qr(np.stack([window, window * times * rate], axis=1))
    made = []
    for wave in (np.cos(2 * np.pi * centre * times), np.sin(2 * np.pi * centre * times)):
        kernel = window * wave
        # Orthogonal to constant and slope, with the window still on it.
        basis = np.stack([np.ones_like(times), times * rate], axis=1)
        kernel = kernel - blind @ np.linalg.solve(basis.T @ blind, basis.T @ kernel)
        kernel /= np.sum(window)
        made.append(kernel[::-1].astype(np.float32))
    return made[0], made[1]
