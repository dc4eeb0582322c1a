"""Codes of the video memory as characters of the terminal."""

from __future__ import annotations

import unicodedata

import pytest
from rich.cells import cell_len

from trs80arm.drawing.glyphs import GLYPHS, braille, choose
from trs80arm.machine.video import sextant
from trs80arm.options import GlyphSet

PATTERNS = range(64)
SETS = list(GLYPHS)


def test_every_sextant_is_named_after_its_blocks() -> None:
    for pattern in PATTERNS:
        name = unicodedata.name(sextant(pattern))
        if name.startswith("BLOCK SEXTANT-"):
            blocks = {int(digit) for digit in name.removeprefix("BLOCK SEXTANT-")}
            assert blocks == {bit + 1 for bit in range(6) if pattern >> bit & 1}
    assert [sextant(pattern) for pattern in (0, 21, 42, 63)] == [" ", "▌", "▐", "█"]


def test_every_braille_cell_is_named_after_its_dots() -> None:
    dot_of_bit = {0: "1", 1: "4", 2: "2", 3: "5", 4: "3", 5: "6"}
    for pattern in range(1, 64):
        dots = unicodedata.name(braille(pattern)).removeprefix("BRAILLE PATTERN DOTS-")
        assert set(dots) == {dot_of_bit[bit] for bit in range(6) if pattern >> bit & 1}


@pytest.mark.parametrize("chosen", [GlyphSet.SEXTANT, GlyphSet.BRAILLE])
def test_two_sets_lose_nothing(chosen: GlyphSet) -> None:
    drawn = {GLYPHS[chosen].narrow[128 + pattern] for pattern in PATTERNS}
    assert len(drawn) == 64


@pytest.mark.parametrize("chosen", SETS)
@pytest.mark.parametrize("wide", [False, True])
def test_a_row_is_64_cells_wide(chosen: GlyphSet, wide: bool) -> None:
    for start in (0x20, 0x80):
        codes = bytes(range(start, start + 64))
        text = GLYPHS[chosen].row(codes, wide=wide)
        assert cell_len(text) == 64
        assert chosen is not GlyphSet.ASCII or text.isascii()


def test_32_columns_show_every_other_code_twice_as_wide() -> None:
    codes = b"A" + b"?" + b"B" + b"?" + bytes((0x81, 0x20)) + b" " * 58
    text = GLYPHS[GlyphSet.SEXTANT].row(codes, wide=True)
    assert text.startswith("A B ")
    assert text[4:6] == sextant(0b11) + " "


def test_the_arrow_signs_are_those_of_the_character_generator() -> None:
    assert GLYPHS[GlyphSet.SEXTANT].row(b"[\\]^" + b" " * 60, wide=False)[:4] == "↑↓←→"


@pytest.mark.parametrize(
    ("environment", "chosen"),
    [
        ({"LANG": "en_US.UTF-8"}, GlyphSet.SEXTANT),
        ({"LANG": "C"}, GlyphSet.ASCII),
        ({"LANG": "en_US.UTF-8", "TERM": "linux"}, GlyphSet.ASCII),
        ({"LANG": "en_US.UTF-8", "TERM_PROGRAM": "Apple_Terminal"}, GlyphSet.QUADRANT),
        ({"LANG": "en_US.UTF-8", "TEXTUAL_DRIVER": "web"}, GlyphSet.BRAILLE),
        ({}, GlyphSet.SEXTANT),
    ],
)
def test_hints_choose_a_set_that_is_likely_there(
    environment: dict[str, str], chosen: GlyphSet
) -> None:
    assert choose(GlyphSet.AUTO, environment) is chosen
    assert choose(GlyphSet.BRAILLE, environment) is GlyphSet.BRAILLE
