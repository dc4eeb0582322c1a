"""The commands that open the terminal, here or in a browser."""

from __future__ import annotations

import gc
import sys
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

import click

from trs80arm.cli.arguments import A_PATH, A_PROGRAM, Folder, WholeNumber
from trs80arm.cli.ending import fail
from trs80arm.cli.options import (
    PLUGGED_ARM,
    SCREEN_FLAGS,
    machine_options,
    plug_options,
    settings_options,
    take_plug,
    take_settings,
)

if TYPE_CHECKING:
    from trs80arm.options import TerminalOptions


@click.command()
@click.argument("program", type=A_PROGRAM, required=False)
@click.option("--run", is_flag=True, help="Type RUN at once.")
@click.option("--record", type=A_PATH, help="Write everything that the operator does to a file.")
@click.option("--replay", type=A_PATH, help="Play a recorded session.")
@click.option("--plain", is_flag=True, help="Line by line, for screen readers and pipes.")
@click.option(
    "--own-folder",
    type=Folder(),
    help="Open and save in this folder only; programs that come along can be opened.",
)
@settings_options(SCREEN_FLAGS)
@click.option(
    "--serial", is_flag=True, help="Watch the arm that your client moves over a serial line."
)
@click.option(
    "--serial-tcp", type=WholeNumber(0, 65535), help="The same on a TCP port of this computer."
)
@plug_options
@machine_options
def terminal(**given: Any) -> None:
    """Open the terminal, with PROGRAM loaded if one is given.

    With --serial the arm is a TeachMover at the end of a serial line, for which the TRS-80 has no
    ARMBASIC; the status line says what a client is to open.
    """
    if given["serial"] or given["serial_tcp"] is not None:
        _refuse_beside_serial(given)
    _open_terminal(given)


def _refuse_beside_serial(given: dict[str, Any]) -> None:
    for name, why in (
        ("plain", "`trs80arm serial` has the line without a screen"),
        ("replay", "a recording has an arm of its own"),
        ("plug", "the arm on the wire is the TRS-80's"),
    ):
        if given[name]:
            fail(f"--{name} does not go with --serial: {why}")


@click.command()
@click.option("--plain", is_flag=True, help="Line by line, for screen readers and pipes.")
@settings_options(SCREEN_FLAGS)
@machine_options
def tour(**given: Any) -> None:
    """The first five minutes, step by step: drive the arm, pick a part, teach, see a slip.

    Each step waits until you have done it; the tour goes on where you left it.
    """
    _open_terminal(given, tour=True)


@click.command()
@settings_options(SCREEN_FLAGS)
@machine_options
def demo(**given: Any) -> None:
    """Watch the article's pick-and-place task; any key ends the demonstration."""
    _open_terminal(given, demo=True)


def _open_terminal(given: dict[str, Any], **more: Any) -> NoReturn:
    options = terminal_options(given, **more)
    if options.plain:
        from trs80arm.plain import run_plain

        sys.exit(run_plain(options))
    # What is imported from here on stays; `run_terminal` sets it aside.
    gc.disable()
    from trs80arm.ui.start import run_terminal

    sys.exit(run_terminal(options))


def terminal_options(given: dict[str, Any], **more: Any) -> TerminalOptions:
    """What a start of the terminal asks for; takes the flags out of `given`."""
    from trs80arm import settings as settings_module

    config = given.get("config")
    # A person who presses BREAK wants the arm to stop, unless the settings say otherwise.
    served = given.get("serial") or given.get("serial_tcp") is not None
    teachmover = [PLUGGED_ARM] if given.get("plug") or served else []
    settings = take_settings(given, "driver.break_now=true", *teachmover)
    if "plug" in given:
        given["plug"] = take_plug(given, settings)
    options = settings.options(config or settings_module.default_path(), **given, **more)
    if served and options.rig is not None:
        return replace(options, rig=replace(options.rig, controller=True))
    return options


@click.command()
@click.option("--host", default="127.0.0.1", show_default=True, help="The address to listen at.")
@click.option("--port", default=8000, show_default=True, type=WholeNumber(1, 65535))
@click.option(
    "--allow-files", is_flag=True, help="Let visitors open and save files as you can yourself."
)
@click.argument("program", type=A_PROGRAM, required=False)
def serve(host: str, port: int, program: Path | None, allow_files: bool) -> None:
    """Serve the terminal to a browser (extra `web`)."""
    from trs80arm.ui.serve import ServeError, serve_terminal

    try:
        serve_terminal(host, port, program, allow_files=allow_files)
    except ServeError as error:
        fail(error)
