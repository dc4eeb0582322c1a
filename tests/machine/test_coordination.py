"""Figure 10: motors with unequal counts begin and end together, evenly spaced."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.machine.coordination import Coordination, Pace
from trs80arm.machine.half_steps import HALF_STEPS
from trs80arm.pulses import Pulses, Train


def steps(*counts: int) -> list[list[int]]:
    """The ticks at which each motor steps in a whole move."""
    move = Coordination(counts)
    found: list[list[int]] = [[] for _ in counts]
    for train in move.trains(0, move.ticks):
        found[train.motor] = train.ticks()
        assert train.tick_array().tolist() == found[train.motor]
    return found


def well_coordinated(many: int, few: int) -> None:
    major, minor = steps(many, few)
    assert major == list(range(many))
    assert len(minor) == few
    assert minor[-1] == many - 1
    if few > 1:
        assert minor[0] == 0
        ideal = (many - 1) / (few - 1)
        gaps = np.diff(minor)
        assert gaps.min() >= max(1, np.floor(ideal))
        assert gaps.max() <= np.ceil(ideal)


def test_21_steps_against_3_as_in_figure_10():
    base, shoulder = steps(21, 3)
    assert base == list(range(21))
    assert shoulder == [0, 10, 20]


def test_every_ratio_up_to_50_against_50():
    for many in range(1, 51):
        for few in range(1, many + 1):
            well_coordinated(many, few)


@given(st.integers(1, 65535), st.data())
def test_large_ratios(many, data):
    well_coordinated(many, data.draw(st.integers(1, many)))


def test_direction_is_the_sign_and_a_motor_without_steps_has_no_train():
    trains = Coordination((5, 0, -3, 0, 0, 1)).trains(0, 5)
    assert [(train.motor, train.direction, len(train)) for train in trains] == [
        (0, 1, 5),
        (2, -1, 3),
        (5, 1, 1),
    ]


def test_a_single_step_comes_with_the_last_tick():
    assert steps(10, 1)[1] == [9]
    assert steps(1, 1) == [[0], [0]]


@given(
    st.lists(st.integers(-60, 60), min_size=6, max_size=6),
    st.lists(st.integers(0, 60), max_size=6),
)
def test_a_move_cut_anywhere_has_the_same_steps(counts, cuts):
    move = Coordination(counts)
    edges = sorted({0, move.ticks, *(cut for cut in cuts if cut < move.ticks)})
    pieces: list[list[int]] = [[] for _ in counts]
    for first, stop in pairwise(edges):
        for train in move.trains(first, stop):
            pieces[train.motor] += train.ticks()
            assert all(first <= tick < stop for tick in train.ticks())
    assert pieces == steps(*counts)


@pytest.mark.parametrize("delay", [0, 1, 50, 222, 32767])
def test_a_million_ticks_are_exact_to_the_t_state(delay):
    pace = Pace(7, delay)
    exact = 1_000_000 * (120 + 3 * delay) * T_STATES_PER_SECOND / 100_000
    assert pace.time(1_000_000) == 7 + exact
    ticks = np.array([0, 1, 2, 625, 999_999, 1_000_000], dtype=np.int64)
    train = Train(0, 1, 0, 1_000_001)
    writes = Pulses(7, *pace.ratio, (train,), [0] * 6, HALF_STEPS).columns().arrays()
    assert np.asarray(writes.times)[ticks].tolist() == [pace.time(int(tick)) for tick in ticks]


def test_the_pace_of_d_0_is_1_2_milliseconds_and_each_unit_adds_0_03():
    second = T_STATES_PER_SECOND
    assert Pace(0, 0).time(1000) == int(1.2 * second)
    assert Pace(0, 1).time(100_000) - Pace(0, 0).time(100_000) == 3 * second


@given(st.integers(0, 10**9), st.integers(0, 32767), st.integers(-5, 10**7))
def test_the_first_tick_from_a_time(start, delay, after):
    pace, time = Pace(start, delay), start + after
    tick = pace.first_tick_from(time)
    assert pace.time(tick) >= time
    assert tick == 0 or pace.time(tick - 1) < time
