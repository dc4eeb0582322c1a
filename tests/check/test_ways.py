"""`trs80arm check`: where a program goes, and what it reads that nothing sets."""

from __future__ import annotations

import pytest

from tests.check.conftest import Check
from trs80arm.check.findings import Level, Rule


def rules(check: Check, text: str) -> list[tuple[int | None, Rule]]:
    return [(each.number, each.rule) for each in check(text)]


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("10 PRINT\n20 END\n30 PRINT\n", 30),
        ("10 GOTO 10\n20 PRINT\n", 20),
        ("10 GOTO 10:PRINT\n", 10),
        ("10 GOSUB 30\n20 END\n30 RETURN\n40 PRINT\n", 40),
        ("10 IF INP(1) THEN 30 ELSE 40\n20 PRINT\n30 END\n40 END\n", 20),
        ("10 END\n20 @RESET\n", 20),
        ("10 ON ERROR GOTO 30\n20 END\n30 RESUME 10\n40 CLS\n", 40),
    ],
)
def test_what_nothing_leads_to_is_noted(check: Check, text: str, line: int) -> None:
    (found,) = check(text)
    assert (found.rule, found.number, found.level) == (Rule.UNREACHED, line, Level.NOTE)


def test_a_stretch_that_nothing_leads_to_is_told_once(check: Check) -> None:
    (found,) = check("10 END\n20 PRINT 1\n30 REM\n40 PRINT 2\n50 RETURN\n60 DATA 1\n")
    assert (found.number, found.text) == (20, "nothing leads here and up to line 40")


@pytest.mark.parametrize(
    "text",
    [
        # Ends, remarks and data stand where nothing comes.
        "10 GOTO 10\n20 END\n30 REM THE END\n40 DATA 1\n",
        # CONT goes on behind a STOP.
        "10 STOP\n20 PRINT\n",
        "10 ON INP(1) GOTO 30\n20 END\n30 PRINT\n",
        "10 ON INP(1) GOSUB 30\n20 END\n30 RETURN\n",
        "10 ON ERROR GOTO 30\n20 END\n30 PRINT:RESUME NEXT\n",
        # An error in line 20 is passed.
        "10 ON ERROR GOTO 40\n20 RETURN\n30 END\n40 RESUME NEXT\n",
        "10 RUN 30\n20 END\n30 PRINT\n",
        "10 IF INP(1) THEN PRINT 1:END ELSE PRINT 2\n20 PRINT\n",
        "10 IF INP(1) IF INP(2) THEN END ELSE END\n20 PRINT\n",
    ],
)
def test_what_something_leads_to_is_not_told(check: Check, text: str) -> None:
    assert check(text) == []


@pytest.mark.parametrize(
    ("text", "line", "rule"),
    [
        ("10 NEXT\n", 10, Rule.NEXT_WITHOUT_FOR),
        ("10 FOR I=1 TO 2:NEXT J\n", 10, Rule.NEXT_WITHOUT_FOR),
        ("10 FOR I=1 TO 2:GOSUB 30:NEXT\n20 END\n30 NEXT:RETURN\n", 30, Rule.NEXT_WITHOUT_FOR),
        ("10 FOR I=1 TO 2\n20 END\n", 10, Rule.FOR_WITHOUT_NEXT),
        ("10 FOR I=1 TO 2:FOR J=1 TO 2\n20 NEXT J\n", 10, Rule.FOR_WITHOUT_NEXT),
        ("10 GOSUB 30\n20 END\n30 PRINT:GOTO 20\n", 10, Rule.NO_RETURN),
    ],
)
def test_a_loop_or_subroutine_that_does_not_close_is_told(
    check: Check, text: str, line: int, rule: Rule
) -> None:
    assert (line, rule) in rules(check, text)


@pytest.mark.parametrize(
    "text",
    [
        "10 FOR I=1 TO 2:FOR J=1 TO 2:NEXT J,I\n",
        "10 FOR I=1 TO 2:FOR J=1 TO 2:NEXT:NEXT\n",
        "10 FOR I=1 TO 9\n20 IF INP(1) THEN NEXT ELSE 40\n30 END\n40 NEXT:PRINT\n",
        "10 DEFINT A-Z:FOR I%=1 TO 2:NEXT I\n",
        "10 FOR SP=1 TO 2:NEXT SP\n",
        "10 GOTO 30\n20 NEXT:END\n30 FOR I=1 TO 2:GOTO 20\n",
        "10 GOSUB 30:END\n30 GOTO 50\n40 RETURN\n50 GOTO 40\n",
        "10 ON INP(1) GOSUB 30,30:END\n30 RETURN\n",
    ],
)
def test_a_loop_or_subroutine_that_closes_somewhere_is_not_told(check: Check, text: str) -> None:
    assert check(text) == []


def test_a_variable_that_nothing_sets_is_noted_where_it_is_read_first(check: Check) -> None:
    (found,) = check("10 G0=5\n20 G=G0-GC\n30 PRINT G;GC\n")
    assert (found.rule, found.number, found.column) == (Rule.NEVER_SET, 20, len("20 G=G0-") + 1)
    assert found.text == "nothing sets GC: it is 0"


@pytest.mark.parametrize(
    "statement",
    ["INPUT A", "READ A", "@READ B,A", "FOR A=1 TO 2:NEXT", "LET A=1", "A%=1", "PRINT VARPTR(A)"],
)
def test_whatever_can_set_a_variable_counts(check: Check, statement: str) -> None:
    assert check(f"10 {statement}:PRINT A\n20 DATA 1\n") == []


def test_an_array_is_another_variable(check: Check) -> None:
    assert rules(check, "10 A=1:PRINT A(1)\n") == [(10, Rule.NEVER_SET)]
    assert rules(check, "10 A(1)=1:PRINT A(1),A\n") == [(10, Rule.NEVER_SET)]
    assert rules(check, "10 DIM A(5):PRINT A(1)\n") == []


def test_ways_are_not_told_of_a_program_that_cannot_be_read(check: Check) -> None:
    assert rules(check, "10 GTO 30\n20 END\n30 PRINT A\n") == [(10, Rule.SYNTAX)]


# -- remarks that allow it -------------------------------------------------------------------------


def test_a_remark_allows_a_rule_in_its_line(check: Check) -> None:
    text = "10 PRINT A:REM CHECK: ALLOW NEVER-SET\n20 PRINT B\n"
    assert [each.number for each in check(text)] == [20]


@pytest.mark.parametrize("remark", ["REM CHECK: ALLOW", "'check: allow"])
def test_a_remark_of_its_own_allows_rules_in_the_program(check: Check, remark: str) -> None:
    assert check(f"5 {remark} NEVER-SET, unreached\n10 PRINT A:END\n20 PRINT\n") == []


def test_a_remark_that_allows_no_rule_is_told(check: Check) -> None:
    (found,) = check("10 REM CHECK: ALLOW NEVERSET\n")
    assert (found.rule, found.text) == (Rule.UNKNOWN_RULE, "there is no rule NEVERSET")
