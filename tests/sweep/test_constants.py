"""Numbers of a program, found by name or place and replaced."""

from __future__ import annotations

import pytest

from trs80arm.files import parse_program
from trs80arm.program_text import spell
from trs80arm.sweep.axes import SweepError
from trs80arm.sweep.constants import find, replaced

PROGRAM = """
10 D=50:REM D=60
20 A$="D=70":LET SPEED=-1.5E2:IF D=80 THEN W%=7 ELSE X=8
30 FOR I=1TO3:Y=D+90:NEXT
40 DATA 5, -30,"6",D=4: Q = 12 :R2=S1-3
50 S=1:GOTO 30
60 S=2
"""


@pytest.mark.parametrize(
    ("name", "line"),
    [
        ("D", "10 D=5:REM D=60"),
        ("SP", '20 A$="D=70":LET SPEED=5:IF D=80 THEN W%=7 ELSE X=8'),
        ("W%", '20 A$="D=70":LET SPEED=-1.5E2:IF D=80 THEN W%=5 ELSE X=8'),
        ("X", '20 A$="D=70":LET SPEED=-1.5E2:IF D=80 THEN W%=7 ELSE X=5'),
        ("Q", '40 DATA 5, -30,"6",D=4: Q = 5 :R2=S1-3'),
        ("S@60", "60 S=5"),
        ("20#2", '20 A$="D=70":LET SPEED=-1.5E2:IF D=5 THEN W%=7 ELSE X=8'),
        ("30#2", "30 FOR I=1TO5:Y=D+90:NEXT"),
        ("40#2", '40 DATA 5, 5,"6",D=4: Q = 12 :R2=S1-3'),
        ("40#5", '40 DATA 5, -30,"6",D=4: Q = 12 :R2=S1-5'),
    ],
)
def test_one_number_is_replaced_and_nothing_else(name: str, line: str) -> None:
    lines = parse_program(PROGRAM.encode())
    new = replaced(lines, dict.fromkeys(find(lines, name), 5.0))
    assert [f"{number} {spell(text)}" for number, text in new if (number, text) not in lines] == [
        line
    ]


def test_a_number_of_several_lines_is_replaced_in_each() -> None:
    lines = parse_program(b"10 DATA 1,50\n20 DATA 2,60\n30 DATA 3,70\n")
    new = replaced(lines, dict.fromkeys(find(lines, "10-25#2"), 5.0))
    assert [spell(text) for _, text in new] == ["DATA 1,5", "DATA 2,5", "DATA 3,70"]


def test_numbers_are_written_as_they_are_typed() -> None:
    lines = parse_program(b"10 A=1:B=2\n")
    new = replaced(lines, {find(lines, "A")[0]: -0.25, find(lines, "B")[0]: 1e-7})
    assert spell(new[0][1]) == "A=-.25:B=1E-07".replace("-.25", "-0.25")


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("Y", "no line gives"),
        ("S", "more than once, in 50, 60; say which, as S@50"),
        ("D@20", "line 20 does not give"),
        ("70#1", "no line 70"),
        ("70-80#1", "no lines 70 to 80"),
        ("10#2", "has 1 number$"),
        ("10-20#2", "line 10 has 1 number$"),
        ("W", "no line gives"),
    ],
)
def test_what_is_not_there_or_not_clear_is_told(name: str, said: str) -> None:
    with pytest.raises(SweepError, match=said):
        find(parse_program(PROGRAM.encode()), name)
