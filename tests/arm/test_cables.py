"""Cables and geometry: Figures 1 to 4 and the couplings of the joints."""

from __future__ import annotations

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from trs80arm.arm import Bench, JointAngles, MiniMover, OutOfReach, Pose
from trs80arm.arm.geometry import (
    forward,
    inverse,
    pose_of,
)
from trs80arm.arm.models import MINIMOVER5
from trs80arm.arm.stepping import PulseGenerator, delay_period

BASE_SHOULDER_STEPS, _, ELBOW_STEPS, WRIST_STEPS, _, HAND_STEPS = (
    drive.steps for drive in MINIMOVER5.drives
)
EASY = delay_period(200)


@pytest.fixture
def arm() -> MiniMover:
    arm = MiniMover(bench=Bench("empty"))
    arm.move_joints(JointAngles(0.1, 1.0, -0.5, -0.8, 0.2))
    arm.move_joint("hand", 1.5)
    return arm


@pytest.fixture
def generator(arm: MiniMover) -> PulseGenerator:
    generator = PulseGenerator(arm)
    generator.align()
    return generator


def turned(arm: MiniMover, before: JointAngles) -> tuple[float, ...]:
    now = arm.state().angles
    return (
        now.base - before.base,
        now.shoulder - before.shoulder,
        now.elbow - before.elbow,
        now.pitch - before.pitch,
        now.roll - before.roll,
    )


@pytest.mark.parametrize(
    ("motor", "change"),
    [
        (0, (40 / BASE_SHOULDER_STEPS, 0, 0, 0, 0)),
        (1, (0, -40 / BASE_SHOULDER_STEPS, 0, 0, 0)),
        (2, (0, 0, 40 / ELBOW_STEPS, 0, 0)),
        (3, (0, 0, 0, -20 / WRIST_STEPS, -20 / WRIST_STEPS)),
        (4, (0, 0, 0, 20 / WRIST_STEPS, -20 / WRIST_STEPS)),
        (5, (0, 0, 0, 0, 0)),
    ],
)
def test_a_positive_count_turns_one_joint(
    arm: MiniMover, generator: PulseGenerator, motor: int, change: tuple[float, ...]
) -> None:
    before = arm.state().angles
    generator.turn(motor, 40, EASY)
    assert turned(arm, before) == pytest.approx(change, abs=1e-12)


def test_shoulder_move_keeps_the_forearm_angle(arm: MiniMover, generator: PulseGenerator) -> None:
    # "changing the shoulder angle results in an equal change in the elbow angle ... the elbow
    # drive, in effect, controls the angle of the forearm with respect to the horizontal"
    before = arm.state().angles
    generator.turn(1, 60, EASY)
    after = arm.state().angles
    assert after.elbow == before.elbow
    bend = (after.elbow - after.shoulder) - (before.elbow - before.shoulder)
    assert bend == pytest.approx(before.shoulder - after.shoulder)


def test_shoulder_and_elbow_moves_keep_the_hand_level(
    arm: MiniMover, generator: PulseGenerator
) -> None:
    # "the wrist drives control the angle of the hand with respect to the horizontal (pitch)"
    before = arm.state().angles
    generator.step((0, 50, 70), EASY)
    after = arm.state().angles
    assert (after.pitch, after.roll) == (before.pitch, before.roll)


def test_pitch_is_the_average_of_the_wrist_gears() -> None:
    # "the pitch angle P equals the average of the positions of the left and right gears"
    angles = JointAngles(0, 1, 0, 0.3, 0.5)
    assert (angles.left_gear + angles.right_gear) / 2 == pytest.approx(angles.pitch)
    assert (angles.left_gear - angles.right_gear) / 2 == pytest.approx(angles.roll)


def test_both_gears_one_way_roll_and_against_each_other_pitch(
    arm: MiniMover, generator: PulseGenerator
) -> None:
    before = arm.state().angles
    generator.step((0, 0, 0, -30, 30), EASY)
    assert turned(arm, before) == pytest.approx((0, 0, 0, 30 / WRIST_STEPS, 0), abs=1e-12)
    before = arm.state().angles
    generator.step((0, 0, 0, -30, -30), EASY)
    assert turned(arm, before) == pytest.approx((0, 0, 0, 0, 30 / WRIST_STEPS), abs=1e-12)


def test_elbow_bend_opens_the_hand(arm: MiniMover, generator: PulseGenerator) -> None:
    # "This drive interacts with joint 3 (elbow) in that elbow bend will cause the hand to open
    # slightly."
    before = arm.state().pose.opening
    generator.turn(2, 100, EASY)
    assert arm.state().pose.opening - before == pytest.approx(100 / HAND_STEPS)


def test_closing_the_hand_as_many_steps_compensates(
    arm: MiniMover, generator: PulseGenerator
) -> None:
    # "This can be compensated for by closing the hand exactly the same number of steps that the
    # elbow is raised."
    before = arm.state().pose.opening
    generator.turn(2, 100, EASY)
    generator.turn(5, -100, EASY)
    assert arm.state().pose.opening == pytest.approx(before)
    generator.step((0, 0, -150), EASY)
    assert arm.state().pose.opening == pytest.approx(before)


def test_forearm_limits_are_measured_from_the_upper_arm() -> None:
    # "the limits of forearm motion are measured with respect to the upper arm, not the
    # horizontal (x-y) plane": lowering the upper arm alone runs into them.
    arm = MiniMover(bench=Bench("empty"))
    arm.move_joints(JointAngles(0.0, math.radians(40), math.radians(30), 0.0, 0.0))
    generator = PulseGenerator(arm)
    generator.align()
    generator.turn(1, 300, EASY)
    angles = arm.state().angles
    assert arm.state().slipped[1] != 0
    assert angles.elbow == pytest.approx(math.radians(30), abs=1e-3)
    assert 0 <= angles.shoulder - angles.elbow < math.radians(0.4)


def test_the_start_is_table_4s_initialization_point() -> None:
    pose = MiniMover().state().pose
    assert (pose.x, pose.y, pose.pitch, pose.roll) == pytest.approx((5, 0, -90, 0))
    assert pose.z == pytest.approx(0, abs=1e-9)
    assert pose.opening == 0


@pytest.mark.parametrize(
    ("place", "degrees"),
    [
        ((5, 0, 0, -90, 0), (0, 18.35, -103.58, -90, -90)),
        ((8, 0, 1.5, -90, 0), (0, 31.02, -73.39, -90, -90)),
        ((8, 0, 0.5, -90, 0), (0, 22.92, -77.19, -90, -90)),
        ((6, 5, 1.5, -90, 90), (39.81, 31.47, -74.76, 39.81, -219.81)),
        ((6, 5, 0.5, -90, 90), (39.81, 23.25, -78.64, 39.81, -219.81)),
    ],
)
def test_inverse_gives_table_4s_angles(
    place: tuple[float, ...], degrees: tuple[float, ...]
) -> None:
    # The fact sheet's worked values for the article's data lines.
    a = inverse(MINIMOVER5, *place)
    found = (a.base, a.shoulder, a.elbow, a.left_gear, a.right_gear)
    assert [math.degrees(value) for value in found] == pytest.approx(degrees, abs=0.006)


@pytest.mark.parametrize(
    "place",
    [
        (0.1, 0.1, 5, 0, 0),
        (-1, 5, 3, -90, 0),
        (3, 0, 5, 0, 0),
        (18, 0, 8, 0, 0),
        (8, 0, 1, -90, 200),
        (4, 0, 8, 0, 0),
    ],
)
def test_inverse_refuses_what_the_subroutine_refuses(place: tuple[float, ...]) -> None:
    with pytest.raises(OutOfReach):
        inverse(MINIMOVER5, *place)


@settings(max_examples=200, deadline=None)
@given(
    st.floats(0.5, 16),
    st.floats(-14, 14),
    st.floats(-3, 20),
    st.floats(-90, 90),
    st.floats(-90, 90),
)
def test_forward_undoes_inverse(x: float, y: float, z: float, pitch: float, roll: float) -> None:
    try:
        angles = inverse(MINIMOVER5, x, y, z, pitch, roll)
    except OutOfReach:
        return
    pose = pose_of(MINIMOVER5, angles, 1.0)
    assert (pose.x, pose.y, pose.z) == pytest.approx((x, y, z), abs=1e-6)
    assert (pose.pitch, pose.roll) == pytest.approx((pitch, roll), abs=1e-6)


def test_with_roll_zero_the_fingers_lie_side_by_side() -> None:
    across = forward(MINIMOVER5, JointAngles(0.0, 0.5, -0.5, 0.0, 0.0)).across
    assert across == pytest.approx((0, 1, 0))
    rolled = forward(MINIMOVER5, JointAngles(0.0, 0.5, -0.5, 0.0, math.pi / 2)).across
    assert rolled == pytest.approx((0, 0, 1), abs=1e-12)


def test_a_part_keeps_its_turn_when_only_the_base_turns_and_roll_is_kept() -> None:
    # R1 = 1, "flag for world coordinates"
    for y in (-4.0, 0.0, 5.0):
        across = forward(MINIMOVER5, inverse(MINIMOVER5, 6, y, 2, -90, 30)).across
        assert across == pytest.approx((0.5, math.sqrt(0.75), 0), abs=1e-9)


def test_resolution_is_the_articles() -> None:
    # "Resolution .013 in (0.3) maximum on all axes": the forearm's end, one half-step.
    assert pytest.approx(0.013, abs=0.0005) == 7 / ELBOW_STEPS


def test_pose_is_a_plain_value() -> None:
    assert Pose(1, 2, 3, 4, 5) == Pose(1, 2, 3, 4, 5, 0.0)
