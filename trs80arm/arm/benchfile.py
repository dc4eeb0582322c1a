"""Reading a bench from a TOML file, with errors that name file, key and what was expected.

A bench lies beside the program that works on it. Every key is checked; unknown ones are errors.
The reference of the format is in `docs/arm.md`.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

from trs80arm.arm.bench import Bench, BenchError, around, deep, obstacle
from trs80arm.arm.bench_devices import DEVICES, read_command, read_devices
from trs80arm.arm.bench_forms import (
    FAR,
    KEYS,
    read_friction,
    read_shape,
    read_solids,
    read_turn,
    refuse_overlap,
)
from trs80arm.arm.bench_goals import read_goal
from trs80arm.arm.bench_sensors import SENSORS, read_selector, read_sensors
from trs80arm.arm.by_hand import occupied
from trs80arm.arm.fixtures import Feeder, Tray
from trs80arm.arm.geometry import CableDrive, OutOfReach
from trs80arm.arm.limits import beyond_any_stop
from trs80arm.arm.model import ArmModel, Pose
from trs80arm.arm.world import World
from trs80arm.plain_values import SettingsError, Table
from trs80arm.reasons import reason
from trs80arm.toml_files import TomlError, read_text, tables_of, with_plain_ends


def load(path: str | Path) -> Bench:
    """Read a bench from a file.

    Raises:
        BenchError: one line, if the file cannot be read or is not a bench.
    """
    return parse(read(path), str(path))


def read(path: str | Path) -> str:
    """The text of a bench file, not looked at.

    Raises:
        BenchError: one line, if the file cannot be read or is no text.
    """
    try:
        return with_plain_ends(read_text(Path(path), "bench"))
    except TomlError as error:
        raise BenchError(f"{path}: {error}") from None
    except OSError as error:
        raise BenchError(f"{path}: cannot be read: {reason(error)}") from None


def parse(text: str, name: str = "bench") -> Bench:
    """Read a bench from TOML text.

    Args:
        text: the file's content.
        name: of the file, for errors.

    Raises:
        BenchError: one line, if the text is not a bench.
    """
    try:
        data = tables_of(text)
    except TomlError as error:
        raise BenchError(f"{name}: expected TOML: {error}") from None
    return build(data, name)


def build(data: dict[str, Any], name: str = "bench") -> Bench:
    """Set up what the tables of a bench file say.

    Args:
        data: the tables, as TOML gives them.
        name: of the file, for errors.

    Raises:
        BenchError: one line, if that is no bench.
    """
    try:
        return _bench(Table(name, "", data), Path(name).stem or "bench")
    except SettingsError as error:
        raise BenchError(str(error)) from None


def _bench(top: Table, name: str) -> Bench:
    bench = Bench(top.text("name", name))
    model = bench.settings.arm_model
    _arm(bench, model, top.table("arm"))
    drive = CableDrive.from_pose(model, bench.start or model.start)
    for item in top.tables("obstacle"):
        _obstacle(bench, item)
    read_selector(bench, top)
    read_devices(bench, top)
    for item in top.tables("part"):
        _part(bench, item)
    for item in top.tables("feeder"):
        _feeder(bench, item)
    for item in top.tables("tray"):
        _tray(bench, item)
    read_sensors(bench, top)
    bench.goals += [read_goal(bench, item) for item in top.tables("goal")]
    top.done(f"name, arm, part, feeder, tray, obstacle, {DEVICES}, selector, {SENSORS}, goal")
    there = occupied(World(bench, bench.settings, drive))
    if there is not None:
        raise top.fail("arm.at", f"a free place for the hand; {there} is in the way")
    return bench


def _arm(bench: Bench, model: ArmModel, item: Table | None) -> None:
    """Where the arm stands when it is switched on."""
    if item is None:
        return
    x, y, z = item.vector("at", 3, -FAR, FAR)
    pose = Pose(
        x,
        y,
        z,
        item.number("pitch", -360, 360, -90.0),
        item.number("roll", -360, 360, 0.0),
        item.number("opening", 0, model.hand.range, 0.0),
    )
    item.done("at, pitch, roll, opening")
    try:
        drive = CableDrive.from_pose(model, pose)
    except OutOfReach as error:
        raise item.fail("at", f"a pose within reach; {error}") from None
    stop = beyond_any_stop(drive, (0,) * 6)
    if stop is not None:
        raise item.fail("at", f"a pose within the stops; it is beyond {stop}")
    bench.start = pose


def _obstacle(bench: Bench, item: Table) -> None:
    """[[obstacle]]."""
    name = item.text("name", f"obstacle {len(bench.obstacles) - 1}")
    at = item.vector("at", 2, -FAR, FAR)
    bottom = item.number("bottom", 0, FAR, 0.0)
    shape = read_shape(item)
    turn, solids = read_turn(item), read_solids(item, shape)
    item.done(f"name, at, bottom, turn, tilt, roll, shape, {KEYS[shape]}")
    bench.obstacles.append(obstacle(name, solids, at[0], at[1], bottom, turn))


def _part(bench: Bench, item: Table) -> None:
    """[[part]]."""
    name = item.text("name", f"part {len(bench.parts) + 1}")
    if name in bench.parts:
        raise item.fail("name", "a name that no other part has")
    x, y = item.vector("at", 2, -FAR, FAR)
    bottom = item.number("bottom", 0, FAR, 0.0)
    shape = read_shape(item)
    turn, solids = read_turn(item), read_solids(item, shape)
    weight, friction = item.number("weight", 0.01, 1600, 2.0), read_friction(item)
    item.done(f"name, at, bottom, turn, tilt, roll, shape, {KEYS[shape]}, weight, friction")
    made = bench.make(solids, name, weight, x, y, bottom, turn, friction)
    refuse_overlap(bench, item, "at", made.placed)
    bench.scene.add(made)


def _feeder(bench: Bench, item: Table) -> None:
    """[[feeder]]."""
    name = item.text("name", f"feeder {len(bench.feeders) + 1}")
    x, y = item.vector("at", 2, -FAR, FAR)
    turn = math.radians(item.number("turn", -360, 360, 0.0))
    shape = read_shape(item)
    solids = read_solids(item, shape)
    weight, friction = item.number("weight", 0.01, 1600, 2.0), read_friction(item)
    count = item.integer("count", 1, 1_000_000) if "count" in item.data else None
    bottom = item.number("bottom", 0, FAR, 0.0)
    feeder = Feeder(
        name,
        x,
        y,
        turn,
        around(solids),
        weight,
        count,
        solids=solids,
        friction=friction,
        bottom=bottom,
        commanded="give" in item.data,
    )
    answers = read_command(bench, item, feeder)
    item.done(f"name, at, bottom, turn, shape, {KEYS[shape]}, weight, friction, count, {answers}")
    refuse_overlap(bench, item, "at", feeder.placed)
    for other in bench.feeders:
        if any(deep(mine, theirs) for mine in feeder.placed for theirs in other.placed):
            raise item.fail("at", f"a free place; it overlaps {other.name}")
    bench.feeders.append(feeder)


def _tray(bench: Bench, item: Table) -> None:
    """[[tray]]."""
    name = item.text("name", f"tray {len(bench.trays) + 1}")
    x, y = item.vector("at", 2, -FAR, FAR)
    width, depth = item.vector("size", 2, 0.1, FAR)
    item.done("name, at, size")
    bench.trays.append(Tray(name, x, y, width, depth))
