"""One row of the table, and the clocks that fill it."""

from __future__ import annotations

import os
import subprocess
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import IO


@dataclass(frozen=True)
class Row:
    """One thing measured.

    Attributes:
        name: what it is.
        measures: column to value; a column says its unit.
    """

    name: str
    measures: Mapping[str, float]


def process_cost(
    command: Sequence[str], timeout: float = 120.0, output: IO[bytes] | int = subprocess.DEVNULL
) -> float:
    """Seconds of the processor that a command takes to its end.

    Args:
        command: with its arguments.
        timeout: seconds on the wall.
        output: where what it prints goes.

    Raises:
        subprocess.SubprocessError: it failed, or took too long.
    """
    # An input that is not at its end, for what leaves when it is, as PC-BASIC does.
    process = subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=output, stderr=subprocess.DEVNULL
    )
    assert process.stdin is not None
    stop = time.monotonic() + timeout
    while True:
        pid, status, used = os.wait4(process.pid, os.WNOHANG)
        if pid:
            break
        if time.monotonic() > stop:
            process.kill()
            process.wait()
            raise subprocess.TimeoutExpired(command, timeout)
        time.sleep(0.002)
    process.stdin.close()
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise subprocess.CalledProcessError(process.returncode, command)
    return used.ru_utime + used.ru_stime


def empty_loop() -> float:
    """Seconds that a round of an empty Python loop takes now: the yardstick where no peer is."""
    begin = time.process_time()
    for _ in range(300_000):
        pass
    return (time.process_time() - begin) / 300_000
