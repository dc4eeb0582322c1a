"""The five ARMBASIC statements as the language reads them."""

from __future__ import annotations

import pytest

from tests.basic.machine import Machine


def test_step_floors_its_numbers_and_fills_up_with_zeros() -> None:
    machine = Machine()
    assert machine.do("@STEP 50.9,1,-2.5,3") == ""
    assert machine.arm.calls == [("step", 50, (1, -3, 3, 0, 0, 0))]


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("@STEP", "?MO"),
        ("@STEP 5,", "?MO"),
        ("@STEP -1", "?FC"),
        ("@STEP 1,40000", "?OV"),
        ('@STEP "A"', "?TM"),
        ("@STEP 1,1,1,1,1,1,1,1", "?SN"),
        ("@STEP 5 6)", "?SN"),
        ("@RESET 5", "?SN"),
        ("@READ", "?SN"),
        ("@READ A$", "?TM"),
        ("@READ A,B,C,D,E,F,G", "?SN"),
        ("@READ 5", "?SN"),
        ("@PRINT", "?SN"),
        ("@", "?SN"),
        ("@CLOSE -1", "?FC"),
        ("A=@READ", "?SN"),
    ],
)
def test_mistakes(line: str, message: str) -> None:
    machine = Machine()
    assert machine.do(line) == f"{message} Error\n"


@pytest.mark.parametrize("line", ["@STEP 5", "@CLOSE", "@SET", "@RESET", "@READ A"])
def test_without_armbasic_they_are_syntax_errors(line: str) -> None:
    machine = Machine(armbasic=False)
    assert machine.do(line) == "?SN Error\n"
    assert not machine.arm.calls


def test_read_converts_to_the_variables() -> None:
    machine = Machine()
    machine.arm.registers = [1, -2, 3, 4, 5, 6]
    assert machine.do("@READ A,B%,C#,D(2):PRINT A;B%;C#;D(2)") == " 1 -2  3  4 \n"


def test_blanks_may_stand_behind_the_sign() -> None:
    machine = Machine()
    machine.do("@ RESET:@ CLOSE 20:@SET")
    assert machine.arm.calls == [("reset",), ("close", 20), ("set", None)]


def test_a_program_goes_on_behind_a_motion() -> None:
    machine = Machine()
    assert machine.run("10 FOR I=1 TO 3:@STEP 9,I:NEXT:@READ A:PRINT A") == " 6 \n"
