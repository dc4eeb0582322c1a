"""The terminal program: `run_terminal` is what the command line calls.

The app is the desk with its commands. It is made with everything that it needs, so that a test can
give it a session and a clock of its own.
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import signal
import sys
import threading

from trs80arm.arm.bench import BenchError
from trs80arm.desk.demo import Demo
from trs80arm.desk.opening import UNUSABLE, USAGE_ERROR, open_session
from trs80arm.desk.places import state_folder
from trs80arm.files import FileFormatError
from trs80arm.options import TerminalOptions
from trs80arm.reasons import one_line
from trs80arm.ui.commands.files import PLAYING
from trs80arm.ui.commands.machine import MachineCommands
from trs80arm.ui.commands.table import Palette, bindings
from trs80arm.ui.themes import THEMES

CRASHED = 3
SIGNALLED = 128
"""With the number of the signal added: the exit code of a program that was told to end."""
GRACE = 2.0
"""Seconds in which a program that was told to end gives the terminal back."""
ENDING = [
    signal.Signals[name] for name in ("SIGTERM", "SIGHUP") if name in signal.Signals.__members__
]
"""Told to end, or the terminal was closed: the program goes, but what is unsaved is kept."""


class Trs80Arm(MachineCommands):
    """A TRS-80 and a MiniMover 5 in the terminal: a `Desk` with all its commands."""

    BINDINGS = bindings()
    COMMANDS = {Palette}  # noqa: RUF012

    _demo: Demo | None = None

    def on_ready(self) -> None:
        """Say what was loaded, run it, or play, as the options want."""
        options = self.options
        if self._ticking:
            for number in ENDING:
                # Windows has no such handlers.
                with contextlib.suppress(NotImplementedError):
                    asyncio.get_running_loop().add_signal_handler(number, self._told_to_end, number)
        if options.demo:
            self.action_demo()
        elif self.session.playing:
            self.say(PLAYING)
        elif self.session.path is not None:
            self.loaded(self.session.path)
            if options.run:
                self.action_run_program()

    def _told_to_end(self, number: signal.Signals) -> None:
        """A signal: keep what is unsaved, give the terminal back, end."""
        self.keep_copy()
        self.session.close()
        # Of a terminal that is gone nothing can be given back, and the writes that wait for it
        # would keep the program for ever.
        last = threading.Timer(GRACE, os._exit, (SIGNALLED + number,))
        last.daemon = True
        last.start()
        self.exit(SIGNALLED + number)

    def action_demo(self) -> None:
        """Play the demonstration."""
        self.if_program_may_go("Demonstration", self._start_demo)

    def _start_demo(self) -> None:
        try:
            self._demo = Demo(self.session)
        except (OSError, BenchError, FileFormatError) as error:
            self.say(f"No demonstration: {one_line(error)}", error=True)
        else:
            self.pacer.forgive()

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
        The exit code: 0, 2 when a file of the options cannot be used or there is no terminal, told
        in one line on standard error, 3 after a fault of the program, 128 and the number of the
        signal that ended it.
    """
    if not _has_terminal():
        print("trs80arm: this is no terminal; --plain works without one", file=sys.stderr)
        return USAGE_ERROR
    try:
        session = open_session(options)
    except UNUSABLE as error:
        print(f"trs80arm: {one_line(error)}", file=sys.stderr)
        return USAGE_ERROR
    app = Trs80Arm(session, options, state_folder())
    if options.theme not in app.available_themes:
        own = ", ".join(theme.name for theme in THEMES)
        print(
            f"trs80arm: theme: there is no theme {options.theme!r}; there are {own} "
            "and those of Textual",
            file=sys.stderr,
        )
        return USAGE_ERROR
    result = app.run()
    if result is None:
        # Textual has restored the terminal and shown what went wrong.
        app.keep_copy()
        result = CRASHED
    # The terminal may have been closed.
    with contextlib.suppress(OSError):
        _tell_of_copies(app)
    return result


def _tell_of_copies(app: Trs80Arm) -> None:
    """Where that is kept which is not saved; nothing after an ordinary end."""
    for what, path in (
        ("the program in memory is kept", app.copy_path),
        ("the positions taught are kept as a program", app.lesson_copy_path),
    ):
        if path.is_file():
            print(f"trs80arm: {what} in {path}", file=sys.stderr)


def _has_terminal() -> bool:
    """Whether there is a terminal, or a browser that stands for one."""
    if os.environ.get("TEXTUAL_DRIVER"):
        return True
    streams = (sys.__stdin__, sys.__stderr__)
    return all(stream is not None and stream.isatty() for stream in streams)
