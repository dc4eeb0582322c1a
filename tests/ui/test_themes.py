"""The own themes and all of Textual's can be chosen; what is drawn stays legible in each."""

from __future__ import annotations

from dataclasses import replace

import pytest
from rich.style import Style
from textual.widgets import Button

from tests.ui.piloted import piloted
from tests.ui.screen_text import styles_at
from tests.ui.sitting import Opener
from trs80arm.drawing.rows import Ink, Paint
from trs80arm.ui.filming import picture
from trs80arm.ui.screens.pendant import PendantScreen
from trs80arm.ui.themes import GREEN, THEMES, Themed

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


class Painted(Themed[None]):
    """An application with the own themes and nothing else."""

    def __init__(self) -> None:
        super().__init__()
        for theme in THEMES:
            self.register_theme(theme)


def test_the_second_application_has_the_colours_of_the_first() -> None:
    first = Painted()
    seen = {}
    for name in first.available_themes:
        first.theme = name
        seen[name] = first.get_css_variables(), first.theme_variables
        # What one does with its variables is nothing to the next.
        first.theme_variables["primary"] = first.get_css_variables()["primary"] = "none"
    assert seen["green"][0]["tube"] != seen["amber"][0]["tube"] != seen["nord"][0]["tube"]
    second = Painted()
    for name, (variables, own) in seen.items():
        second.theme = name
        assert second.get_css_variables() == variables
        assert second.theme_variables == own | {"primary": second.theme_variables["primary"]}
        assert second.theme_variables["primary"] != "none"


def test_a_theme_put_in_the_place_of_another_has_its_own_colours() -> None:
    app = Painted()
    app.theme = "green"
    before = app.get_css_variables()
    app.register_theme(replace(GREEN, primary="#123456"))
    assert app.get_css_variables()["primary"] == "#123456" != before["primary"]


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


VISIBLE = 3.0
"""The contrast that the web's rules ask of lines that say where something is."""


@pytest.mark.parametrize("name", [theme.name for theme in THEMES])
@piloted
async def test_frames_and_titles_can_be_seen_in_the_own_themes(sit_down: Opener, name: str) -> None:
    async with sit_down(120, 40, theme=name) as sitting:
        await sitting.press("ctrl+t", "f12")
        await sitting.settle()
        dialog = sitting.app.screen
        assert isinstance(dialog, PendantScreen)
        box = dialog.query_one(".dialog")
        frames = [*sitting.app.desk.panels.values(), box]
        for widget in frames:
            if not widget.display:
                continue
            _, colour = widget.styles.border_top
            ground = Style(bgcolor=widget.background_colors[1].rich_color)
            line = widget.background_colors[1] + colour
            assert contrast(Style(color=line.rich_color) + ground) >= VISIBLE
            title = widget.styles.border_title_color
            assert contrast(Style(color=title.rich_color) + ground) >= LEGIBLE


@piloted
async def test_the_focused_button_is_one_block_of_colour(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await sitting.type_line("10 REM")
        await sitting.press("f10")
        await sitting.settle()
        button = sitting.app.focused
        assert isinstance(button, Button)
        assert str(button.label) == "Save"
        region = button.region
        cells = styles_at(sitting.app, region)
        assert {style.bgcolor for style in cells} == {button.rich_style.bgcolor}
        assert not any(style.reverse for style in cells)


@piloted
async def test_an_ink_is_looked_up_when_it_is_used_and_anew_in_another_theme(
    sit_down: Opener,
) -> None:
    async with sit_down(120, 40, theme="green") as sitting:
        side = sitting.app.desk.side
        assert set(side._component_styles) < {f"panel--{ink.value}" for ink in Ink}
        before = side.get_component_rich_style("panel--arm")
        sitting.app.theme = "paper"
        await sitting.settle()
        after = side.get_component_rich_style("panel--arm")
        assert after.color != before.color
        assert after.color in {style.color for style in styles_at(sitting.app, side.region)}


@piloted
async def test_the_arm_is_no_dark_blue_on_black(sit_down: Opener) -> None:
    async with sit_down(120, 40, theme="ansi-dark") as sitting:
        style = sitting.app.desk.side.get_component_rich_style("panel--arm")
        assert style.color is not None
        assert style.color.number == 14


@pytest.mark.parametrize("name", [theme.name for theme in THEMES])
@piloted
async def test_a_shadow_is_darker_than_the_table(sit_down: Opener, name: str) -> None:
    async with sit_down(120, 40, theme=name) as sitting:
        top = sitting.app.desk.panels["top"]
        table, shadow = (
            top._style(Paint(ink, level)).color for ink, level in ((Ink.TABLE, 2), (Ink.SHADOW, 0))
        )
        assert table is not None
        assert shadow is not None
        assert luminance(shadow.get_truecolor()) < luminance(table.get_truecolor())


@pytest.mark.parametrize(("name", "ground"), [("ansi-dark", "#000000"), ("ansi-light", "#ffffff")])
@piloted
async def test_films_in_the_terminals_own_colours_have_a_terminals_ground(
    sit_down: Opener, name: str, ground: str
) -> None:
    async with sit_down(80, 24, theme=name) as sitting:
        grounds = [look.ground for line in picture(sitting.app) for _, look in line]
        assert max(grounds, key=grounds.count) == ground


@piloted
async def test_the_table_is_grey_in_the_terminals_own_colours(sit_down: Opener) -> None:
    for theme, colour in (("ansi-dark", 8), ("ansi-light", 7)):
        async with sit_down(120, 40, theme=theme) as sitting:
            style = sitting.app.desk.side.get_component_rich_style("panel--table")
            assert style.color is not None
            assert style.color.number == colour


@pytest.mark.parametrize("name", [theme.name for theme in THEMES])
@piloted
async def test_all_inks_are_legible_in_the_own_themes(sit_down: Opener, name: str) -> None:
    async with sit_down(120, 40, theme=name) as sitting:
        side = sitting.app.desk.side
        styles = {ink: side.get_component_rich_style(f"panel--{ink.value}") for ink in Ink}
        del styles[Ink.PLAIN]
        faint = {ink.value for ink, style in styles.items() if contrast(style) < LEGIBLE}
        assert faint == set()
