from __future__ import annotations

import os
import stat
from pathlib import Path

import pytest

from trs80arm.saving import write_whole


def test_a_file_is_replaced_and_nothing_else_is_left(tmp_path: Path) -> None:
    path = tmp_path / "a.bas"
    write_whole(path, b"ONE")
    write_whole(path, b"TWO")
    assert path.read_bytes() == b"TWO"
    assert os.listdir(tmp_path) == ["a.bas"]


def test_a_failed_save_leaves_the_old_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "a.bas"
    write_whole(path, b"OLD")

    def full(descriptor: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OSError, match="No space") as error:
        write_whole(path, b"NEW")
    assert error.value.filename == str(path)
    assert path.read_bytes() == b"OLD"
    assert os.listdir(tmp_path) == ["a.bas"]


def test_permissions_are_kept(tmp_path: Path) -> None:
    path = tmp_path / "a.bas"
    write_whole(path, b"OLD")
    path.chmod(0o640)
    write_whole(path, b"NEW")
    assert stat.S_IMODE(path.stat().st_mode) == 0o640


def test_a_link_is_written_through(tmp_path: Path) -> None:
    target, link = tmp_path / "real.bas", tmp_path / "link.bas"
    target.write_bytes(b"OLD")
    link.symlink_to(target)
    write_whole(link, b"NEW")
    assert link.is_symlink()
    assert target.read_bytes() == b"NEW"


def test_a_folder_that_is_not_there_is_told_by_the_files_own_name(tmp_path: Path) -> None:
    path = tmp_path / "nowhere" / "a.bas"
    with pytest.raises(FileNotFoundError) as error:
        write_whole(path, b"NEW")
    assert error.value.filename == str(path)


def test_a_folder_in_the_files_place_is_told_by_the_files_own_name(tmp_path: Path) -> None:
    path = tmp_path / "a.bas"
    path.mkdir()
    with pytest.raises(IsADirectoryError) as error:
        write_whole(path, b"NEW")
    assert error.value.filename == str(path)
    assert os.listdir(tmp_path) == ["a.bas"]
