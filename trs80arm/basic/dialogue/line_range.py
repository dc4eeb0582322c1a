"""Line numbers and ranges as LIST, DELETE, EDIT and AUTO read them behind their word.

`.` is the line listed, entered, edited or in error last; `-` is a token in crunched text.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from trs80arm.basic import cruncher, tokens
from trs80arm.basic.characters import BLANKS, COLON, END, POINT
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.state import State

BEYOND: Final = 0xFFFA
"""The end of a range that has none: larger than any line number."""


@dataclass(frozen=True)
class LineRange:
    """The lines from `first` to `last`, both included."""

    first: int
    last: int


def skip_blanks(text: bytes, position: int) -> int:
    """The first place from `position` on that is no blank."""
    while position < len(text) and text[position] in BLANKS:
        position += 1
    return position


def at_end(text: bytes, position: int) -> bool:
    """Whether a statement ends at `position`."""
    return position >= len(text) or text[position] in (END, COLON)


def line_or_dot(state: State, text: bytes, position: int) -> tuple[int, int]:
    """A line number or `.`; 0 where there is neither.

    Returns:
        The number and the place of the next character that is no blank.

    Raises:
        BasicError: SN for a number above 65529.
    """
    position = skip_blanks(text, position)
    if position < len(text) and text[position] == POINT:
        return state.control.dot, skip_blanks(text, position + 1)
    number, end = cruncher.line_number(text, position)
    return number or 0, skip_blanks(text, end)


def parse(state: State, text: bytes) -> LineRange:
    """The range behind LIST or DELETE: nothing, `n`, `n-`, `-m` or `n-m`.

    Raises:
        BasicError: SN for anything else.
    """
    position = skip_blanks(text, 0)
    if at_end(text, position):
        return LineRange(0, BEYOND)
    first, position = line_or_dot(state, text, position)
    if at_end(text, position):
        return LineRange(first, first)
    if text[position] != tokens.MINUS:
        raise BasicError(Code.SN)
    position = skip_blanks(text, position + 1)
    if at_end(text, position):
        return LineRange(first, BEYOND)
    last, position = line_or_dot(state, text, position)
    if not at_end(text, position):
        raise BasicError(Code.SN)
    return LineRange(first, last)
