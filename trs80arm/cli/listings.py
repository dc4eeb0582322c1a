"""The commands about program files: read without running, converted, listed."""

from __future__ import annotations

import math
import sys
from pathlib import Path

import click

from trs80arm.cli.arguments import A_PATH, A_PROGRAM
from trs80arm.cli.ending import fail, tell
from trs80arm.cli.options import SETTING_FLAGS, settings_options


@click.command()
@click.argument("programs", type=A_PROGRAM, nargs=-1, required=True)
@click.option(
    "--format",
    "form",
    type=click.Choice(["text", "json", "sarif"]),
    default="text",
    show_default=True,
    help="Lines `file:line: level: text`, one JSON object, or SARIF 2.1.0.",
)
@click.option("--strict", is_flag=True, help="Exit code 1 for warnings too.")
@click.option(
    "--ignore",
    "ignored",
    multiple=True,
    metavar="RULE",
    help="Leave out what a rule finds; may be given several times.",
)
@settings_options({"arm": SETTING_FLAGS["arm"]})
@click.option("--no-armbasic", is_flag=True, help="The bare ROM: @ words are errors.")
def check(
    programs: tuple[Path, ...],
    form: str,
    strict: bool,
    ignored: tuple[str, ...],
    arm: str | None,
    no_armbasic: bool,
) -> None:
    """Read PROGRAMS without running them, and tell what is wrong in them.

    Files, folders with programs in them, or - for standard input. Errors are what stops the machine
    when it comes there: syntax, jumps to missing lines, too many values for @STEP, points in DATA
    that the arm does not reach. Warnings are what is hardly meant: two names that are one variable,
    a FOR without NEXT. Notes are worth a look: what nothing leads to, what nothing sets. The exit
    code is 1 when there are errors, 2 when a file is no program. A remark REM CHECK: ALLOW RULE
    keeps a rule silent in its line, or, on a line of its own, in its program.
    """
    from trs80arm.arm.models import model_named
    from trs80arm.check.command import run_check
    from trs80arm.check.findings import RULES

    for name in ignored:
        if name not in RULES:
            raise click.BadParameter(
                f"there is no rule {name!r}; the rules are {', '.join(RULES)}",
                param_hint="--ignore",
            )
    try:
        model = model_named(arm) if arm is not None else None
    except ValueError as error:
        raise click.BadParameter(str(error), param_hint="--arm") from None
    done = run_check(
        programs,
        form,
        strict=strict,
        ignored=[RULES[name] for name in ignored],
        armbasic=not no_armbasic,
        arm=model,
    )
    sys.exit(done)


@click.command()
@click.argument("source", type=A_PROGRAM)
@click.argument("target", type=A_PATH, required=False)
@click.option("--keep-good", is_flag=True, help="Take what is good of a damaged file.")
@click.option("--name", metavar="LETTER", help="The program of a cassette that is meant.")
@click.option("--list", "listed", is_flag=True, help="Tell what is in SOURCE; write nothing.")
def convert(
    source: Path, target: Path | None, keep_good: bool, name: str | None, listed: bool
) -> None:
    """Convert a program or a cassette, or list what is on it.

    By TARGET's suffix: crunched (.bas), cassette as bytes (.cas, .500) or as sound (.wav), or else
    text. SOURCE is told by what is in it. Sound is a recording of a cassette at 500 baud, digitised
    in any way. From a cassette to a cassette goes all that is on it, else its first program.
    """
    from trs80arm import converting, files

    if listed == (target is not None):
        raise click.UsageError(
            "--list writes no TARGET" if listed else "Missing argument 'TARGET'; --list needs none"
        )
    try:
        if target is None:
            for line in converting.listing(source):
                click.echo(line)
            return
        done = converting.convert(source, target, keep_good=keep_good, name=name)
    except files.FileFormatError as error:
        fail(error)
    for remark in done.remarks:
        tell(f"{source}: {remark}")
    click.echo(f"{target}: {done.words}")


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
