"""A recorded session played again without a screen: what `trs80arm replay` does.

A recording is its own operator and brings its machine and bench along; what is told of it, and what
may be expected, is as of a run.
"""

from __future__ import annotations

from typing import TextIO

from trs80arm.batch import (
    BatchOptions,
    Done,
    Look,
    Stopwatch,
    Task,
    UnusableError,
    attempt,
    script_of,
    traced,
)
from trs80arm.desk.recording import Recording, RecordingError, load
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.operator import GLANCE
from trs80arm.rig import ReplayError, Rig
from trs80arm.script import Expected, RunScript
from trs80arm.teletype import Teletype


def replay_session(
    options: BatchOptions, out: TextIO | None = None, stopwatch: Stopwatch | None = None
) -> int:
    """Play a recording to its end, as the options say.

    Args:
        options: the recording in the place of a program, and what to tell of it.
        out: what is printed to; standard output unless given.
        stopwatch: seconds of the wall's clock, for JSON to tell how long it took.

    Returns:
        The exit code: 0 as expected, 1 not so or stopped on a BASIC error, 2 unusable.
    """

    def task() -> Task:
        script = script_of(options)
        if script != RunScript(expected=script.expected):
            raise UnusableError(
                f"{options.program}: a recording is its own operator: of a script it has [expect] "
                "and nothing else"
            )
        try:
            recording = load(options.program)
        except RecordingError as error:
            raise UnusableError(str(error)) from None

        def perform(stream: TextIO, look: Look | None) -> Done:
            return _play(options, recording, script.expected, stopwatch, stream, look)

        return Task(script, recording.end / T_STATES_PER_SECOND, perform)

    return attempt(options, task, out)


def _play(
    options: BatchOptions,
    recording: Recording,
    expected: Expected,
    stopwatch: Stopwatch | None,
    stream: TextIO,
    look: Look | None,
) -> Done:
    """Do everything again, each thing at its virtual time."""
    rig = recording.rig()
    teletype = Teletype(stream)
    rig.listen(lambda code, _: teletype(code))
    begun = stopwatch() if stopwatch else 0.0
    with traced(rig, options):
        for done in recording.inputs:
            _pass(rig, done.time, look)
            try:
                rig.replay([done])
            except ReplayError as error:
                raise UnusableError(f"{options.program}: {error}") from None
        _pass(rig, recording.end, look)
    teletype.end_line()
    wall = stopwatch() - begun if stopwatch else None
    return Done(rig, rig.waiting, rig.time, wall, True, expected, unattended=False)


def _pass(rig: Rig, target: int, look: Look | None) -> None:
    """Let time pass to a T-state, and whoever looks on look."""
    if look is not None:
        while rig.clock.now < target:
            look(rig)
            rig.run_to(min(target, rig.clock.now + round(GLANCE * T_STATES_PER_SECOND)))
    rig.run_to(target)
