"""What an edit of the program leaves of what was compiled from it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from tests.basic.machine import Machine
from trs80arm.basic.compiler.statements import StatementCompiler

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


def test_what_stands_before_a_changed_line_is_not_compiled_again(
    written: Callable[[], int],
) -> None:
    machine = Machine()
    machine.load(*LINES)
    run(machine)
    assert written() > 200
    machine.basic.store_line(900, b"A=-900:PRINT A")
    assert b"\r-900 \r" in run(machine)
    assert written() < 50


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
