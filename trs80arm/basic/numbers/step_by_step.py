"""SIN, COS, TAN, ATN, LOG and EXP by the ROM's own polynomials, step by step.

Every step is rounded single arithmetic in the ROM's order, so the errors are the machine's too:
SIN(1E-3) is 1.00003E-03 and 3[2 is not 9. Coefficients and methods: Level II facts, Functions,
where they were fitted to the ROM's results and verified on 20,000 arguments each.

This is the definition. A program's functions are `functions`, which have the same bits and turn to
these where they cannot be certain.
"""

from __future__ import annotations

import math

from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.numbers.single import add, div, mul, negate, round_away, sub

TWO_PI = round_away(2.0 * math.pi)
HALF_PI = round_away(math.pi / 2.0)
LN_2 = round_away(math.log(2.0))
LOG2_E = round_away(1.0 / math.log(2.0))
ROOT_2 = round_away(math.sqrt(2.0))
ROOT_HALF = round_away(math.sqrt(0.5))

SIN = (
    39.710670471191406,
    -76.57498168945312,
    81.60223388671875,
    -41.3416748046875,
    6.283185005187988,
)
ATN = (
    0.0028662257827818394,
    -0.016165737062692642,
    0.042909614741802216,
    -0.07528963685035706,
    0.10656264424324036,
    -0.14208900928497314,
    0.19993549585342407,
    -0.33333146572113037,
    1.0,
)
EXP = (
    -0.00014131607895251364,
    0.0013298820704221725,
    -0.00830136053264141,
    0.041657350957393646,
    -0.16666531562805176,
    0.4999999701976776,
    -1.0,
    1.0,
)
LOG = (0.5989786386489868, 0.9614706635475159, 2.885392427444458)


def _polynomial(x: float, coefficients: tuple[float, ...]) -> float:
    """Horner's rule, highest power first, every product and sum rounded.

    The common cases of `single.mul` and `single.add` stand here in line; these two are called only
    where a result is near the ends of the range, or where unlike operands are far apart.
    """
    total = coefficients[0]
    for coefficient in coefficients[1:]:
        s = total * x * (1.0 + 2.0**-52)
        if 1e-74 < s * s < 1e74:
            c = s * (2.0**29 + 1.0)
            product = c - (c - s)
        else:
            product = mul(total, x)
        s = (product + coefficient) * (1.0 + 2.0**-52)
        ratio = product / coefficient
        if 1e-74 < s * s < 1e74 and (ratio > 0.0 or -256.0 <= ratio <= -(2.0**-8)):
            c = s * (2.0**29 + 1.0)
            total = c - (c - s)
        elif -(2.0**-26) < ratio < 0.0:
            total = coefficient
        else:
            total = add(product, coefficient)
    return total


def _odd(x: float, coefficients: tuple[float, ...]) -> float:
    """The polynomial in the square of `x`, times `x`."""
    return mul(_polynomial(mul(x, x), coefficients), x)


def sin(x: float) -> float:
    """The sine of `x` radians.

    The argument becomes a fraction of a turn first; what is lost there is lost for small angles.
    """
    turn = div(x, TWO_PI)
    turn = sub(turn, float(math.floor(turn)))
    t = sub(0.25, turn)
    if t >= 0.0:
        return _odd(sub(0.25, t), SIN)
    t = add(t, 0.5)
    return _odd(negate(sub(0.25, t) if t >= 0.0 else add(0.25, t)), SIN)


def cos(x: float) -> float:
    """The cosine of `x` radians: the sine a quarter turn further."""
    return sin(add(x, HALF_PI))


def tan(x: float) -> float:
    """The tangent of `x` radians; division by zero where the cosine is 0."""
    return div(sin(x), cos(x))


def atn(x: float) -> float:
    """The arc tangent of `x` in radians, between -pi/2 and pi/2."""
    magnitude = abs(x)
    if magnitude >= 1.0:
        result = sub(HALF_PI, _odd(div(1.0, magnitude), ATN))
    else:
        result = _odd(magnitude, ATN)
    return negate(result) if x < 0.0 else result


def log(x: float) -> float:
    """The natural logarithm; FC unless `x` is positive."""
    if x <= 0.0:
        raise BasicError(Code.FC)
    mantissa, exponent = math.frexp(x)
    y = sub(1.0, div(ROOT_2, add(mantissa, ROOT_HALF)))
    return mul(add(add(_odd(y, LOG), -0.5), float(exponent)), LN_2)


def exp(x: float) -> float:
    """The power `x` of e; OV from about 87.4 on, 0 below about -88.7."""
    binary = mul(x, LOG2_E)
    if binary >= 128.0:
        raise BasicError(Code.OV)
    if binary <= -128.0:
        return 0.0
    whole = math.floor(binary)
    if whole > 125:
        raise BasicError(Code.OV)
    t = sub(mul(float(whole + 1), LN_2), x)
    return mul(_polynomial(t, EXP), math.ldexp(1.0, whole + 1))
