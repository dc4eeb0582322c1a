"""Random programs on random benches: what holds of parts whatever BASIC does to them."""

from __future__ import annotations

import math
import random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.slices import elsewhere
from trs80arm import Rig
from trs80arm.arm import ArmSettings, BenchError, benchfile
from trs80arm.arm.bench import Bench, deep
from trs80arm.arm.fixtures import Part
from trs80arm.arm.models import MODELS
from trs80arm.works.devices import RigSettings

FRAME = 1 / 60
DEPTH = 0.03
"""Inches to which parts may be found in each other, or in the arm, also when something tumbles."""

SHAPES = (
    "size = [{a}, {b}, {c}]",
    "size = [3, {a}, 0.2]",
    "size = [0.3, 0.3, 2.5]",
    "shape = 'cylinder'\ndiameter = {a}\nheight = {c}",
    "shape = 'prism'\noutline = [[-{a}, -{b}], [{a}, -{b}], [0, {b}]]\nheight = {c}",
    "shape = 'tray'\nsize = [2, 2, {a}]\nwall = 0.1",
    "shape = 'holed'\nsize = [1.5, 1.5, {c}]\nhole = [0.6, 0.6]",
    "shape = 'pegs'\nsize = [2, 1.5, 0.3]\npegs = [[-0.5, 0], [0.5, 0.2]]\n"
    "peg_diameter = 0.25\npeg_height = {a}",
)


def random_bench(chance: random.Random) -> Bench:
    """The open hand low above the table, up to five things around it."""
    text = "[arm]\nat = [8, 0, 1.6]\nopening = 1.5\n"
    for _ in range(chance.randrange(1, 6)):
        a, b, c = (round(chance.uniform(0.3, 1.2), 2) for _ in range(3))
        thing = (
            f"[[part]]\nat = [{chance.uniform(6.5, 9.5):.2f}, {chance.uniform(-2, 2):.2f}]\n"
            f"bottom = {chance.choice([0, 0, 0, 1.3, 4, 9])}\nturn = {chance.randrange(360)}\n"
            f"tilt = {chance.choice([0, 0, 0, 30, 90])}\n"
            f"weight = {chance.choice([0.05, 0.5, 2, 8, 30, 100])}\n"
            f"friction = {chance.choice([0.05, 0.3, 0.5, 0.5, 1, 3])}\n"
            + chance.choice(SHAPES).format(a=a, b=b, c=c)
            + "\n"
        )
        try:
            benchfile.parse(text + thing)
        except BenchError:
            continue
        text += thing
    return benchfile.parse(text)


def random_program(chance: random.Random) -> str:
    """Down, close, squeeze, lift, swing, let go, or sweep, in some order."""
    moves = [
        "@STEP 60,0,132,-36",
        "@CLOSE 60",
        "@STEP 100,0,0,0,0,0,-30",
        "@STEP 100,0,-132,36",
        f"@STEP 60,{chance.randrange(-250, 250)}",
        f"@STEP 60,0,0,0,{chance.randrange(-60, 60)},{chance.randrange(-60, 60)}",
        "@STEP 60,0,0,0,0,0,150",
    ]
    if chance.random() < 0.5:
        chance.shuffle(moves)
    return "\n".join(f"{10 * k} {move}" for k, move in enumerate(moves, 1)) + "\n"


def machine(seed: int, model: str) -> Rig:
    chance = random.Random(seed)
    rig = Rig(RigSettings(arm=ArmSettings(model=model)), random_bench(chance))
    rig.load_text(random_program(chance))
    rig.type("RUN\r")
    return rig


def parts(rig: Rig) -> list[Part]:
    return list(rig.arm.bench.parts.values())


def assert_possible(rig: Rig) -> None:
    """Nothing is below the table, inside another or the arm, or nowhere."""
    found = parts(rig)
    rig.arm.world.show()
    links = rig.arm.world.bench.scene.link_solids
    for k, part in enumerate(found):
        assert all(math.isfinite(value) and abs(value) < 100 for value in part.place)
        assert part.bottom > -DEPTH
        assert not any(deep(a, b, DEPTH) for a in part.placed for b in links)
        for other in found[:k]:
            assert not any(deep(a, b, DEPTH) for a in part.placed for b in other.placed)
    assert rig.pose.z > -0.2


def energy(part: Part) -> float:
    """Of height and speed, inch-ounces; the spin left out."""
    return part.weight * (part.place[2] + sum(v * v for v in part.velocity) / (2 * 386.09))


@pytest.mark.parametrize("model", sorted(MODELS))
@settings(max_examples=12, deadline=None, derandomize=True)
@given(st.integers(0, 10**9))
def test_whatever_a_program_does_parts_are_where_parts_can_be(model: str, seed: int) -> None:
    rig = machine(seed, model)
    for _ in range(40):
        rig.run_for(15 * FRAME)
        assert_possible(rig)
    rig.run_until_waiting(60)
    rig.run_for(2.0)
    assert_possible(rig)
    # Nothing moves by itself, and nobody gives it any energy.
    for _ in range(10):
        before = {part.name: (part.place, part.asleep, energy(part)) for part in parts(rig)}
        rig.run_for(15 * FRAME)
        total = sum(energy(part) for part in parts(rig))
        assert total <= sum(had for _, _, had in before.values()) + 0.05
        for part in parts(rig):
            place, asleep, _ = before[part.name]
            assert not asleep or part.place == place


@pytest.mark.parametrize("model", sorted(MODELS))
@settings(max_examples=6, deadline=None, derandomize=True)
@given(st.integers(0, 10**9), st.lists(st.integers(1, 40), min_size=3, max_size=5))
def test_runs_in_pieces_and_from_snapshots_are_the_same(
    model: str, seed: int, pieces: list[int]
) -> None:
    whole, sliced = machine(seed, model), machine(seed, model)
    for piece in pieces:
        whole.run_for(5 * piece * FRAME)
        for _ in range(5):
            sliced.run_for(piece * FRAME)
        assert sliced.snapshot() == whole.snapshot()
        sliced = elsewhere(sliced)


PEGS = """
[arm]
at = [8, 0, 0.6]
opening = 1.5
[[part]]
at = [7.73, 0.95]
turn = 124
weight = 0.5
shape = "pegs"
size = [2, 1.5, 0.15]
pegs = [[-0.5, 0], [0.5, 0.2]]
peg_diameter = 0.25
peg_height = 0.48
"""


def test_a_hand_that_presses_on_what_gives_way_is_the_same_in_one_run_and_in_slices() -> None:
    whole, sliced = (Rig(bench=benchfile.parse(PEGS)) for _ in range(2))
    for rig in (whole, sliced):
        rig.load_text(
            "10 @STEP 60,0,132,-36\n20 @STEP 100,0,0,0,0,0,-118\n30 @STEP 100,0,-132,36\n"
        )
        rig.type("RUN\r")
    for _ in range(45):
        whole.run_for(5 * FRAME)
        for _ in range(5):
            sliced.run_for(FRAME)
    assert sliced.snapshot() == whole.snapshot()


def test_what_comes_to_lie_on_one_finger_weighs_from_the_start_however_the_run_is_cut() -> None:
    bench = """
    [arm]
    at = [8, 0, 0.6]
    opening = 2.5
    [[part]]
    at = [8.1, -1.39]
    bottom = 4
    turn = 215
    friction = 0.05
    weight = 100
    shape = "prism"
    outline = [[-0.57, -0.34], [0.57, -0.34], [0, 0.34]]
    height = 0.77
    """
    whole, sliced = (Rig(bench=benchfile.parse(bench)) for _ in range(2))
    for rig in (whole, sliced):
        rig.type("@STEP 100,0,0,0,0,0,-95\r")
    whole.run_for(90 * FRAME)
    for _ in range(90):
        sliced.run_for(FRAME)
    assert sliced.snapshot() == whole.snapshot()


def test_the_hand_opens_under_what_lies_on_it_alike_in_one_run_and_in_slices() -> None:
    bench = """
    [arm]
    at = [8, 0, 0.6]
    [[part]]
    at = [7.99, -0.26]
    bottom = 4
    turn = 232
    weight = 0.5
    shape = "cylinder"
    diameter = 1.11
    height = 0.46
    """
    whole, sliced = (Rig(bench=benchfile.parse(bench)) for _ in range(2))
    for rig in (whole, sliced):
        rig.load_text("10 @STEP 70,0,0,0,0,0,173\n")
        rig.type("RUN\r")
    (disc,) = parts(whole)
    assert disc.carried is not None
    for _ in range(8):
        whole.run_for(10 * FRAME)
        for _ in range(5):
            sliced.run_for(2 * FRAME)
        assert parts(sliced)[0].place == disc.place
