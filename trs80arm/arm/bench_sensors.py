"""The sensors of a bench file, on the table and on the arm, and the selector of their banks.

The reference of the keys is in `docs/arm.md`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from itertools import count
from typing import TypeVar

from trs80arm.arm.bench import Bench
from trs80arm.arm.bench_forms import FAR
from trs80arm.arm.cell.home import JOINTS, HomeSwitch
from trs80arm.arm.cell.inputs import Answering, Selector
from trs80arm.arm.cell.mounted import Face, ForceSensor, PalmProximity, TactilePad, Tension
from trs80arm.arm.cell.sensors import LightBeam, Proximity, Tactile
from trs80arm.arm.linkage import FINGERS
from trs80arm.arm.model import Limits, Link, Motor
from trs80arm.arm.shapes import Vector, upright
from trs80arm.plain_values import Table

PLAY, MOST_PLAY = 0.25, 10.0
"""Degrees of play of a home switch unless given, and at most."""

T = TypeVar("T")


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


def wired(bench: Bench, item: Table, kind: str, called: str | None = None) -> tuple[int, int, str]:
    """The keys `bit`, `bank` and `name`: where a sensor is on the input nibble.

    Args:
        bench: so far.
        item: its table.
        kind: by which it is called, with a number.
        called: its name if the file has none, instead of that; with a number if it is taken.
    """
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
    names = {sensor.name for sensor in bench.sensors}
    if called is None or called in names:
        first, kind = (1, kind) if called is None else (2, called)
        called = next(f"{kind} {n}" for n in count(first) if f"{kind} {n}" not in names)
    name = item.text("name", called)
    if name in names:
        raise item.fail("name", "a name that no other sensor has")
    return bit, bank, name


def _vector(values: tuple[float, ...]) -> Vector:
    return values[0], values[1], values[2]


def _on(item: Table, choices: Mapping[str, T]) -> T:
    """The key `on`: where the arm has a sensor."""
    value = item.data.pop("on", None)
    if not isinstance(value, str) or value not in choices:
        raise item.fail("on", f"one of {', '.join(choices)}")
    return choices[value]


def _proximity(bench: Bench, item: Table) -> Answering:
    """[[proximity]]: on the table, or in the palm."""
    if "on" in item.data:
        _on(item, {"palm": None})
        bit, bank, name = wired(bench, item, "proximity", "palm")
        eye = PalmProximity(name, bit, bank, item.number("range", 0.05, FAR))
        item.done("on, range, bit, bank, name")
        return eye
    bit, bank, name = wired(bench, item, "proximity")
    place = _vector(item.vector("at", 3, -FAR, FAR))
    sensor = Proximity(bit, place, item.number("range", 0.05, FAR), name, bank)
    item.done("at, range, bit, bank, name")
    return sensor


def _tactile(bench: Bench, item: Table) -> Answering:
    """[[tactile]]: on the table, or on the arm."""
    if "on" in item.data:
        on = _on(item, _LINKS)
        face = None
        if on in FINGERS:
            face = item.take("face", Face, Face.TIP)
        where = f"{_WORDS[on]} {face.value}" if face is not None else _WORDS[on]
        bit, bank, name = wired(bench, item, "tactile", where)
        mounted = TactilePad(name, bit, bank, on, face, item.number("threshold", *_OUNCES, 1.0))
        item.done(f"on, {'face, ' if on in FINGERS else ''}threshold, bit, bank, name")
        return mounted
    bit, bank, name = wired(bench, item, "tactile")
    x, y = item.vector("at", 2, -FAR, FAR)
    width, depth = item.vector("size", 2, 0.1, FAR)
    height = item.number("height", 0, FAR, 0.0)
    pad = upright(x, y, height - 0.05, (width, depth, 0.1), 0.0)
    item.done("at, size, height, bit, bank, name")
    return Tactile(bit, pad, name, bank)


def _beam(bench: Bench, item: Table) -> Answering:
    """[[beam]]."""
    bit, bank, name = wired(bench, item, "beam")
    start = _vector(item.vector("from", 3, -FAR, FAR))
    end = _vector(item.vector("to", 3, -FAR, FAR))
    if math.dist(start, end) < 0.01:
        raise item.fail("to", "another place than from")
    item.done("from, to, bit, bank, name")
    return LightBeam(bit, start, end, name, bank)


def _force(bench: Bench, item: Table) -> Answering:
    """[[force]]."""
    on = _on(item, {each.value: each for each in Tension})
    bit, bank, name = wired(bench, item, "force", f"{on.value} tension")
    sensor = ForceSensor(name, bit, bank, on, item.number("threshold", *_OUNCES))
    item.done("on, threshold, bit, bank, name")
    return sensor


def _home(bench: Bench, item: Table) -> Answering:
    """[[home]]."""
    joint = item.data.pop("joint", None)
    if not isinstance(joint, str) or joint not in JOINTS:
        raise item.fail("joint", f"one of {', '.join(JOINTS)}")
    bit, bank, name = wired(bench, item, "home", f"{joint} home")
    low, high = _range(bench.settings.arm_model.limits, JOINTS[joint])
    mark, play = item.number("at", low, high), item.number("play", 0, MOST_PLAY, PLAY)
    item.done("joint, at, play, bit, bank, name")
    return HomeSwitch(name, bit, bank, JOINTS[joint], math.radians(mark), math.radians(play))


def _range(limits: Limits, motor: Motor) -> tuple[float, float]:
    """How far a joint goes, degrees; the forearm to the horizontal."""
    low, high = {
        Motor.BASE: (-limits.base, limits.base),
        Motor.SHOULDER: limits.shoulder,
        Motor.ELBOW: (
            limits.shoulder[0] + limits.elbow[0],
            limits.shoulder[1] + limits.elbow[1],
        ),
    }.get(motor, (-limits.gear, limits.gear))
    return round(math.degrees(low), 6), round(math.degrees(high), 6)


_WORDS = {link: link.name.lower().replace("_", " ") for link in Link}
_LINKS = {word: link for link, word in _WORDS.items()}
_OUNCES = 0.1, 200.0
"""Between which the threshold of a force lies."""

_READERS: dict[str, Callable[[Bench, Table], Answering]] = {
    "proximity": _proximity,
    "tactile": _tactile,
    "beam": _beam,
    "force": _force,
    "home": _home,
}
SENSORS = ", ".join(_READERS)
"""The tables of sensors, for errors."""
