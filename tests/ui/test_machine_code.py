"""Machine code in the terminal: a game at the machine's speed beside the arm; a user's ROM."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.machine.z80.own_rom import own_rom
from tests.ui.piloted import piloted
from tests.ui.sitting import Opener
from trs80arm.rig import Key, RigSettings

pytest.importorskip("z80", reason="the extra z80 is not installed")

TAPE = Path(__file__).parents[2] / "programs" / "catch.cas"


@piloted
async def test_a_game_runs_beside_the_arm(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        rig = sitting.app.session.rig
        rig.insert_cassette("CATCH", TAPE.read_bytes())
        for line in ("SYSTEM", "CATCH"):
            await sitting.type_line(line)
        rig.type("/\r")
        await sitting.pass_time(1)
        before, base = rig.clock.now, rig.joints[0]
        rig.hold([Key.RIGHT], 0.4)
        await sitting.pass_time(0.5)
        assert rig.clock.now - before == pytest.approx(0.5 * 1_774_080, rel=0.1)
        assert rig.joints[0] > base
        assert sitting.tube.startswith("CATCH  CAUGHT")


@piloted
async def test_the_checksum_of_a_rom_is_told(sit_down: Opener) -> None:
    async with sit_down(rig=RigSettings(rom=own_rom())) as sitting:
        assert sitting.tube.startswith("HI")
        assert own_rom().crc.upper() in sitting.app._notice
