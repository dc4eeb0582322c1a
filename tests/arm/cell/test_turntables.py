"""Turntables behind a pulse-and-direction board, driven from BASIC by OUT alone."""

from __future__ import annotations

import math

import pytest

from tests.arm.cell.cells import at_the_cell, run, started
from tests.slices import sliced
from trs80arm import Rig
from trs80arm.arm.cell.turntable import Turntable
from trs80arm.arm.contact.clock import T_STATES_PER_SECOND
from trs80arm.arm.events import EventKind
from trs80arm.arm.minimover import MiniMover

TWO = """
[[turntable]]
name = "left"
at = [6, 5]
radius = 2
drive = "pulse"
pulse = 0
direction = 1
[[turntable]]
name = "right"
at = [6, -5]
radius = 2
steps = 192
drive = "pulse"
pulse = 2
[[part]]
name = "on the left"
at = [7, 5]
size = [0.5, 0.5, 0.5]
[[part]]
name = "on the right"
at = [7, -5]
size = [0.5, 0.5, 0.5]
"""

TURNS = """10 FOR I=1 TO 12:OUT 158,5:OUT 158,0:GOSUB 50:NEXT
20 FOR I=1 TO 24:OUT 158,3:OUT 158,2:GOSUB 50:NEXT
30 FOR I=1 TO 200:NEXT
40 END
50 FOR J=1 TO 30:NEXT:RETURN
"""
"""Twelve half-steps of both, then twenty-four of the left one backwards."""


def angle(rig: Rig, part: str, x: float, y: float) -> float:
    """Degrees by which a part stands around an axis."""
    place = rig.arm.bench.parts[part].place
    return math.degrees(math.atan2(place[1] - y, place[0] - x))


def tables(arm: MiniMover) -> list[Turntable]:
    return [device for device in arm.bench.cell.devices if isinstance(device, Turntable)]


def test_a_rising_edge_turns_a_plate_by_a_half_step_the_way_its_other_bit_says() -> None:
    rig = at_the_cell(TWO)
    run(rig, TURNS)
    assert [table.rotor for table in tables(rig.arm)] == [-12, 12]
    assert angle(rig, "on the left", 6, 5) == pytest.approx(-45, abs=4)
    assert angle(rig, "on the right", 6, -5) == pytest.approx(22.5, abs=4)
    assert rig.registers == (0,) * 6


def test_pulses_that_come_too_fast_lose_rings_as_those_of_any_motor() -> None:
    arm = at_the_cell(TWO).arm
    arm.apply([1000 * k for k in range(200)], [6] * 200, [1, 0] * 100)
    (slip,) = arm.events
    assert (slip.kind, slip.motor, slip.text) == (
        EventKind.SLIP,
        6,
        f"left slipped {abs(slip.steps)} steps: too fast",
    )
    left, _ = tables(arm)
    assert left.rotor == 100 + slip.steps
    assert slip.steps % 8 == 0


def test_a_plate_turns_the_same_sliced_with_a_snapshot_between() -> None:
    ends = []
    for in_slices in (False, True):
        rig = started(at_the_cell(TWO), TURNS)
        if in_slices:
            rig = sliced(rig, (0.1 + 0.013 * k for k in range(20)), range(0, 20, 7))
        rig.run_until_waiting(12)
        rig.run_to(12 * T_STATES_PER_SECOND)
        parts = [(part.name, part.place, part.turn) for part in rig.arm.bench.parts.values()]
        ends.append((parts, rig.arm.events, rig.snapshot()))
    assert ends[0] == ends[1]
