"""The line mode: a conversation with the same machine."""

from __future__ import annotations

import io
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tests.own_places import PROGRAMS, own_places
from trs80arm.desk.session import Session
from trs80arm.options import Speed, TerminalOptions
from trs80arm.plain import PlainMode, run_plain

__all__ = ["own_places"]


def talk(*lines: str, session: Session | None = None) -> str:
    """What is printed when these lines are typed."""
    out = io.StringIO()
    plain = PlainMode(session or Session(), out, echo=False, speed=None)
    assert plain.talk(iter(f"{line}\n" for line in lines)) == 0
    return out.getvalue()


def test_basic_answers() -> None:
    assert "\n 42 \n" in talk("PRINT 6*7")


def test_input_is_answered_by_the_next_line() -> None:
    said = talk("10 INPUT A", '20 PRINT "TWICE";2*A', "RUN", "21")
    assert "TWICE 42" in said


def test_manual_mode_takes_holds() -> None:
    said = talk("@SET", "1+W:0.5 0", "PRINT 1")
    assert "@SET: which keys?" in said
    base = next(line for line in said.splitlines() if line.startswith("base: "))
    assert int(base.split()[1].rstrip(",")) > 100


def test_a_wrong_hold_is_told_and_asked_again() -> None:
    said = talk("@SET", "Z:1", "0")
    assert "Z" in said


def test_programs_are_opened_and_saved(tmp_path: Path) -> None:
    target = tmp_path / "copy.txt"
    said = talk(f".open {PROGRAMS / 'table2.bas'}", f".save {target}", ".open nowhere.bas", ".fly")
    assert "table2.bas is loaded: RUN runs it." in said
    assert target.read_text().startswith("10 @STEP S,-P1")
    assert "nowhere.bas: No such file" in said
    assert "There is no .fly" in said


def test_a_cassette_of_machine_code_is_put_in_and_it_is_told_how_it_is_loaded() -> None:
    session = Session()
    session.load(PROGRAMS / "catch.cas")
    said = talk("SYSTEM", "CATCH", session=session)
    assert "SYSTEM, then CATCH, loads it" in said
    assert "No cassette" not in said
    assert said.count("*?") == 2


def test_pose_and_registers_are_said_in_words() -> None:
    said = talk(".pose", ".registers", ".quit", "PRINT 1")
    assert "X 5.00, Y 0.00, Z 0.00 inches" in said
    assert "hand: 0, true 0" in said
    assert "\n 1 \n" not in said


def test_a_program_opened_after_one_that_would_not_stop_is_heard(tmp_path: Path) -> None:
    session = Session()
    session.rig.load_text("10 POKE 16396,23\n20 GOTO 20\n")
    session.rig.type("RUN\r")
    session.run_for(2)
    (tmp_path / "a.bas").write_text('10 PRINT "HEARD"\n')
    out = io.StringIO()
    plain = PlainMode(session, out, echo=False, speed=None)
    plain.take(f".open {tmp_path / 'a.bas'}")
    plain.take("do not save")
    assert plain.talk(iter(["RUN\n"])) == 0
    assert "\nHEARD\n" in out.getvalue()


Opened = Callable[..., tuple[int, str, str]]


@pytest.fixture
def opened(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Opened:
    """Opens the line mode as the command line does: exit code, output, errors."""

    def open_it(typed: str = "", **options: Any) -> tuple[int, str, str]:
        monkeypatch.setattr("sys.stdin", io.StringIO(typed))
        chosen = TerminalOptions(plain=True, **{"speed": Speed.FLAT_OUT, **options})
        code = run_plain(chosen)
        return code, *capsys.readouterr()

    return open_it


def test_a_pipe_is_a_transcript_with_what_was_typed(opened: Opened) -> None:
    code, out, err = opened("PRINT 6*7\n")
    assert (code, err) == (0, "")
    assert out.startswith("MEMORY SIZE?")
    assert "PRINT 6*7\n 42 \n" in out


def test_a_program_is_loaded_with_its_bench_and_run(opened: Opened, tmp_path: Path) -> None:
    (tmp_path / "a.bas").write_text('10 PRINT "IT RUNS"\n')
    part = '[[part]]\nname = "cube"\nsize = [1, 1, 1]\nat = [8, 2]\nweight = 2\n'
    (tmp_path / "a.toml").write_text(part)
    code, out, _ = opened(program=tmp_path / "a.bas", run=True)
    assert code == 0
    assert "\nIT RUNS\n" in out


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"program": Path("nowhere.bas")}, "nowhere.bas: No such file or directory"),
        ({"bench": Path("nowhere.toml")}, "nowhere.toml: cannot be read"),
        ({"replay": Path("nowhere.jsonl")}, "nowhere.jsonl: No such file or directory"),
        ({"record": Path("nowhere/a.jsonl")}, "nowhere/a.jsonl: No such file or directory"),
    ],
)
def test_what_cannot_be_used_is_one_line_and_code_2(
    opened: Opened, options: dict[str, Path], said: str
) -> None:
    code, out, err = opened(**options)
    assert code == 2
    assert out == ""
    assert err.startswith(f"trs80arm: {said}")
    assert err.count("\n") == 1


def test_a_session_is_recorded_and_replayed(opened: Opened, tmp_path: Path) -> None:
    path = tmp_path / "a.jsonl"
    opened("10 PRINT 355/113\nRUN\n", record=path)
    assert path.read_text().count('"type"') == 2
    _, out, _ = opened(replay=path)
    assert " 3.14159" in out


class Interrupted:
    """A terminal at which Ctrl+C is pressed at certain lines."""

    def __init__(self, *lines: str | None) -> None:
        self._lines = iter(lines)

    def __iter__(self) -> Interrupted:
        return self

    def __next__(self) -> str:
        line = next(self._lines)
        if line is None:
            raise KeyboardInterrupt
        return line


def test_ctrl_c_is_break() -> None:
    out = io.StringIO()
    plain = PlainMode(Session(), out, echo=False, speed=None)
    assert plain.talk(Interrupted("10 INPUT A\n", "RUN\n", None, "PRINT 7*6\n")) == 0
    assert "BREAK IN 10" in out.getvalue().upper()
    assert "\n 42 \n" in out.getvalue()


def test_ctrl_c_stops_a_program_that_runs() -> None:
    pressed = []

    def sleep(seconds: float) -> None:
        pressed.append(seconds)
        if len(pressed) == 3:
            raise KeyboardInterrupt

    out = io.StringIO()
    plain = PlainMode(Session(), out, echo=False, speed=2.0, sleep=sleep)
    assert plain.talk(iter(["10 GOTO 10\n", "RUN\n", "PRINT 7*6\n"])) == 0
    assert pressed[0] == pytest.approx(0.025)
    assert "BREAK IN 10" in out.getvalue().upper()
    assert "\n 42 \n" in out.getvalue()


def test_the_screen_the_events_and_help_are_told() -> None:
    said = talk(".screen", "@STEP 50,0,-3000", ".events", ".help", ".open", ".run")
    assert "MEMORY SIZE?" in said.partition("Type .help for help.")[2]
    assert "shoulder" in said
    assert "  .quit                       leave\n" in said
    assert "Which? A number or a name" in said


def test_lost_steps_are_told_with_the_registers() -> None:
    said = talk("@STEP 50,0,-3000", ".registers")
    assert "lost" in next(line for line in said.splitlines() if line.startswith("shoulder: "))


def test_a_program_that_cannot_be_saved_is_told(tmp_path: Path) -> None:
    said = talk("10 REM", f".save {tmp_path / 'nowhere' / 'a.bas'}", f".open {tmp_path}", "go")
    assert "nowhere/a.bas: No such file or directory" in said
    assert f"{tmp_path}: Is a directory" in said
