"""Double precision: 56 bits, sixteen digits, in whole-number arithmetic.

`Double` is the value of a variable such as `A#` and of every literal of more than seven digits. The
routines follow the ROM to the bit, its defective subtraction included (`registers.add`).
"""

from __future__ import annotations

from typing import Final

from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.numbers import registers, single

BITS = 56
WHOLE: Final = 128 + BITS
"""The exponent from which on a double has no fraction."""
BELOW_TOP_BYTE: Final = (1 << BITS - 8) - 1
"""The bits of the mantissa's six lower bytes."""


class Double:
    """A double precision number; never changed after it is made.

    Attributes:
        exponent: as stored, 128 more than the power of two; 0 for zero.
        mantissa: signed, 56 bits with the top bit set, or 0.
    """

    __slots__ = ("exponent", "mantissa")

    def __init__(self, exponent: int, mantissa: int) -> None:
        self.exponent: Final = exponent
        self.mantissa: Final = mantissa

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Double):
            return NotImplemented
        return self.exponent == other.exponent and self.mantissa == other.mantissa

    def __hash__(self) -> int:
        return hash((self.exponent, self.mantissa))

    def __repr__(self) -> str:
        return f"Double({self.exponent}, {self.mantissa})"


ZERO = Double(0, 0)
MINUS_32768 = Double(128 + 16, -1 << BITS - 1)


def add(a: Double, b: Double) -> Double:
    """The sum as the ROM rounds it; OV."""
    return Double(*registers.add((a.exponent, a.mantissa), (b.exponent, b.mantissa), BITS))


def sub(a: Double, b: Double) -> Double:
    """The difference as the ROM rounds it; OV. The ROM adds the negated second operand."""
    return Double(*registers.add((a.exponent, a.mantissa), (b.exponent, -b.mantissa), BITS))


def mul(a: Double, b: Double) -> Double:
    """The product as the ROM rounds it; OV."""
    return Double(*registers.multiply((a.exponent, a.mantissa), (b.exponent, b.mantissa), BITS))


def div(a: Double, b: Double) -> Double:
    """The quotient as the ROM rounds it; division by zero, OV.

    A divisor of the largest exponent gives zero: the ROM complements the exponent first and takes
    the 0 it gets for a zero operand. For that reason it does not see that the dividend is zero,
    and takes it for 2 to the power of -129: 0#/1D-3 is 1.469367938527859D-36.
    """
    if b.exponent == 255:
        return ZERO
    dividend = a.mantissa or 1 << BITS - 1
    return Double(*registers.divide((a.exponent, dividend), (b.exponent, b.mantissa), BITS))


def times_ten(a: Double) -> Double:
    """Ten times a double by the ROM's short way, for reading and printing; OV."""
    return Double(*registers.times_ten((a.exponent, a.mantissa), BITS))


def negate(a: Double) -> Double:
    """The double with the other sign; zero has none."""
    return Double(a.exponent, -a.mantissa)


def compare(a: Double, b: Double) -> int:
    """-1, 0 or 1 as `a` is less than, equal to or greater than `b`."""
    if a.exponent == b.exponent or (a.mantissa < 0) != (b.mantissa < 0):
        return (a.mantissa > b.mantissa) - (a.mantissa < b.mantissa)
    if not a.exponent:
        return -1 if b.mantissa > 0 else 1
    if not b.exponent:
        return 1 if a.mantissa > 0 else -1
    larger = 1 if a.exponent > b.exponent else -1
    return larger if a.mantissa > 0 else -larger


def floor(a: Double) -> Double:
    """INT of a double outside the integers: the largest whole double that is not above `a`.

    Below zero the ROM takes one from the magnitude, drops the fraction and adds one again, and the
    borrow does not reach the top byte: INT(-44800#) is -45056.
    """
    shift = WHOLE - a.exponent
    if shift <= 0 or not a.exponent:
        return a
    if a.mantissa > 0:
        return from_int(a.mantissa >> shift)
    magnitude = -a.mantissa
    less_one = magnitude - 1 if magnitude & BELOW_TOP_BYTE else magnitude | BELOW_TOP_BYTE
    return from_int(-(less_one >> shift) - 1)


def floored(a: Double) -> int:
    """The largest whole number that is not above `a`, as a Python int."""
    shift = WHOLE - a.exponent
    return a.mantissa >> shift if shift > 0 else a.mantissa << -shift


def is_small(a: Double) -> bool:
    """Whether the magnitude is below 32768, or `a` is -32768: what INT makes an integer of."""
    return a.exponent < MINUS_32768.exponent or a == MINUS_32768


def from_int(number: int) -> Double:
    """The double of a whole number of at most 56 bits."""
    size = number.bit_length()
    if not size:
        return ZERO
    return Double(size + 128, number << (BITS - size))


def from_single(x: float) -> Double:
    """The double of the same value."""
    exponent, mantissa = single.to_register(x)
    return Double(exponent, mantissa << 32)


def to_single(a: Double) -> float:
    """The nearest single, half away from zero; OV at the upper end."""
    exponent = a.exponent
    if not exponent:
        return 0.0
    mantissa = (abs(a.mantissa) + 0x80000000) >> 32
    if mantissa >> 24:
        if exponent == 255:
            raise BasicError(Code.OV)
        mantissa >>= 1
        exponent += 1
    return single.from_register((exponent, -mantissa if a.mantissa < 0 else mantissa))


def pack(a: Double) -> bytes:
    """The eight bytes in memory: mantissa low byte first, sign above its top bit, exponent."""
    if not a.exponent:
        return bytes(8)
    sign = 1 << 55 if a.mantissa < 0 else 0
    word = (abs(a.mantissa) & ((1 << 55) - 1)) | sign
    return word.to_bytes(7, "little") + bytes([a.exponent])


def unpack(data: bytes) -> Double:
    """The double of eight bytes in memory; exponent 0 is zero whatever the others hold."""
    exponent = data[7]
    if not exponent:
        return ZERO
    word = int.from_bytes(data[:7], "little")
    mantissa = word | 1 << 55
    return Double(exponent, -mantissa if word >> 55 else mantissa)
