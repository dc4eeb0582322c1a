from __future__ import annotations

import pytest

from trs80arm.arm import benchfile
from trs80arm.drawing.readings import Kind, Readings, things_of
from trs80arm.rig import Rig

BENCH = """
name = "all sorts"
[[feeder]]
name = "supply"
at = [8.0, 0.0]
size = [0.5, 0.5, 1.0]
weight = 0.4
[[tray]]
name = "tray"
at = [6.0, 5.0]
size = [2.0, 2.0]
[[obstacle]]
name = "wall"
at = [11.0, 3.0]
size = [0.5, 4.0, 4.0]
[[part]]
name = "block"
at = [9.0, -4.0]
size = [1.0, 1.0, 1.0]
weight = 1
[turntable]
at = [9.0, -5.0]
radius = 2.5
"""


def test_everything_on_the_bench_but_the_arms_own_base_is_seen() -> None:
    things = list(things_of(benchfile.parse(BENCH)))
    assert {thing.kind for thing in things} == {
        Kind.FEEDER,
        Kind.TRAY,
        Kind.OBSTACLE,
        Kind.PART,
        Kind.TURNTABLE,
    }
    assert [thing.name for thing in things if thing.kind is Kind.OBSTACLE] == ["wall"]


def test_an_arm_that_has_lost_no_step_has_no_twin() -> None:
    rig = Rig()
    rig.type("@STEP 50,100,-50,60,20,20,30\r")
    rig.run_until_waiting()
    readings = Readings.of(rig)
    assert readings.registers == readings.joints == (100, -50, 60, 20, 20, 30)
    assert readings.believed is None
    assert readings.motors_on
    assert not readings.switch_closed


def test_an_arm_driven_too_fast_is_believed_elsewhere() -> None:
    rig = Rig()
    rig.type("@STEP 0,800\r")
    rig.run_until_waiting()
    readings = Readings.of(rig)
    assert readings.registers[0] == 800
    assert readings.joints[0] < 800
    assert readings.believed is not None
    told, true = readings.believed.angles, readings.posture.angles
    assert told.base - true.base == pytest.approx((800 - readings.joints[0]) / 937.8)
    assert told.shoulder == true.shoulder


def test_a_closed_hand_is_seen_by_switch_force_and_lamps() -> None:
    rig = Rig()
    rig.type("@CLOSE\r")
    rig.run_until_waiting()
    readings = Readings.of(rig)
    assert readings.switch_closed
    assert readings.force >= 2 / 16
    assert readings.coils[5] != 0
