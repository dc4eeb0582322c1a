"""How many T-states the ROM takes to find lines, take them out, put them in and link them.

What a typed line takes grows with the program: the search walks its links from the start (1B2CH),
taking a line out moves what is behind it down (2BE4H), putting one in moves it up (1955H), and then
all links from the place of the line on are made anew by looking for each line's zero (1AFCH). The
loops compare 16-bit numbers by their high bytes first, and take a little longer where these are
equal. Observed on the ROM between those addresses, to the T-state.
"""

from __future__ import annotations

from typing import Final

from trs80arm.basic.program import LINE_HEAD, Program

_LOW_BYTES_TOO: Final = 12
"""What a comparison takes more when the high bytes are equal."""
_PASSED: Final = 187
_FOUND, _LARGER, _NO_MORE = 200, 197, 61
"""A line passed in the search, and the three ways in which it ends."""
_TAKE_OUT: Final = 80
_BYTE_DOWN: Final = 88
_PUT_IN: Final = 437
_COPIED: Final = 42
_BYTE_UP: Final = 93
_LINK: Final = 111
_LOOKED_AT: Final = 25
_LINKED: Final = 39
_NUMBER_TEXT: Final = 2934
_LEADING_ZERO: Final = 182
_SUBTRACTION: Final = 40


def search(program: Program, number: int) -> int:
    """T-states to look for a line: it ends at the line, at a larger one, or at the end."""
    numbers = program.numbers()
    passed = program.place(number)
    alike = passed - min(passed, program.place(number & 0xFF00))
    total = _PASSED * passed + _LOW_BYTES_TOO * alike
    if passed == len(numbers):
        return total + _NO_MORE
    stop = numbers[passed]
    if stop == number:
        return total + _FOUND
    return total + _LARGER + _LOW_BYTES_TOO * (stop >> 8 == number >> 8)


def take_out(stop: int, end: int) -> int:
    """T-states to move the rest of a program down over lines that go.

    Args:
        stop: the first address behind the lines.
        end: the first address behind the program.
    """
    alike = min(end - stop, (end & 0xFF) + 1)
    return _TAKE_OUT + _BYTE_DOWN * (end - stop) + _LOW_BYTES_TOO * alike


def put_in(place: int, end: int, text: bytes) -> int:
    """T-states to move the rest of a program up and copy a line into the gap.

    Args:
        place: where the line is to stand.
        end: the first address behind the program.
        text: the crunched line.
    """
    return _PUT_IN + moved_up(place, end) + _COPIED * len(text)


def moved_up(place: int, end: int) -> int:
    """T-states to move the bytes from `place` to `end` up, from the last to the first (1955H)."""
    alike = min(end - place, 0xFF - (place & 0xFF))
    return _BYTE_UP * (end - place) + _LOW_BYTES_TOO * alike


def link(program: Program, number: int) -> int:
    """T-states to make the links anew, from the first line not before `number` to the end."""
    lines = len(program) - program.place(number)
    text = program.end - 2 - program.place_for(number) - (LINE_HEAD + 1) * lines
    return _LINKED + _LINK * lines + _LOOKED_AT * text


def number_text(number: int) -> int:
    """T-states to turn a line number into digits (0FAFH): powers of ten are taken off."""
    digits = f"{number}"
    return _NUMBER_TEXT - _LEADING_ZERO * (len(digits) - 1) + _SUBTRACTION * sum(map(int, digits))
