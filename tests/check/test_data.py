"""`trs80arm check`: what READ makes of DATA, and points that the arm does not reach."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.check.conftest import Check
from trs80arm.arm.bench import Bench
from trs80arm.benches import BenchFile
from trs80arm.check.findings import Finding, Rule
from trs80arm.check.program import check_bytes
from trs80arm.rig import Rig

PROGRAMS = Path(__file__).parents[2] / "programs"
SOLUTION = """
500 REM JOINT ANGLES FOR U INCHES AHEAD, V TO THE LEFT, W ABOVE THE TABLE, HAND DOWN
510 Q=SQR(U*U+V*V):E=W+3.5-8.1:F=SQR(Q*Q+E*E)/14
520 AL=ATN(SQR(1-F*F)/F):GA=ATN(E/Q)
530 BB=INT(937.8*ATN(V/U)):SS=INT(937.8*(GA+AL)):EE=INT(551.4*(GA-AL))
540 @STEP 50,BB-B0,S0-SS,EE-E0:B0=BB:S0=SS:E0=EE:RETURN
"""
"""Somebody else's: other names, the law of cosines, and no test of its own."""


def moved(name: str, line: int, place: int, to: str) -> list[Finding]:
    """What is found where one item of a program that comes along is another number."""
    path = PROGRAMS / f"{name}.bas"
    text, times = re.subn(
        rf"^({line} DATA (?:[^,\n]*,){{{place}}})[^,\n]*",
        rf"\g<1>{to}",
        path.read_text(),
        flags=re.M,
    )
    assert times == 1
    bench = path.with_suffix(".toml")
    return check_bytes(path, text.encode(), bench=BenchFile.read(bench).bench)


@pytest.mark.parametrize(
    ("name", "line", "place"),
    [
        *(("bridge", line, 1 + n) for n, line in enumerate((300, 310, 320, 330, 340, 350))),
        *(("guarded", 240, place) for place in (0, 3, 7, 10)),
        *(("pegs", 400 + 10 * n, place) for n, place in enumerate((0, 1, 4))),
        *(("table4", 10000 + 10 * n, n % 3) for n in range(8)),
        *(("table4-as-printed", line, 2) for line in (10000, 10040)),
        *(("tower", line, 0) for line in (10000, 10260 + 10, 10500)),
    ],
)
def test_a_point_moved_out_of_reach_is_found(name: str, line: int, place: int) -> None:
    found = [each for each in moved(name, line, place, "30") if each.rule is Rule.OUT_OF_REACH]
    assert [each.number for each in found] == [line]
    assert "30" in re.split(r", | \(", found[0].text)


def test_it_is_told_which_variables_take_the_point_and_where_it_is_turned_away() -> None:
    (found,) = [each for each in moved("table4", 10040, 0, "-8") if each.rule is Rule.OUT_OF_REACH]
    assert found.text == (
        "-8 (X of line 308) is out of reach: the program turns it away in line 5060"
    )
    assert found.column == len("10040 DATA ") + 1


def test_a_point_that_the_program_takes_and_the_arm_does_not_is_found() -> None:
    """Table 4's subroutine does not know how far the hand turns on the forearm."""
    found = [each for each in moved("table4", 10050, 3, "20") if each.rule is Rule.OUT_OF_REACH]
    assert [each.number for each in found] == [10050]
    assert "the pitch of the hand would be at" in found[0].text


def test_a_point_below_the_table_is_found() -> None:
    (low,) = [each for each in moved("table4", 10020, 2, "-2") if each.rule is Rule.OUT_OF_REACH]
    assert low.text.endswith("the fingertips would be 2.0 in below the table")


def test_points_are_found_whatever_they_are_called_and_however_they_are_kept(check: Check) -> None:
    text = f"""
10 READ N:DIM PX(20),PY(20),PZ(20)
20 FOR I=1 TO N:READ PX(I),PY(I),PZ(I):NEXT
30 FOR I=1 TO N:U=PX(I)/2.54:V=PY(I)/2.54:W=PZ(I)/2.54:GOSUB 500:NEXT
40 END
{SOLUTION}
900 DATA 3, 20,0,5
910 DATA 60,0,5
920 DATA 20,5,5
"""
    (found,) = check(text)
    assert (found.rule, found.number) == (Rule.OUT_OF_REACH, 910)
    assert found.text == (
        "60, 0, 5 (PX(), PY(), PZ() of line 20) is out of reach: line 520 ends with ?FC"
    )


def test_all_points_that_are_turned_away_are_found(check: Check) -> None:
    text = f"""
10 READ U,V,W:IF U=0 THEN END
20 IF SQR(U*U+V*V)>14 THEN PRINT "TOO FAR":GOTO 10
30 GOSUB 500:GOTO 10
{SOLUTION}
900 DATA 7,0,2, 30,0,2, 7,1,2, 7,-30,2, 8,0,2, 0,0,0
"""
    assert [each.text.split(" (")[0] for each in check(text)] == ["30, 0", "7, -30"]


def test_counts_that_are_taught_are_added_up_to_the_stops(check: Check) -> None:
    """Wherever the arm begins, its base turns by half a circle and no more."""
    text = """
10 @SET
20 FOR I=1 TO 3:READ D,A,B:@STEP D,A,B:NEXT
30 DATA 50,1400,-50
40 DATA 50,1500,50
50 DATA 50,1500,20000
"""
    found = check(text)
    assert [(each.number, each.rule) for each in found] == [(50, Rule.OUT_OF_REACH)]
    assert "the base would be at" in found[0].text
    assert "or beyond, its stop is at 90" in found[0].text


def test_where_the_arm_begins_the_bench_says() -> None:
    text = b"10 READ A:@STEP 50,A\n20 DATA 1600\n"
    assert check_bytes(Path("p.bas"), text) == []
    (found,) = check_bytes(Path("p.bas"), text, bench=Bench())
    assert "the base would be at 98 degrees, its stop is at 90" in found.text


@pytest.mark.parametrize(
    "text",
    [
        # Inches or millimetres: nobody knows before the run.
        "10 INPUT U$:F=1:IF U$='MM' THEN F=25.4\n20 READ U,V,W:IF U=0 THEN END\n"
        f"30 U=U/F:V=V/F:W=W/F:GOSUB 500:GOTO 20\n{SOLUTION}900 DATA 200,9,9,0,0,0\n",
        # An end of the list that would be out of reach, were it a point.
        f"10 READ U,V,W:IF U<-99 THEN END\n20 GOSUB 500:GOTO 10\n{SOLUTION}"
        "900 DATA 7,0,2,-999,0,0\n",
        # Down until something is felt, however deep.
        "10 READ U,V:W=5\n20 GOSUB 500:IF INP(152) AND 1 THEN W=W-.5:GOTO 20\n"
        f"30 END\n{SOLUTION}900 DATA 7,1\n",
        # The arm is jogged in between.
        "10 READ A:@STEP 50,A:@SET:READ A:@STEP 50,A\n20 DATA 2500,2500\n",
        # Motors turned by OUT.
        "10 READ A:@STEP 50,A:OUT 152,5:READ A:@STEP 50,A\n20 DATA 2500,2500\n",
        # Nothing but numbers.
        "10 READ A,B:IF SQR(A*A-B)>3 THEN PRINT 'MUCH':END\n20 PRINT B:END\n30 DATA 9,1\n",
    ],
)
def test_what_only_a_run_can_tell_is_not_told(check: Check, text: str) -> None:
    assert check(text.replace("'", '"')) == []


@pytest.mark.parametrize("statement", ["POKE", "OUT 1", "POKE 1,2,3", "A=INT(1,2)", "@STEP", "ON"])
def test_behind_what_is_no_statement_nothing_is_followed(check: Check, statement: str) -> None:
    found = check(f"10 READ A\n20 {statement}\n30 READ A\n40 DATA 1\n")
    assert {each.rule for each in found} == {Rule.SYNTAX}


@pytest.mark.parametrize("number", ["0", "A", "N"])
def test_a_loop_that_never_ends_is_left(check: Check, number: str) -> None:
    assert check(f"10 A=0:READ N\n20 A=A+1:IF {number}<1E9 THEN 20\n30 DATA 1\n") == []


# -- the items themselves --------------------------------------------------------------------------


def test_a_read_without_data_is_told(check: Check) -> None:
    (found,) = check("10 FOR I=1 TO 4\n20 READ A\n30 NEXT\n40 DATA 1,2,3\n")
    assert (found.rule, found.number) == (Rule.OUT_OF_DATA, 20)


def test_an_item_that_is_no_number_is_told_where_it_stands(check: Check) -> None:
    (found,) = check('10 READ N$,A,B$,C\n20 DATA PIER, 5, "A,B:C", LOAD\n')
    assert (found.rule, found.number, found.column) == (Rule.DATA_TYPE, 20, 27)
    assert found.text == "'LOAD' is no number (C of line 10) (?SN)"


@pytest.mark.parametrize(
    "text",
    [
        "10 READ A:IF A>=0 THEN 10\n20 RESTORE:READ A\n30 DATA 1,2,-1\n",
        "10 INPUT N:FOR I=1 TO N:READ A:NEXT\n20 READ B$\n30 DATA 1,2,X\n",
        "10 IF INKEY$='' THEN 10\n20 READ A:GOTO 10\n30 DATA 1\n",
        "10 ON ERROR GOTO 30\n20 READ A:GOTO 20\n30 END\n40 DATA 1\n",
        "10 READ A,B#,C%:DATA 1E5,1D5,-3,,+2\n20 READ D,E\n",
        "10 DEFSTR A:READ A,B\n20 DATA X,1\n",
    ],
)
def test_data_that_may_suffice_are_not_told(check: Check, text: str) -> None:
    assert check(text.replace("'", '"')) == []


def test_the_error_that_is_told_of_data_is_the_one_that_the_machine_shows(check: Check) -> None:
    for text, error in (
        ("10 READ A\n20 DATA X\n", "?SN ERROR IN 20"),
        ("10 READ A,B\n20 DATA 1\n", "?OD ERROR IN 10"),
    ):
        (found,) = check(text)
        assert error.endswith(str(found.number))
        rig = Rig()
        rig.load_text(text)
        rig.type("RUN\r")
        rig.run_until_waiting()
        assert any(line.startswith(error) for line in rig.screen())
