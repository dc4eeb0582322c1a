"""The command line: `trs80arm [PROGRAM]` opens the terminal, its subcommands work without one.

Everything heavy is imported inside the commands, so that `trs80arm --help` answers at once. Exit
codes: 0 ended or limit reached as asked, 1 the program stopped on a BASIC error, 2 bad usage or an
unreadable file, with one line on standard error.
"""

from __future__ import annotations

import difflib
import gc
import io
import math
import os
import re
import sys
from collections.abc import Callable, Mapping
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn, TypeVar

import click

from trs80arm import __version__
from trs80arm.shown import shown

if TYPE_CHECKING:
    from trs80arm.options import TerminalOptions
    from trs80arm.rig import RigSettings
    from trs80arm.settings import Settings

USAGE_ERROR = 2
LONGEST_RUN = 1e9
"""Virtual seconds of an unattended run, 31 years."""
BROKEN_PIPE = 128 + 13
"""The exit code when whoever read the output has left: that of a program ended by SIGPIPE."""
INTERRUPTED = 128 + 2
A_PATH = click.Path(path_type=Path)
CLOSE = 0.6
"""How much of a word must be that of a command for it to be proposed."""
Command = TypeVar("Command", bound=Callable[..., Any])


class Finite(click.FloatRange):
    """A number in a range; neither infinite nor none at all."""

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> float:
        """The number that a text says."""
        number = float(super().convert(value, param, ctx))
        if not math.isfinite(number):
            self.fail(f"{value} is not a finite number", param, ctx)
        return number


class Named(click.Path):
    """A program or a bench: a file, or the name of one that comes along."""

    def __init__(self, suffix: str) -> None:
        super().__init__(path_type=Path)
        self._suffix = suffix

    def convert(
        self,
        value: str | os.PathLike[str],
        param: click.Parameter | None,
        ctx: click.Context | None,
    ) -> str | bytes | os.PathLike[str]:
        """The file that is meant."""
        from trs80arm.bundled import named

        return named(Path(value), self._suffix)


A_PROGRAM = Named(".bas")
A_BENCH = Named(".toml")


class ProgramFirst(click.Group):
    """A group of commands of which `terminal` may be left out: `trs80arm table4.bas`."""

    default = "terminal"

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Put the default command in front of arguments that do not begin with a command."""
        if args[:2] == ["--plain", "tour"]:
            args = ["tour", "--plain", *args[2:]]
        if args[:1] not in (["--help"], ["-h"], ["--version"]) and (
            not args or args[0] not in self.commands
        ):
            self._refuse_odd_words(ctx, args)
            args = [self.default, *args]
        return super().parse_args(ctx, args)

    def _refuse_odd_words(self, ctx: click.Context, args: list[str]) -> None:
        """A word that is neither a command nor a program is told as that, whatever follows it."""
        from trs80arm.bundled import PROGRAM_SUFFIX, named
        from trs80arm.paths import is_file

        if not args or args[0].startswith("-"):
            return
        word = args[0]
        plain = word.replace("-", "").isalnum()
        if plain and not Path(word).exists() and not is_file(named(Path(word), PROGRAM_SUFFIX)):
            close = difflib.get_close_matches(word, self.commands, 1, CLOSE)
            hint = f"; is {close[0]} meant?" if close else "; `trs80arm programs` lists some"
            raise click.UsageError(f"there is no command and no program {word!r}{hint}", ctx)


def fail(message: object) -> NoReturn:
    """Say one clear line on standard error and leave with the code for bad usage."""
    click.echo(f"trs80arm: {shown(message)}", err=True)
    sys.exit(USAGE_ERROR)


@click.group(cls=ProgramFirst, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="trs80arm")
def cli() -> None:
    """A TRS-80 Level II with ARMBASIC and a MiniMover 5 robot arm.

    `trs80arm [PROGRAM]` opens the terminal; `trs80arm terminal --help` has its options.
    """


# -- options that several commands share -----------------------------------------------------------

_SETTING_FLAGS = {
    "ram": ("machine.ram", "K of RAM: 4, 16, 32 or 48."),
    "memory-size": ("machine.memory_size", "What is typed at MEMORY SIZE?"),
    "tapes": ("machine.tapes", "The folder of the cassettes."),
    "printer": ("machine.printer", "The file for the printer's paper."),
    "arm": ("arm.model", "The arm on the cable: {arms}."),
}
_SCREEN_FLAGS = {
    "speed": (
        "terminal.speed",
        "Virtual seconds a second: 0.05 to 20, or max.",
    ),
    "keys": ("terminal.keys", "auto, events, repeat or latch."),
    "glyphs": ("terminal.glyphs", "auto, sextant, braille, quadrant or ascii."),
    "theme": ("terminal.theme", "green, white, amber, contrast or paper."),
    "arm-style": (
        "terminal.arm",
        "The arm: ascii, half, sextant, braille or outline.",
    ),
    "cursor": ("terminal.cursor", "blink or steady."),
    "fps": ("terminal.fps", "The most frames a second."),
}
_FILM_FLAGS = ("glyphs", "theme", "arm-style", "cursor")
LONGEST_FILM = 600.0
"""Virtual seconds of a film at most."""


class Told(click.Option):
    """An option whose help has words that are looked up only when somebody wants to read it."""

    def get_help_record(self, ctx: click.Context) -> tuple[str, str] | None:
        """What `--help` says of it."""
        record = super().get_help_record(ctx)
        if record is None or "{arms}" not in record[1]:
            return record
        # Their modules are listed, not loaded: help answers without numpy.
        modules = (file.name for file in (resources.files("trs80arm") / "arm" / "models").iterdir())
        arms = sorted(name[:-3] for name in modules if name.endswith(".py") and name[0] != "_")
        flag, text = record
        return flag, text.format(arms=" or ".join(arms))


def _settings_options(flags: dict[str, tuple[str, str]]) -> Callable[[Command], Command]:
    """The flags that are settings; each stands for `--option TABLE.KEY=VALUE`."""

    def decorate(command: Command) -> Command:
        for name, (_, text) in reversed(flags.items()):
            command = click.option(f"--{name}", metavar="VALUE", help=text, cls=Told)(command)
        return command

    return decorate


def _machine_options(command: Command) -> Command:
    """The options of every command that builds a rig."""
    for option in (
        click.option("--config", type=A_PATH, help="The settings file instead of the usual one."),
        click.option("--option", multiple=True, help="Any setting: TABLE.KEY=VALUE (repeatable)."),
        click.option(
            "--break-now/--break-at-end",
            default=None,
            help="BREAK stops a motion at once, or is seen when it has ended.",
        ),
        click.option("--no-armbasic", is_flag=True, help="The bare ROM: @ words are ?SN."),
        _settings_options(_SETTING_FLAGS),
        click.option(
            "--bench", type=A_BENCH, help="The bench: a TOML file or one that came along."
        ),
    ):
        command = option(command)
    return command


def _take_settings(given: dict[str, Any], *defaults: str) -> Settings:
    """Read settings file, environment and flags; takes the flags out of `given`."""
    from trs80arm import settings

    flags = {}
    for name, (setting, _) in (_SETTING_FLAGS | _SCREEN_FLAGS).items():
        value = given.pop(name.replace("-", "_"), None)
        if value is not None:
            flags[f"{setting}={value}"] = f"--{name} {value}"
    if given.pop("no_armbasic", False):
        flags["machine.armbasic=false"] = "--no-armbasic"
    break_now = given.pop("break_now")
    if break_now is not None:
        flags[f"driver.break_now={str(break_now).lower()}"] = "--break-now"
    every = [*flags, *given.pop("option")]
    try:
        return settings.load(given.pop("config"), every, defaults=defaults)
    except settings.SettingsError as error:
        message = str(error)
        for option, flag in flags.items():
            # The user knows it by the flag that was typed.
            message = message.replace(f"--option {option}", flag)
        fail(message)


# -- the terminal ----------------------------------------------------------------------------------


@cli.command()
@click.argument("program", type=A_PROGRAM, required=False)
@click.option("--run", is_flag=True, help="Type RUN at once.")
@click.option("--record", type=A_PATH, help="Write everything that the operator does to a file.")
@click.option("--replay", type=A_PATH, help="Play a recorded session.")
@click.option("--plain", is_flag=True, help="Line by line, for screen readers and pipes.")
@click.option(
    "--own-folder",
    type=click.Path(path_type=Path, exists=True, file_okay=False),
    help="Open and save in this folder only; programs that come along can be opened.",
)
@_settings_options(_SCREEN_FLAGS)
@_machine_options
def terminal(**given: Any) -> None:
    """Open the terminal, with PROGRAM loaded if one is given."""
    _open_terminal(given)


@cli.command()
@click.option("--plain", is_flag=True, help="Line by line, for screen readers and pipes.")
@_settings_options(_SCREEN_FLAGS)
@_machine_options
def tour(**given: Any) -> None:
    """The first five minutes, step by step: drive the arm, pick a part, teach, see a slip.

    Each step waits until you have done it; the tour goes on where you left it.
    """
    _open_terminal(given, tour=True)


@cli.command()
@_settings_options(_SCREEN_FLAGS)
@_machine_options
def demo(**given: Any) -> None:
    """Watch the article's pick-and-place task; any key ends the demonstration."""
    _open_terminal(given, demo=True)


def _open_terminal(given: dict[str, Any], **more: Any) -> NoReturn:
    options = _terminal_options(given, **more)
    if options.plain:
        from trs80arm.plain import run_plain

        sys.exit(run_plain(options))
    # What is imported from here on stays; `run_terminal` sets it aside.
    gc.disable()
    from trs80arm.ui.start import run_terminal

    sys.exit(run_terminal(options))


def _terminal_options(given: dict[str, Any], **more: Any) -> TerminalOptions:
    from trs80arm import settings as settings_module

    config = given.get("config")
    # A person who presses BREAK wants the arm to stop, unless the settings say otherwise.
    settings = _take_settings(given, "driver.break_now=true")
    return settings.options(config or settings_module.default_path(), **given, **more)


@cli.command()
@click.option("--host", default="127.0.0.1", show_default=True, help="The address to listen at.")
@click.option("--port", default=8000, show_default=True, type=click.IntRange(1, 65535))
@click.option(
    "--allow-files", is_flag=True, help="Let visitors open and save files as you can yourself."
)
@click.argument("program", type=A_PROGRAM, required=False)
def serve(host: str, port: int, program: Path | None, allow_files: bool) -> None:
    """Serve the terminal to a browser (extra `web`)."""
    from trs80arm.ui.serve import ServeError, serve_terminal

    try:
        serve_terminal(host, port, program, allow_files=allow_files)
    except ServeError as error:
        fail(error)


# -- without a screen ------------------------------------------------------------------------------


@cli.command()
@click.argument("programs", type=A_PROGRAM, nargs=-1, required=True)
@click.option(
    "--seconds",
    type=Finite(min=0, max=LONGEST_RUN),
    help="Stop after so many virtual seconds from RUN; 3600 unless given.",
)
@click.option("--input", "inputs", multiple=True, help="The answer to the next INPUT.")
@click.option("--set", "sets", multiple=True, help='The next @SET, as in "6:1.0 1+W:0.5 0".')
@click.option(
    "--script", type=A_PATH, help="What the operator does and what is expected: a TOML file."
)
@click.option("--screen", is_flag=True, help="Print the final 16 lines of the tube.")
@click.option("--registers", is_flag=True, help="Print J1 to J6 at the end.")
@click.option("--pose", is_flag=True, help="Print x y z pitch roll opening at the end.")
@click.option("--json", "as_json", is_flag=True, help="Print the whole run as one JSON object.")
@click.option("--trace", type=A_PATH, help="Latch writes to a .csv, .npz or .vcd file.")
@click.option("--trace-pose", type=A_PATH, help="Angles, pose, grip and loads to .csv or .npz.")
@click.option(
    "--trace-rate",
    type=Finite(min=0, max=100_000, min_open=True),
    help="Poses a virtual second; one after each step unless given.",
)
@click.option("--jobs", type=click.IntRange(1, 1024), help="How many programs run at once.")
@click.option("--junit", type=A_PATH, help="Write JUnit XML to a file, and print a table.")
@_machine_options
def run(programs: tuple[Path, ...], jobs: int | None, junit: Path | None, **given: Any) -> None:
    """Run PROGRAMS without a screen, as fast as the computer can.

    What one program prints goes to standard output; of several, run at once, a table does. A
    program runs until it ends, until the limit of virtual seconds, or until it waits for input or
    an @SET that neither the options nor its script have. A script NAME.run.toml beside a program is
    taken as a bench NAME.toml is.
    """
    from time import perf_counter

    from trs80arm.batch import BatchOptions, run_program

    settings = _take_settings(given)
    options = BatchOptions(programs[0], rig=settings.rig(), **given)
    if len(programs) == 1 and junit is None:
        sys.exit(run_program(options, stopwatch=perf_counter))
    from trs80arm.several import run_programs

    sys.exit(run_programs(programs, options, perf_counter, jobs=jobs, junit=junit))


@cli.command()
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
@click.option("--runs", type=click.IntRange(1, 100_000), default=1, help="Runs of each cell.")
@click.option("--seed", type=int, default=1, help="What the errors are drawn from.")
@click.option(
    "--seconds",
    type=Finite(min=0, max=LONGEST_RUN, min_open=True),
    default=600.0,
    show_default=True,
    help="Look at a run after so many virtual seconds, if it has not ended.",
)
@click.option("--input", "inputs", multiple=True, help="The answer to the next INPUT.")
@click.option("--set", "sets", multiple=True, help='The next @SET, as in "6:1.0 1+W:0.5 0".')
@click.option("--no-slip", is_flag=True, help="A run in which a motor slips has failed.")
@click.option("--expect", default="", metavar="TEXT", help="What a run has to print.")
@click.option("-o", "--output", type=A_PATH, help="All runs as CSV.")
@click.option("--plot", type=A_PATH, help="Success as a .svg, .png or .pdf (extra `plot`).")
@click.option("--jobs", type=click.IntRange(1, 256), help="Processes; one a core unless given.")
@_machine_options
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

    flags = [flag.replace("-", "_") for flag in _SETTING_FLAGS]
    shared = ("config", "option", "break_now", "no_armbasic", *flags)
    machine = {name: given.pop(name) for name in shared}

    def settings_of(varied: Mapping[str, float]) -> RigSettings:
        chosen = dict(machine)
        chosen["option"] = [
            *chosen["option"],
            *(f"{name}={number_text(value)}" for name, value in varied.items()),
        ]
        return _take_settings(chosen).rig()

    try:
        run_sweep(SweepOptions(**given), settings_of)
    except SweepError as error:
        fail(error)


@cli.command()
@click.argument("program", type=A_PROGRAM)
@click.option("-o", "--output", type=A_PATH, required=True, help="A .svg, .gif or .cast file.")
@click.option(
    "--seconds",
    type=Finite(min=0, max=LONGEST_FILM, min_open=True),
    default=60.0,
    show_default=True,
    help="End after so many virtual seconds from RUN.",
)
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
@click.option("--input", "inputs", multiple=True, help="The answer to the next INPUT.")
@click.option("--set", "sets", multiple=True, help='The next @SET, as in "6:1.0 1+W:0.5 0".')
@click.option("--do", "commands", multiple=True, help="A command before RUN, as fill_space.")
@click.option("--font", type=A_PATH, help="A monospaced font for a GIF.")
@_settings_options({name: _SCREEN_FLAGS[name] for name in _FILM_FLAGS})
@_machine_options
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
        make_film(_terminal_options(given), Shooting(**shooting), output)
    except FilmError as error:
        fail(error)


@cli.command("export")
@click.argument("program", type=A_PROGRAM, required=False)
@click.option("-o", "--output", type=A_PATH, required=True, help="The file; its suffix says which.")
@click.option(
    "--seconds",
    type=Finite(min=0, max=LONGEST_FILM, min_open=True),
    default=60.0,
    show_default=True,
    help="End a run after so many virtual seconds.",
)
@click.option(
    "--fps",
    "looks",
    type=Finite(min=0.5, max=1000),
    help="Looks at a run a virtual second; 30 unless given, 10 of a .cast.",
)
@click.option("--input", "inputs", multiple=True, help="The answer to the next INPUT.")
@click.option("--set", "sets", multiple=True, help='The next @SET, as in "6:1.0 1+W:0.5 0".')
@_machine_options
def export_(**given: Any) -> None:
    """Write the arm and its bench, or a run of PROGRAM, for other programs.

    MuJoCo's MJCF (.xml, .mjcf) and URDF (.urdf) have the arm that --arm names, as it is switched
    on, with the bench of --bench or of PROGRAM. Of a run there are animated glTF (.gltf, .glb),
    joints over time (.csv, .npz) and an asciinema cast of the terminal (.cast).
    """
    from trs80arm.export.exporting import FILM, Export, ExportError, export

    output, looks = given.pop("output"), given.pop("looks")
    answers = {name: given.pop(name) for name in ("seconds", "inputs", "sets")}
    if output.suffix.lower() == FILM:
        if given["program"] is None:
            fail(f"{output}: a {FILM} file is of a run: name a program")
        _make_film(given, output, fps=min(looks or 10.0, 50.0), **answers)
        return
    bench, program = given.pop("bench"), given.pop("program")
    settings = _take_settings(given)
    try:
        export(Export(output, program, bench, fps=looks or 30.0, rig=settings.rig(), **answers))
    except ExportError as error:
        fail(error)


@cli.command()
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


@cli.command()
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


@cli.command()
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


@cli.command()
@click.argument("name")
@click.option("-o", "--output", type=A_PATH, help="An .svg or .png file instead of text.")
@click.option("--width", type=click.IntRange(40, 400), help="Columns of the text.")
@click.option("--config", type=A_PATH, help="The settings file instead of the usual one.")
@click.option("--option", multiple=True, help="Any setting: TABLE.KEY=VALUE (repeatable).")
@click.option("--arm", metavar="VALUE", help=_SETTING_FLAGS["arm"][1])
def figure(name: str, output: Path | None, width: int | None, **given: Any) -> None:
    """Draw the article's figure NAME from the running model: 1 to 12 or table1.

    Arm, card and keys are those of the settings; so is what the figures say of them.
    """
    import shutil

    from trs80arm.arm.figures import FigureError
    from trs80arm.article import draw
    from trs80arm.reasons import reason

    settings = _take_settings({"break_now": None, **given})
    try:
        drawn = draw(name, settings.rig())
        if output is None:
            click.echo(drawn.text(width or shutil.get_terminal_size().columns))
        else:
            drawn.save(output)
    except FigureError as error:
        fail(error)
    except OSError as error:
        fail(f"{output}: {reason(error)}")


def main() -> None:
    """Run the command line; bad usage is told in one line."""
    _open_streams()
    try:
        # Not `cli.main`, which has its own way with a broken pipe.
        with cli.make_context("trs80arm", sys.argv[1:]) as context:
            cli.invoke(context)
        sys.stdout.flush()
    except click.exceptions.Exit as ending:
        sys.exit(ending.exit_code)
    except click.UsageError as error:
        command = error.ctx.command_path if error.ctx else "trs80arm"
        fail(f"{error.format_message().rstrip('.')} ({command} --help tells more)")
    except (click.Abort, KeyboardInterrupt):
        sys.exit(INTERRUPTED)
    except BrokenPipeError:
        _give_up_output()
        sys.exit(BROKEN_PIPE)
    except OSError as error:
        from trs80arm.reasons import reason

        _give_up_output()
        fail(f"{error.filename or 'standard output'}: {reason(error)}")
    except Exception as error:
        from trs80arm.desk.last_resort import FAULT, last_words
        from trs80arm.desk.places import state_folder

        click.echo(f"trs80arm: {last_words(error, state_folder())}", err=True)
        sys.exit(FAULT)


def _open_streams() -> None:
    """Give every standard stream something to write to and a way with every character."""
    if sys.stdin is None:
        sys.stdin = open(os.devnull, encoding="utf-8")  # noqa: SIM115
    if sys.stdout is None:
        sys.stdout = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115
    if sys.stderr is None:
        sys.stderr = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115
    for stream in (sys.stdin, sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")


def _give_up_output() -> None:
    """What is still to be printed goes nowhere, or it would be told once more at the very end."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
