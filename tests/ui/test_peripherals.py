"""Recorder and printer on the screen: by keyboard, by mouse, in the status line."""

from __future__ import annotations

import pytest

from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text
from tests.ui.sitting import Opener


@pytest.mark.parametrize(("width", "height"), [(80, 24), (120, 40)])
@piloted
async def test_a_cassette_is_put_in_recorded_and_taken_out_by_keyboard(
    sit_down: Opener, width: int, height: int
) -> None:
    async with sit_down(width, height, turbo=False) as sitting:
        await sitting.app.run_action("do('show_tapes')")
        await sitting.settle()
        assert "no cassette" in screen_text(sitting.app)
        await sitting.press("ctrl+f", "enter")
        await sitting.settle()
        assert "A new cassette" in screen_text(sitting.app)
        await sitting.press("enter")
        await sitting.settle()
        assert "> TAPE1" in screen_text(sitting.app)
        sitting.app.session.rig.load_text("10 REM " + "X" * 200)
        sitting.app.session.rig.type('CSAVE "A"\r')
        await sitting.pass_time(5)
        sitting.wall.now += 10
        await sitting.settle()
        text = screen_text(sitting.app)
        assert "CSAVE on TAPE1" in text
        assert "====" in text
        assert "cassette TAPE1  0:0" in text
        await sitting.pass_time(6)
        assert "> TAPE1  program A" in screen_text(sitting.app)
        await sitting.press("ctrl+f", "end", "enter")
        await sitting.settle()
        assert "cassette TAPE1" not in screen_text(sitting.app)


@piloted
async def test_a_tape_goes_flat_out_and_then_the_speed_is_what_it_was(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        rig = sitting.app.session.rig
        rig.load_text("10 REM " + "X" * 200)
        rig.type('CSAVE "A"\r')
        await sitting.pass_time(2)
        assert not rig.tape.running
        assert rig.tape.length > 400
        assert not sitting.app.pacer.turbo
        assert rig.time > 7


@piloted
async def test_paper_is_looked_through_and_torn_off(sit_down: Opener) -> None:
    async with sit_down(80, 24) as sitting:
        await sitting.type_line('FOR I=1 TO 30:LPRINT "LINE";I:NEXT')
        await sitting.app.run_action("do('show_paper')")
        await sitting.settle()
        assert "LINE 30" in screen_text(sitting.app)
        await sitting.press("pageup", "pageup")
        await sitting.settle()
        text = screen_text(sitting.app)
        assert "LINE 20" in text
        assert "LINE 30" not in text
        await sitting.press("pagedown", "pagedown", "pagedown")
        await sitting.settle()
        assert "LINE 30" in screen_text(sitting.app)
        await sitting.pilot.click("#paper")
        await sitting.settle()
        assert "Tear off" in screen_text(sitting.app)
        await sitting.press("down", "enter")
        await sitting.settle()
        await sitting.press("right", "enter")
        await sitting.settle()
        assert "nothing printed yet" in screen_text(sitting.app)


@piloted
async def test_a_click_on_the_tapes_opens_the_shelf(sit_down: Opener) -> None:
    async with sit_down(120, 40) as sitting:
        await sitting.app.run_action("do('show_tapes')")
        await sitting.settle()
        await sitting.pilot.click("#tapes")
        await sitting.settle()
        assert "Insert a new one" in screen_text(sitting.app)
