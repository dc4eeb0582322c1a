"""The command line itself: one group of every command."""

from __future__ import annotations

import click

from trs80arm import __version__
from trs80arm.cli.group import ProgramFirst
from trs80arm.cli.listings import check, convert, programs
from trs80arm.cli.making import export_, figure, film
from trs80arm.cli.runs import replay, run, sweep
from trs80arm.cli.terminal import demo, serve, terminal, tour

_COMMANDS = (
    *(terminal, tour, demo, serve),
    *(run, replay, sweep),
    *(film, export_, figure),
    *(check, convert, programs),
)


@click.group(
    cls=ProgramFirst,
    commands=_COMMANDS,
    context_settings={"help_option_names": ["-h", "--help"]},
)
@click.version_option(__version__, prog_name="trs80arm")
def cli() -> None:
    """A TRS-80 Level II with ARMBASIC and a MiniMover 5 robot arm.

    `trs80arm [PROGRAM]` opens the terminal; `trs80arm terminal --help` has its options.
    """
