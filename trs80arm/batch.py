"""Running a program without a screen: what `trs80arm run` does.

A rig, a scripted operator, the program's output on standard output, and at the end what was asked
for: the tube, the registers, the pose, traces.
"""

from __future__ import annotations

import io
import json
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, ExitStack, contextmanager, nullcontext
from dataclasses import dataclass, field, replace
from functools import partial
from os.path import realpath
from pathlib import Path
from typing import TYPE_CHECKING, Any, TextIO

from trs80arm.arm.bench import BenchError
from trs80arm.bars import running
from trs80arm.basic.activity import Waiting
from trs80arm.basic.outcome import Ending
from trs80arm.expectations import unmet
from trs80arm.files import FileFormatError
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.operator import Operator, ScriptError, parse_holds
from trs80arm.reasons import one_line
from trs80arm.report import ended, report
from trs80arm.rig import Rig, RigSettings
from trs80arm.script import Expected, RunScript, read_script, script_beside
from trs80arm.serial.wire import WireError
from trs80arm.shown import shown
from trs80arm.teletype import ENTER, Teletype
from trs80arm.trace import PoseTrace, Trace, TraceError
from trs80arm.unattended import NotReadyError, ready_with

if TYPE_CHECKING:
    from trs80arm.serial.limits import Plugging

DEFAULT_SECONDS = 3600.0
"""Virtual seconds after which an unattended run ends when no limit is given."""


Look = Callable[[Rig], None]
Stopwatch = Callable[[], float]


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
    script: Path | None = None
    rig: RigSettings = field(default_factory=RigSettings)
    plug: Plugging | None = None


@dataclass(frozen=True)
class Done:
    """A run that is over.

    Attributes:
        rig: as it stands.
        waiting: what the machine waits for.
        spent: virtual seconds from RUN on.
        wall: seconds of the wall's clock, where somebody gave one.
        limited: whether the limit of seconds was asked for.
        expected: by the script.
        unattended: whether a script answered, and not a person whose session was recorded.
    """

    rig: Rig
    waiting: Waiting
    spent: float
    wall: float | None
    limited: bool
    expected: Expected
    unattended: bool = True

    def told(self, program: Path, output: str) -> dict[str, Any]:
        """The whole run as one plain object."""
        return {
            "program": str(program),
            "ended": ended(self.rig.outcome, self.waiting),
            "output": output,
            **report(self.rig),
            "seconds": {
                "virtual": round(self.spent, 6),
                "wall": None if self.wall is None else round(self.wall, 6),
            },
        }


@dataclass(frozen=True)
class Task:
    """What is to be run.

    Attributes:
        script: what the operator does, and what is expected.
        seconds: virtual ones that it takes at most; None if nobody has said.
        perform: does it, given what is printed to and who is called with the rig now and then.
    """

    script: RunScript
    seconds: float | None
    perform: Callable[[TextIO, Look | None], Done]


UNUSABLE = (NotReadyError, ScriptError, FileFormatError, BenchError, TraceError, WireError, OSError)
"""What is raised for what cannot be used, beside `UnusableError`."""


def run_program(
    options: BatchOptions,
    out: TextIO | None = None,
    stopwatch: Stopwatch | None = None,
) -> int:
    """Run a program as the options say.

    Args:
        options: what to run, and what to tell of it.
        out: what is printed to; standard output unless given.
        stopwatch: seconds of the wall's clock, for JSON to tell how long the run took.

    Returns:
        The exit code: 0 ended or limit reached, 1 stopped on a BASIC error, 2 unusable.
    """

    def task() -> Task:
        script = script_of(options)
        return Task(script, script.seconds, partial(carry_out, options, script, stopwatch))

    return attempt(options, task, out)


def attempt(options: BatchOptions, task: Callable[[], Task], out: TextIO | None = None) -> int:
    """Do a task, and tell of it as the options say; whatever cannot be used is one line.

    Args:
        options: what to tell of it.
        task: reads what is to be run.
        out: what is printed to; standard output unless given.

    Returns:
        The exit code, as `run_program`.
    """
    stream = out or sys.stdout
    try:
        return _run(options, task, stream)
    except BrokenPipeError:
        raise
    except (UnusableError, *UNUSABLE) as error:
        if isinstance(error, OSError) and error.filename is None:
            raise  # Of the stream that is printed to.
        print(f"trs80arm: {one_line(error)}", file=sys.stderr)
    return 2


def _run(options: BatchOptions, task: Callable[[], Task], stream: TextIO) -> int:
    _check_traces(options)
    if options.as_json and (options.screen or options.registers or options.pose):
        raise UnusableError("--json has screen, registers and pose in it: give it without them")
    kept = io.StringIO() if options.as_json else None
    chosen = task()
    script = chosen.script
    with running(options.program.stem, chosen.seconds, stream) as (look, shown_on):
        out: TextIO = kept or shown_on
        if script.expected.anything and kept is None:
            out = _Both(shown_on)
        done = chosen.perform(out, look)
    rig = done.rig
    failures: list[str] = []
    if kept is not None or script.expected.anything:
        told = done.told(options.program, out.getvalue() if isinstance(out, io.StringIO) else "")
        failures = unmet(script.expected, told)
        if kept is not None:
            print(json.dumps({**told, "unmet": failures}, indent=1), file=stream)
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
    for words in faults(done):
        print(f"trs80arm: {words}", file=sys.stderr)
    for failure in failures:
        print(shown(f"{options.program}: {failure}"), file=sys.stderr)
    return 1 if failures or failed(done) else 0


class _Both(io.StringIO):
    """Keeps what is printed, and prints it."""

    def __init__(self, stream: TextIO) -> None:
        super().__init__()
        self._stream = stream

    def write(self, text: str) -> int:
        """Print."""
        self._stream.write(text)
        return super().write(text)

    def flush(self) -> None:
        """Let it be seen."""
        self._stream.flush()


def script_of(options: BatchOptions) -> RunScript:
    """What the operator does, by the script and by the options."""
    path = options.script or script_beside(options.program)
    script = read_script(path) if path else RunScript()
    return replace(
        script,
        seconds=script.seconds if options.seconds is None else options.seconds,
        inputs=(*script.inputs, *options.inputs),
        sets=(*script.sets, *(tuple(parse_holds(holds)) for holds in options.sets)),
    )


def carry_out(
    options: BatchOptions,
    script: RunScript,
    stopwatch: Stopwatch | None,
    stream: TextIO,
    look: Look | None = None,
) -> Done:
    """Run a program to its end, its limit, or what nobody answers.

    Args:
        options: the program, its bench, the rig and the traces.
        script: what the operator does.
        stopwatch: seconds of the wall's clock.
        stream: what is printed to.
        look: called with the rig now and then.

    Raises:
        NotReadyError: the memory size cannot be.
        FileFormatError, BenchError, TraceError, OSError: a file cannot be used.
        WireError: the arm on the wire cannot follow, or may not.
    """
    rig = ready_with(options.rig, options.program, options.bench)
    begun = stopwatch() if stopwatch else 0.0
    with traced(rig, options), _plugged(rig, options.plug) as follow:
        looks = [each for each in (look, follow) if each is not None]
        waiting, spent = _from_run_to_end(rig, script, stream, _all_of(looks))
    wall = stopwatch() - begun if stopwatch else None
    return Done(rig, waiting, spent, wall, script.seconds is not None, script.expected)


def _all_of(looks: Sequence[Look]) -> Look | None:
    """Everybody who looks, as one; None if nobody does."""

    def look(rig: Rig) -> None:
        for each in looks:
            each(rig)

    return look if looks else None


def _plugged(rig: Rig, plug: Plugging | None) -> AbstractContextManager[Look | None]:
    """What has to be called now and then for an arm on a wire to follow, if one is plugged in."""
    if plug is None:
        return nullcontext()
    # Threads and ports: few runs have them.
    from trs80arm.serial.courier import plugged

    return plugged(rig, plug)


@contextmanager
def traced(rig: Rig, options: BatchOptions) -> Iterator[None]:
    """Write the traces that the options ask for while a block runs.

    Raises:
        TraceError, OSError: one cannot be written.
    """
    with ExitStack() as traces:
        if options.trace:
            traces.enter_context(Trace(rig, options.trace))
        if options.trace_pose:
            traces.enter_context(PoseTrace(rig, options.trace_pose, options.trace_rate))
        yield


def _check_traces(options: BatchOptions) -> None:
    """Refuse traces of which one would be lost or has nothing to be written to."""
    if options.trace_pose is None:
        if options.trace_rate is not None:
            raise UnusableError("--trace-rate is for --trace-pose FILE, which is not given")
    elif options.trace and realpath(options.trace) == realpath(options.trace_pose):
        raise UnusableError(f"{options.trace}: --trace and --trace-pose need a file each")


def _from_run_to_end(
    rig: Rig, script: RunScript, stream: TextIO, look: Look | None
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
    limit = DEFAULT_SECONDS if script.seconds is None else script.seconds
    spent = (rig.clock.now - start[0]) / T_STATES_PER_SECOND
    begun = start[0] / T_STATES_PER_SECOND
    keys = [(begun + at, hold) for at, hold in script.keys]
    waiting = Operator(rig, script.inputs, script.sets, keys, look).run(limit - spent)
    stop_listening()
    # `?UL Error in 20` is the program's last word; READY and the prompt are the machine's.
    for code in after_the_end.partition(b"READY")[0]:
        teletype(code)
    teletype.end_line()
    return waiting, (rig.clock.now - start[0]) / T_STATES_PER_SECOND


def faults(done: Done) -> Iterator[str]:
    """What the output of a run does not show, in words."""
    rig = done.rig
    for device, fault in (("cassette", rig.tape.fault), ("printer", rig.printer.fault)):
        if fault is not None:
            yield f"{device}: {fault}"
    expected = done.expected.ended is not None
    if _stopped_by_error(rig) or expected or not done.unattended:
        return
    if done.waiting in (Waiting.INPUT, Waiting.SET):
        word, option = ("INPUT", "--input") if done.waiting is Waiting.INPUT else ("@SET", "--set")
        yield f"stopped at an {word} that no {option} answers"
    elif done.waiting is Waiting.NOTHING and not done.limited:
        yield f"stopped after {DEFAULT_SECONDS:.0f} virtual seconds; --seconds N for more"


def failed(done: Done) -> bool:
    """Whether the run ended on a BASIC error that no script expects."""
    return _stopped_by_error(done.rig) and done.expected.ended != Ending.ERROR.value


def _stopped_by_error(rig: Rig) -> bool:
    return rig.outcome is not None and rig.outcome.ending is Ending.ERROR
