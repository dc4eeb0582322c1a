"""Running a program without a screen: what `trs80arm run` does.

A rig, a scripted operator, the program's output on standard output, and at the end what was asked
for: the tube, the registers, the pose, traces.
"""

from __future__ import annotations

import io
import json
import sys
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path
from typing import TextIO

from trs80arm.arm.bench import BenchError
from trs80arm.basic.activity import Waiting
from trs80arm.basic.outcome import Ending
from trs80arm.benches import BenchFile, bench_beside
from trs80arm.files import FileFormatError, load_program
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.operator import Hold, Operator, ScriptError, parse_holds
from trs80arm.reasons import one_line
from trs80arm.report import ended, report
from trs80arm.rig import Rig, RigSettings
from trs80arm.teletype import ENTER, Teletype
from trs80arm.trace import PoseTrace, Trace, TraceError

DEFAULT_SECONDS = 3600.0
"""Virtual seconds after which an unattended run ends when no limit is given."""


class UnusableError(Exception):
    """What the user gave cannot be used: one clear line."""


@dataclass(frozen=True)
class BatchOptions:
    """The options of `trs80arm run`, as its help describes them."""

    program: Path
    bench: Path | None = None
    seconds: float | None = None
    inputs: tuple[str, ...] = ()
    sets: tuple[str, ...] = ()
    screen: bool = False
    registers: bool = False
    pose: bool = False
    as_json: bool = False
    trace: Path | None = None
    trace_pose: Path | None = None
    trace_rate: float | None = None
    rig: RigSettings = field(default_factory=RigSettings)


def run_program(
    options: BatchOptions,
    out: TextIO | None = None,
    stopwatch: Callable[[], float] | None = None,
) -> int:
    """Run a program as the options say.

    Args:
        options: what to run, and what to tell of it.
        out: what is printed to; standard output unless given.
        stopwatch: seconds of the wall's clock, for JSON to tell how long the run took.

    Returns:
        The exit code: 0 ended or limit reached, 1 stopped on a BASIC error, 2 unusable.
    """
    stream = out or sys.stdout
    try:
        return _run(options, stream, stopwatch)
    except BrokenPipeError:
        raise
    except (UnusableError, ScriptError, FileFormatError, BenchError, TraceError, OSError) as error:
        if isinstance(error, OSError) and error.filename is None:
            raise  # Of the stream that is printed to.
        print(f"trs80arm: {one_line(error)}", file=sys.stderr)
    return 2


def _run(options: BatchOptions, stream: TextIO, stopwatch: Callable[[], float] | None) -> int:
    _check_traces(options)
    if options.as_json and (options.screen or options.registers or options.pose):
        raise UnusableError("--json has screen, registers and pose in it: give it without them")
    lines = load_program(options.program)
    bench = options.bench or bench_beside(options.program)
    sets = [parse_holds(holds) for holds in options.sets]
    rig = Rig(options.rig, BenchFile.read(bench).bench if bench else None)
    if rig.waiting is Waiting.MEMORY_SIZE:
        raise UnusableError(
            f"MEMORY SIZE? does not take {options.rig.memory_size!r}: an address from 17430 to "
            f"{0x4000 + 1024 * options.rig.ram_kib - 1}, or nothing"
        )
    rig.load_lines(lines)
    begun = stopwatch() if stopwatch else 0.0
    kept = io.StringIO() if options.as_json else None
    with ExitStack() as traces:
        if options.trace:
            traces.enter_context(Trace(rig, options.trace))
        if options.trace_pose:
            traces.enter_context(PoseTrace(rig, options.trace_pose, options.trace_rate))
        waiting, spent = _from_run_to_end(rig, options, sets, kept or stream)
    if kept is not None:
        told = {
            "program": str(options.program),
            "ended": ended(rig.outcome, waiting),
            "output": kept.getvalue(),
            **report(rig),
            "seconds": {
                "virtual": round(spent, 6),
                "wall": round(stopwatch() - begun, 6) if stopwatch else None,
            },
        }
        print(json.dumps(told, indent=1), file=stream)
    if options.screen:
        print("\n".join(rig.screen()), file=stream)
    if options.registers:
        print(*rig.registers, file=stream)
    if options.pose:
        pose = rig.pose
        values = (pose.x, pose.y, pose.z, pose.pitch, pose.roll, pose.opening)
        print(*(f"{value + 0.0:.4f}" for value in values), file=stream)
    if rig.arm.bench.goals and not options.as_json:
        print(rig.score().text(), file=stream)
    stream.flush()
    return _verdict(rig, options, waiting)


def _check_traces(options: BatchOptions) -> None:
    """Refuse traces of which one would be lost or has nothing to be written to."""
    if options.trace_pose is None:
        if options.trace_rate is not None:
            raise UnusableError("--trace-rate is for --trace-pose FILE, which is not given")
    elif options.trace and options.trace.resolve() == options.trace_pose.resolve():
        raise UnusableError(f"{options.trace}: --trace and --trace-pose need a file each")


def _from_run_to_end(
    rig: Rig, options: BatchOptions, sets: list[list[Hold]], stream: TextIO
) -> tuple[Waiting, float]:
    """Type RUN and let the program run until it ends, waits in vain, or its time is over.

    Returns:
        What the machine waits for then, and the virtual seconds from RUN on.
    """
    teletype = Teletype(stream)
    start: list[int] = []
    after_the_end = bytearray()

    def listener(code: int, is_echo: bool) -> None:
        if not start:
            if is_echo and code == ENTER:
                start.append(rig.clock.now)
        elif rig.outcome is None:
            teletype(code)
        else:
            after_the_end.append(code)

    stop_listening = rig.listen(listener)
    rig.type("RUN\r")
    while not start:
        rig.run_for(0.01)
    limit = DEFAULT_SECONDS if options.seconds is None else options.seconds
    spent = (rig.clock.now - start[0]) / T_STATES_PER_SECOND
    waiting = Operator(rig, options.inputs, sets).run(limit - spent)
    stop_listening()
    # `?UL Error in 20` is the program's last word; READY and the prompt are the machine's.
    for code in after_the_end.partition(b"READY")[0]:
        teletype(code)
    teletype.end_line()
    return waiting, (rig.clock.now - start[0]) / T_STATES_PER_SECOND


def _verdict(rig: Rig, options: BatchOptions, waiting: Waiting) -> int:
    """Say on standard error what the output does not show, and give the exit code."""
    for device, fault in (("cassette", rig.tape.fault), ("printer", rig.printer.fault)):
        if fault is not None:
            print(f"trs80arm: {device}: {fault}", file=sys.stderr)
    outcome = rig.outcome
    if outcome is not None and outcome.ending is Ending.ERROR:
        return 1
    if waiting in (Waiting.INPUT, Waiting.SET):
        word, option = ("INPUT", "--input") if waiting is Waiting.INPUT else ("@SET", "--set")
        print(f"trs80arm: stopped at an {word} that no {option} answers", file=sys.stderr)
    elif waiting is Waiting.NOTHING and options.seconds is None:
        print(
            f"trs80arm: stopped after {DEFAULT_SECONDS:.0f} virtual seconds; --seconds N for more",
            file=sys.stderr,
        )
    return 0
