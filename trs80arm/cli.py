"""The command line: `trs80arm [PROGRAM]` opens the terminal, its subcommands work without one.

Everything heavy is imported inside the commands, so that `trs80arm --help` answers at once. Exit
codes: 0 ended or limit reached as asked, 1 the program stopped on a BASIC error, 2 bad usage or an
unreadable file, with one line on standard error.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

import click

from trs80arm import __version__

if TYPE_CHECKING:
    from trs80arm.arm.bench import Bench

PROGRAM_ERROR = 1
USAGE_ERROR = 2


class ProgramFirst(click.Group):
    """A group of commands of which `terminal` may be left out: `trs80arm table4.bas`."""

    default = "terminal"

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Put the default command in front of arguments that do not begin with a command."""
        words = [word for word in args if word in self.commands]
        if args[:1] not in (["--help"], ["--version"], ["-h"]) and not (
            words and args[0] == words[0]
        ):
            args = [self.default, *args]
        return super().parse_args(ctx, args)


def fail(message: str) -> NoReturn:
    """Say one clear line on standard error and leave with the code for bad usage."""
    click.echo(f"trs80arm: {message}", err=True)
    sys.exit(USAGE_ERROR)


@click.group(cls=ProgramFirst, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="trs80arm")
def cli() -> None:
    """A TRS-80 Level II with ARMBASIC and a MiniMover 5 robot arm.

    `trs80arm [PROGRAM]` opens the terminal; `trs80arm terminal --help` has its options.
    """


def read_program(path: Path) -> bytes:
    """The content of a program file; a file that cannot be read ends the command."""
    try:
        return path.read_bytes()
    except OSError as error:
        fail(f"{path}: {error.strerror or error}")


def find_bench(bench: Path | None, program: Path | None) -> Bench | None:
    """The bench asked for, or the one named like the program and standing beside it."""
    from trs80arm.arm.bench import Bench, BenchError

    if bench is None and program is not None and program.with_suffix(".toml").is_file():
        bench = program.with_suffix(".toml")
    if bench is None:
        return None
    try:
        return Bench.load(bench)
    except OSError as error:
        fail(f"{bench}: {error.strerror or error}")
    except BenchError as error:
        fail(str(error))


@cli.command()
@click.argument("program", type=click.Path(path_type=Path))
@click.option("--bench", type=click.Path(path_type=Path), help="The bench file (TOML).")
@click.option(
    "--seconds",
    type=click.FloatRange(min=0),
    default=3600.0,
    show_default=True,
    help="Stop after so many virtual seconds from RUN.",
)
@click.option("--input", "inputs", multiple=True, help="The answer to the next INPUT.")
@click.option("--set", "sets", multiple=True, help='The next @SET, as in "6:1.0 1+W:0.5 0".')
@click.option("--screen", is_flag=True, help="Print the final 16 lines of the tube.")
@click.option("--registers", is_flag=True, help="Print J1 to J6 at the end.")
@click.option("--pose", is_flag=True, help="Print x y z pitch roll opening at the end.")
@click.option("--ram", type=click.Choice(["4", "16", "32", "48"]), default="16", help="K of RAM.")
@click.option("--no-armbasic", is_flag=True, help="The bare ROM: @ words are ?SN.")
@click.option("--break-now", is_flag=True, help="BREAK stops a motion at once.")
@click.option("--tapes", type=click.Path(path_type=Path), help="The folder of the cassettes.")
@click.option("--printer", type=click.Path(path_type=Path), help="The file for the printer's paper.")
@click.option("--trace", type=click.Path(path_type=Path), help="Latch writes: .csv, .npz or .vcd.")
@click.option("--trace-pose", type=click.Path(path_type=Path), help="Pose at each step: .csv, .npz.")
def run(**options: Any) -> None:
    """Run PROGRAM without a screen, as fast as the computer can.

    What the program prints goes to standard output. It runs until it ends, until the limit of
    virtual seconds, or until it waits for input or an @SET that the options do not have.
    """
    from trs80arm.batch import BatchOptions, run_program

    sys.exit(run_program(BatchOptions(**options)))


def main() -> None:
    """Run the command line."""
    cli(prog_name="trs80arm")
