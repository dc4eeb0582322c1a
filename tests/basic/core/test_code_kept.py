"""What an edit of the program leaves of what was compiled from it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from tests.basic.machine import Machine
from trs80arm.basic.compiler.statements import StatementCompiler

FIND = "2000 Q=PEEK(VARPTR(A$)+1)+256*PEEK(VARPTR(A$)+2):RETURN"
"""Where the literal stands in the program that A$ was given."""
LINES = [f"{number} A={number}:PRINT A" for number in range(10, 1010, 10)]


@pytest.fixture
def written(monkeypatch: pytest.MonkeyPatch) -> Callable[[], int]:
    """How many statements were compiled since it was asked last."""
    counted = 0
    compile_ = StatementCompiler.compile

    def compiled(self: StatementCompiler) -> bool:
        nonlocal counted
        counted += 1
        return compile_(self)

    def ask() -> int:
        nonlocal counted
        counted, before = 0, counted
        return before

    monkeypatch.setattr(StatementCompiler, "compile", compiled)
    return ask


def run(machine: Machine, seconds: float = 100) -> bytes:
    before = len(machine.screen.printed)
    machine.do("RUN", seconds=seconds)
    return bytes(machine.screen.printed[before:])


@pytest.mark.parametrize("number", [10, 300, 900, 1000])
@pytest.mark.parametrize("text", [b"A=-900:PRINT A", b"PRINT-900", b"IF 1 THEN PRINT-900"])
def test_only_a_changed_line_is_compiled_again(
    written: Callable[[], int], number: int, text: bytes
) -> None:
    machine = Machine()
    machine.load(*LINES)
    run(machine)
    assert written() > 200
    machine.basic.store_line(number, text)
    assert b"\r-900 \r" in b"\r" + run(machine)
    assert written() < 6


def test_a_line_that_comes_or_goes_is_known_to_the_jumps_over_it(
    written: Callable[[], int],
) -> None:
    machine = Machine()
    machine.load(*LINES, "1005 IF A=1000 THEN PRINT 5:GOTO 15 ELSE GOTO 700")
    assert b"?UL Error in 1005" in run(machine)
    written()
    machine.basic.store_line(15, b"PRINT 15:END")
    assert run(machine).endswith(b" 15 \rREADY\r>")
    assert written() < 250


def test_a_jump_forward_over_an_edit_finds_its_line() -> None:
    machine = Machine()
    machine.load("10 GOTO 40", "20 PRINT 2", "30 PRINT 3", "40 PRINT 4:END")
    assert run(machine).startswith(b" 4 \r") or b" 4 \r" in run(machine)
    machine.basic.store_line(20, b"PRINT 22222")
    assert b" 4 \r" in run(machine)
    machine.basic.store_line(40, b"PRINT 44:END")
    assert b" 44 \r" in run(machine)


def test_run_in_a_line_that_has_moved_goes_to_the_start() -> None:
    machine = Machine()
    machine.load(
        '10 PRINT "A";:PRINT PEEK(30000)', "20 IF PEEK(30000)=1 THEN END", "30 POKE 30000,1:RUN"
    )
    machine.do("POKE 30000,0")
    assert run(machine).startswith(b"A 0 \rA 1 \r")
    for line in (b"PRINT 15", b"REM A LONGER LINE", b""):
        machine.basic.store_line(15, line)
        machine.do("POKE 30000,0")
        assert run(machine).count(b"A ") == 2


def test_an_error_in_a_line_that_has_moved_is_found_there() -> None:
    machine = Machine()
    machine.load("10 A=0", "20 B=1:C=B/A:PRINT C", "30 PRINT 3")
    assert b"?/0 Error in 20" in run(machine)
    machine.basic.store_line(15, b"B=2")
    assert b"?/0 Error in 20" in run(machine)
    assert machine.do("PRINT ERL;C") == " 20  0 \n"


def test_a_literal_in_a_line_that_has_moved_is_pointed_to_there() -> None:
    machine = Machine()
    machine.load('10 A$="ARM":PRINT A$', '20 B$="HAND":PRINT B$:READ C$:PRINT C$', "30 DATA BENCH")
    assert run(machine).startswith(b"ARM\rHAND\rBENCH\r")
    for text in (b"REM", b'PRINT "ROBOT"', b""):
        machine.basic.store_line(5, text)
        assert run(machine).endswith(b"ARM\rHAND\rBENCH\rREADY\r>")
        assert machine.do("PRINT B$;LEN(B$)") == "HAND 4 \n"


def test_a_poke_into_a_literal_leaves_the_rest_of_the_program_alone(
    written: Callable[[], int],
) -> None:
    machine = Machine()
    machine.load('1 A$="ARM":GOSUB 2000:FOR I=0 TO 2:POKE Q+I,88+I:NEXT:PRINT A$', *LINES, FIND)
    assert run(machine).startswith(b"XYZ\r 10 \r")
    assert written() > 200
    assert run(machine).startswith(b"XYZ\r 10 \r")
    assert written() < 20


def test_a_poke_into_a_jump_has_it_go_elsewhere() -> None:
    machine = Machine()
    machine.load(
        '10 A$="Z":GOTO 30',
        "20 PRINT 20:END",
        "30 GOSUB 2000:PRINT PEEK(Q+5)",
        "40 POKE Q+5,50:GOTO 10",
        FIND,
    )
    assert run(machine).startswith(b" 51 \r 20 \r")


def test_a_poke_into_a_line_number_has_the_line_found_by_another() -> None:
    machine = Machine()
    machine.load(
        "10 GOSUB 50:GOSUB 2000",
        "20 POKE Q-6,60:GOSUB 60",
        "30 GOSUB 50",
        '50 A$="Z":PRINT "FIFTY":RETURN',
        FIND,
    )
    assert run(machine).startswith(b"FIFTY\rFIFTY\r?UL Error in 30\r")


def test_a_line_that_comes_behind_one_that_was_jumped_back_to_is_not_passed() -> None:
    machine = Machine()
    machine.load("40 X=40", "50 PRINT X:STOP", "60 DIM X:GOTO 40")
    assert machine.do("RUN 60").startswith(" 40 \n")
    machine.basic.store_line(45, b"X=45")
    assert machine.do("RUN 60").startswith(" 45 \n")
    machine.basic.store_line(45, b"")
    machine.basic.store_line(50, b"PRINT-X:STOP")
    assert machine.do("RUN 60").startswith("-40 \n")
