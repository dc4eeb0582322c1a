"""Which files a visitor can name."""

from __future__ import annotations

import io
from pathlib import Path

import pytest

from trs80arm.bundled import programs_folder
from trs80arm.desk.reach import ALL_FILES, OUTSIDE, Reach
from trs80arm.desk.session import Session
from trs80arm.plain import PlainMode


@pytest.fixture
def reach(tmp_path: Path) -> Reach:
    folder = tmp_path / "own"
    folder.mkdir()
    (tmp_path / "theirs.bas").write_text("10 REM SECRET\n")
    (folder / "link.bas").symlink_to(tmp_path / "theirs.bas")
    (folder / "loop").symlink_to(folder / "loop")
    return Reach(folder)


@pytest.mark.parametrize(
    "text",
    [
        *("../theirs.bas", "/etc/passwd", "/", "..", "link.bas", "a/../..", "x\0.bas"),
        *("../own-and-more", "/dev/stdin", "~/x.bas", "~root/x.bas"),
    ],
)
def test_what_is_not_in_ones_own_folder_cannot_be_named(reach: Reach, text: str) -> None:
    path = reach.typed(text)
    inside = reach.folder is not None and text.startswith("~")
    for to_write in (False, True):
        assert reach.refusal(path, to_write=to_write) == ("" if inside else OUTSIDE)
    if inside:
        assert path == reach.home / text


def test_ones_own_files_can_be_read_and_written(reach: Reach) -> None:
    for text in ("a.bas", " a.bas ", "tapes/a.cas", str(reach.home / "a.bas"), "b/../a.bas"):
        assert not reach.refusal(reach.typed(text), to_write=True)


def test_programs_that_come_along_are_read_and_not_written(reach: Reach) -> None:
    along = programs_folder()
    assert along is not None
    assert not reach.refusal(along / "table4.bas", to_write=False)
    assert reach.refusal(along / "table4.bas", to_write=True) == OUTSIDE
    assert reach.proposal(along / "table4.bas") == "table4.bas"
    assert reach.proposal("new.bas") == "new.bas"


def test_who_sits_at_the_computer_reaches_all(tmp_path: Path) -> None:
    assert not ALL_FILES.refusal(Path("/etc/passwd"), to_write=True)
    assert ALL_FILES.typed("~") == Path.home()
    assert ALL_FILES.proposal(tmp_path / "x") == tmp_path / "x"
    assert ALL_FILES.home == Path.cwd()


def test_the_line_mode_stays_in_the_folder(reach: Reach, tmp_path: Path) -> None:
    out = io.StringIO()
    plain = PlainMode(Session(), out, echo=False, speed=None, reach=reach)
    for line in (".open ../theirs.bas", ".save ../mine.bas", ".open link.bas"):
        plain.take(line)
    assert out.getvalue().count(OUTSIDE) == 3
    assert not (tmp_path / "mine.bas").exists()
    plain.session.rig.load_text("10 REM MINE")
    plain.take(".save mine.txt")
    assert (reach.home / "mine.txt").is_file()
