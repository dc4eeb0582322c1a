"""Recordings in a stream of bits, whose bytes may begin anywhere.

A sync byte is looked for bit by bit, as the ROM does: in sound there are no bytes before it, and
some files were written by who had not found it yet.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

import numpy as np

from trs80arm.machine import cassette
from trs80arm.machine.cassette import FileFormatError, Recording

SYNC_BITS: Final = bytes((1, 0, 1, 0, 0, 1, 0, 1))
_LEADER: Final = 8
"""Zeros before the sync byte that are enough where a recording may begin."""
_SURE_LEADER: Final = 64
"""The same behind a damaged one, in whose bytes a sync byte may be."""


@dataclass(frozen=True)
class Found:
    """A recording among bits.

    Attributes:
        sync: the place of the sync byte's first bit.
        begin: the place of the first bit behind it.
        end: the place behind the last one.
        data: the bytes in between; of a damaged recording all that follow it.
        recording: what it is; of a damaged one the part before the damage, or None.
        fault: what is wrong with it, its offset in `data`; None if it is whole.
    """

    sync: int
    begin: int
    end: int
    data: bytes
    recording: Recording | None
    fault: FileFormatError | None


def recordings(bits: bytes) -> Iterator[Found]:
    """The recordings in bits, each a byte of 0 or 1, in order."""
    values = np.frombuffer(bits, np.uint8)
    zeros, place = _LEADER, 0
    while (found := bits.find(bytes(zeros) + SYNC_BITS, place)) >= 0:
        sync = found + zeros
        begin = sync + len(SYNC_BITS)
        whole = (len(bits) - begin) // 8
        if not whole:
            return
        data = np.packbits(values[begin : begin + whole * 8]).tobytes()
        # A parser of cassettes finds it behind a sync byte, and counts that.
        parsed = next(cassette.stretches(bytes((cassette.SYNC,)) + data))
        size, fault = whole, None
        if parsed.fault is None:
            size = parsed.stop - 1
        else:
            fault = _one_less(parsed.fault)
        end = begin + 8 * size
        yield Found(sync, begin, end, data[:size], parsed.recording, fault)
        zeros, place = (_LEADER, end) if fault is None else (_SURE_LEADER, begin)


def _one_less(fault: FileFormatError) -> FileFormatError:
    if fault.offset is None:
        return fault
    return FileFormatError(fault.message, fault.offset - 1)
