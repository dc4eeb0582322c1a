"""`Rig.variables`: a program's variables by name, from outside."""

from __future__ import annotations

import pytest

from tests.statements import done
from trs80arm.rig import ChangeError, Rig


@pytest.fixture(scope="module")
def rig() -> Rig:
    return done(
        Rig(), 'A=1/4:A%=7:A#=1/3#:A$="X":WEIGHT=12:DIM P(2,1):P(2,1)=5:I=2', "DEFINT K:K=3:K!=.5"
    )


@pytest.mark.parametrize(
    ("name", "value"),
    [("A", 0.25), ("a%", 7), ("A$", "X"), ("WEIGHTY", 12), ("P(I,1)", 5), ("K", 3), ("K!", 0.5)],
)
def test_a_name_is_read_as_the_program_reads_it(rig: Rig, name: str, value: object) -> None:
    assert rig.variables[name] == value


def test_a_double_is_as_near_as_python_has_it(rig: Rig) -> None:
    assert rig.variables["A#"] == pytest.approx(1 / 3, abs=1e-15)


@pytest.mark.parametrize("name", ["Z", "Z$", "Q(1)", "P(1)", "P(3,0)", "P(A$,1)", "1A", ""])
def test_what_is_not_there_is_a_key_error(rig: Rig, name: str) -> None:
    assert name not in rig.variables
    with pytest.raises(KeyError):
        rig.variables[name]


def test_every_name_that_is_listed_can_be_looked_up(rig: Rig) -> None:
    found = dict(rig.variables)
    assert len(found) == len(rig.variables) == 8 + 6
    assert found["K"] == 3
    assert found["K!"] == 0.5
    assert found["P(2,1)"] == 5


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("B", -2.5),
        ("B%", 12),
        ("B$", 'A "B" C'),
        ("B$", ""),
        ("B#", 1e-20),
        ("C", 1e30),
        ("D", True),
    ],
)
def test_what_is_written_can_be_read(name: str, value: float | str) -> None:
    machine = Rig()
    machine.variables[name] = value
    held = machine.variables[name]
    assert held == (pytest.approx(value) if isinstance(value, float) else value)


@pytest.mark.parametrize(
    ("name", "value", "said"),
    [
        ("A%", 40000, "?OV"),
        ("A", "X", "?TM"),
        ("P(99)", 1, "?BS"),
        ("TO", 1, "?SN|assignment"),
        ("A=1:B", 1, "one statement"),
        ("A", 1e99, "?OV"),
    ],
)
def test_what_the_machine_does_not_take_is_its_error(name: str, value: float, said: str) -> None:
    with pytest.raises(ChangeError, match=said.replace("?", r"\?")):
        Rig().variables[name] = value


def test_no_number_is_no_value() -> None:
    with pytest.raises(ValueError, match="no number"):
        Rig().variables["A"] = float("nan")


def test_writing_takes_no_time_and_a_program_goes_on_with_it() -> None:
    machine = done(Rig(), "10 IF A=0 THEN 10", "20 PRINT A")
    machine.type("RUN\r")
    machine.run_for(1)
    now = machine.clock.now
    machine.variables["A"] = 42
    assert machine.clock.now == now
    assert machine.run_until_text(" 42 \n")


def test_a_line_is_stopped_at_before_its_first_statement_each_time() -> None:
    machine = done(Rig(), "10 FOR I=1 TO 3", "20 A=I:B=0", "30 NEXT")
    machine.type("RUN\r")
    assert machine.run_until_line(20)
    assert "A" not in machine.variables
    assert machine.run_until_line(20)
    assert machine.variables["A"] == 1
    assert machine.run_until_line(20)
    assert not machine.run_until_line(20, seconds=1)


def test_a_text_counts_from_the_call_on() -> None:
    machine = done(Rig(), 'PRINT "HERE"')
    assert not machine.run_until_text("HERE", seconds=0.5)
