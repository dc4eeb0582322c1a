"""The logic analyser: every write to the card's latches with its time, to a file.

It is clipped on to the card as an observer. CSV and NPZ list the writes; VCD shows the coils as
signals to a waveform viewer.
"""

from __future__ import annotations

import csv
import io
from array import array
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path
from typing import Any, BinaryIO, Protocol

import numpy as np

from trs80arm.machine.card import Card, Latch, Observer
from trs80arm.machine.clock import T_STATES_PER_SECOND, Clock
from trs80arm.pulses import Series
from trs80arm.trace.files import TraceError, kind_of, seconds, trace_file
from trs80arm.trace.vcd import VcdSink

NAMES = tuple(latch.name.lower().replace("_", " ") for latch in Latch)
"""base, shoulder, elbow, left wrist, right wrist, hand, auxiliary."""


class Probed(Protocol):
    """What a trace is attached to: a rig."""

    @property
    def card(self) -> Card:
        """The card whose latches are watched."""

    def watch_latches(self, observer: Observer) -> Callable[[], None]:
        """Clip an analyser on the card; the function returned takes it off."""

    @property
    def clock(self) -> Clock:
        """The clock that the card's writes are timed by."""


class LatchSink(Protocol):
    """One format of the analyser's file."""

    def write(self, times: Series, latches: Series, nibbles: Series) -> None:
        """Add writes, in order."""

    def finish(self, time: int) -> None:
        """The trace ends at a T-state."""


class CsvSink:
    """`t_states,seconds,latch,nibble`, one line a write; phi1 is the nibble's bit of value 8."""

    def __init__(self, file: BinaryIO) -> None:
        self._text = io.TextIOWrapper(file, encoding="ascii", newline="", write_through=True)
        self._rows = csv.writer(self._text, lineterminator="\n")
        self._rows.writerow(("t_states", "seconds", "latch", "nibble"))

    def write(self, times: Series, latches: Series, nibbles: Series) -> None:
        """Add one line a write."""
        self._rows.writerows(
            (int(time), seconds(time), NAMES[latch], int(nibble))
            for time, latch, nibble in zip(times, latches, nibbles, strict=True)
        )

    def finish(self, time: int) -> None:
        """Leave the file to whoever opened it."""
        self._text.detach()


class ArraySink:
    """Arrays `t_states`, `seconds`, `latch`, `nibble`, and `names` of the latches by number.

    Ten bytes are kept for a write.
    """

    def __init__(self) -> None:
        self._times = array("q")
        self._latches = array("B")
        self._nibbles = array("B")

    def write(self, times: Series, latches: Series, nibbles: Series) -> None:
        """Keep the writes."""
        for column, values in (
            (self._times, times),
            (self._latches, latches),
            (self._nibbles, nibbles),
        ):
            column.frombytes(np.asarray(values).astype(column.typecode).tobytes())

    def arrays(self) -> dict[str, Any]:
        """What was written so far."""
        times = np.array(self._times, dtype=np.int64)
        return {
            "t_states": times,
            "seconds": times / T_STATES_PER_SECOND,
            "latch": np.array(self._latches, dtype=np.uint8),
            "nibble": np.array(self._nibbles, dtype=np.uint8),
            "names": np.array(NAMES),
        }

    def finish(self, time: int) -> None:
        """Nothing is to be done."""


class NpzSink(ArraySink):
    """The arrays as a file, when the trace ends."""

    def __init__(self, file: BinaryIO) -> None:
        super().__init__()
        self._file = file

    def finish(self, time: int) -> None:
        """Write the arrays, compressed."""
        np.savez_compressed(self._file, **self.arrays())


class Trace:
    """A running trace of the latches; a context manager.

    Args:
        rig: what to watch.
        path: a `.csv`, `.npz` or `.vcd` file; it appears, complete, when the trace is closed. None
            keeps the trace in memory, for `arrays`.

    Raises:
        TraceError: the suffix is another one, or the file cannot be written.
    """

    each_step = False

    def __init__(self, rig: Probed, path: Path | str | None = None) -> None:
        self._rig = rig
        self._opened = ExitStack()
        self._sink: LatchSink = ArraySink() if path is None else self._sink_of(path)
        self._take_off = rig.watch_latches(self)
        self._is_on = True

    def _sink_of(self, path: Path | str) -> LatchSink:
        kind = kind_of(path, (".csv", ".npz", ".vcd"))
        file = self._opened.enter_context(trace_file(path))
        if kind == ".csv":
            return CsvSink(file)
        if kind == ".npz":
            return NpzSink(file)
        return VcdSink(file, self._rig.clock.now, self._rig.card.latches)

    @property
    def arrays(self) -> dict[str, Any]:
        """What was written so far, as numpy arrays of one length but for `names`.

        `t_states`, `seconds` since power-on, `latch` (0 the base's), `nibble` (phi1 is its bit of
        value 8), and `names` of the latches by number.

        Raises:
            TraceError: the trace goes to a text file.
        """
        if not isinstance(self._sink, ArraySink):
            raise TraceError("a trace that goes to a text file has no arrays")
        return self._sink.arrays()

    def wrote(self, times: Series, latches: Series, nibbles: Series) -> None:
        """Note a burst of writes (the card calls this)."""
        self._sink.write(times, latches, nibbles)

    def close(self) -> None:
        """End the trace and let the file have its name."""
        if self._is_on:
            self._is_on = False
            self._take_off()
            with self._opened:
                self._sink.finish(self._rig.clock.now)

    def __enter__(self) -> Trace:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()
