from __future__ import annotations

import pytest

from tests.drawing import samples
from tests.goldens import check_golden
from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text
from trs80arm.arm.models import MINIMOVER5
from trs80arm.desk.hands import MoveJoint, MoveTo
from trs80arm.drawing.readings import Readings
from trs80arm.options import ArmStyle
from trs80arm.ui.screens.hand_move import HandMoveScreen
from trs80arm.ui.themes import Themed


class Desk(Themed[None]):
    """Nothing but the dialog, and what it asked for."""

    def __init__(self) -> None:
        super().__init__()
        self.seen = samples.readings()
        self.asked: list[MoveJoint | MoveTo] = []
        self.answer = ""

    def look(self) -> Readings:
        return self.seen

    def on_mount(self) -> None:
        self.push_screen(HandMoveScreen(self.look, self.move, style=ArmStyle.OUTLINE))

    def move(self, move: MoveJoint | MoveTo) -> str:
        self.asked.append(move)
        return self.answer


@pytest.mark.parametrize("width", [80, 110])
@piloted
async def test_the_dialog_shows_arm_and_joints(width: int) -> None:
    desk = Desk()
    async with desk.run_test(size=(width, 30)) as pilot:
        await pilot.pause()
        check_golden(f"hand-move-{width}x30", screen_text(desk))


@piloted
async def test_arrows_choose_a_joint_and_turn_it() -> None:
    desk = Desk()
    async with desk.run_test(size=(80, 24)) as pilot:
        await pilot.press("right", "down", "left", "pageup", "up", "up", "right")
        joints = [(message.joint, message.value) for message in desk.asked]
        assert joints[0] == ("base", 1.0)
        assert joints[1] == ("shoulder", pytest.approx(30.0))
        assert joints[2] == ("shoulder", pytest.approx(21.0))
        assert joints[3] == ("hand", pytest.approx(1.4))


@piloted
async def test_a_typed_figure_is_a_value_for_the_joint() -> None:
    desk = Desk()
    async with desk.run_test(size=(80, 24)) as pilot:
        await pilot.press("down", "down", "-", "4", "2", "enter")
        await pilot.pause()
        assert [(message.joint, message.value) for message in desk.asked] == [("elbow", -42.0)]


@piloted
async def test_several_figures_are_a_pose_and_what_is_left_out_stays() -> None:
    desk = Desk()
    async with desk.run_test(size=(80, 24)) as pilot:
        await pilot.press(*"7", "space", *"1", "space", *"2", "enter")
        await pilot.pause()
        [asked] = desk.asked
        assert isinstance(asked, MoveTo)
        assert (asked.pose.x, asked.pose.y, asked.pose.z) == (7, 1, 2)
        assert asked.pose.opening == desk.seen.pose.opening


@piloted
async def test_home_is_where_table_4_begins() -> None:
    desk = Desk()
    async with desk.run_test(size=(80, 24)) as pilot:
        await pilot.press("home")
        assert desk.asked == [MoveTo(MINIMOVER5.start)]


@pytest.mark.parametrize("typed", ["1 2", "1 2 3 4 5 6 7"])
@piloted
async def test_other_counts_of_figures_are_refused(typed: str) -> None:
    desk = Desk()
    async with desk.run_test(size=(80, 24)) as pilot:
        keys = ["space" if key == " " else key for key in typed]
        await pilot.press(*keys, "enter")
        await pilot.pause()
        assert desk.asked == []
        assert "3 to 6 for a pose" in screen_text(desk)


@piloted
async def test_the_answer_to_a_move_is_shown() -> None:
    desk = Desk()
    async with desk.run_test(size=(80, 24)) as pilot:
        desk.answer = "block is in the way"
        await pilot.press("right")
        await pilot.pause()
        assert "block is in the way" in screen_text(desk)


@piloted
async def test_motors_that_are_on_are_said_at_once() -> None:
    desk = Desk()
    desk.seen = samples.readings(motors_on=True)
    async with desk.run_test(size=(80, 24)) as pilot:
        await pilot.pause()
        assert "@RESET turns them off" in screen_text(desk)
