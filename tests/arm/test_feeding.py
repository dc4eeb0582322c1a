"""Feeders whose place the arm itself stands in."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.arm.writes import Recorder
from trs80arm.arm import MiniMover, benchfile
from trs80arm.arm.ahead import look_ahead
from trs80arm.arm.contact.rotations import about, product
from trs80arm.arm.feeding import Feeding, Given
from trs80arm.arm.motors import PHASES
from trs80arm.arm.stepping import PulseGenerator, delay_period
from trs80arm.arm.sweep import Ranges
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


BESIDE = """
[arm]
at = [8.0, 0.0, 3.0]
[[feeder]]
name = "tower"
at = [7.0, 4.0]
size = [0.5, 1.0, 2.0]
turn = 20.0
"""


@given(st.integers(0, 10**6), st.floats(0.0, 0.6))
def test_where_it_is_sure_that_nothing_is_given_nothing_is_anywhere_on_the_way(
    seed: int, wide: float
) -> None:
    arm = MiniMover(bench=benchfile.parse(BESIDE))
    chance = random.Random(seed)
    feeding = Feeding(arm.bench, arm.world.linkage, arm.world.around)
    feeding.vacant = dict(enumerate(arm.bench.feeders))
    here = [chance.uniform(*span) for span in ((-1, 1), (-0.5, 1.5), (-2, 0), (-2, 1), (-2, 1))]
    places = np.array(
        [[at + chance.uniform(0.0, wide) for at in (*here, 0.5)] for _ in range(20)]
    ).T
    if feeding.surely_unfed(Ranges.of(places)):
        assert feeding.places_unfed(places) == 20
        assert not any(feeding.may_give(place) for place in places.T.tolist())


@given(st.integers(0, 10**6), st.floats(0.0, 0.2), st.floats(-20.0, 20.0))
def test_a_part_that_is_surely_in_its_feeders_place_is_found_there(
    seed: int, far: float, degrees: float
) -> None:
    arm = MiniMover(bench=benchfile.parse(BESIDE))
    chance = random.Random(seed)
    (part,), (feeder,) = arm.bench.parts.values(), arm.bench.feeders
    given = Given.of(part)
    way = [chance.gauss(0.0, 1.0) for _ in range(3)]
    by = [far * each / math.hypot(*way) for each in way]
    axis = (chance.gauss(0.0, 1.0), chance.gauss(0.0, 1.0), chance.gauss(0.0, 1.0))
    x, y, z = (at + gone for at, gone in zip(part.place, by, strict=True))
    part.put((x, y, z), product(about(axis, degrees), part.turn))
    if given.still(arm.bench.parts):
        assert arm.bench.found_at(feeder.placed) == part.name
    part.held = True
    assert not given.still(arm.bench.parts)
