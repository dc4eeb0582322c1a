"""Golden screens: what the program shows, at the sizes it was made for and in every theme."""

from __future__ import annotations

import re
from typing import Any

import pytest
from textual.app import App

from tests.goldens import check_golden
from tests.own_places import PROGRAMS
from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text as text_of
from tests.ui.sitting import Opener
from trs80arm.options import ArmStyle, GlyphSet
from trs80arm.ui.themes import THEMES

SIZES = [(80, 24), (100, 30), (120, 40)]


CLOCK = re.compile(r"^\d+:\d\d\.\d", re.MULTILINE)


def screen_text(app: App[Any]) -> str:
    """The screen without the machine's clock, which tells how long statements took."""
    return CLOCK.sub("M:SS.s", text_of(app))


def shape(width: int, height: int) -> str:
    return f"{width}x{height}"


@pytest.mark.parametrize(("width", "height"), [*SIZES, (64, 18), (70, 24), (160, 50), (60, 17)])
@piloted
async def test_the_first_start(sit_down: Opener, width: int, height: int) -> None:
    async with sit_down(width, height) as sitting:
        await sitting.settle()
        check_golden(f"start-{shape(width, height)}", screen_text(sitting.app))


@pytest.mark.parametrize(("width", "height"), [*SIZES, (200, 60), (200, 24), (60, 60)])
@piloted
async def test_table_4_is_loaded(sit_down: Opener, width: int, height: int) -> None:
    async with sit_down(width, height, program=PROGRAMS / "table4.bas") as sitting:
        await sitting.type_line("LIST 10-100")
        check_golden(f"table4-{shape(width, height)}", screen_text(sitting.app))


@pytest.mark.parametrize(("width", "height"), SIZES)
@piloted
async def test_the_arm_after_a_motion(sit_down: Opener, width: int, height: int) -> None:
    async with sit_down(width, height) as sitting:
        await sitting.type_line("CLS:@STEP 50,400,-300,200,100,-100,300")
        await sitting.pass_time(3)
        check_golden(f"moved-{shape(width, height)}", screen_text(sitting.app))


@pytest.mark.parametrize(("width", "height"), SIZES)
@piloted
async def test_manual_mode(sit_down: Opener, width: int, height: int) -> None:
    async with sit_down(width, height) as sitting:
        await sitting.begin_manual_mode()
        check_golden(f"manual-{shape(width, height)}", screen_text(sitting.app))


@pytest.mark.parametrize("bottom", ["motors", "log", "keyboard"])
@pytest.mark.parametrize(("width", "height"), SIZES)
@piloted
async def test_the_switched_panels(sit_down: Opener, width: int, height: int, bottom: str) -> None:
    async with sit_down(width, height) as sitting:
        await sitting.app.run_action(f"do('show_{bottom}')")
        await sitting.settle()
        check_golden(f"{bottom}-{shape(width, height)}", screen_text(sitting.app))


@pytest.mark.parametrize("theme", [theme.name for theme in THEMES])
@piloted
async def test_every_theme_has_its_colours(sit_down: Opener, theme: str) -> None:
    from tests.ui.screen_text import screen_colours

    async with sit_down(80, 24, theme=theme) as sitting:
        await sitting.settle()
        text = screen_text(sitting.app) + "\n" + screen_colours(sitting.app)
        check_golden(f"theme-{theme}", text)


@pytest.mark.parametrize("action", ["help", "open", "speed", "glyphs", "bench", "key_test"])
@piloted
async def test_the_dialogs(sit_down: Opener, action: str) -> None:
    async with sit_down(80, 24) as sitting:
        await sitting.app.run_action(f"do('{action}')")
        await sitting.app.workers.wait_for_complete()
        await sitting.settle()
        text = screen_text(sitting.app).replace(str(PROGRAMS), "PROGRAMS")
        assert "Traceback" not in text
        if action not in ("open", "bench"):
            check_golden(f"dialog-{action}", text)


@piloted
async def test_the_question_before_leaving(sit_down: Opener) -> None:
    async with sit_down(80, 24) as sitting:
        await sitting.type_line("10 PRINT 1")
        await sitting.press("f10")
        await sitting.settle()
        check_golden("dialog-leave", screen_text(sitting.app))


@piloted
async def test_ascii_means_ascii(sit_down: Opener) -> None:
    async with sit_down(120, 40, glyphs=GlyphSet.ASCII) as sitting:
        await sitting.type_line("CLS:FOR I=128 TO 191:PRINT CHR$(I);:NEXT:PRINT 2[3")
        await sitting.pass_time(1)
        check_golden("ascii-120x40", screen_text(sitting.app))
        assert sitting.tube.isascii()


@pytest.mark.parametrize(
    ("style", "drawn"),
    [
        (ArmStyle.ASCII, "###"),
        (ArmStyle.HALF, "▀"),
        (ArmStyle.SEXTANT, "🬭"),
        (ArmStyle.BRAILLE, "⣿"),
        (ArmStyle.OUTLINE, "_.-"),
    ],
)
@piloted
async def test_the_arm_is_drawn_in_the_style_chosen(
    sit_down: Opener, style: ArmStyle, drawn: str
) -> None:
    async with sit_down(120, 40, arm=style) as sitting:
        await sitting.settle()
        assert drawn in screen_text(sitting.app)


@piloted
async def test_32_columns(sit_down: Opener) -> None:
    async with sit_down(80, 24) as sitting:
        await sitting.type_line('CLS:PRINT CHR$(23);"WIDE";CHR$(191);CHR$(149)')
        await sitting.pass_time(0.5)
        check_golden("wide-80x24", screen_text(sitting.app))
