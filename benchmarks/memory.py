"""How much memory processes take at their most, and whether a longer run takes more."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

from benchmarks.rows import Row

PROGRAMS = Path(__file__).parents[1] / "programs"
SHORT = 60
"""Virtual seconds of the shorter run of the arm."""


_LAUNCHER = """
import resource, subprocess, sys
subprocess.run(sys.argv[1:], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)
"""


def most_memory(command: Sequence[str]) -> float:
    """MB that a command takes at its most.

    A process is counted from what the one that starts it holds, so a small one stands between, and
    what was measured before does not matter.

    Args:
        command: with its arguments.

    Raises:
        subprocess.SubprocessError: it failed.
    """
    launched = [sys.executable, "-c", _LAUNCHER, *command]
    told = subprocess.run(launched, stdin=subprocess.DEVNULL, capture_output=True, check=True)
    return int(told.stdout) / 1024


def rows(seconds: float) -> Iterator[Row]:
    """Each process once: the same takes the same."""
    module = [sys.executable, "-m", "trs80arm"]
    table4 = [*module, "run", str(PROGRAMS / "table4.bas"), "--set", "6:1.0 0", "--seconds"]
    tenfold = str(SHORT * 10 if seconds >= 0.5 else SHORT)
    started = {
        "bare interpreter": [sys.executable, "-c", "pass"],
        "import numpy": [sys.executable, "-c", "import numpy"],
        "trs80arm --help": [*module, "--help"],
        "Table 4, 60 virtual seconds": [*table4, str(SHORT)],
        f"Table 4, {tenfold} virtual seconds": [*table4, tenfold],
    }
    bare = None
    for name, command in started.items():
        taken = most_memory(command)
        bare = bare or taken
        yield Row(name, {"MB": taken, "x bare": taken / bare})
