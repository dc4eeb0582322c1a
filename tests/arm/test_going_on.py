"""What goes on without being looked at: motions past things, and a grip that tightens."""

from __future__ import annotations

import random

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from trs80arm.arm import MiniMover, benchfile
from trs80arm.arm.course import Course
from trs80arm.arm.geometry import inverse
from trs80arm.arm.linkage import ArmLinkage
from trs80arm.arm.model import Motor
from trs80arm.arm.models import MODELS
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.stepping import SWITCH_CLOSED, PulseGenerator, delay_period
from trs80arm.arm.sweep import Ranges

USUAL, SLOW = delay_period(50), delay_period(100)

CELL = """
[arm]
at = [8.0, 0.0, 1.5]
opening = 0.6
[[part]]
name = "block"
at = [8.0, 0.0]
size = [0.5, 0.5, 1.0]
weight = 2.0
"""


@pytest.fixture
def generator() -> PulseGenerator:
    """An open hand over a block."""
    return PulseGenerator(MiniMover(bench=benchfile.parse(CELL)))


def gripping(generator: PulseGenerator, squeeze: int) -> PulseGenerator:
    """The hand down around the block and closed on it, motors on."""
    generator.step((0, 132, -36), USUAL)
    generator.step((0, 0, 0, 0, 0, -2100), USUAL, SWITCH_CLOSED)
    generator.step((0, 0, 0, 0, 0, -squeeze), SLOW)
    return generator


@pytest.mark.parametrize("name", sorted(MODELS))
def test_a_course_has_corners_where_the_links_are(name: str) -> None:
    linkage = ArmLinkage(MODELS[name], ArmSettings(model=name))
    chance = random.Random(1)
    places = [[*(chance.uniform(-2, 2) for _ in range(5)), chance.uniform(0, 3)] for _ in range(9)]
    course = Course(linkage, np.array(places).T, ())
    for place, joints in enumerate(places):
        for index, (link, solid) in enumerate(
            zip(linkage.links(joints), linkage.solids, strict=True)
        ):
            there = [
                tuple(
                    link.place[row] + sum(link.turn[3 * row + k] * corner[k] for k in range(3))
                    for row in range(3)
                )
                for corner in solid.vertices
            ]
            (corners,), (heights,) = course.corners(index), course.heights(index)
            assert pytest.approx(np.array(there), abs=1e-12) == corners[:, place].T
            assert pytest.approx(heights[place], abs=1e-12) == corners[2, place]


def test_a_hand_comes_down_around_a_part_without_being_looked_at(
    generator: PulseGenerator,
) -> None:
    solved, scene = [], generator.arm.bench.scene
    before = scene.solved
    generator.step((0, 132, -36), USUAL)
    solved.append(scene.solved - before)
    assert solved == [0]
    assert generator.arm.bench.parts["block"].asleep


def test_places_are_clear_as_far_as_measuring_each_says() -> None:
    arm = MiniMover(bench=benchfile.parse(CELL))
    world = arm.world
    rotors = np.zeros((60, 6), dtype=np.int64)
    # Down to the block with the fingers closing: at some place one of them is in it.
    rotors[:, arm.model.latch(Motor.SHOULDER)] = np.arange(60) * 3
    rotors[:, arm.model.latch(Motor.HAND)] = -np.arange(60) * 2
    joints = np.array(
        (*arm.drive.driven(rotors.T), arm.drive.cable(rotors.T) / arm.model.hand_steps)
    )
    each = [world.around.measured(place).enough for place in joints.T.tolist()]
    assert not all(each)
    near = world.around.near(Ranges.of(joints))
    assert world.around.places_clear(joints, near) == each.index(False)


def test_a_grip_that_tightens_is_not_solved_again_and_presses_harder_with_every_step(
    generator: PulseGenerator,
) -> None:
    gripping(generator, 6)
    arm, scene = generator.arm, generator.arm.bench.scene
    assert arm.grip.part == "block"
    solved, force = scene.solved, arm.grip.force
    generator.step((0, 0, 0, 0, 0, -52), SLOW)
    assert scene.solved == solved
    assert arm.grip.force == pytest.approx(force + 1.0)
    assert scene.torques[5] == pytest.approx(16 * arm.grip.force, abs=0.7)


def test_what_lies_flat_between_the_fingers_is_taken_into_the_grip_without_being_solved_again() -> (
    None
):
    heavy = CELL.replace("weight = 2.0", "weight = 9.0")
    generator = gripping(PulseGenerator(MiniMover(bench=benchfile.parse(heavy))), 0)
    arm, scene = generator.arm, generator.arm.bench.scene
    assert scene.gripped
    assert arm.grip.part is None
    solved = scene.solved
    generator.step((0, 0, 0, 0, 0, -30), SLOW)
    assert arm.grip.part == "block"
    assert arm.grip.weight == 9.0
    assert scene.solved == solved


def test_a_grip_that_slackens_is_solved_again_when_its_friction_is_used_up(
    generator: PulseGenerator,
) -> None:
    gripping(generator, 60)
    generator.step((0, -132, 36), SLOW)
    arm, scene = generator.arm, generator.arm.bench.scene
    block = arm.bench.parts["block"]
    high, solved = block.place[2], scene.solved
    assert block.carried is not None
    generator.step((0, 0, 0, 0, 0, 30), SLOW)
    assert scene.solved == solved
    assert block.place[2] == pytest.approx(high, abs=0.01)
    generator.step((0, 0, 0, 0, 0, 60), SLOW)
    generator.wait(1)
    assert scene.solved > solved
    assert arm.grip.part is None
    assert block.place[2] == pytest.approx(0.5, abs=0.005)


def test_a_part_that_is_lifted_off_the_table_goes_on_with_the_hand_after_a_few_looks(
    generator: PulseGenerator,
) -> None:
    gripping(generator, 30)
    scene = generator.arm.bench.scene
    solved = scene.solved
    generator.step((0, -132, 36), SLOW)
    generator.step((400, -8, -13, -200, -200), USUAL)
    assert generator.arm.grip.part == "block"
    assert scene.solved - solved <= 3
    assert not any(scene.torques[:5])


CROWDED = CELL + "".join(
    f"[[part]]\nat = [{x}, {y}]\nsize = [1, 1, {z}]\nturn = {31 * y}\n"
    for x, y, z in ((7, 3, 2), (9, 6, 5), (5, -4, 7), (12, -1, 1.5), (10, -6, 3))
)


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 10**6), st.floats(0.0, 0.3))
def test_where_a_sweep_is_clear_the_arm_has_room_everywhere_on_its_way(
    seed: int, wide: float
) -> None:
    arm = MiniMover(bench=benchfile.parse(CROWDED))
    chance, around = random.Random(seed), arm.world.around
    here = [
        chance.uniform(-1.2, 1.2),
        chance.uniform(-0.2, 1.5),
        chance.uniform(-1.5, 0.0),
        chance.uniform(-2.0, 0.5),
        chance.uniform(-2.0, 0.5),
        chance.uniform(0.0, 2.0),
    ]
    ways = [chance.uniform(0.0, wide) for _ in here]
    places = [
        [at + way * chance.random() for at, way in zip(here, ways, strict=True)] for _ in range(12)
    ]
    near = around.near(Ranges.of(np.array(places).T))
    for place in places:
        assert around.measured(place, near).enough is around.measured(place).enough
        assert near or around.measured(place).enough
    one = places[0]
    if not around.near(Ranges.about(one, wide / 10)):
        other = [at + wide / 10 * chance.uniform(-1, 1) for at in one]
        assert around.measured(one).enough
        assert around.measured(other).enough


def test_ranges_are_within_themselves_and_not_within_less() -> None:
    narrow = Ranges.about((0.1, 0.2, 0.3, 0.4, 0.5, 0.6), 0.0)
    wide = Ranges.of(np.array([[0.1, 0.2, 0.3, 0.4, 0.5, 0.6], [0.2, 0.2, 0.3, 0.4, 0.4, 0.6]]).T)
    assert narrow.within(narrow)
    assert narrow.within(wide)
    assert not wide.within(narrow)


def test_a_swing_above_everything_is_seen_to_be_clear_at_once() -> None:
    arm = MiniMover(bench=benchfile.parse(CELL))
    for height, clear in ((3.0, True), (0.6, False)):
        at = inverse(arm.model, 8.0, 0.0, height, -90.0, 0.0).driven
        ways = [(base, *at[1:], 0.6) for base in (-0.8, 0.8)]
        assert (not arm.world.around.near(Ranges.of(np.array(ways).T))) is clear
