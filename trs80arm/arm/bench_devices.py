"""The devices in a bench file: what the auxiliary latch drives, a table a device.

Each says which bits of the latch it listens to; no bit has two listeners. The reference of the
keys is in `docs/workcell.md`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

from trs80arm.arm.bench import Bench, obstacle
from trs80arm.arm.bench_forms import FAR, read_friction, read_size, refuse_overlap
from trs80arm.arm.bench_sensors import wired
from trs80arm.arm.cell.commanded_feeder import CommandedFeeder
from trs80arm.arm.cell.conveyor import Conveyor
from trs80arm.arm.cell.device import AnsweringDevice, Lamp
from trs80arm.arm.cell.machine import BUSY, DONE, ERROR, Machine
from trs80arm.arm.cell.sensors import LightBeam
from trs80arm.arm.cell.turntable import Turntable
from trs80arm.arm.contact.forms import tray
from trs80arm.arm.contact.rotations import oriented
from trs80arm.arm.contact.solids import box
from trs80arm.arm.contact.table import Plate
from trs80arm.arm.fixtures import Feeder
from trs80arm.arm.shapes import Vector, upright
from trs80arm.plain_values import Table

DEVICES = "conveyor, machine, turntable"
"""The tables of devices."""
FASTEST = 20.0
"""Inches a second that a belt makes at most."""
BESIDE = 0.25
"""Inches beside the belt at which a photocell and its lamp stand."""
WALL = 0.1
"""Thickness of a machine's hood, inches."""
LAMP = 0.15
"""Size that answers are drawn with, inches."""
DRIVES = ("coils", "pulse")
"""How a turntable's motor hangs on the latch."""


def read_devices(bench: Bench, top: Table) -> None:
    """All devices of a bench file.

    Raises:
        SettingsError: one line, if one cannot be.
    """
    for item in top.tables("conveyor"):
        _conveyor(bench, item)
    for item in top.tables("machine"):
        _machine(bench, item)
    for item in _tables(top, "turntable"):
        _turntable(bench, item)


def _tables(top: Table, key: str) -> list[Table]:
    """The tables of a kind: several, `[[key]]`, or a single one, `[key]`."""
    if isinstance(top.data.get(key), Mapping):
        alone = top.table(key)
        return [] if alone is None else [alone]
    return top.tables(key)


def _name(bench: Bench, item: Table, kind: str) -> str:
    """The key `name`: the kind unless given, with a number from the second on."""
    names = [device.name for device in bench.cell.devices if device.kind == kind]
    name = item.text("name", kind if not names else f"{kind} {len(names) + 1}")
    if name in names:
        raise item.fail("name", f"a name that no other {kind} has")
    return name


class Wires:
    """The bits of the auxiliary latch that one device takes."""

    def __init__(self, bench: Bench, item: Table) -> None:
        self._bench = bench
        self._item = item
        self._own: dict[int, str] = {}

    def bit(self, key: str) -> int:
        """A key that names a bit: one to which nobody else listens."""
        bit = self._item.integer(key, 0, 3)
        self._free(key, bit)
        self._own[bit] = key
        return bit

    def optional(self, key: str) -> int | None:
        """The same, or None where the file does not have it."""
        return self.bit(key) if key in self._item.data else None

    def all(self, key: str) -> None:
        """A device whose key `key` says that it takes all four."""
        for bit in range(4):
            self._free(key, bit)

    def _free(self, key: str, bit: int) -> None:
        other = self._bench.cell.listener(bit)
        whose = None if other is None else f"that of {other.title}"
        if self._bench.selector is not None and bit in self._bench.selector.bits:
            whose = "that of the selector"
        if bit in self._own:
            whose = f"named by {self._own[bit]}"
        if whose is not None:
            raise self._item.fail(
                key, f"a free bit; bit {bit} of the auxiliary latch is already {whose}"
            )


def _conveyor(bench: Bench, item: Table) -> None:
    """[[conveyor]]."""
    name = _name(bench, item, Conveyor.kind)
    x, y = item.vector("at", 2, -FAR, FAR)
    length, width = (
        item.number(key, least, FAR) for key, least in (("length", 1.0), ("width", 0.25))
    )
    height = item.number("height", 0.1, 10.0, 1.0)
    turn = oriented(item.number("turn", -360, 360, 0.0))
    speed, ramp = item.number("speed", 0.05, FASTEST), item.number("ramp", 0.01, 10.0, 0.25)
    friction = read_friction(item)
    wires = Wires(bench, item)
    run, reverse = wires.bit("run"), wires.optional("reverse")
    frame = obstacle(name, (box((length, width, height)),), x, y, 0.0, turn)
    conveyor = Conveyor(name, frame, speed, ramp, run, reverse, friction)
    _photocell(bench, item, conveyor)
    item.done(
        "name, at, length, width, height, turn, speed, ramp, friction, run, reverse, photocell"
    )
    refuse_overlap(bench, item, "at", conveyor.frame.placed)
    bench.cell.devices.append(conveyor)


def _photocell(bench: Bench, item: Table, conveyor: Conveyor) -> None:
    """[conveyor.photocell]: a beam across the belt."""
    cell = item.table("photocell")
    if cell is None:
        return
    bit, bank, name = wired(bench, cell, "photocell", f"{conveyor.name} photocell")
    place = conveyor.frame.box
    half = place.half
    along = cell.number("along", -half[0], half[0], 0.0)
    above = cell.number("above", 0.05, 10.0, 0.25)
    cell.done("name, along, above, bit, bank")
    ends = [place.point(along, side * (half[1] + BESIDE), half[2] + above) for side in (-1, 1)]
    bench.sensors.append(LightBeam(bit, ends[0], ends[1], name, bank))


def _machine(bench: Bench, item: Table) -> None:
    """[[machine]]."""
    name = _name(bench, item, Machine.kind)
    x, y = item.vector("at", 2, -FAR, FAR)
    turn = item.number("turn", -360, 360, 0.0)
    size, height = read_size(item), item.number("height", 0, 10.0, 0.0)
    seconds = item.number("seconds", 0.001, 3600.0)
    press = item.number("press", 0.05, size[2]) if "press" in item.data else None
    start = Wires(bench, item).bit("start")
    outer = (size[0] + 2 * WALL, size[1] + 2 * WALL, size[2] + WALL)
    # A tray turned over: four walls and a roof.
    over = oriented(turn, 0.0, 180.0)
    hood = obstacle(f"{name} hood", tray(outer, WALL), x, y, height, over)
    inside = obstacle(name, (box(size),), x, y, height, oriented(turn)).box
    block = None
    if height:
        base = (outer[0], outer[1], height)
        block = obstacle(name, (box(base),), x, y, 0.0, oriented(turn))
        refuse_overlap(bench, item, "at", block.placed)
    refuse_overlap(bench, item, "at", hood.placed)
    machine = Machine(name, inside, hood, block, seconds, start, press)
    bench.cell.devices.append(machine)
    for place, key in enumerate((BUSY, DONE, ERROR)):
        if key in item.data or key == DONE:
            along = LAMP * (2 * place + 1) - inside.half[0]
            middle = inside.point(along, -inside.half[1] - WALL - LAMP, LAMP - inside.half[2])
            read_lamp(bench, item, key, machine, middle)
    item.done("name, at, turn, size, height, seconds, press, start, busy, done, error")


def read_command(bench: Bench, item: Table, feeder: Feeder) -> str:
    """The keys `give` and `there` of a feeder: who commands it, and what it answers.

    Args:
        bench: so far.
        item: the feeder's table.
        feeder: that it describes.

    Returns:
        The keys that it may have, for errors.
    """
    if not feeder.commanded:
        return "give"
    device = CommandedFeeder(feeder.name, feeder, Wires(bench, item).bit("give"))
    bench.cell.devices.append(device)
    if "there" in item.data:
        place = feeder.place
        beside = place.point(0.0, -place.half[1] - 2 * LAMP, LAMP - place.half[2])
        read_lamp(bench, item, "there", device, beside)
    return "give, there"


def read_lamp(bench: Bench, item: Table, key: str, device: AnsweringDevice, at: Vector) -> None:
    """An answer of a device: `key = 2`, a bit of the input nibble, or `{ bit = 2, bank = 1 }`.

    Args:
        bench: so far.
        item: the device's table.
        key: that names the answer.
        device: that gives it.
        at: where drawings have it.

    Raises:
        SettingsError: it cannot be.
    """
    if not isinstance(item.data.get(key), Mapping):
        item.data[key] = {"bit": item.integer(key, 1, 3)}
    table = item.table(key)
    assert table is not None
    bit, bank, name = wired(bench, table, key, f"{device.name} {key}")
    table.done("name, bit, bank")
    x, y, z = at
    lamp = upright(x, y, z - LAMP / 2, (LAMP, LAMP, LAMP), 0.0)
    bench.sensors.append(Lamp(device, key, name, bit, bank, lamp))


def _turntable(bench: Bench, item: Table) -> None:
    """[turntable] or [[turntable]]."""
    name = _name(bench, item, Turntable.kind)
    x, y = item.vector("at", 2, -FAR, FAR)
    plate = Plate(x, y, item.number("radius", 0.1, FAR))
    steps = item.integer("steps", 8, 1_000_000, 96)
    drive = item.data.pop("drive", DRIVES[0])
    if drive not in DRIVES:
        raise item.fail("drive", f"one of {', '.join(DRIVES)}")
    wires, pulse, direction = Wires(bench, item), None, None
    if drive == "coils":
        wires.all("drive")
        item.done("name, at, radius, steps, drive")
    else:
        pulse, direction = wires.bit("pulse"), wires.optional("direction")
        item.done("name, at, radius, steps, drive, pulse, direction")
    for other in bench.cell.devices:
        if isinstance(other, Turntable):
            apart = math.dist((x, y), (other.plate.x, other.plate.y))
            if apart < plate.radius + other.plate.radius:
                raise item.fail("at", f"a free place; it overlaps {other.title}")
    bench.cell.devices.append(Turntable(name, plate, steps, pulse, direction))
