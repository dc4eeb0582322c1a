"""The command line itself: one group of every command."""

from __future__ import annotations

import sys

import click

from trs80arm import __version__
from trs80arm.cli.ending import INTERRUPTED, fail
from trs80arm.cli.group import ProgramFirst


@click.group(cls=ProgramFirst, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="trs80arm")
def cli() -> None:
    """Open the terminal, or carry out a command without one."""


def invoke(arguments: list[str]) -> None:
    """Carry out one command line; leaves when it ends early or is not understood."""
    try:
        # Not `cli.main`, which has its own way with a broken pipe.
        with cli.make_context("trs80arm", arguments) as context:
            cli.invoke(context)
    except click.exceptions.Exit as ending:
        sys.exit(ending.exit_code)
    except click.UsageError as error:
        command = error.ctx.command_path if error.ctx else "trs80arm"
        fail(f"{error.format_message().rstrip('.')} ({command} --help tells more)")
    except click.Abort:
        sys.exit(INTERRUPTED)
