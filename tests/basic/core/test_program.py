"""The program in memory and the cruncher."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.basic.machine import Machine
from trs80arm.basic import cruncher, words
from trs80arm.basic.errors import BasicError


def test_the_words_have_the_tokens_of_the_rom() -> None:
    assert [words.TOKENS[word] for word in ("END", "PRINT", "SGN", "'")] == [128, 178, 215, 251]


@pytest.mark.parametrize(
    ("typed", "stored"),
    [
        ("PRINT", b"\xb2"),
        ("?", b"\xb2"),
        ("print", b"\xb2"),
        ("FORI=1TO10", b"\x81I\xd51\xbd10"),
        ("IFATHEN5ELSE6", b"\x8fA\xca5:\x956"),
        ("'X", b":\x93\xfbX"),
        ("REM print", b"\x93 print"),
        ('A$="print"', b'A$\xd5"print"'),
        ("DATA for,x:for", b"\x88 for,x:\x81"),
        ("GO TO 5", b"\x8d 5"),
        ("@STEP 5", b"@\xcc 5"),
        ("P R I N T", b"P R I N T"),
    ],
)
def test_lines_are_crunched_as_the_rom_does(typed: str, stored: bytes) -> None:
    assert cruncher.crunch(typed.encode()).text == stored


@given(
    st.lists(st.sampled_from([w.decode() for w in words.SPELLINGS[:-1]]), min_size=1, max_size=6)
)
def test_what_is_spelled_out_crunches_to_the_same_line(words: list[str]) -> None:
    crunched = cruncher.crunch(" ".join(words).encode()).text
    assert cruncher.crunch(cruncher.spell(crunched)).text == crunched


def test_a_line_number_above_65529_is_a_syntax_error() -> None:
    assert cruncher.split_line(b"65529 A")[0] == 65529
    with pytest.raises(BasicError, match="SN"):
        cruncher.split_line(b"65530 A")


def test_lines_stand_in_memory_from_42e9_with_links() -> None:
    machine = Machine()
    machine.load("20 PRINT", "10 A=1")
    ram = machine.memory.ram
    assert bytes(ram[17129:17145]) == b"\xf1\x42\x0a\0A\xd51\0\xf7\x42\x14\0\xb2\0\0\0"
    assert machine.basic.program.numbers() == [10, 20]
    assert machine.basic.program.end == 17145


def test_a_stored_line_replaces_the_old_one_and_an_empty_one_deletes_it() -> None:
    machine = Machine()
    machine.load("10 A=1", "20 B=2", "10 C=3")
    assert [text for _, text in machine.basic.program.lines()] == [b"C\xd53", b"B\xd52"]
    machine.load("10")
    assert machine.basic.program.numbers() == [20]


def test_a_program_that_pokes_itself_runs_what_it_poked() -> None:
    machine = Machine()
    assert machine.run("10 GOTO 30", "20 PRINT 1:END", "30 POKE 17144,50:GOTO 20") == " 2 \n"


@given(
    st.dictionaries(st.integers(0, 65529), st.text("ABC=1:", min_size=1, max_size=9), max_size=8)
)
def test_lines_are_kept_in_order_whatever_the_order_of_typing(lines: dict[int, str]) -> None:
    machine = Machine()
    for number, text in lines.items():
        machine.load(f"{number} X{text}")
    assert machine.basic.program.numbers() == sorted(lines)


@given(
    st.lists(
        st.one_of(
            st.tuples(st.integers(1, 12), st.sampled_from([b"A", b"PRINT 1", b"B\xd5\x02:C"])),
            st.integers(1, 12),
            st.tuples(st.just("poke"), st.integers(0, 90), st.integers(0, 255)),
        ),
        max_size=15,
    )
)
def test_what_is_known_of_the_lines_after_a_change_is_what_the_links_lead_to(
    changes: list[Any],
) -> None:
    machine = Machine()
    program, ram = machine.basic.program, machine.memory.ram
    for change in changes:
        match change:
            case ("poke", place, value):
                ram[program.start + place] = value
                program.changed()
            case (number, text):
                program.store(number, text)
            case number:
                program.delete(number)
        known = program._walk()
        program._index = None
        assert program._walk() == known
