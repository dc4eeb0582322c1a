"""The tape without a ROM: SYSTEM loads it beside this project's BASIC, and USR moves the arm."""

from __future__ import annotations

import pytest

from tests.machine.armbasic_z80.assembled import blocks, maker
from tests.machine.bench_top import Analyser
from trs80arm.rig import Key, Rig, RigSettings, Waiting

pytest.importorskip("z80", reason="the extra z80 is not installed")


def loaded(size: int = 16, answer: str = "31100") -> Rig:
    """A machine that has read the tape and started it."""
    rig = Rig(RigSettings(memory_size=answer, ram_kib=size))
    rig.insert_cassette("armbasic", maker().tape_file(size).read_bytes())
    typed = [
        ("SYSTEM", Waiting.SYSTEM),
        (f"ARM{size}", Waiting.SYSTEM),
        ("/", Waiting.COMMAND),
    ]
    for text, waiting in typed:
        rig.type(text + "\r")
        assert rig.run_until_waiting(120) is waiting
    return rig


def ran(rig: Rig, program: str) -> list[str]:
    """Run a program; what is on the tube."""
    rig.load_text(program)
    rig.type("CLS:RUN\r")
    assert rig.run_until_waiting(60) is Waiting.COMMAND
    return [line.strip() for line in rig.screen() if line.strip()]


def test_the_pages_usr_program_moves_the_arm_and_reads_the_registers() -> None:
    rig = loaded()
    arrays, _ = blocks("usr")
    assert ran(rig, arrays)[0] == "21  3  0"
    assert rig.joints == (21, 3, 0, 0, 0, 0)


def test_the_pages_own_machine_program_turns_base_and_shoulder() -> None:
    rig = loaded()
    _, data = blocks("usr")
    ran(rig, data)
    assert rig.joints == (100, -100, 0, 0, 0, 0)
    assert rig.registers == (0, 0, 0, 0, 0, 0)


@pytest.mark.parametrize("size", [16, 32, 48])
def test_usr_does_what_the_statement_does(size: int) -> None:
    origin = maker().ORIGINS[size]
    rig = loaded(size, str(origin))
    written = Analyser()
    rig.watch_latches(written)
    entry = origin + 27
    ran(
        rig,
        f"10 DEFINT A:DIM A(6):X=0:POKE 16526,{entry % 256}:POKE 16527,{entry // 256}\n"
        "20 FOR I=0 TO 6:READ A(I):NEXT:X=USR(VARPTR(A(0)))\n"
        "30 DATA 20,30,-20,10,-5,5,7\n",
    )
    other = Rig()
    statement = Analyser()
    other.watch_latches(statement)
    ran(other, "10 @STEP 20,30,-20,10,-5,5,7\n")
    assert [write[1:] for write in written.writes] == [write[1:] for write in statement.writes]


def test_close_and_reset_by_usr() -> None:
    rig = loaded()
    screen = ran(
        rig,
        "10 POKE 16526,254:POKE 16527,121:PRINT USR(50)\n"
        "20 POKE 16526,236:POKE 16527,121:X=USR(0)\n",
    )
    assert screen[0] == "0"
    assert rig.state.switch_closed
    assert rig.card.latches[:6] == [0] * 6


def test_manual_mode_by_usr_takes_keys_until_0() -> None:
    rig = loaded()
    rig.load_text("10 POKE 16526,1:POKE 16527,122:PRINT USR(50)\n")
    rig.type("CLS:RUN\r")
    rig.run_for(3)
    rig.hold([Key.N1, Key.W], 0.27)
    rig.run_for(1)
    assert 95 <= rig.joints[0] <= 105
    assert rig.joints[1] == -rig.joints[0]
    rig.hold([Key.N0], 0.1)
    rig.run_for(1)
    assert rig.screen()[0].strip() == "0"


def test_with_all_memory_for_basic_the_driver_takes_what_it_needs() -> None:
    rig = loaded(answer="")
    rig.type("PRINT MEM\r")
    rig.run_until_waiting()
    fresh = Rig(RigSettings(memory_size="31200"))
    fresh.type("PRINT MEM\r")
    fresh.run_until_waiting()
    numbers = [
        next(line for line in reversed(machine.screen()) if line.strip().isdigit())
        for machine in (rig, fresh)
    ]
    assert numbers[0] == numbers[1]
