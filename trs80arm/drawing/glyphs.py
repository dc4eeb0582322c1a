"""What a code of the video memory looks like in a terminal: text, arrows, 2x3 graphics blocks.

The machine's graphics codes 128 to 191 hold the six blocks in bits 0 to 5, top left to bottom
right, which is Unicode's own order of sextants. Four sets of glyphs draw them; no terminal can be
asked which it has, so the user chooses.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass

from trs80arm.machine.video import FIRST_GRAPHIC, glyph, sextant
from trs80arm.options import GlyphSet

PATTERNS = 64
_ASCII_ARROWS = {0x5B: "^", 0x5C: "v", 0x5D: "<", 0x5E: ">"}
"""Small letters do not occur on the tube, so the small v can only be the arrow."""


def braille(pattern: int) -> str:
    """The same as six of the eight dots of a braille cell, which are numbered by columns."""
    dots = (0, 3, 1, 4, 2, 5)
    return chr(0x2800 + sum(1 << dot for bit, dot in enumerate(dots) if pattern >> bit & 1))


def quadrant(pattern: int) -> str:
    """The same in two rows: the middle third lights the half that it has more company in."""
    # fmt: off
    shapes = " ▘▝▀▖▌▞▛▗▚▐▜▄▙▟█"
    # fmt: on
    lit = 0
    for column in (0, 1):
        top, middle, bottom = (pattern >> (2 * row + column) & 1 for row in range(3))
        if top or (middle and not bottom):
            lit |= 1 << column
        if bottom:
            lit |= 4 << column
    return shapes[lit]


def ascii_block(pattern: int) -> str:
    """The same by how much of the cell is lit, and where."""
    count = pattern.bit_count()
    if count == 0:
        return " "
    if count >= 5:
        return "#"
    if pattern in (0b000011, 0b000001, 0b000010):
        return "'"
    if pattern in (0b001100, 0b001111, 0b111100):
        return "-" if count == 2 else "="
    if pattern in (0b110000, 0b010000, 0b100000):
        return "_" if count == 2 else "."
    if pattern in (21, 42):
        return "|"
    return ":" if count <= 3 else "%"


_DRAWN = {
    GlyphSet.SEXTANT: sextant,
    GlyphSet.BRAILLE: braille,
    GlyphSet.QUADRANT: quadrant,
    GlyphSet.ASCII: ascii_block,
}


def _halves(pattern: int) -> tuple[int, int]:
    """The two patterns of twice the width: each column of blocks fills a cell."""
    left, right = pattern & 0b010101, pattern & 0b101010
    return left | left << 1, right | right >> 1


@dataclass(frozen=True)
class Glyphs:
    """The glyphs of one set, as tables for `str.translate`: for 64 and for 32 columns."""

    narrow: Mapping[int, str]
    wide: Mapping[int, str]

    def row(self, codes: bytes, *, wide: bool) -> str:
        """The text of a row of the tube: 64 cells wide, from its 64 codes.

        In 32-column mode the tube shows every other code, each two cells wide.
        """
        if wide:
            return codes[::2].decode("latin-1").translate(self.wide)
        return codes.decode("latin-1").translate(self.narrow)


def _tables(chosen: GlyphSet) -> Glyphs:
    draw = _DRAWN[chosen]
    signs = {code: glyph(code) for code in range(0x20, FIRST_GRAPHIC)}
    if chosen is GlyphSet.ASCII:
        signs |= _ASCII_ARROWS
    narrow, wide = dict(signs), {code: sign + " " for code, sign in signs.items()}
    for pattern in range(PATTERNS):
        narrow[FIRST_GRAPHIC + pattern] = draw(pattern)
        left, right = _halves(pattern)
        wide[FIRST_GRAPHIC + pattern] = draw(left) + draw(right)
    return Glyphs(narrow, wide)


GLYPHS: dict[GlyphSet, Glyphs] = {chosen: _tables(chosen) for chosen in _DRAWN}
"""The tables of every set; AUTO is resolved by `choose`."""


def choose(wanted: GlyphSet, environment: Mapping[str, str] = os.environ) -> GlyphSet:
    """The set to draw with: the one wanted, or by hints the one most likely to be there.

    Args:
        wanted: the user's choice, AUTO for none.
        environment: the variables that terminals and locales set.
    """
    if wanted is not GlyphSet.AUTO:
        return wanted
    locale = next(
        (environment[name] for name in ("LC_ALL", "LC_CTYPE", "LANG") if environment.get(name)), ""
    )
    if locale in ("C", "POSIX") or (locale and "utf" not in locale.lower()):
        return GlyphSet.ASCII
    if environment.get("TERM") == "linux":
        return GlyphSet.ASCII
    if environment.get("TERM_PROGRAM") == "Apple_Terminal":
        return GlyphSet.QUADRANT
    # In a browser: its fonts seldom have sextants.
    if environment.get("TEXTUAL_DRIVER"):
        return GlyphSet.BRAILLE
    return GlyphSet.SEXTANT
