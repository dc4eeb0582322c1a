"""The palette finds commands by the words that people have for them."""

from __future__ import annotations

from pathlib import Path

import pytest
from textual.command import CommandPalette

from tests.ui.piloted import piloted
from tests.ui.sitting import Opener, Sitting
from trs80arm.ui.commands.command import key_names
from trs80arm.ui.commands.palette import Palette
from trs80arm.ui.commands.table import COMMANDS


@piloted
async def test_the_palette_is_not_opened_twice_below_a_dialog(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await sitting.press("ctrl+p")
        await sitting.app.run_action("do('help')")
        await sitting.press("ctrl+p")
        await sitting.settle()
        opened = [s for s in sitting.app.screen_stack if isinstance(s, CommandPalette)]
        assert len(opened) == 1


async def found(sitting: Sitting, query: str) -> list[str]:
    palette = Palette(sitting.app.screen)
    hits = [hit async for hit in palette.search(query)]
    hits.sort(key=lambda hit: -hit.score)
    return [str(hit.text or hit.match_display) for hit in hits]


@pytest.mark.parametrize(
    ("query", "title"),
    [
        ("quit", "Leave  (F10, Ctrl+Q)"),
        ("exit", "Leave  (F10, Ctrl+Q)"),
        ("load", "Program: open  (F2, Ctrl+O)"),
        ("screenshot", "Screen: save as picture"),
        ("green", "Theme: green"),
        ("amber", "Theme: amber"),
        ("zoom", "View: arm large, and back  (F11)"),
        ("tour", "Session: demonstration"),
        ("restart", "Machine: off and on"),
        ("save file", "Program: save  (F3, Ctrl+S)"),
    ],
)
@piloted
async def test_commands_are_found_by_other_words(sit_down: Opener, query: str, title: str) -> None:
    async with sit_down() as sitting:
        assert title in (await found(sitting, query))[:4]


@piloted
async def test_every_command_is_found_by_its_title_its_other_words_and_its_keys(
    sit_down: Opener,
) -> None:
    async with sit_down() as sitting:
        shown = [hit async for hit in Palette(sitting.app.screen).discover()]
        titles = {str(hit.display) for hit in shown}
        for command in COMMANDS:
            if command.name == "palette":
                continue
            keys = key_names(command)
            title = f"{command.title}  ({', '.join(keys)})" if keys else command.title
            assert title in titles
            for words in (command.title, *command.also.split(), *keys):
                assert title in await found(sitting, words), (words, title)


@piloted
async def test_a_title_that_fits_goes_before_another_word(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        assert (await found(sitting, "Speed: flat"))[0] == "Speed: flat out"


@piloted
async def test_a_theme_is_seen_while_it_is_marked_and_remembered_when_chosen(
    sit_down: Opener, tmp_path: Path
) -> None:
    path = tmp_path / "settings.toml"
    async with sit_down(settings_file=path) as sitting:
        await sitting.app.run_action("do('theme')")
        await sitting.press("down")
        assert sitting.app.theme == "white"
        await sitting.press("escape")
        await sitting.settle()
        assert sitting.app.theme == "green"
        assert not path.exists()
        await sitting.app.run_action("do('theme')")
        await sitting.press("down", "down", "enter")
        await sitting.settle()
        assert sitting.app.theme == "amber"
        assert 'theme = "amber"' in path.read_text()
