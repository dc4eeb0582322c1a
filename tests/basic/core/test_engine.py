"""What compiled code is kept, and what it may call."""

from __future__ import annotations

from tests.basic.machine import Machine
from trs80arm.basic.code import CompiledCode


def test_editing_a_program_leaves_nothing_behind_in_the_names_of_compiled_code() -> None:
    machine = Machine()
    engine = machine.basic.state.engine
    assert isinstance(engine, CompiledCode)
    machine.run("10 A#=1.5", "20 GOSUB 40:FOR I=1 TO 2:NEXT", "30 END", "40 RETURN")
    names = set(engine.environment)
    for edit in range(60):
        line = f"{100 + edit} A{edit % 10}#={edit}.25#:FOR K{edit % 7}=1 TO 2:GOSUB 40:NEXT"
        machine.load(line)
        assert machine.do(f"GOSUB 40:RUN {100 + edit}").strip() == ""
    assert set(engine.environment) == names
