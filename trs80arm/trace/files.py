"""The files of traces: opened early, filled as time passes, and given their name when complete."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO

from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.reasons import reason
from trs80arm.saving import whole_file


class TraceError(Exception):
    """A trace cannot be written where it was asked for; one line says why."""


def kind_of(path: Path | str, kinds: Collection[str]) -> str:
    """The suffix of a file in lower case, if it is one of `kinds`.

    Raises:
        TraceError: it is none of them.
    """
    suffix = Path(path).suffix.lower()
    if suffix not in kinds:
        raise TraceError(f"{path}: a trace of this sort is a file named {' or '.join(kinds)}")
    return suffix


@contextmanager
def trace_file(path: Path | str) -> Iterator[BinaryIO]:
    """A file that takes its name when the trace ends.

    Raises:
        TraceError: it cannot be written.
    """
    try:
        with whole_file(Path(path)) as file:
            yield file
    except OSError as error:
        raise TraceError(f"{path}: {reason(error)}") from None


def seconds(time: int) -> str:
    """A T-state as seconds since power-on, to the nanosecond."""
    return f"{time / T_STATES_PER_SECOND:.9f}"
