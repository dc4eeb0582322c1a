"""The line mode: a conversation with the same machine."""

from __future__ import annotations

import io
from pathlib import Path

from tests.ui.conftest import PROGRAMS
from trs80arm.desk.session import Session
from trs80arm.plain import PlainMode


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
    assert "table2.bas is loaded." in said
    assert target.read_text().startswith("10 @STEP S,-P1")
    assert "nowhere.bas: No such file" in said
    assert "There is no .fly" in said


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
    assert plain.talk(iter(["RUN\n"])) == 0
    assert "\nHEARD\n" in out.getvalue()
