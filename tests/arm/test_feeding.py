"""Feeders whose place the arm itself stands in."""

from __future__ import annotations

import pytest

from tests.arm.writes import Recorder
from trs80arm.arm import MiniMover, benchfile
from trs80arm.arm.ahead import look_ahead
from trs80arm.arm.motors import PHASES
from trs80arm.arm.stepping import PulseGenerator, delay_period
from trs80arm.pulses import Pulses, Train

USUAL = delay_period(50)

OVER = """
[arm]
at = [13.0, 0.0, 0.8]
pitch = -10.0
[[feeder]]
name = "tower"
at = [8.4, 0.0]
size = [0.5, 0.5, 4.0]
"""


@pytest.fixture
def generator() -> PulseGenerator:
    """An arm whose forearm is where the feeder's next part would stand, its hand far from there."""
    return PulseGenerator(MiniMover(bench=benchfile.parse(OVER)))


def test_a_feeder_gives_nothing_into_the_arm(generator: PulseGenerator) -> None:
    generator.step((0, 0, 0, 0, 0, 60), USUAL)
    assert not generator.arm.bench.parts


def test_motions_that_leave_the_arm_in_its_place_are_not_looked_at(
    generator: PulseGenerator,
) -> None:
    generator.step((0, 0, 0, 0, 0, 60), USUAL)
    arm = generator.arm
    train = Train(5, 1, 0, 60)
    burst = Pulses(generator.time + USUAL, USUAL, 1, (train,), arm.rotors, PHASES)
    ahead = look_ahead(arm.motors, burst)
    assert ahead is not None
    assert arm.world.first_look(ahead) is None


def test_it_gives_at_the_same_time_however_the_motion_that_clears_its_place_is_cut(
    generator: PulseGenerator,
) -> None:
    recorder = Recorder()
    again = PulseGenerator(recorder)  # type: ignore[arg-type]
    for each in (generator, again):
        each.step((0, 0, 0, 0, 0, 60), USUAL)
        each.step((400,), USUAL)
    other = MiniMover(bench=benchfile.parse(OVER))
    for time, latch, nibble in recorder.writes:
        other.apply([time], [latch], [nibble])
    assert [event.text for event in other.events] == ["tower gives tower 1"]
    assert other.events == generator.arm.events
