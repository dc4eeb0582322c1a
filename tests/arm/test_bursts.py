"""Whole motions at once: the state does not depend on how the writes are cut."""

from __future__ import annotations

import pickle
import random
from functools import cache

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from tests.arm.writes import CELL, Recorder, Writes, picks_and_places
from trs80arm.arm import Bench, MiniMover, benchfile
from trs80arm.arm.contact.clock import PAUSE
from trs80arm.arm.motors import PHASES
from trs80arm.arm.stepping import SWITCH_CLOSED, PulseGenerator, delay_period
from trs80arm.pulses import Columns

BENCH = """
[[feeder]]
at = [8, 0]
size = [0.5, 0.5, 1.0]
weight = 6
[[tray]]
at = [6, 5]
size = [3, 3]
[[part]]
at = [5, 4]
size = [1, 1, 2]
[[obstacle]]
at = [5, -5]
size = [1, 2, 6]
[[proximity]]
bit = 1
at = [6, 5, 0]
range = 2
"""


def motions(seed: int, most: int = 5) -> Writes:
    """A program's worth of latch writes."""
    recorder = Recorder()
    work(PulseGenerator(recorder), seed, most)  # type: ignore[arg-type]
    return recorder.writes


def work(generator: PulseGenerator, seed: int, most: int = 5) -> None:
    """Free motions, pick-ups, motions that fail: so many at most."""
    chance = random.Random(seed)
    speeds = [delay_period(d) for d in (50, 50, 100, 0)]
    generator.step((0, 0, 0, 0, 0, chance.choice([0, 370, 800])), speeds[0])
    for _ in range(chance.randint(1, most)):
        if chance.random() < 0.4:
            counts = [chance.randrange(-300, 300) for _ in range(6)]
            generator.step(counts, chance.choice(speeds))
            continue
        for counts in (
            (0, -207, 290),
            (0, 132, -36),
            (0, 0, 0, 0, 0, -chance.randrange(20, 200)),
            (0, -132, 36),
            tuple(chance.randrange(-300, 300) for _ in range(5)),
        ):
            generator.step(counts, speeds[0])
        if chance.random() < 0.3:
            generator.time += 100
            generator.arm.follow(Columns([generator.time] * 7, range(7), [0] * 7), None)


@cache
def in_one_piece(seed: int, most: int = 5) -> object:
    """The signature of an arm that did the writes of some motions at once."""
    return signature(run(motions(seed, most), []))


def run(writes: Writes, cuts: list[int], bench: str = BENCH) -> MiniMover:
    arm = MiniMover(bench=benchfile.parse(bench))
    begin = 0
    for cut in [*cuts, len(writes)]:
        piece = writes[begin : begin + cut]
        begin += cut
        if piece:
            times, latches, nibbles = zip(*piece, strict=True)
            assert arm.apply(times, latches, nibbles) == len(piece)
    return arm


def signature(arm: MiniMover) -> object:
    arm.world.show()
    scene = arm.bench.scene
    parts = [
        (part.name, part.place, part.turn, part.held, part.asleep, part.still, part.carried)
        for part in arm.bench.parts.values()
    ]
    motors = [
        (m.coils, m.row, m.field, m.rotor, m.ring, m.anchor, m.pulses, m.way, m.moved, m.done)
        for m in arm.motors
    ]
    pressing = scene.joints, scene.torques, scene.time
    return arm.state(), motors, arm.peaks, arm.events, parts, pressing, arm.grip, arm.inputs(0)


@settings(max_examples=25, deadline=None)
@given(st.integers(0, 10**6), st.lists(st.integers(1, 900), min_size=1, max_size=12), st.just(2))
@example(96056, [315, 630], 5)
def test_any_cutting_of_the_same_writes_gives_the_same_state(
    seed: int, cuts: list[int], most: int
) -> None:
    assert signature(run(motions(seed, most), cuts)) == in_one_piece(seed, most)


@settings(max_examples=15, deadline=None)
@given(
    st.integers(0, 10**6),
    st.lists(st.tuples(st.integers(0, 1200), st.integers(0, 2 * PAUSE)), min_size=1, max_size=8),
    st.none() | st.lists(st.integers(1, 900), min_size=1, max_size=6),
)
@example(3, [(40, PAUSE - 1), (41, PAUSE), (300, PAUSE + 1), (700, 2 * PAUSE)], [35, 10])
@example(262, [(405, 67), (90, 217), (907, 317), (0, 991), (1200, 130)], None)
def test_pauses_in_which_the_clock_stands_are_the_same_however_cut(
    seed: int, waits: list[tuple[int, int]], cuts: list[int] | None
) -> None:
    writes = [
        (time + sum(wait for place, wait in waits if place <= number), latch, nibble)
        for number, (time, latch, nibble) in enumerate(motions(seed, 2))
    ]
    pieces = [1] * len(writes) if cuts is None else cuts
    assert signature(run(writes, pieces)) == signature(run(writes, []))


@pytest.mark.parametrize("seed", range(4))
def test_arrays_and_single_writes_give_the_same_state(seed: int) -> None:
    writes = motions(seed)
    assert signature(run(writes, [1] * len(writes))) == in_one_piece(seed)


@settings(max_examples=10, deadline=None)
@given(st.integers(0, 10**6))
def test_trains_of_pulses_and_their_single_writes_give_the_same_state(seed: int) -> None:
    generator = PulseGenerator(MiniMover(bench=benchfile.parse(BENCH)))
    work(generator, seed, most=2)
    assert signature(generator.arm) == in_one_piece(seed, most=2)


@pytest.mark.parametrize(("weight", "manages"), [(1.5, True), (3, False)])
def test_a_motor_that_falls_behind_is_done_at_the_same_time_however_cut(
    weight: float, manages: bool
) -> None:
    bench = BENCH.replace("weight = 6", f"weight = {weight}")
    moves = ((0, 0, 0, 0, 0, 370), (0, -75, 254), (0, 0, 0, 0, 0, -190), (0, -132, 36))
    generator = PulseGenerator(MiniMover(bench=benchfile.parse(bench)))
    recorder = Recorder()
    recording = PulseGenerator(recorder)  # type: ignore[arg-type]
    for counts in moves:
        generator.step(counts, delay_period(50))
        recording.step(counts, delay_period(50))
    lifting = generator.arm.motors[1]
    assert (lifting.rotor == lifting.field) == manages
    assert (lifting.done - lifting.moved > 2 * delay_period(50)) == manages
    writes = recorder.writes
    for cuts in ([], [1] * len(writes), [700], [50] * 20):
        assert signature(run(writes, cuts, bench)) == signature(generator.arm)


@settings(max_examples=20, deadline=None)
@given(
    st.lists(st.tuples(st.integers(0, 9000), st.integers(0, 6), st.integers(0, 15)), max_size=150),
    st.integers(1, 150),
)
def test_random_patterns_are_the_same_however_cut(steps: Writes, cut: int) -> None:
    time, writes = 0, []
    for wait, latch, nibble in steps:
        time += wait
        writes.append((time, latch, nibble))
    assert signature(run(writes, [cut])) == signature(run(writes, [1] * len(writes)))


def test_a_stop_condition_ends_whole_and_cut_bursts_alike() -> None:
    ends = set()
    for piece in (1, 7, 40, 100, 3000):
        arm = MiniMover(bench=benchfile.parse(BENCH))
        generator = PulseGenerator(arm)
        generator.step((0, 0, 0, 0, 0, 900), delay_period(50))
        generator.step((0, -75, 254), delay_period(50))
        done = 0
        while not arm.grip.switch_closed:
            done += generator.step((0, 0, 0, 0, 0, -piece), delay_period(50), SWITCH_CLOSED)
        ends.add((done, arm.state()))
    assert len(ends) == 1


def test_a_burst_without_its_stop_is_done_to_the_end() -> None:
    arm = MiniMover(bench=Bench("empty"))
    times = [5000 * i for i in range(200)]
    patterns = [PHASES[i % 8] for i in range(200)]
    assert arm.apply(times, [5] * 200, patterns, SWITCH_CLOSED) == 200
    assert arm.apply(times, [0] * 200, patterns, (1, 1)) == 1


@pytest.mark.parametrize("seed", range(3))
def test_what_is_known_of_a_burst_from_the_last_time_round_changes_nothing(seed: int) -> None:
    chance = random.Random(seed)
    ways = [tuple(chance.randrange(-200, 200) for _ in range(5)) for _ in range(3)]
    round_trip = [*ways, *(tuple(-count for count in way) for way in ways)]
    arms = []
    for forgets in (False, True):
        generator = PulseGenerator(MiniMover(bench=benchfile.parse("")))
        generator.step((0, 0, 0, 0, 0, 300), delay_period(50))
        for lap in range(3):
            for number, way in enumerate(round_trip):
                # What goes on at once and what begins after a while asks other things of a motor.
                generator.time += 1000 * number * lap
                generator.step(way, delay_period(60))
                if forgets:
                    generator.arm = pickle.loads(pickle.dumps(generator.arm))
        arms.append(generator.arm)
    assert signature(arms[0]) == signature(arms[1])
    assert all(arms[0].peaks[:5])


def test_an_arm_goes_on_after_pickling_as_if_nothing_had_happened() -> None:
    writes = motions(3)
    half = len(writes) // 2
    arm = run(writes[:half], [])
    copy = pickle.loads(pickle.dumps(arm))
    for each in (arm, copy):
        each.apply(*zip(*writes[half:], strict=True))
    assert signature(copy) == signature(arm)


def test_picking_and_placing_is_the_same_cut_anyhow_and_saved_anywhere() -> None:
    writes = picks_and_places(2)
    arm = MiniMover(bench=benchfile.parse(CELL))
    arm.apply(*zip(*writes, strict=True))
    assert arm.bench.trays[0].taken == 2
    for seed in range(3):
        chance = random.Random(seed)
        other, begin = MiniMover(bench=benchfile.parse(CELL)), 0
        while begin < len(writes):
            end = begin + chance.choice([1, 2, 3, 10, 23, 24, 50, 200, 700])
            other.apply(*zip(*writes[begin:end], strict=True))
            begin = end
            if seed == 2 and chance.random() < 0.3:
                other = pickle.loads(pickle.dumps(other))
        assert signature(other) == signature(arm)
