"""The own themes and all of Textual's can be chosen; what is drawn stays legible in each."""

from __future__ import annotations

import pytest
from rich.style import Style

from tests.ui.conftest import Opener
from tests.ui.piloted import piloted
from trs80arm.drawing.rows import Ink
from trs80arm.ui.themes import THEMES

LEGIBLE = 4.5
"""The contrast that the web's rules ask of text."""


def luminance(channels: tuple[int, int, int]) -> float:
    linear = [
        value / 255 / 12.92 if value / 255 <= 0.03928 else ((value / 255 + 0.055) / 1.055) ** 2.4
        for value in channels
    ]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(style: Style) -> float:
    assert style.color is not None
    assert style.bgcolor is not None
    one, other = (
        luminance(tuple(colour.get_truecolor())) for colour in (style.color, style.bgcolor)
    )
    return (max(one, other) + 0.05) / (min(one, other) + 0.05)


@piloted
async def test_every_theme_of_textual_can_be_chosen_too(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        for name in sitting.app.available_themes:
            sitting.app.theme = name
            await sitting.pilot.pause()
            assert "READY" in sitting.tube


@pytest.mark.parametrize("name", ["nord", "textual-light", "textual-ansi", "nonsense"])
@piloted
async def test_the_program_starts_in_any_theme(sit_down: Opener, name: str) -> None:
    async with sit_down(theme=name) as sitting:
        assert "READY" in sitting.tube


@pytest.mark.parametrize("name", [theme.name for theme in THEMES])
@piloted
async def test_all_inks_are_legible_in_the_own_themes(sit_down: Opener, name: str) -> None:
    async with sit_down(120, 40, theme=name) as sitting:
        side = sitting.app.desk.side
        styles = {ink: side.get_component_rich_style(f"panel--{ink.value}") for ink in Ink}
        del styles[Ink.PLAIN]
        faint = {ink.value for ink, style in styles.items() if contrast(style) < LEGIBLE}
        assert faint == set()
