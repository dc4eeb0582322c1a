"""SIN, COS, TAN, ATN, LOG, EXP, SQR and the power, with the ROM's bits, in straight lines.

What they compute is `step_by_step`: the ROM's polynomials, every product and sum rounded. Here each
rounding is the fewest operations of Python floats that give the same, for arguments where it is
certain that they do; the others, which are few, go step by step.

- A product of two singles is exact in 53 bits. It is rounded half away from zero by Veltkamp's way
  (`single`); for the products of a polynomial the hair away from zero is in its argument already
  (`wide`).
- A sum of a coefficient and a smaller product of the other sign: the ROM drops what is more than 8
  bits below the coefficient's last place, and then rounds half away. That is the same as adding
  2^-8 of that place, less 2^-25 of it, to the coefficient, and rounding to the nearest: the sum is
  then never half-way between two singles. With a product of the same sign nothing that is dropped
  counts, and 2^-26 of that place keeps the sum from the half-way.
- Where a sum lies between the same two powers of two for every argument, it is rounded by adding
  and taking off a number whose last place is the sum's (1.5 * 2^28 for sums of 1/2 to 1); else by
  Veltkamp's way.

A test holds the two side by side.
"""

from __future__ import annotations

import math
from typing import Final

from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.numbers import step_by_step
from trs80arm.basic.numbers.single import BITS, add, div, mul, negate

_POWERS: Final = tuple(math.ldexp(1.0, power) for power in range(-100, 101))
"""2^-100 to 2^100, by the power plus 100."""


OF_ONE_EXPONENT: Final = {2.0: "squares", 3.0: "cubes", 0.5: "roots"}
"""What generated text calls the power with a usual exponent."""


def sin(x: float) -> float:
    """The sine of `x` radians.

    The argument becomes a fraction of a turn first; what is lost there is lost for small angles.
    """
    t = x / 6.2831854820251465
    c = t * 536870913.0
    t = c - (c - t)
    # The fraction of a turn is exact but between -1/2 and 0, and the way to the first quarter is
    # exact but in the first quarter itself, where the ROM rounds to 2^-26.
    if t >= 1.0 or t <= -0.5:
        t -= t // 1.0
    elif t < 0.0:
        if t > -(2.0**-20):
            return step_by_step.sin(x)
        t = t + (1.0 + 2.0**-31 - 2.0**-48) + 1.5 * 2.0**28 - 1.5 * 2.0**28
    if t <= 0.25:
        if t < 2.0**-26:
            # What is so much smaller than a quarter is lost to the ROM.
            return 0.0
        t = 0.25 - (0.25 + 2.0**-33 - 2.0**-50 - t + 1.5 * 2.0**26 - 1.5 * 2.0**26)
    elif t <= 0.75:
        t = 0.5 - t
    else:
        t -= 1.0
    c = (s := t * t * 1.0000000000000002) * 536870913.0
    square = c - (c - s)
    wide = square * 1.0000000000000002
    c = (s := 39.710670471191406 * wide) * 536870913.0
    s = c - (c - s) - (76.57498168945312 + 2.0**-25 - 2.0**-42)
    s = s + 1.5 * 2.0**35 - 1.5 * 2.0**35
    c = (s := s * wide) * 536870913.0
    s = c - (c - s) + (81.60223388671875 + 2.0**-25 - 2.0**-42)
    s = s + 1.5 * 2.0**35 - 1.5 * 2.0**35
    c = (s := s * wide) * 536870913.0
    s = c - (c - s) - (41.3416748046875 + 2.0**-26 - 2.0**-43)
    s = s + 1.5 * 2.0**34 - 1.5 * 2.0**34
    c = (s := s * wide) * 536870913.0
    c = (s := c - (c - s) + (6.283185005187988 + 2.0**-29 - 2.0**-46)) * 536870913.0
    c = (s := (c - (c - s)) * t * 1.0000000000000002) * 536870913.0
    return c - (c - s)


def cos(x: float) -> float:
    """The cosine of `x` radians: the sine a quarter turn further."""
    if x >= 0.0 or -256.0 <= x <= -0.0078125:
        c = (s := (x + 1.5707963705062866) * 1.0000000000000002) * 536870913.0
        return sin(c - (c - s))
    return sin(add(x, 1.5707963705062866))


def tan(x: float) -> float:
    """The tangent of `x` radians; division by zero where the cosine is 0."""
    return div(sin(x), cos(x))


def atn(x: float) -> float:
    """The arc tangent of `x` in radians, between -pi/2 and pi/2."""
    t = -x if x < 0.0 else x
    if t >= 1.0:
        t = 1.0 / t
        c = t * 536870913.0
        t = c - (c - t)
    if t < 2.0**-10:
        return step_by_step.atn(x)
    c = (s := t * t * 1.0000000000000002) * 536870913.0
    square = c - (c - s)
    wide = square * 1.0000000000000002
    c = (s := 0.0028662257827818394 * wide) * 536870913.0
    c = (s := c - (c - s) - (0.016165737062692642 + 2.0**-37 - 2.0**-54)) * 536870913.0
    c = (s := (c - (c - s)) * wide) * 536870913.0
    c = (s := c - (c - s) + (0.042909614741802216 + 2.0**-36 - 2.0**-53)) * 536870913.0
    c = (s := (c - (c - s)) * wide) * 536870913.0
    c = (s := c - (c - s) - (0.07528963685035706 + 2.0**-35 - 2.0**-52)) * 536870913.0
    c = (s := (c - (c - s)) * wide) * 536870913.0
    c = (s := c - (c - s) + (0.10656264424324036 + 2.0**-35 - 2.0**-52)) * 536870913.0
    c = (s := (c - (c - s)) * wide) * 536870913.0
    c = (s := c - (c - s) - (0.14208900928497314 + 2.0**-34 - 2.0**-51)) * 536870913.0
    c = (s := (c - (c - s)) * wide) * 536870913.0
    c = (s := c - (c - s) + (0.19993549585342407 + 2.0**-34 - 2.0**-51)) * 536870913.0
    c = (s := (c - (c - s)) * wide) * 536870913.0
    c = (s := c - (c - s) - (0.33333146572113037 + 2.0**-33 - 2.0**-50)) * 536870913.0
    c = (s := (c - (c - s)) * wide) * 536870913.0
    s = c - (c - s) + (1.0 + 2.0**-31 - 2.0**-48)
    s = s + 1.5 * 2.0**28 - 1.5 * 2.0**28
    c = (s := s * t * 1.0000000000000002) * 536870913.0
    s = c - (c - s)
    if x >= 1.0:
        c = (s := 1.5707963705062866 + 2.0**-31 - 2.0**-48 - s) * 536870913.0
        return c - (c - s)
    if x <= -1.0:
        c = (s := s - (1.5707963705062866 + 2.0**-31 - 2.0**-48)) * 536870913.0
        return c - (c - s)
    return -s if x < 0.0 else s


def log(x: float) -> float:
    """The natural logarithm; FC unless `x` is positive."""
    if x <= 0.0:
        raise BasicError(Code.FC)
    s, exponent = math.frexp(x)
    s = s + (0.7071067690849304 + 2.0**-49) + 1.5 * 2.0**29 - 1.5 * 2.0**29
    c = (s := 1.4142135381698608 / s) * 536870913.0
    t = 1.0 - (c - (c - s))
    c = (s := t * t * 1.0000000000000002) * 536870913.0
    square = c - (c - s)
    wide = square * 1.0000000000000002
    c = (s := 0.5989786386489868 * wide) * 536870913.0
    s = c - (c - s) + (0.9614706635475159 + 2.0**-50)
    s = s + 1.5 * 2.0**28 - 1.5 * 2.0**28
    c = (s := s * wide) * 536870913.0
    s = c - (c - s) + (2.885392427444458 + 2.0**-48)
    s = s + 1.5 * 2.0**30 - 1.5 * 2.0**30
    c = (s := s * t * 1.0000000000000002) * 536870913.0
    s = c - (c - s)
    if 0.0 < s < 2.0**-8:
        c = (s := s - (0.5 + 2.0**-32 - 2.0**-49)) * 536870913.0
    else:
        c = (s := (s - 0.5) * 1.0000000000000002) * 536870913.0
    s = c - (c - s)
    if exponent:
        if exponent > s * -65536.0:
            return step_by_step.log(x)
        if exponent > s * -256.0:
            place = 1 << exponent.bit_length() - 1
            c = (s := exponent + place * (2.0**-31 - 2.0**-48) + s) * 536870913.0
        else:
            c = (s := (s + exponent) * 1.0000000000000002) * 536870913.0
        s = c - (c - s)
    c = (s := s * 0.6931471824645996 * 1.0000000000000002) * 536870913.0
    return c - (c - s)


def exp(x: float) -> float:
    """The power `x` of e; OV from about 87.4 on, 0 below about -88.7."""
    if not -60.0 < x < 60.0:
        return step_by_step.exp(x)
    c = (s := x * 1.4426950216293335 * 1.0000000000000002) * 536870913.0
    whole = (c - (c - s)) // 1.0 + 1.0
    c = (s := whole * 0.6931471824645996 * 1.0000000000000002) * 536870913.0
    s = c - (c - s) - x
    c = s * 536870913.0
    if c - (c - s) != s:
        if not 2.0**-7 < x < 1.0:
            return step_by_step.exp(x)
        c = (s := s * 1.0000000000000002) * 536870913.0
        s = c - (c - s)
    if not 2.0**-16 < s < 0.693:
        return step_by_step.exp(x)
    wide = s * 1.0000000000000002
    c = (s := -0.00014131607895251364 * wide) * 536870913.0
    s = c - (c - s) + (0.0013298820704221725 + 2.0**-41 - 2.0**-58)
    s = s + 1.5 * 2.0**19 - 1.5 * 2.0**19
    c = (s := s * wide) * 536870913.0
    c = (s := c - (c - s) - (0.00830136053264141 + 2.0**-38 - 2.0**-55)) * 536870913.0
    c = (s := (c - (c - s)) * wide) * 536870913.0
    s = c - (c - s) + (0.041657350957393646 + 2.0**-36 - 2.0**-53)
    s = s + 1.5 * 2.0**24 - 1.5 * 2.0**24
    c = (s := s * wide) * 536870913.0
    s = c - (c - s) - (0.16666531562805176 + 2.0**-34 - 2.0**-51)
    s = s + 1.5 * 2.0**26 - 1.5 * 2.0**26
    c = (s := s * wide) * 536870913.0
    s = c - (c - s) + (0.4999999701976776 + 2.0**-33 - 2.0**-50)
    s = s + 1.5 * 2.0**27 - 1.5 * 2.0**27
    c = (s := s * wide) * 536870913.0
    s = c - (c - s) - (1.0 + 2.0**-31 - 2.0**-48)
    s = s + 1.5 * 2.0**28 - 1.5 * 2.0**28
    c = (s := s * wide) * 536870913.0
    s = c - (c - s) + (1.0 + 2.0**-31 - 2.0**-48)
    return (s + 1.5 * 2.0**28 - 1.5 * 2.0**28) * _POWERS[int(whole) + 100]


def power(base: float, exponent: float) -> float:
    """`base [ exponent`, by logarithm, so that whole powers are not exact.

    Raises:
        BasicError: division by zero for 0 to a negative power, FC for a negative base with an
            exponent that is not whole, OV.
    """
    if exponent == 0.0:
        return 1.0
    if base > 0.0:
        s = log(base) * exponent * 1.0000000000000002
        if 1e-30 < s < 1e30 or -1e30 < s < -1e-30:
            c = s * 536870913.0
            return exp(c - (c - s))
        return exp(mul(exponent, log(base)))
    if base == 0.0:
        if exponent < 0.0:
            raise BasicError(Code.DIVISION)
        return 0.0
    if exponent != math.floor(exponent):
        raise BasicError(Code.FC)
    result = exp(mul(exponent, log(-base)))
    return negate(result) if _odd_low_bit(exponent) else result


def _odd_low_bit(whole: float) -> bool:
    """Whether the ROM takes a whole exponent for odd.

    It looks at the lowest bit of the 24 that its INT leaves, which from 2 to the 24th on are the
    mantissa: (-1)[1E10 is -1.
    """
    shift = max(0, math.frexp(whole)[1] - BITS)
    return math.fmod(math.ldexp(whole, -shift), 2.0) != 0.0


def sqr(x: float) -> float:
    """The square root, which the ROM takes as the power of one half; FC below 0."""
    if x > 0.0:
        return exp(log(x) * 0.5)
    return power(x, 0.5)
