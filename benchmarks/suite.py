"""How long the project's own tests take on all cores, and in which rooms.

What is compiled of them is kept from an earlier run, as on a computer on which they are run again
and again. A room's seconds are those that its tests say they took, on the clock of one core.
"""

from __future__ import annotations

import os
import sys
import tempfile
import time
from collections import defaultdict
from collections.abc import Iterator, Sequence
from pathlib import Path
from xml.etree import ElementTree

from benchmarks.rows import Row, process_cost

ROOT = Path(__file__).parents[1]
TESTS = "tests"
NO_ROOM = "of all rooms"
"""What stands beside the rooms."""
LONGEST = 1800.0
"""Seconds on the wall after which something must be wrong."""


def of_tests(chosen: Sequence[str], cores: int) -> Iterator[Row]:
    """All of the chosen tests, and each room of them, the longest first.

    Args:
        chosen: files and folders, as for pytest.
        cores: how many tests run at once.

    Raises:
        subprocess.SubprocessError: a test failed.
    """
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.xml"
        options = ["-n", str(cores), "--dist", "worksteal", f"--junitxml={report}"]
        where = [str(ROOT / each) for each in chosen]
        began = time.monotonic()
        spent = process_cost(
            [sys.executable, "-m", "pytest", "--rootdir", str(ROOT), *options, *where], LONGEST
        )
        lasted = time.monotonic() - began
        cases = ElementTree.parse(report).getroot().findall("*/testcase")
    rooms: defaultdict[str, list[float]] = defaultdict(list)
    for case in cases:
        room = case.attrib["classname"].split(".")[1]
        rooms[NO_ROOM if room.startswith("test_") else room].append(float(case.attrib["time"]))
    yield Row("all", {"tests": len(cases), "s": lasted, "s of a core": spent})
    for room, times in sorted(rooms.items(), key=lambda item: -sum(item[1])):
        yield Row(room, {"tests": len(times), "s of a core": sum(times)})


def rows(_seconds: float) -> Iterator[Row]:
    """All tests, once."""
    return of_tests([TESTS], os.cpu_count() or 1)
