"""The list of what generated code may hold lets the compiler's text pass, and nothing else."""

from __future__ import annotations

import pytest

from tests.fuzz import generated, noise
from tests.fuzz.checks import BrokenError
from tests.fuzz.machines import Commanded
from trs80arm import Rig

FRAME = "def cells():\n v_A_s = None\n def statement():\n  {}\n  return 17130\n return statement\n"


@pytest.mark.parametrize(
    "line", ["clock.now += 5", "t1 = mul(v_A_s, 2.0)", "f = frames[-1]; frames.pop()", "poke(1, 2)"]
)
def test_what_the_compiler_writes_passes(line: str) -> None:
    code = FRAME.format(line)
    generated.look_at(code)
    with pytest.raises(BrokenError, match="in generated code"):
        generated.look_at(code.replace("return 17130", "import os"))


@pytest.mark.parametrize(
    "line",
    [
        *("import os", "from os import system", "global clock", "del clock", "raise t1"),
        *("t1 = open", "t1 = open('a')", "t1 = exec('5')", "t1 = __import__", "os = 5"),
        *("t1 = clock.__class__", "t1 = mul.__globals__", "clock.limit = 5", "t1 = f.data"),
        *("t1 = lambda: 5", "t1 = [t2 for t2 in frames]", "t1 = 'text'", "t1 = f'{t2}'"),
        *("frames.clear()", "t1 = mul(t2, x=5)", "t1 = mul(*frames)", "t1 = t2()", "yield"),
        *("with t1: pass", "assert t1", "t1 = {}", "t1 = [5]", "t1: int = 5", "t1 = 5j"),
    ],
)
def test_nothing_else_passes(line: str) -> None:
    with pytest.raises(BrokenError, match="in generated code"):
        generated.look_at(FRAME.format(line))


@pytest.mark.parametrize("listing", noise.PROGRAMS, ids=range(len(noise.PROGRAMS)))
def test_the_programs_that_come_along_compile_to_what_is_listed(listing: str) -> None:
    rig = Rig()
    rig.load_text(listing)
    with generated.watched():
        rig.type("RUN\r")
        rig.run_for(2)
    assert rig.basic.state.engine.environment


def test_a_register_that_moves_by_itself_is_seen() -> None:
    rig = Rig()
    rig.load_text("10 @STEP 50,9\n20 PRINT 2")
    watch = Commanded(rig)
    first = rig.basic.program.start - 1
    second = rig.basic.program.find(20)
    assert second is not None
    watch.statement(10, first)
    rig.driver.registers = (9, 0, 0, 0, 0, 0)
    watch.statement(20, second - 1)
    rig.driver.registers = (8, 0, 0, 0, 0, 0)
    with pytest.raises(BrokenError, match="without a command"):
        watch.statement(10, first)
