"""Whatever the theme, what is drawn in its colours can be read on its grounds."""

from __future__ import annotations

import pytest
from textual.color import BLACK, WHITE, Color
from textual.theme import BUILTIN_THEMES, Theme

from trs80arm.ui.contrast import LINE, TEXT, contrast, legible, readable
from trs80arm.ui.themes import THEMES

EVERY = {theme.name: theme for theme in (*BUILTIN_THEMES.values(), *THEMES)}
COLOURED = [name for name in EVERY if "ansi" not in name]
INKS = ("primary", "secondary", "accent", "warning", "error", "success")


def variables(theme: Theme) -> dict[str, str]:
    made = theme.to_color_system().generate()
    tube = {"tube": made["foreground"], "tube-background": made["background"]}
    made = {**tube, **made, **theme.variables}
    return made | readable(made)


def measured(colours: dict[str, str], text: str, ground: str) -> float:
    return contrast(Color.parse(colours[text]), Color.parse(colours[ground]))


def test_contrast_is_that_of_the_webs_rules() -> None:
    assert contrast(BLACK, WHITE) == pytest.approx(21.0)
    assert contrast(WHITE, WHITE) == 1.0
    assert contrast(Color.parse("#777777"), WHITE) == pytest.approx(4.48, abs=0.01)


def test_a_colour_that_can_be_read_stays_as_it_is() -> None:
    assert legible(WHITE, BLACK) == WHITE


def test_a_colour_that_cannot_be_read_keeps_its_hue() -> None:
    red, green, blue = legible(Color.parse("#000080"), BLACK).rgb
    assert blue > red == green


@pytest.mark.parametrize("name", COLOURED)
def test_everything_is_legible_in_every_theme(name: str) -> None:
    colours = variables(EVERY[name])
    for ink in INKS:
        for ground in ("background", "surface"):
            assert measured(colours, f"text-{ink}", ground) >= TEXT
    assert measured(colours, "tube", "tube-background") >= TEXT
    assert measured(colours, "title", "background") >= TEXT
    assert measured(colours, "frame", "background") >= LINE
    assert measured(colours, "key", "panel") >= TEXT
    assert measured(colours, "word", "panel") >= TEXT
    assert measured(colours, "on-warning", "warning") >= TEXT
    assert measured(colours, "on-primary", "primary") >= TEXT


@pytest.mark.parametrize("name", [name for name in EVERY if "ansi" in name])
def test_the_terminals_own_colours_are_left_to_the_terminal(name: str) -> None:
    theme = EVERY[name]
    made = theme.to_color_system().generate()
    colours = variables(theme)
    assert all(colours[f"text-{ink}"] == made[f"text-{ink}"] for ink in INKS)
    assert colours["key"] == made["accent"]
