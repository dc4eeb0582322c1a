"""The eye on the arm: a look at each step, or at a rate."""

from __future__ import annotations

import csv
import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import trs80arm
from tests.machine.bench_top import Machine
from trs80arm.arm import Bench
from trs80arm.arm.loads import unloaded
from trs80arm.arm.models import MINIMOVER5
from trs80arm.machine.coordination import Pace
from trs80arm.pulses import Burst
from trs80arm.trace import PoseTrace, TraceError

MOTORS = ("base", "shoulder", "elbow", "left_wrist", "right_wrist", "hand")


@dataclass
class Angles:
    base: float
    shoulder: float = 0.5
    elbow: float = -0.25
    pitch: float = -math.pi / 2
    roll: float = 0.0


@dataclass
class HandPose:
    x: float
    y: float = 0.0
    z: float = 1.5
    pitch: float = -90.0
    roll: float = -0.00001
    opening: float = 0.75


@dataclass
class State:
    """A state of an arm whose base follows latch 0, a degree a write."""

    writes: int
    force: float = 0.125
    switch_closed: bool = True

    @property
    def angles(self) -> Angles:
        return Angles(math.radians(self.writes))

    @property
    def pose(self) -> HandPose:
        return HandPose(self.writes / 10)


class Follower:
    """A plug that counts the writes to the base's latch."""

    def __init__(self) -> None:
        self.writes = 0

    def follow(self, burst: Burst, stop: Any = None) -> int:
        self.writes += sum(int(latch) == 0 for latch in burst.columns().latches)
        return len(burst)

    def inputs(self, time: int) -> int:
        return 0b1111


class Rig(Machine):
    loads = unloaded(MINIMOVER5)

    @property
    def state(self) -> State:
        return State(self.card.plug.writes)


def rows(path: Path) -> list[dict[str, str]]:
    return list(csv.DictReader(path.open()))


def test_one_look_at_the_start_and_one_after_each_step(tmp_path):
    rig = Rig(Follower())
    with PoseTrace(rig, tmp_path / "a.csv"):
        rig.step(50, 100, -30)
    table = rows(tmp_path / "a.csv")
    assert [float(row["base"]) for row in table] == list(range(101))
    pace = Pace(0, 50)
    assert [int(row["t_states"]) for row in table] == [0, *(pace.time(k) for k in range(100))]


def test_the_columns_are_degrees_inches_pounds_and_the_switch(tmp_path):
    rig = Rig(Follower())
    with PoseTrace(rig, tmp_path / "a.csv"):
        rig.step(0, 3)
    last = rows(tmp_path / "a.csv")[-1]
    del last["t_states"], last["seconds"]
    assert last == {
        "base": "3.0000",
        "shoulder": f"{math.degrees(0.5):.4f}",
        "elbow": f"{math.degrees(-0.25):.4f}",
        "hand_pitch": "-90.0000",
        "hand_roll": "0.0000",
        "x": "0.3000",
        "y": "0.0000",
        "z": "1.5000",
        "pitch": "-90.0000",
        "roll": "0.0000",
        "opening": "0.7500",
        "force": "0.1250",
        "switch": "1",
        **{f"{name}_{of}": "0.0000" for name in MOTORS for of in ("torque", "used")},
        "grip_needed": "0.0000",
    }


def test_the_columns_tell_what_the_motors_use_before_one_slips(tmp_path):
    rig = trs80arm.Rig(bench=Bench("empty"))
    for joint, value in (("elbow", 0), ("pitch", 0), ("shoulder", 2)):
        rig.move_joint(joint, value)
    with PoseTrace(rig, tmp_path / "a.csv"):
        rig.type("@STEP 80,0,-40\r")
        rig.run_until_waiting()
    table = rows(tmp_path / "a.csv")
    assert max(float(row["shoulder_used"]) for row in table) == pytest.approx(92, abs=1)
    assert max(float(row["shoulder_torque"]) for row in table) == pytest.approx(196, abs=0.5)
    assert {row["grip_needed"] for row in table} == {"0.0000"}


def test_npz_holds_the_same_columns(tmp_path):
    rig = Rig(Follower())
    with PoseTrace(rig, tmp_path / "a.npz"):
        rig.step(0, 60)
    with np.load(tmp_path / "a.npz") as arrays:
        assert arrays["base"].round(6).tolist() == list(range(61))
        assert arrays["switch"].tolist() == [1.0] * 61
        assert len(arrays["t_states"]) == len(arrays["seconds"]) == 61


def test_at_a_rate_each_look_shows_the_arm_as_it_stood_then(tmp_path):
    rig = Rig(Follower())
    rig.clock.now = 1_000_000
    with PoseTrace(rig, tmp_path / "a.csv", rate=100):
        rig.step(50, 50)
        rig.clock.now += 177_408
        rig.step(50, 50)
    table = rows(tmp_path / "a.csv")
    starts = (Pace(1_000_000, 50), Pace(1_000_000 + Pace(0, 50).time(50) + 177_408, 50))
    moves = [pace.time(tick) for pace in starts for tick in range(50)]
    times = [int(row["t_states"]) for row in table]
    assert times == [1_000_000 + int(k * 17740.8) for k in range(len(times))]
    assert rig.clock.now - 17741 <= times[-1] <= rig.clock.now
    for row, time in zip(table, times, strict=True):
        # A step that falls on a look is seen by it.
        assert float(row["base"]) == sum(move <= time for move in moves)


def test_looking_does_not_change_the_writes(tmp_path):
    plain, watched = Rig(Follower()), Rig(Follower())
    plain.step(7, 80, 33, -12)
    with PoseTrace(watched, tmp_path / "a.csv", rate=333.3):
        watched.step(7, 80, 33, -12)
    assert watched.analyser.writes == plain.analyser.writes
    assert watched.card.latches == plain.card.latches


@pytest.mark.parametrize("name", ["a.vcd", "a", "nowhere/a.npz"])
def test_a_pose_trace_that_cannot_be_written_says_so(tmp_path, name):
    rig = Rig(Follower())
    with pytest.raises(TraceError):
        PoseTrace(rig, tmp_path / name)
    assert rig.card.observers == [rig.analyser]


@pytest.mark.parametrize("rate", [0, -1, math.inf, math.nan])
def test_a_rate_must_be_possible(tmp_path, rate):
    with pytest.raises(ValueError):
        PoseTrace(Rig(Follower()), tmp_path / "a.csv", rate=rate)


def test_without_a_path_the_looks_are_arrays():
    rig = trs80arm.Rig()
    with PoseTrace(rig) as eye:
        rig.type("@STEP 50,100\r")
        rig.run_until_waiting()
    arrays = eye.arrays
    assert arrays["base"][-1] == pytest.approx(100 / 937.8 * 57.2958, abs=1e-3)
    assert {len(column) for column in arrays.values()} == {1 + 100}
