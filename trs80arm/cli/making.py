"""The commands that make files of arm and runs: films, exports, the article's figures."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import click
from click.core import ParameterSource

from trs80arm.cli.arguments import A_PATH, A_PROGRAM, Finite, WholeNumber
from trs80arm.cli.ending import fail
from trs80arm.cli.options import (
    SCREEN_FLAGS,
    SETTING_FLAGS,
    Command,
    answer_options,
    machine_options,
    settings_options,
    take_settings,
)
from trs80arm.cli.terminal import terminal_options

_FILM_FLAGS = ("glyphs", "theme", "arm-style", "cursor")
_OF_RUNS = ("seconds", "looks", "inputs", "sets")
"""What `export` takes of which a file of the arm as it stands has nothing."""
LONGEST_FILM = 600.0
"""Virtual seconds of a film or an export at most."""


def _length_option(words: str) -> Callable[[Command], Command]:
    """How much of a run there is to be."""
    return click.option(
        "--seconds",
        type=Finite(min=0, max=LONGEST_FILM, min_open=True),
        default=60.0,
        show_default=True,
        help=words,
    )


@click.command()
@click.argument("program", type=A_PROGRAM)
@click.option("-o", "--output", type=A_PATH, required=True, help="A .svg, .gif or .cast file.")
@_length_option("End after so many virtual seconds from RUN.")
@click.option(
    "--speed",
    "pace",
    type=Finite(min=0.01, max=100),
    default=1.0,
    show_default=True,
    help="Virtual seconds a second of the film.",
)
@click.option(
    "--fps",
    "pictures",
    type=Finite(min=0.5, max=50),
    default=10.0,
    show_default=True,
    help="Pictures a second of the film.",
)
@click.option("--size", default="100x30", show_default=True, help="Columns x rows.")
@answer_options
@click.option("--do", "commands", multiple=True, help="A command before RUN, as fill_space.")
@click.option("--font", type=A_PATH, help="A monospaced font for a GIF.")
@settings_options({name: SCREEN_FLAGS[name] for name in _FILM_FLAGS})
@machine_options
def film(**given: Any) -> None:
    """Film a run of PROGRAM in the terminal: animated SVG, GIF or asciinema cast.

    RUN is typed, and the film goes on for a moment after the program has ended, or until it waits
    for what the options do not answer. The file's suffix says which kind it is to be.
    """
    size = re.fullmatch(r"(\d{1,3})x(\d{1,3})", given.pop("size"))
    if size is None:
        fail("--size is COLUMNSxROWS, as 100x30")
    _make_film(
        given,
        given.pop("output"),
        columns=int(size[1]),
        rows=int(size[2]),
        fps=given.pop("pictures"),
        speed=given.pop("pace"),
        seconds=given.pop("seconds"),
        inputs=given.pop("inputs"),
        sets=given.pop("sets"),
        do=given.pop("commands"),
        font=given.pop("font"),
    )


def _make_film(given: dict[str, Any], output: Path, **shooting: Any) -> None:
    """Film a run of the terminal, as `Shooting` has it."""
    from trs80arm.ui.filming import FilmError, Shooting, make_film

    try:
        make_film(terminal_options(given), Shooting(**shooting), output)
    except FilmError as error:
        fail(error)


@click.command("export")
@click.argument("program", type=A_PROGRAM, required=False)
@click.option("-o", "--output", type=A_PATH, required=True, help="The file; its suffix says which.")
@_length_option("End a run after so many virtual seconds.")
@click.option(
    "--fps",
    "looks",
    type=Finite(min=0.5, max=1000),
    help="Looks at a run a virtual second; 30 unless given, 10 of a .cast.",
)
@answer_options
@machine_options
def export_(**given: Any) -> None:
    """Write the arm and its bench, or a run of PROGRAM, for other programs.

    MuJoCo's MJCF (.xml, .mjcf) and URDF (.urdf) have the arm that --arm names, as it is switched
    on, with the bench of --bench or of PROGRAM. Of a run there are animated glTF (.gltf, .glb),
    joints over time (.csv, .npz) and an asciinema cast of the terminal (.cast).
    """
    from trs80arm.export.exporting import FILM, STANDING, Export, ExportError, export

    if given["output"].suffix.lower() in STANDING:
        _refuse_what_is_of_runs(click.get_current_context(), given["output"])
    output, looks = given.pop("output"), given.pop("looks")
    answers = {name: given.pop(name) for name in ("seconds", "inputs", "sets")}
    if output.suffix.lower() == FILM:
        if given["program"] is None:
            fail(f"{output}: a {FILM} file is of a run: name a program")
        _make_film(given, output, fps=min(looks or 10.0, 50.0), **answers)
        return
    bench, program = given.pop("bench"), given.pop("program")
    settings = take_settings(given)
    try:
        export(Export(output, program, bench, fps=looks or 30.0, rig=settings.rig(), **answers))
    except ExportError as error:
        fail(error)


def _refuse_what_is_of_runs(context: click.Context, output: Path) -> None:
    """A file of the arm as it stands has no use for what says how long and how a run is."""
    what_it_has = f"a {output.suffix} file has the arm as it stands"
    for option in context.command.params:
        source = context.get_parameter_source(option.name or "")
        if option.name in _OF_RUNS and source is ParameterSource.COMMANDLINE:
            fail(f"{output}: {option.opts[0]} is for a run; {what_it_has}")


@click.command()
@click.argument("name")
@click.option("-o", "--output", type=A_PATH, help="An .svg or .png file instead of text.")
@click.option("--width", type=WholeNumber(40, 400), help="Columns of the text.")
@click.option("--config", type=A_PATH, help="The settings file instead of the usual one.")
@click.option("--option", multiple=True, help="Any setting: TABLE.KEY=VALUE (repeatable).")
@settings_options({"arm": SETTING_FLAGS["arm"]})
def figure(name: str, output: Path | None, width: int | None, **given: Any) -> None:
    """Draw the article's figure NAME from the running model: 1 to 12 or table1.

    Arm, card and keys are those of the settings; so is what the figures say of them.
    """
    import shutil

    from trs80arm.arm.figures import FigureError
    from trs80arm.article import draw

    settings = take_settings({"break_now": None, **given})
    try:
        drawn = draw(name, settings.rig())
        if output is None:
            click.echo(drawn.text(width or shutil.get_terminal_size().columns))
        else:
            drawn.save(output)
    except FigureError as error:
        fail(error)
