"""The terminal program: `run_terminal` is what the command line calls.

The app is the desk with its commands. It is made with everything that it needs, so that a test can
give it a session and a clock of its own.
"""

from __future__ import annotations

import sys

from trs80arm.arm.bench import BenchError
from trs80arm.batch import bench_beside
from trs80arm.options import TerminalOptions
from trs80arm.ui.commands import Palette, bindings
from trs80arm.ui.demo import Demo
from trs80arm.ui.machine_commands import MachineCommands
from trs80arm.ui.places import state_folder
from trs80arm.ui.session import Session

USAGE_ERROR = 2
CRASHED = 3


class Trs80Arm(MachineCommands):
    """A TRS-80 and a MiniMover 5 in the terminal: a `Desk` with all its commands."""

    BINDINGS = bindings()
    COMMANDS = {Palette}  # noqa: RUF012

    _demo: Demo | None = None

    def on_ready(self) -> None:
        """Load, run, play or greet, as the options say."""
        options = self.options
        if options.replay is not None:
            self.play_file(options.replay)
        elif options.demo:
            self.action_demo()
        elif options.program is not None:
            self.load_file(options.program)
            if options.run:
                self.action_run_program()

    def action_demo(self) -> None:
        """Play the demonstration."""
        self.if_program_may_go("Demonstration", self._start_demo)

    def _start_demo(self) -> None:
        self._demo = Demo(self.session)
        self.another_machine()

    def tick(self) -> None:
        """Let the demonstration do its next thing, then let time pass."""
        if self._demo is not None:
            self._demo.go_on()
            self.say(self._demo.caption)
            if self._demo.over:
                self._demo = None
        super().tick()

    def operator_came(self) -> bool:
        """Whether a key only ended the demonstration or a recording."""
        if self._demo is not None:
            self._demo.stop()
            self._demo = None
        elif self.session.playing:
            self.session.stop_playing()
        else:
            return False
        self.say("The machine is yours.")
        return True


def run_terminal(options: TerminalOptions) -> int:
    """Open the terminal program and stay until its user leaves.

    Returns:
        The exit code: 0, or 2 when a file of the options cannot be used, told in one line on
        standard error.
    """
    if options.plain:
        from trs80arm.ui.plain import run_plain

        return run_plain(options)
    try:
        session = open_session(options)
    except (OSError, BenchError, ValueError) as error:
        print(f"trs80arm: {one_line(error)}", file=sys.stderr)
        return USAGE_ERROR
    app = Trs80Arm(session, options, state_folder())
    result = app.run()
    if result is None:
        # Textual has restored the terminal and shown what went wrong.
        app.keep_copy()
        print(f"trs80arm: the program in memory is kept in {app.copy_path}", file=sys.stderr)
        return CRASHED
    return result


def open_session(options: TerminalOptions) -> Session:
    """The desk as the options want it: the machine, its bench, the recording kept of it.

    Raises:
        OSError: a file cannot be read or written.
        BenchError: the bench file is none.
        ValueError: a fitting of the machine cannot be.
    """
    bench = options.bench
    if bench is None and options.program is not None:
        bench = bench_beside(options.program)
    session = Session(options.rig, bench, options.record)
    started_with = (options.program, options.replay, options.demo or None, options.plain or None)
    if all(choice is None for choice in started_with):
        session.greet()
    return session


def one_line(error: Exception) -> str:
    """What went wrong, in one line for standard error."""
    if isinstance(error, OSError) and error.filename:
        return f"{error.filename}: {error.strerror}"
    return str(error).splitlines()[0] if str(error) else type(error).__name__
