from __future__ import annotations

import os
import signal
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from trs80arm.saving import whole_file, write_whole


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


def test_a_device_is_written_to_and_stays_a_device(tmp_path: Path) -> None:
    write_whole(Path("/dev/null"), b"NEW")
    assert stat.S_ISCHR(os.stat("/dev/null").st_mode)
    link = tmp_path / "a.bas"
    link.symlink_to("/dev/full")
    with pytest.raises(OSError, match="No space") as error:
        write_whole(link, b"NEW")
    assert error.value.filename == str(link)
    assert os.listdir(tmp_path) == ["a.bas"]


def test_a_pipe_takes_what_is_saved(tmp_path: Path) -> None:
    pipe = tmp_path / "a.bas"
    os.mkfifo(pipe)
    with pytest.raises(OSError, match="No such device") as error:
        write_whole(pipe, b"NEW")  # Nobody reads: no save waits for ever.
    assert error.value.filename == str(pipe)
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    write_whole(pipe, b"NEW")
    assert os.read(reader, 10) == b"NEW"
    os.close(reader)
    assert stat.S_ISFIFO(pipe.stat().st_mode)


def test_what_stands_behind_dev_fd_is_written(tmp_path: Path) -> None:
    source, sink = os.pipe()
    write_whole(Path(f"/dev/fd/{sink}"), b"NEW")
    assert os.read(source, 10) == b"NEW"
    os.close(source)
    os.close(sink)


def test_owner_and_group_are_kept(tmp_path: Path) -> None:
    path = tmp_path / "a.bas"
    write_whole(path, b"OLD")
    if os.geteuid() == 0:
        os.chown(path, 1234, 2345)
    before = path.stat()
    write_whole(path, b"NEW")
    after = path.stat()
    assert (after.st_uid, after.st_gid) == (before.st_uid, before.st_gid)


def test_a_file_that_may_not_be_written_is_not_replaced(unprivileged: Path) -> None:
    path = unprivileged / "a.bas"
    write_whole(path, b"OLD")
    path.chmod(0o444)
    with pytest.raises(PermissionError) as error:
        write_whole(path, b"NEW")
    assert error.value.filename == str(path)
    assert path.read_bytes() == b"OLD"


@pytest.mark.parametrize("length", [246, 250, 255])
def test_the_longest_names_can_be_saved(tmp_path: Path, length: int) -> None:
    path = tmp_path / ("n" * (length - 4) + ".bas")
    write_whole(path, b"NEW")
    assert path.read_bytes() == b"NEW"
    assert os.listdir(tmp_path) == [path.name]


def test_a_loop_of_links_and_a_zero_in_a_name_are_plain_errors(tmp_path: Path) -> None:
    loop = tmp_path / "a.bas"
    loop.symlink_to(loop)
    with pytest.raises(OSError, match="symbolic links") as error:
        write_whole(loop, b"NEW")
    assert error.value.filename == str(loop)
    with pytest.raises(OSError, match="Invalid argument"):
        write_whole(tmp_path / "a\0.bas", b"NEW")


def test_what_a_killed_save_left_is_cleared_by_the_next(tmp_path: Path) -> None:
    script = (
        "import sys, time\nfrom pathlib import Path\nfrom trs80arm.saving import whole_file\n"
        "with whole_file(Path(sys.argv[1])) as file:\n"
        "    file.write(b'HALF'); file.flush(); print('ready', flush=True); time.sleep(60)\n"
    )
    path = tmp_path / "a.bas"
    arguments = [sys.executable, "-c", script, str(path)]
    with subprocess.Popen(arguments, stdout=subprocess.PIPE) as writer:
        assert writer.stdout is not None
        assert writer.stdout.readline() == b"ready\n"
        write_whole(tmp_path / "b.bas", b"NEW")
        assert len(os.listdir(tmp_path)) == 2, "a writer at work keeps its file"
        writer.send_signal(signal.SIGKILL)
    assert len(os.listdir(tmp_path)) == 2
    write_whole(tmp_path / "b.bas", b"NEW")
    assert os.listdir(tmp_path) == ["b.bas"]


def test_an_error_of_the_writer_keeps_its_own_name(tmp_path: Path) -> None:
    other = tmp_path / "other"
    with pytest.raises(FileNotFoundError) as error, whole_file(tmp_path / "a.bas"):
        other.read_bytes()
    assert error.value.filename == str(other)
    assert os.listdir(tmp_path) == []
