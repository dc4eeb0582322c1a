"""ARMBASIC's five commands, as an analyser on the latches sees them."""

from __future__ import annotations

import pickle
from itertools import pairwise

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from tests.machine.bench_top import ClosingHand, Machine, Write, ticks
from trs80arm.machine.card import Latch
from trs80arm.machine.coordination import Pace
from trs80arm.machine.driver import DriverSettings, Mode
from trs80arm.machine.half_steps import HALF_STEPS
from trs80arm.machine.jog_keys import JogKeys
from trs80arm.machine.keys import Key
from trs80arm.progress import Progress

MS = 1774.08
PERIOD_50 = 4790
"""T-states of 1.2 + 0.03 * 50 = 2.7 ms, rounded down: 4790.016."""

counts = st.lists(st.integers(-40, 40), min_size=6, max_size=6)
BREAK_NOW = DriverSettings(break_now=True)


def patterns(writes: list[Write], latch: int) -> list[int]:
    return [nibble for _, which, nibble in writes if which == latch]


# -- @STEP ----------------------------------------------------------------------------------------


def test_a_positive_count_runs_down_figure_8_and_a_negative_one_up():
    machine = Machine()
    assert patterns(machine.step(0, 9), 0) == [4, 6, 2, 10, 8, 9, 1, 5, 4]
    assert patterns(machine.step(0, -9), 0) == [5, 1, 9, 8, 10, 2, 6, 4, 5]


def test_21_against_3_from_the_latches():
    machine = Machine()
    writes = machine.step(50, 21, 3)
    assert ticks(writes, Latch.BASE, 0, PERIOD_50) == list(range(21))
    assert ticks(writes, Latch.SHOULDER, 0, PERIOD_50) == [0, 10, 20]


@pytest.mark.parametrize(("delay", "milliseconds"), [(0, 1.2), (1, 1.23), (50, 2.7), (100, 4.2)])
def test_a_move_takes_its_longest_count_times_the_step_period(delay, milliseconds):
    machine = Machine()
    machine.step(delay, 290, 0, 3)
    assert machine.clock.now == int(290 * milliseconds * MS + 1e-6)


def test_a_second_move_at_the_same_pace_keeps_the_rhythm():
    machine = Machine()
    machine.step(0, 5)
    machine.step(0, 5)
    times = [time for time, _, _ in machine.analyser.writes]
    assert {after - before for before, after in pairwise(times)} <= {2128, 2129}


def test_raising_the_forearm_closes_the_hand_step_by_step_in_the_same_instant():
    machine = Machine()
    writes = machine.step(50, 0, 0, 100)
    elbow = [time for time, latch, _ in writes if latch == Latch.ELBOW]
    hand = [time for time, latch, _ in writes if latch == Latch.HAND]
    assert elbow == hand
    assert patterns(writes, Latch.HAND)[:3] == [1, 9, 8]
    assert machine.driver.registers == (0, 0, 100, 0, 0, 0)


@pytest.mark.parametrize(
    ("elbow", "hand", "motor"), [(100, 30, -70), (100, 100, 0), (100, -100, -200), (-7, 3, 10)]
)
def test_the_hand_motor_makes_the_hands_count_less_the_elbows(elbow, hand, motor):
    machine = Machine()
    writes = machine.step(50, 0, 0, elbow, 0, 0, hand)
    turned = patterns(writes, Latch.HAND)
    direction = 1 if motor > 0 else -1
    assert turned == [HALF_STEPS[direction * i % 8] for i in range(1, abs(motor) + 1)]
    assert machine.driver.registers == (0, 0, elbow, 0, 0, hand)
    # No motor is asked for two half-steps in one tick, so the hand's count may set the time.
    assert machine.clock.now == Pace(0, 50).time(max(abs(elbow), abs(motor)))


def test_a_move_of_no_steps_writes_nothing_and_takes_no_time():
    machine = Machine()
    assert machine.step(50) == []
    assert machine.clock.now == 0
    assert machine.driver.mode is Mode.IDLE


@given(counts)
def test_registers_count_what_was_commanded(steps):
    machine = Machine()
    machine.step(10, *steps)
    assert machine.driver.registers == tuple(steps)
    machine.step(10, *(-step for step in steps))
    assert machine.driver.registers == (0, 0, 0, 0, 0, 0)


def test_registers_wrap_around_in_16_bits():
    machine = Machine()
    machine.step(0, 32767, -32768, 0, 0, 0, 32767)
    machine.step(0, 1, -1, 0, 0, 0, 2)
    assert machine.driver.registers == (-32768, 32767, 0, 0, 0, -32767)


def test_long_and_short_bursts_write_the_same():
    """A move sent as arrays and the same move in pieces too short for arrays."""
    whole, pieces = Machine(), Machine()
    steps = (200, -130, 90, 7, -1, 44)
    whole.step(20, *steps)
    pieces.driver.step(20, steps)
    while pieces.run(pieces.clock.now + 4000) is Progress.BUSY:
        pass
    assert max(pieces.analyser.bursts) < 12 < max(whole.analyser.bursts)
    assert pieces.analyser.writes == whole.analyser.writes


# -- slices and snapshots ---------------------------------------------------------------------


def everything(machine: Machine) -> tuple:
    driver, card = machine.driver, machine.card
    return machine.analyser.writes, driver.registers, driver.mode, card.latches, machine.clock.now


@settings(max_examples=50, deadline=None)
@given(counts, st.integers(0, 60), st.lists(st.integers(1, 60_000), max_size=12))
def test_a_step_is_the_same_however_it_is_sliced(steps, delay, slices):
    whole, sliced = Machine(), Machine()
    whole.step(delay, *steps)
    sliced.driver.step(delay, steps)
    for length in slices:
        if sliced.run(sliced.clock.now + length) is Progress.DONE:
            break
    sliced.run()
    assert everything(sliced) == everything(whole)


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 300), st.integers(0, 60), st.lists(st.integers(1, 90_000), max_size=12))
def test_a_close_is_the_same_however_it_is_sliced(closes_after, delay, slices):
    machines = []
    for lengths in ([], slices):
        machine = Machine(ClosingHand(closes_after))
        machine.driver.close(delay)
        for length in lengths:
            if machine.run(machine.clock.now + length) is Progress.DONE:
                break
        machine.run()
        machines.append(machine)
    assert everything(machines[0]) == everything(machines[1])
    assert machines[0].driver.registers[5] == -closes_after


KEYS = "123456QWERTY"
events = st.lists(
    st.tuples(st.integers(0, 60_000), st.booleans(), st.sampled_from(KEYS)), max_size=12
)


@settings(max_examples=50, deadline=None)
@given(events, st.lists(st.integers(1, 400_000), max_size=12), st.integers(0, 60))
def test_manual_mode_is_the_same_however_it_is_sliced(pressed, cuts, delay):
    machines = []
    for extra in ([], cuts):
        machine = Machine()
        machine.driver.set(delay)
        time, timeline = 0, {400_000: [], **{cut: [] for cut in extra}}
        for after, down, key in pressed:
            time += after
            timeline.setdefault(time, []).append((down, key))
        for time in sorted(timeline):
            machine.run(time)
            for down, key in timeline[time]:
                (machine.press if down else machine.release)([key])
        machine.run(800_000)
        machine.press("0")
        assert machine.run(900_000) is Progress.DONE
        machines.append(machine)
    assert everything(machines[0]) == everything(machines[1])


def test_a_motion_can_be_put_away_in_the_middle_and_taken_up_again():
    whole, parted = Machine(), Machine()
    whole.step(50, 60, -20, 33)
    parted.driver.step(50, (60, -20, 33, 0, 0, 0))
    parted.run(100_000)
    analyser = parted.analyser
    restored = pickle.loads(pickle.dumps(parted))
    restored.analyser, restored.card.observers = analyser, [analyser]
    assert restored.driver.mode is Mode.STEP
    restored.run()
    assert everything(restored) == everything(whole)


# -- BREAK ------------------------------------------------------------------------------------


def test_a_step_goes_on_to_its_end_under_break():
    machine = Machine()
    machine.driver.step(50, (100, 0, 0, 0, 0, 0))
    machine.run(100_000)
    machine.press([Key.BREAK])
    assert machine.run() is Progress.DONE
    assert machine.driver.registers[0] == 100


def test_break_now_ends_a_step_and_the_registers_hold_what_was_commanded():
    machine = Machine(settings=BREAK_NOW)
    machine.driver.step(50, (100, 50, 0, 0, 0, 0))
    machine.run(10 * PERIOD_50)
    machine.press([Key.BREAK])
    assert machine.run() is Progress.BREAK
    assert machine.clock.now == 10 * PERIOD_50
    assert machine.driver.registers[0] == 10 == len(patterns(machine.analyser.writes, 0))
    assert machine.driver.registers[1] == len(patterns(machine.analyser.writes, 1))
    assert machine.driver.mode is Mode.IDLE


@pytest.mark.parametrize("break_now", [False, True])
def test_break_ends_a_close_that_would_never_end(break_now):
    machine = Machine(settings=DriverSettings(break_now=break_now))
    machine.driver.close()
    machine.run(100_000)
    machine.press([Key.BREAK])
    assert machine.run(200_000) is Progress.BREAK
    assert machine.driver.registers[5] == -21


@pytest.mark.parametrize("break_now", [False, True])
def test_break_leaves_manual_mode_at_once(break_now):
    machine = Machine(settings=DriverSettings(break_now=break_now))
    machine.driver.set(32767)
    machine.run(1000)
    machine.press([Key.BREAK])
    assert machine.run(100_000) is Progress.BREAK
    assert machine.clock.now == 1000


# -- @CLOSE -----------------------------------------------------------------------------------


def test_close_steps_the_hand_until_the_switch_closes_and_counts():
    machine = Machine(ClosingHand(100))
    machine.driver.close(20)
    assert machine.run() is Progress.DONE
    assert machine.driver.registers == (0, 0, 0, 0, 0, -100)
    assert patterns(machine.analyser.writes, Latch.HAND)[:4] == [1, 9, 8, 10]
    assert machine.clock.now == Pace(0, 20).time(100)


def test_close_with_the_switch_closed_makes_no_step():
    machine = Machine(ClosingHand(0))
    machine.driver.close()
    assert machine.run() is Progress.DONE
    assert machine.analyser.writes == []
    assert machine.clock.now == 0


def test_close_without_a_delay_takes_50():
    machine = Machine(ClosingHand(10))
    machine.driver.close()
    machine.run()
    assert machine.clock.now == Pace(0, 50).time(10)


# -- @SET -------------------------------------------------------------------------------------


@pytest.mark.parametrize("joint", range(6))
def test_a_digit_counts_its_joint_up_and_the_letter_below_it_down(joint):
    for key, direction in (("123456"[joint], 1), ("QWERTY"[joint], -1)):
        machine = Machine()
        machine.driver.set()
        machine.press(key)
        machine.run(Pace(0, 50).time(10))
        registers = [0] * 6
        registers[joint] = 10 * direction
        assert list(machine.driver.registers) == registers


def test_all_twelve_keys_act_at_once():
    machine = Machine()
    machine.driver.set(10)
    machine.press("1WE4T")
    machine.run(Pace(0, 10).time(7))
    assert machine.driver.registers == (7, -7, -7, 7, -7, 0)
    assert len({time for time, _, _ in machine.analyser.writes}) == 7


def test_opposite_keys_cancel():
    machine = Machine()
    machine.driver.set()
    machine.press("123456QWERTY")
    machine.run(Pace(0, 50).time(200))
    assert machine.analyser.writes == []
    machine.release("6")
    machine.run(Pace(0, 50).time(210))
    assert machine.driver.registers == (0, 0, 0, 0, 0, -10)


def test_other_keys_do_nothing():
    machine = Machine()
    machine.driver.set()
    machine.press(set(Key) - set("0123456QWERTY") - {Key.BREAK})
    assert machine.run(1_000_000) is Progress.BUSY
    assert machine.analyser.writes == []


@given(st.integers(0, 100_000), st.integers(0, 100_000))
@example(pressed=0, held=3 * PERIOD_50)
@example(pressed=0, held=Pace(0, 50).time(63))
def test_motion_starts_and_stops_within_one_step_of_the_key(pressed, held):
    machine = Machine()
    machine.driver.set(50)
    machine.run(pressed)
    machine.press("1")
    machine.run(pressed + held)
    machine.release("1")
    machine.run(pressed + held + 100_000)
    times = [time for time, _, _ in machine.analyser.writes]
    assert all(pressed <= time < pressed + held for time in times)
    # Ticks come at whole T-states: now and then there is one more between two of them.
    longest = PERIOD_50 + 1
    if held > longest:
        assert times[0] - pressed <= longest
        assert pressed + held - times[-1] <= longest


def test_0_ends_manual_mode_at_once_and_does_not_end_the_next_one():
    machine = Machine()
    machine.driver.set(1000)
    machine.run(5000)
    machine.press("0")
    assert machine.run(100_000) is Progress.DONE
    assert machine.clock.now == 5000
    machine.driver.set()
    assert machine.run(500_000) is Progress.BUSY
    machine.release("0")
    assert machine.run(600_000) is Progress.BUSY
    machine.press("0")
    assert machine.run(700_000) is Progress.DONE


def test_the_elbow_key_keeps_the_hands_opening():
    machine = Machine()
    machine.driver.set()
    machine.press("3")
    machine.run(Pace(0, 50).time(12))
    writes = machine.analyser.writes
    assert patterns(writes, Latch.HAND) == [HALF_STEPS[-i % 8] for i in range(1, 13)]
    assert machine.driver.registers == (0, 0, 12, 0, 0, 0)


def test_elbow_up_with_hand_open_leaves_the_hand_motor_still():
    machine = Machine()
    machine.driver.set()
    machine.press("36")
    machine.run(Pace(0, 50).time(12))
    assert patterns(machine.analyser.writes, Latch.HAND) == []
    assert machine.driver.registers == (0, 0, 12, 0, 0, 12)


def test_elbow_up_with_hand_close_take_turns_so_that_no_motor_steps_twice_a_tick():
    machine = Machine()
    machine.driver.set()
    machine.press("3Y")
    machine.run(Pace(0, 50).time(12))
    writes = machine.analyser.writes
    assert ticks(writes, Latch.HAND, 0, PERIOD_50) == list(range(12))
    assert ticks(writes, Latch.ELBOW, 0, PERIOD_50) == list(range(0, 12, 2))
    assert machine.driver.registers == (0, 0, 6, 0, 0, -6)


def test_the_keys_of_manual_mode_can_be_chosen():
    keys = JogKeys(positive=tuple(map(Key, "QWERTY")), negative=tuple(map(Key, "123456")))
    machine = Machine(settings=DriverSettings(keys=keys, set_delay=0))
    machine.driver.set()
    machine.press("Q")
    machine.run(Pace(0, 0).time(5))
    assert machine.driver.registers[0] == 5


@pytest.mark.parametrize(
    "wrong",
    [
        {"positive": (Key.N1,)},
        {"leave": Key.N1},
        {"leave": Key.BREAK},
        {"negative": (Key.Q, Key.Q, Key.E, Key.R, Key.T, Key.Y)},
    ],
)
def test_keys_that_contradict_each_other_are_refused(wrong):
    with pytest.raises(ValueError):
        JogKeys(**wrong)


@pytest.mark.parametrize("wrong", [{"set_delay": -1}, {"close_delay": 32768}])
def test_a_usual_delay_must_be_one_that_basic_could_give(wrong):
    with pytest.raises(ValueError):
        DriverSettings(**wrong)


# -- @RESET and @READ ------------------------------------------------------------------------


def test_reset_zeroes_the_registers_and_switches_the_six_motors_off():
    machine = Machine()
    machine.card.write(0x9E, 0xA)
    machine.step(0, 3, 4, 5, 6, 7, 8)
    machine.driver.reset()
    assert machine.driver.read() == (0, 0, 0, 0, 0, 0)
    assert machine.card.latches == [0, 0, 0, 0, 0, 0, 0xA]


def test_the_next_step_after_a_reset_goes_on_from_the_row_before_it():
    machine = Machine()
    machine.step(0, 3)
    machine.driver.reset()
    assert patterns(machine.step(0, 1), 0) == [HALF_STEPS[4]]
    assert machine.card.latches[1:6] == [0] * 5


def test_patterns_sent_with_out_leave_the_drivers_row_and_registers_alone():
    machine = Machine()
    machine.step(0, 3)
    machine.card.write(0x98, 0b1001)
    assert machine.driver.registers[0] == 3
    assert machine.card.latches[0] == 0b1001
    assert patterns(machine.step(0, 1), 0) == [HALF_STEPS[4]]


def test_whoever_wants_to_know_hears_of_a_reset():
    machine = Machine()
    heard = []
    machine.driver.reset_observers.append(lambda: heard.append(machine.driver.registers))
    machine.step(0, 3)
    machine.driver.reset()
    assert heard == [(0, 0, 0, 0, 0, 0)]
    assert pickle.loads(pickle.dumps(machine.driver)).reset_observers == []


def test_the_mode_tells_what_the_driver_does():
    machine = Machine()
    modes = [machine.driver.mode]
    machine.driver.step(0, (9, 0, 0, 0, 0, 0))
    modes.append(machine.driver.mode)
    machine.run()
    modes.append(machine.driver.mode)
    machine.driver.close()
    modes.append(machine.driver.mode)
    machine.driver.set()
    modes.append(machine.driver.mode)
    machine.driver.reset()
    modes.append(machine.driver.mode)
    idle = Mode.IDLE
    assert modes == [idle, Mode.STEP, idle, Mode.CLOSE, Mode.SET, idle]


def test_a_motion_can_be_gone_through_tick_by_tick():
    machine = Machine()
    assert machine.driver.next_tick is None
    machine.driver.step(50, (3, 0, 0, 0, 0, 0))
    for done in range(3):
        assert machine.driver.registers[0] == done
        machine.run(machine.driver.next_tick + 1)
    assert machine.driver.registers[0] == 3
    machine.run()
    assert machine.driver.next_tick is None


def test_manual_mode_reads_each_row_of_the_keyboard_once_a_look() -> None:
    machine = Machine()
    read: list[int] = []
    peek = machine.matrix.peek

    def count(address: int) -> int:
        read.append(address)
        return peek(address)

    machine.matrix.peek = count  # type: ignore[method-assign]
    machine.driver.set()
    assert len(read) == len(set(read))
    read.clear()
    machine.run(until=1000)
    assert 0 < len(read) == len(set(read))
