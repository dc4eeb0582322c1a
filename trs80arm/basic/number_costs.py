"""How many T-states the ROM's number routines take, from the numbers that they work on.

Constants are converted anew each time they are executed, numbers are scaled digit by digit before
they are printed, and the arithmetic of doubles shifts and adds 56 bits one after the other: what
that takes depends on the digits and bits. The models here follow the ROM's steps; what each step
takes was measured on the ROM with the clock between two OUT statements, over some 500 constants,
300 printed numbers and 900 operations with random operands. They meet those within 1 per cent.
"""

from __future__ import annotations

from typing import Final, NamedTuple

from trs80arm.basic.characters import ZERO
from trs80arm.basic.numbers import decimal, double, literal, registers, single
from trs80arm.basic.numbers.convert import Number
from trs80arm.basic.numbers.double import Double
from trs80arm.basic.numbers.registers import Register


class Steps(NamedTuple):
    """What the steps of reading and scaling a number take in one precision, in T-states.

    Attributes:
        bits: of the mantissa.
        ten: the register that holds ten.
        digit: one more digit: ten times the number, the digit made a number, both added.
        zero: what a digit 0 takes less.
        first: a digit that is added to 0.
        digit_bit: for each bit of the digit, which need not be shifted up then.
        shift: for each bit that the digit is shifted for the sum.
        shift_byte: for each 8 bits of it.
        digit_carry: a digit whose multiplication by ten carries.
        times_ten: a step of ten up.
        carry: more when that carries.
        tenth: a step of ten down.
        tenth_bit: for each 1 in the quotient.
        tenth_less: more when the first digit of the quotient is 0.
    """

    bits: int
    ten: Register
    digit: int
    zero: int
    first: int
    digit_bit: int
    shift: int
    shift_byte: int
    digit_carry: int
    times_ten: int
    carry: int
    tenth: int
    tenth_bit: int
    tenth_less: int


SINGLE: Final = Steps(
    24, (132, 10 << 20), 3841, -1901, 1940, -186, 49, 0, 388, 1258, 266, 8424, 0, 291
)
DOUBLE: Final = Steps(
    56, (132, 10 << 52), 5929, -1502, 2470, 0, 339, 258, 425, 2537, 279, 90050, -355, 1408
)
CHARACTER: Final = 71
"""A character of a constant."""
DIGIT: Final = 458
"""A digit while the number is an integer."""
EXPONENT: Final = 478
"""An exponent."""
BECOMES_DOUBLE: Final = -519
"""The eighth digit, beside what a digit takes in double precision."""

INTEGER_TEXT: Final = 11373
INTEGER_DIGIT: Final = -148
INTEGER_COUNT: Final = 40
"""An integer's text, for each of its digits, and for each time a power of ten is taken away."""
INTEGER_ZERO: Final = -2694
NEGATIVE: Final = 301
SINGLE_TEXT: Final = 14512
SINGLE_UP: Final = 1779
SINGLE_DOWN: Final = 8976
SINGLE_COUNT: Final = 50
SINGLE_SHIFT: Final = -88
SINGLE_ZERO: Final = -6286
_WHOLE: Final = tuple(
    SINGLE_TEXT + SINGLE_UP * (6 - length) + SINGLE_SHIFT * 24 for length in range(7)
)
_TENS: Final[tuple[int, ...]] = (10**6, 10**5, 10**4, 1000, 100, 10, 1)
"""By the digits of a whole single: its text, beside its digits, and what makes six of them."""
TEXT_CHARACTER: Final = 15
DOUBLE_TEXT: Final = 31900
DOUBLE_ZERO: Final = -23300
DOUBLE_FAR_UP: Final = 29738
DOUBLE_FAR_UP_BIT: Final = 362
DOUBLE_FAR_UP_ZERO: Final = -3485
"""Times 1E10: for each 1 in the number's mantissa, and for each zero byte of it."""
DOUBLE_UP: Final = 3309
DOUBLE_UP_CARRY: Final = 454
DOUBLE_DOWN: Final = 87567
DOUBLE_DOWN_BIT: Final = -228
DOUBLE_COUNT_HIGH: Final = 417
DOUBLE_COUNT_LOW: Final = 63
"""A power of ten taken away: the first ten digits are found in double precision."""
FIELD_SINGLE: Final = 8300
"""A digit too many for a field of PRINT USING."""

SUM_SWAP: Final = 570
SUM_BYTE: Final = 357
SUM_BIT: Final = 365
SUM_UNLIKE: Final = 86
SUM_NEGATIVE: Final = 377
SUM_CARRY: Final = 480
PRODUCT_BY: Final = 880
PRODUCT_BY_BIT: Final = 64
PRODUCT_BY_ZERO_BYTE: Final = -709
"""A single product, whose usual right side has one or two zero bytes and four ones."""
PRODUCT: Final = 27340
PRODUCT_BIT: Final = 386
PRODUCT_ZERO_BYTE: Final = -3386
PRODUCT_NORMAL: Final = 419
QUOTIENT: Final = 88440
QUOTIENT_BIT: Final = -340
QUOTIENT_LESS: Final = 1334
"""Double precision: by the exponents and bits of the operands (see the functions)."""


def _carries(mantissa: int, bits: int) -> bool:
    """Whether five times a mantissa has three bits more than the mantissa."""
    return (abs(mantissa) * 5 >> 2) >> bits > 0


def _register(value: float | Double) -> tuple[Steps, Register]:
    """What a number's steps take, and the number as a register."""
    if isinstance(value, Double):
        return DOUBLE, (value.exponent, value.mantissa)
    return SINGLE, single.to_register(value)


class LiteralMeter(literal.Meter):
    """Adds up what the scan of a number takes, as often as it is read.

    Attributes:
        total: T-states so far.
    """

    def __init__(self) -> None:
        self.total = 0

    def character(self) -> None:
        """A character was taken."""
        self.total += CHARACTER

    def integer_digit(self) -> None:
        """A digit came to an integer."""
        self.total += DIGIT

    def digit(self, value: float | Double, digit: int) -> None:
        """Ten times the number, and the digit added."""
        steps, register = _register(value)
        bits = steps.bits
        size = digit.bit_length()
        self.total += steps.digit_bit * size
        if not register[0]:
            self.total += steps.first
            return
        self.total += steps.digit + (steps.digit_carry if _carries(register[1], bits) else 0)
        distance = abs(registers.times_ten(register, bits)[0] - (128 + size))
        if not digit or distance > bits:
            self.total += steps.zero
        else:
            self.total += steps.shift_byte * (distance // 8) + steps.shift * (distance % 8)

    def became_double(self) -> None:
        """The eighth digit."""
        self.total += BECOMES_DOUBLE

    def exponent(self) -> None:
        """An exponent begins."""
        self.total += EXPONENT

    def ten_up(self, value: float | Double) -> None:
        """A step of ten up."""
        steps, register = _register(value)
        self.total += steps.times_ten + (steps.carry if _carries(register[1], steps.bits) else 0)

    def ten_down(self, value: float | Double) -> None:
        """A step of ten down, by the bits of the quotient; a zero stays one."""
        steps, register = _register(value)
        if register[0]:
            self.total += _tenth(register, steps)


def _tenth(register: Register, steps: Steps) -> int:
    """T-states to divide by ten."""
    quotient = (abs(register[1]) << (steps.bits + 8)) // steps.ten[1]
    less = steps.tenth_less if abs(register[1]) < steps.ten[1] else 0
    return steps.tenth + steps.tenth_bit * quotient.bit_count() + less


def _digit_sum(figures: bytes) -> int:
    """The digits of a number added up: each is counted down to zero on the Z-80."""
    return sum(figures) - ZERO * len(figures)


def text(value: Number, shown: str) -> int:
    """T-states to make a number's text, as PRINT and STR$ do.

    Args:
        value: the number.
        shown: what it came to.
    """
    negative = NEGATIVE if shown[0] == "-" else 0
    figures = shown[1:]
    length = len(figures)
    if type(value) is float and value and length <= decimal.SINGLE_DIGITS and figures.isdigit():
        # A whole number: bringing it to six digits rounds nothing.
        size = (int(figures) * _TENS[length]).bit_length()
        total = TEXT_CHARACTER * (length + 1) + negative + _WHOLE[length] + SINGLE_SHIFT * -size
        return total + SINGLE_COUNT * (sum(figures.encode()) - ZERO * length)
    if isinstance(value, int) and value != -32768:
        count = _digit_sum(shown.encode("ascii")[1:])
        total = INTEGER_TEXT + INTEGER_DIGIT * (len(shown) - 1) + INTEGER_COUNT * count
        return total + negative + (0 if value else INTEGER_ZERO)
    total = TEXT_CHARACTER * len(shown) + negative
    if isinstance(value, Double):
        return total + DOUBLE_TEXT + (double_scaling(value) if value.exponent else DOUBLE_ZERO)
    if not value:
        return total + SINGLE_TEXT + SINGLE_ZERO
    return total + SINGLE_TEXT + single_scaling(float(value))


def field(value: Number, left: int, right: int, exponent: bool) -> int:
    """T-states to cut a number down to the digits that a field of PRINT USING shows.

    For every digit too many it is divided by ten.

    Args:
        value: the number.
        left: places in front of the point.
        right: places behind it.
        exponent: whether the field shows an exponent.
    """
    if isinstance(value, int) or not value or value == double.ZERO:
        return 0
    if isinstance(value, float):
        x, places = decimal.scaled(abs(value))
        count = decimal.SINGLE_DIGITS
    else:
        x, places = decimal.scaled(Double(value.exponent, abs(value.mantissa)))
        count = decimal.DOUBLE_DIGITS
    wanted = left - 1 + right if exponent else count - places + right
    unwanted = max(0, count - wanted)
    if isinstance(x, float):
        return FIELD_SINGLE * unwanted
    total = 0
    while unwanted and x.exponent:
        total += _tenth((x.exponent, x.mantissa), DOUBLE)
        x = double.div(x, decimal.TEN)
        unwanted -= 1
    return total


def single_scaling(value: float) -> int:
    """T-states to bring a single to six digits before the point, and to find the digits."""
    x, places = decimal.scaled(abs(value))
    assert isinstance(x, float)
    figures = decimal.digits(decimal.cut(x), decimal.SINGLE_DIGITS)
    total = SINGLE_UP * places if places > 0 else -SINGLE_DOWN * places
    total += SINGLE_COUNT * _digit_sum(figures.encode("ascii"))
    return total + SINGLE_SHIFT * (24 - single.to_register(x)[0] + 128)


def double_scaling(value: Double) -> int:
    """T-states to bring a double to sixteen digits before the point, and to find the digits."""
    total = 0
    x = Double(value.exponent, abs(value.mantissa))
    while double.compare(x, decimal.FEW) < 0:
        zeros = x.mantissa.to_bytes(7, "little").count(0)
        total += DOUBLE_FAR_UP + DOUBLE_FAR_UP_BIT * x.mantissa.bit_count()
        total += DOUBLE_FAR_UP_ZERO * zeros
        x = double.mul(x, decimal.TEN_TO_TENTH)
    while double.compare(x, decimal.ABOVE) >= 0:
        quotient = (x.mantissa << 64) // DOUBLE.ten[1]
        total += DOUBLE_DOWN + DOUBLE_DOWN_BIT * quotient.bit_count()
        x = double.div(x, decimal.TEN)
    while double.compare(x, decimal.BELOW) < 0:
        total += DOUBLE_UP + (DOUBLE_UP_CARRY if _carries(x.mantissa, 56) else 0)
        x = double.times_ten(x)
    figures = decimal.digits(decimal.cut(x), decimal.DOUBLE_DIGITS).encode("ascii")
    total += DOUBLE_COUNT_HIGH * _digit_sum(figures[:10])
    return total + DOUBLE_COUNT_LOW * _digit_sum(figures[10:])


def product_by(value: float) -> int:
    """T-states of a product with a known single on the right, beside those of a usual one."""
    mantissa = abs(single.to_register(value)[1])
    zeros = mantissa.to_bytes(3, "little").count(0)
    return PRODUCT_BY + PRODUCT_BY_BIT * mantissa.bit_count() + PRODUCT_BY_ZERO_BYTE * zeros


def double_sum(a: Double, b: Double) -> int:
    """T-states of the sum of two doubles beyond those of the quickest."""
    if not a.exponent or not b.exponent:
        return 0
    distance = abs(a.exponent - b.exponent)
    if distance > 56:
        return 0
    total = SUM_SWAP if a.exponent < b.exponent else 0
    total += SUM_BYTE * (distance // 8) + SUM_BIT * (distance % 8)
    large, small = (a, b) if a.exponent >= b.exponent else (b, a)
    exact = large.mantissa + (small.mantissa >> distance)
    lost = 56 - exact.bit_length()
    if (a.mantissa < 0) != (b.mantissa < 0):
        total += SUM_UNLIKE
        if (exact < 0) != (large.mantissa < 0):
            total += SUM_NEGATIVE
    if lost < 0:
        return total + SUM_CARRY
    return total + SUM_BYTE * (lost // 8) + SUM_BIT * (lost % 8) if exact else total


def double_product(a: Double, b: Double) -> int:
    """T-states of the product of two doubles: by the bits of the first."""
    if not a.exponent or not b.exponent:
        return 0
    mantissa = abs(a.mantissa)
    total = PRODUCT + PRODUCT_BIT * mantissa.bit_count()
    total += PRODUCT_ZERO_BYTE * mantissa.to_bytes(7, "little").count(0)
    if (a.mantissa * b.mantissa).bit_length() < 112:
        total += PRODUCT_NORMAL
    return total


def double_quotient(a: Double, b: Double) -> int:
    """T-states of the quotient of two doubles: by its bits."""
    if not a.exponent or not b.exponent:
        return 0
    dividend, divisor = abs(a.mantissa), abs(b.mantissa)
    total = QUOTIENT + QUOTIENT_BIT * ((dividend << 64) // divisor).bit_count()
    return total + (QUOTIENT_LESS if dividend < divisor else 0)
