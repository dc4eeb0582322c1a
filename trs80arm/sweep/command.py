"""What `trs80arm sweep` does: settle what is run, run it, and tell of it."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from contextlib import ExitStack
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path

from trs80arm.arm.bench import BenchError
from trs80arm.arm.figures import FigureError
from trs80arm.arm.figures.chart import SUFFIXES
from trs80arm.bars import counting
from trs80arm.benches import bench_for
from trs80arm.files import FileFormatError, load_program
from trs80arm.operator import ScriptError, parse_holds
from trs80arm.paths import is_file
from trs80arm.reasons import reason
from trs80arm.rig import RigSettings
from trs80arm.saving import expect_to_write, whole_file
from trs80arm.sweep.axes import NOISE, SweepError, grid, parse_axis
from trs80arm.sweep.journal import Journal, mark
from trs80arm.sweep.placing import read_bench
from trs80arm.sweep.running import Plan, Result, cases, check, run_all
from trs80arm.sweep.telling import chart, csv_text, table
from trs80arm.unattended import NotReadyError

MOST_RUNS = 1_000_000


@dataclass(frozen=True)
class SweepOptions:
    """The options of `trs80arm sweep`, as its help describes them."""

    program: Path
    vary: tuple[str, ...]
    bench: Path | None = None
    noise: float = 0.0
    runs: int = 1
    seed: int = 1
    seconds: float = 600.0
    inputs: tuple[str, ...] = ()
    sets: tuple[str, ...] = ()
    no_slip: bool = False
    expect: str = ""
    output: Path | None = None
    plot: Path | None = None
    jobs: int | None = None


def run_sweep(
    options: SweepOptions, settings_of: Callable[[Mapping[str, float]], RigSettings]
) -> None:
    """Do a sweep and print its table.

    Args:
        options: what to vary, what to do and where to write it.
        settings_of: the fittings for values of those things varied that are settings.

    Raises:
        SweepError: it cannot be done; one line that says why.
    """
    try:
        _run(options, settings_of)
    except (NotReadyError, FileFormatError, ScriptError, BenchError, FigureError) as error:
        raise SweepError(str(error)) from None
    except OSError as error:
        if error.filename is None:
            raise  # Of the stream that is printed to.
        raise SweepError(f"{error.filename}: {reason(error)}") from None


def _run(options: SweepOptions, settings_of: Callable[[Mapping[str, float]], RigSettings]) -> None:
    axes = [parse_axis(text) for text in options.vary]
    cells = grid(axes)
    if len(cells) * options.runs > MOST_RUNS:
        raise SweepError(f"that is {len(cells) * options.runs} runs; {MOST_RUNS} at most")
    if options.plot is not None:
        if len(axes) > 2:
            raise SweepError("--plot shows one or two things varied")
        if options.plot.suffix.lower() not in SUFFIXES:
            raise SweepError(f"{options.plot}: a plot is saved as one of {', '.join(SUFFIXES)}")
        if find_spec("matplotlib") is None:
            raise SweepError("--plot needs matplotlib: pip install 'trs80arm[plot]'")
        expect_to_write(options.plot)
    path = bench_for(options.program, options.bench)
    lines = load_program(options.program)
    source, bench = read_bench(path)
    plan = Plan(
        lines=tuple(lines),
        source=source,
        bench=bench,
        inputs=options.inputs,
        sets=tuple(tuple(parse_holds(holds)) for holds in options.sets),
        seconds=options.seconds,
        noise=options.noise,
        seed=options.seed,
        # Where nothing else says what is wanted, a run in which all steps are made is a good one.
        no_slip=options.no_slip or not (bench.get("goal") or options.expect),
        expect=options.expect,
    )
    each = list(cases(axes, cells, options.runs, settings_of))
    check(plan, axes, each)
    # Left last: the journal goes when the file that it was for is there.
    with ExitStack() as journals, ExitStack() as files:
        # Opened before the runs, so that none is in vain; it appears when all are done.
        file = files.enter_context(whole_file(options.output)) if options.output else None
        output, journal = options.output, None
        # What is no regular file, as a pipe, is written to and never gone on with.
        if output is not None and (is_file(output) or not output.exists()):
            journal = Journal(output, mark(plan, axes, each), each)
        results = list(journal.results) if journal else []
        begun = len(results)
        if begun:
            print(f"trs80arm: {begun} of {len(each)} runs were done before", file=sys.stderr)
        others = run_all(plan, axes, each[begun:], options.jobs)
        try:
            with counting("runs", len(each), begun) as advance:
                kept = journals.enter_context(journal.keep(others)) if journal else others
                for result in kept:
                    results.append(result)
                    advance()
        except KeyboardInterrupt:
            _tell_broken_off(journal, len(results), len(each))
            raise
        if file is not None:
            file.write(csv_text(axes, results, plan.seed).encode("utf-8"))
    title = _title(options, plan)
    print(table(axes, results, title).text(), end="")
    _tell_questions(results)
    if options.plot is not None:
        chart(axes, results, title).save(options.plot)


def _wanted(plan: Plan) -> str:
    """What success was, in words."""
    wanted = []
    if plan.bench.get("goal"):
        wanted.append("goals met")
    if plan.expect:
        wanted.append(f"{plan.expect!r} printed")
    if plan.no_slip:
        wanted.append("no slip")
    return ", ".join(wanted)


def _title(options: SweepOptions, plan: Plan) -> str:
    """What was run, and what success was."""
    parts = [f"{options.program.name}: {_wanted(plan)}"]
    if options.runs > 1:
        parts.append(f"{options.runs} runs of each")
    if options.noise or any(parse_axis(text).name == NOISE for text in options.vary):
        error = f" of {options.noise:g} in" if options.noise else ""
        parts.append(f"parts placed with an error{error}, seed {options.seed}")
    return "; ".join(parts)


def _tell_broken_off(journal: Journal | None, done: int, total: int) -> None:
    """Say what became of the runs that are done when the user ends the whole."""
    how = "lost; with -o FILE they would be kept"
    if journal is not None:
        how = f"in {journal.path}; the same command goes on from there"
    print(f"trs80arm: broken off; {done} of {total} runs are {how}", file=sys.stderr)


def _tell_questions(results: list[Result]) -> None:
    """Say if runs failed for want of an answer, which is the operator's fault and not the arm's."""
    for how, word, option in (("input", "INPUT", "--input"), ("set", "@SET", "--set")):
        count = sum(each.ended == how for each in results)
        if count:
            print(
                f"trs80arm: {count} of {len(results)} runs stopped at an {word} that no {option} "
                "answers",
                file=sys.stderr,
            )
