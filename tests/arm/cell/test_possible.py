"""Whatever is done with devices every part stays where one can be; no forged device is taken."""

from __future__ import annotations

import contextlib
import json
import random

import pytest

from tests.arm.test_robustness import Operator, assert_possible
from tests.sealing import sealed
from trs80arm import Rig
from trs80arm.arm import BenchError, MiniMover, benchfile
from trs80arm.arm.stepping import PulseGenerator
from trs80arm.snapshots import SnapshotError


def random_cell(chance: random.Random) -> str:
    """A bench file with devices around the place where the arm works, and parts on them."""
    bits = chance.sample(range(4), 4)
    reverse = f"reverse = {bits[1]}\n" if chance.random() < 0.5 else ""
    height = chance.choice([0.5, 1.0, 2.0])
    x, y, turn = chance.uniform(7, 9), chance.uniform(-5, -3), chance.choice([0, 90, 30])
    tables = [
        f"[arm]\nat = [5.0, 0.0, 5.0]\n[[conveyor]]\nname = 'belt'\nat = [{x}, {y}]\n"
        f"length = {chance.uniform(2, 8)}\nwidth = {chance.uniform(1, 2.5)}\nheight = {height}\n"
        f"turn = {turn}\nspeed = {chance.choice([0.5, 2.0, 8.0])}\n"
        f"ramp = {chance.choice([0.01, 0.25])}\nrun = {bits[0]}\n{reverse}"
        "photocell = { bit = 1 }",
        f"[[machine]]\nat = [8.0, 4.0]\nturn = {chance.choice([0, 45])}\nsize = [1.5, 1.5, 1.5]\n"
        f"seconds = {chance.choice([0.01, 0.3])}\npress = 0.4\nstart = {bits[2]}\ndone = 2",
        f"[[feeder]]\nat = [{x}, {y}]\nbottom = {height}\nsize = [0.6, 0.6, 0.8]\n"
        f"give = {bits[3]}\nthere = 3",
        "[[part]]\nname = 'in the nest'\nat = [8.0, 4.0]\nsize = [0.5, 0.5, 1.0]",
    ]
    for k in range(chance.randrange(4)):
        size = [round(chance.uniform(0.3, 1.2), 3) for _ in range(3)]
        tables.append(
            f"[[part]]\nname = 'part {k}'\nat = [{x + chance.uniform(-2, 2)}, "
            f"{y + chance.uniform(-1, 1)}]\nbottom = {height + 1.3 * k}\nsize = {size}"
        )
    return "\n".join(tables)


@pytest.mark.parametrize("seed", [0, 1, 923, 40])
def test_whatever_is_done_with_devices_every_part_stays_where_a_part_can_be(seed: int) -> None:
    chance = random.Random(seed)
    arm = None
    while arm is None:
        with contextlib.suppress(BenchError):
            arm = MiniMover(bench=benchfile.parse(random_cell(chance)))
    operator = Operator(chance, PulseGenerator(arm))
    for _ in range(5):
        latch = chance.randrange(16)
        operator.write([6] * 8, [latch, 0, latch, 15, latch, chance.randrange(16), latch, latch])
        operator.generator.wait(chance.choice([0.05, 0.3]))
        operator.act()
        assert_possible(arm)


CELL = """
[[conveyor]]
at = [7.0, -6.0]
length = 6.0
width = 2.0
speed = 2.0
run = 0
[[machine]]
at = [9.0, 4.0]
size = [1.5, 1.5, 2.0]
seconds = 0.2
start = 2
done = 2
[[turntable]]
at = [13.0, 0.0]
radius = 1.0
drive = "pulse"
pulse = 1
[[part]]
at = [9.0, 4.0]
size = [0.5, 0.5, 1.0]
"""


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("ramp", 0.0),
        ("speed", -1.0),
        ("run", 9),
        ("steps", 0),
        ("pulse", -1),
        ("start", 4),
        ("phase", "asleep"),
        ("until", -1),
        ("hood", None),
        ("seconds", 0),
    ],
)
def test_a_forged_device_is_refused(key: str, value: object) -> None:
    rig = Rig(bench=benchfile.parse(CELL))
    rig.type("OUT 158,5\r")
    rig.run_until_waiting()
    snapshot = rig.snapshot()
    content = json.loads(snapshot.split(b"\n", 1)[1])
    forged = 0

    def forge(state: object) -> None:
        nonlocal forged
        if isinstance(state, dict):
            if key in state and "name" in state:
                state[key], forged = value, forged + 1
            for each in state.values():
                forge(each)
        elif isinstance(state, list):
            for each in state:
                forge(each)

    forge(content["state"])
    assert forged
    with pytest.raises(SnapshotError):
        rig.restore(sealed(content))
    assert rig.snapshot() == snapshot


def test_a_lamp_is_refused_whose_device_has_no_answers() -> None:
    rig = Rig(bench=benchfile.parse(CELL))
    rig.type("OUT 158,5\r")
    rig.run_until_waiting()
    content = json.loads(rig.snapshot().split(b"\n", 1)[1])
    state = dict(content["state"])
    _, _, lamp = state["arm.bench.sensors"][1]
    conveyor = state["arm.bench.cell.devices"][1]
    assert lamp["device"][1] == "Machine"
    assert conveyor[1] == "Conveyor"
    lamp["device"] = conveyor
    with pytest.raises(SnapshotError, match="another kind of value"):
        rig.restore(sealed(content))
