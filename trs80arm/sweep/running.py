"""The runs of a sweep, on as many cores as there are.

Every run is a rig of its own from power-on. What is varied, and the errors in placing, are settled
before it begins; the run itself is the same every time.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

from trs80arm.arm.events import EventKind
from trs80arm.cores import EndedFromOutsideError, on_all_cores
from trs80arm.operator import Hold, Operator
from trs80arm.report import ended
from trs80arm.rig import Rig, RigSettings
from trs80arm.sweep.axes import NOISE, Axis, SweepError
from trs80arm.sweep.constants import Constant, Line, find, replaced
from trs80arm.sweep.placing import changed, placed
from trs80arm.unattended import ready

ENDINGS = ("end", "stop", "limit")
"""How a run may have ended to succeed: not by an error, or at a question that nobody answered."""


@dataclass(frozen=True)
class Plan:
    """What all runs of a sweep have in common.

    Attributes:
        lines: the program, crunched.
        source: the bench file, as errors call it.
        bench: what it says.
        inputs: the answers to INPUT.
        sets: what is done in each `@SET`.
        seconds: virtual ones after which a run is looked at as it is then.
        noise: standard deviation of the error in placing, inches.
        seed: that the errors are drawn from.
        no_slip: whether a motor that slips is a failure.
        expect: what has to be printed, or empty.
    """

    lines: tuple[Line, ...]
    source: str
    bench: dict[str, Any]
    inputs: tuple[str, ...] = ()
    sets: tuple[tuple[Hold, ...], ...] = ()
    seconds: float = 600.0
    noise: float = 0.0
    seed: int = 1
    no_slip: bool = False
    expect: str = ""


@dataclass(frozen=True)
class Case:
    """One run to be done.

    Attributes:
        values: of the axes.
        run: its number in the cell, from 1.
        settings: the machine's fittings.
    """

    values: tuple[float, ...]
    run: int
    settings: RigSettings


@dataclass(frozen=True)
class Result:
    """How one run went.

    Attributes:
        values: of the axes.
        run: its number in the cell, from 1.
        success: whether it did what was asked for.
        ended: `end`, `stop`, `break`, `error`, `input`, `set`, or `limit`.
        met: goals of the bench that were met.
        goals: that there are.
        off: inches by which the worst part is off its place; None if none belongs anywhere.
        slips: times that a motor slipped.
        lost: half-steps lost by it, of all motors.
        peak: the most that any motor used of what it has, per cent.
        seconds: virtual ones from power-on.
    """

    values: tuple[float, ...]
    run: int
    success: bool
    ended: str
    met: int
    goals: int
    off: float | None
    slips: int
    lost: int
    peak: int
    seconds: float


def cases(
    axes: Sequence[Axis],
    cells: Sequence[tuple[float, ...]],
    runs: int,
    settings_of: Callable[[Mapping[str, float]], RigSettings],
) -> Iterator[Case]:
    """All runs, cell by cell.

    Args:
        axes: what is varied.
        cells: of the grid.
        runs: of each.
        settings_of: the fittings for values of those axes that are settings.
    """
    for cell in cells:
        named = {
            axis.name: value for axis, value in zip(axes, cell, strict=True) if axis.is_setting
        }
        settings = settings_of(named)
        for run in range(1, runs + 1):
            yield Case(cell, run, settings)


def run_case(plan: Plan, axes: Sequence[Axis], case: Case) -> Result:
    """Do one run.

    Raises:
        NotReadyError: it is given a memory size that it does not take.
        SweepError: it has nothing of an axis' name.
        BenchError: its bench cannot be.
    """
    rig = _rig(plan, axes, case)
    printed = bytearray()
    rig.listen(lambda code, is_echo: None if is_echo else printed.append(code))
    rig.type("RUN\r")
    waiting = Operator(rig, plan.inputs, plan.sets).run(plan.seconds)
    how = ended(rig.outcome, waiting)["how"]
    score = rig.score()
    slips = [event for event in rig.arm.events if event.kind is EventKind.SLIP]
    success = (
        how in ENDINGS
        and score.perfect
        and not (slips and plan.no_slip)
        and plan.expect.encode("latin-1", "replace") in bytes(printed)
    )
    return Result(
        case.values,
        case.run,
        success,
        how,
        score.met,
        score.total,
        max(score.errors, default=None),
        len(slips),
        sum(abs(event.steps) for event in slips),
        max(load.peak for load in rig.loads.motors),
        round(rig.time, 6),
    )


def _rig(plan: Plan, axes: Sequence[Axis], case: Case) -> Rig:
    """The rig of a case, with its program in memory."""
    noise, keys = plan.noise, {}
    constants: dict[Constant, float] = {}
    for axis, value in zip(axes, case.values, strict=True):
        if axis.name == NOISE:
            noise = value
        elif axis.in_program:
            for constant in find(plan.lines, axis.name):
                if constant in constants:
                    raise SweepError("two of the things to be varied are one number of the program")
                constants[constant] = value
        elif axis.of_parts:
            keys[axis.of_parts] = value
    bench = placed(plan.source, changed(plan.bench, keys), noise, plan.seed, case.run)
    return ready(case.settings, bench, replaced(plan.lines, constants))


def check(plan: Plan, axes: Sequence[Axis], each: Sequence[Case]) -> None:
    """See that every cell can be run, on a bench without errors, before any is.

    Raises:
        NotReadyError: one is given a memory size that it does not take.
        SweepError: one cannot.
        BenchError: its bench cannot be.
    """
    for number, axis in enumerate(axes):
        for value in axis.values:
            case = next(case for case in each if case.values[number] == value)
            _rig(plan, axes, case)


def run_all(
    plan: Plan, axes: Sequence[Axis], each: Sequence[Case], jobs: int | None = None
) -> Iterator[Result]:
    """Do all runs; their results come in the order of the cases, on however many cores.

    Args:
        plan: what they have in common.
        axes: what is varied.
        each: the runs.
        jobs: processes; as many as there are cores unless given, and with one no other process.

    Raises:
        SweepError: a run cannot be, or a process was ended from outside.
        BenchError: its bench cannot be.
    """
    early: dict[int, Result] = {}
    awaited = 0
    try:
        for number, result in on_all_cores(partial(run_case, plan, axes), each, jobs):
            early[number] = result
            while awaited in early:
                yield early.pop(awaited)
                awaited += 1
    except EndedFromOutsideError as error:
        raise SweepError(str(error)) from None
