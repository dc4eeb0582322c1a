"""Single precision: the 24-bit floating point in which Level II computes by default.

A single is a Python float that is zero or lies between 2^-128 and 2^127 and has at most 24
significant bits. `add`, `sub`, `mul` and `div` are the hot path of the compiled program: they work
in Python floats and fall back on `registers` only where the two could differ (verified on the ROM:
Level II facts, Rounding of + - * /; peers 1.4).
"""

from __future__ import annotations

import math

from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.numbers import registers
from trs80arm.basic.numbers.registers import Register

BITS = 24
LARGEST = 2.0**127 - 2.0**103
"""1.70141E+38."""
SMALLEST = 2.0**-128
"""2.93874E-39; a smaller result is zero."""

AWAY = 1.0 + 2.0**-52
"""A factor that turns a tie of 24 bits into something just above it."""
SPLIT = 2.0**29 + 1.0
"""Veltkamp's constant: `c = x * SPLIT; c - (c - x)` is `x` rounded to 24 bits."""

_NEARLY = 1.0 + 2.0**-30
"""A factor that moves a value by at least 1/128 of its 24th bit."""
_LOW = 2.0**-125
_HIGH = 2.0**125
"""Between these magnitudes no operation can overflow or underflow, not even by exponents alone."""


def to_register(x: float) -> Register:
    """The stored exponent and signed 24-bit mantissa of a single."""
    if not x:
        return registers.ZERO
    fraction, exponent = math.frexp(x)
    return exponent + 128, int(fraction * 16777216.0)


def from_register(register: Register) -> float:
    """The single of a stored exponent and signed 24-bit mantissa."""
    return math.ldexp(register[1], register[0] - 128 - BITS)


def round_away(x: float) -> float:
    """A Python float rounded to 24 bits, half away from zero; OV; zero when too small."""
    x *= AWAY
    c = x * SPLIT
    r = c - (c - x)
    if -LARGEST <= r <= LARGEST:
        return r if r >= SMALLEST or r <= -SMALLEST else 0.0
    raise BasicError(Code.OV)


def add(a: float, b: float) -> float:
    """The sum as the ROM rounds it; OV.

    Operands of unlike signs whose exponents are more than 8 apart lose bits below the guard byte,
    which raises the magnitude by up to 1/128 of the last place: where that much could change the
    rounding, and near the ends of the range, the registers decide.
    """
    s = a + b
    x = s * AWAY
    c = x * SPLIT
    r = c - (c - x)
    if _LOW < r < _HIGH or -_HIGH < r < -_LOW:
        if r == s:
            return r
        ratio = a / b
        if ratio > 0.0 or -256.0 <= ratio <= -0.00390625:
            return r
        if -16777216.0 <= ratio <= -5.9604644775390625e-08:
            x = s * _NEARLY
            c = x * SPLIT
            if c - (c - x) == r:
                return r
    elif not s:
        return 0.0
    return from_register(registers.add(to_register(a), to_register(b), BITS))


def sub(a: float, b: float) -> float:
    """The difference as the ROM rounds it; OV. The ROM adds the negated second operand."""
    s = a - b
    x = s * AWAY
    c = x * SPLIT
    r = c - (c - x)
    if _LOW < r < _HIGH or -_HIGH < r < -_LOW:
        if r == s:
            return r
        ratio = a / b
        if ratio < 0.0 or 0.00390625 <= ratio <= 256.0:
            return r
        if 5.9604644775390625e-08 <= ratio <= 16777216.0:
            x = s * _NEARLY
            c = x * SPLIT
            if c - (c - x) == r:
                return r
    elif not s:
        return 0.0
    return from_register(registers.add(to_register(a), to_register(-b), BITS))


def mul(a: float, b: float) -> float:
    """The product as the ROM rounds it; OV, also for some products just below 2^127."""
    x = a * b * AWAY
    if _LOW < x < _HIGH or -_HIGH < x < -_LOW:
        c = x * SPLIT
        return c - (c - x)
    if not x:
        return 0.0
    return from_register(registers.multiply(to_register(a), to_register(b), BITS))


def div(a: float, b: float) -> float:
    """The quotient as the ROM rounds it; division by zero, OV."""
    if b:
        x = a / b * AWAY
        if _LOW < x < _HIGH or -_HIGH < x < -_LOW:
            c = x * SPLIT
            return c - (c - x)
    return from_register(registers.divide(to_register(a), to_register(b), BITS))


def times_ten(x: float) -> float:
    """Ten times a single by the ROM's short way, for reading and printing; OV."""
    return from_register(registers.times_ten(to_register(x), BITS))


def negate(x: float) -> float:
    """The single with the other sign; zero has none."""
    return -x if x else 0.0


def floor(x: float) -> float:
    """The largest whole single that is not above `x` (INT)."""
    return float(math.floor(x))


def pack(x: float) -> bytes:
    """The four bytes in memory: mantissa low byte first, sign above its top bit, exponent."""
    exponent, mantissa = to_register(x)
    if not exponent:
        return bytes(4)
    sign = 0x800000 if mantissa < 0 else 0
    return ((abs(mantissa) & 0x7FFFFF) | sign).to_bytes(3, "little") + bytes([exponent])


def unpack(data: bytes) -> float:
    """The single of four bytes in memory; exponent 0 is zero whatever the others hold."""
    exponent = data[3]
    if not exponent:
        return 0.0
    word = int.from_bytes(data[:3], "little")
    value = math.ldexp(word | 0x800000, exponent - 128 - BITS)
    return -value if word & 0x800000 else value
