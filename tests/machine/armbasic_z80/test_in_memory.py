"""The driver as it is put into memory for a ROM of one's own, and known again there."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.machine.armbasic_z80.assembled import driver
from tests.machine.armbasic_z80.board import Board
from tests.machine.armbasic_z80.rom_machine import ROM
from tests.machine.z80.own_rom import own_rom
from trs80arm.arm.bench import Bench
from trs80arm.arm.settings import ArmSettings
from trs80arm.machine.card import CardSettings, Jumper, Latch
from trs80arm.machine.memory import Memory
from trs80arm.machine.z80.rom import Rom
from trs80arm.rig import Rig, RigSettings, Waiting
from trs80arm.works import rom_driver

OTHERWISE = CardSettings(base=0x40, coil_bits=(0, 1, 2, 3), switch_bit=3, switch_closed=1)
"""A card wired in another way."""


@pytest.mark.parametrize("size", [16, 32, 48])
def test_it_is_the_one_of_the_source(size: int) -> None:
    memory, image = Memory(size), driver(size)
    start = rom_driver.put_in(memory, size, CardSettings())
    assert start == image.origin == rom_driver.ORIGINS[size]
    assert memory.read(start, len(image.image)) == image.image
    assert rom_driver.origin(memory.ram, CardSettings()) == start


def test_places_in_it_are_where_its_source_has_them() -> None:
    symbols, start = driver().symbols, driver().origin
    assert start + rom_driver.RESET_DONE == symbols["PACE"] - 1
    assert driver().image[rom_driver.RESET_DONE] == 0xC9
    for offset, name in (
        (rom_driver._PORT, "BASE"),
        (rom_driver._SWITCH, "GRIP"),
        (rom_driver._CLOSED, "SHUT"),
        (rom_driver._RING, "RING"),
        (rom_driver._COUNTS, "COUNTS"),
        (rom_driver._ZEROS, "ZEROS"),
    ):
        assert start + offset == symbols[name]


def test_it_is_made_for_the_card() -> None:
    memory = Memory(16)
    start = rom_driver.put_in(memory, 16, OTHERWISE)
    assert memory.read(start + 39, 3) == bytes((0x40, 8, 8))
    assert memory.read(start + 64, 8) == bytes((10, 2, 6, 4, 5, 1, 9, 8))
    assert rom_driver.origin(memory.ram, OTHERWISE) == start
    assert rom_driver.origin(memory.ram, CardSettings()) is None


def test_a_memory_without_it_has_none() -> None:
    assert rom_driver.origin(Memory(16).ram, CardSettings()) is None


def test_its_registers_are_what_read_gives() -> None:
    board, memory, start = Board(), Memory(16), driver().origin
    board.move(0, 3, 3, 3, 3, 3, 3)
    assert board.call("OFF")
    board.move(0, 5, -3, 40, 0, 7, -11)
    memory.write(start, bytes(board.chip.memory[start : memory.top]))
    assert rom_driver.registers(memory, start) == board.registers == (5, -3, 40, 0, 7, -11)
    rom_driver.zero(memory, start)
    assert rom_driver.registers(memory, start) == (0, 0, 0, 0, 0, 0)


@pytest.mark.parametrize(
    ("ram", "card", "says"),
    [
        (4, CardSettings(), "16 K"),
        (16, CardSettings(jumper=Jumper.PARALLEL), "on the bus"),
        (16, CardSettings(order=(None, *Latch)), "six ports"),
    ],
)
def test_a_machine_that_it_cannot_drive_is_told(ram: int, card: CardSettings, says: str) -> None:
    with pytest.raises(rom_driver.DriverError, match=says):
        rom_driver.check(ram, card)


def test_the_registers_are_the_arms_own_computers_where_it_has_one() -> None:
    settings = RigSettings(rom=own_rom(), controller=True, arm=ArmSettings(model="teachmover"))
    assert not settings.has_armbasic
    rig = Rig(settings)
    rom_driver.put_in(rig.memory, 16, rig.settings.card)
    rig.receive(b"@STEP 100,5\r")
    rig.run_for(1)
    assert rig.registers == rig.joints == (5, 0, 0, 0, 0, 0)


@pytest.mark.skipif(ROM is None, reason="TRS80ARM_TEST_ROM names no ROM")
@pytest.mark.parametrize("size", [16, 32, 48])
@pytest.mark.parametrize("card", [CardSettings(), OTHERWISE], ids=["usual", "otherwise"])
def test_a_machine_with_its_own_rom_has_armbasic_when_it_is_switched_on(
    size: int, card: CardSettings
) -> None:
    assert ROM is not None
    rig = Rig(RigSettings(ram_kib=size, rom=Rom.read(Path(ROM)), card=card))
    assert rig.waiting is Waiting.COMMAND
    rig.type("@STEP 100,50,-30,20,0,0,100\r")
    rig.run_until_waiting()
    assert rig.registers == (50, -30, 20, 0, 0, 100)
    assert rig.joints == rig.registers
    resets: list[int] = []
    rig.watch_resets(lambda: resets.append(rig.clock.now))
    rig.type("@RESET:@STEP 100,0,0,8:@READ A,B,C:PRINT A;B;C\r")
    rig.run_until_waiting()
    assert rig.registers == rig.joints == (0, 0, 8, 0, 0, 0)
    assert len(resets) == 1
    assert any(line.startswith(" 0  0  8") for line in rig.screen())
    rig.set_bench(Bench.standard())
    assert rig.registers == (0, 0, 0, 0, 0, 0)
    rig.reset()
    rig.type("@STEP 100,5\r")
    rig.run_until_waiting()
    assert rig.registers[0] == 5
