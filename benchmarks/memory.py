"""How much memory processes take at their most, and whether a longer run takes more."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

from benchmarks.rows import Row, process_cost

PROGRAMS = Path(__file__).parents[1] / "programs"
SHORT = 60
"""Virtual seconds of the shorter run of the arm."""


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
        taken = process_cost(command).megabytes
        bare = bare or taken
        yield Row(name, {"MB": taken, "x bare": taken / bare})
