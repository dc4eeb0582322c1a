"""The commands that run programs without a screen."""

from __future__ import annotations

import gc
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from trs80arm.cli.arguments import A_PATH, A_PROGRAM, Finite, WholeNumber
from trs80arm.cli.ending import fail
from trs80arm.cli.options import (
    PLUGGED_ARM,
    SETTING_FLAGS,
    Command,
    answer_options,
    machine_options,
    plug_options,
    take_plug,
    take_settings,
)

if TYPE_CHECKING:
    from trs80arm.rig import RigSettings

LONGEST_RUN = 1e9
"""Virtual seconds of an unattended run, 31 years."""


def telling_options(command: Command) -> Command:
    """What is told of a run."""
    for option in (
        click.option(
            "--trace-rate",
            type=Finite(min=0, max=100_000, min_open=True),
            help="Poses a virtual second; one after each step unless given.",
        ),
        click.option(
            "--trace-pose", type=A_PATH, help="Angles, pose, grip and loads to .csv or .npz."
        ),
        click.option("--trace", type=A_PATH, help="Latch writes to a .csv, .npz or .vcd file."),
        click.option(
            "--json", "as_json", is_flag=True, help="Print the whole run as one JSON object."
        ),
        click.option("--pose", is_flag=True, help="Print x y z pitch roll opening at the end."),
        click.option("--registers", is_flag=True, help="Print J1 to J6 at the end."),
        click.option("--screen", is_flag=True, help="Print the final 16 lines of the tube."),
    ):
        command = option(command)
    return command


@click.command()
@click.argument("programs", type=A_PROGRAM, nargs=-1, required=True)
@click.option(
    "--seconds",
    type=Finite(min=0, max=LONGEST_RUN),
    help="Stop after so many virtual seconds from RUN; 3600 unless given.",
)
@answer_options
@click.option(
    "--script", type=A_PATH, help="What the operator does and what is expected: a TOML file."
)
@telling_options
@click.option("--jobs", type=WholeNumber(1, 1024), help="How many programs run at once.")
@click.option("--junit", type=A_PATH, help="Write JUnit XML to a file, and print a table.")
@plug_options
@machine_options
def run(programs: tuple[Path, ...], jobs: int | None, junit: Path | None, **given: Any) -> None:
    """Run PROGRAMS without a screen, as fast as the computer can.

    What one program prints goes to standard output; of several, run at once, a table does. A
    program runs until it ends, until the limit of virtual seconds, or until it waits for input or
    an @SET that neither the options nor its script have. A script NAME.run.toml beside a program is
    taken as a bench NAME.toml is.
    """
    # What is imported stays: to search it for garbage, again and again, takes a tenth of the start.
    gc.disable()
    from time import perf_counter

    from trs80arm.batch import BatchOptions, run_program

    gc.freeze()
    gc.enable()
    settings = take_settings(given, *([PLUGGED_ARM] if given["plug"] else []))
    given["plug"] = take_plug(given, settings)
    if given["plug"] is not None and (len(programs) > 1 or junit is not None):
        fail("--plug is for one program, without --junit: there is one arm on the wire")
    options = BatchOptions(programs[0], rig=settings.rig(), **given)
    if options.rig.rom is not None:
        click.echo(options.rig.rom.told, err=True)
    if len(programs) == 1 and junit is None:
        sys.exit(run_program(options, stopwatch=perf_counter))
    from trs80arm.several import run_programs

    sys.exit(run_programs(programs, options, perf_counter, jobs=jobs, junit=junit))


@click.command()
@click.argument("recording", type=A_PATH)
@click.option("--script", type=A_PATH, help="What is expected: a TOML file with [expect].")
@telling_options
def replay(recording: Path, **given: Any) -> None:
    """Play a recorded session again without a screen, as fast as the computer can.

    RECORDING is what `trs80arm --record FILE` or the terminal has saved; it brings its machine and
    bench along. What was typed and printed goes to standard output. A script NAME.run.toml beside
    the recording says what it is to come to.
    """
    from time import perf_counter

    from trs80arm.batch import BatchOptions
    from trs80arm.replay import replay_session

    sys.exit(replay_session(BatchOptions(recording, **given), stopwatch=perf_counter))


@click.command()
@click.argument("program", type=A_PROGRAM)
@click.option(
    "--vary",
    multiple=True,
    required=True,
    metavar="NAME=VALUES",
    help="What is varied: D=10:200:10 or weight=1,4,8 (repeatable).",
)
@click.option(
    "--noise",
    type=Finite(min=0, max=12),
    default=0.0,
    help="Parts are placed with an error of so many inches, along x and along y.",
)
@click.option("--runs", type=WholeNumber(1, 100_000), default=1, help="Runs of each cell.")
@click.option("--seed", type=int, default=1, help="What the errors are drawn from.")
@click.option(
    "--seconds",
    type=Finite(min=0, max=LONGEST_RUN, min_open=True),
    default=600.0,
    show_default=True,
    help="Look at a run after so many virtual seconds, if it has not ended.",
)
@answer_options
@click.option("--no-slip", is_flag=True, help="A run in which a motor slips has failed.")
@click.option("--expect", default="", metavar="TEXT", help="What a run has to print.")
@click.option("-o", "--output", type=A_PATH, help="All runs as CSV.")
@click.option("--plot", type=A_PATH, help="Success as a .svg, .png or .pdf (extra `plot`).")
@click.option("--jobs", type=WholeNumber(1, 256), help="Processes; one a core unless given.")
@machine_options
def sweep(**given: Any) -> None:
    """Run PROGRAM over a grid of values and tell how often it succeeds.

    NAME is a BASIC variable that the program gives a plain number (D; D@420 in line 420), the N-th
    number of a line (470#2), weight, friction, dx, dy or dturn of the parts ("block.weight" of
    one), noise, or a setting (arm.pad_friction). A run succeeds when the goals of its bench are
    met; on a bench without goals, when no motor slipped.
    """
    from trs80arm.sweep.axes import SweepError
    from trs80arm.sweep.command import SweepOptions, run_sweep
    from trs80arm.sweep.constants import number_text

    flags = [flag.replace("-", "_") for flag in SETTING_FLAGS]
    shared = ("config", "option", "break_now", "no_armbasic", *flags)
    machine = {name: given.pop(name) for name in shared}

    def settings_of(varied: Mapping[str, float]) -> RigSettings:
        chosen = dict(machine)
        chosen["option"] = [
            *chosen["option"],
            *(f"{name}={number_text(value)}" for name, value in varied.items()),
        ]
        return take_settings(chosen).rig()

    try:
        run_sweep(SweepOptions(**given), settings_of)
    except SweepError as error:
        fail(error)
