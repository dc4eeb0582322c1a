"""The display and keyboard drivers against what the original ROM's did, to the T-state.

The recordings in `golden/` are of random codes and keys, run through the ROM's own routines.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from trs80arm.machine.clock import Clock
from trs80arm.machine.display import Display
from trs80arm.machine.keyboard import KeyboardDriver, Matrix
from trs80arm.machine.keys import Key
from trs80arm.machine.memory import Memory
from trs80arm.machine.video import BLANK, CELLS, Video

GOLDEN = Path(__file__).parent / "golden"


def recordings(name: str) -> list[str]:
    lines = (GOLDEN / name).read_text().splitlines()
    return [line for line in lines if not line.startswith("#")]


@pytest.mark.parametrize("recording", recordings("display.txt"))
def test_the_display_driver_is_the_roms(recording: str) -> None:
    fields = [field.strip() for field in recording.split("|")]
    routine, start, codes, t_states, end, cells = fields
    clock, memory, video = Clock(), Memory(16), Video()
    display = Display(clock, memory, video)
    video.fill(0, CELLS)
    display.cursor = int(start)
    took = []
    for code in codes.split():
        before = clock.now
        (display.put if routine == "print" else display.echo)(int(code))
        took.append(clock.now - before)
    assert took == [int(item) for item in t_states.split()]
    assert display.cursor == int(end)
    shown = [f"{place}:{code}" for place, code in enumerate(video.cells) if code != BLANK]
    assert shown == cells.split()


@pytest.mark.parametrize("recording", recordings("keyboard.txt"))
def test_the_keyboard_scan_is_the_roms(recording: str) -> None:
    clock, matrix = Clock(), Matrix()
    driver = KeyboardDriver(clock, Memory(16), matrix)
    for step in recording.split(" || "):
        held, found = step.split("|")
        matrix.release_all()
        for name in held.split():
            matrix.press(Key(name))
        code, more = found.split()
        before = clock.now
        assert driver.scan() == int(code)
        assert clock.now - before == int(more)
