"""Where tube and arm share the room, what has something to show gets most of it."""

from __future__ import annotations

import pytest

from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text
from tests.ui.sitting import Opener, Sitting
from trs80arm.ui.layout import Lead
from trs80arm.ui.screens.desk import STAY


def rows(sitting: Sitting) -> tuple[int, int]:
    """The rows of the tube and of the arm from the side that are seen."""
    desk = sitting.app.desk
    return desk.tube.size.height, desk.side.size.height


@piloted
async def test_at_the_prompt_the_tube_has_all_its_lines(sit_down: Opener) -> None:
    async with sit_down(80, 24) as sitting:
        assert rows(sitting)[0] == 16


@pytest.mark.parametrize("size", [(80, 24), (100, 30)])
@piloted
async def test_in_manual_mode_the_arm_has_the_room_and_the_prompt_is_seen(
    sit_down: Opener, size: tuple[int, int]
) -> None:
    async with sit_down(*size) as sitting:
        await sitting.begin_manual_mode()
        tube, arm = rows(sitting)
        assert arm >= 14
        assert tube >= 6
        assert ">@SET" in screen_text(sitting.app)


@piloted
async def test_when_the_arm_has_stood_for_a_while_the_tube_is_whole_again(sit_down: Opener) -> None:
    async with sit_down(80, 24) as sitting:
        await sitting.type_line("@STEP 50,100")
        await sitting.pass_time(0.2)
        assert sitting.app.desk.leading is Lead.ARM
        await sitting.pass_time(STAY + 1)
        assert rows(sitting)[0] == 16


@piloted
async def test_a_program_that_draws_keeps_the_tube(sit_down: Opener) -> None:
    async with sit_down(80, 24) as sitting:
        await sitting.type_line("CLS: SET(10,10)")
        await sitting.begin_manual_mode()
        assert rows(sitting)[0] == 16


@piloted
async def test_what_is_printed_elsewhere_while_the_arm_moves_is_seen(sit_down: Opener) -> None:
    async with sit_down(80, 24) as sitting:
        await sitting.begin_manual_mode()
        assert rows(sitting)[0] < 16
        for cell, letter in enumerate("UP HERE"):
            sitting.app.session.rig.memory.poke(0x3C00 + cell, ord(letter))
        await sitting.settle()
        await sitting.settle()
        assert "UP HERE" in screen_text(sitting.app)


@piloted
async def test_lines_that_scroll_up_are_not_something_new(sit_down: Opener) -> None:
    async with sit_down(80, 24) as sitting:
        sitting.app.session.rig.type(
            "10 PRINT I;:PRINT I,I,I,I,I,I,I:I=I+1:@STEP 50,10:GOTO 10\rRUN\r"
        )
        await sitting.pass_time(8)
        assert sitting.app.desk.leading is Lead.ARM
        assert rows(sitting)[0] < 16


@piloted
async def test_the_room_can_be_given_at_a_key_and_back(sit_down: Opener) -> None:
    async with sit_down(80, 24) as sitting:
        await sitting.press("ctrl+e")
        await sitting.settle()
        assert rows(sitting)[1] >= 14
        await sitting.press("ctrl+e")
        await sitting.settle()
        assert rows(sitting)[0] == 16


@pytest.mark.parametrize("size", [(80, 24), (100, 30)])
@pytest.mark.parametrize("name", ["space", "scope"])
@piloted
async def test_a_picture_that_is_asked_for_has_room_to_be_read(
    sit_down: Opener, name: str, size: tuple[int, int]
) -> None:
    async with sit_down(*size) as sitting:
        await sitting.app.run_action(f"do('show_{name}')")
        await sitting.settle()
        await sitting.settle()
        panel = sitting.app.desk.panels[name]
        assert panel.size.height >= 14
        assert panel.has_class("leading")
        assert rows(sitting)[0] >= 6
        await sitting.press("ctrl+e")
        await sitting.settle()
        assert rows(sitting)[0] == 16


@piloted
async def test_where_there_is_room_for_all_the_scope_leads_nothing(sit_down: Opener) -> None:
    async with sit_down(120, 40) as sitting:
        await sitting.app.run_action("do('show_scope')")
        await sitting.settle()
        await sitting.settle()
        assert sitting.app.desk.tube.has_class("leading")


@pytest.mark.parametrize("size", [(50, 20), (60, 60)])
@piloted
async def test_a_window_narrower_than_the_tube_follows_the_cursor(
    sit_down: Opener, size: tuple[int, int]
) -> None:
    async with sit_down(*size) as sitting:
        sitting.app.session.rig.type("A" * 40 + "B" * 20)
        sitting.app.session.rig.run_until_waiting(60)
        sitting.app.pacer.forgive()
        await sitting.settle()
        assert "B" * 20 + "_" in screen_text(sitting.app)
        assert sitting.app.desk.tube.first_column > 0
