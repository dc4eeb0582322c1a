"""The debugger in the line mode."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.own_places import own_places
from tests.sixty_lines import LISTING
from tests.test_plain import talk
from trs80arm.desk.session import Session

__all__ = ["own_places"]


@pytest.fixture
def sixty(tmp_path: Path) -> str:
    """The file of a program of sixty lines with a mistake in it."""
    path = tmp_path / "sixty.bas"
    path.write_text(LISTING)
    return f".open {path}"


def test_the_mistake_is_found_in_lines(sixty: str) -> None:
    session = Session()
    said = talk(
        *(sixty, ".break 220", "RUN", ".print I W", ".registers"),
        *(".back 2", ".print I", ".list", ".step 2", ".registers"),
        session=session,
    )
    assert "Breakpoint before 220: R(I)=W" in said
    assert "I = 5" in said
    assert "Back before 550: NEXT I" in said
    assert "I = 4" in said
    assert " >550 NEXT I" in said
    times = re.findall(r"T-state (\d+)", said)
    assert times[0] == times[-1] == str(session.rig.clock.now)
    registers = re.findall(r"base: .*", said)
    assert registers[0] == registers[-1]


def test_conditions_are_typed_behind_if() -> None:
    said = talk(
        "10 FOR I=1 TO 9", "20 A=I", "30 NEXT", ".break 20 if I>5", ".break", "RUN", ".vars"
    )
    assert "Stops before 20 if I>5." in said
    assert "20 if I>5" in said
    assert "I = 6\nA = 5" in said


def test_steps_over_and_out_of_a_subroutine() -> None:
    program = ("10 GOSUB 50", "20 GOSUB 50", "30 END", "50 B=B+1", "60 RETURN")
    said = talk(*program, ".break 10", "RUN", ".step", ".stack", ".out", ".over", ".go")
    where = re.findall(r"(?:Before|before) (\d+)", said)
    assert where == ["10", "10", "50", "20", "30"]
    assert "10  GOSUB" in said


def test_variables_and_memory_are_changed_and_refused() -> None:
    said = talk(
        *("10 A%=1", "20 GOTO 20", ".break 20", "RUN", ".let A%=7", ".let A%=70000", ".print A%"),
        *(".poke 3C00H,66", ".memory 3C00H 1", ".poke 1", ".memory X", ".print Q", ".let GOTO 1"),
    )
    assert "A% = 7" in said
    assert "?OV Error." in said
    assert re.search(r"3C00  42 .*  B", said)
    assert "Type an address and a value" in said
    assert "X is no address" in said
    assert "There is no Q yet." in said
    assert "Only an assignment" in said


def test_states_are_kept_listed_taken_and_dropped() -> None:
    said = talk(
        *("10 A=A+1:GOTO 10", ".break 10 if A=3", "RUN", ".keep three", ".clear", ".let A=9"),
        *(
            ".states",
            ".take three",
            ".print A",
            ".drop three",
            ".take three",
            ".take before load",
            ".print A",
        ),
    )
    assert "State three is saved." in said
    assert re.search(r"three  \d{4}-\d\d-\d\d \d\d:\d\d  10: A=A\+1", said)
    assert "State three is loaded." in said
    assert "A = 3" in said
    assert "There is no state 'three'." in said
    assert "A = 9" in said.partition("no state")[2]


def test_manual_mode_ends_at_a_breakpoint_whatever_else_is_held() -> None:
    said = talk("10 @SET", "20 A=1", "30 GOTO 30", ".break 20", "RUN", "1:0.3 0 6:1")
    assert "Breakpoint before 20" in said


def test_a_line_is_not_typed_while_the_machine_stands() -> None:
    said = talk("10 A=1", "20 GOTO 20", ".break 20", "RUN", "PRINT 6*7")
    assert "The machine stands" in said
    assert " 42\n" not in said


@pytest.mark.parametrize(
    ("line", "said"),
    [
        (".break 5", "There is no line 5."),
        (".break 10 if", "Stops before 10 if."),
        (".break 10 if I", "A condition compares"),
        (".clear 10", "Line 10 has no breakpoint."),
        (".until X", "Which line? A number."),
        (".step many", "How often?"),
        (".out", "The program is in no subroutine."),
        (".back", "Nothing is known of an earlier statement."),
        (".back stop", "Nothing is known of an earlier stop."),
        (".step", "No program runs; it stops before"),
        (".where", "No program runs."),
        (".stack", "No FOR or GOSUB is open."),
        (".print", "Which variable?"),
    ],
)
def test_what_cannot_be_done_is_said(line: str, said: str) -> None:
    assert said in talk("10 A=1", line)


def test_a_watch_says_what_changed() -> None:
    said = talk(
        *("10 FOR I=1 TO 3", "20 A=I", "30 NEXT", ".watch A", ".watch latch hand", ".watch", "RUN"),
        *(".go", ".unwatch A", ".watch latch nose", ".unwatch Q"),
    )
    assert "Stops behind a change of A." in said
    assert "A = none\nlatch hand = " in said
    assert "A none -> 1: before 30: NEXT" in said
    assert "A 1 -> 2: before 30: NEXT" in said
    assert "A is not watched any more." in said
    assert "The latches are base, shoulder," in said
    assert "Q is not watched." in said


def test_machine_code_is_stepped_through() -> None:
    pytest.importorskip("z80", reason="the extra z80 is not installed")
    said = talk(
        *("10 FOR I=0 TO 3:READ A:POKE 28672+I,A:NEXT", "20 POKE 16526,0:POKE 16527,112"),
        *("30 X=USR(0)", "40 DATA 62,5,60,201", ".codebreak 7002H", ".codebreak", "RUN", ".cpu"),
        *(".code 7000H", ".codestep", ".codebreak 28674", ".codebreak nowhere", ".codestep 0"),
    )
    assert "Stops at 7002H." in said
    assert "Breakpoint at 7002H: INC A" in said
    assert re.search(r"PC 7002  SP [0-9A-F]{4}  AF 05", said)
    assert "  7000 3E05     LD A,05H\n*>7002 3C       INC A" in said
    assert "At 7003H: RET" in said
    assert "Does not stop any more at 7002H." in said
    assert "Nowhere is no address" in said
    assert "How often? A number from 1 to 1000." in said
