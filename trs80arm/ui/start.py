"""Opens the terminal program: `run_terminal` is what the command line calls."""

from __future__ import annotations

import contextlib
import gc
import os
import signal
import sys
import threading
import time
from typing import TYPE_CHECKING

from trs80arm.desk.last_resort import FAULT, last_words
from trs80arm.desk.opening import UNUSABLE, USAGE_ERROR, open_session
from trs80arm.desk.places import state_folder
from trs80arm.desk.plugged import plug_in
from trs80arm.desk.served import open_line
from trs80arm.options import ArmStyle, TerminalOptions
from trs80arm.reasons import one_line
from trs80arm.serial.endpoints import EndpointError
from trs80arm.serial.wire import WireError
from trs80arm.shown import message

if TYPE_CHECKING:
    from trs80arm.ui.app import Trs80Arm
    from trs80arm.ui.terminal.pixels import PixelScreen

SERVER = "TRS80ARM_SERVER"
"""The environment variable with the number of the process that serves this one to a browser."""
LOOK_SECONDS = 2.0
"""Between two looks at whether the server is still there."""


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
        courier = plug_in(session, options.plug)
        port = open_line(options)
    except (*UNUSABLE, WireError, EndpointError) as error:
        print(f"trs80arm: {one_line(error)}", file=sys.stderr)
        return USAGE_ERROR
    # What cannot be used is told before Textual is there.
    from trs80arm.ui import themes
    from trs80arm.ui.app import Trs80Arm

    app = Trs80Arm(session, options, state_folder(), courier=courier, port=port)
    if why := themes.refusal(options.theme, app.available_themes):
        print(f"trs80arm: {message(why)}", file=sys.stderr)
        return USAGE_ERROR
    _end_with_server()
    app.desk.use_pixels(_pixels(app, options))
    # What is there now stays to the end: to search it for garbage takes as long as ten frames.
    gc.freeze()
    gc.enable()
    result = app.run()
    if result is None:
        # Textual has restored the terminal.
        app.recovery.keep()
        result = FAULT
        if app.fault is not None:
            words = last_words(app.fault, state_folder(), session)
            print(f"trs80arm: {words}", file=sys.stderr)
    app.plugged.close()
    app.served.close()
    app.recovery.let_go()
    # The terminal may have been closed.
    with contextlib.suppress(OSError):
        _tell_of_copies(app)
    return result


def _pixels(app: Trs80Arm, options: TerminalOptions) -> PixelScreen | str:
    """The pixels of this terminal, or why there are none; asked before Textual reads it."""
    from trs80arm.ui.terminal.pixels import NOT_ASKED, NoPixelsError, find_pixels, may_have_pixels

    if options.arm is not ArmStyle.PIXELS and not may_have_pixels(os.environ):
        return NOT_ASKED
    try:
        return find_pixels(app.console.color_system)
    except NoPixelsError as error:
        return str(error)


def _end_with_server() -> None:
    """A program that a browser sees ends with its server, also when that was killed."""
    server = os.environ.get(SERVER, "")
    if server.isdecimal():
        watch = threading.Thread(target=_watch_server, args=(int(server),), daemon=True)
        watch.start()


def _watch_server(server: int) -> None:
    while os.getppid() == server:
        time.sleep(LOOK_SECONDS)
    os.kill(os.getpid(), signal.SIGTERM)
    # Should the program not hear: it keeps its copies within that time.
    time.sleep(2 * LOOK_SECONDS)
    os._exit(FAULT)


def _tell_of_copies(app: Trs80Arm) -> None:
    """Where that is kept which is not saved; nothing after an ordinary end."""
    for what, path in app.recovery.kept():
        print(f"trs80arm: {what} in {path}", file=sys.stderr)


def _has_terminal() -> bool:
    """Whether there is a terminal, or a browser that stands for one."""
    if os.environ.get("TEXTUAL_DRIVER"):
        return True
    streams = (sys.__stdin__, sys.__stderr__)
    return all(stream is not None and stream.isatty() for stream in streams)
