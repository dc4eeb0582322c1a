"""The command that puts an arm behind a serial line."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from trs80arm.cli.arguments import WholeNumber
from trs80arm.cli.ending import fail
from trs80arm.cli.options import (
    PLUGGED_ARM,
    SCREEN_FLAGS,
    arm_options,
    settings_options,
    take_settings,
)


@click.command()
@click.option(
    "--tcp",
    type=WholeNumber(0, 65535),
    help="A TCP port of this computer instead of a pseudo-terminal; 0 takes any.",
)
@click.option("--log", is_flag=True, help="Print every line that goes over the wire.")
@settings_options({"speed": SCREEN_FLAGS["speed"]})
@arm_options
def serial(tcp: int | None, log: bool, bench: Path | None, **given: Any) -> None:
    """Put a TeachMover behind a serial line, for programs that drive one.

    The first line that is printed says what such a program is to open: the path of a
    pseudo-terminal, or with --tcp the address of a port. The arm answers as docs/serial.md says and
    takes the time that it takes, unless --speed has it otherwise. ENTER is the stop key of its
    pendant; the name of another key and ENTER presses that. Ctrl+C ends it.
    """
    from trs80arm.rig import RigSettings
    from trs80arm.serial.endpoints import EndpointError
    from trs80arm.serial.serving import Serving, ServingError, serve

    settings = take_settings(given, PLUGGED_ARM)
    rig = RigSettings(card=settings.card, arm=settings.arm, controller=True)
    try:
        serve(Serving(rig, bench, tcp, settings.terminal.speed.factor, log))
    except (EndpointError, ServingError) as error:
        fail(error)
