"""The sound of a cassette: bytes as the pulses that the ROM puts on the line to the recorder.

Each bit is a clock pulse, and a one has a second pulse in the middle of its cell. A pulse is the
line high and then low, as OUT 255 sets it. All times were counted in T-states while the ROM did
CSAVE.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from trs80arm.machine import cassette
from trs80arm.machine.audio.wav import Samples
from trs80arm.machine.cassette import SYNC
from trs80arm.machine.clock import T_STATES_PER_SECOND

HALF_PULSE: Final = 227
"""T-states that the line is high, and then low: 128 microseconds each."""
CLOCK_TO_DATA: Final = 1_780
ZERO_CELL: Final = 3_570
ONE_CELL: Final = 1_780 + 1_777
BETWEEN_BYTES: Final = 130
"""What the last cell of a byte is longer, with the least to be done in between."""
BEHIND_SYNC: Final = 2_037
"""What the last cell of the sync byte is longer: the ROM looks for the program."""
SILENCE: Final = T_STATES_PER_SECOND // 2
"""T-states of blank tape before and behind a recording."""
LEVEL: Final = 0.5
"""How loud it is, of 1."""
_BLOCK = 1 << 20


def duration(content: bytes) -> int:
    """T-states that the pulses of some bytes take, blank tape not counted."""
    ones = int(np.unpackbits(np.frombuffer(content, np.uint8)).sum())
    cells = 8 * len(content) * ZERO_CELL - ones * (ZERO_CELL - ONE_CELL)
    return cells + len(content) * BETWEEN_BYTES


def pulse_times(content: bytes) -> np.ndarray[tuple[int], np.dtype[np.int64]]:
    """When each pulse begins, in T-states from the first one.

    The first sync byte is taken to end the leader, and has the pause behind it.
    """
    bits = np.unpackbits(np.frombuffer(content, np.uint8)).astype(np.int64)
    lengths = np.where(bits, ONE_CELL, ZERO_CELL)
    lengths[7::8] += BETWEEN_BYTES
    sync = content.find(SYNC)
    if sync >= 0:
        lengths[8 * sync + 7] += BEHIND_SYNC
    clocks = np.concatenate([np.zeros(1, np.int64), np.cumsum(lengths)[:-1]])
    data = clocks[bits > 0] + CLOCK_TO_DATA
    return np.sort(np.concatenate([clocks, data]))


def cassette_sound(content: bytes, rate: int) -> Samples:
    """The sound of a cassette with any number of recordings, blank tape between them."""
    sounds = [np.zeros(0, np.float32)]
    start = 0
    for stretch in cassette.stretches(content):
        sounds.append(sound(content[start : stretch.stop], rate))
        start = stretch.stop
    rest = content[start:]
    if any(rest):
        sounds.append(sound(rest, rate))
    return np.concatenate(sounds)


def sound(content: bytes, rate: int) -> Samples:
    """The sound of one recording, leader and all, with blank tape around it.

    A sample is the mean of the line over its time, as a sound card's would be.
    """
    if not content:
        return np.zeros(0, np.float32)
    starts = pulse_times(content) + SILENCE
    per = T_STATES_PER_SECOND / rate
    length = int((starts[-1] + 2 * HALF_PULSE + SILENCE) / per) + 1
    out = np.zeros(length, np.float32)
    # The area under the line up to each edge of a sample is straight between its changes.
    moments = np.stack([starts, starts + HALF_PULSE, starts + 2 * HALF_PULSE], axis=1).ravel()
    areas = np.tile(np.array([0.0, HALF_PULSE, 0.0]), len(starts))
    for begin in range(0, length, _BLOCK):
        edges = np.arange(begin, min(begin + _BLOCK, length) + 1) * per
        out[begin : begin + _BLOCK] = np.diff(np.interp(edges, moments, areas)) / per
    return out * np.float32(LEVEL)
