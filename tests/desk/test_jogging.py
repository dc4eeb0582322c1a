"""Jogs lead where they should, in straight lines, for every arm, and say where they end."""

from __future__ import annotations

import itertools
import math

import pytest

from trs80arm.arm.minimover import MiniMover
from trs80arm.arm.models import MODELS
from trs80arm.arm.settings import ArmSettings
from trs80arm.desk.jogging import (
    LONGEST_PIECE,
    STEP_SIZES,
    Coordinates,
    Jogger,
    Stance,
    StepSize,
)
from trs80arm.rig import Counts, Pose

FORWARD, LEFT, UP = (1, 0, 0, 0, 0, 0), (0, 1, 0, 0, 0, 0), (0, 0, 1, 0, 0, 0)
DOWN, BACK = (0, 0, -1, 0, 0, 0), (-1, 0, 0, 0, 0, 0)
INCH = StepSize(100, 1.0, 10.0)
ROUNDING = 0.02
"""Inches: the arm's resolution is .013 on each axis."""


def standing(model: str = "minimover5", pose: Pose | None = None) -> Stance:
    arm = MiniMover(ArmSettings(model=model))
    registers: Counts = (0, 0, 0, 0, 0, 0)
    stance = Stance(arm.model, arm.drive, registers, registers)
    return stance if pose is None else stance.after(stance.steps_to(pose))


def jogged(
    stance: Stance, coordinates: Coordinates, *presses: tuple[int, ...], size: StepSize = INCH
) -> list[Stance]:
    """Every stance on the way of some presses."""
    jogger, way = Jogger(), [stance]
    for ways in presses:
        for piece in jogger.plan(way[-1], coordinates, ways, size).pieces:
            way.append(way[-1].after(piece))
    return way


ABOVE = Pose(8.0, 2.0, 3.0, -60.0, 20.0, 1.0)


@pytest.mark.parametrize("model", sorted(MODELS))
@pytest.mark.parametrize(
    ("ways", "moved"),
    [
        (FORWARD, (1, 0, 0, 0, 0, 0)),
        (LEFT, (0, 1, 0, 0, 0, 0)),
        (UP, (0, 0, 1, 0, 0, 0)),
        ((0, 0, 0, 1, 0, 0), (0, 0, 0, 10, 0, 0)),
        ((0, 0, 0, 0, -1, 0), (0, 0, 0, 0, -10, 0)),
        ((1, -1, 0, 0, 0, 1), (1, -1, 0, 0, 0, 1)),
    ],
)
def test_a_jog_in_the_world_moves_what_it_says_and_nothing_else(
    model: str, ways: tuple[int, ...], moved: tuple[float, ...]
) -> None:
    start = standing(model, ABOVE)
    end = jogged(start, Coordinates.WORLD, ways)[-1]
    before, after = start.pose, end.pose
    assert after.x - before.x == pytest.approx(moved[0], abs=ROUNDING)
    assert after.y - before.y == pytest.approx(moved[1], abs=ROUNDING)
    assert after.z - before.z == pytest.approx(moved[2], abs=ROUNDING)
    assert after.pitch - before.pitch == pytest.approx(moved[3], abs=0.4)
    assert after.roll - before.roll == pytest.approx(moved[4], abs=0.4)
    assert after.opening - before.opening == pytest.approx(moved[5], abs=0.01)


def test_the_fingertip_keeps_to_the_line_in_small_pieces() -> None:
    way = jogged(standing(pose=ABOVE), Coordinates.WORLD, *[LEFT] * 5)
    for one, next_one in itertools.pairwise(way):
        assert math.dist(place(one), place(next_one)) < LONGEST_PIECE + 2 * ROUNDING
    for stance in way:
        assert stance.pose.x == pytest.approx(8.0, abs=ROUNDING)
        assert stance.pose.z == pytest.approx(3.0, abs=ROUNDING)


def test_what_rounding_takes_from_one_press_the_next_one_has() -> None:
    fine = STEP_SIZES[0]
    presses = 150
    end = jogged(standing(pose=ABOVE), Coordinates.WORLD, *[BACK] * presses, size=fine)[-1]
    assert end.pose.x == pytest.approx(8.0 - presses * fine.inches, abs=ROUNDING)
    assert end.pose.y == pytest.approx(2.0, abs=ROUNDING)
    assert end.pose.pitch == pytest.approx(-60.0, abs=0.4)


def test_out_and_back_is_where_it_began_to_the_step() -> None:
    presses = [FORWARD, UP, LEFT, DOWN, BACK, (0, -1, 0, 0, 0, 0)]
    way = jogged(standing(pose=ABOVE), Coordinates.WORLD, *presses)
    assert way[-1].registers == way[0].registers


def test_in_tool_coordinates_the_hand_goes_along_itself() -> None:
    start = standing(pose=Pose(8.0, 0.0, 4.0, -45.0, 0.0, 1.0))
    end = jogged(start, Coordinates.TOOL, FORWARD)[-1].pose
    assert end.x - 8.0 == pytest.approx(math.sqrt(0.5), abs=ROUNDING)
    assert end.z - 4.0 == pytest.approx(-math.sqrt(0.5), abs=ROUNDING)
    off_its_back = jogged(start, Coordinates.TOOL, UP)[-1].pose
    assert off_its_back.x - 8.0 == pytest.approx(math.sqrt(0.5), abs=ROUNDING)
    assert off_its_back.z - 4.0 == pytest.approx(math.sqrt(0.5), abs=ROUNDING)
    to_its_left = jogged(start, Coordinates.TOOL, LEFT)[-1].pose
    assert to_its_left.y == pytest.approx(1.0, abs=ROUNDING)


def test_joints_go_by_half_steps_alone() -> None:
    [_, end] = jogged(standing(), Coordinates.JOINT, (1, -1, 0, 0, 0, 0))
    assert end.registers == (100, -100, 0, 0, 0, 0)


def test_a_line_ends_where_the_reach_ends_and_says_why() -> None:
    stance, jogger = standing(pose=Pose(12.0, 0.0, 6.0, 0.0, 0.0, 0.0)), Jogger()
    while not (plan := jogger.plan(stance, Coordinates.WORLD, FORWARD, INCH)).problem:
        for piece in plan.pieces:
            stance = stance.after(piece)
    for piece in plan.pieces:
        stance = stance.after(piece)
    assert "farther from the shoulder than the two links are long" in plan.problem
    assert 17.2 < stance.pose.x < 17.35


def test_the_table_is_said_to_be_in_the_way() -> None:
    plan = Jogger().plan(standing(), Coordinates.WORLD, DOWN, INCH)
    assert "below the table" in plan.problem


def test_a_joint_goes_as_far_as_it_can() -> None:
    start = standing(pose=Pose(0.5, 9.0, 3.0, -90.0, 0.0, 0.0))
    plan = Jogger().plan(start, Coordinates.JOINT, FORWARD, StepSize(100, 1.0, 10.0))
    [piece] = plan.pieces
    assert 25 <= piece[0] < 100
    assert plan.problem == "beyond the stop: base +-90"


@pytest.mark.parametrize(("model", "half_pound"), [("minimover5", 26), ("teachmover", 16)])
def test_the_hand_closes_in_looks_at_its_switch_and_no_farther_than_it_can(
    model: str, half_pound: int
) -> None:
    start = standing(model, Pose(8.0, 0.0, 3.0, -90.0, 0.0, 0.2))
    closing = (0, 0, 0, 0, 0, -1)
    plan = Jogger().plan(start, Coordinates.WORLD, closing, INCH)
    assert plan.closes
    assert {-piece[5] for piece in plan.pieces[:-1]} == {half_pound}
    assert 0 < -plan.pieces[-1][5] <= half_pound
    hand = start.model.hand
    assert sum(piece[5] for piece in plan.pieces) == pytest.approx(
        -(0.2 * start.model.hand_steps + hand.switch_steps), abs=0.5
    )


def test_the_hand_opens_as_far_as_it_goes() -> None:
    wide = standing(pose=Pose(8.0, 0.0, 3.0, -90.0, 0.0, 2.9))
    opened = jogged(wide, Coordinates.WORLD, (0, 0, 0, 0, 0, 1), size=StepSize(9, 0.5, 5))[-1]
    assert 2.9 < opened.pose.opening <= 3.0


def place(stance: Stance) -> tuple[float, float, float]:
    return stance.pose.x, stance.pose.y, stance.pose.z
