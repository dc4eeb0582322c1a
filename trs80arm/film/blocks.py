"""Characters that are drawn as shapes: blocks, sextants, and the dots of braille.

Few fonts have all of them, and where they do, lines of text leave gaps between them.
"""

from __future__ import annotations

from functools import lru_cache

from trs80arm.machine.video import sextant

Rectangle = tuple[float, float, float, float]
"""Left, top, width and height, as shares of a cell."""

_HALVES = {
    "▀": (0.0, 0.0, 1.0, 0.5),
    "▄": (0.0, 0.5, 1.0, 0.5),
    "█": (0.0, 0.0, 1.0, 1.0),
    "▌": (0.0, 0.0, 0.5, 1.0),
    "▐": (0.5, 0.0, 0.5, 1.0),
    "▁": (0.0, 7 / 8, 1.0, 1 / 8),
    "▆": (0.0, 2 / 8, 1.0, 6 / 8),
}
_SEXTANTS = {sextant(pattern): pattern for pattern in range(1, 63)}
_BRAILLE, _LAST_BRAILLE = 0x2800, 0x28FF
_DOT_PLACES = ((0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2), (0, 3), (1, 3))
"""Column and row of each dot of a braille cell, by its bit."""
_DOT = (0.2, 0.11)
"""Width and height of a dot."""


@lru_cache(1024)
def blocks_of(sign: str) -> tuple[Rectangle, ...]:
    """The rectangles that a character is; none for one that a font is to draw."""
    if sign in _HALVES:
        return (_HALVES[sign],)
    pattern = _SEXTANTS.get(sign)
    if pattern is not None:
        return tuple(
            (place % 2 / 2, place // 2 / 3, 0.5, 1 / 3)
            for place in range(6)
            if pattern >> place & 1
        )
    if _BRAILLE < ord(sign) <= _LAST_BRAILLE:
        width, height = _DOT
        return tuple(
            ((column + 0.5) / 2 - width / 2, (row + 0.5) / 4 - height / 2, width, height)
            for bit, (column, row) in enumerate(_DOT_PLACES)
            if ord(sign) - _BRAILLE >> bit & 1
        )
    return ()
