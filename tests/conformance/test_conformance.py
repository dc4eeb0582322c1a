"""Every case recorded from the ROM; `python -m tests.conformance` shows more.

They are played on this project's BASIC, and where the environment's `TRS80ARM_TEST_ROM` names a
file with a Level II ROM, on that ROM as well.
"""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from tests.conformance import case, player, verdict
from tests.conformance.exceptions import EXCEPTIONS, ROM_EXCEPTIONS
from tests.conformance.told_times import ToldTimes
from trs80arm.machine.z80.rom import Rom

CASES = list(case.load(Path(__file__).parent / "cases"))
ROM = os.environ.get("TRS80ARM_TEST_ROM")
ENGINES: list[Rom | None] = [None, Rom.read(Path(ROM))] if ROM else [None]


# The tests of a case stand next to each other, so that one process does them and plays it once.
@pytest.mark.parametrize("one", CASES, ids=lambda one: one.id, scope="module")
class TestCases:
    @pytest.mark.parametrize("rom", ENGINES, ids=lambda rom: "basic" if rom is None else rom.crc)
    def test_machine_does_what_the_rom_did(
        self, one: case.Case, rom: Rom | None, told_times: ToldTimes
    ) -> None:
        played = player.play_once(one, rom)
        if rom is None:
            told_times.tell(one.id, played.times)
        differences = verdict.compare(one, played)
        if one.id in (EXCEPTIONS if rom is None else ROM_EXCEPTIONS):
            assert differences, f"{one.id} passes: it is no exception any more"
        else:
            assert not differences, "\n".join(map(str, differences))

    def test_blocks_and_single_statements_are_one_machine(self, one: case.Case) -> None:
        """To the last T-state of every segment."""
        assert player.play(one, blocks=False) == player.play_once(one)
