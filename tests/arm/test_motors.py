"""The stepper motors: Figures 7 and 8, and what a rotor does when it cannot follow."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from trs80arm.arm import Bench, EventKind, MiniMover, Reason
from trs80arm.arm.motors import PHASES, ROWS
from trs80arm.arm.stepping import PulseGenerator, delay_period

FIGURE_8 = ("0101", "0100", "0110", "0010", "1010", "1000", "1001", "0001")
EASY = delay_period(200)


def bare() -> MiniMover:
    return MiniMover(bench=Bench("empty"))


def write(arm: MiniMover, patterns: list[int], latch: int = 0, period: int = EASY) -> int:
    times = [period * (i + 1) for i in range(len(patterns))]
    return arm.apply(times, [latch] * len(patterns), patterns)


def test_the_table_is_figure_8() -> None:
    assert tuple(f"{pattern:04b}" for pattern in PHASES) == FIGURE_8


def test_each_row_differs_from_the_next_in_one_coil() -> None:
    for row in range(8):
        assert (PHASES[row] ^ PHASES[(row + 1) % 8]).bit_count() == 1


def test_down_the_table_is_clockwise_and_wraps_around() -> None:
    # "To step the motor clockwise the patterns are output sequentially from top to bottom. When
    # the end of the table is reached, it is necessary to wrap around to the other end."
    arm = bare()
    write(arm, [PHASES[i % 8] for i in range(1, 21)])
    assert arm.rotors[0] == 20


def test_the_reversed_sequence_turns_the_other_way() -> None:
    # "To move the motor in the opposite direction, the sequence in which the entries are output
    # must be reversed."
    arm = bare()
    write(arm, [PHASES[-i % 8] for i in range(1, 21)])
    assert arm.rotors[0] == -20


@pytest.mark.parametrize("first", [0, 1])
def test_every_other_row_makes_full_steps(first: int) -> None:
    arm = bare()
    write(arm, [PHASES[(first + 2 * i) % 8] for i in range(25)])
    assert arm.rotors[0] == first + 48
    assert arm.state().slipped == (0,) * 6


def test_a_jump_of_three_rows_is_followed_the_short_way() -> None:
    arm = bare()
    write(arm, [PHASES[0], PHASES[3]])
    assert arm.rotors[0] == 3
    write(arm, [PHASES[6], PHASES[7]])
    assert arm.rotors[0] == 7


def test_a_jump_of_five_rows_is_three_the_other_way() -> None:
    arm = bare()
    write(arm, [PHASES[0], PHASES[5]])
    assert arm.rotors[0] == -3


def test_a_reversed_field_has_no_pull() -> None:
    arm = bare()
    write(arm, [PHASES[0], PHASES[4]])
    assert arm.rotors[0] == 0
    write(arm, [PHASES[3]])
    assert arm.rotors[0] == 3


@pytest.mark.parametrize("nibble", [0b0000, 0b1100, 0b0011, 0b1111])
def test_opposed_coils_make_no_field(nibble: int) -> None:
    # "Coils phi1 and phi2 are on one magnetic path. Coils phi3 and phi4 are on another."
    assert ROWS[nibble] == -1
    arm = bare()
    write(arm, [PHASES[0], PHASES[1], nibble])
    assert arm.rotors[0] == 1
    assert arm.state().coils[0] == nibble


@pytest.mark.parametrize(("nibble", "like"), [(0b1101, 7), (0b1110, 3), (0b0111, 1), (0b1011, 5)])
def test_three_coils_are_the_row_that_is_left_when_a_pair_cancels(nibble: int, like: int) -> None:
    assert ROWS[nibble] == like


def test_a_latch_holds_its_pattern_until_the_next() -> None:
    # "After a phase pattern is sent to a 4-bit latch, it is held by the latch until the next
    # pattern is sent."
    arm = bare()
    arm.apply([10, 20], [0, 3], [0b0100, 0b0010])
    assert arm.state().coils == (4, 0, 0, 2, 0, 0, 0)


def test_without_current_a_rotor_stays_and_slip_begins_anew() -> None:
    arm = bare()
    write(arm, [PHASES[i % 8] for i in range(200)], period=delay_period(0))
    assert arm.state().slipped[0] < 0
    stood = arm.rotors[0]
    write(arm, [0])
    assert arm.rotors[0] == stood
    assert arm.state().slipped[0] == 0
    assert not arm.state().motors_on


def test_a_motor_driven_too_fast_loses_whole_rings_by_rate() -> None:
    arm = bare()
    generator = PulseGenerator(arm)
    generator.turn(0, 600, delay_period(0))
    slipped = arm.state().slipped[0]
    assert slipped < -500
    assert slipped % 8 == 0
    losses = [event for event in arm.events if event.kind is EventKind.SLIP]
    assert sum(event.steps for event in losses) == slipped
    assert {event.reason for event in losses} == {Reason.RATE}
    assert {event.motor for event in losses} == {0}


def test_a_few_quick_steps_are_caught_up_with() -> None:
    arm = bare()
    PulseGenerator(arm).turn(0, 4, delay_period(0))
    assert arm.rotors[0] == 4
    assert arm.events == []


def test_a_motor_in_step_again_follows_again() -> None:
    arm = bare()
    generator = PulseGenerator(arm)
    generator.turn(0, 200, delay_period(0))
    lost = arm.state().slipped[0]
    before = arm.rotors[0]
    generator.time += 100_000
    generator.turn(0, 50, EASY)
    assert arm.rotors[0] - before >= 46
    assert abs(arm.state().slipped[0] - lost) <= 8


def test_a_blocked_motor_falls_back_a_ring_and_says_so() -> None:
    arm = bare()
    arm.move_joint("base", 89.9)
    generator = PulseGenerator(arm)
    generator.align()
    generator.turn(0, 100, EASY)
    losses = [event for event in arm.events if event.kind is EventKind.SLIP]
    assert [event.reason for event in losses] == [Reason.STOP]
    assert losses[0].steps % 8 == 0
    assert losses[0].steps == 8 * round(arm.state().slipped[0] / 8)


def test_no_write_is_refused() -> None:
    arm = bare()
    assert arm.apply([0, 0, 5, 5], [9, -3, 6, 0], [99, 3, 5, -1]) == 4


@settings(max_examples=60, deadline=None)
@given(st.lists(st.integers(0, 15), max_size=60))
def test_a_rotor_under_a_field_stands_where_the_field_says(patterns: list[int]) -> None:
    arm = bare()
    write(arm, patterns)
    for motor in arm.motors[:1]:
        if motor.row >= 0:
            assert (motor.rotor - motor.row) % 8 in (0, 4)
            if (motor.rotor - motor.row) % 8 == 0:
                assert (motor.rotor - motor.field) % 8 == 0


def test_figure_8_motors_are_the_same_for_all_six() -> None:
    arm = bare()
    arm.move_to(arm.state().pose)
    generator = PulseGenerator(arm)
    generator.turn(5, 40, EASY)
    for motor, count in enumerate((16, -16, 16, -16, 16, 16)):
        before = arm.rotors[motor]
        generator.turn(motor, count, EASY)
        assert arm.rotors[motor] - before == count
