from __future__ import annotations

from pathlib import Path

import pytest
from textual.widgets import Input, OptionList

from tests.desk.test_teach import pick_and_place
from tests.drawing import samples
from tests.goldens import check_golden
from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text
from trs80arm.desk.teach import Lesson
from trs80arm.drawing.readings import Readings
from trs80arm.ui.screens.teach import TeachResult, TeachScreen
from trs80arm.ui.themes import Themed


class Desk(Themed[None]):
    """Nothing but the dialog, and what it ended with."""

    def __init__(self, lesson: Lesson, folder: Path) -> None:
        super().__init__()
        self.lesson = lesson
        self.folder = folder
        self.seen = samples.readings(samples.TO_THE_LEFT, registers=(1, 2, 3, 4, 5, 6))
        self.result: TeachResult | None = None

    def look(self) -> Readings:
        return self.seen

    def on_mount(self) -> None:
        def ended(result: TeachResult | None) -> None:
            self.result = result

        self.push_screen(TeachScreen(self.lesson, self.look, self.folder), ended)

    def names(self) -> list[str]:
        return [position.name for position in self.lesson.positions]


@pytest.mark.parametrize("width", [80, 110])
@piloted
async def test_the_dialog_lists_positions_and_shows_the_program(width: int, tmp_path: Path) -> None:
    desk = Desk(pick_and_place(), tmp_path)
    async with desk.run_test(size=(width, 30)) as pilot:
        await pilot.pause()
        check_golden(f"teach-{width}x30", screen_text(desk))


@piloted
async def test_an_empty_lesson_says_how_to_begin(tmp_path: Path) -> None:
    desk = Desk(Lesson(), tmp_path)
    async with desk.run_test(size=(80, 24)) as pilot:
        assert "Nothing taught yet" in screen_text(desk)
        await pilot.press("enter", "x", "w", "l", "g", "left_square_bracket")
        assert desk.names() == []
        await pilot.press("t")
        assert desk.lesson.positions[0].registers == (1, 2, 3, 4, 5, 6)


@piloted
async def test_positions_are_put_in_order_and_removed(tmp_path: Path) -> None:
    desk = Desk(pick_and_place(), tmp_path)
    async with desk.run_test(size=(100, 30)) as pilot:
        await pilot.press("down", "right_square_bracket", "x")
        assert desk.names() == ["ABOVE", "B", "C", "D", "E", "F", "G"]
        assert desk.screen.query_one(OptionList).highlighted == 2


@piloted
async def test_a_position_is_edited_and_nonsense_is_refused(tmp_path: Path) -> None:
    desk = Desk(pick_and_place(), tmp_path)
    async with desk.run_test(size=(100, 30)) as pilot:
        await pilot.press("enter")
        desk.screen.query_one("#name", Input).value = "up there"
        desk.screen.query_one("#registers", Input).value = "1 2 three"
        await pilot.press("enter")
        assert desk.names()[0] == "ABOVE"
        desk.screen.query_one("#registers", Input).value = "1, 2, 3, 4, 5, 6"
        desk.screen.query_one("#hand", Input).value = "12"
        await pilot.press("enter")
        await pilot.pause()
        first = desk.lesson.positions[0]
        assert (first.name, first.registers) == ("UP THERE", (1, 2, 3, 4, 5, 6))
        assert (first.grips, first.squeeze) == (True, 12)


@piloted
async def test_the_program_is_written_in_the_chosen_style(tmp_path: Path) -> None:
    desk = Desk(pick_and_place(), tmp_path)
    async with desk.run_test(size=(100, 30)) as pilot:
        await pilot.press("s", "w")
        await pilot.press("enter")
        await pilot.pause()
        text = (tmp_path / "taught.bas").read_text()
        assert "DATA 8, 0, 1.5, -90, 0, 0, 340, 50" in text
        await pilot.press("d")
        desk.screen.query_one(Input).value = "90"
        await pilot.press("enter", "s", "r", "l")
        await pilot.pause()
        assert desk.result is not None
        assert "S=90" in desk.result.listing
        assert "GOTO 200" in desk.result.listing


@piloted
async def test_a_folder_that_cannot_be_written_is_said(tmp_path: Path) -> None:
    desk = Desk(pick_and_place(), tmp_path / "missing")
    async with desk.run_test(size=(100, 30)) as pilot:
        await pilot.press("w", "enter")
        await pilot.pause()
        assert "There is no folder" in screen_text(desk)
