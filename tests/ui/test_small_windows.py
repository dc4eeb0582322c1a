"""Windows in which nothing has room: nobody can work there, and nothing breaks."""

from __future__ import annotations

import pytest

from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text
from tests.ui.sitting import Opener
from trs80arm.ui.screens.dialog import Choose
from trs80arm.ui.screens.help import HelpScreen


@pytest.mark.parametrize("key", ["f8", "f2"])
@pytest.mark.parametrize("size", [(5, 24), (1, 1)])
@piloted
async def test_a_dialog_opens_in_a_window_that_is_too_small_for_it(
    sit_down: Opener, size: tuple[int, int], key: str
) -> None:
    async with sit_down() as sitting:
        await sitting.pilot.resize_terminal(*size)
        await sitting.press(key, "down", "escape")
        await sitting.settle()
        assert sitting.app.fault is None


@pytest.mark.parametrize("command", ["theme", "bench"])
@piloted
async def test_a_list_shrinks_below_the_minimum_and_comes_back(
    sit_down: Opener, command: str
) -> None:
    async with sit_down() as sitting:
        sitting.app.action_do(command)
        await sitting.settle()
        for size in ((5, 24), (2, 2), (80, 24)):
            await sitting.pilot.resize_terminal(*size)
            await sitting.settle()
        assert sitting.app.fault is None
        assert isinstance(sitting.app.screen, Choose)


@piloted
async def test_help_comes_to_rest_in_the_smallest_window(sit_down: Opener) -> None:
    async with sit_down(21, 32) as sitting:
        await sitting.press("f1", "7", "@")
        await sitting.pilot.resize_terminal(3, 2)
        await sitting.settle()
        assert isinstance(sitting.app.screen, HelpScreen)


@piloted
async def test_a_question_can_be_answered_where_its_text_fills_the_window(
    sit_down: Opener,
) -> None:
    async with sit_down(100, 30) as sitting:
        await sitting.press("ctrl+r")
        await sitting.pilot.resize_terminal(40, 12)
        await sitting.pass_time(0.5)
        # A key that comes before the dialog has its new size scrolls nothing.
        for _ in range(30):
            await sitting.press("tab")
            await sitting.pass_time(0.1)
            if "Only the parts" in screen_text(sitting.app):
                break
        assert "Only the parts" in screen_text(sitting.app)


@piloted
async def test_the_desk_comes_to_rest_behind_a_dialog_that_was_there_before(
    sit_down: Opener,
) -> None:
    async with sit_down(100, 30) as sitting:
        await sitting.press("f3", "ctrl+r")
        await sitting.pilot.resize_terminal(40, 12)
        await sitting.pass_time(0.5)
        sitting.app.session.rig.type("LLIST\r")
        await sitting.pass_time(0.5)
        assert sitting.app.fault is None
