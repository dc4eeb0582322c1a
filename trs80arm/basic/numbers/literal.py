"""The ROM's one scanner of numbers: constants of a program, VAL, READ and INPUT all go through it.

It collects digits in the narrowest type that holds them and then multiplies or divides by ten once
for every place, rounding each time, so a literal is not always the nearest number (Level II facts,
Literals; verified there on 30,000 literals).
"""

from __future__ import annotations

from typing import NamedTuple

from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.numbers import convert, double, single
from trs80arm.basic.numbers.convert import Number
from trs80arm.basic.numbers.double import Double

_BLANKS = frozenset(b" \t\n")
_PLUS = frozenset(b"+\xcd")
"""Plus as typed and as its token 205; behind an E a crunched line has the token."""
_MINUS = frozenset(b"-\xce")
"""Minus as typed and as its token 206."""
_MANY = 50
"""The exponent that stands for every exponent of three digits and more."""
_TEN = double.from_int(10)


class Scanned(NamedTuple):
    """A number and the place behind it."""

    value: Number
    end: int


def scan(text: bytes, position: int = 0, start: Number = 0) -> Scanned:
    """Read the number at `position`; text that is no number is the integer 0.

    Blanks (also tabs and line feeds) are skipped everywhere, in the number and behind it.

    Args:
        text: typed text or a crunched line; its end counts as the end of the number.
        position: where to begin; an ASCII sign may stand there.
        start: the zero to begin with, which is the narrowest type of the result: VAL, and READ and
            INPUT into a double, begin with a double zero, so their `.1` is .1 to 16 digits.

    Returns:
        The value and the index of the first character that does not belong to it.

    Raises:
        BasicError: OV for a number too large; SN for `%` behind anything but an integer.
    """
    size = len(text)

    def at(place: int) -> tuple[int, int]:
        """The next place from `place` on that is no blank, and what stands there (0 at the end)."""
        while place < size and text[place] in _BLANKS:
            place += 1
        return place, text[place] if place < size else 0

    position, code = at(position)
    negative = code == 0x2D
    if negative or code == 0x2B:
        position, code = at(position + 1)
    value = start
    decimals = 0
    point = False
    exponent = 0
    while True:
        if 0x30 <= code <= 0x39:
            value = _with_digit(value, code - 0x30)
            decimals += point
        elif code == 0x2E and not point:
            point = True
            if type(value) is int:
                value = float(value)
        else:
            break
        position, code = at(position + 1)
    if code in b"ED" and code:
        value = convert.to_single(value) if code == 0x45 else convert.to_double(value)
        position, code = at(position + 1)
        below = code in _MINUS
        if below or code in _PLUS:
            position, code = at(position + 1)
        while 0x30 <= code <= 0x39:
            exponent = exponent * 10 + code - 0x30 if exponent < 10 else _MANY
            position, code = at(position + 1)
        if below:
            exponent = -exponent
    elif code == 0x25:
        if type(value) is not int:
            raise BasicError(Code.SN)
        position += 1
    elif code == 0x23:
        value = convert.to_double(value)
        position += 1
    elif code == 0x21:
        value = convert.to_single(value)
        position += 1
    value = _scaled(value, exponent - decimals)
    return Scanned(convert.negate(value) if negative else value, position)


def _with_digit(value: Number, digit: int) -> Number:
    """Ten times the value plus a digit, in the type that the ROM has reached by then."""
    if isinstance(value, int):
        number = value * 10 + digit
        return number if number < 32768 else float(number)
    if isinstance(value, float):
        if value < 1000000.0:
            return value * 10.0 + digit
        value = double.from_single(value)
    return double.add(double.times_ten(value), double.from_int(digit))


def _scaled(value: Number, places: int) -> Number:
    """The value times ten to the power of `places`, one rounded step for each place."""
    if isinstance(value, Double):
        for _ in range(places):
            value = double.times_ten(value)
        for _ in range(-places):
            value = double.div(value, _TEN)
    elif places:
        value = float(value)
        for _ in range(places):
            value = single.times_ten(value)
        for _ in range(-places):
            value = single.div(value, 10.0)
    return value
