"""The door of the terminal: keys, commands, clicks and sizes, one after the other, at any size."""

from __future__ import annotations

import contextlib
import os
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory
from typing import Any
from unittest.mock import patch

from textual.css.query import NoMatches
from textual.errors import NoWidget
from textual.pilot import OutOfBounds

from tests.fuzz import noise
from tests.fuzz.checks import hold
from tests.fuzz.target import Case, Target
from tests.own_places import PROGRAMS
from tests.ui.piloted import piloted
from tests.ui.sitting import Sitting, opener_in
from trs80arm.ui.commands.table import COMMANDS

SIZES = [(80, 24), (120, 40), (100, 30), (200, 60), (40, 12), (39, 11), (60, 10), (20, 5), (3, 2)]
"""Columns and rows: what people have, the least there is room in, and less."""
LEAVES = ("leave",)
"""Commands that end the program; there is little to see behind them."""
KEYS = ["escape", "escape", "enter", "tab", "shift+tab", "space", "backspace", "delete"]
KEYS += ["up", "down", "left", "right", "pageup", "pagedown", "home", "end", "ctrl+left"]
KEYS += [*"0123456789qwertyQYxz.,-+=@?/"]
LOOK = 0.0002
"""Seconds that pass while the program looks at the wall's clock."""
PROGRAM = ["", "table4.bas"]


def _size(rng: Random) -> list[int]:
    """Columns and rows of a window."""
    if rng.random() < 0.8:
        return list(rng.choice(SIZES))
    return [rng.randrange(1, 220), rng.randrange(1, 70)]


def _sitting(rng: Random) -> Case:
    deeds: list[Any] = []
    for _ in range(rng.randrange(5, 40)):
        kind = rng.choices(["press", "do", "type", "size", "click"], [5, 2, 1, 1, 1])[0]
        if kind == "press":
            deed: list[Any] = [kind, rng.choice(KEYS)]
        elif kind == "do":
            named = [each.name for each in COMMANDS if each.name not in LEAVES]
            deed = [kind, rng.choice(named)]
        elif kind == "type":
            deed = [kind, rng.choice(["RUN", "@SET", "LIST", "EDIT 10", noise.statement(rng)])]
        elif kind == "size":
            deed = [kind, *_size(rng)]
        else:
            deed = [kind, rng.randrange(120), rng.randrange(40)]
        deeds.append([*deed, rng.choice([0.02, 0.1, 0.5])])
    return {"size": _size(rng), "program": rng.choice(PROGRAM), "deeds": deeds}


async def _do(sitting: Sitting, kind: str, *what: Any) -> None:
    app = sitting.app
    match kind:
        case "press":
            await sitting.press(*what)
        case "do":
            app.action_do(*what)
        case "type":
            app.session.rig.type(f"{what[0]}\r")
        case "size":
            await sitting.pilot.resize_terminal(*what)
        case "click":
            place = tuple(min(at, end - 1) for at, end in zip(what, app.size, strict=True))
            # A window may have places with nothing at them.
            with contextlib.suppress(NoMatches, NoWidget, OutOfBounds):
                await sitting.pilot.click(offset=place)


def _play(case: Case) -> None:
    with TemporaryDirectory() as name, contextlib.chdir(name):
        folder = Path(name)

        @piloted
        async def sit() -> None:
            async with opener_in(folder)(*case["size"]) as sitting:
                # Flat out the machine works until the wall's clock has moved on.
                sitting.wall.look = LOOK
                if case["program"]:
                    listing = (PROGRAMS / case["program"]).read_text(encoding="utf-8")
                    sitting.app.session.rig.load_text(listing)
                for *deed, seconds in case["deeds"]:
                    await _do(sitting, *deed)
                    if not sitting.app.is_running:
                        break
                    await sitting.pass_time(seconds)
                hold(sitting.app.fault is None, "a fault of the program")

        settings = {"TRS80ARM_STATE": name, "TRS80ARM_CONFIG": str(folder / "settings.toml")}
        with patch.dict(os.environ, settings):
            sit()


TARGETS = [Target("windows", _sitting, _play)]
