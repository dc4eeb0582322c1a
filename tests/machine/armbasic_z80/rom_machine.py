"""A machine under the real ROM that has read the driver's tape.

There is one where `TRS80ARM_TEST_ROM` names a Level II ROM of one's own.
"""

from __future__ import annotations

import os
from dataclasses import replace
from functools import cache
from pathlib import Path

from tests.machine.armbasic_z80.assembled import maker
from trs80arm.machine.z80.rom import Rom
from trs80arm.rig import Rig, RigSettings, Waiting

ROM = os.environ.get("TRS80ARM_TEST_ROM")
SETTINGS = RigSettings(memory_size="31200")


def load_tape(rig: Rig, size: int = 16) -> None:
    """SYSTEM, its name, `/`, READY."""
    rig.insert_cassette("armbasic", maker().tape_file(size).read_bytes())
    for text, waiting in (
        ("SYSTEM", Waiting.SYSTEM),
        (f"ARM{size}", Waiting.SYSTEM),
        ("/", Waiting.COMMAND),
    ):
        rig.type(text + "\r")
        assert rig.run_until_waiting(120) is waiting
    rig.eject_cassette()


@cache
def with_tape() -> tuple[RigSettings, bytes]:
    """A machine under the ROM that has read the tape."""
    assert ROM is not None
    settings = replace(SETTINGS, armbasic=False, rom=Rom.read(Path(ROM)))
    rig = Rig(settings)
    load_tape(rig)
    return settings, rig.snapshot()


def under_the_rom() -> Rig:
    settings, snapshot = with_tape()
    rig = Rig(settings)
    rig.restore(snapshot)
    return rig
