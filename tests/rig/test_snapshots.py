"""A snapshot is all of a rig: what it does next depends on nothing else."""

from __future__ import annotations

from pathlib import Path

from trs80arm import Rig, RigSettings
from trs80arm.arm.bench import Bench
from trs80arm.arm.settings import ArmSettings
from trs80arm.machine.card import CardSettings
from trs80arm.machine.driver import DriverSettings

BENCH = "[[part]]\nname = 'cube'\nat = [9, 1]\nsize = [1, 1, 1]\nweight = 1\n"
SETTINGS = RigSettings(
    ram_kib=48,
    memory_size="40000",
    armbasic=False,
    blocks=False,
    card=CardSettings(base=0x40, switch_closed=1),
    driver=DriverSettings(set_delay=7),
    arm=ArmSettings(speed_margin=2.0),
    ghosting=True,
)


def free(rig: Rig) -> int:
    rig.type("PRINT MEM\r")
    rig.run_until_waiting()
    lines = rig.screen()
    return int(lines[lines.index("READY", lines.index(">PRINT MEM")) - 1])


def test_a_48k_snapshot_makes_a_16k_rig_one_of_48k_also_after_a_reset() -> None:
    big = Rig(RigSettings(ram_kib=48))
    rig = Rig()
    rig.restore(big.snapshot())
    assert rig.settings.ram_kib == 48
    expected = free(big)
    assert free(rig) == expected > 40000
    rig.reset()
    assert free(rig) == expected


def test_a_snapshot_brings_all_settings_and_the_bench() -> None:
    source = Rig(SETTINGS, Bench.from_toml(BENCH))
    rig = Rig()
    rig.restore(source.snapshot())
    assert rig.settings == SETTINGS
    rig.reset()
    assert rig.settings == SETTINGS
    assert rig.card.settings == SETTINGS.card
    assert rig.driver.settings == SETTINGS.driver
    assert list(rig.arm.bench.parts) == ["cube"]


def test_a_snapshot_names_no_file_and_leaves_those_of_the_rig(tmp_path: Path) -> None:
    there, here = tmp_path / "their-folder", tmp_path / "my-folder"
    theirs = RigSettings(tape_folder=there / "tapes", printer_file=there / "paper.txt")
    mine = RigSettings(tape_folder=here / "tapes", printer_file=here / "paper.txt")
    snapshot = Rig(theirs).snapshot()
    assert b"their-folder" not in snapshot
    here.mkdir()
    rig = Rig(mine)
    rig.restore(snapshot)
    assert rig.settings == mine
    rig.load_text('10 LPRINT "HELLO":CSAVE "A"')
    rig.type("RUN\r")
    rig.run_until_waiting()
    assert (here / "paper.txt").read_text() == "HELLO\n"
    assert (here / "tapes" / "A.cas").is_file()
    assert not there.exists()


def test_the_cassettes_of_a_rig_without_a_folder_are_in_its_snapshot() -> None:
    source = Rig()
    source.load_text("10 REM KEPT")
    source.type('CSAVE "A"\r')
    source.run_until_waiting()
    rig = Rig()
    rig.restore(source.snapshot())
    rig.reset()
    rig.type("CLOAD\rLIST\r")
    rig.run_until_waiting()
    assert "10 REM KEPT" in rig.screen()
