from __future__ import annotations

import pickle

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trs80arm.machine.clock import Clock
from trs80arm.machine.console import Console
from trs80arm.machine.display import Display
from trs80arm.machine.keyboard import KeyboardDriver, Matrix
from trs80arm.machine.memory import Memory
from trs80arm.machine.video import ROWS, Video, glyph


class Tube:
    """A display with its video memory in the map."""

    def __init__(self) -> None:
        self.clock = Clock()
        self.memory = Memory(16)
        self.video = Video()
        self.display = Display(self.clock, self.memory, self.video)
        self.console = Console(self.display, KeyboardDriver(self.clock, self.memory, Matrix()))
        self.memory.attach(0x3C00, 0x4000, self.video)
        self.show(28, 31)

    def show(self, *what: str | int) -> list[str]:
        """Print texts and codes; the screen without its empty rows at the end."""
        for item in what:
            for code in item.encode("latin-1") if isinstance(item, str) else (item,):
                self.display.put(code)
        lines = self.video.lines()
        while lines and not lines[-1]:
            lines.pop()
        return lines

    def cost(self, *what: str | int) -> int:
        """The T-states that printing takes."""
        before = self.clock.now
        self.show(*what)
        return self.clock.now - before


@pytest.fixture
def tube() -> Tube:
    return Tube()


def test_video_memory_has_no_bit_6(tube: Tube) -> None:
    tube.memory.poke(15360, 1)
    tube.memory.poke(15361, 200)
    tube.memory.poke(15362, 97)
    assert [tube.memory.peek(15360 + i) for i in range(3)] == [65, 136, 33]


def test_poking_0_to_31_shows_the_capitals(tube: Tube) -> None:
    # Case gfx-poke-screen-low.
    for code in range(32):
        tube.memory.poke(15360 + code, code)
    assert tube.video.lines()[0] == "@ABCDEFGHIJKLMNOPQRSTUVWXYZ[\\]^_"


def test_small_letters_are_shown_as_capitals(tube: Tube) -> None:
    # Case gfx-lowercase-shown.
    assert tube.show("abc XYZ xyz `") == ["ABC XYZ XYZ @"]


def test_the_character_generator_has_arrows() -> None:
    assert [glyph(code) for code in (65, 0x5B, 0x5C, 0x5D, 0x5E, 0x5F, 128)] == list("A↑↓←→_ ")


def test_a_newline_erases_the_line_it_comes_to(tube: Tube) -> None:
    tube.display.cursor = 64
    tube.show("OLD TEXT", 28, "A", 13)
    assert tube.video.lines()[:2] == ["A", ""]


def test_codes_10_to_13_are_newlines(tube: Tube) -> None:
    # Case gfx-chr-10-13.
    assert tube.show("A", 10, "B", 13, "C", 11, "D", 12, "E") == list("ABCDE")


def test_64_characters_wrap_before_the_newline(tube: Tube) -> None:
    assert tube.show("A" * 64, 13, "B") == ["A" * 64, "", "B"]


def test_the_last_line_scrolls(tube: Tube) -> None:
    tube.show("TOP", 13, "SECOND")
    tube.display.cursor = 960
    tube.show("BOTTOM", 13)
    assert tube.video.lines() == ["SECOND", *[""] * 13, "BOTTOM", ""]
    assert tube.display.cursor == 960


def test_a_character_in_the_last_cell_scrolls(tube: Tube) -> None:
    tube.display.cursor = 1023
    tube.show("X")
    assert tube.video.lines()[14:] == [" " * 63 + "X", ""]
    assert tube.display.cursor == 960


def test_backspace_erases_and_goes_back_over_the_edge(tube: Tube) -> None:
    # Case gfx-chr-8-edge.
    tube.display.cursor = 64
    assert tube.show(8, "X") == [" " * 63 + "X"]


def test_arrows_stay_within_the_line(tube: Tube) -> None:
    # Case gfx-chr-8-edge, and gfx-chr-24-25.
    tube.display.cursor = 128
    tube.show(24, "Y")
    assert tube.video.lines()[2] == " " * 63 + "Y"
    tube.display.cursor = 191
    tube.show(25, "Z")
    assert tube.video.lines()[2] == "Z" + " " * 62 + "Y"


def test_down_and_up_go_around_the_screen(tube: Tube) -> None:
    tube.display.cursor = 5
    tube.show(27)
    assert tube.display.cursor == 965
    tube.show(26)
    assert tube.display.cursor == 5


def test_erasing_to_the_end_of_line_and_screen(tube: Tube) -> None:
    # Case gfx-chr-30-31.
    tube.show(*["ABCDEFGHIJ\r"] * 5)
    tube.display.cursor = 67
    tube.show(30)
    tube.display.cursor = 195
    assert tube.show(31) == ["ABCDEFGHIJ", "ABC", "ABCDEFGHIJ", "ABC"]


def test_codes_from_192_are_runs_of_blanks(tube: Tube) -> None:
    # Case gfx-chr-compress.
    shown = tube.show("A", 192, "B", 193, "C", 200, "D", 255, "E")
    assert shown == ["AB C        D", " " * 12 + "E"]


@pytest.mark.parametrize("code", [*range(8), 9, *range(16, 23)])
def test_other_control_codes_do_nothing(tube: Tube, code: int) -> None:
    tube.show("AB")
    assert tube.show(code, "C") == ["ABC"]


def test_code_23_uses_every_other_cell(tube: Tube) -> None:
    # Cases gfx-chr-23 and gfx-chr-23-back.
    assert tube.show(23, "WIDE", 13, "LINE2") == ["W I D E", "L I N E 2"]
    assert tube.display.wide
    assert tube.video.wide
    assert tube.show(28, "HOME") == ["HOMED E", "L I N E 2"]
    assert not tube.display.wide


def test_32_columns_begin_in_an_even_cell(tube: Tube) -> None:
    # Case keys-line-edit-shift-right leaves the cursor at 386 behind the prompt.
    tube.show("ABC", 23)
    assert tube.display.cursor == 4
    assert tube.show("D") == ["ABC D"]


def test_wide_columns_are_counted_singly(tube: Tube) -> None:
    tube.show(23, "ABC")
    assert (tube.display.cursor, tube.display.column) == (6, 3)


def test_wide_backspace_goes_back_two_cells(tube: Tube) -> None:
    assert tube.show(23, "AB", 8, "C") == ["A C"]


def test_the_cursor_sign_covers_and_gives_back(tube: Tube) -> None:
    tube.show("AB", 28, 14)
    assert tube.video.lines()[0] == "_B"
    tube.show(25)
    assert tube.video.lines()[0] == "A_"
    tube.show(15)
    assert tube.video.lines()[0] == "AB"


def test_the_cursor_sign_moves_with_the_text(tube: Tube) -> None:
    assert tube.show(14, "HI") == ["HI_"]
    assert tube.show(13) == ["HI", "_"]


def test_the_cursor_lives_at_16416(tube: Tube) -> None:
    # Case gfx-cursor-peek.
    tube.display.cursor = 300
    assert tube.memory.peek(16416) + 256 * tube.memory.peek(16417) == 15660
    tube.memory.poke(16416, 10)
    tube.memory.poke(16417, 60)
    assert tube.show("X") == [" " * 10 + "X"]


@given(st.binary(max_size=60), st.integers(0, 255), st.integers(0, 255))
def test_whatever_is_printed_the_cursor_stays_on_the_tube(
    codes: bytes, low: int, high: int
) -> None:
    tube = Tube()
    tube.memory.poke(16416, low)
    tube.memory.poke(16417, high)
    for code in codes:
        before = tube.clock.now
        tube.display.put(code)
        assert 0 <= tube.display.cursor < 1024
        assert 0 <= tube.display.column < 64
        assert tube.clock.now > before
    assert len(tube.video.cells) == 1024
    assert all(cell & 0x60 or cell >= 128 for cell in tube.video.cells)


@given(st.integers(0, 127), st.integers(0, 47))
def test_a_block_set_is_lit_and_no_other(x: int, y: int) -> None:
    tube = Tube()
    tube.display.plot(x, y, True)
    lit = [(i, j) for i in range(128) for j in range(48) if tube.display.point(i, j)]
    assert lit == [(x, y)]
    tube.display.plot(x, y, False)
    assert not tube.display.point(x, y)


def test_six_blocks_make_a_cell(tube: Tube) -> None:
    # Case gfx-set-six.
    seen = []
    for y in range(3):
        for x in range(2):
            tube.display.plot(x, y, True)
            seen.append(tube.memory.peek(15360))
    assert seen == [129, 131, 135, 143, 159, 191]


def test_plotting_on_text_makes_it_graphic(tube: Tube) -> None:
    tube.show("AB")
    assert not tube.display.point(0, 0)
    tube.display.plot(1, 2, True)
    tube.display.plot(3, 2, False)
    assert tube.video.cells[:2] == bytes((160, 128))


# T-states: differences of `t` between cases that differ in nothing but the tube.


def test_a_character_takes_as_long_as_on_the_rom(tube: Tube) -> None:
    # layout-wrap-string-63, -64, -65: 980 each, with 68 of PRINT's loop and 29 of STRING$'s.
    assert tube.cost("A") == 980 - 68 - 29
    assert tube.cost("A" * 60) == 60 * (980 - 68 - 29)


def test_a_newline_on_a_line_that_ends_a_page_is_quicker(tube: Tube) -> None:
    # LIST at rows 3 and 1 took 27950 and 27005 T-states.
    tube.display.cursor = 64
    slow = tube.cost(13)
    assert slow - tube.cost(13) == 27950 - 27005


def test_scrolling_takes_as_long_as_on_the_rom() -> None:
    # memory-mem-program: PRINT MEM took 62491 in rows 11 to 13, and 120458 when all three lines
    # scrolled. It printed other numbers, which take some hundred T-states more or less.
    tube = Tube()
    tube.display.cursor = 11 * 64
    plain = tube.cost(13, 13, 13)
    tube.display.cursor = 15 * 64
    scrolled = tube.cost(13, 13, 13)
    assert scrolled - plain == pytest.approx(120458 - 62491, abs=400)


def test_the_echo_of_typing_is_cheaper_than_print(tube: Tube) -> None:
    before = tube.clock.now
    tube.display.echo(65)
    assert tube.clock.now - before == tube.cost("A") - 251


def test_the_front_end_hears_which_rows_changed(tube: Tube) -> None:
    assert tube.video.take_dirty() == list(range(ROWS))
    assert tube.video.take_dirty() == []
    tube.show("A")
    tube.display.cursor = 320
    tube.show("B")
    assert tube.video.take_dirty() == [0, 5]
    tube.video.switch(True)
    assert tube.video.take_dirty() == list(range(ROWS))


def test_a_listener_hears_codes_until_it_is_gone(tube: Tube) -> None:
    heard: list[tuple[int, bool]] = []
    tube.console.listeners.append(lambda code, echo: heard.append((code, echo)))
    tube.console.put(65)
    tube.console.echo(66)
    tube.console.show_cursor(True)
    tube.console.listeners.clear()
    tube.console.put(67)
    assert heard == [(65, False), (66, True)]


def test_a_pickled_console_forgets_its_listeners_and_keeps_its_picture(tube: Tube) -> None:
    tube.console.listeners.append(lambda code, echo: None)
    tube.show("HELLO", 23)
    copy = pickle.loads(pickle.dumps(tube))
    assert copy.video.take_dirty() == list(range(ROWS))
    assert copy.show("W") == ["HELLO W"]
    assert copy.memory.peek(15360) == 72
