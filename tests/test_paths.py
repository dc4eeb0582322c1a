"""Whatever is typed as a file's name is looked at without a surprise."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from trs80arm.desk.places import program_files
from trs80arm.paths import (
    is_file,
    is_folder,
    open_to_read,
    read_beginning,
    refusal,
    typed_path,
)

ODD = ["~n", "~nouser/x.bas", "x" * 300, "a\0b", "", " ", "/none/x.bas", "~/x" * 2000]


@pytest.mark.parametrize("text", ODD)
def test_under_an_odd_name_there_is_just_nothing(text: str, tmp_path: Path) -> None:
    path = tmp_path / typed_path(text)
    assert not is_file(path)
    assert is_folder(path) == (text.strip() == "")
    assert list(program_files(path)) == []


def test_a_name_that_the_system_refuses_has_a_reason() -> None:
    assert refusal(Path("x" * 300)) == "x" * 40 + ": File name too long"
    assert refusal(Path("a\0b")) == "No file can be called that."
    assert refusal(Path("new.bas")) == ""


def test_the_home_folder_is_meant_by_its_sign() -> None:
    assert typed_path(" ~/x.bas ") == Path.home() / "x.bas"
    assert typed_path("~nouser/x.bas") == Path("~nouser/x.bas")


def test_only_files_are_read_and_no_more_than_wanted(tmp_path: Path) -> None:
    (tmp_path / "a.bas").write_bytes(b"x" * 100)
    assert read_beginning(tmp_path / "a.bas", 10) == b"x" * 10
    os.mkfifo(tmp_path / "pipe.bas")
    for other in (tmp_path / "pipe.bas", Path(os.devnull)):
        with pytest.raises(OSError, match="not a file"):
            read_beginning(other, 10)


def test_pipes_and_folders_are_not_offered_as_programs(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.bas")
    (tmp_path / "folder.bas").mkdir()
    (tmp_path / "real.bas").write_text("10 END\n")
    assert program_files(tmp_path) == [tmp_path / "real.bas"]


def test_a_folder_in_a_files_place_is_named() -> None:
    with pytest.raises(IsADirectoryError) as refused:
        open_to_read(Path("tests"))
    assert refused.value.filename == "tests"
