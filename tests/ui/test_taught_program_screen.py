"""The program of the points: seen, written, loaded, read back."""

from __future__ import annotations

from pathlib import Path

import pytest
from textual.widgets import Input, Static

from tests.desk.test_teach import pick_and_place
from tests.goldens import check_golden
from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text
from trs80arm.desk.pendant import Pendant
from trs80arm.desk.session import Session
from trs80arm.desk.teach import Lesson
from trs80arm.ui.screens.edit_point import EditPoint
from trs80arm.ui.screens.taught_program import ProgramScreen, TeachResult
from trs80arm.ui.themes import Themed


class Desk(Themed[None]):
    """Nothing but the dialog, and what it ended with."""

    def __init__(self, lesson: Lesson, folder: Path) -> None:
        super().__init__()
        self.pendant = Pendant(Session(), lesson)
        self.folder = folder
        self.result: TeachResult | None = None

    def on_mount(self) -> None:
        def ended(result: TeachResult | None) -> None:
            self.result = result

        self.push_screen(ProgramScreen(self.pendant, self.folder), ended)

    def names(self) -> list[str]:
        return [position.name for position in self.pendant.lesson.positions]


@pytest.mark.parametrize("width", [80, 110])
@piloted
async def test_the_dialog_shows_the_program(width: int, tmp_path: Path) -> None:
    desk = Desk(pick_and_place(), tmp_path)
    async with desk.run_test(size=(width, 30)) as pilot:
        await pilot.pause()
        check_golden(f"taught-program-{width}x30", screen_text(desk))


@piloted
async def test_without_points_there_is_nothing_to_write(tmp_path: Path) -> None:
    desk = Desk(Lesson(), tmp_path)
    async with desk.run_test(size=(80, 24)) as pilot:
        await pilot.pause()
        assert "There is no point yet" in screen_text(desk)
        await pilot.press("w", "l", "s")
        assert isinstance(desk.screen, ProgramScreen)


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
        await pilot.press("enter", "s", "u", "l")
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


@piloted
async def test_a_listing_that_was_edited_is_read_back(tmp_path: Path) -> None:
    desk = Desk(pick_and_place(), tmp_path)
    async with desk.run_test(size=(100, 30)) as pilot:
        await pilot.press("w", "enter")
        await pilot.pause()
        path = tmp_path / "taught.bas"
        path.write_text(path.read_text().replace("REM C TO D", "REM C TO OVER THERE"))
        await pilot.press("i", "enter")
        await pilot.pause()
        assert desk.names()[4] == "OVER THERE"
        path.write_text(path.read_text().replace("END", "INPUT A"))
        await pilot.press("i", "enter")
        await pilot.pause()
        assert "INPUTA cannot be read back" in screen_text(desk)
        assert len(desk.names()) == 8


@piloted
async def test_points_that_no_file_has_do_not_go_unasked(tmp_path: Path) -> None:
    desk = Desk(pick_and_place(), tmp_path)
    async with desk.run_test(size=(100, 30)) as pilot:
        desk.pendant._session.rig.load_text("10 @STEP 50,100\n20 @CLOSE\n")
        await pilot.press("m")
        await pilot.pause()
        assert "would go" in screen_text(desk)
        await pilot.press("escape")
        await pilot.pause()
        assert len(desk.names()) == 8
        await pilot.press("m")
        await pilot.pause()
        await pilot.press("enter")
        await pilot.pause()
        assert desk.names() == ["START", "A"]


class Editing(Themed[None]):
    """Nothing but the dialog about one point, and what it gave."""

    def __init__(self) -> None:
        super().__init__()
        self.lesson = pick_and_place()

    def on_mount(self) -> None:
        def edited(position: object) -> None:
            self.edited = position

        self.push_screen(EditPoint(self.lesson.positions[0], 32), edited)


@piloted
async def test_a_point_is_edited_and_nonsense_is_refused() -> None:
    desk = Editing()
    async with desk.run_test(size=(80, 24)) as pilot:
        await pilot.pause()
        assert any("(32 a pound)" in str(hint.content) for hint in desk.screen.query(Static))
        for line, value in (
            ("name", "up there"),
            ("comment", "wait here"),
            ("registers", "1 2 three"),
            ("delay", "80"),
        ):
            desk.screen.query_one(f"#{line}", Input).value = value
        await pilot.press("enter")
        assert "six numbers" in screen_text(desk)
        desk.screen.query_one("#registers", Input).value = "1, 2, 3, 4, 5, 6"
        desk.screen.query_one("#hand", Input).value = "12"
        await pilot.press("enter")
        await pilot.pause()
        first = desk.edited
        assert first.name == "UP THERE"
        assert first.comment == "WAIT HERE"
        assert first.delay == 80
        assert first.registers == (1, 2, 3, 4, 5, 6)
        assert (first.grips, first.squeeze) == (True, 12)
