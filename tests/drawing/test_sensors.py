"""Sensors in the pictures: where they are on table and arm, and whether they answer."""

from __future__ import annotations

import math

import numpy as np
import pytest

from trs80arm.arm import Pose, benchfile
from trs80arm.drawing.bench_solids import solids_of
from trs80arm.drawing.materials import Material
from trs80arm.drawing.readings import Kind, Readings, Thing
from trs80arm.rig import Rig

MOUNTED = """
[arm]
at = [8, 0, 2]
opening = 1.0
[selector]
bits = [0, 1]
[[tactile]]
name = "tip"
on = "left finger"
bit = 1
[[tactile]]
name = "pad"
on = "right finger"
face = "inner"
bit = 2
[[tactile]]
name = "bumper"
on = "forearm"
bit = 3
[[proximity]]
name = "palm"
on = "palm"
range = 4
bit = 1
bank = 1
[[force]]
name = "load"
on = "shoulder"
threshold = 5
bit = 2
bank = 1
[[home]]
name = "home"
joint = "base"
at = 0
bit = 3
bank = 1
"""


def sensors(rig: Rig) -> dict[str, Thing]:
    return {thing.name: thing for thing in Readings.of(rig).things if thing.kind is Kind.SENSOR}


def test_what_is_mounted_on_the_arm_is_drawn_where_the_arm_has_it() -> None:
    rig = Rig(bench=benchfile.parse(MOUNTED))
    for pose in (Pose(8, 0, 2, -90, 0, 1.0), Pose(6, 5, 3, -90, 0, 2.0)):
        rig.move_to(pose)
        seen = {name: thing.box.center for name, thing in sensors(rig).items()}
        half = pose.opening / 2
        # With roll 0 in the world the fingers stand along y, the left one to the left.
        assert seen["tip"] == pytest.approx((pose.x, pose.y + half + 0.1, pose.z), abs=0.02)
        assert seen["pad"] == pytest.approx((pose.x, pose.y - half, pose.z + 0.85), abs=0.02)
        assert seen["palm"] == pytest.approx((pose.x, pose.y, pose.z + 1.7), abs=0.06)
        assert seen["load"] == pytest.approx((0, 0, 8.1), abs=1e-6)
        x, y, z = seen["home"]
        assert math.hypot(x, y) < 2
        assert z < 3


def test_a_sensor_that_answers_is_of_a_brighter_material() -> None:
    rig = Rig(bench=benchfile.parse(MOUNTED))
    seen = sensors(rig)
    assert {name for name, thing in seen.items() if thing.on} == {"palm", "home"}
    for thing in seen.values():
        material = Material.SENSOR if thing.on else Material.IDLE
        assert np.unique(solids_of(thing, 10).shape.materials).tolist() == [material]


def test_the_bank_that_the_selector_shows_is_read() -> None:
    rig = Rig(bench=benchfile.parse(MOUNTED))
    assert Readings.of(rig).bank == 0
    rig.type("OUT 158,1\r")
    rig.run_until_waiting()
    assert Readings.of(rig).bank == 1
    assert Readings.of(Rig()).bank is None
