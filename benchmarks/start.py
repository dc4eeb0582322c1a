"""How long a start takes, beside those of the bare interpreter and of numpy in the same run.

Processes take turns, and each has its best of several: seconds of the processor, of modules that
an earlier start has compiled, as those of an installed program are. The first frame of the terminal
is timed by the clock on the wall, from the start to the last words of the greeting in a pty.
"""

from __future__ import annotations

import shutil
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from benchmarks.compiled import compiled_modules
from benchmarks.rows import Row, process_cost
from benchmarks.terminal import first_frame

BARE, NUMPY = "bare interpreter", "import numpy"
MOST = 25


def commands(program: Path) -> dict[str, list[str]]:
    """What is started, by its name; the installed script where there is one."""
    python = [sys.executable]
    module = [*python, "-m", "trs80arm"]
    beside = Path(sys.executable).with_name("trs80arm")
    script = str(beside) if beside.exists() else shutil.which("trs80arm")
    return {
        BARE: [*python, "-c", "pass"],
        NUMPY: [*python, "-c", "import numpy"],
        "trs80arm --help": [script, "--help"] if script else [*module, "--help"],
        "python -m trs80arm --help": [*module, "--help"],
        "trs80arm run, one line": [*module, "run", str(program)],
    }


def rows(seconds: float) -> Iterator[Row]:
    """Each start; more rounds for more seconds."""
    with tempfile.TemporaryDirectory() as folder, compiled_modules():
        program = Path(folder) / "one.bas"
        program.write_text('10 PRINT "READY"\n')
        started = commands(program)
        best: dict[str, float] = {}
        for _ in range(max(1, min(MOST, int(50 * seconds)))):
            for name, command in started.items():
                taken = process_cost(command)
                best[name] = min(best.get(name, taken), taken)
        for name, taken in best.items():
            measures = {"ms": 1000 * taken, "x bare": taken / best[BARE]}
            if taken > best[NUMPY]:
                measures["ms beyond numpy"] = 1000 * (taken - best[NUMPY])
            yield Row(name, measures)
        frames = [first_frame((120, 40)) for _ in range(max(2, min(8, int(20 * seconds))))]
        yield Row("first frame of the terminal, wall", {"ms": 1000 * min(frames)})
