"""Loads: what the arm lifts, how fast, and what happens when it cannot."""

from __future__ import annotations

import math

import pytest

from trs80arm.arm import Bench, EventKind, JointAngles, MiniMover, Pose, Reason
from trs80arm.arm.experiments import Row, table1
from trs80arm.arm.limits import load_fraction
from trs80arm.arm.models import MINIMOVER5
from trs80arm.arm.motors import T_STATES_PER_SECOND
from trs80arm.arm.stepping import PulseGenerator, delay_period

AT_PART = Pose(8.0, 0.0, 0.5, -90.0, 0.0, 1.0)


def carrying(weight: float, *degrees: float) -> PulseGenerator:
    """An arm that holds a part at these joint angles, shoulder to pitch, motors off."""
    bench = Bench("one part")
    bench.add_part("load", (0.5, 0.5, 1.0), weight, 8.0, 0.0)
    arm = MiniMover(bench=bench)
    arm.move_to(AT_PART)
    generator = PulseGenerator(arm)
    generator.align()
    generator.close(delay_period(200), 140)
    generator.off()
    shoulder, elbow, pitch = (math.radians(value) for value in degrees)
    arm.move_joints(JointAngles(0.0, shoulder, elbow, pitch, 0.0))
    generator.align()
    assert arm.state().held == "load"
    return generator


def lift(generator: PulseGenerator) -> None:
    """Raise upper arm and forearm a little, at Table 1's full-load speeds."""
    shoulder = round(T_STATES_PER_SECOND / MINIMOVER5.drives[1].full_load_rate)
    elbow = round(T_STATES_PER_SECOND / MINIMOVER5.drives[2].full_load_rate)
    generator.step((0, -100, 0), shoulder)
    generator.step((0, 0, 60), elbow)


def losses(arm: MiniMover) -> set[Reason | None]:
    return {event.reason for event in arm.events if event.kind is EventKind.SLIP}


def test_8_ounces_at_full_extension_are_lifted() -> None:
    # "Load Capacity 8 oz (225 gm) at full extension"
    generator = carrying(8.0, 0, -8, 0)
    lift(generator)
    assert generator.arm.state().slipped == (0,) * 6
    assert generator.arm.state().held == "load"


def test_12_ounces_at_full_extension_slip_under_load() -> None:
    generator = carrying(12.0, 0, -8, 0)
    lift(generator)
    assert losses(generator.arm) == {Reason.LOAD}
    assert generator.arm.state().slipped[1] != 0


@pytest.mark.parametrize(("weight", "lifted"), [(16.0, True), (24.0, False)])
def test_half_extension_carries_twice_as_much(weight: float, lifted: bool) -> None:
    # "16 oz (450 gm) at half extension"
    generator = carrying(weight, 62, -62, -60)
    lift(generator)
    assert (generator.arm.state().slipped == (0,) * 6) is lifted


def test_lowering_a_load_is_no_load() -> None:
    generator = carrying(8.0, 4, -4, 0)
    generator.step((0, 100, 0), round(T_STATES_PER_SECOND / 330))
    assert generator.arm.state().slipped == (0,) * 6


def test_the_lever_is_the_links_cosine() -> None:
    level = JointAngles(0.0, 0.0, 0.0, 0.0, 0.0)
    half = JointAngles(0.0, math.pi / 3, -math.pi / 3, -math.pi / 3, 0.0)
    for motor, up in ((1, -1), (2, 1), (3, -1), (4, 1)):
        assert load_fraction(motor, up, MINIMOVER5, level, 8.0, 0) == pytest.approx(1.0, abs=1e-3)
        assert load_fraction(motor, up, MINIMOVER5, half, 16.0, 0) == pytest.approx(1.0, abs=2e-3)
        assert load_fraction(motor, -up, MINIMOVER5, level, 8.0, 0) == 0
    assert load_fraction(0, 1, MINIMOVER5, level, 8.0, 0) == pytest.approx(1.0, abs=1e-3)


@pytest.fixture(scope="module")
def rows() -> list[Row]:
    return table1()


def test_table_1_is_kept_in_every_row(rows: list[Row]) -> None:
    assert [row.name for row in rows if not row.kept] == []
    assert len(rows) == 29


def test_speeds_are_up_to_a_margin_over_table_1s(rows: list[Row]) -> None:
    for row in rows:
        if row.name.endswith("no load"):
            assert 1.1 <= row.measured / row.article <= 1.2
