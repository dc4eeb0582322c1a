"""Arms as data: what the MiniMover 5 and the TeachMover have in common, and what they have not."""

from __future__ import annotations

import math
from dataclasses import fields, replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from trs80arm import Rig
from trs80arm.arm import ArmSettings, Bench, BenchError, MiniMover, Motor, benchfile
from trs80arm.arm.contact.clock import T_STATES_PER_SECOND
from trs80arm.arm.forces import Strength
from trs80arm.arm.geometry import CableDrive, inverse
from trs80arm.arm.model import ArmModel
from trs80arm.arm.models import MINIMOVER5, MODELS, TEACHMOVER
from trs80arm.arm.stepping import PulseGenerator, delay_period
from trs80arm.basic.activity import Waiting
from trs80arm.machine.driver import DriverSettings
from trs80arm.works.devices import RigSettings

SIX = st.tuples(*[st.integers(-3000, 3000)] * 6)
PROGRAMS = Path(__file__).parents[2] / "programs"
TEACH = ArmSettings(model="teachmover")


@pytest.mark.parametrize("model", MODELS.values(), ids=lambda model: model.name)
def test_every_figure_of_a_model_says_where_it_comes_from(model: ArmModel) -> None:
    named = " ".join(what for what, _ in model.sources)
    for field in fields(ArmModel):
        if field.init and field.name not in ("name", "title", "sources"):
            assert field.name in named, field.name


@given(st.sampled_from(list(MODELS.values())), SIX)
def test_counts_undo_turns(model: ArmModel, rotors: tuple[int, ...]) -> None:
    assert model.counts(model.turned(rotors)) == rotors[:5]


@given(st.sampled_from(list(MODELS.values())), st.lists(SIX, min_size=1, max_size=5))
def test_arrays_of_rotors_turn_as_single_ones_do(
    model: ArmModel, rows: list[tuple[int, ...]]
) -> None:
    columns = np.array(rows).T
    for joint, turns in enumerate(model.turned(columns)):
        assert turns.tolist() == [model.turned(row)[joint] for row in rows]
    assert model.paid_out(columns).tolist() == [model.paid_out(row) for row in rows]


def test_the_teachmover_makes_steps_a_fifth_smaller_than_the_minimovers() -> None:
    for motor in list(Motor)[:5]:
        old, new = (model.drives[model.latch(motor)].steps for model in (MINIMOVER5, TEACHMOVER))
        assert new / old == pytest.approx(1.2, abs=1e-3)


def test_the_teachmovers_fourth_motor_is_the_right_wrists() -> None:
    assert TEACHMOVER.motor_names[3:5] == ("right wrist", "left wrist")


def test_the_teachmovers_manual_finds_its_start_at_these_counts() -> None:
    # x = 5, z = 0, pitch -90: shoulder 508 and elbow 1162 steps from level, says the manual.
    angles = inverse(TEACHMOVER, 5.0, 0.0, 0.0, -90.0, 0.0)
    assert angles.shoulder * TEACHMOVER.drives[1].steps == pytest.approx(508, abs=1.5)
    assert -angles.elbow * TEACHMOVER.drives[2].steps == pytest.approx(1162, abs=1.5)


def test_positive_counts_of_the_teachmover_lower_forearm_and_hand_and_open_it() -> None:
    drive = CableDrive.from_pose(TEACHMOVER, TEACHMOVER.start)
    assert drive.angles((0, 0, 100, 0, 0, 0)).elbow < drive.home.elbow
    lower = drive.angles((0, 0, 0, 100, 100, 0))
    assert lower.pitch - drive.home.pitch == pytest.approx(-200 / (2 * TEACHMOVER.drives[3].steps))
    assert drive.cable((0, 0, 0, 0, 0, 371)) == 371
    assert drive.cable((0, 0, -100, 0, 0, 0)) == 100, "raising the forearm opens the hand"


def test_the_teachmover_turns_a_radian_where_its_manual_says() -> None:
    generator = PulseGenerator(MiniMover(TEACH, Bench("empty")))
    arm = generator.arm
    before = arm.state().angles
    generator.step((100, -100, -100), delay_period(150))
    after = arm.state().angles
    assert after.base - before.base == pytest.approx(100 * math.tau / 7072)
    assert after.shoulder - before.shoulder == pytest.approx(100 * math.tau / 7072)
    assert after.elbow - before.elbow == pytest.approx(100 * math.tau / 4158)


def test_step_leaves_the_teachmovers_hand_to_the_program() -> None:
    rig = Rig(RigSettings(arm=TEACH), Bench("empty"))
    rig.type("@STEP 150,0,-100,-100\r")
    rig.run_until_waiting()
    assert rig.arm.rotors == (0, -100, -100, 0, 0, 0)
    assert rig.registers == rig.joints == (0, -100, -100, 0, 0, 0)
    assert rig.state.pose.opening == pytest.approx(100 / 370.8)


def test_the_teachmover_picks_and_places_with_every_rate_left_at_its_default() -> None:
    rig = Rig(RigSettings(arm=TEACH), benchfile.load(PROGRAMS / "table3.toml"))
    lines = (
        "10 @CLOSE: @STEP 50,0,0,0,0,0,-30",
        "20 @STEP 50,0,-100,-50,25,25,-50: REM UP; THE HAND GOES WITH THE ELBOW",
        "30 @STEP 50,800",
        "40 @STEP 50,0,100,50,-25,-25,50",
        "50 @STEP 50,0,0,0,0,0,150",
        "60 @STEP 50,0,-100,-50,25,25,-50",
    )
    rig.type("".join(line + "\r" for line in (*lines, "RUN")))
    assert rig.run_until_waiting(60) is Waiting.COMMAND
    assert rig.arm.bench.trays[0].taken == 1
    assert rig.state.slipped == (0,) * 6
    assert rig.joints == rig.registers


@pytest.mark.parametrize("model", MODELS.values(), ids=lambda model: model.name)
def test_every_arms_motors_follow_armbasic_at_its_default_rates(model: ArmModel) -> None:
    asked = DriverSettings()
    for delay in (asked.close_delay, asked.set_delay):
        rate = T_STATES_PER_SECOND / delay_period(delay)
        for motor, curve in zip(Motor, Strength.of(model).curves, strict=True):
            assert curve.idle**0.5 > rate, motor


def test_a_bench_beyond_the_teachmovers_reach_is_refused_in_one_line() -> None:
    bench = benchfile.parse("[arm]\nat = [3.9, 0, 16]\npitch = 0\n", "near")
    MiniMover(bench=bench)
    with pytest.raises(BenchError, match=r"^near: arm\.at: expected a place that the Teach"):
        MiniMover(TEACH, bench)


def test_drives_in_another_order_than_armbasic_counts_them_are_refused() -> None:
    with pytest.raises(ValueError, match="@CLOSE drives the sixth"):
        replace(MINIMOVER5, drives=MINIMOVER5.drives[::-1])
