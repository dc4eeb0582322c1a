"""The commands about program files: read without running, converted, listed."""

from __future__ import annotations

import math
import sys
from pathlib import Path

import click

from trs80arm.cli.arguments import A_PATH, A_PROGRAM
from trs80arm.cli.ending import fail


@click.command()
@click.argument("programs", type=A_PROGRAM, nargs=-1, required=True)
@click.option(
    "--format",
    "form",
    type=click.Choice(["text", "json", "sarif"]),
    default="text",
    show_default=True,
    help="Lines `file:line: text`, one JSON object, or SARIF 2.1.0.",
)
@click.option("--strict", is_flag=True, help="Exit code 1 for warnings too.")
@click.option("--no-armbasic", is_flag=True, help="The bare ROM: @ words are errors.")
def check(programs: tuple[Path, ...], form: str, strict: bool, no_armbasic: bool) -> None:
    """Read PROGRAMS without running them, and tell what is wrong in them.

    Errors are what stops the machine when it comes there: syntax, jumps to missing lines, too many
    values for @STEP. Warnings are two names that are one variable, and lines lost to a later one of
    the same number. The exit code is 1 when there are errors, 2 when a file is no program.
    """
    from trs80arm.check.command import run_check

    sys.exit(run_check(programs, form, strict=strict, armbasic=not no_armbasic))


@click.command()
@click.argument("source", type=A_PROGRAM)
@click.argument("target", type=A_PATH)
@click.option("--keep-good", is_flag=True, help="Take what is good of a damaged file.")
def convert(source: Path, target: Path, keep_good: bool) -> None:
    """Convert a program file: text, crunched (.bas) or cassette (.cas), by TARGET's suffix."""
    from trs80arm import files
    from trs80arm.reasons import reason

    try:
        count = files.convert(source, target, keep_good=keep_good)
    except files.FileFormatError as error:
        fail(error)
    except OSError as error:
        fail(f"{error.filename}: {reason(error)}")
    click.echo(f"{target}: {count} line{'' if count == 1 else 's'}")


@click.command()
def programs() -> None:
    """List the programs that come along; each opens by its name."""
    import shutil
    import textwrap

    from trs80arm.bundled import described

    listed = described()
    if not listed:
        fail("no programs were installed with trs80arm")
    width = max(len(name) for name, _ in listed) + 2
    columns = shutil.get_terminal_size().columns if sys.stdout.isatty() else math.inf
    for name, words in listed:
        # A pipe has a line for each.
        line = name.ljust(width) + words
        if len(line) > columns:
            line = textwrap.fill(line, int(columns), subsequent_indent=" " * width)
        click.echo(line)
