"""Folders that may not be written, are full, may not be looked into or are none: everywhere.

Nothing is torn, nothing is left over, and what is told is one line.
"""

from __future__ import annotations

import codecs
import contextlib
import errno
import os
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.desk.sitting import Sitting
from trs80arm import Rig, RigSettings, settings
from trs80arm.benches import bench_files
from trs80arm.cli import main
from trs80arm.desk import recording
from trs80arm.desk.last_resort import last_words
from trs80arm.desk.places import RecentFiles, program_files
from trs80arm.desk.session import Session
from trs80arm.desk.states import QUICK, StateError, States
from trs80arm.files import FileFormatError
from trs80arm.settings import SettingsError

BAD = ("read-only", "no rights", "full", "missing", "a file", "a pipe", "a loop")
OLD = b"10 REM OLD\r\n"


# A user without rights may not be let into where Python keeps its codecs.
codecs.lookup("ascii")


@pytest.fixture(params=BAD)
def bad(
    request: pytest.FixtureRequest, unprivileged: Path, monkeypatch: pytest.MonkeyPatch
) -> Iterator[Path]:
    """A folder in which nothing can be saved; `a.bas` was there before, where it can be."""
    folder = unprivileged / "folder"
    match request.param:
        case "missing":
            # Nor can it be made.
            folder = unprivileged / "shut" / "folder"
            folder.parent.mkdir()
            folder.parent.chmod(0o500)
        case "a file":
            folder.write_bytes(OLD)
        case "a pipe":
            os.mkfifo(folder)
        case "a loop":
            folder.symlink_to(folder)
        case kind:
            folder.mkdir()
            (folder / "a.bas").write_bytes(OLD)
            if kind == "full":

                def full(descriptor: int) -> None:
                    raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

                monkeypatch.setattr(os, "fsync", full)
            else:
                folder.chmod(0o500 if kind == "read-only" else 0)
    yield folder
    monkeypatch.undo()
    folder.parent.chmod(0o700)
    if folder.is_dir():
        folder.chmod(0o700)
        assert [path for path in folder.rglob("*") if not path.is_dir()] == [folder / "a.bas"]
        assert (folder / "a.bas").read_bytes() == OLD


def told_by(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> str:
    """What the command line says on standard error, with the exit code for what cannot be used."""
    sys.argv[1:] = arguments
    with pytest.raises(SystemExit) as ended:
        main()
    assert ended.value.code == 2
    told = capsys.readouterr().err
    assert told.startswith("trs80arm: ")
    assert told.count("\n") == 1
    return told


@pytest.fixture
def command(monkeypatch: pytest.MonkeyPatch) -> None:
    """The command line may be used, with the settings that everybody has."""
    monkeypatch.setattr(sys, "argv", ["trs80arm"])
    for name in [name for name in os.environ if name.startswith("TRS80ARM_")]:
        monkeypatch.delenv(name)
    monkeypatch.setenv("TRS80ARM_CONFIG", os.devnull)


@pytest.mark.usefixtures("command")
@pytest.mark.parametrize(
    "words",
    [
        ["convert", "{program}", "{bad}/a.bas"],
        ["convert", "{program}", "{bad}/b.cas"],
        ["run", "{program}", "--trace", "{bad}/t.csv"],
        ["run", "{program}", "--trace", "{bad}/t.vcd"],
        ["run", "{program}", "--trace-pose", "{bad}/t.npz"],
    ],
    ids=lambda words: words[-1].removeprefix("{bad}/"),
)
def test_a_command_that_cannot_write_says_so(
    bad: Path, unprivileged: Path, words: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    program = unprivileged / "program.bas"
    program.write_text("10 @STEP 50,9\n")
    told_by([word.format(program=program, bad=bad) for word in words], capsys)


@pytest.mark.usefixtures("command")
@pytest.mark.parametrize("words", [["run"], ["run", "--bench"], ["run", "--config"], ["convert"]])
def test_a_command_that_cannot_read_says_so(
    bad: Path, words: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    program = [] if len(words) == 1 else ["table4.bas"]
    told = told_by([words[0], *program, *words[1:], str(bad / "none.x")][:4], capsys)
    assert "none.x" in told or words == ["convert"]


SAVES: dict[str, Callable[[Path, Session], Any]] = {
    "program": lambda folder, session: session.save(folder / "a.bas", None),
    "recording": lambda folder, session: session.save_recording(folder / "a.jsonl"),
    "kept recording": lambda folder, session: Session(record=folder / "none" / "a.jsonl"),
    "settings": lambda folder, session: settings.remember(folder / "s.toml", "theme", "paper"),
}


@pytest.mark.parametrize("what", SAVES)
def test_what_cannot_be_saved_is_an_error_of_the_system(bad: Path, what: str) -> None:
    session = Session()
    session.rig.load_text("10 REM NEW")
    with pytest.raises(OSError) as error:
        SAVES[what](bad, session)
    assert error.value.strerror


def test_a_state_folder_that_cannot_be_used_takes_nothing_and_breaks_nothing(bad: Path) -> None:
    desk = Sitting(bad)
    desk.session.rig.load_text("10 REM MINE")
    desk.session.rig.type("10 REM MINE\r")
    desk.session.rig.run_until_waiting()
    recent = RecentFiles(bad / "recent.json")
    recent.add(Path(__file__))
    assert recent.all() == []
    assert desk.recovery.left_over() == []
    assert desk.recovery.keep() == (not desk.session.unsaved)
    desk.recovery.keep()
    desk.recovery.drop()
    assert len(desk.person.errors) <= 1
    assert bench_files(bad) == []
    assert not program_files(bad) or program_files(bad) == [bad / "a.bas"]
    states = States(bad)
    with pytest.raises(StateError):
        states.save(QUICK, desk.session)
    with pytest.raises(StateError):
        states.load(QUICK, desk.session)
    assert states.all() == []
    assert "a fault of the program itself: KeyError" in last_words(KeyError("x"), bad, Session())


@pytest.fixture(params=["pipe", "loop", "folder"])
def odd(request: pytest.FixtureRequest) -> Callable[[Path], Path]:
    """Puts a pipe that nobody opens, a loop of links or a folder in a file's place."""

    def put(path: Path) -> Path:
        match request.param:
            case "pipe":
                os.mkfifo(path)
            case "loop":
                path.symlink_to(path)
            case _:
                path.mkdir()
        return path

    return put


def test_what_is_no_file_in_the_state_folder_is_passed_over(
    tmp_path: Path, odd: Callable[[Path], Path]
) -> None:
    desk = Sitting(tmp_path)
    desk.state.mkdir()
    odd(desk.state / "recent.json")
    odd(desk.state / "recovered-20250101-000000-1.sitting")
    odd(desk.state / ".trs80arm-abcdefgh.saving")
    copy = odd(desk.state / "recovered-20250101-000000-1.bas")
    odd(desk.state / "quick.state")
    assert States(desk.state).all() == []
    with pytest.raises(StateError):
        States(desk.state).load(QUICK, desk.session)
    assert desk.recent.all() == []
    desk.files.load_file(copy)
    assert len(desk.person.errors) == 1
    desk.type("10 REM MINE")
    assert desk.recovery.keep()
    assert desk.recovery.program_copy.is_file()


def test_what_is_no_file_is_neither_waited_for_nor_replaced(
    tmp_path: Path, odd: Callable[[Path], Path]
) -> None:
    path = odd(tmp_path / "odd.bas")
    before = os.lstat(path)
    session = Session()
    session.rig.load_text("10 REM NEW")
    for deed in (
        lambda: session.save(path, None),
        lambda: session.save_recording(path),
        lambda: Session(record=path),
        lambda: settings.remember(path, "theme", "paper"),
    ):
        with pytest.raises(OSError):
            deed()
    for read in (lambda: session.load(path), lambda: recording.load(path)):
        with contextlib.suppress(OSError, FileFormatError, recording.RecordingError):
            read()
    with contextlib.suppress(SettingsError):
        nothing = settings.load(Path(os.devnull), environment={})
        assert settings.load(path, environment={}) == nothing
    rig = Rig(RigSettings(printer_file=path))
    rig.type('LPRINT "X"\r')
    rig.run_until_waiting()
    assert rig.printer.fault is not None
    assert os.lstat(path).st_ino == before.st_ino


@pytest.mark.parametrize("kind", ["tapes", "printer"])
def test_cassette_and_paper_that_cannot_be_written_are_told_and_the_program_goes_on(
    bad: Path, kind: str
) -> None:
    chosen = (
        RigSettings(tape_folder=bad / "tapes")
        if kind == "tapes"
        else RigSettings(printer_file=bad / "none" / "paper.txt")
    )
    rig = Rig(chosen)
    rig.load_text('10 CSAVE "A":LPRINT "X":PRINT 7')
    rig.type("RUN\r")
    rig.run_until_waiting()
    assert " 7" in rig.screen()
    fault = rig.tape.fault if kind == "tapes" else rig.printer.fault
    assert fault is not None
    assert "\n" not in fault
