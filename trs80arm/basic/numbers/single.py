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

# The constants below stand in the functions as constant expressions, which the compiler folds; a
# global name would cost a tenth of the time of an addition.
#
# 1 + 2^-52: a factor that turns a tie of 24 bits into something just above it.
# 2^29 + 1: Veltkamp's constant; with c = x * (2^29 + 1), c - (c - x) is x rounded to 24 bits.
# 2^-125 to 2^125: magnitudes between which no operation can overflow or underflow, not even by the
# exponents alone.


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
    x *= 1.0 + 2.0**-52
    c = x * (2.0**29 + 1.0)
    r = c - (c - x)
    if -LARGEST <= r <= LARGEST:
        return r if r >= SMALLEST or r <= -SMALLEST else 0.0
    raise BasicError(Code.OV)


def add(a: float, b: float) -> float:
    """The sum as the ROM rounds it; OV.

    For generated code, the common case without the call (`s` and `c` are locals; a quarter of the
    time less)::

        s if (c := (s := A + B) * 536870913.0) - (c - s) == s
             and 2.0**-125 < s < 2.0**125 else add(A, B)
    """
    s = a + b
    x = s * (1.0 + 2.0**-52)
    c = x * (2.0**29 + 1.0)
    r = c - (c - x)
    if 2.0**-125 < r < 2.0**125 or -(2.0**125) < r < -(2.0**-125):
        if r == s:
            return r
        ratio = a / b
        if ratio > 0.0 or -256.0 <= ratio <= -(2.0**-8) or _is_safe(s, r, ratio):
            return r
    return _add(a, b) if s else 0.0


def sub(a: float, b: float) -> float:
    """The difference as the ROM rounds it; OV. The ROM adds the negated second operand.

    The expression given with `add` serves here with `A - B`.
    """
    s = a - b
    x = s * (1.0 + 2.0**-52)
    c = x * (2.0**29 + 1.0)
    r = c - (c - x)
    if 2.0**-125 < r < 2.0**125 or -(2.0**125) < r < -(2.0**-125):
        if r == s:
            return r
        ratio = a / b
        if ratio < 0.0 or 2.0**-8 <= ratio <= 256.0 or _is_safe(s, r, -ratio):
            return r
    return _add(a, -b) if s else 0.0


def _is_safe(s: float, r: float, ratio: float) -> bool:
    """Whether the exact sum `s` of operands of unlike signs rounds to `r` on the ROM too.

    With exponents more than 8 apart the smaller operand loses bits below the guard byte, which
    raises the magnitude of the sum by up to 1/128 of its last place; an operand 25 binary places
    below the other does not count at all.
    """
    if -(2.0**24) <= ratio <= -(2.0**-24):
        x = s * (1.0 + 2.0**-30)
        c = x * (2.0**29 + 1.0)
        return c - (c - x) == r
    return False


def _add(a: float, b: float) -> float:
    return from_register(registers.add(to_register(a), to_register(b), BITS))


def mul(a: float, b: float) -> float:
    """The product as the ROM rounds it; OV, also for some products just below 2^127.

    For generated code, the common case without the call::

        (c := s * 536870913.0) - (c - s)
            if 2.0**-125 < (s := A * B * 1.0000000000000002) < 2.0**125 else mul(A, B)
    """
    x = a * b * (1.0 + 2.0**-52)
    if 2.0**-125 < x < 2.0**125 or -(2.0**125) < x < -(2.0**-125):
        c = x * (2.0**29 + 1.0)
        return c - (c - x)
    if not x:
        return 0.0
    return from_register(registers.multiply(to_register(a), to_register(b), BITS))


def div(a: float, b: float) -> float:
    """The quotient as the ROM rounds it; division by zero, OV.

    Generated code may use the expression given with `mul`, with `A / B`, where B is not 0.
    """
    if b:
        x = a / b * (1.0 + 2.0**-52)
        if 2.0**-125 < x < 2.0**125 or -(2.0**125) < x < -(2.0**-125):
            c = x * (2.0**29 + 1.0)
            return c - (c - x)
        if not x:
            return 0.0
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


def narrow(value: float) -> int | float:
    """A whole single as an integer if it fits into one."""
    return int(value) if -32768.0 <= value < 32768.0 else value
