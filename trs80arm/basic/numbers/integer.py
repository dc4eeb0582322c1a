"""Integers of 16 bits: `A%`, whole-number literals up to 32767, and everything that is an address.

An integer operation that leaves the range gives a single without an error; a conversion that leaves
it is an overflow (Level II facts, things 3 and Rounding).
"""

from __future__ import annotations

import math

from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.numbers import double, single
from trs80arm.basic.numbers.double import Double


def add(a: int, b: int) -> int | float:
    """The sum, an integer if it fits, else a single."""
    r = a + b
    return r if -32769 < r < 32768 else float(r)


def sub(a: int, b: int) -> int | float:
    """The difference, an integer if it fits, else a single."""
    r = a - b
    return r if -32769 < r < 32768 else float(r)


def mul(a: int, b: int) -> int | float:
    """The product, an integer if it fits, else a single."""
    r = a * b
    return r if -32769 < r < 32768 else single.mul(float(a), float(b))


def step(value: int, by: int) -> int:
    """The next value of a loop's variable; OV outside the range."""
    value += by
    if not -32769 < value < 32768:
        raise BasicError(Code.OV)
    return value


def negate(a: int) -> int | float:
    """The integer with the other sign; -32768 gives the single 32768."""
    return -a if a != -32768 else 32768.0


def floor_to_integer(value: int | float | Double) -> int:
    """A number rounded down to an integer, as CINT, AND, PEEK, subscripts and so on do.

    A double becomes a single first, rounded half away: CINT(28.9999999#) is 29.

    Raises:
        BasicError: OV unless -32768 <= value < 32768; -32768.4 is out (facts, thing 3).
    """
    if type(value) is int:
        return value
    number = math.floor(double.to_single(value) if isinstance(value, Double) else value)
    if -32769 < number < 32768:
        return number
    raise BasicError(Code.OV)
