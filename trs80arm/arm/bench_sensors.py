"""The sensors of a bench file: proximity, tactile, beam, and the selector of their banks.

The reference of the keys is in `docs/arm.md`.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from trs80arm.arm.bench import Bench
from trs80arm.arm.bench_forms import FAR
from trs80arm.arm.cell.inputs import Answering, Selector
from trs80arm.arm.cell.sensors import LightBeam, Proximity, Tactile
from trs80arm.arm.shapes import Vector, upright
from trs80arm.plain_values import Table


def read_selector(bench: Bench, top: Table) -> None:
    """Take the selector's table out of a bench file's, before all that may be in a bank.

    Raises:
        SettingsError: one line, if it cannot be.
    """
    selector = top.table("selector")
    if selector is not None:
        bench.selector = _selector(selector)


def read_sensors(bench: Bench, top: Table) -> None:
    """Take the sensors' tables out of a bench file's.

    Raises:
        SettingsError: one line, if one of them cannot be.
    """
    for head, read in _READERS.items():
        for item in top.tables(head):
            bench.sensors.append(read(bench, item))


def _selector(item: Table) -> Selector:
    """[selector]."""
    expected = "1 to 4 different bits of the auxiliary output, each from 0 to 3"
    bits = item.data.pop("bits", None)
    if not isinstance(bits, list) or not 1 <= len(bits) <= 4:
        raise item.fail("bits", expected)
    if any(isinstance(bit, bool) or bit not in (0, 1, 2, 3) for bit in bits):
        raise item.fail("bits", expected)
    if len(set(bits)) != len(bits):
        raise item.fail("bits", expected)
    item.done("bits")
    return Selector(tuple(int(bit) for bit in bits))


def _wired(bench: Bench, item: Table, kind: str) -> tuple[int, int, str]:
    """The keys `bit`, `bank` and `name`: where a sensor is on the input nibble."""
    bit = item.integer("bit", 1, 3)
    bank = 0
    if "bank" in item.data:
        if bench.selector is None:
            raise item.fail("bank", "a [selector] in the file, whose bits choose a bank")
        bank = item.integer("bank", 0, bench.selector.banks - 1)
    for other in bench.sensors:
        if (other.bit, other.bank) == (bit, bank):
            where = "input bit" if bench.selector is None else "input bit and bank"
            raise item.fail("bit", f"an {where} that no other sensor uses")
    name = item.text("name", _unused(bench, kind))
    if any(other.name == name for other in bench.sensors):
        raise item.fail("name", "a name that no other sensor has")
    return bit, bank, name


def _unused(bench: Bench, kind: str) -> str:
    """A name for one more sensor of a kind."""
    names = {sensor.name for sensor in bench.sensors}
    return next(f"{kind} {n}" for n in range(1, len(names) + 2) if f"{kind} {n}" not in names)


def _vector(values: tuple[float, ...]) -> Vector:
    return values[0], values[1], values[2]


def _proximity(bench: Bench, item: Table) -> Answering:
    """[[proximity]]."""
    bit, bank, name = _wired(bench, item, "proximity")
    place = _vector(item.vector("at", 3, -FAR, FAR))
    sensor = Proximity(bit, place, item.number("range", 0.05, FAR), name, bank)
    item.done("at, range, bit, bank, name")
    return sensor


def _tactile(bench: Bench, item: Table) -> Answering:
    """[[tactile]]."""
    bit, bank, name = _wired(bench, item, "tactile")
    x, y = item.vector("at", 2, -FAR, FAR)
    width, depth = item.vector("size", 2, 0.1, FAR)
    height = item.number("height", 0, FAR, 0.0)
    pad = upright(x, y, height - 0.05, (width, depth, 0.1), 0.0)
    item.done("at, size, height, bit, bank, name")
    return Tactile(bit, pad, name, bank)


def _beam(bench: Bench, item: Table) -> Answering:
    """[[beam]]."""
    bit, bank, name = _wired(bench, item, "beam")
    start = _vector(item.vector("from", 3, -FAR, FAR))
    end = _vector(item.vector("to", 3, -FAR, FAR))
    if math.dist(start, end) < 0.01:
        raise item.fail("to", "another place than from")
    item.done("from, to, bit, bank, name")
    return LightBeam(bit, start, end, name, bank)


_READERS: dict[str, Callable[[Bench, Table], Answering]] = {
    "proximity": _proximity,
    "tactile": _tactile,
    "beam": _beam,
}
SENSORS = ", ".join(_READERS)
"""The tables of sensors, for errors."""
