"""The operator moves the arm by hand: only with the motors off, and not through things."""

from __future__ import annotations

import math

import pytest

from trs80arm.arm import Bench, InTheWay, MiniMover, MotorsOn, OutOfReach, Pose
from trs80arm.arm.motors import PHASES
from trs80arm.arm.stepping import PulseGenerator, delay_period

EASY = delay_period(200)


@pytest.fixture
def arm() -> MiniMover:
    return MiniMover(bench=Bench("empty"))


def test_set_arm_to_the_following_position(arm: MiniMover) -> None:
    # "SET ARM TO THE FOLLOWING POSITION & ORIENTATION" (Table 4, line 150)
    wanted = Pose(8.0, 2.0, 1.5, -80.0, 30.0, 1.25)
    arm.move_to(wanted)
    pose = arm.state().pose
    for name in ("x", "y", "z"):
        assert getattr(pose, name) == pytest.approx(getattr(wanted, name), abs=0.02)
    assert (pose.pitch, pose.roll) == pytest.approx((-80, 30), abs=0.3)
    assert pose.opening == pytest.approx(1.25, abs=0.001)


def test_with_the_motors_on_the_arm_cannot_be_moved(arm: MiniMover) -> None:
    PulseGenerator(arm).turn(5, 8, EASY)
    with pytest.raises(MotorsOn):
        arm.move_to(Pose(8, 0, 2, -90, 0))
    with pytest.raises(MotorsOn):
        arm.move_joint("base", 10)


def test_turning_off_the_motors_allows_it_to_be_moved_about(arm: MiniMover) -> None:
    # "Turning off the motors in this way allows the manipulator to be backdriven (manually
    # moved about)."
    generator = PulseGenerator(arm)
    generator.turn(5, 8, EASY)
    generator.off()
    arm.move_joint("base", 10)
    assert math.degrees(arm.state().angles.base) == pytest.approx(10, abs=0.05)


def test_switching_on_pulls_each_rotor_to_the_nearest_step(arm: MiniMover) -> None:
    arm.move_joints(arm.state().angles)
    for time, turned in enumerate(range(-9, 10)):
        arm.apply([100_000 * time], [0], [0])
        angles = arm.state().angles
        arm.move_joint("base", math.degrees(turned / 937.8))
        assert arm.rotors[0] == turned
        arm.apply([100_000 * time + 1], [0], [PHASES[0]])
        if turned % 8 == 4:
            assert arm.rotors[0] == turned, "the dead point pulls no way"
        else:
            assert arm.rotors[0] == 8 * round(turned / 8)
        assert arm.state().slipped[0] == 0
        assert arm.state().angles.elbow == angles.elbow


@pytest.mark.parametrize(
    ("joint", "value"),
    [("base", 91), ("shoulder", 146), ("elbow", 60), ("pitch", 40), ("hand", 3.2), ("hand", -1)],
)
def test_joints_do_not_go_beyond_their_stops(arm: MiniMover, joint: str, value: float) -> None:
    before = arm.state()
    with pytest.raises(ValueError):
        arm.move_joint(joint, value)
    assert arm.state() == before


@pytest.mark.parametrize("value", [math.nan, math.inf])
def test_nowhere_is_no_place(arm: MiniMover, value: float) -> None:
    with pytest.raises(ValueError, match="nowhere"):
        arm.move_joint("base", value)
    with pytest.raises(ValueError):
        arm.move_to(Pose(8, 0, value, -90, 0))


def test_an_unknown_joint_is_named(arm: MiniMover) -> None:
    with pytest.raises(ValueError, match="knee"):
        arm.move_joint("knee", 3)


def test_out_of_reach_is_said(arm: MiniMover) -> None:
    with pytest.raises(OutOfReach):
        arm.move_to(Pose(20, 0, 2, -90, 0))


def test_the_arm_is_not_put_into_table_or_parts() -> None:
    arm = MiniMover()
    before = arm.state()
    with pytest.raises(InTheWay, match="table"):
        arm.move_to(Pose(8, 3, -1, -90, 0))
    with pytest.raises(InTheWay, match="block"):
        arm.move_to(Pose(8, 0, 0.5, -90, 0))
    assert arm.state() == before


def test_a_held_part_is_carried_along(arm: MiniMover) -> None:
    arm = MiniMover()
    arm.move_to(Pose(8, 0, 0.5, -90, 0, 1))
    generator = PulseGenerator(arm)
    generator.align()
    generator.close(EASY, 30)
    generator.off()
    arm.move_to(Pose(6, 4, 3.5, -90, 0, 0.4))
    assert arm.state().held == "block"
    center = arm.bench.parts["block"].place
    assert center == pytest.approx((6, 4, 3.5), abs=0.05)


@pytest.mark.parametrize("direction", [1, -1])
def test_energising_pulls_a_rotor_up_to_four_half_steps_and_five_by_the_registers(
    direction: int,
) -> None:
    worst, pulled = 0, 0
    for by in range(8):
        generator = PulseGenerator(MiniMover(bench=Bench("empty")))
        generator.turn(0, 8, delay_period(100))
        generator.off()
        arm = generator.arm
        steps = arm.model.drives[0].steps
        before = arm.state().angles.base + by / steps
        arm.move_joint("base", math.degrees(before))
        began = arm.rotors[0]
        generator.turn(0, direction, delay_period(100))
        first = arm.rotors[0] - began
        generator.turn(0, direction, delay_period(100))
        pulled = max(pulled, abs(first))
        worst = max(worst, abs(arm.rotors[0] - began - 2 * direction))
    assert (pulled, worst) == (3, 5)
