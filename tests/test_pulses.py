"""Bursts as trains of pulses: the same writes as one by one, in however many pieces."""

from __future__ import annotations

from itertools import pairwise

from hypothesis import given
from hypothesis import strategies as st

from trs80arm.arm.ahead import ColumnsAhead, PulsesAhead
from trs80arm.arm.motors import PHASES, StepperMotor
from trs80arm.pulses import Burst, Columns, Pulses, Train


@st.composite
def trains(draw: st.DrawFn, motor: int) -> Train:
    under = draw(st.integers(1, 40))
    over = under + draw(st.integers(0, 100))
    begin = draw(st.integers(0, 20))
    end = begin + draw(st.integers(0, 60))
    return Train(
        motor, draw(st.sampled_from((1, -1))), begin, end, draw(st.integers(0, 90)), over, under
    )


@st.composite
def bursts(draw: st.DrawFn) -> Pulses:
    motors = sorted(draw(st.sets(st.integers(0, 5), min_size=1)))
    found = tuple(draw(trains(motor)) for motor in motors)
    rows = draw(st.tuples(*[st.integers(-9, 9)] * 6))
    under = draw(st.integers(1, 700))
    over = under * draw(st.integers(1, 40)) + draw(st.integers(0, 700))
    return Pulses(draw(st.integers(0, 999)), over, under, found, rows, PHASES)


Write = tuple[int, int, int]


def writes(burst: Burst) -> list[Write]:
    columns = burst.columns()
    rows = zip(columns.times, columns.latches, columns.nibbles, strict=True)
    return [(int(time), int(latch), int(nibble)) for time, latch, nibble in rows]


def as_said(burst: Pulses) -> list[Write]:
    """The writes, from what the fields say."""
    found = []
    for order, train in enumerate(burst.trains):
        row = burst.rows[train.motor]
        for step in range(train.begin, train.end):
            row += train.direction
            tick = (train.phase + step * train.over) // train.under
            time = burst.start + tick * burst.over // burst.under
            found.append((tick, order, (time, train.motor, PHASES[row % 8])))
    return [write for _, _, write in sorted(found)]


@given(bursts())
def test_columns_are_the_steps_of_all_trains_in_order(burst: Pulses) -> None:
    assert writes(burst) == as_said(burst)
    assert len(burst) == len(as_said(burst))
    if burst:
        assert (burst.begins, burst.ends) == (writes(burst)[0][0], writes(burst)[-1][0])
    assert dict(burst.held()) == {latch: nibble for _, latch, nibble in writes(burst)}


@given(bursts(), st.integers(0, 400))
def test_the_pieces_of_a_burst_are_the_burst(burst: Pulses, count: int) -> None:
    count = min(count, len(burst))
    first, rest = burst.split(count)
    assert writes(first) == as_said(burst)[:count]
    assert writes(rest) == as_said(burst)[count:]


@given(bursts(), st.integers(0, 400))
def test_the_first_writes_are_taken_off_a_burst_one_by_one(burst: Pulses, count: int) -> None:
    count = min(count, len(burst))
    first, rest = burst.first(count)
    assert writes(first) == as_said(burst)[:count]
    assert writes(rest) == as_said(burst)[count:]


@given(bursts(), st.integers(0, 4000))
def test_a_burst_is_cut_before_a_time(burst: Pulses, time: int) -> None:
    before, rest = burst.until(time)
    assert writes(before) == [write for write in as_said(burst) if write[0] < time]
    assert writes(rest) == [write for write in as_said(burst) if write[0] >= time]


@given(bursts().filter(len), st.integers(1, 4000))
def test_a_burst_goes_up_to_its_first_pause(burst: Pulses, pause: int) -> None:
    times = [time for time, _, _ in as_said(burst)]
    apart = [later - time for time, later in pairwise(times)]
    count = next((i for i, each in enumerate(apart, 1) if each >= pause), len(burst))
    near = burst.before_pause(pause)
    assert writes(near) == as_said(burst)[:count] == writes(burst.columns().before_pause(pause))
    assert (near is burst) == (count == len(burst))


@given(bursts(), st.integers(0, 400))
def test_columns_are_cut_like_trains(burst: Pulses, count: int) -> None:
    count = min(count, len(burst))
    columns = Columns(*zip(*as_said(burst), strict=True)) if burst else Columns((), (), ())
    pieces = zip(columns.split(count), burst.split(count), strict=True)
    assert all(writes(one) == writes(other) for one, other in pieces)
    assert (
        dict(columns.held()) == dict(columns.arrays().held() if burst else ()) == dict(burst.held())
    )


def standing(burst: Pulses) -> list[StepperMotor]:
    """Motors at the rows from which a burst goes on."""
    motors = [StepperMotor() for _ in range(7)]
    for motor, row in zip(motors, burst.rows, strict=False):
        motor.rotor = row
    return motors


@given(bursts().filter(len), st.integers(0, 4000))
def test_what_trains_do_ahead_is_what_their_writes_do(burst: Pulses, time: int) -> None:
    motors = standing(burst)
    one, other = PulsesAhead.of(motors, burst), ColumnsAhead.of(motors, burst.columns().arrays())
    assert one is not None
    assert other is not None
    assert one.ends == other.ends
    assert one.turned_before(time) == other.turned_before(time)
    for order, (mine, theirs) in enumerate(zip(one.turnings, other.turnings, strict=True)):
        assert mine.gap <= theirs.gap
        for name in (
            "latch",
            "steps",
            "way",
            "net",
            "low",
            "high",
            "first",
            "last",
            "turn",
            "nibble",
        ):
            assert getattr(mine, name) == getattr(theirs, name)
        assert one.turned_at_last(order) == other.turned_at_last(order)
        assert one.closest(order) <= other.closest(order)
        assert one.moments(order, 0, 9) == other.moments(order, 0, 9)
        every = range(len(one.turnings))
        for all_mine, all_theirs in (
            (one.half_steps(order), other.half_steps(order)),
            (one.before_each(order, every), other.before_each(order, every)),
        ):
            each = zip(all_mine, all_theirs, strict=True)
            assert all(of_one.tolist() == of_other.tolist() for of_one, of_other in each)


@given(
    bursts().filter(len),
    st.booleans(),
    st.sampled_from((1, -1)),
    st.sets(st.integers(0, 5), min_size=2, max_size=2),
)
def test_the_bounds_on_sums_of_trains_hold_for_their_writes(
    burst: Pulses, instants: bool, sign: int, latches: set[int]
) -> None:
    motors, (left, right) = standing(burst), sorted(latches)
    signs = ((left, 1), (right, sign))
    one, other = PulsesAhead.of(motors, burst), ColumnsAhead.of(motors, burst.columns().arrays())
    assert one is not None
    assert other is not None
    low, high = one.together(signs, instants=instants)
    least, most = other.together(signs, instants=instants)
    assert low <= least <= most <= high


def test_what_makes_up_for_the_elbow_keeps_the_opening_exactly() -> None:
    pair = Train(2, 1, 0, 100), Train(5, -1, 0, 100)
    burst = Pulses(0, 5000, 1, pair, [0] * 6, PHASES)
    ahead = PulsesAhead.of(standing(burst), burst)
    assert ahead is not None
    assert ahead.together(((5, 1), (2, 1)), instants=True) == (0, 0)


def test_a_motor_that_stands_elsewhere_in_the_ring_is_not_looked_ahead_at() -> None:
    burst = Pulses(0, 5000, 1, (Train(0, 1, 0, 9),), [0] * 6, PHASES)
    motors = standing(burst)
    motors[0].rotor = 1
    assert PulsesAhead.of(motors, burst) is None


def test_a_motor_that_turns_back_is_not_taken_to_go_on_with_another() -> None:
    places = [1, 2, 3, 2, 1, 0, -1, -2]
    writes = [(1000 * k, 3, PHASES[k + 1]) for k in range(2)]
    writes += [(2000 + 1000 * k, 4, PHASES[place % 8]) for k, place in enumerate(places)]
    columns = Columns(*zip(*writes, strict=True)).arrays()
    ahead = ColumnsAhead.of([StepperMotor() for _ in range(6)], columns)
    assert ahead is not None
    assert ahead.together(((3, 1), (4, 1))) == (0, 5)
    assert ahead.together(((4, 1),)) == (-2, 3)
