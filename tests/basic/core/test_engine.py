"""What compiled code is kept, and what it may call."""

from __future__ import annotations

import pytest

from tests.basic.machine import Machine
from trs80arm.basic import words
from trs80arm.basic.code import CompiledCode
from trs80arm.basic.compiler.emitter import Emitter, UnlistedName
from trs80arm.basic.runtime import environment


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


def test_a_row_that_calls_a_routine_that_is_not_there_is_found_at_the_start(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(words, "CALLS", words.CALLS | {"peak"})
    with pytest.raises(environment.NamesError, match="peak"):
        environment.environment(Machine().basic.state)


def test_a_routine_that_nobody_calls_is_found_at_the_start(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(words, "CALLS", words.CALLS - {"peek"})
    with pytest.raises(environment.NamesError, match="peek"):
        environment.environment(Machine().basic.state)


def test_compiled_text_uses_no_names_beside_the_list() -> None:
    out = Emitter()
    out.emit("open('secret')")
    with pytest.raises(UnlistedName, match="open"):
        out.build(environment.environment(Machine().basic.state))


def test_every_word_says_how_it_is_read() -> None:
    read = {words.Role.STATEMENT, words.Role.FUNCTION}
    assert not [row.spelling for row in words.TABLE if (row.role in read) != bool(row.parser)]
