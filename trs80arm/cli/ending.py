"""How the command line leaves: its exit codes, and the one line of what cannot be done."""

from __future__ import annotations

import sys
from contextlib import suppress
from typing import NoReturn

import click

from trs80arm import shown

USAGE_ERROR = 2
BROKEN_PIPE = 128 + 13
"""The exit code when whoever read the output has left: that of a program ended by SIGPIPE."""
INTERRUPTED = 128 + 2


def fail(why: object) -> NoReturn:
    """Say one clear line on standard error and leave with the code for bad usage."""
    tell(shown.message(why))
    sys.exit(USAGE_ERROR)


def tell(line: str) -> None:
    """Say a line on standard error; where nothing can be written the exit code has to do."""
    with suppress(OSError):
        click.echo(f"trs80arm: {line}", err=True)
