"""Names and messages from outside are shown as they are: no control codes, no markup."""

from __future__ import annotations

from pathlib import Path

import pytest
from rich.segment import Segment
from textual.color import Color

from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text
from tests.ui.sitting import Opener
from trs80arm.ui.terminal.no_codes import NoControlCodes

ODD = ["n\x1b]0;X\x07.bas", "[x].bas", "[@click=app.exit(5)]y.bas", "\u202ex.bas"]


@piloted
async def test_the_open_dialog_shows_odd_names(sit_down: Opener, tmp_path: Path) -> None:
    for name in ODD:
        (tmp_path / name).write_text("10 REM\n")
    async with sit_down() as sitting:
        await sitting.press("f2")
        await sitting.press(*f"{tmp_path}/")
        await sitting.settle()
        picture = screen_text(sitting.app)
    assert "\x1b" not in picture
    assert "\u202e" not in picture
    assert "\\x1b]0;X\\x07.bas" in picture
    assert "[x].bas" in picture


@pytest.mark.parametrize("text", ["[/x]", "[@click=app.exit(5)]x[/]", "\x1b]0;X\x07", "a\nb"])
@piloted
async def test_a_message_is_no_markup_and_has_no_codes(sit_down: Opener, text: str) -> None:
    async with sit_down() as sitting:
        sitting.app.say(text, error=True)
        await sitting.settle()
        picture = screen_text(sitting.app)
        assert sitting.app.is_running
    assert "\x1b" not in picture
    if text.isprintable():
        assert text in picture


def test_the_last_filter_drops_what_a_terminal_would_obey() -> None:
    line = [Segment("A\x1b[2JB\x9b"), Segment("\u2588 ")]
    cleaned = NoControlCodes().apply(line, Color(0, 0, 0))
    assert [segment.text for segment in cleaned] == ["A[2JB", "\u2588 "]
    assert cleaned[1] is line[1]
