"""The eye on the arm: angles, pose, grip, and what the motors bear, at each step or at a rate.

It is clipped on to the card as an observer that looks after every instant of a burst, and then asks
the rig where the arm truly is.
"""

from __future__ import annotations

import csv
import io
import math
from array import array
from collections.abc import Callable, Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO, Protocol

import numpy as np

from trs80arm.arm.model import Motor
from trs80arm.machine.card import Card, Observer
from trs80arm.machine.clock import T_STATES_PER_SECOND, Clock
from trs80arm.pulses import Series
from trs80arm.trace.files import TraceError, kind_of, seconds, trace_file

if TYPE_CHECKING:
    from trs80arm.arm.loads import Loads
    from trs80arm.arm.state import ArmState

_MOTORS = tuple(motor.name.lower() for motor in Motor)

COLUMNS = (
    *("base", "shoulder", "elbow", "hand_pitch", "hand_roll"),
    *("x", "y", "z", "pitch", "roll", "opening", "force", "switch"),
    *(f"{name}_torque" for name in _MOTORS),
    *(f"{name}_used" for name in _MOTORS),
    "grip_needed",
)
"""Joint angles in degrees, shoulder, elbow and hand pitch from the horizontal; the hand's pose in
inches and degrees, the grip's force in pounds, and the switch, 1 when closed; by motor, the torque
at its joint, ounce-inches (ounces at the fingers for the hand), and how much of what it has is
used, per cent; the pounds of grip that holding what is between the fingers takes."""

_SWITCH = COLUMNS.index("switch")


class Watched(Protocol):
    """What the eye looks at: a rig."""

    @property
    def card(self) -> Card:
        """The card whose writes move the arm."""

    def watch_latches(self, observer: Observer) -> Callable[[], None]:
        """Clip an analyser on the card; the function returned takes it off."""

    @property
    def clock(self) -> Clock:
        """The clock that the card's writes are timed by."""

    @property
    def state(self) -> ArmState:
        """Where the arm is."""

    @property
    def loads(self) -> Loads:
        """What its motors and its hand bear."""


class PoseSink(Protocol):
    """One format of the eye's file."""

    def row(self, time: int, values: Sequence[float]) -> None:
        """Add one look: a T-state and the values of `COLUMNS`."""

    def finish(self) -> None:
        """The trace is complete."""


class CsvSink:
    """`t_states,seconds` and the columns, one line a look, four decimals."""

    def __init__(self, file: BinaryIO) -> None:
        self._text = io.TextIOWrapper(file, encoding="ascii", newline="", write_through=True)
        self._rows = csv.writer(self._text, lineterminator="\n")
        self._rows.writerow(("t_states", "seconds", *COLUMNS))

    def row(self, time: int, values: Sequence[float]) -> None:
        """Add one line."""
        # Adding 0 to the rounded number turns -0.0 into 0.0.
        texts = [f"{round(number, 4) + 0.0:.4f}" for number in values]
        texts[_SWITCH] = str(int(values[_SWITCH]))
        self._rows.writerow((time, seconds(time), *texts))

    def finish(self) -> None:
        """Leave the file to whoever opened it."""
        self._text.detach()


class ArraySink:
    """Arrays `t_states` and `seconds`, and one of each column's name."""

    def __init__(self) -> None:
        self._times = array("q")
        self._values = array("d")

    def row(self, time: int, values: Sequence[float]) -> None:
        """Keep the values."""
        self._times.append(time)
        self._values.extend(values)

    def arrays(self) -> dict[str, Any]:
        """What was seen so far."""
        times = np.array(self._times, dtype=np.int64)
        values = np.array(self._values, dtype=np.float64).reshape(-1, len(COLUMNS))
        columns = {name: values[:, place] for place, name in enumerate(COLUMNS)}
        return {"t_states": times, "seconds": times / T_STATES_PER_SECOND, **columns}

    def finish(self) -> None:
        """Nothing is to be done."""


class NpzSink(ArraySink):
    """The arrays as a file, when the trace ends."""

    def __init__(self, file: BinaryIO) -> None:
        super().__init__()
        self._file = file

    def finish(self) -> None:
        """Write the arrays, compressed."""
        np.savez_compressed(self._file, **self.arrays())


class PoseTrace:
    """A running trace of the arm; a context manager.

    Without a rate there is a look when the trace begins and one after every instant at which a
    latch was written. With a rate there is one at every tick of it from the beginning to the end
    of the trace; between two writes the motors, and so the arm, stand still. (What is moved by hand
    with the motors off is seen from the next write on.)

    Args:
        rig: what to watch.
        path: a `.csv` or `.npz` file; it appears, complete, when the trace is closed. None keeps
            the trace in memory, for `arrays`.
        rate: looks a virtual second, or None for each step.

    Raises:
        TraceError: the suffix is another one, or the file cannot be written.
        ValueError: the rate is not above 0.
    """

    each_step = True

    def __init__(
        self, rig: Watched, path: Path | str | None = None, rate: float | None = None
    ) -> None:
        if rate is not None and not 0 < rate <= T_STATES_PER_SECOND:
            raise ValueError(f"{rate} looks a second cannot be taken")
        self._rig = rig
        self._interval = None if rate is None else T_STATES_PER_SECOND / rate
        self._start = rig.clock.now
        self._looks = 0
        self._last = values_of(rig)
        self._opened = ExitStack()
        self._sink: PoseSink = ArraySink() if path is None else self._sink_of(path)
        if rate is None:
            self._sink.row(self._start, self._last)
        self._take_off = rig.watch_latches(self)
        self._is_on = True

    def _sink_of(self, path: Path | str) -> PoseSink:
        kind = kind_of(path, (".csv", ".npz"))
        file = self._opened.enter_context(trace_file(path))
        return CsvSink(file) if kind == ".csv" else NpzSink(file)

    @property
    def arrays(self) -> dict[str, Any]:
        """What was seen so far, as numpy arrays of one length, by the names of `COLUMNS`.

        `t_states` and `seconds` since power-on stand before them.

        Raises:
            TraceError: the trace goes to a text file.
        """
        if not isinstance(self._sink, ArraySink):
            raise TraceError("a trace that goes to a text file has no arrays")
        return self._sink.arrays()

    def wrote(self, times: Series, latches: Series, nibbles: Series) -> None:
        """Look at the arm after an instant's writes (the card calls this)."""
        time = int(times[-1])
        if self._interval is None:
            self._sink.row(time, values_of(self._rig))
        else:
            self._stand_still(time)
            self._last = values_of(self._rig)

    def close(self) -> None:
        """End the trace and let the file have its name."""
        if self._is_on:
            self._is_on = False
            self._take_off()
            with self._opened:
                self._stand_still(self._rig.clock.now + 1)
                self._sink.finish()

    def _stand_still(self, until: int) -> None:
        """Take the looks that are due before a T-state, at which nothing has changed yet."""
        while self._interval is not None:
            due = self._start + int(self._looks * self._interval)
            if due >= until:
                return
            self._looks += 1
            self._sink.row(due, self._last)

    def __enter__(self) -> PoseTrace:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def values_of(rig: Watched) -> tuple[float, ...]:
    """The values of `COLUMNS` at this moment."""
    state, loads = rig.state, rig.loads
    motors = [loads.of(motor) for motor in Motor]
    angles, pose = state.angles, state.pose
    joints = (angles.base, angles.shoulder, angles.elbow, angles.pitch, angles.roll)
    return (
        *(math.degrees(angle) for angle in joints),
        *(pose.x, pose.y, pose.z, pose.pitch, pose.roll, pose.opening),
        state.force,
        float(state.switch_closed),
        *(load.torque for load in motors),
        *(100 * load.used for load in motors),
        loads.grip.needed,
    )
