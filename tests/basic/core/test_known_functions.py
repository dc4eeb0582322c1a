"""Functions remember what they gave: a program cannot tell, neither by results nor by the clock."""

from __future__ import annotations

import pytest

from tests.basic.machine import Machine
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
    machine.load(f"10 FOR I=1 TO {known.MOST + 10}:S=SIN(I):NEXT")
    machine.do("RUN", seconds=1000)
    sines = machine.basic.state.engine.environment["sin"]
    assert sorted(sines) == [known.MOST + i for i in range(1, 11)]
