"""The driver's routines on a bare Z-80 write what the machine's own driver writes, when it does."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from tests.machine.armbasic_z80.assembled import assembled, blocks, driver
from tests.machine.armbasic_z80.board import Board, lateness, patterns
from tests.machine.bench_top import ClosingHand, Machine, Write
from trs80arm.machine.coordination import Pace
from trs80arm.machine.half_steps import HALF_STEPS
from trs80arm.machine.keys import Key
from trs80arm.progress import Progress

TOLERANCE = 0.02
"""Of a tick."""

count = st.one_of(st.just(0), st.integers(-2, 2), st.integers(-40, 40))
counts = st.lists(count, min_size=6, max_size=6)
delays = st.one_of(st.just(0), st.integers(0, 100), st.integers(0, 3000))


def period(delay: int) -> float:
    """T-states of a tick."""
    over, under = Pace(0, delay).ratio
    return over / under


def check_same(mine: list[Write], reference: list[Write], start: int, delay: int) -> None:
    """The same writes in the same order, each within the tolerance of its time."""
    assert patterns(mine) == patterns(reference)
    if mine:
        worst = max(map(abs, lateness(mine, reference, start)))
        assert worst <= TOLERANCE * period(delay)


# -- @STEP ----------------------------------------------------------------------------------------


@settings(max_examples=150, deadline=None)
@given(delays, counts)
@example(0, [1, 1, 1, 1, 1, 1])
@example(0, [40, -40, 40, -40, 40, -40])
@example(50, [21, 3, 0, 0, 0, 0])
@example(20, [0, 0, 30, 0, 0, 30])
def test_a_move_is_the_built_in_drivers(delay: int, steps: list[int]) -> None:
    board, machine = Board(), Machine()
    check_same(board.move(delay, *steps), machine.step(delay, *steps), 0, delay)
    assert board.registers == machine.driver.registers


@settings(max_examples=40, deadline=None)
@given(st.lists(st.one_of(counts, st.none()), min_size=2, max_size=5))
def test_moves_go_on_where_the_one_before_ended(moves: list[list[int] | None]) -> None:
    board, machine = Board(), Machine()
    for steps in moves:
        if steps is None:
            assert board.call("OFF")
            machine.driver.reset()
        else:
            start = machine.clock.now
            check_same(board.move(10, *steps), machine.step(10, *steps), start, 10)
        assert board.registers == machine.driver.registers
        assert board.card.latches == machine.card.latches


@pytest.mark.parametrize(
    ("delay", "steps"),
    [
        (0, (32767, -32768, 1, 0, 2, 12345)),
        (3, (0, 0, -32768, 0, 0, 32767)),
        (3, (0, 5, 32767, -3, 0, -32768)),
        (1, (0, 0, 32767, 0, 0, 32767)),
        (32767, (3, -2, 0, 1, 0, 0)),
    ],
)
def test_the_longest_moves_and_ticks_are_too(delay: int, steps: tuple[int, ...]) -> None:
    board, machine = Board(), Machine()
    check_same(board.move(delay, *steps), machine.step(delay, *steps), 0, delay)
    assert board.registers == machine.driver.registers


@pytest.mark.parametrize("delay", [0, 1, 2, 7, 50, 99, 1000, 32767])
def test_ticks_are_as_long_as_the_formula_to_the_t_state(delay: int) -> None:
    board = Board()
    times = [time for time, _, _ in board.move(delay, 30)]
    assert {later - earlier for earlier, later in pairwise(times)} <= {
        int(period(delay)),
        int(period(delay)) + 1,
    }
    assert times[-1] - times[0] == pytest.approx(29 * period(delay), abs=2, rel=1e-7)


def test_a_move_comes_back_when_it_would_make_the_next_step_ready() -> None:
    board = Board()
    next_step = board.move(50, 10)[-1][0] + period(50)
    assert next_step - 2000 < board.clock.now < next_step


def test_a_move_of_no_steps_writes_nothing() -> None:
    board = Board()
    assert board.move(50) == []
    assert board.clock.now < period(50)


# -- @CLOSE ---------------------------------------------------------------------------------------


@settings(max_examples=40, deadline=None)
@given(delays, st.integers(0, 30))
def test_close_is_the_built_in_drivers(delay: int, closes_after: int) -> None:
    board, machine = Board(ClosingHand(closes_after)), Machine(ClosingHand(closes_after))
    assert board.call("CLOSE", de=delay)
    machine.driver.close(delay)
    machine.run()
    check_same(board.analyser.writes, machine.analyser.writes, 0, delay)
    assert board.registers == machine.driver.registers == (0, 0, 0, 0, 0, -closes_after)
    assert not board.carry


@pytest.mark.parametrize("tick", [0, 1, 17])
def test_break_ends_a_close_that_would_never_end(tick: int) -> None:
    board, machine = Board(), Machine()
    board.at_ticks([(tick, True, Key.BREAK)], period(50))
    assert board.call("CLOSE", de=50)
    assert board.carry
    machine.driver.close(50)
    machine.run(int((tick - 0.5) * period(50)))
    machine.press([Key.BREAK])
    assert machine.run() is Progress.BREAK
    check_same(board.analyser.writes, machine.analyser.writes, 0, 50)


@pytest.mark.parametrize(("bit", "shut"), [(1, 0), (1, 1), (4, 0), (4, 4)])
def test_the_grip_switch_may_be_another_bit(bit: int, shut: int) -> None:
    class Hand(ClosingHand):
        def inputs(self, time: int) -> int:
            return shut if self.steps <= 0 else 0b1111 ^ shut

    board = Board(Hand(5))
    board.put_byte("GRIP", bit)
    board.put_byte("SHUT", shut)
    assert board.call("CLOSE", de=0)
    assert board.registers[5] == -5


# -- @SET -----------------------------------------------------------------------------------------

KEYS = "123456QWERTY"
pressed = st.lists(
    st.tuples(st.integers(0, 5), st.booleans(), st.sampled_from(KEYS)), min_size=1, max_size=20
)


def manual(delay: int, keys: list[tuple[int, bool, str]], ending: str) -> tuple[Board, Machine]:
    """Manual mode on both, with keys pressed and released half a tick before ticks."""
    board, machine = Board(), Machine()
    board.at_ticks(keys, period(delay))
    assert board.call("MANUAL", de=delay, limit=100_000_000)
    before = [(down, key) for tick, down, key in keys if tick == 0]
    for down, key in before:
        (machine.press if down else machine.release)([Key(key)])
    machine.driver.set(delay)
    for tick, down, key in keys[len(before) :]:
        machine.run(int((tick - 0.5) * period(delay)))
        (machine.press if down else machine.release)([Key(key)])
    expected = Progress.BREAK if ending == Key.BREAK else Progress.DONE
    assert machine.run() is expected
    assert board.carry is (ending == Key.BREAK)
    return board, machine


@settings(max_examples=100, deadline=None)
@given(st.integers(0, 100), pressed, st.sampled_from(["0", Key.BREAK]))
@example(0, [(0, True, key) for key in "123456"], "0")
@example(0, [(0, True, "3"), (0, True, "Y")], "0")
@example(7, [(1, True, "E"), (0, True, "6"), (5, True, "3"), (0, False, "6")], "0")
def test_manual_mode_is_the_built_in_drivers(
    delay: int, after: list[tuple[int, bool, str]], ending: str
) -> None:
    tick, keys = 0, []
    for ticks, down, key in after:
        tick += ticks
        keys.append((tick, down, key))
    board, machine = manual(delay, [*keys, (tick + 6, True, ending)], ending)
    check_same(board.analyser.writes, machine.analyser.writes, 0, delay)
    assert board.registers == machine.driver.registers


def test_a_0_that_is_down_must_be_let_go_first() -> None:
    keys = [(0, True, "0"), (2, True, "1"), (5, False, "0"), (9, True, "0")]
    board, machine = manual(20, keys, "0")
    assert board.registers == machine.driver.registers == (7, 0, 0, 0, 0, 0)


def test_manual_mode_takes_the_same_time_whatever_is_down() -> None:
    others = [(tick, tick % 3 != 2, key) for tick, key in enumerate("2W3E4R5T6Y3Y6E3542W", start=1)]
    board, _ = manual(0, [(0, True, "1"), *others, (40, True, "0")], "0")
    base = [time for time, latch, _ in board.analyser.writes if latch == 0]
    assert len(base) == 40
    assert {later - earlier for earlier, later in pairwise(base)} <= {2128, 2129}


# -- half steps of one's own ----------------------------------------------------------------------


@settings(max_examples=60, deadline=None)
@given(st.lists(st.lists(st.sampled_from([-1, 0, 1]), min_size=6, max_size=6), max_size=8))
def test_pulse_steps_the_motors_that_ways_names_and_writes_no_other(ways: list[list[int]]) -> None:
    board = Board()
    rows = [0] * 6
    expected = []
    for way in ways:
        for motor, direction in enumerate(way):
            board.put_byte("WAYS", direction, motor)
            rows[motor] += direction
            if direction:
                expected.append((motor, HALF_STEPS[rows[motor] % 8]))
        assert board.call("PULSE")
    assert patterns(board.analyser.writes) == expected


def test_every_pulse_takes_the_same_time() -> None:
    board, taken = Board(), set()
    for ways in ((0,) * 6, (1,) * 6, (-1,) * 6, (1, 0, -1, 0, 0, 1)):
        for motor, direction in enumerate(ways):
            board.put_byte("WAYS", direction, motor)
        begins = board.clock.now
        assert board.call("PULSE")
        taken.add(board.clock.now - begins)
    assert len(taken) == 1


def test_registers_have_16_bits() -> None:
    board = Board()
    board.move(0, 32767, -32768)
    board.move(0, 1, -1)
    assert board.registers[:2] == (-32768, 32767)


def test_a_loop_that_takes_longer_than_a_tick_waits_a_moment_only() -> None:
    board = Board()
    assert board.call("PACE", de=0, hl=60_000)
    begins = board.clock.now
    assert board.call("WAIT")
    assert board.clock.now - begins < 400


def test_the_pages_own_program_turns_two_motors(tmp_path) -> None:
    board = Board()
    (source,) = blocks("z80")
    board.load(31100, assembled(source, tmp_path))
    assert board.call_at(31100)
    assert board.registers == (100, -100, 0, 0, 0, 0)
    base = [time for time, latch, _ in board.analyser.writes if latch == 0]
    assert base[-1] - base[0] == pytest.approx(99 * period(60), abs=2)


# -- from the tape --------------------------------------------------------------------------------

READY, NEW, FETCH, MEMTOP, STRTOP = 0x06CC, 0x1B4D, 0x4003, 0x40B1, 0x40A0


def started(memory_top: int) -> tuple[Board, list[int]]:
    """The driver started from its tape; which addresses of the ROM it went to."""
    board, visited = Board(), []

    def visit() -> None:
        visited.append(board.chip.pc)
        board.go_back()

    for address in (READY, NEW):
        board.answer(address, visit)
    board.load(FETCH, b"\xc3\x78\x1d")
    board.put_words(MEMTOP, [memory_top])
    assert board.call("START")
    return board, visited


def test_started_below_an_answered_memory_size_it_hooks_in_and_goes_to_ready() -> None:
    board, visited = started(driver().origin - 2)
    assert visited == [READY]
    hook = driver().symbols["HOOK"].to_bytes(2, "little")
    assert bytes(board.chip.memory[FETCH : FETCH + 3]) == b"\xc3" + hook
    assert board.words(MEMTOP, 1) == [driver().origin - 2]


def test_started_with_all_memory_for_basic_it_takes_what_it_needs() -> None:
    board, visited = started(0x7FFF)
    assert visited == [NEW, READY]
    assert board.words(MEMTOP, 1) == [driver().origin - 2]
    assert board.words(STRTOP, 1) == [driver().origin - 52]


def test_started_again_it_takes_another_base_port() -> None:
    board, _ = started(driver().origin - 2)
    written: list[int] = []
    board.put_byte("BASE", 0xB8)
    assert board.call("START")
    board.chip.set_output_callback(lambda port, value: written.append(port & 0xFF))
    board.move(0, 1, 1, 1, 1, 1, 2)
    assert board.call("OFF")
    assert written[:6] == written[-6:] == [0xB8, 0xB9, 0xBA, 0xBB, 0xBC, 0xBD]


# -- the hook -------------------------------------------------------------------------------------

GETCH, BEGINS = 0x1D78, 0x1D5B
TEXT = 0x6000


def fetched(text: bytes) -> tuple[int, int, bool, bool]:
    """What BASIC's fetching of a character gives: where, which, end of statement, figure."""
    at = 0
    while text[at] in b"\t\n ":
        at += 1
    return TEXT + at, text[at], text[at] in b":\0", 0x30 <= text[at] <= 0x39


@pytest.mark.parametrize("blanks", [b"", b" ", b" \n\t "])
def test_the_hook_fetches_every_character_as_the_rom_does(blanks: bytes) -> None:
    for code in set(range(256)) - set(b"\t\n "):
        board = Board()

        def answer(board: Board = board) -> None:
            chip = board.chip
            rest = bytes(chip.memory[chip.hl + 1 : TEXT + 10])
            at, chip.a, ends, figure = fetched(rest)
            chip.hl += 1 + at - TEXT
            chip.f = ends << 6 | figure
            board.go_back()

        board.answer(GETCH, answer)
        board.load(TEXT, blanks + bytes((code, 0)))
        assert board.call("HOOK", hl=TEXT - 1, de=0x1234, bc=0x5678)
        chip = board.chip
        got = chip.hl, chip.a, bool(chip.f & 0x40), board.carry
        assert got == fetched(blanks + bytes((code, 0)))
        assert (chip.de, chip.bc) == (0x1234, 0x5678)
