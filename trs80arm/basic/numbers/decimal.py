"""How the machine writes numbers: six digits for a single, sixteen for a double.

The ROM scales a number into the range of its digits by repeated steps of ten, each rounded, then
adds a half and cuts (Level II facts, Printing; verified there on 50,000 values). PRINT, LPRINT,
STR$ and PRINT# call `number_text`; PRINT USING starts from `scaled`.
"""

from __future__ import annotations

from typing import NamedTuple

from trs80arm.basic.numbers import double, single
from trs80arm.basic.numbers.convert import Number
from trs80arm.basic.numbers.double import Double

SINGLE_DIGITS = 6
DOUBLE_DIGITS = 16

TEN = double.from_int(10)
TEN_TO_TENTH = double.from_int(10**10)
_HALF = Double(128, 1 << 55)
FEW = double.from_int(65536)
ABOVE = double.unpack(bytes.fromhex("feff03bfc91b0eb6"))
"""9999999999999999.5: from here on the number is divided by ten."""
BELOW = double.unpack(bytes.fromhex("fdff9f31a95f63b2"))
"""999999999999999.95 to 56 bits: below it the number is multiplied by ten."""


class Scaled(NamedTuple):
    """A magnitude brought to six or sixteen digits before the point.

    Attributes:
        value: the magnitude times `10**places`, not yet rounded to a whole number.
        places: how many places the point was moved to the right.
    """

    value: float | Double
    places: int


def scaled(magnitude: float | Double) -> Scaled:
    """Bring a positive number to 6 (single) or 16 (double) digits before the point."""
    places = 0
    if isinstance(magnitude, float):
        x = magnitude
        while x >= 999999.5:
            x = single.div(x, 10.0)
            places -= 1
        while x <= 99999.9375:
            x = single.mul(x, 10.0)
            places += 1
        return Scaled(x, places)
    y = magnitude
    while double.compare(y, FEW) < 0:
        y = double.mul(y, TEN_TO_TENTH)
        places += 10
    while double.compare(y, ABOVE) >= 0:
        y = double.div(y, TEN)
        places -= 1
    while double.compare(y, BELOW) < 0:
        y = double.times_ten(y)
        places += 1
    return Scaled(y, places)


def tenth(x: float | Double) -> float | Double:
    """A tenth of a scaled number, rounded as the machine rounds."""
    return single.div(x, 10.0) if isinstance(x, float) else double.div(x, TEN)


def cut(x: float | Double) -> int:
    """A scaled number with a half added and the fraction cut off."""
    if isinstance(x, float):
        return int(single.add(x, 0.5))
    return double.floored(double.add(x, _HALF))


def digits(number: int, count: int) -> str:
    """A whole number in exactly `count` digits.

    A number that rounding brought up to `10**count` begins with the character behind the nine, a
    colon (case `numfmt-colon-digit`).
    """
    first, rest = divmod(number, 10 ** (count - 1))
    return chr(0x30 + first) + (f"{rest:0{count - 1}d}" if count > 1 else "")


def number_text(value: Number) -> str:
    """A number as PRINT writes it, with a blank or `-` in front and nothing behind."""
    if isinstance(value, int):
        return f" {value}" if value >= 0 else str(value)
    if isinstance(value, float):
        if -1000000.0 < value < 1000000.0 and value == int(value):
            return f" {int(value)}" if value >= 0.0 else str(int(value))
        negative = value < 0.0
        magnitude: float | Double = -value if negative else value
        count, letter = SINGLE_DIGITS, "E"
    else:
        if not value.exponent:
            return " 0"
        negative = value.mantissa < 0
        magnitude = double.negate(value) if negative else value
        count, letter = DOUBLE_DIGITS, "D"
    x, places = scaled(magnitude)
    figures = digits(cut(x), count)
    point = count - places
    sign = "-" if negative else " "
    if -1 <= point <= count:
        if point < 0:
            return f"{sign}.0{figures.rstrip('0')}"
        whole, fraction = figures[:point], figures[point:].rstrip("0")
        return f"{sign}{whole}.{fraction}" if fraction else sign + whole
    fraction = figures[1:].rstrip("0")
    mantissa = f"{figures[0]}.{fraction}" if fraction else figures[0]
    exponent = point - 1
    return f"{sign}{mantissa}{letter}{'-' if exponent < 0 else '+'}{abs(exponent):02d}"
