"""The arithmetic of the ROM's floating-point registers, on whole numbers, exact to the bit.

A value is a stored exponent (1 to 255, 128 more than the power of two; 0 means zero) and a mantissa
of 24 or 56 bits with its top bit set: `mantissa * 2**(exponent - 128 - bits)`. The ROM works with
one guard byte below the mantissa and drops what falls out of it (Level II facts, Rounding of
+ - * /). `double` uses these routines for everything, `single` where a Python float would not do.
"""

from __future__ import annotations

from trs80arm.basic.errors import BasicError, Code

GUARD = 8
"""Bits kept below the mantissa while the ROM adds, multiplies or divides."""
HALF = 1 << (GUARD - 1)

Register = tuple[int, int]
"""Stored exponent and mantissa; the mantissa is signed, `(0, 0)` is zero."""

ZERO: Register = (0, 0)


def rounded(negative: bool, exponent: int, extended: int, bits: int) -> Register:
    """A mantissa with guard byte, rounded half away from zero.

    Args:
        negative: the sign of the result.
        exponent: the stored exponent that `extended` has with its top bit set.
        extended: `bits + GUARD` bits, possibly with leading zeros.
        bits: 24 or 56.

    Raises:
        BasicError: OV when rounding carries out of the largest exponent.
    """
    shift = bits + GUARD - extended.bit_length()
    exponent -= shift
    if exponent <= 0 or not extended:
        return ZERO
    mantissa = ((extended << shift) + HALF) >> GUARD
    if mantissa >> bits:
        mantissa >>= 1
        exponent += 1
    if exponent > 255:
        raise BasicError(Code.OV)
    return exponent, -mantissa if negative else mantissa


def add(a: Register, b: Register, bits: int) -> Register:
    """The sum of two registers; OV when it is too large.

    The operand with the smaller exponent is shifted right; what leaves the guard byte is lost. In
    double precision operands of unlike signs meet the ROM's defect: its guard byte is appended as
    it is instead of being subtracted (case `numfmt-double-subtract-guard`).
    """
    if not a[0]:
        return b
    if not b[0]:
        return a
    if a[0] < b[0]:
        a, b = b, a
    exponent, large = a
    distance = exponent - b[0]
    if distance > bits:
        return a
    negative = large < 0
    shifted = (abs(b[1]) << GUARD) >> distance
    if negative == (b[1] < 0):
        total = (abs(large) << GUARD) + shifted
        if total >> (bits + GUARD):
            total >>= 1
            exponent += 1
            if exponent > 255:
                raise BasicError(Code.OV)
        return rounded(negative, exponent, total, bits)
    if bits == 24:
        total = (abs(large) << GUARD) - shifted
    else:
        total = ((abs(large) - (shifted >> GUARD)) << GUARD) | (shifted & 0xFF)
    if total < 0:
        negative = not negative
        total = -total
    return rounded(negative, exponent, total, bits)


def _exponent(total: int) -> int:
    """The provisional exponent of a product or quotient, 0 for underflow; OV when too large.

    The ROM judges by the sum of the exponents, before it knows the mantissa.
    """
    if total <= 128:
        return 0
    if total >= 384:
        raise BasicError(Code.OV)
    return total - 128


def multiply(a: Register, b: Register, bits: int) -> Register:
    """The product of two registers; OV when the sum of the exponents is too large."""
    if not a[0] or not b[0]:
        return ZERO
    exponent = _exponent(a[0] + b[0])
    if not exponent:
        return ZERO
    extended = abs(a[1] * b[1]) >> (bits - GUARD)
    return rounded((a[1] < 0) != (b[1] < 0), exponent, extended, bits)


def divide(a: Register, b: Register, bits: int) -> Register:
    """The quotient of two registers; division by zero or OV.

    The ROM sets the exponent two too small at first, so a quotient near the lower end is already
    zero: 1E-38/2 is 0 (case `numfmt-min-values`). At the upper end the correction wraps round in
    its byte: 1E38/.5 is 0, and a quotient twice as large is one of the smallest numbers or OV.
    """
    if not b[0]:
        raise BasicError(Code.DIVISION)
    if not a[1]:
        return ZERO
    exponent = _exponent(a[0] + 255 - b[0])
    if not exponent:
        return ZERO
    exponent = (exponent + 2) & 0xFF
    dividend, divisor = abs(a[1]), abs(b[1])
    if dividend < divisor:
        if exponent == 1:
            raise BasicError(Code.OV)
        dividend <<= 1
        exponent = (exponent - 1) & 0xFF
    extended = (dividend << (bits + GUARD - 1)) // divisor
    return rounded((a[1] < 0) != (b[1] < 0), exponent, extended, bits)


def times_ten(a: Register, bits: int) -> Register:
    """Ten times a register, as the ROM's own short way `(4x + x) * 2` gives it; OV."""
    exponent, mantissa = a
    if not exponent:
        return ZERO
    if exponent > 253:
        raise BasicError(Code.OV)
    exponent, mantissa = add((exponent + 2, mantissa), a, bits)
    if exponent == 255:
        raise BasicError(Code.OV)
    return exponent + 1, mantissa
