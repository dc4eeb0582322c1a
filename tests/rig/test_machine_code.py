"""Machine code beside BASIC: USR and SYSTEM, the ROM's routines answered, BREAK, slices, states."""

from __future__ import annotations

import subprocess
import sys
from random import Random

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from trs80arm.basic.dialogue import machine_code
from trs80arm.basic.errors import Code
from trs80arm.basic.interpreter import Interpreter
from trs80arm.basic.outcome import Ending
from trs80arm.rig import Key, Rig, RigSettings, Waiting

pytest.importorskip("z80", reason="the extra z80 is not installed")

START = 32000
DOUBLES = "CD 7F 0A 29 C3 9A 0A"
"""CALL 0A7FH, ADD HL,HL, JP 0A9AH."""


def program(code: str, *lines: str) -> Rig:
    """A machine that runs a program with machine code at 32000."""
    rig = Rig()
    data = bytes.fromhex(code)
    rig.memory.write(START, data)
    vector = "POKE 16526,0:POKE 16527,125"
    rig.load_text("\n".join((f"10 {vector}", *lines)))
    rig.type("RUN\n")
    return rig


def printed(rig: Rig, seconds: float = 10.0) -> str:
    """What a run prints."""
    codes = bytearray()
    rig.listen(lambda code, is_echo: None if is_echo else codes.append(code))
    rig.run_until_waiting(seconds)
    return codes.decode("latin-1").replace("\r", "\n").rpartition("READY")[0]


def tell_break(rig: Rig, seconds: float) -> None:
    rig.hold([Key.BREAK], seconds)
    rig.run_for(seconds + 0.2)


def test_usr_gives_what_the_code_leaves() -> None:
    assert printed(program(DOUBLES, "20 PRINT USR(21);USR(100)")) == " 42  200 \n"


def test_what_stands_before_a_call_is_done_once() -> None:
    rig = program(DOUBLES, '20 PRINT "X";RND(0);USR(1);"Y";USR(USR(2));', "30 PRINT RND(0)")
    plain = program(DOUBLES, '20 PRINT "X";RND(0); 2 ;"Y"; 8 ;', "30 PRINT RND(0)")
    assert printed(rig) == printed(plain)


def test_a_string_comes_back() -> None:
    rig = program("C9", '20 A$="HELLO":PRINT USR("A");USR(A$);USR(A$+"!")')
    assert printed(rig) == "AHELLOHELLO!\n"


def test_a_string_is_no_number() -> None:
    rig = program("C9", '20 A=USR("A")')
    assert "?TM Error in 20" in printed(rig)


def test_without_a_vector_usr_is_fc() -> None:
    rig = Rig()
    rig.load_text("10 PRINT USR(0)")
    rig.type("RUN\n")
    assert printed(rig) == "?FC Error in 10\n"


@pytest.mark.parametrize(
    ("code", "shows"),
    [
        ("3E 41 CD 33 00 C9", "A"),  # a character
        ("21 07 7D CD A7 28 C9 48 49 00", "HI"),  # a string; see the address
        ("21 D2 04 CD AF 0F C9", "1234"),  # a number
        ("CD C9 01 C9", "\x1c\x1f"),  # clear the screen
    ],
)
def test_routines_of_the_rom_that_print(code: str, shows: str) -> None:
    assert printed(program(code, "20 X=USR(0)")).startswith(shows)


def test_a_block_is_set() -> None:
    # Back, what to do, X; then Y, a text with a parenthesis, and to the routine.
    code = "21 17 7D E5 3E 80 F5 3E 05 F5 3E 07 21 18 7D C3 50 01 00 00 00 00 00 C9 29"
    rig = program(code, "20 X=USR(0)")
    rig.run_until_waiting(5)
    assert rig.console.point(5, 7)


def test_a_key_is_waited_for() -> None:
    rig = program("CD 49 00 6F 26 00 C3 9A 0A", "20 PRINT USR(0)")
    rig.run_for(1)
    assert rig.waiting is Waiting.INPUT
    rig.type("Q")
    assert printed(rig) == " 81 \n"


def test_an_address_of_the_rom_that_is_not_here_is_named() -> None:
    rig = program("CD 34 12", "20 X=USR(0)")
    assert printed(rig) == (
        "Machine code went to 1234H in the ROM, which is not here\n?FC Error in 20\n"
    )
    assert rig.outcome is not None
    assert rig.outcome.code is Code.FC


def test_it_can_be_trapped() -> None:
    rig = program("CD 34 12", "20 ON ERROR GOTO 40", "30 X=USR(0)", "40 PRINT ERR/2+1;ERL:END")
    assert " 5  30 \n" in printed(rig)


def test_a_jump_to_zero_begins_anew() -> None:
    rig = program("C3 00 00", "20 X=USR(0)")
    assert rig.run_until_waiting(5) is Waiting.MEMORY_SIZE
    rig.type("\n")
    assert rig.run_until_waiting(5) is Waiting.COMMAND


def test_halt_comes_back_to_ready() -> None:
    rig = program("76", "20 X=USR(0)")
    assert rig.run_until_waiting(5) is Waiting.COMMAND


@pytest.mark.parametrize(
    ("code", "seconds"),
    [
        ("18 FE", 0.06),  # round and round
        ("F3 18 FE", 0.06),  # interrupts off
        ("3A 40 38 18 FB", 1.1),  # looks at BREAK's row all the time
        ("CD 2B 00 18 FB", 1.1),  # by the ROM's scan
        ("CD 49 00 18 FB", 1.1),
        ("21 00 70 06 20 CD 40 00 18 F6", 1.5),
        ("01 00 00 CD 60 00 18 F8", 0.1),
        ("CD 87 02 18 FB", 0.1),  # leader after leader to the tape
    ],
)
def test_break_ends_any_code(code: str, seconds: float) -> None:
    rig = program(code, "20 X=USR(0)")
    rig.run_for(1)
    tell_break(rig, seconds)
    assert rig.waiting is Waiting.COMMAND
    assert rig.outcome is not None
    assert rig.outcome.ending is Ending.BREAK
    rig.type("PRINT 1\n")
    assert " 1 \n" in printed(rig)


def test_a_leader_leaves_the_registers_as_the_rom_does() -> None:
    # B has counted the bytes to 0; A: the sync byte.
    rig = program("01 34 12 CD 87 02 6F 60 C3 9A 0A", "20 PRINT USR(0)")
    assert printed(rig).startswith(f" {0xA5} \n")


def test_code_that_looks_at_break_gets_it() -> None:
    # Until bit 2 of row 6 is there; then 7.
    rig = program("3A 40 38 E6 04 28 F9 21 07 00 C3 9A 0A", "20 PRINT USR(0)")
    rig.run_for(1)
    rig.hold([Key.BREAK], 0.1)
    rig.run_for(0.05)
    rig.release_all()
    assert "7" in printed(rig) + "".join(rig.screen())


def test_an_out_is_at_its_t_state() -> None:
    rig = Rig()
    seen: list[int] = []

    class Analyser:
        each_step = False

        def wrote(self, times: object, latches: object, nibbles: object) -> None:
            seen.extend(times)  # type: ignore[call-overload]

    rig.watch_latches(Analyser())  # type: ignore[arg-type]
    # OUT (98H),A; 100 times a loop of 13; OUT (98H),A; RET
    rig.memory.write(START, bytes.fromhex("06 64 D3 98 10 FE D3 98 C9"))
    rig.load_text("10 POKE 16526,0:POKE 16527,125:X=USR(0)")
    rig.type("RUN\n")
    rig.run_until_waiting(5)
    assert seen[1] - seen[0] == 99 * 13 + 8 + 11


def test_machine_code_pokes_what_basic_keeps() -> None:
    # LD HL,40AAH; LD (HL),1; INC HL; LD (HL),0; INC HL; LD (HL),0: the seed
    rig = program("21 AA 40 36 01 23 36 00 23 36 00 C9", "20 X=USR(0):PRINT PEEK(16554)")
    assert printed(rig) == " 1 \n"


def test_an_integer_is_changed_by_its_address() -> None:
    code = "CD 7F 0A 36 39 23 36 30 C9"
    rig = program(code, "20 A%=1:X=USR(VARPTR(A%)):PRINT A%")
    assert printed(rig) == f" {0x3039} \n"


def test_system_goes_to_code_in_memory() -> None:
    rig = Rig()
    rig.memory.write(START, bytes.fromhex("3E 58 CD 33 00 C3 CC 06"))
    rig.type("SYSTEM\n/32000\n")
    rig.run_until_waiting(5)
    assert "X" in rig.screen()
    assert rig.waiting is Waiting.COMMAND


POLLS = "21 00 3C 3A 01 38 77 23 7C E6 3F F6 3C 67 D3 98 18 F1"
"""Fills the screen with what row 0 of the keyboard says, and steps the base."""


@settings(max_examples=8, deadline=None)
@given(
    slices=st.lists(st.integers(1, 200_000), min_size=1, max_size=12),
    key=st.sampled_from([Key.A, Key.B]),
)
def test_sliced_equals_whole_and_a_state_goes_on(slices: list[int], key: Key) -> None:
    def begun() -> tuple[Rig, int]:
        rig = program(POLLS, '20 PRINT "X";USR(0)')
        rig.run_for(0.5)
        assert rig.joints[0] != 0, "the code is at work"
        rig.hold([key], 0.2)
        return rig, rig.clock.now

    whole, start = begun()
    whole.run_to(start + sum(slices))
    rig, at = begun()
    for number, length in enumerate(slices):
        at += length
        rig.run_to(at)
        if number % 3 == 1:
            other = Rig(RigSettings())
            other.go_back(rig.snapshot())
            rig = other
    assert (rig.snapshot() == whole.snapshot()) is True


@settings(max_examples=20, deadline=None)
@given(code=st.binary(min_size=1, max_size=400), seconds=st.floats(0.01, 0.3))
# LD HL,F800; LDIR: through all of memory, the words that BASIC keeps for itself among them.
@example(bytes.fromhex("21 00 F8 ED B0"), 0.25)
def test_no_code_raises_an_exception_or_stops_break_and_reset(code: bytes, seconds: float) -> None:
    rig = Rig()
    rig.memory.write(START - 0x100, code)
    rig.type(f"SYSTEM\n/{START - 0x100}\n")
    rig.run_for(1.5 + seconds)
    tell_break(rig, 1.5)
    assert rig.waiting is not Waiting.NOTHING
    rig.reset()
    assert rig.waiting is Waiting.COMMAND


def test_a_million_random_bytes() -> None:
    """Run after run on one machine, whatever the one before has left of it."""
    rng, rig = Random(1980), Rig()
    for number in range(500):
        rig.memory.write(0x5000, rng.randbytes(2000))
        basic = rig.basic
        assert isinstance(basic, Interpreter)
        basic.state.return_to_command()
        machine_code.go(basic.state, 0x5000 + rng.randrange(2000))
        rig.run_to(rig.clock.now + 30_000)
        if number % 50 == 49:
            tell_break(rig, 1.5)
            assert rig.waiting is not Waiting.NOTHING
            rig.reset()
            assert rig.waiting is Waiting.COMMAND


def test_the_reset_button_leads_to_ready() -> None:
    rig = program("F3 3A 40 38 18 FB", "20 X=USR(0)")
    rig.run_for(1)
    rig.push_reset()
    assert rig.run_until_waiting(1) is Waiting.COMMAND
    rig.type("LIST 20\n")
    assert "20 X=USR(0)" in printed(rig)


def test_the_reset_button_leaves_basic_alone() -> None:
    rig = Rig()
    rig.load_text("10 GOTO 10")
    rig.type("RUN\n")
    rig.run_for(1)
    rig.push_reset()
    rig.run_for(1)
    assert rig.waiting is Waiting.NOTHING


def test_the_processor_is_loaded_when_machine_code_runs_and_not_before() -> None:
    script = (
        "import sys; from trs80arm import Rig; rig = Rig(); rig.load_text('10 PRINT 1'); "
        "rig.type('RUN\\n'); rig.run_for(1); before = 'z80' in sys.modules; "
        "rig.memory.write(32000, b'\\xc9'); rig.type('SYSTEM\\n/32000\\n'); rig.run_for(3); "
        "print(before, 'z80' in sys.modules)"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    assert done.stdout.split() == ["False", "True"]
