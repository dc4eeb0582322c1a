"""A run in joint space, as a table: CSV to read, NPZ for numpy.

The joints are those of MJCF and URDF, radians and metres; `J1` to `J6` are the motors, half-steps
from the chain's zero, which are the controls of the MJCF; `register_1` to `register_6` what was
commanded.
"""

from __future__ import annotations

import csv
import io

import numpy as np

from trs80arm.export.chain import JOINTS
from trs80arm.export.recording import Look, Recording
from trs80arm.export.units import METRES, number

COLUMNS = (
    "seconds",
    *JOINTS,
    *(f"J{latch + 1}" for latch in range(6)),
    *(f"register_{latch + 1}" for latch in range(6)),
)
_TURNING = 5


def csv_table(recording: Recording) -> bytes:
    """The run as CSV, a line a look."""
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    rows.writerow(COLUMNS)
    rows.writerows([number(value) for value in _row(look)] for look in recording.looks)
    return text.getvalue().encode("ascii")


def npz_table(recording: Recording) -> bytes:
    """The run as compressed arrays, one for each of `COLUMNS`."""
    values = np.array([_row(look) for look in recording.looks])
    columns = {name: values[:, place] for place, name in enumerate(COLUMNS)}
    file = io.BytesIO()
    np.savez_compressed(file, **columns)  # type: ignore[arg-type]
    return file.getvalue()


def _row(look: Look) -> tuple[float, ...]:
    slid = (value * METRES for value in look.joints[_TURNING:])
    return (look.time, *look.joints[:_TURNING], *slid, *look.motors, *look.registers)
