"""Why it slips, or does not: what motors bear and have, cables, and the grip against friction."""

from __future__ import annotations

from math import tau

import pytest

from tests.slices import elsewhere
from trs80arm import Rig
from trs80arm.arm import ArmModel, Bench, Motor, Pose, benchfile
from trs80arm.arm.events import EventKind
from trs80arm.arm.models import MINIMOVER5, TEACHMOVER

SHOULDER = 1


def stretched() -> Rig:
    """An arm held out level, its motors off."""
    rig = Rig(bench=Bench("empty"))
    for joint, value in (("elbow", 0), ("pitch", 0), ("shoulder", 2)):
        rig.move_joint(joint, value)
    return rig


def typed(rig: Rig, line: str) -> int:
    """Type a line; the greatest use of the shoulder that a look at each fiftieth second finds."""
    rig.type(line + "\r")
    most = 0
    while rig.typing or rig.waiting.name != "COMMAND":
        rig.run_for(0.02)
        most = max(most, rig.loads.motors[SHOULDER].per_cent)
    return most


def slips(rig: Rig) -> int:
    return sum(event.kind is EventKind.SLIP for event in rig.arm.events)


def test_the_shoulder_is_seen_at_92_per_cent_before_it_slips() -> None:
    rig = stretched()
    seen: list[tuple[int, bool]] = []
    for delay in (100, 90, 80, 70, 60, 50, 40):
        use = typed(rig, f"@RESET:@STEP {delay},0,-60")
        seen.append((use, slips(rig) > 0))
        typed(rig, "@STEP 100,0,60")
    uses = [use for use, _ in seen]
    assert uses == sorted(uses)
    assert (92, False) in seen
    # What has slipped stood above all that it has; what stood below it has not slipped.
    assert seen[-1][1]
    assert all(use > 100 for use, slipped in seen if slipped)
    assert all(not slipped for use, slipped in seen if use <= 100)


def test_a_standing_motor_bears_its_load_with_what_it_holds() -> None:
    rig = stretched()
    typed(rig, "@STEP 200,0,-1")
    rig.run_for(1)
    load = rig.loads.of(Motor.SHOULDER)
    assert load.rate == 0
    assert load.torque == load.against == pytest.approx(196, abs=0.5)
    assert load.has == pytest.approx(644)
    assert load.used == pytest.approx(196 / 644, abs=0.001)
    assert load.margin == pytest.approx(1 - load.used)


def test_without_current_the_gears_friction_is_what_a_motor_has() -> None:
    load = stretched().loads.of(Motor.SHOULDER)
    assert not load.energised
    assert load.has == pytest.approx(380, abs=0.5)


def test_the_torque_at_the_rotor_is_the_joint_s_over_its_gearing() -> None:
    # 937.8 half-steps a radian and 96 a turn: the shoulder's motor turns 61.4 times as far.
    load = stretched().loads.of(Motor.SHOULDER)
    assert load.rotor_torque == pytest.approx(load.torque / (937.8 * tau / 96))
    assert load.cable == pytest.approx(load.torque / 1.5)


@pytest.mark.parametrize("model", [MINIMOVER5, TEACHMOVER])
def test_pulleys_are_as_large_as_the_steps_per_radian_say(model: ArmModel) -> None:
    sizes = {drive.turns: drive.pulley for drive in model.drives}
    assert sizes[Motor.BASE] == sizes[Motor.SHOULDER] == pytest.approx(1.5)
    assert sizes[Motor.SHOULDER] / sizes[Motor.ELBOW] == pytest.approx(1.70, abs=0.01)
    assert sizes[Motor.ELBOW] / sizes[Motor.LEFT_WRIST] == pytest.approx(2.707, abs=0.01)
    # An inch of cable opens the hand by an inch.
    assert sizes[Motor.HAND] == pytest.approx(0.988, abs=0.01)


def test_going_down_the_weight_helps_and_the_rate_alone_counts() -> None:
    rig = stretched()
    rig.type("@STEP 50,0,-200:@RESET:@STEP 50,0,180\r")
    rig.run_until_waiting()
    # 370 half-steps a second of 666 against no torque at all, squared.
    assert rig.loads.motors[SHOULDER].peak == 31


def test_peaks_count_from_reset_on() -> None:
    rig = stretched()
    typed(rig, "@STEP 60,0,-60")
    assert rig.loads.motors[SHOULDER].peak == 100
    typed(rig, "@RESET")
    assert [load.peak for load in rig.loads.motors] == [0] * 6
    typed(rig, "@STEP 200,0,-20")
    assert 0 < rig.loads.motors[SHOULDER].peak < 100


def test_a_peak_does_not_hang_on_who_looks_and_when() -> None:
    line = "@STEP 50,200,-150,60,40,-40,90\r"
    once, often = stretched(), stretched()
    for rig in (once, often):
        rig.type(line)
    once.run_for(5)
    for _ in range(500):
        often.run_for(0.01)
        assert often.loads.hardest.used < 2
    peaks = [load.peak for load in once.loads.motors]
    assert peaks == [load.peak for load in often.loads.motors]
    assert all(peaks)


def test_a_peak_is_of_the_bench_at_which_the_arm_stands() -> None:
    low, high = Bench("low"), Bench("high")
    low.start, high.start = Pose(6.0, 0.0, 4.0, -90.0, 0.0), Pose(9.0, 0.0, 11.0, 0.0, 0.0)
    motion = "@STEP 60,60,-100,60,40,40"
    moved, fresh = Rig(bench=low), Rig(bench=high)
    typed(moved, motion)
    before = [load.peak for load in moved.loads.motors]
    moved.set_bench(high)
    for rig in (moved, fresh):
        typed(rig, motion)
    peaks = [load.peak for load in moved.loads.motors]
    assert peaks == [load.peak for load in fresh.loads.motors]
    assert peaks != before


def test_a_peak_is_part_of_a_snapshot() -> None:
    rig = stretched()
    typed(rig, "@STEP 60,0,-60")
    other = elsewhere(rig)
    assert other.loads == rig.loads


def gripping(weight: float, squeeze: int) -> Rig:
    """A part between the fingers, gripped until the switch closes, and then squeezed."""
    bench = Bench("one part")
    bench.add_part("load", (0.5, 0.5, 1.0), weight, 8.0, 0.0)
    rig = Rig(bench=bench)
    rig.move_to(Pose(8.0, 0.0, 0.5, -90.0, 0.0, 1.0))
    rig.type(f"@CLOSE 100:@STEP 100,0,0,0,0,0,{-squeeze}\r")
    rig.run_until_waiting()
    return rig


def test_the_grip_s_force_stands_beside_what_holding_takes() -> None:
    grip = gripping(4.0, 30).loads.grip
    assert grip.weight == 4.0
    assert grip.force == pytest.approx(37 / 52, abs=0.02)
    # Two pads of 0.75: a pound of force holds 24 oz.
    assert grip.needed == pytest.approx(4 / 24)
    assert grip.used == pytest.approx(grip.needed / grip.force)
    assert grip.carries == pytest.approx(24 * grip.force)


def test_a_part_too_heavy_for_the_grip_needs_more_than_there_is() -> None:
    rig = gripping(12.0, 0)
    used = rig.loads.grip.used
    assert used is not None
    assert used > 1
    assert rig.state.held is None
    # From just above what it needs on the hand holds it.
    rig.type("@STEP 100,0,0,0,0,0,-40\r")
    rig.run_until_waiting()
    used = rig.loads.grip.used
    assert used is not None
    assert used < 1
    assert rig.state.held == "load"


TOWER = """
[arm]
at = [8, 0, 0.3]
opening = 1.2
[[part]]
name = "pier"
at = [8, 0]
size = [0.8, 0.6, 0.8]
weight = 2
[[part]]
name = "deck"
at = [8, 0]
bottom = 0.8
size = [0.8, 0.4, 0.3]
weight = 5
[[part]]
name = "top"
at = [8, 0]
bottom = 1.1
size = [0.4, 0.4, 0.3]
weight = 1
"""
BEAM = """
[[part]]
name = "beam"
at = [8.6, 0]
bottom = 1.4
size = [1.6, 0.3, 0.2]
weight = 3
[[part]]
name = "post"
at = [9.3, 0]
size = [0.2, 0.2, 1.4]
weight = 3
"""


def told(bench: str, *lines: str) -> Rig:
    """A machine at a bench when it has done some statements and all has come to rest."""
    rig = Rig(bench=benchfile.parse(bench))
    for line in lines:
        typed(rig, line)
    rig.run_for(0.5)
    return rig


@pytest.mark.parametrize(("squeeze", "holds"), [(1, False), (6, False), (20, True)])
def test_all_that_rides_on_a_part_has_to_be_held(squeeze: int, holds: bool) -> None:
    rig = told(TOWER, "@CLOSE 60", f"@STEP 60,0,0,0,0,0,-{squeeze}")
    grip = rig.loads.grip
    assert grip.weight == 8
    assert grip.used is not None
    assert (grip.used < 1) is holds
    assert rig.state.held == ("pier" if holds else None)
    typed(rig, "@STEP 200,0,-60,15")
    rig.run_for(0.5)
    assert (rig.arm.bench.parts["pier"].bottom > 0.3) is holds
    assert rig.loads.grip.weight == 8


def test_what_something_else_carries_too_does_not_ride_on_the_part() -> None:
    # A beam from the tower to a post on the table.
    assert told(TOWER + BEAM, "@CLOSE 60").loads.grip.weight == 2


def test_an_empty_hand_needs_no_force() -> None:
    grip = stretched().loads.grip
    assert grip.used is None
    assert grip.needed == 0


def test_a_load_in_the_hand_is_on_the_cables_that_carry_it() -> None:
    rig = gripping(8.0, 100)
    typed(rig, "@STEP 100,0,-300,200")
    rig.run_for(1)
    loads = rig.loads
    angles = rig.state.angles
    assert rig.state.held == "load"
    assert angles.shoulder > 0.3
    for motor, own in ((Motor.SHOULDER, 196.0), (Motor.ELBOW, 115.5)):
        level = loads.of(motor).torque / (own + 8 * 7)
        assert 0.05 < level < 1
        assert loads.of(motor).cable == pytest.approx(
            loads.of(motor).torque / MINIMOVER5.drives[motor].pulley
        )
    assert loads.of(Motor.HAND).cable > 16
