"""Scripts of runs without a screen: what the operator does, and what is expected of the run.

A script is a TOML file. It names no place on the disk and runs no code; whatever is wrong in it is
one line that names file and key.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated

from trs80arm.operator import HAND_PAUSE, Hold, ScriptError, parse_holds
from trs80arm.paths import beside
from trs80arm.plain_values import Range, SettingsError, Table
from trs80arm.toml_files import TomlError, read_text, tables_of

SUFFIX = ".run.toml"
"""With what the name of a script beside a program ends."""
LONGEST = 1e9
"""Virtual seconds of a run at most, 31 years."""
_FAR = 1e6
_ENDINGS = ("end", "stop", "break", "error", "input", "set", "limit")
_KEYS = "seconds, inputs, sets, keys, expect"
_EXPECTED = "ended, line, error, output, screen, registers, joints, most_slips, goals, pose, part"


@dataclass(frozen=True)
class Place:
    """Where something is expected, and how far from there it may be."""

    name: str
    at: tuple[float, ...]
    within: float
    held: bool | None = None


@dataclass(frozen=True)
class Expected:
    """What a run is expected to come to; what is None or empty is not looked at.

    Attributes:
        ended: how it ends, as `report.ended` says it.
        line: in which line.
        error: with which error's two letters.
        output: texts that are printed, in this order.
        screen: texts that stand on the tube at the end.
        registers: J1 to J6 as commanded.
        joints: J1 to J6 as they truly are.
        most_slips: how many times motors may slip.
        goals: whether the bench's goals are met.
        pose: where the hand is.
        parts: where parts are.
    """

    ended: str | None = None
    line: int | None = None
    error: str | None = None
    output: tuple[str, ...] = ()
    screen: tuple[str, ...] = ()
    registers: tuple[int, ...] | None = None
    joints: tuple[int, ...] | None = None
    most_slips: int | None = None
    goals: bool | None = None
    pose: Place | None = None
    parts: tuple[Place, ...] = ()

    @property
    def anything(self) -> bool:
        """Whether anything is expected at all."""
        return self != Expected()


@dataclass(frozen=True)
class RunScript:
    """A script.

    Attributes:
        seconds: the limit in virtual seconds from RUN; None for the usual one.
        inputs: the answers to INPUT, in order.
        sets: what is done in each `@SET`, in order.
        keys: keys held down at times from RUN, in order of time.
        expected: what the run is to come to.
    """

    seconds: float | None = None
    inputs: tuple[str, ...] = ()
    sets: tuple[tuple[Hold, ...], ...] = ()
    keys: tuple[tuple[float, Hold], ...] = ()
    expected: Expected = field(default_factory=Expected)


def script_beside(program: Path) -> Path | None:
    """The script that is named like a program and stands beside it, `NAME.run.toml`."""
    return beside(program, SUFFIX)


def read_script(path: Path) -> RunScript:
    """Read a script.

    Raises:
        ScriptError: it is no script; one line that names the file and the key.
        OSError: it cannot be read.
    """
    try:
        return _script(Table(str(path), "", tables_of(read_text(path, "script"))))
    except TomlError as error:
        raise ScriptError(f"{path}: {error}") from None
    except SettingsError as error:
        raise ScriptError(str(error)) from None


def _script(table: Table) -> RunScript:
    seconds = table.take("seconds", Annotated[float, Range(0, LONGEST)], None)
    inputs = table.take("inputs", tuple[str, ...], ())
    sets = tuple(
        tuple(_holds(table, "sets", holds)) for holds in table.take("sets", tuple[str, ...], ())
    )
    keys: list[tuple[float, Hold]] = []
    for each in table.tables("keys"):
        at = each.number("at", 0, LONGEST)
        for hold in _holds(each, "hold", each.take("hold", str)):
            keys.append((at, hold))
            at += hold.seconds + HAND_PAUSE
        each.done("at, hold")
    expect = table.table("expect")
    expected = _expected(expect) if expect else Expected()
    table.done(_KEYS)
    return RunScript(seconds, inputs, sets, tuple(sorted(keys, key=lambda key: key[0])), expected)


def _holds(table: Table, key: str, text: str) -> list[Hold]:
    try:
        return parse_holds(text)
    except ScriptError as error:
        raise table.fail(key, f'keys as in "6:1.0 0": {error}') from None


def _expected(table: Table) -> Expected:
    six = tuple[int, int, int, int, int, int]
    ended = table.take("ended", str, None)
    if ended is not None and ended not in _ENDINGS:
        raise table.fail("ended", f"one of {', '.join(_ENDINGS)}")
    pose = table.table("pose")
    expected = Expected(
        ended=ended,
        line=table.take("line", int, None),
        error=table.take("error", str, None),
        output=_texts(table, "output"),
        screen=_texts(table, "screen"),
        registers=table.take("registers", six, None),
        joints=table.take("joints", six, None),
        most_slips=table.take("most_slips", Annotated[int, Range(0, 10**9)], None),
        goals=table.take("goals", bool, None),
        pose=_place(pose, "the hand") if pose else None,
        parts=tuple(_place(part, None) for part in table.tables("part")),
    )
    table.done(_EXPECTED)
    return expected


def _texts(table: Table, key: str) -> tuple[str, ...]:
    if isinstance(table.data.get(key), str):
        return (table.take(key, str),)
    texts: tuple[str, ...] = table.take(key, tuple[str, ...], ())
    return texts


def _place(table: Table, name: str | None) -> Place:
    known = "at, within" if name else "name, at, within, held"
    held = None if name else table.take("held", bool, None)
    place = Place(
        name or table.text("name"),
        table.vector("at", 3, -_FAR, _FAR),
        table.number("within", 0, _FAR, 0.1),
        held,
    )
    table.done(known)
    return place
