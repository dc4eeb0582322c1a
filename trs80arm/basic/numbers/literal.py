"""The ROM's one scanner of numbers: constants of a program, VAL, READ and INPUT all go through it.

It collects digits in the narrowest type that holds them and then multiplies or divides by ten once
for every place, rounding each time, so a literal is not always the nearest number (Level II facts,
Literals; verified there on 30,000 literals).
"""

from __future__ import annotations

from typing import NamedTuple

from trs80arm.basic import characters
from trs80arm.basic.characters import BLANKS
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.numbers import convert, double, single
from trs80arm.basic.numbers.convert import Number
from trs80arm.basic.numbers.double import Double

_PLUS = frozenset(b"+\xcd")
"""Plus as typed and as its token 205; behind an E a crunched line has the token."""
_MINUS = frozenset(b"-\xce")
"""Minus as typed and as its token 206."""
_E, _D = ord("E"), ord("D")
TYPE_SIGNS = frozenset((characters.NUMBER_SIGN, characters.EXCLAMATION, characters.PERCENT))
"""Behind a number they say its type."""
_MANY = 50
"""The exponent that stands for every exponent of three digits and more."""
_TEN = double.from_int(10)


class Meter:
    """Hears each step of a scan; this one does nothing with it."""

    def character(self) -> None:
        """A character was taken."""

    def integer_digit(self) -> None:
        """A digit came to an integer."""

    def digit(self, value: float | Double, digit: int) -> None:
        """A digit comes to a number in floating point."""

    def became_double(self) -> None:
        """A single has had as many digits as it holds."""

    def exponent(self) -> None:
        """An exponent begins."""

    def ten_up(self, value: float | Double) -> None:
        """A number is multiplied by ten."""

    def ten_down(self, value: float | Double) -> None:
        """A number is divided by ten."""


_UNMETERED = Meter()


class Scanned(NamedTuple):
    """A number and the place behind it."""

    value: Number
    end: int


def scan(text: bytes, position: int = 0, start: Number = 0, meter: Meter = _UNMETERED) -> Scanned:
    """Read the number at `position`; text that is no number is the integer 0.

    Blanks (also tabs and line feeds) are skipped everywhere, in the number and behind it.

    Args:
        text: typed text or a crunched line; its end counts as the end of the number.
        position: where to begin; an ASCII sign may stand there.
        start: the zero to begin with, which is the narrowest type of the result: VAL, and READ and
            INPUT into a double, begin with a double zero, so their `.1` is .1 to 16 digits.
        meter: hears what is done.

    Returns:
        The value and the index of the first character that does not belong to it.

    Raises:
        BasicError: OV for a number too large; SN for `%` behind anything but an integer.
    """
    size = len(text)

    def at(place: int) -> tuple[int, int]:
        """The next place from `place` on that is no blank, and what stands there (0 at the end)."""
        while place < size and text[place] in BLANKS:
            place += 1
        return place, text[place] if place < size else 0

    def behind(place: int) -> tuple[int, int]:
        """The same behind a character that is taken."""
        meter.character()
        return at(place + 1)

    position, code = at(position)
    negative = code == characters.MINUS
    if negative or code == characters.PLUS:
        position, code = behind(position)
    value = start
    decimals = 0
    point = False
    exponent = 0
    while True:
        if characters.ZERO <= code <= characters.NINE:
            value = _with_digit(value, code - characters.ZERO, meter)
            decimals += point
        elif code == characters.POINT and not point:
            point = True
            if type(value) is int:
                value = float(value)
        else:
            break
        position, code = behind(position)
    if code in (_E, _D):
        value = convert.to_single(value) if code == _E else convert.to_double(value)
        meter.exponent()
        position, code = behind(position)
        below = code in _MINUS
        if below or code in _PLUS:
            position, code = behind(position)
        while characters.ZERO <= code <= characters.NINE:
            digit = code - characters.ZERO
            exponent = exponent * 10 + digit if exponent < 10 else _MANY
            position, code = behind(position)
        if below:
            exponent = -exponent
    elif code in TYPE_SIGNS:
        meter.character()
        position += 1
        value = _with_type(value, code)
    value = _scaled(value, exponent - decimals, meter)
    return Scanned(convert.negate(value) if negative else value, position)


def _with_type(value: Number, sign: int) -> Number:
    """The value in the type that a sign behind it says; SN for `%` behind more than an integer."""
    if sign == characters.NUMBER_SIGN:
        return convert.to_double(value)
    if sign == characters.EXCLAMATION:
        return convert.to_single(value)
    if type(value) is not int:
        raise BasicError(Code.SN)
    return value


def _with_digit(value: Number, digit: int, meter: Meter) -> Number:
    """Ten times the value plus a digit, in the type that the ROM has reached by then."""
    if isinstance(value, int):
        number = value * 10 + digit
        if number < 32768:
            meter.integer_digit()
            return number
        meter.digit(float(value), digit)
        return float(number)
    if isinstance(value, float):
        if value < 1000000.0:
            meter.digit(value, digit)
            return value * 10.0 + digit
        value = double.from_single(value)
        meter.became_double()
    meter.digit(value, digit)
    return double.add(double.times_ten(value), double.from_int(digit))


def _scaled(value: Number, places: int, meter: Meter) -> Number:
    """The value times ten to the power of `places`, one rounded step for each place."""
    if isinstance(value, Double):
        for _ in range(places):
            meter.ten_up(value)
            value = double.times_ten(value)
        for _ in range(-places):
            meter.ten_down(value)
            value = double.div(value, _TEN)
    elif places:
        value = float(value)
        for _ in range(places):
            meter.ten_up(value)
            value = single.times_ten(value)
        for _ in range(-places):
            meter.ten_down(value)
            value = single.div(value, 10.0)
    return value
