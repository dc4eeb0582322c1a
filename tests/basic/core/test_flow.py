"""Loops, jumps, subroutines, errors: in single statements and in blocks."""

from __future__ import annotations

import pytest

from tests.basic.machine import Machine


@pytest.fixture(params=[False, True], ids=["statements", "blocks"])
def machine(request: pytest.FixtureRequest) -> Machine:
    return Machine(blocks=request.param)


def test_a_loop_runs_its_body_at_least_once(machine: Machine) -> None:
    assert machine.run("10 FOR I=5 TO 1:PRINT I;:NEXT:PRINT I") == " 5  6 \n"


def test_next_of_an_outer_loop_drops_the_inner_one(machine: Machine) -> None:
    text = machine.run("10 FOR I=1 TO 2:FOR J=1 TO 2:NEXT I:PRINT J:NEXT J")
    assert text == " 1 \n?NF Error in 10\n"


def test_a_subroutine_hides_its_callers_loops(machine: Machine) -> None:
    assert machine.run("10 FOR I=1 TO 2:GOSUB 20", "20 NEXT") == "?NF Error in 20\n"


def test_a_jump_into_a_loop_finds_no_loop(machine: Machine) -> None:
    assert machine.run("10 GOTO 30", "20 FOR I=1 TO 3", "30 PRINT I:NEXT").startswith(" 0 \n?NF")


def test_what_stands_before_a_syntax_error_is_done(machine: Machine) -> None:
    assert machine.run("10 PRINT 1;2)") == " 1  2 \n?SN Error in 10\n"


def test_an_evaluation_error_comes_before_a_syntax_error_behind_it(machine: Machine) -> None:
    assert machine.run("10 A=1/0)").startswith("?/0 Error in 10")


def test_resume_goes_back_to_the_whole_if_statement(machine: Machine) -> None:
    lines = ["10 ON ERROR GOTO 50", "20 A=A+1:IF A<3 THEN PRINT A;:PRINT 1/B", "30 END"]
    assert machine.run(*lines, "50 B=1:RESUME NEXT") == " 1 \n"


def test_an_error_in_the_handler_is_not_trapped(machine: Machine) -> None:
    lines = ["10 ON ERROR GOTO 30", "20 ERROR 5", "30 PRINT ERL;:ERROR 6"]
    assert machine.run(*lines) == " 20 \n?OV Error in 30\n"


def test_cont_goes_on_behind_stop_with_loops_open(machine: Machine) -> None:
    assert machine.run("10 FOR I=1 TO 2:STOP:PRINT I;:NEXT") == "Break in 10\n"
    assert machine.do("CONT") == " 1 \nBreak in 10\n"


def test_changing_a_line_forbids_cont(machine: Machine) -> None:
    machine.run("10 STOP")
    machine.load("20 REM")
    assert machine.do("CONT").strip() == "?CN Error"


def test_trace_shows_each_new_line(machine: Machine) -> None:
    text = machine.run("10 TRON", "20 FOR I=1 TO 2", "30 NEXT", "40 TROFF")
    assert text == "<20><30><30><40>\n"


def test_break_stops_between_statements_and_cont_repeats_nothing(machine: Machine) -> None:
    machine.load("10 A=A+1:GOTO 10")
    machine.do("RUN", seconds=1)
    machine.screen.keys.append(1)
    machine.clock.limit += 1_000_000
    machine.basic.advance(until_waiting=True)
    assert b"Break in 10" in machine.screen.printed
    assert machine.basic.state.control.resume_address


def test_break_does_nothing_when_its_vector_is_poked(machine: Machine) -> None:
    machine.load("10 GOTO 10")
    machine.do("POKE 16396,23")
    machine.do("RUN", seconds=1)
    machine.screen.keys.append(1)
    machine.clock.limit += 1_000_000
    machine.basic.advance(until_waiting=True)
    assert b"Break" not in machine.screen.printed


@pytest.mark.parametrize(
    ("lines", "wanted"),
    [
        (["10 DEFINT A:A=2.7:PRINT A:DEFSNG A:PRINT A"], " 2 \n 0 \n"),
        (["10 FOR K=1 TO 2:A=2.5:PRINT A;:DEFINT A:NEXT"], " 2.5  2 \n"),
        (["10 X=5:CLEAR:PRINT X"], " 0 \n"),
        (["10 A(3)=4:PRINT A(3);:CLEAR:DIM A(20):A(20)=7:PRINT A(20)"], " 4  7 \n"),
        (["10 ON 2 GOSUB 30,40:END", "30 PRINT 3", "40 PRINT 4:RETURN"], " 4 \n"),
        (["10 IF 0 THEN IF 1 THEN PRINT 1 ELSE PRINT 2 ELSE PRINT 3"], " 3 \n"),
        (["10 READ A$,B:PRINT A$;B", "20 DATA X Y , 5"], "X Y  5 \n"),
    ],
)
def test_programs(machine: Machine, lines: list[str], wanted: str) -> None:
    assert machine.run(*lines) == wanted
