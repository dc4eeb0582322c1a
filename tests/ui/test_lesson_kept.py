"""Positions that were taught are not lost: leaving asks, and a bad end leaves a program of them."""

from __future__ import annotations

from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text
from tests.ui.sitting import Opener
from trs80arm.desk.recovery import Recovery
from trs80arm.desk.session import Session
from trs80arm.desk.teach import Lesson
from trs80arm.ui.screens.dialog import Ask
from trs80arm.ui.screens.pendant import PendantScreen


@piloted
async def test_leaving_asks_when_no_program_of_the_positions_is_written(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await sitting.press("ctrl+t", "f10")
        await sitting.settle()
        assert isinstance(sitting.app.screen, Ask)
        assert "Positions were taught" in screen_text(sitting.app)
        await sitting.press("enter")
        await sitting.settle()
        assert isinstance(sitting.app.screen, PendantScreen)


@piloted
async def test_positions_given_up_leave_no_copy(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await sitting.press("ctrl+t")
        sitting.app.recovery.keep()
        assert sitting.app.recovery.lesson_copy.is_file()
        await sitting.press("f10", "right", "enter")
        await sitting.pilot.pause()
    assert sitting.app.return_value == 0
    assert not sitting.app.recovery.lesson_copy.exists()


@piloted
async def test_a_bad_end_leaves_a_program_of_the_positions(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await sitting.press("ctrl+t", "ctrl+c", "ctrl+c")
        await sitting.pilot.pause()
    kept = sitting.app.recovery.lesson_copy
    assert "@READ K1" in kept.read_text()
    assert sitting.app.recovery.left_over() == []
    # The process would end here.
    sitting.app.recovery.let_go()
    later = Recovery(Session(), Lesson(), kept.parent, "20990101-000000", lambda *_, **__: None)
    assert later.left_over() == [kept]


@piloted
async def test_positions_loaded_into_the_machine_are_safe_with_its_program(
    sit_down: Opener,
) -> None:
    async with sit_down() as sitting:
        await sitting.press("ctrl+t", "f12")
        await sitting.settle()
        await sitting.press("l")
        await sitting.settle()
        await sitting.press("l")
        await sitting.settle()
        assert not sitting.app.lesson.unwritten
        assert sitting.app.session.unsaved


@piloted
async def test_the_arm_is_moved_by_hand_and_says_why_not(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await sitting.press("ctrl+g")
        await sitting.press("right")
        await sitting.settle()
        assert round(sitting.app.session.rig.state.angles.base, 3) == 0.017
        await sitting.press("escape")
        await sitting.type_line("@STEP 50,10")
        await sitting.press("ctrl+g", "right")
        await sitting.settle()
        assert "@RESET turns them off" in screen_text(sitting.app)
        assert round(sitting.app.session.rig.state.angles.base * 937.8) == 26
