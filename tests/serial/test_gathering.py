"""Latch writes as legs: nothing is lost, no leg is long or crooked."""

from __future__ import annotations

from itertools import accumulate

from hypothesis import given
from hypothesis import strategies as st

from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.machine.half_steps import HALF_STEPS
from trs80arm.serial.gathering import LONE_RATE, LONGEST, PAUSE, Gathering, Leg

Write = tuple[int, int, int]


def writes(motion: list[tuple[int, int, int]]) -> list[Write]:
    """Half-steps as latch writes.

    Args:
        motion: milliseconds since the one before, motor, and which way.
    """
    rows, time, made = [0] * 6, 0, []
    for milliseconds, motor, way in motion:
        time += milliseconds * T_STATES_PER_SECOND // 1000
        rows[motor] += way
        made.append((time, motor, HALF_STEPS[rows[motor] % 8]))
    return made


def legs_of(made: list[Write], slices: int = 1) -> list[Leg]:
    """What is gathered from writes that come in slices of so many."""
    gathering, legs = Gathering([0] * 6), []
    for begin in range(0, len(made), slices):
        columns = zip(*made[begin : begin + slices], strict=True)
        legs += gathering.take(list(gathering.turns(*columns)))
    return [*legs, *gathering.end()]


motions = st.lists(
    st.tuples(st.integers(1, 150), st.integers(0, 5), st.sampled_from([1, -1])), max_size=120
)


@given(motion=motions, slices=st.integers(1, 50))
def test_no_half_step_is_lost_or_invented(motion: list[tuple[int, int, int]], slices: int) -> None:
    gone = [sum(way for _, motor, way in motion if motor == each) for each in range(6)]
    legs = legs_of(writes(motion), slices)
    assert [sum(counts) for counts in zip(*(leg.counts for leg in legs), strict=True)] == (
        gone if legs else []
    )
    assert legs or not any(gone)


@given(motion=motions, slices=st.integers(1, 50))
def test_how_the_writes_come_changes_nothing(
    motion: list[tuple[int, int, int]], slices: int
) -> None:
    assert legs_of(writes(motion), slices) == legs_of(writes(motion), 1)


@given(counts=st.lists(st.integers(-400, 400), min_size=6, max_size=6), tick=st.integers(2, 12))
def test_the_legs_of_an_even_motion_are_short_straight_and_as_fast(
    counts: list[int], tick: int
) -> None:
    most = max(map(abs, counts))
    motion = []
    for each in range(1, most + 1):
        due = [
            m
            for m in range(6)
            if abs(counts[m]) * each // most > abs(counts[m]) * (each - 1) // most
        ]
        motion += [(tick if m == due[0] else 0, m, 1 if counts[m] > 0 else -1) for m in due]
    legs = legs_of(writes(motion), 7)
    ways = accumulate(
        (leg.counts for leg in legs), lambda a, b: tuple(map(sum, zip(a, b, strict=True)))
    )
    for leg, way in zip(legs, ways, strict=True):
        assert leg.seconds <= LONGEST + 0.05
        share = max(map(abs, way)) / most
        for gone, count in zip(way, counts, strict=True):
            assert abs(gone - share * count) <= 2
        if max(map(abs, leg.counts)) > 1:
            assert leg.rate * tick / 1000 == 1.0 or abs(leg.rate * tick / 1000 - 1) < 0.35


def test_a_corner_ends_a_leg() -> None:
    along, up = [(5, 0, 1)] * 30, [(5, 1, -1)] * 30
    counts = [leg.counts for leg in legs_of(writes(along + up))]
    assert len(counts) > 1
    assert all(abs(leg[0]) < 8 or abs(leg[1]) < 8 for leg in counts)


def test_a_pause_ends_a_leg_and_a_lone_step_is_slow() -> None:
    pause = round(1000 * PAUSE) + 5
    legs = legs_of(writes([(5, 0, 1), (pause, 0, 1), (pause, 0, 1)]))
    assert legs == [Leg((1, 0, 0, 0, 0, 0), LONE_RATE)] * 3


def test_patterns_without_a_field_turn_nothing() -> None:
    gathering = Gathering([0] * 6)
    turns = list(gathering.turns((1, 2, 3, 4), (0, 0, 6, 0), (0b0100, 0, 0b0100, 0b0110)))
    assert turns == [(1, 0, 1), (4, 0, 1)], "it goes on from where it was switched off"


def test_against_a_field_that_points_the_other_way_a_rotor_stays() -> None:
    gathering = Gathering([0] * 6)
    turns = list(gathering.turns((1, 2), (0, 0), (0b1010, 0b1000)))
    assert turns == [(2, 0, -3)], "from row 0 to row 5 it is nearer backwards"
