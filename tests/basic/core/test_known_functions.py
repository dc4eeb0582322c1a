"""Functions remember what they gave: a program cannot tell, neither by results nor by the clock."""

from __future__ import annotations

from unittest import mock

import pytest

from tests.basic.machine import Machine
from trs80arm.basic.numbers import functions
from trs80arm.basic.runtime import known

CALLS = [
    *(f"{name}({x})" for name in ("SIN", "COS", "TAN", "ATN", "EXP") for x in ("0", "1", "-1.7")),
    *(f"{name}({x})" for name in ("LOG", "SQR") for x in ("1", "2.5")),
    *("SQR(0)", "2[3", "0[2", "1[9", "5[0", "0[0", "(-2)[3"),
]


def _shown(machine: Machine, line: str) -> tuple[bytes, int]:
    machine.do("PRINT")
    before = len(machine.screen.printed), machine.clock.now
    machine.do(line)
    return bytes(machine.screen.printed[before[0] :]), machine.clock.now - before[1]


@pytest.mark.parametrize("call", CALLS)
def test_the_second_time_is_like_the_first(call: str) -> None:
    machine = Machine()
    first = _shown(machine, f"PRINT {call}")
    assert _shown(machine, f"PRINT {call}") == first


@pytest.mark.parametrize("call", ["LOG(0)", "SQR(-1)", "EXP(99)", "(-2)[.5", "0[(-1)"])
def test_an_error_is_none_the_cheaper_for_being_known(call: str) -> None:
    machine = Machine()
    first = _shown(machine, f"PRINT {call}")
    assert b"Error" in first[0]
    assert _shown(machine, f"PRINT {call}") == first


def test_only_the_last_few_thousand_are_remembered() -> None:
    machine = Machine()
    machine.load(f"10 FOR I=1 TO {known.MOST + 10}:S=SIN(I+(I/2=INT(I/2))/2):NEXT")
    machine.do("RUN", seconds=1000)
    sines = machine.basic.state.engine.environment["sin"]
    last = range(known.MOST + 1, known.MOST + 11)
    assert sorted(sines) == [i if i % 2 else i - 0.5 for i in last]


IN_STEPS = [
    "FOR I=-900 TO 900:GOSUB 90:NEXT",
    "FOR I=0 TO 8 STEP .01:GOSUB 90:NEXT",
    "FOR I=6000 TO -3000 STEP -7:GOSUB 90:NEXT",
    "FOR I=16777000 TO 16777300:GOSUB 90:NEXT",
    "FOR I=1 TO 3000:X=I:IF I/90=INT(I/90) THEN I=I+1:GOSUB 90:NEXT ELSE GOSUB 90:NEXT",
]


@pytest.mark.parametrize("loop", IN_STEPS)
@pytest.mark.parametrize("call", ["SIN(I)", "COS(I)", "ATN(I)", "EXP(I/100)", "I[2", "I[3"])
def test_arguments_in_steps_are_computed_ahead_and_nobody_can_tell(call: str, loop: str) -> None:
    assert _sum(call, loop) == _sum(call, loop, ahead=False)


@pytest.mark.parametrize("call", ["LOG(I)", "SQR(I)", "I[.5", "I[1.5"])
@pytest.mark.parametrize("loop", IN_STEPS)
def test_steps_may_come_to_an_error(call: str, loop: str) -> None:
    assert _sum(call, loop) == _sum(call, loop, ahead=False)


def _sum(call: str, loop: str, *, ahead: bool = True) -> tuple[bytes, int]:
    machine = Machine()
    machine.load(
        "5 ON ERROR GOTO 95",
        f"10 {loop}",
        "20 PRINT S;E:END",
        f"90 S=S/2+{call}:RETURN",
        "95 E=E+I:RESUME NEXT",
    )
    with mock.patch.object(known, "_IN_STEPS", known._IN_STEPS if ahead else 10**9):
        machine.do("RUN", seconds=10_000)
    return bytes(machine.screen.printed), machine.clock.now


def test_a_loop_in_steps_asks_for_few_arguments_itself() -> None:
    machine = Machine()
    machine.load("10 FOR I=1 TO 3000:S=S+I[2:NEXT")
    with mock.patch.object(functions, "power", wraps=functions.power) as asked:
        machine.do("RUN", seconds=10_000)
    assert asked.call_count < 100
