"""Sensors on hand and arm: pads feel force, the palm sees what is ahead, cables tell of strain."""

from __future__ import annotations

import math

import pytest

from tests.arm.cell.cells import arm_at, stepping_at
from tests.arm.refusals import refusal
from trs80arm.arm import Pose, benchfile
from trs80arm.arm.cell.mounted import ForceSensor, TactilePad
from trs80arm.arm.stepping import PulseGenerator, delay_period

SLOW = delay_period(100)

TIPS = """
[arm]
at = [8, 0, 0.1]
opening = 1.0
[[tactile]]
name = "left tip"
on = "left finger"
threshold = 2
bit = 1
[[tactile]]
name = "right tip"
on = "right finger"
face = "tip"
bit = 2
"""
FACES = """
[arm]
at = [8, 3, 0.5]
opening = 1.0
[selector]
bits = [0, 1]
[[tactile]]
name = "inner left"
on = "left finger"
face = "inner"
bit = 1
[[tactile]]
name = "inner right"
on = "right finger"
face = "inner"
bit = 2
[[tactile]]
name = "outer left"
on = "left finger"
face = "outer"
bit = 1
bank = 1
[[tactile]]
name = "outer right"
on = "right finger"
face = "outer"
bit = 2
bank = 1
[[tactile]]
name = "tip left"
on = "left finger"
bit = 3
[[force]]
name = "grip"
on = "grip"
threshold = 8
bit = 1
bank = 2
[[force]]
name = "shoulder"
on = "shoulder"
threshold = 3
bit = 2
bank = 2
[[part]]
name = "block"
at = [8, 3]
size = [0.5, 0.5, 1]
weight = 4
"""


def answering(generator: PulseGenerator) -> set[str]:
    return {answer.name for answer in generator.arm.answers(generator.time) if answer.given}


def force(generator: PulseGenerator, name: str) -> float:
    arm = generator.arm
    arm.advance(generator.time)
    sensor = next(each for each in arm.bench.sensors if each.name == name)
    assert isinstance(sensor, TactilePad | ForceSensor)
    return sensor.force(arm.world.seen(generator.time, None))


def test_a_fingertip_feels_the_table_by_the_second_half_step_that_presses() -> None:
    generator = stepping_at(TIPS)
    touched, steps = 0, 0
    while generator.arm.inputs(generator.time) == 0b1111:
        generator.step((0, 1), SLOW)
        generator.wait(0.05)
        steps += 1
        if not touched and generator.arm.world.torques[1]:
            touched = steps
    assert touched == 15
    assert steps - touched <= 1
    assert generator.arm.inputs(generator.time) == 0b1011


def test_what_the_tips_bear_is_what_the_shoulder_presses_with() -> None:
    generator = stepping_at(TIPS)
    generator.step((0, 30), SLOW)
    generator.wait(0.5)
    arm = generator.arm
    angles, pressed = arm.state().angles, arm.borne()[1]
    weight = arm.strength.weight(1, angles.driven, (), math.cos)
    pushed = (weight - pressed) / (7.0 * math.cos(angles.shoulder))
    tips = force(generator, "left tip") + force(generator, "right tip")
    assert tips > 8
    assert tips == pytest.approx(pushed, rel=0.1)
    assert answering(generator) == {"left tip", "right tip"}
    generator.step((0, -40), SLOW)
    assert answering(generator) == set()


def test_inner_pads_feel_what_is_squeezed_and_no_other_pad_does() -> None:
    generator = stepping_at(FACES)
    assert answering(generator) == set()
    generator.close(SLOW, 20)
    generator.wait(0.3)
    assert answering(generator) == {"inner left", "inner right", "grip"}
    squeezed = 16 * generator.arm.state().force
    assert force(generator, "inner left") == force(generator, "inner right") == squeezed
    assert force(generator, "grip") == squeezed
    generator.turn(5, 15, SLOW)
    assert "grip" not in answering(generator)
    generator.turn(5, 40, SLOW)
    assert answering(generator) == set()


def test_an_empty_hand_feels_itself() -> None:
    generator = stepping_at(FACES.replace("at = [8, 3, 0.5]", "at = [8, -3, 2]"))
    generator.close(SLOW, 60)
    assert answering(generator) == {"inner left", "inner right", "grip"}


def test_the_shoulders_cable_tells_of_a_load_and_not_of_the_arms_own_weight() -> None:
    generator = stepping_at(FACES)
    generator.close(SLOW, 40)
    assert "shoulder" not in answering(generator)
    generator.step((0, -60), SLOW)
    generator.wait(0.3)
    held = generator.arm.state()
    assert held.held == "block"
    assert force(generator, "shoulder") == pytest.approx(4 * math.cos(held.angles.shoulder), 0.01)
    assert "shoulder" in answering(generator)


def test_a_cable_tells_of_an_operators_pull() -> None:
    generator = stepping_at(FACES)
    arm = generator.arm
    arm.pull((0.0, 0.0, -10.0))
    assert "shoulder" in answering(generator)
    arm.pull(None)
    assert answering(generator) == set()


def test_an_outer_pad_feels_what_the_hand_pushes_aside() -> None:
    generator = stepping_at(FACES.replace("at = [8, 3, 0.5]", "at = [8, 1.5, 0.5]"))
    seen = set()
    for _ in range(30):
        generator.step((3,), SLOW)
        seen |= answering(generator)
    assert seen == {"outer left"}
    # Half of 4 oz rubs on the table.
    assert force(generator, "outer left") == pytest.approx(2.0, abs=0.4)
    generator.step((-30,), SLOW)
    generator.wait(0.2)
    assert answering(generator) == set()


def test_a_links_pad_feels_whatever_presses_on_the_link() -> None:
    text = """
    [arm]
    at = [9, 0, 2]
    [[tactile]]
    on = "hand"
    threshold = 0.5
    bit = 1
    [[tactile]]
    on = "forearm"
    bit = 2
    [[tactile]]
    on = "upper arm"
    bit = 3
    [[obstacle]]
    at = [9, 3]
    size = [3, 1, 12]
    """
    generator = stepping_at(text)
    assert generator.arm.inputs(generator.time) == 0b1111
    generator.step((200,), SLOW)
    assert answering(generator) == {"forearm"}
    assert generator.arm.inputs(generator.time) == 0b1011


@pytest.mark.parametrize("height", [0.5, 1.0, 2.0])
def test_the_palm_sees_a_part_or_the_table_straight_ahead_within_its_range(height: float) -> None:
    text = f"""
    [arm]
    at = [8, 0, 4]
    opening = 2.0
    [[proximity]]
    on = "palm"
    range = 2.5
    bit = 1
    [[part]]
    at = [8, 0]
    size = [1, 1, {height}]
    """
    arm = arm_at(text)
    # The palm is 1.7 in behind the fingertips.
    for x, top in ((8, height), (11, 0.0)):
        arm.move_to(Pose(x, 0, top + 0.79, -90, 0, 2.0))
        assert arm.inputs(0) == 0b1101
        arm.move_to(Pose(x, 0, top + 0.81, -90, 0, 2.0))
        assert arm.inputs(0) == 0b1111


def test_the_palm_sees_what_is_in_the_hand() -> None:
    generator = stepping_at(FACES + "[[proximity]]\non = 'palm'\nrange = 1.7\nbit = 3\nbank = 3\n")
    generator.close(SLOW, 40)
    generator.step((0, -100), SLOW)
    assert "palm" in answering(generator)


@pytest.mark.parametrize(
    ("text", "line"),
    [
        (
            "[[tactile]]\non='foot'\nbit=1",
            "tactile[1].on: expected one of upper arm, forearm, hand, left finger, right finger",
        ),
        ("[[tactile]]\non=3\nbit=1", "tactile[1].on: expected one of upper arm"),
        (
            "[[tactile]]\non='hand'\nface='tip'\nbit=1",
            "tactile[1].face: expected nothing by that name; the keys here are "
            "on, threshold, bit, bank, name",
        ),
        (
            "[[tactile]]\non='left finger'\nface='back'\nbit=1",
            "tactile[1].face: expected one of tip, inner, outer",
        ),
        (
            "[[tactile]]\non='left finger'\nthreshold=0\nbit=1",
            "tactile[1].threshold: expected a number from 0.1 to 200",
        ),
        (
            "[[tactile]]\non='left finger'\nsize=[1,1]\nbit=1",
            "tactile[1].size: expected nothing by that name; the keys here are "
            "on, face, threshold, bit, bank, name",
        ),
        ("[[proximity]]\non='wrist'\nrange=1\nbit=1", "proximity[1].on: expected one of palm"),
        (
            "[[proximity]]\non='palm'\nbit=1",
            "proximity[1].range: expected a number from 0.05 to 60",
        ),
        (
            "[[force]]\nbit=1\nthreshold=3",
            "force[1].on: expected one of base, shoulder, elbow, wrist, grip",
        ),
        ("[[force]]\non='grip'\nbit=1", "force[1].threshold: expected a number from 0.1 to 200"),
        (
            "[[force]]\non='grip'\nbit=0\nthreshold=3",
            "force[1].bit: expected a whole number from 1 to 3",
        ),
    ],
)
def test_a_sensor_of_the_arm_that_cannot_be_gets_one_line(text: str, line: str) -> None:
    assert refusal(text).startswith(f"b.toml: {line}")


def test_a_sensor_without_a_name_is_called_by_where_it_is() -> None:
    text = """
    [selector]
    bits = [0, 1]
    [[proximity]]
    on = "palm"
    range = 1
    bit = 1
    [[proximity]]
    at = [8, 0, 0]
    range = 1
    bit = 2
    [[tactile]]
    on = "right finger"
    face = "outer"
    bit = 3
    [[tactile]]
    on = "right finger"
    face = "outer"
    threshold = 10
    bit = 1
    bank = 1
    [[force]]
    on = "elbow"
    threshold = 4
    bit = 2
    bank = 1
    [[home]]
    joint = "left wrist"
    at = 0
    bit = 3
    bank = 1
    """
    assert [sensor.name for sensor in benchfile.parse(text).sensors] == [
        "palm",
        "proximity 1",
        "right finger outer",
        "right finger outer 2",
        "elbow tension",
        "left wrist home",
    ]
