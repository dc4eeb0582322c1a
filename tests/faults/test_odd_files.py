"""Pipes, devices, loops of links and files without end where a file should be: nothing hangs."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from trs80arm import Rig, RigSettings
from trs80arm.arm.bench import BenchError
from trs80arm.arm.figures import FigureError, figure
from trs80arm.benches import BenchFile
from trs80arm.desk import recording
from trs80arm.desk.places import RecentFiles
from trs80arm.files import FileFormatError, load_program
from trs80arm.machine import printer


def odd_things(folder: Path) -> None:
    """One of each in a folder of cassettes, and a good one behind them."""
    os.mkfifo(folder / "A.cas")
    (folder / "B.cas").symlink_to(folder / "B.cas")
    (folder / "C.cas").symlink_to(folder / "D.cas")
    (folder / "D.cas").symlink_to(folder / "C.cas")
    (folder / "E.cas").symlink_to("/dev/zero")
    (folder / "F.cas").symlink_to("/dev/full")
    (folder / "G.cas").mkdir()
    (folder / "H.cas").symlink_to(folder / "nowhere" / "x.cas")


def test_cload_passes_by_whatever_is_no_cassette(tmp_path: Path) -> None:
    maker = Rig(RigSettings(tape_folder=tmp_path))
    maker.load_text("10 REM GOOD")
    maker.type('CSAVE "Z"\r')
    maker.run_until_waiting()
    odd_things(tmp_path)
    rig = Rig(RigSettings(tape_folder=tmp_path))
    assert rig.tape.cassettes == ["Z"]
    rig.type("CLOAD\rLIST\r")
    rig.run_until_waiting()
    assert "10 REM GOOD" in rig.screen()
    for name in "ABCDEFGH":
        rig.type(f'CSAVE "{name}"\rPRINT 7\r')
        rig.run_until_waiting()
        assert [line for line in rig.screen() if line][-3:] == [" 7", "READY", ">_"]
        assert rig.tape.fault is not None
        assert "is no file" in rig.tape.fault
    assert (tmp_path / "A.cas").is_fifo()
    assert (tmp_path / "E.cas").is_symlink()


def test_a_cassette_longer_than_any_is_a_fault_of_the_recorder(tmp_path: Path) -> None:
    with (tmp_path / "A.cas").open("wb") as file:
        file.truncate(1 << 33)
    rig = Rig(RigSettings(tape_folder=tmp_path))
    rig.type("CLOAD\r")
    rig.run_for(5)
    assert rig.tape.fault is not None
    assert "longer than any cassette" in rig.tape.fault


@pytest.mark.parametrize("endless", ["/dev/zero", "large"])
def test_files_without_end_are_refused(tmp_path: Path, endless: str) -> None:
    path = Path(endless)
    if endless == "large":
        path = tmp_path / "large.bas"
        with path.open("wb") as file:
            file.truncate(1 << 33)
    with pytest.raises(FileFormatError, match="which no program is"):
        load_program(path)
    with pytest.raises(BenchError, match="which no bench is"):
        BenchFile.read(path)
    with pytest.raises(recording.RecordingError, match="longer than 64 MB"):
        recording.load(path)


def test_a_program_may_come_through_a_pipe() -> None:
    source, sink = os.pipe()
    os.write(sink, b"10 PRINT 1\n")
    os.close(sink)
    assert load_program(Path(f"/dev/fd/{source}"))[0][0] == 10
    os.close(source)


def test_a_figure_that_does_not_fit_on_the_disk_leaves_the_old_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "a.svg"
    path.write_text("OLD")

    def full(descriptor: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(FigureError, match="No space left"):
        figure("8").save(path)
    assert path.read_text() == "OLD"
    assert os.listdir(tmp_path) == ["a.svg"]


def test_paper_in_memory_is_of_bounded_length_and_a_file_has_all(tmp_path: Path) -> None:
    paper = printer.Printer(tmp_path / "paper.txt")
    for number in range(120_000):
        for code in b"%09d" % number:
            paper.put(code)
        # Ten numbers a line, for each line opens the file once.
        if number % 10 == 9 and number % 60_000 > 10:
            paper.put(13)
    paper.flush()
    assert printer.PAPER <= len(paper.sent) < 2 * printer.PAPER
    last = "".join(f"{number:09d}" for number in range(119_990, 120_000))
    assert paper.text.endswith(f"\n{last}\n")
    text = (tmp_path / "paper.txt").read_text()
    assert text.replace("\n", "") == "".join(f"{number:09d}" for number in range(120_000))


def test_a_line_that_never_ends_is_of_bounded_length() -> None:
    paper = printer.Printer()
    for _ in range(3 * printer.PAPER):
        paper.put(65)
    assert len(paper.sent) < 2 * printer.PAPER


@pytest.mark.parametrize(
    "content", [b"", b"{", b"5", b'["\\u0000", 7, null, "/nowhere"]', b"\xff", b"[" * 100_000]
)
def test_a_list_of_recent_files_that_is_none_is_empty_and_begun_anew(
    tmp_path: Path, content: bytes
) -> None:
    path = tmp_path / "recent.json"
    path.write_bytes(content)
    recent = RecentFiles(path)
    assert recent.all() == []
    recent.add(path)
    assert RecentFiles(path).all() == [path.resolve()]
