"""The program in memory is read without running it, and what is found can be looked at."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.desk.sitting import Sitting
from tests.own_places import PROGRAMS
from trs80arm.desk.proof import NO_PROGRAM, NOTHING_WRONG, Proof


@pytest.fixture
def sitting(tmp_path: Path) -> Sitting:
    return Sitting(tmp_path)


def proof(sitting: Sitting) -> Proof:
    return Proof(sitting.session, sitting.person, sitting.person.say)


def test_the_line_that_is_chosen_is_listed(sitting: Sitting) -> None:
    sitting.type("10 SPEED=1", "20 SPAN=GC:GOTO 99")
    sitting.answer("1")
    proof(sitting).read()
    (question,) = sitting.person.asked
    assert question.title == "1 error, 1 warning, 1 note"
    assert {choice.label for choice in question.choices} == {
        "20 warning: SPAN is the same variable as SPEED in line 10: only SP counts",
        "20 note: nothing sets GC: it is 0",
        "20 error: there is no line 99 (?UL)",
    }
    sitting.type()
    assert "LIST 20" in "\n".join(sitting.session.rig.screen())


def test_while_a_program_runs_the_finding_is_told_again(sitting: Sitting) -> None:
    sitting.type("10 INPUT X:GOTO 99", "RUN")
    sitting.answer("0")
    proof(sitting).read()
    assert sitting.person.told == ["10: there is no line 99 (?UL)"]


def test_there_may_be_nothing_to_tell(sitting: Sitting) -> None:
    proof(sitting).read()
    sitting.type("10 PRINT 1")
    proof(sitting).read()
    assert sitting.person.told == [NO_PROGRAM, NOTHING_WRONG]


def test_the_bench_says_where_the_arm_begins(sitting: Sitting) -> None:
    sitting.files.load_file(PROGRAMS / "table4.bas")
    proof(sitting).read()
    assert sitting.person.told[-1] == NOTHING_WRONG
    sitting.type("10050 DATA 6, 5, 0.5, 20, 90, 300, 50")
    sitting.answer(None)
    proof(sitting).read()
    (question,) = sitting.person.asked
    assert "is out of reach: the pitch of the hand would be at" in question.choices[0].label
