from __future__ import annotations

import re
from functools import partial

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.drawing import samples
from tests.goldens import check_golden
from trs80arm.arm.geometry import JointAngles, OutOfReach
from trs80arm.arm.model import Pose
from trs80arm.arm.models import MINIMOVER5
from trs80arm.desk.taught_programs import Manner, in_data, in_steps, moves
from trs80arm.desk.teach import Lesson, listing_name, steps_between
from trs80arm.drawing.readings import Posture, Readings

REGISTER = st.integers(-32768, 32767)
SIX = st.tuples(*[REGISTER] * 6)


def standing(
    registers: tuple[int, ...], pose: Pose, *, grips: bool = False, force: float = 0.0
) -> Readings:
    j1, j2, j3, j4, j5, _ = registers
    left, right = -1.5 - j4 / 203.7, -1.5 + j5 / 203.7
    angles = JointAngles(
        j1 / 937.8, 0.3 - j2 / 937.8, -1.8 + j3 / 551.4, (left + right) / 2, (left - right) / 2
    )
    return samples.readings(
        Posture(MINIMOVER5, angles, pose.opening),
        registers=registers,
        pose=pose,
        inputs=0b1110 if grips else 0b1111,
        force=force,
    )


def pick_and_place() -> Lesson:
    """The article's task, as it would be taught: A above and at the part, B, C, D."""
    above, at = Pose(8, 0, 1.5, -90, 0, 0.55), Pose(8, 0, 0.5, -90, 0, 0.55)
    there, down = Pose(6, 5, 1.5, -90, 90, 0.5), Pose(6, 5, 0.5, -90, 90, 0.5)
    lesson = Lesson()
    lesson.add(standing((0, -207, 290, 0, 0, 340), above), "above")
    lesson.add(standing((0, -75, 254, 0, 0, 340), at))
    lesson.add(standing((0, -75, 254, 0, 0, -2), at, grips=True, force=0.702))
    lesson.add(standing((0, -207, 290, 0, 0, -2), above, grips=True, force=0.702))
    lesson.add(standing((651, -215, 277, -461, -462, -2), there, grips=True, force=0.702))
    lesson.add(standing((651, -80, 240, -461, -462, -2), down, grips=True, force=0.702))
    lesson.add(standing((651, -80, 240, -461, -462, 340), down))
    lesson.add(standing((651, -215, 277, -461, -462, 340), there))
    return lesson


def test_a_position_keeps_registers_pose_and_grip() -> None:
    position = Lesson().add(standing((1, 2, 3, 4, 5, 6), Pose(8, 0, 1, -90, 0), grips=True))
    assert position.registers == (1, 2, 3, 4, 5, 6)
    assert position.pose.x == 8
    assert position.grips


def test_the_squeeze_is_what_the_hand_closed_beyond_its_switch() -> None:
    position = Lesson().add(standing((0,) * 6, Pose(8, 0, 1, -90, 0), grips=True, force=0.702))
    assert position.squeeze == 30


def test_positions_are_named_by_free_letters() -> None:
    lesson = Lesson()
    for _ in range(3):
        lesson.add(samples.readings())
    lesson.rename(0, "pick up")
    assert lesson.add(samples.readings()).name == "A"
    assert [position.name for position in lesson.positions] == ["PICK UP", "B", "C", "A"]


@pytest.mark.parametrize(
    ("typed", "kept"), [("above it", "ABOVE IT"), ('x:"y"', "XY"), ("é", ""), (" a ", "A")]
)
def test_names_are_what_a_listing_can_hold(typed: str, kept: str) -> None:
    assert listing_name(typed) == kept


def test_an_empty_name_changes_nothing() -> None:
    lesson = Lesson()
    lesson.add(samples.readings(), "here")
    lesson.rename(0, "  ")
    assert lesson.positions[0].name == "HERE"


def test_positions_move_in_the_list_and_stop_at_its_ends() -> None:
    lesson = pick_and_place()
    assert lesson.move(0, 2) == 2
    assert lesson.positions[2].name == "ABOVE"
    assert lesson.move(2, -9) == 0
    assert lesson.move(0, 99) == 7


def test_teaching_again_keeps_name_and_place() -> None:
    lesson = pick_and_place()
    lesson.teach_again(0, standing((9,) * 6, Pose(7, 0, 1, -90, 0)))
    assert lesson.positions[0].name == "ABOVE"
    assert lesson.positions[0].registers == (9,) * 6
    assert len(lesson) == 8


def test_positions_from_another_zero_are_named() -> None:
    lesson = Lesson()
    lesson.add(samples.readings(registers=(0,) * 6))
    moved = samples.posture(10.0, 31.0, -73.4, -90.0, 0.0, 1.3)
    lesson.add(samples.readings(moved, registers=(164, 0, 0, 0, 0, 0)))
    assert lesson.strays() == []
    lesson.add(samples.readings(moved, registers=(0,) * 6))
    lesson.add(samples.readings(moved, registers=(164 - 8, 0, 0, 0, 0, 0)))
    assert lesson.strays() == ["C", "D"]


@pytest.mark.parametrize("registers", [(), (1, 2, 3), (0, 0, 0, 0, 0, 32768)])
def test_registers_are_six_words_of_sixteen_bits(registers: tuple[int, ...]) -> None:
    lesson = pick_and_place()
    with pytest.raises(ValueError, match="six numbers"):
        lesson.set_registers(0, registers)


@given(SIX, SIX)
def test_steps_lead_from_one_reading_to_the_other_as_the_registers_wrap(
    start: tuple[int, int, int, int, int, int], end: tuple[int, int, int, int, int, int]
) -> None:
    steps = steps_between(start, end)
    assert all(-32768 <= step <= 32767 for step in steps)
    reached = [(a + step + 32768) % 65536 - 32768 for a, step in zip(start, steps, strict=True)]
    assert tuple(reached) == end


def test_the_hand_takes_hold_after_arriving_and_lets_go_after_arriving() -> None:
    route = moves(pick_and_place().positions, Manner(repeats=True))
    assert [(move.closes, move.hand) for move in route] == [
        (False, 0),
        (True, -30),
        (False, 0),
        (False, 0),
        (False, 0),
        (False, 342),
        (False, 0),
        (False, 0),
    ]
    assert all(move.joints[5] == 0 for move in route)


def test_a_tighter_hold_comes_before_the_move_and_a_looser_one_after_it() -> None:
    lesson = pick_and_place()
    lesson.set_grip(2, grips=True, squeeze=0)
    lesson.set_grip(4, grips=True, squeeze=10)
    route = moves(lesson.positions, Manner(repeats=True))
    assert [(move.before, move.hand) for move in route[1:4]] == [(0, 0), (-30, 0), (0, 20)]
    steps = in_steps(lesson.positions, Manner(repeats=True))
    assert re.search(r"@STEP S,0,0,0,0,0,-30\n\d+ @STEP S,0,-132", steps)
    data = in_data(lesson.positions, Manner(repeats=True), MINIMOVER5)
    assert "DATA 8, 0, 0.5, -90, 0, 0, -30, 50\n" in data
    assert "110 DIM UU(8,11)" in data


def test_going_round_brings_every_joint_back() -> None:
    route = moves(pick_and_place().positions, Manner(repeats=True))
    assert [sum(column) for column in zip(*(move.joints[:5] for move in route), strict=True)] == (
        [0] * 5
    )


def test_going_once_ends_at_the_last_position() -> None:
    route = moves(pick_and_place().positions, Manner(repeats=False))
    assert len(route) == 7


def test_program_of_steps() -> None:
    check_golden("taught-steps", in_steps(pick_and_place().positions, Manner(repeats=True)))


def test_program_of_data_lines() -> None:
    check_golden(
        "taught-data",
        in_data(pick_and_place().positions, Manner(speed=80, repeats=True), MINIMOVER5),
    )


@pytest.mark.parametrize("write", [in_steps, partial(in_data, model=MINIMOVER5)])
def test_line_numbers_rise_and_every_jump_has_its_line(write: object) -> None:
    assert callable(write)
    listing = write(pick_and_place().positions, Manner(repeats=True))
    numbers = [int(line.split(" ", 1)[0]) for line in listing.splitlines()]
    assert numbers == sorted(set(numbers))
    jumps = re.findall(r"(?:GOTO|GOSUB|THEN) (\d+)", listing)
    assert {int(target) for target in jumps} <= set(numbers)
    assert all(len(line) < 240 for line in listing.splitlines())


def test_a_position_behind_the_base_cannot_be_given_in_coordinates() -> None:
    lesson = pick_and_place()
    lesson.add(standing((0,) * 6, Pose(-3, 2, 5, -90, 0)), "behind")
    with pytest.raises(OutOfReach, match="BEHIND"):
        in_data(lesson.positions, Manner(repeats=True), MINIMOVER5)
    assert "BEHIND" in in_steps(lesson.positions, Manner(repeats=True))


@pytest.mark.parametrize("write", [in_steps, partial(in_data, model=MINIMOVER5)])
def test_nothing_taught_is_no_program(write: object) -> None:
    assert callable(write)
    with pytest.raises(ValueError, match="no position"):
        write([], Manner(repeats=True))


def test_one_position_alone_is_gone_to() -> None:
    lesson = Lesson()
    lesson.add(standing((5, 0, 0, 0, 0, 0), Pose(8, 0, 1.5, -90, 0)))
    assert "@STEP S,5-K1,0-K2" in in_steps(lesson.positions, Manner(repeats=True))
    assert in_data(lesson.positions, Manner(repeats=True), MINIMOVER5).count("DATA") == 4
