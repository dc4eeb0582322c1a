"""A user's own ROM: known by its checksum, run on the processor, never kept in a state."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.machine.z80.own_rom import own_rom
from trs80arm.machine import cassette
from trs80arm.machine.z80.rom import SIZE, Rom, RomError
from trs80arm.rig import Key, Rig, RigSettings, SnapshotError, Waiting

pytest.importorskip("z80", reason="the extra z80 is not installed")


SLICE = 3_701
"""T-states, no multiple of anything."""


@pytest.fixture
def rig() -> Rig:
    return Rig(RigSettings(rom=own_rom()))


def test_a_rom_has_twelve_kibibytes(tmp_path: Path) -> None:
    for size in (0, SIZE - 1, SIZE + 1):
        path = tmp_path / "level2.rom"
        path.write_bytes(bytes(size))
        with pytest.raises(RomError, match="12288 bytes"):
            Rom.read(path)


def test_a_rom_is_told_by_its_checksum() -> None:
    rom = own_rom()
    assert rom.told == f"ROM: an unknown one, CRC-32 {rom.crc.upper()}"
    assert Rom("0d8a132e").name == "Level II 1.2 of March 1979"


def test_a_rom_of_which_only_the_checksum_is_known_has_no_bytes() -> None:
    with pytest.raises(RomError, match="needs the ROM with the checksum 0d8a132e"):
        _ = Rom("0d8a132e").content


def test_the_rom_runs_the_machine(rig: Rig) -> None:
    assert rig.screen()[0].startswith("HI")
    assert rig.waiting is Waiting.INPUT
    rig.type("ABC")
    rig.run_for(1)
    assert rig.screen()[0].startswith("HIABC")
    assert rig.card.latches[0] == ord("C") & 0xF


def test_what_the_rom_shows_is_heard(rig: Rig) -> None:
    heard: list[int] = []
    rig.listen(lambda code, is_echo: heard.append(code))
    rig.type("DAB")
    rig.run_for(1)
    assert bytes(heard) == b"DAB"


def test_peek_sees_the_rom_and_poke_does_not_change_it(rig: Rig) -> None:
    rig.memory.poke(0, 0)
    assert rig.memory.peek(0) == 0xF3


def test_sliced_equals_whole(rig: Rig) -> None:
    whole = rig.snapshot()
    rig.type("CAB")
    begun = rig.clock.now
    rig.run_to(begun + 240 * SLICE)
    there = rig.snapshot()
    rig.restore(whole)
    rig.type("CAB")
    for number in range(1, 241):
        rig.run_to(begun + number * SLICE)
    assert (rig.snapshot() == there) is True


def test_a_snapshot_has_the_checksum_and_no_byte_of_the_rom(rig: Rig) -> None:
    snapshot = rig.snapshot()
    assert own_rom().crc.encode() in snapshot
    with pytest.raises(SnapshotError, match="start with --rom"):
        Rig().restore(snapshot)
    other = Rig(RigSettings(rom=own_rom()))
    other.restore(snapshot)
    assert (other.snapshot() == snapshot) is True


def test_halt_is_the_reset_button(rig: Rig) -> None:
    processor = rig._works.processor
    rig.memory.poke(0x5000, 0x76)
    processor.registers.pc = 0x5000
    rig.basic.waiting = Waiting.NOTHING  # type: ignore[misc]
    rig.run_for(0.1)
    assert not processor.registers.halted
    assert rig.screen()[0].startswith("HIHI")


def test_keys_are_seen_at_their_time(rig: Rig) -> None:
    rig.press(Key.A)
    rig.run_for(0.01)
    assert rig.screen()[0].startswith("HIA")


def test_manual_mode_of_the_z80_driver_is_waited_in_until_its_key_0(rig: Rig) -> None:
    driver = Path(__file__).parents[3] / "programs" / "armbasic-16k.cas"
    (recording,) = cassette.parse(driver.read_bytes())
    assert isinstance(recording, cassette.SystemRecording)
    for address, block in recording.blocks:
        rig.memory.write(address, block)
    # LD DE,50; CALL MANUAL; CALL 002BH; JR on the spot
    rig.memory.write(0x5000, bytes.fromhex("113200 CDE979 CD2B00 18FE"))
    rig._works.processor.registers.pc = 0x5000
    rig.basic.waiting = Waiting.NOTHING  # type: ignore[misc]
    assert rig.run_until_waiting(1) is Waiting.SET
    rig.restore(rig.snapshot())
    rig.hold([Key.N1], 0.27)
    rig.run_for(0.5)
    assert rig.waiting is Waiting.SET
    assert 95 <= rig.joints[0] <= 105
    rig.hold([Key.N0], 0.1)
    rig.run_for(0.5)
    assert rig.waiting is Waiting.NOTHING


def test_the_reset_button_begins_at_0066(rig: Rig) -> None:
    rig.memory.write(0x5000, b"\x18\xfe")
    rig._works.processor.registers.pc = 0x5000
    rig.push_reset()
    rig.run_for(0.1)
    assert rig.screen()[0].startswith("HIHI")
    assert rig.waiting is Waiting.INPUT
