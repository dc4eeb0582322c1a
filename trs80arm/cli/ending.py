"""How the command line leaves: its exit codes, and the one line of what cannot be done."""

from __future__ import annotations

import sys
from typing import NoReturn

import click

from trs80arm.shown import shown

USAGE_ERROR = 2
BROKEN_PIPE = 128 + 13
"""The exit code when whoever read the output has left: that of a program ended by SIGPIPE."""
INTERRUPTED = 128 + 2


def fail(message: object) -> NoReturn:
    """Say one clear line on standard error and leave with the code for bad usage."""
    click.echo(f"trs80arm: {shown(message)}", err=True)
    sys.exit(USAGE_ERROR)
