"""Films a run: the terminal program without a terminal, its clock in the camera's hands.

What `trs80arm film` does: the program is opened as for a person, RUN is typed, a scripted operator
answers, and every so often what stands on the screen is kept.
"""

from __future__ import annotations

import asyncio
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from rich.segment import Segment
from rich.style import Style
from textual.app import App
from textual.strip import Strip

from trs80arm.desk.opening import UNUSABLE, open_session
from trs80arm.desk.session import Session
from trs80arm.film.cast import cast
from trs80arm.film.frames import Film, Line, Look
from trs80arm.film.gif import GifError, find_letters, gif
from trs80arm.film.svg import svg
from trs80arm.operator import Operator, ScriptError, parse_holds
from trs80arm.options import ArmStyle, Speed, TerminalOptions
from trs80arm.reasons import one_line
from trs80arm.saving import expect_to_write, write_whole
from trs80arm.ui import layout, themes
from trs80arm.ui.app import Trs80Arm
from trs80arm.ui.commands.table import COMMANDS
from trs80arm.ui.terminal.picture import on_screen

_KINDS: dict[str, Callable[[Film, Path | None], bytes]] = {
    ".svg": lambda film, _: svg(film),
    ".gif": gif,
    ".cast": lambda film, _: cast(film),
}

STRIDE = 1 / 60
"""Virtual seconds that pass at most between two looks of the program at its clock."""
LINGERS = 1.0
"""Seconds of film after the program has ended."""
BEGINNING = 0.3
"""Virtual seconds before RUN is typed."""


@dataclass(frozen=True)
class Shooting:
    """How a film is to be made.

    Attributes:
        columns, rows: of the terminal.
        fps: pictures a second of the film.
        speed: virtual seconds a second of the film.
        seconds: virtual seconds from RUN after which it ends at the latest.
        inputs, sets: what the operator answers, as for `trs80arm run`.
        do: commands of the program, by name, that are done before RUN.
        font: for a GIF: a file with a monospaced font, None for one of the system's.
    """

    columns: int = 100
    rows: int = 30
    fps: float = 10.0
    speed: float = 1.0
    seconds: float = 60.0
    inputs: tuple[str, ...] = ()
    sets: tuple[str, ...] = ()
    do: tuple[str, ...] = ()
    font: Path | None = None


class Wall:
    """A clock that stands until it is moved."""

    def __init__(self) -> None:
        self.now = 1000.0

    def __call__(self) -> float:
        """What it shows, in seconds."""
        return self.now


class FilmError(Exception):
    """A film cannot be made so: one clear line."""


def make_film(options: TerminalOptions, shooting: Shooting, path: Path) -> None:
    """Film a program's run and write the film.

    Args:
        options: how the terminal program is to start, the program among them.
        shooting: how the film is to be made.
        path: the file, whose suffix says the kind: `.svg`, `.gif` or `.cast`.

    Raises:
        FilmError: something that was asked for cannot be.
        OSError: a file cannot be read or written.
    """
    if path.suffix.lower() not in _KINDS:
        raise FilmError(f"{path}: a film is a {', '.join(_KINDS)} file")
    names = {command.name for command in COMMANDS}
    for name in shooting.do:
        if name not in names:
            raise FilmError(f"--do {name}: there is no such command")
    if shooting.columns < layout.SMALLEST[0] or shooting.rows < layout.SMALLEST[1]:
        raise FilmError(
            "--size: the terminal needs {} columns and {} rows".format(*layout.SMALLEST)
        )
    if shooting.font is not None and path.suffix.lower() != ".gif":
        raise FilmError("--font is for a GIF")
    expect_to_write(path)
    try:
        if path.suffix.lower() == ".gif":
            find_letters(shooting.font)  # Before the run, which may take its time.
        sets = [parse_holds(holds) for holds in shooting.sets]
        # A film is made of characters.
        arm = ArmStyle.HALF if options.arm is ArmStyle.PIXELS else options.arm
        chosen = replace(options, speed=Speed.ONE, arm=arm, settings_file=None)
        session = open_session(chosen)
    except (*UNUSABLE, ScriptError, GifError) as error:
        raise FilmError(one_line(error)) from None
    operator = Operator(session.rig, shooting.inputs, sets)
    try:
        made = asyncio.run(_shoot(session, chosen, shooting, operator))
    finally:
        session.close()
    write_whole(path, _KINDS[path.suffix.lower()](made, shooting.font))


async def _shoot(
    session: Session, options: TerminalOptions, shooting: Shooting, operator: Operator
) -> Film:
    wall = Wall()
    name = options.program.name if options.program else "trs80arm"
    made = Film(shooting.columns, shooting.rows, f"{name} on a TRS-80 with a MiniMover 5")
    with tempfile.TemporaryDirectory() as state:
        app = Trs80Arm(session, options, Path(state), wall=wall, ticking=False)
        if why := themes.refusal(options.theme, app.available_themes):
            raise FilmError(why)
        app.animation_level = "none"
        async with app.run_test(size=(shooting.columns, shooting.rows)) as pilot:
            for command in shooting.do:
                await app.run_action(f"do('{command}')")
            rig = session.rig
            _let_pass(app, wall, BEGINNING)
            rig.type("RUN\r")
            start, frame, ended = rig.time, 0, None
            while True:
                await pilot.pause()
                app.draw()
                await pilot.pause()
                time = frame / shooting.fps
                made.add(time, picture(app))
                if rig.outcome is not None or not operator.attend():
                    ended = time if ended is None else ended
                if ended is not None and time >= ended + LINGERS:
                    return made
                if rig.time - start >= shooting.seconds:
                    return made
                frame += 1
                target = start + frame * shooting.speed / shooting.fps
                while rig.time < target - STRIDE / 100:
                    operator.attend()
                    _let_pass(app, wall, min(STRIDE, target - rig.time))


def _let_pass(app: Trs80Arm, wall: Wall, seconds: float) -> None:
    wall.now += seconds
    app.tick()


def picture(app: App[Any]) -> tuple[Line, ...]:
    """What stands on the screen, as a picture of a film."""
    own = ("#c0c0c0", "#000000") if app.current_theme.dark else ("#000000", "#ffffff")
    return tuple(_line(strip, own) for strip in on_screen(app))


def _line(strip: Strip, own: tuple[str, str]) -> Line:
    return tuple((segment.text, _look(segment, own)) for segment in strip if segment.text)


def _look(segment: Segment, own: tuple[str, str]) -> Look:
    """How a segment looks in a terminal whose own ink and ground are these."""
    style = segment.style or Style.null()
    pairs = list(zip((style.color, style.bgcolor), own, strict=True))
    ink, ground = (
        default if colour is None or colour.is_default else colour.get_truecolor().hex
        for colour, default in (reversed(pairs) if style.reverse else pairs)
    )
    return Look(ink, ground, bool(style.bold))
