"""Variables and strings as the machine's memory shows them."""

from __future__ import annotations

import pickle

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from tests.basic.machine import Machine
from trs80arm.basic.system_area import SystemArea
from trs80arm.basic.variables import Variables, decode, encode


def test_poke_into_a_variable_changes_it() -> None:
    machine = Machine()
    assert machine.do("A%=0:P=VARPTR(A%):POKE P,5:POKE P+1,1:PRINT A%") == " 261 \n"


def test_a_number_can_be_poked_byte_by_byte_from_the_mantissa_up() -> None:
    machine = Machine()
    line = "A=0:P=VARPTR(A):POKE P,205:POKE P+1,204:POKE P+2,76:POKE P+3,125:PRINT A"
    assert machine.do(line) == " .1 \n"


def test_a_new_simple_variable_moves_the_arrays() -> None:
    machine = Machine()
    machine.do("DIM A%(3):A%(0)=11:P=VARPTR(A%(0))")
    assert machine.do("Q=5:PRINT VARPTR(A%(0))-P") == " 7 \n"


def test_a_literal_of_the_program_costs_no_string_space() -> None:
    machine = Machine()
    assert machine.run('10 A$="LITERAL":PRINT FRE(A$);:A$=A$+"X":PRINT FRE(A$)') == " 50  42 \n"


def test_string_space_full_of_garbage_is_collected() -> None:
    machine = Machine()
    assert machine.run('10 FOR I=1 TO 200:A$=STR$(I):NEXT:PRINT A$;FRE("")') == " 200 46 \n"


def test_more_than_the_string_space_holds_is_an_error() -> None:
    machine = Machine()
    assert machine.do('A$=STRING$(51,"A")') == "?OS Error\n"


def test_a_string_can_be_laid_over_other_memory() -> None:
    machine = Machine()
    line = 'A$="..":P=VARPTR(A$):POKE 20000,72:POKE 20001,73:POKE P+1,32:POKE P+2,78:PRINT A$'
    assert machine.run(f"10 {line}") == "HI\n"


def test_mem_counts_program_variables_and_stack() -> None:
    machine = Machine()
    assert machine.do("PRINT MEM") == " 15572 \n"
    machine.load("10 A=1")
    assert machine.do("PRINT MEM") == " 15564 \n"
    assert machine.run("10 FOR I=1 TO 1:GOSUB 20", "20 PRINT MEM") == " 15516 \n"


def test_endless_gosub_fills_the_memory() -> None:
    assert Machine().run("10 GOSUB 10") == "?OM Error in 10\n"


@pytest.mark.parametrize(
    ("address", "value"),
    [(16548, 17129), (16561, 32767), (16544, 32717), (16598, 32767), (16526, 0x1E4A)],
)
def test_system_words(address: int, value: int) -> None:
    machine = Machine()
    peek = machine.memory.peek
    assert peek(address) | peek(address + 1) << 8 == value


@settings(max_examples=30)
@given(st.dictionaries(st.integers(*SystemArea.RANGE), st.integers(0, 255), max_size=30))
@example({0x40A0: 0, 0x40A1: 0})
def test_whatever_is_poked_system_words_are_bytes(pokes: dict[int, int]) -> None:
    memory = Machine().memory
    for address, value in pokes.items():
        memory.poke(address, value)
    assert all(0 <= memory.peek(address) <= 255 for address in range(*SystemArea.RANGE))


def test_the_seed_is_where_programs_poke_it() -> None:
    machine = Machine()
    machine.do("POKE 16554,0:POKE 16555,0:POKE 16556,0")
    assert machine.do("PRINT RND(100);RND(100);RND(100)") == " 3  47  27 \n"


@given(st.sampled_from("isdt"), st.binary(min_size=8, max_size=8))
def test_bytes_in_memory_are_values_and_back(kind: str, data: bytes) -> None:
    size = {"i": 2, "s": 4, "d": 8, "t": 3}[kind]
    raw = data[:size]
    if kind in "sd" and not raw[-1]:
        return
    assert encode(kind, decode(kind, raw)) == raw


@settings(max_examples=30)
@given(st.lists(st.tuples(st.sampled_from("ABC"), st.sampled_from("isdt")), max_size=8))
def test_every_address_of_the_tables_belongs_to_one_variable(keys: list[tuple[str, str]]) -> None:
    variables = Variables()
    variables.start = 17131
    for key in keys:
        scalar = variables.scalar(key)
        if scalar.offset is None:
            variables.create(scalar)
    total = sum(s.size for s in variables.order)
    assert variables.end == 17131 + total
    for scalar in variables.order:
        assert variables.peek(variables.address(scalar) - 1) == ord(scalar.name)


def test_a_running_program_can_be_pickled_and_goes_on_the_same() -> None:
    program = ['10 A$=A$+"X":B(2)=B(2)+1:IF B(2)<40 THEN 10', "20 PRINT LEN(A$);B(2)"]
    one = Machine()
    one.load("5 CLEAR 200", *program)
    one.do("RUN", seconds=0.2)
    two = pickle.loads(pickle.dumps(one))
    for machine in (one, two):
        machine.clock.limit += 100_000_000
        machine.basic.advance(until_waiting=True)
    assert one.screen.printed == two.screen.printed
    assert one.clock.now == two.clock.now
    assert b" 40  40 " in one.screen.printed
