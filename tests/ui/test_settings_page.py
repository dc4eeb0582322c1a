"""The page of settings on the screen: searched, changed, saved on demand."""

from __future__ import annotations

import tomllib
from pathlib import Path

from textual.widgets import Input, OptionList

from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text
from tests.ui.sitting import Opener, Sitting
from trs80arm.options import Speed
from trs80arm.ui.screens.dialog import Choose
from trs80arm.ui.screens.settings import AskValue, SettingsScreen


async def open_at(sitting: Sitting, words: str) -> None:
    await sitting.app.run_action("do('settings')")
    await sitting.settle()
    assert isinstance(sitting.app.screen, SettingsScreen)
    sitting.app.screen.query_one(Input).value = words
    await sitting.settle()


@piloted
async def test_every_setting_is_shown_with_its_meaning_and_default(sit_down: Opener) -> None:
    async with sit_down(120, 40) as sitting:
        await open_at(sitting, "terminal.fps")
        text = screen_text(sitting.app)
        assert "terminal.fps, by default 30. From the next start on." in text
        assert "The most frames a second" in text


@piloted
async def test_a_choice_is_made_from_a_list_and_seen_at_once(sit_down: Opener) -> None:
    async with sit_down(120, 40) as sitting:
        await open_at(sitting, "terminal.speed")
        await sitting.press("enter")
        await sitting.settle()
        assert isinstance(sitting.app.screen, Choose)
        sitting.app.screen.query_one(OptionList).highlighted = list(Speed).index(Speed.FIVE)
        await sitting.press("enter")
        await sitting.settle()
        assert sitting.app.pacer.speed == 5
        assert "* terminal.speed" in screen_text(sitting.app)


@piloted
async def test_a_value_is_typed_refused_with_a_reason_and_saved_when_asked(
    sit_down: Opener, tmp_path: Path
) -> None:
    file = tmp_path / "settings.toml"
    async with sit_down(120, 40, settings_file=file) as sitting:
        await open_at(sitting, "terminal.fps")
        for value, said in (("600", "fps must be 1 to 60"), ("50", "Ctrl+S saves it")):
            await sitting.press("enter")
            await sitting.settle()
            assert isinstance(sitting.app.screen, AskValue)
            sitting.app.screen.query_one(Input).value = value
            await sitting.press("enter")
            await sitting.settle()
            assert said in screen_text(sitting.app)
        assert not file.exists()
        await sitting.press("ctrl+s")
        await sitting.settle()
        assert tomllib.loads(file.read_text()) == {"terminal": {"fps": 50}}


@piloted
async def test_a_default_comes_back_and_is_taken_out_of_the_file(
    sit_down: Opener, tmp_path: Path
) -> None:
    file = tmp_path / "settings.toml"
    file.write_text("# mine\n[terminal]\nfps = 20\ntap_ms = 90\n")
    async with sit_down(120, 40, settings_file=file, fps=20) as sitting:
        await open_at(sitting, "terminal.fps")
        await sitting.press("ctrl+x", "ctrl+s")
        await sitting.settle()
        assert file.read_text() == "# mine\n[terminal]\ntap_ms = 90\n"


@piloted
async def test_arrows_mark_another_one_while_one_searches(sit_down: Opener) -> None:
    async with sit_down(120, 40) as sitting:
        await open_at(sitting, "base_")
        options = sitting.app.screen.query_one(OptionList)
        before = options.highlighted
        await sitting.press("down")
        await sitting.settle()
        assert options.highlighted == (before or 0) + 1
