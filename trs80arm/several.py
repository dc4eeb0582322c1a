"""Several programs run at once, on all cores: a table, JSON, JUnit XML.

Each program runs on a rig of its own in a process of its own, with the bench and the script that
stand beside it, so that what it comes to does not hang on the others.
"""

from __future__ import annotations

import io
import json
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any, TextIO
from xml.etree import ElementTree

from rich.console import Console
from rich.table import Table
from rich.text import Text

from trs80arm.bars import counting
from trs80arm.batch import (
    UNUSABLE,
    BatchOptions,
    Stopwatch,
    UnusableError,
    carry_out,
    failed,
    faults,
    script_of,
)
from trs80arm.cores import EndedFromOutsideError, on_all_cores
from trs80arm.expectations import unmet
from trs80arm.reasons import one_line
from trs80arm.saving import expect_to_write, write_whole
from trs80arm.shown import shown

_PIPE_WIDTH = 160
"""Columns of the table where no terminal says how many there are."""


@dataclass(frozen=True)
class Run:
    """What became of one program.

    Attributes:
        program: its file.
        told: the run as one plain object; None where something could not be used.
        unmet: what is not as its script expects, a line each.
        notes: what its output does not show.
        error: the BASIC error that it ended on, unless one was expected.
        unusable: why it could not be run.
    """

    program: Path
    told: dict[str, Any] | None = None
    unmet: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    error: str = ""
    unusable: str = ""

    @property
    def passed(self) -> bool:
        """Whether it ran, without an error, to what was expected."""
        return not (self.unusable or self.unmet or self.error)

    @property
    def lines(self) -> Iterator[str]:
        """What there is to say of it, a line each."""
        if self.unusable:
            yield self.unusable
        yield from (f"{self.program}: {each}" for each in (self.error, *self.unmet) if each)


def run_one(options: BatchOptions, stopwatch: Stopwatch) -> Run:
    """Run one program; whatever is wrong with its files is in what is returned."""
    program = options.program
    printed = io.StringIO()
    try:
        done = carry_out(options, script_of(options), stopwatch, printed)
    except (UnusableError, *UNUSABLE) as error:
        return Run(program, unusable=one_line(error))
    told = done.told(program, printed.getvalue())
    ended = told["ended"]
    stopped = f"?{ended['error']} Error in {ended['line']}" if failed(done) else ""
    differing = tuple(unmet(done.expected, told))
    return Run(program, told, differing, tuple(faults(done)), stopped)


def run_programs(
    programs: Sequence[Path],
    options: BatchOptions,
    stopwatch: Stopwatch,
    *,
    jobs: int | None = None,
    junit: Path | None = None,
) -> int:
    """Run programs and print what became of them.

    Args:
        programs: their files.
        options: of all of them; its program is not looked at.
        stopwatch: seconds of the wall's clock.
        jobs: how many run at once; as many as there are cores unless given.
        junit: where JUnit XML is written to.

    Returns:
        The exit code: 0 all passed, 1 some did not, 2 something could not be used.
    """
    try:
        _refuse_what_is_for_one(options, len(programs))
        if junit is not None:
            expect_to_write(junit)
        every = [replace(options, program=each) for each in programs]
        runs = _run_all(every, stopwatch, jobs)
        if junit is not None:
            write_whole(junit, junit_xml(runs))
    except (UnusableError, EndedFromOutsideError, *UNUSABLE) as error:
        if isinstance(error, OSError) and error.filename is None:
            raise
        print(f"trs80arm: {one_line(error)}", file=sys.stderr)
        return 2
    if options.as_json:
        print(json.dumps(_plain(runs), indent=1))
    else:
        _print_table(runs, sys.stdout)
    sys.stdout.flush()
    for run in runs:
        for line in run.lines:
            print(f"trs80arm: {shown(line)}", file=sys.stderr)
        for note in run.notes:
            print(f"trs80arm: {shown(f'{run.program}: {note}')}", file=sys.stderr)
    if any(run.unusable for run in runs):
        return 2
    return 0 if all(run.passed for run in runs) else 1


def _refuse_what_is_for_one(options: BatchOptions, count: int) -> None:
    """What one run alone can have."""
    if options.screen or options.registers or options.pose:
        raise UnusableError("--screen, --registers and --pose are of one program: take --json")
    if count < 2:
        return
    for name, given in (
        ("--script", options.script),
        ("--trace", options.trace),
        ("--trace-pose", options.trace_pose),
        ("--printer", options.rig.printer_file),
    ):
        if given is not None:
            raise UnusableError(f"{name} is for one program, not for {count}")


def _run_all(every: list[BatchOptions], stopwatch: Stopwatch, jobs: int | None) -> list[Run]:
    """All runs in the order of the programs."""
    runs: dict[int, Run] = {}
    with counting("programs", len(every)) as advance:
        for place, run in on_all_cores(partial(run_one, stopwatch=stopwatch), every, jobs):
            runs[place] = run
            advance()
    return [runs[place] for place in range(len(every))]


# -- what is told ----------------------------------------------------------------------------------


def _print_table(runs: list[Run], stream: TextIO) -> None:
    table = Table()
    for name in ("Program", "Ended", "Virtual s", "Wall s", "Slips", "Goals", "Result"):
        table.add_column(name, justify="right" if name.endswith((" s", "Slips")) else "left")
    for run in runs:
        table.add_row(*(Text(shown(cell)) for cell in _cells(run)))
    console = Console(file=stream, width=None if stream.isatty() else _PIPE_WIDTH)
    with console.capture() as drawn:
        console.print(table)
    # Not printed by the console, which has its own way with a broken pipe.
    stream.write(drawn.get())
    passed = sum(run.passed for run in runs)
    print(f"{passed} of {len(runs)} passed", file=stream)


def _cells(run: Run) -> tuple[str, ...]:
    told = run.told
    if told is None:
        return run.program.name, "", "", "", "", "", "unusable"
    ended, score = told["ended"], told["score"]
    line = "" if ended["line"] is None else f" in {ended['line']}"
    error = f" ?{ended['error']}" if ended["error"] else ""
    return (
        run.program.name,
        f"{ended['how']}{error}{line}",
        f"{told['seconds']['virtual']:.1f}",
        f"{told['seconds']['wall']:.2f}",
        str(len(told["slips"])),
        f"{score['met']} of {score['total']}" if score else "",
        "passed" if run.passed else "failed",
    )


def _plain(runs: list[Run]) -> dict[str, Any]:
    return {
        "runs": [
            {
                **(run.told or {"program": str(run.program)}),
                "passed": run.passed,
                "unmet": list(run.unmet),
                "unusable": run.unusable or None,
            }
            for run in runs
        ],
        "passed": sum(run.passed for run in runs),
        "failed": sum(not run.passed for run in runs),
    }


def junit_xml(runs: Sequence[Run]) -> bytes:
    """The runs as JUnit XML: a test case each, what was printed in its `system-out`."""
    suite = ElementTree.Element(
        "testsuite",
        name="trs80arm",
        tests=str(len(runs)),
        failures=str(sum(not run.passed and not run.unusable for run in runs)),
        errors=str(sum(bool(run.unusable) for run in runs)),
        skipped="0",
        time=f"{sum(_wall(run) for run in runs):.3f}",
    )
    for run in runs:
        case = ElementTree.SubElement(
            suite,
            "testcase",
            classname="trs80arm",
            name=shown(run.program),
            time=f"{_wall(run):.3f}",
        )
        if not run.passed:
            lines = [shown(line) for line in run.lines]
            kind = "error" if run.unusable else "failure"
            told = ElementTree.SubElement(case, kind, message=lines[0])
            told.text = "\n".join(lines)
        if run.told is not None:
            output = "\n".join(map(shown, run.told["output"].splitlines()))
            ElementTree.SubElement(case, "system-out").text = output
    root = ElementTree.Element("testsuites")
    root.append(suite)
    ElementTree.indent(root)
    data: bytes = ElementTree.tostring(root, encoding="utf-8", xml_declaration=True)
    return data + b"\n"


def _wall(run: Run) -> float:
    return float(run.told["seconds"]["wall"]) if run.told else 0.0
