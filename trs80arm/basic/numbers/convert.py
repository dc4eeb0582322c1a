"""Between the types: conversions, and arithmetic on operands whose types show only at run time.

The wider type wins: integer, single, double (Level II facts, Rounding of + - * /). The compiler
calls the typed modules directly where it knows the types, and these functions where it does not. A
string where a number is needed is a type mismatch.
"""

from __future__ import annotations

from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.kinds import DOUBLE, INTEGER, Kind
from trs80arm.basic.numbers import double, integer, single
from trs80arm.basic.numbers.double import Double

Number = int | float | Double
"""An integer, a single or a double of the machine."""


def to_integer(value: object) -> int:
    """CINT: the number rounded down; OV outside -32768 to 32767, TM for a string."""
    if isinstance(value, (int, float, Double)):
        return integer.floor_to_integer(value)
    raise BasicError(Code.TM)


def to_single(value: object) -> float:
    """CSNG: the number as a single, a double rounded half away; OV, TM for a string."""
    if isinstance(value, float):
        return value
    if isinstance(value, int):
        return float(value)
    if isinstance(value, Double):
        return double.to_single(value)
    raise BasicError(Code.TM)


def to_double(value: object) -> Double:
    """CDBL: the number as a double of the same value; TM for a string."""
    if isinstance(value, Double):
        return value
    if isinstance(value, float):
        return double.from_single(value)
    if isinstance(value, int):
        return double.from_int(value)
    raise BasicError(Code.TM)


def to_kind(kind: Kind, value: object) -> Number:
    """The number as a variable of a kind takes it; OV, TM for a string."""
    if kind == INTEGER:
        return to_integer(value)
    return to_double(value) if kind == DOUBLE else to_single(value)


def add(a: Number, b: Number) -> Number:
    """The sum in the wider type of the two; OV, TM."""
    if type(a) is float and type(b) is float:
        return single.add(a, b)
    if type(a) is int and type(b) is int:
        return integer.add(a, b)
    if type(a) is Double or type(b) is Double:
        return double.add(to_double(a), to_double(b))
    return single.add(to_single(a), to_single(b))


def sub(a: Number, b: Number) -> Number:
    """The difference in the wider type of the two; OV, TM."""
    if type(a) is float and type(b) is float:
        return single.sub(a, b)
    if type(a) is int and type(b) is int:
        return integer.sub(a, b)
    if type(a) is Double or type(b) is Double:
        return double.sub(to_double(a), to_double(b))
    return single.sub(to_single(a), to_single(b))


def mul(a: Number, b: Number) -> Number:
    """The product in the wider type of the two; OV, TM."""
    if type(a) is float and type(b) is float:
        return single.mul(a, b)
    if type(a) is int and type(b) is int:
        return integer.mul(a, b)
    if type(a) is Double or type(b) is Double:
        return double.mul(to_double(a), to_double(b))
    return single.mul(to_single(a), to_single(b))


def div(a: Number, b: Number) -> Number:
    """The quotient, never an integer; division by zero, OV, TM."""
    if type(a) is Double or type(b) is Double:
        return double.div(to_double(a), to_double(b))
    return single.div(to_single(a), to_single(b))


def compare(a: Number, b: Number) -> int:
    """-1, 0 or 1 as `a` is less than, equal to or greater than `b`; TM."""
    if isinstance(a, Double) or isinstance(b, Double):
        return double.compare(to_double(a), to_double(b))
    if isinstance(a, str) or isinstance(b, str):
        raise BasicError(Code.TM)
    return (a > b) - (a < b)


def negate(a: Number) -> Number:
    """The number with the other sign; the integer -32768 gives the single 32768; TM."""
    if isinstance(a, float):
        return single.negate(a)
    if isinstance(a, int):
        return integer.negate(a)
    if isinstance(a, Double):
        return double.negate(a)
    raise BasicError(Code.TM)


def sign(a: Number) -> int:
    """SGN: -1, 0 or 1, always an integer; TM."""
    if isinstance(a, (int, float)):
        return (a > 0) - (a < 0)
    if isinstance(a, Double):
        return (a.mantissa > 0) - (a.mantissa < 0)
    raise BasicError(Code.TM)


def absolute(a: Number) -> Number:
    """ABS: the magnitude in the same type, but ABS of the integer -32768 is a single; TM."""
    return negate(a) if sign(a) < 0 else a


def int_(a: Number) -> Number:
    """INT: the largest whole number that is not above `a`; TM.

    It keeps the type, but a double below 32768 in magnitude, and -32768 itself, goes the way of
    CINT and is an integer (asked of the ROM: `INT(1#)/3` prints .333333, `INT(40000#)/3` prints
    sixteen digits, `INT(28.9999999#)` is 29 and `INT(32767.9999999#)` ?OV).
    """
    if isinstance(a, float):
        return single.floor(a)
    if isinstance(a, int):
        return a
    if isinstance(a, Double):
        return integer.floor_to_integer(a) if double.is_small(a) else double.floor(a)
    raise BasicError(Code.TM)


def fix(a: Number) -> Number:
    """FIX: the number without its fraction, its type as with INT; TM."""
    return negate(int_(negate(a))) if sign(a) < 0 and not isinstance(a, int) else int_(a)
