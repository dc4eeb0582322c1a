"""The dialogs that ask for files: odd names, and previews of what is no file."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from textual.widgets import Input, OptionList, Static

from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text
from tests.ui.sitting import Opener, Sitting
from trs80arm.ui.screens.dialog import AskPath
from trs80arm.ui.screens.open import MOST_BYTES, OpenScreen, preview


async def type_name(sitting: Sitting, name: str) -> None:
    sitting.app.screen.query_one(Input).value = name
    await sitting.pilot.pause()
    await sitting.app.workers.wait_for_complete()


@pytest.mark.parametrize("name", ["~n", "~nouser/x.bas", "x" * 300, "/none/x", "a\0b"])
@piloted
async def test_any_name_can_be_typed_where_a_program_is_opened(sit_down: Opener, name: str) -> None:
    async with sit_down() as sitting:
        await sitting.press("f2")
        await type_name(sitting, name)
        await sitting.press("enter")
        await sitting.settle()
        assert isinstance(sitting.app.screen, OpenScreen)
        assert "There is no file" in screen_text(sitting.app)


@pytest.mark.parametrize("name", ["~nouser/", "/none/", "x" * 300 + "/"])
@piloted
async def test_a_folder_that_there_is_none_of_has_nothing_to_offer(
    sit_down: Opener, name: str
) -> None:
    async with sit_down() as sitting:
        await sitting.press("f2")
        await type_name(sitting, name)
        assert "No program fits." in screen_text(sitting.app)
        assert sitting.app.screen.query_one(OptionList).option_count == 0


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("~nouser/x.bas", "There is no folder ~nouser."),
        ("x" * 300, "File name too long"),
        ("/none/x.bas", "There is no folder /none."),
        ("", "Type a name."),
    ],
)
@piloted
async def test_a_name_that_cannot_be_saved_under_is_told(
    sit_down: Opener, name: str, said: str
) -> None:
    async with sit_down() as sitting:
        await sitting.type_line("10 REM")
        await sitting.press("f3")
        await type_name(sitting, name)
        await sitting.press("enter")
        await sitting.settle()
        assert isinstance(sitting.app.screen, AskPath)
        assert said in screen_text(sitting.app)


def test_a_preview_is_of_regular_files_of_a_programs_size(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.bas")
    (tmp_path / "large.bas").write_bytes(b"1" * (MOST_BYTES + 1))
    (tmp_path / "odd.bas").write_bytes(b"\xff\x01\x02")
    (tmp_path / "empty.bas").write_bytes(b"")
    assert preview(tmp_path / "pipe.bas") == "not a file"
    assert preview(tmp_path / "large.bas") == "Too large for a program of the TRS-80."
    assert preview(tmp_path / "odd.bas").startswith("odd.bas: ")
    assert preview(tmp_path / "empty.bas") == "An empty program."
    assert preview(tmp_path) == "Is a directory"
    assert preview(tmp_path / "none.bas") == "No such file or directory"


@piloted
async def test_the_preview_follows_what_is_marked(sit_down: Opener, tmp_path: Path) -> None:
    for number in range(3):
        (tmp_path / f"zz{number}.bas").write_text(f"10 REM NUMBER {number}\n")
    async with sit_down() as sitting:
        await sitting.press("f2")
        await type_name(sitting, "zz")
        for number in (1, 2):
            await sitting.press("down")
            await sitting.app.workers.wait_for_complete()
            await sitting.pilot.pause()
            shown = str(sitting.app.screen.query_one("#preview", Static).render())
            assert f"NUMBER {number}" in shown


@piloted
async def test_a_recovered_program_is_removed_when_asked_to_twice(
    sit_down: Opener, tmp_path: Path
) -> None:
    state = tmp_path / "state"
    state.mkdir()
    for day in (1, 2):
        (state / f"recovered-2026010{day}-093000-7.bas").write_text("10 REM LOST\n")
    async with sit_down() as sitting:
        await sitting.press("f2")
        await sitting.settle()
        assert "2026-01-02 09:30" in screen_text(sitting.app)
        await sitting.press("ctrl+x")
        assert len(list(state.glob("recovered-*"))) == 2
        await sitting.press("ctrl+x")
        await sitting.settle()
        assert [path.name for path in state.glob("recovered-*")] == [
            "recovered-20260101-093000-7.bas"
        ]
        assert "2026-01-02 09:30" not in screen_text(sitting.app)


@pytest.mark.parametrize("name", ["/etc/passwd", "/etc/", "../secret.bas", "/no/such/file"])
@pytest.mark.parametrize("key", ["f2", "f3"])
@piloted
async def test_a_visitor_names_files_of_his_own_folder_only(
    sit_down: Opener, tmp_path: Path, key: str, name: str
) -> None:
    own = tmp_path / "own"
    own.mkdir()
    (tmp_path / "secret.bas").write_text("10 REM SECRET\n")
    async with sit_down(own_folder=own) as sitting:
        sitting.app.session.rig.load_text("10 REM MINE")
        await sitting.press(key)
        await type_name(sitting, name)
        assert "secret" not in screen_text(sitting.app).replace("../secret.bas", "")
        await sitting.press("enter")
        await sitting.settle()
        assert "Only the files of your own folder" in screen_text(sitting.app)


@piloted
async def test_a_visitor_saves_and_opens_in_his_own_folder(
    sit_down: Opener, tmp_path: Path
) -> None:
    own = tmp_path / "own"
    own.mkdir()
    async with sit_down(own_folder=own) as sitting:
        sitting.app.session.rig.load_text("10 REM MINE")
        await sitting.press("f3")
        await type_name(sitting, "mine.txt")
        await sitting.press("enter")
        await sitting.settle()
        assert (own / "mine.txt").is_file()
        await sitting.press("f2")
        await sitting.settle()
        assert "mine.txt" in screen_text(sitting.app)


@piloted
async def test_a_name_typed_whole_is_marked_before_longer_ones(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await sitting.press("f2", *"table4", "enter")
        await sitting.settle()
        assert sitting.app.session.path is not None
        assert sitting.app.session.path.name == "table4.bas"


@piloted
async def test_ones_own_programs_stand_before_those_that_come_along(
    sit_down: Opener, tmp_path: Path
) -> None:
    (tmp_path / "mine.bas").write_text("10 REM\n")
    (tmp_path / "there").mkdir()
    (tmp_path / "there" / "other.bas").write_text("10 REM\n")
    async with sit_down() as sitting:
        await sitting.press("f2")
        await sitting.settle()
        whole = screen_text(sitting.app)
        assert 0 < whole.index("mine.bas") < whole.index("Coming along")
        await type_name(sitting, "there/")
        named = screen_text(sitting.app)
        assert "other.bas" in named
        assert "Coming along" not in named


@piloted
async def test_a_click_marks_a_program_and_shows_it_and_a_second_one_opens_it(
    sit_down: Opener,
) -> None:
    async with sit_down(100, 30) as sitting:
        await sitting.press("f2")
        await sitting.settle()
        dialog = sitting.app.screen
        options = dialog.query_one(OptionList)
        before = dialog.query_one("#preview", Static).content
        # The shelf's name stands first, and the first program is marked.
        for row in (0, 2):
            await sitting.pilot.click(options, offset=(5, row))
            await sitting.settle()
            assert sitting.app.screen is dialog
        assert options.highlighted == 2
        assert dialog.query_one("#preview", Static).content != before
        await sitting.pilot.click(options, offset=(5, 2))
        await sitting.settle()
        assert sitting.app.screen is not dialog
        assert list(sitting.app.session.rig.basic.program.lines())


@piloted
async def test_a_first_click_in_any_list_of_a_dialog_chooses_nothing(sit_down: Opener) -> None:
    async with sit_down(100, 30) as sitting:
        await sitting.press("f8")
        await sitting.settle()
        dialog = sitting.app.screen
        options = dialog.query_one(OptionList)
        other = 0 if options.highlighted else 1
        await sitting.pilot.click(options, offset=(5, other))
        await sitting.settle()
        assert sitting.app.screen is dialog
        assert options.highlighted == other
        await sitting.pilot.click(options, offset=(5, other))
        await sitting.settle()
        assert sitting.app.screen is not dialog
