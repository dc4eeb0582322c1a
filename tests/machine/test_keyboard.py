from __future__ import annotations

import pickle
from functools import reduce

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trs80arm.machine.clock import T_STATES_PER_SECOND, Clock
from trs80arm.machine.keyboard import WORK_AREA, KeyboardDriver, Matrix
from trs80arm.machine.keys import MATRIX, Key, keys_for
from trs80arm.machine.memory import Memory


class Keyboard:
    """A matrix with the ROM's scan looking at it."""

    def __init__(self) -> None:
        self.clock = Clock()
        self.memory = Memory(16)
        self.matrix = Matrix()
        self.driver = KeyboardDriver(self.clock, self.memory, self.matrix)
        self.memory.attach(0x3800, 0x3C00, self.matrix)

    def codes(self, *keys: Key) -> list[int]:
        """What the scan finds with these keys down, until it finds nothing new."""
        for key in keys:
            self.matrix.press(key)
        codes = []
        while code := self.driver.scan():
            codes.append(code)
        return codes


@pytest.fixture
def keyboard() -> Keyboard:
    return Keyboard()


@given(st.sets(st.sampled_from(list(Key))), st.integers(0x3800, 0x3BFF))
def test_an_address_reads_the_rows_that_it_selects(keys: set[Key], address: int) -> None:
    matrix = Matrix()
    for key in keys:
        matrix.press(key)
    places = [MATRIX[key] for key in keys]
    selected = [1 << bit for row, bit in places if address >> row & 1]
    assert matrix.read(address) == reduce(lambda a, b: a | b, selected, 0)


def test_peek_sees_keys_of_several_rows_in_four_places(keyboard: Keyboard) -> None:
    # Cases keys-peek-matrix-rows and keys-peek-matrix-mirror.
    for key in (Key.A, Key.H, Key.N0):
        keyboard.matrix.press(key)
    peek = keyboard.memory.peek
    assert [peek(14336 + row) for row in (1, 2, 3, 16)] == [2, 1, 3, 1]
    assert [peek(14337 + mirror) for mirror in (256, 512, 768)] == [2, 2, 2]


def test_a_released_key_is_gone() -> None:
    matrix = Matrix()
    matrix.press(Key.C)
    matrix.release(Key.C)
    matrix.release(Key.D)
    assert matrix.read(0x38FF) == 0


def test_all_keys_can_be_let_go_at_once() -> None:
    matrix = Matrix()
    matrix.press(Key.C)
    matrix.press(Key.SHIFT)
    matrix.release_all()
    assert matrix.read(0x38FF) == 0
    assert not matrix.held


def test_three_corners_of_a_rectangle_show_the_fourth_with_ghosting() -> None:
    for ghosting, row_of_h in ((False, 0b01), (True, 0b11)):
        matrix = Matrix(ghosting=ghosting)
        for key in (Key.AT, Key.A, Key.H):
            matrix.press(key)
        assert matrix.read(0x3802) == row_of_h


def test_two_keys_never_make_a_ghost() -> None:
    matrix = Matrix(ghosting=True)
    matrix.press(Key.A)
    matrix.press(Key.P)
    assert [matrix.read(0x3800 + (1 << row)) for row in range(3)] == [2, 0, 1]


@given(st.sets(st.sampled_from(list(Key)), max_size=6))
def test_ghosts_only_ever_add_keys(keys: set[Key]) -> None:
    plain, haunted = Matrix(), Matrix(ghosting=True)
    for key in keys:
        plain.press(key)
        haunted.press(key)
    for row in range(8):
        address = 0x3800 + (1 << row)
        assert plain.read(address) & ~haunted.read(address) == 0


@pytest.mark.parametrize("character", [chr(code) for code in range(32, 64)])
def test_the_scan_gives_the_sign_that_was_meant(keyboard: Keyboard, character: str) -> None:
    keys = keys_for(character)
    assert keys is not None
    assert keyboard.codes(*keys) == [ord(character)]


def test_letters_are_capitals_and_small_with_shift(keyboard: Keyboard) -> None:
    letters = [Key(chr(code)) for code in range(64, 91)]
    for number, letter in enumerate(letters):
        assert keyboard.codes(letter) == [64 + number]
        keyboard.matrix.release_all()
        keyboard.driver.scan()
        assert keyboard.codes(Key.SHIFT, letter) == [96 + number]
        keyboard.matrix.release_all()
        keyboard.driver.scan()


@pytest.mark.parametrize(
    ("key", "plain", "shifted"),
    [
        (Key.ENTER, 13, 13),
        (Key.CLEAR, 31, 31),
        (Key.BREAK, 1, 1),
        (Key.UP, 91, 27),
        (Key.DOWN, 10, 26),
        (Key.LEFT, 8, 24),
        (Key.RIGHT, 9, 25),
        (Key.SPACE, 32, 32),
        (Key.N0, 48, 32),
    ],
)
def test_the_other_keys_have_their_codes(key: Key, plain: int, shifted: int) -> None:
    assert Keyboard().codes(key) == [plain]
    assert Keyboard().codes(Key.SHIFT, key) == [shifted]


def test_shift_and_down_make_a_letter_a_control_code(keyboard: Keyboard) -> None:
    assert keyboard.codes(Key.SHIFT, Key.DOWN) == [26]
    assert keyboard.codes(Key.A) == [1]


def test_a_held_key_counts_once(keyboard: Keyboard) -> None:
    assert keyboard.codes(Key.X) == [88]
    assert keyboard.driver.scan() == 0


def test_rolling_over_to_another_row_loses_nothing(keyboard: Keyboard) -> None:
    assert keyboard.codes(Key.A) == [65]
    assert keyboard.codes(Key.P) == [80]
    assert keyboard.codes(Key.X) == [88]


def test_keys_of_different_rows_at_once_are_all_seen(keyboard: Keyboard) -> None:
    assert keyboard.codes(Key.SLASH, Key.H, Key.A) == [65, 72, 47]


def test_of_two_new_keys_in_one_row_only_the_lower_bit_counts(keyboard: Keyboard) -> None:
    # Case keys-input-two-at-once.
    assert keyboard.codes(Key.A, Key.B) == [65]


def test_shift_alone_is_no_key(keyboard: Keyboard) -> None:
    assert keyboard.codes(Key.SHIFT) == []
    assert keyboard.driver.quiet


def test_a_key_costs_the_debounce_pause(keyboard: Keyboard) -> None:
    keyboard.codes(Key.Q)
    # The two keys of keys-inkey-latched-last against the one of keys-inkey-latched; 52 of them
    # are the statement loop's.
    assert keyboard.clock.now == 5579385 - 5488402 - 52
    assert keyboard.clock.now / T_STATES_PER_SECOND == pytest.approx(0.051, abs=0.001)


def test_an_idle_scan_is_free(keyboard: Keyboard) -> None:
    keyboard.driver.scan()
    assert keyboard.clock.now == 0


def test_the_work_area_shows_what_the_scan_saw(keyboard: Keyboard) -> None:
    keyboard.codes(Key.A, Key.SPACE)
    seen = [keyboard.memory.peek(WORK_AREA + row) for row in range(7)]
    assert seen == [2, 0, 0, 0, 0, 0, 128]


def test_clearing_the_work_area_makes_held_keys_new(keyboard: Keyboard) -> None:
    keyboard.codes(Key.A)
    keyboard.memory.poke(WORK_AREA, 0)
    assert not keyboard.driver.quiet
    assert keyboard.driver.scan() == 65


@given(st.lists(st.tuples(st.sampled_from(list(Key)), st.booleans()), max_size=12))
def test_a_quiet_keyboard_has_nothing_to_tell(events: list[tuple[Key, bool]]) -> None:
    keyboard = Keyboard()
    for key, down in events:
        (keyboard.matrix.press if down else keyboard.matrix.release)(key)
        area = bytes(keyboard.memory.ram[WORK_AREA : WORK_AREA + 7])
        quiet = keyboard.driver.quiet
        code = keyboard.driver.scan()
        same = area == bytes(keyboard.memory.ram[WORK_AREA : WORK_AREA + 7])
        assert quiet == (code == 0 and same)


def test_a_pickled_keyboard_knows_its_keys() -> None:
    keyboard = Keyboard()
    keyboard.codes(Key.A, Key.SHIFT)
    copy = pickle.loads(pickle.dumps(keyboard))
    assert copy.matrix.held == {Key.A, Key.SHIFT}
    assert copy.driver.quiet
    assert copy.codes(Key.N2) == [34]
    assert keyboard.driver.quiet
