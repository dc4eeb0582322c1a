"""From pulses to bits: each clock pulse is found from the one before it, a cell later.

What counts is always a pulse and its neighbours, never a level for the whole tape: in a dip of the
volume clock and data pulse are weak together. The length of a cell follows the speed of the
recorder. The ROM waits for a clock pulse as long as it takes and makes pauses itself, so a clock
may come late; one may also be lost. Which of the two it was shows in the pulses behind it: a real
clock has another one a cell later, and so on.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from trs80arm.machine.audio.pulses import Pulses

_RUN: Final = 20
"""Pulses at equal distances that may be a leader."""
_UNEVEN: Final = 0.2
"""How much two such distances may differ, as a part of one."""
_STRONG: Final = 0.5
"""A pulse of a leader has at least this part of the strongest around it."""
_EARLIEST, _LATEST = 0.78, 1.28
"""When the next clock comes, in cells from the one before."""
_DATA_FROM, _DATA_TO = 0.36, 0.64
"""When a data pulse comes, in cells from its clock."""
_ONE: Final = 0.5
"""A data pulse has more than this part of the strength of the clocks beside it."""
_SURE: Final = (0.36, 0.64)
"""Between these a bit is in doubt."""
_TOO_STRONG: Final = 2.0
"""A data pulse that has more of its clocks' strength may be a click."""
_AHEAD: Final = 12
"""Cells that are looked at ahead to tell a late clock from a lost one."""
_LONGEST_GAP: Final = 40
"""Cells without a clock after which the recording has ended."""
_WEAK: Final = 0.3
"""A clock below this part of those around is looked at more closely."""
_BESIDE, _BEFORE = 0.35, 0.12
"""A clock that others follow has at least these parts of the strongest around it and of the
strongest of those that follow: the volume may come up again, but what is hardly there is noise."""
_FAINT: Final = 0.06
"""Pulses below this part of what they were for long are none."""
_MOST_JITTER: Final = 0.13
"""Clocks that come so unevenly, in cells, on the average, are noise."""


@dataclass(frozen=True)
class Cells:
    """The bits of a stretch of tape, heard without a break.

    Attributes:
        bits: zeros and ones, one byte each.
        times: when each bit's clock came, in seconds from the start of the sound.
        doubtful: the bits that might as well be the other.
        lost: the bits whose clock was not heard; their values mean nothing.
        stop: when the last one ended.
    """

    bits: bytes
    times: NDArray[np.float64]
    doubtful: NDArray[np.intp]
    lost: NDArray[np.intp]
    stop: float


def follow_all(pulses: Pulses, cell: float) -> Iterator[Cells]:
    """All stretches that begin with zeros, one after the other.

    Args:
        pulses: what was found in the sound.
        cell: seconds of a bit's cell, within a quarter of it.
    """
    follower = _Follower(pulses)
    behind = -1.0
    for place, length in leaders(pulses, cell):
        if pulses.times[place] <= behind:
            continue
        cells = follower.follow(place, length)
        if cells is not None:
            behind = cells.stop
            yield cells


def leaders(pulses: Pulses, cell: float) -> list[tuple[int, float]]:
    """Where strong pulses follow each other at equal distances of about a cell.

    Returns:
        For each the place of its first pulse and the distance in seconds.
    """
    strong = np.flatnonzero(_is_strong(pulses, 1.6 * cell))
    if len(strong) <= _RUN:
        return []
    apart = np.diff(pulses.times[strong])
    right = (apart > 0.75 * cell) & (apart < 1.3 * cell)
    even = np.abs(np.diff(apart)) < _UNEVEN * apart[1:]
    good = right[1:] & right[:-1] & even
    # How many in a row up to each place; a run is found where it is just long enough.
    places = np.arange(len(good))
    last_bad = np.maximum.accumulate(np.where(good, -1, places))
    ends = np.flatnonzero(places - last_bad == _RUN)
    found = []
    for end in ends:
        first = int(end) - _RUN + 1
        distance = float(np.median(apart[first : int(end) + 1]))
        found.append((int(strong[first]), distance))
    return found


def _is_strong(pulses: Pulses, seconds: float) -> NDArray[np.bool_]:
    """Which are not much weaker than the strongest within so many seconds to each side."""
    times, strengths = pulses.times, pulses.strengths
    high = strengths.copy()
    for sign in (1, -1):
        along, strong = times[::sign] * sign, strengths[::sign]
        most = high[::sign]
        # Tops are 0.3 ms apart at least: a few places to each side are enough.
        for step in range(1, int(seconds / 0.3e-3) + 2):
            if step >= len(along):
                break
            near = along[step:] - along[:-step] <= seconds
            most[:-step] = np.where(near, np.maximum(most[:-step], strong[step:]), most[:-step])
    return strengths >= _STRONG * high


class _Follower:
    """Goes from clock to clock through plain lists, which is what Python is quickest with."""

    def __init__(self, pulses: Pulses) -> None:
        self._times: list[float] = pulses.times.tolist()
        self._strengths: list[float] = pulses.strengths.tolist()
        self._count = len(self._times)

    def follow(self, place: int, cell: float) -> Cells | None:
        """The bits from a clock on; None if that was no leader after all.

        Args:
            place: which pulse is the first clock.
            cell: seconds of a cell.
        """
        times, strengths, count = self._times, self._strengths, self._count
        bits = bytearray()
        clocks: list[float] = []
        doubtful: list[int] = []
        lost: list[int] = []
        time, level = times[place], strengths[place]
        strength = lasting = level
        jitter = 0.0
        ahead = place + 1
        while True:
            while ahead < count and times[ahead] <= time + 0.1 * cell:
                ahead += 1
            data = 0.0
            best, best_score, best_strength = -1, 0.0, 0.0
            look = ahead
            latest = time + _LATEST * cell
            data_from, data_to = time + _DATA_FROM * cell, time + _DATA_TO * cell
            earliest, due = time + _EARLIEST * cell, time + cell
            while look < count and (at := times[look]) < latest:
                heard = strengths[look]
                if at < data_to:
                    if at > data_from and heard > data:
                        data = heard
                elif at > earliest:
                    score = heard * (1.0 - 1.4 * abs(at - due) / cell)
                    if score > best_score:
                        best, best_score, best_strength = look, score, heard
                look += 1
            beside = strength
            found = False
            where: int | None = best
            if best >= 0 and best_strength > _FAINT * lasting:
                found = best_strength > _WEAK * min(level, self._high_around(best, cell))
            if not found:
                # The clock is weak, late or lost.
                where = self._resume(ahead, time, cell, lasting)
                if where is not None and times[where] < latest:
                    found, best, best_strength = True, where, strengths[where]
            if found:
                beside = 0.5 * (strength + best_strength)
            ratio = data / beside
            if _SURE[0] < ratio < _SURE[1] or ratio > _TOO_STRONG:
                doubtful.append(len(bits))
            bits.append(ratio > _ONE)
            clocks.append(time)
            if found:
                at = times[best]
                off = (at - due) / cell
                jitter += 0.03 * (abs(off) - jitter)
                if jitter > _MOST_JITTER:
                    break
                if -0.1 < off < 0.1:
                    cell += 0.06 * off * cell
                time, strength, ahead = at, best_strength, best + 1
                level += 0.2 * (strength - level)
                lasting += 0.005 * (strength - lasting)
                continue
            if where is None:
                break
            at = times[where]
            missed = round((at - time) / cell) - 1
            exact = abs((at - time) / cell - missed - 1) < 0.2
            if missed > 0 and (exact or missed > 3):
                for number in range(missed):
                    lost.append(len(bits))
                    bits.append(self._data_at(time + (number + 1) * cell, cell, level))
                    clocks.append(time + (number + 1) * cell)
            time, strength, ahead = at, strengths[where], where + 1
            level = strength
        if len(bits) < _RUN:
            return None
        size = len(bits)
        return Cells(
            bytes(bits),
            np.array(clocks[:size]),
            np.array([each for each in doubtful if each < size], np.intp),
            np.array([each for each in lost if each < size], np.intp),
            clocks[size - 1] + cell,
        )

    def _high_around(self, place: int, cell: float) -> float:
        """The strongest within two cells of a pulse, in front of it and behind."""
        times, strengths = self._times, self._strengths
        high, at = strengths[place], times[place]
        for step in (1, -1):
            look = place + step
            while 0 <= look < self._count and abs(times[look] - at) < 2.2 * cell:
                high = max(high, strengths[look])
                look += step
        return high

    def _data_at(self, clock: float, cell: float, level: float) -> bool:
        """Whether a data pulse is where a lost clock's would be."""
        place = int(np.searchsorted(self._times, clock + _DATA_FROM * cell))
        while place < self._count and self._times[place] < clock + _DATA_TO * cell:
            if self._strengths[place] > _ONE * level:
                return True
            place += 1
        return False

    def _resume(self, place: int, time: float, cell: float, lasting: float) -> int | None:
        """The pulse that is the next clock behind one that was not found; None if there is none.

        Args:
            place: the first pulse behind the last clock.
            time: of the last clock.
            cell: seconds of a cell.
            lasting: how strong pulses were for long.
        """
        times, strengths = self._times, self._strengths
        best, best_regular = None, 0.0
        first_good = None
        while place < self._count and times[place] < time + _EARLIEST * cell:
            place += 1
        while place < self._count and times[place] < time + (_LONGEST_GAP + 1) * cell:
            at = times[place]
            if first_good is not None and at > first_good + 1.2 * cell:
                break
            if strengths[place] > _FAINT * lasting:
                regular = self._regular(place, cell)
                cells = (at - time) / cell
                if abs(cells - round(cells)) < 0.15:
                    regular += 0.5
                if regular > best_regular:
                    best, best_regular = place, regular
                if first_good is None and regular >= _AHEAD - 2:
                    first_good = at
            place += 1
        return best if best_regular >= _AHEAD - 3 else None

    def _regular(self, place: int, cell: float) -> float:
        """How many of the cells behind a pulse begin with one, if it is a clock."""
        times, strengths, count = self._times, self._strengths, self._count
        clock = times[place]
        stop = clock + (_AHEAD + 0.5) * cell
        last = place
        while last < count and times[last] < stop:
            last += 1
        least = _BEFORE * max(strengths[place:last])

        def is_clock(pulse: int) -> bool:
            strength = strengths[pulse]
            return strength >= least and strength >= _BESIDE * self._high_around(pulse, cell)

        found = int(is_clock(place))
        look = place + 1
        for _ in range(_AHEAD):
            due = clock + cell
            while look < last and times[look] < due - 0.17 * cell:
                look += 1
            best, best_off = -1, 1.0
            while look < last and times[look] < due + 0.17 * cell:
                off = abs(times[look] - due)
                if off < best_off and is_clock(look):
                    best, best_off = look, off
                look += 1
            if best < 0:
                clock = due
            else:
                clock = times[best]
                found += 1
        return float(found)
