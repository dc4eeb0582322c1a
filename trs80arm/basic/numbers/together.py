"""The functions of many arguments at once, with the ROM's bits: arrays instead of numbers.

`functions` has each of them in a straight line for one argument, and tells why fewer operations
than the ROM's roundings give the same. Here the same operations are done on arrays, with the
coefficients of `step_by_step`; whoever asks is told for which arguments that is certain. A test
holds all three side by side.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Final

import numpy as np
import numpy.typing as npt

from trs80arm.basic.numbers.functions import OF_ONE_EXPONENT
from trs80arm.basic.numbers.step_by_step import (
    ATN,
    EXP,
    HALF_PI,
    LN_2,
    LOG,
    LOG2_E,
    ROOT_2,
    ROOT_HALF,
    SIN,
    TWO_PI,
)

Array = npt.NDArray[np.float64]
Mask = npt.NDArray[np.bool_]
Function = Callable[[Array], tuple[Array, Mask]]

_SPLIT: Final = 2.0**29 + 1.0
_AWAY: Final = 1.0 + 2.0**-52


def nearest(values: Array) -> Array:
    """Rounded to 24 bits."""
    c = values * _SPLIT
    result: Array = c - (c - values)
    return result


def _away(values: Array) -> Array:
    """Rounded to 24 bits, halves away from zero."""
    return nearest(values * _AWAY)


def _nudged(coefficient: float, *, alike: bool) -> float:
    """A coefficient that a smaller product can be added to, so that the ROM's sum comes out."""
    place = math.copysign(math.ldexp(1.0, math.frexp(coefficient)[1] - 24), coefficient)
    return coefficient + place * (2.0**-26 if alike else 2.0**-8 - 2.0**-25)


def _polynomial(x: Array, coefficients: tuple[float, ...]) -> Array:
    """Horner's rule for positive `x`; each product is smaller than what it is added to."""
    wide = x * _AWAY
    first, *others = coefficients
    product = nearest(first * wide)
    total = product
    before = first
    for coefficient in others:
        alike = (before > 0.0) == (coefficient > 0.0)
        total = nearest(product + _nudged(coefficient, alike=alike))
        product = nearest(total * wide)
        before = coefficient
    return total


def sin(x: Array) -> tuple[Array, Mask]:
    """SIN, but for the smallest arguments."""
    t = nearest(x / TWO_PI)
    behind = t + (1.0 + 2.0**-31 - 2.0**-48) + 1.5 * 2.0**28 - 1.5 * 2.0**28
    certain = (t >= 0.0) | (t <= -(2.0**-20))
    t = np.where((t < 0.0) & (t > -0.5), behind, t - np.floor(t))
    certain &= t >= 2.0**-26
    small = 0.25 - (0.25 + 2.0**-33 - 2.0**-50 - t + 1.5 * 2.0**26 - 1.5 * 2.0**26)
    t = np.where(t <= 0.25, small, np.where(t <= 0.75, 0.5 - t, t - 1.0))
    return _away(_polynomial(_away(t * t), SIN) * t), certain


def cos(x: Array) -> tuple[Array, Mask]:
    """COS, but for small negative arguments, and large ones."""
    result, certain = sin(_away(x + HALF_PI))
    return result, certain & ((x >= 0.0) | ((x >= -256.0) & (x <= -0.0078125)))


def atn(x: Array) -> tuple[Array, Mask]:
    """ATN, for arguments from 2^-10 to 2^10 and their negatives."""
    magnitude = np.abs(x)
    large = magnitude >= 1.0
    t = np.where(large, nearest(1.0 / magnitude), magnitude)
    result = _away(_polynomial(_away(t * t), ATN) * t)
    rest = nearest(HALF_PI + 2.0**-31 - 2.0**-48 - result)
    return np.copysign(np.where(large, rest, result), x), t >= 2.0**-10


def log(x: Array) -> tuple[Array, Mask]:
    """LOG, for positive arguments that are not too near to a power of 2."""
    mantissa, exponent = np.frexp(x)
    s = mantissa + (ROOT_HALF + 2.0**-49) + 1.5 * 2.0**29 - 1.5 * 2.0**29
    t = 1.0 - nearest(ROOT_2 / s)
    s = _away(_polynomial(_away(t * t), LOG) * t)
    small = (s > 0.0) & (s < 2.0**-8)
    s = np.where(small, nearest(s + _nudged(-0.5, alike=False)), _away(s - 0.5))
    place = np.ldexp(1.0, np.frexp(exponent.astype(np.float64))[1] - 1)
    certain = (x > 0.0) & ((exponent == 0) | (exponent <= s * -65536.0))
    far = nearest(exponent + place * (2.0**-31 - 2.0**-48) + s)
    near = _away(s + exponent)
    s = np.where(exponent == 0, s, np.where(exponent > s * -256.0, far, near))
    return _away(s * LN_2), certain


def exp(x: Array) -> tuple[Array, Mask]:
    """EXP, for arguments between -60 and 60."""
    certain = np.abs(x) < 60.0
    whole = np.floor(_away(x * LOG2_E)) + 1.0
    s = _away(whole * LN_2) - x
    exact = nearest(s) == s
    certain &= exact | ((x > 2.0**-7) & (x < 1.0))
    s = np.where(exact, s, _away(s))
    certain &= (s > 2.0**-16) & (s < 0.693)
    power = np.ldexp(1.0, np.where(certain, whole, 0.0).astype(np.int64))
    return _polynomial(s, EXP) * power, certain


def sqr(x: Array) -> tuple[Array, Mask]:
    """SQR, for the arguments of `log`."""
    logarithm, certain = log(x)
    result, sure = exp(logarithm * 0.5)
    return result, certain & sure


def power(exponent: float) -> Function:
    """`[` with one exponent, for the bases of `log`, and their negatives if it is whole."""

    def of(base: Array) -> tuple[Array, Mask]:
        logarithm, certain = log(np.abs(base))
        product = logarithm * exponent
        result, sure = exp(_away(product))
        certain &= sure & (np.abs(product) > 1e-30)
        if exponent % 1.0:
            certain &= base > 0.0
        return np.copysign(result, base) if exponent % 2.0 else result, certain

    return of


FUNCTIONS: Final[dict[str, Function]] = {
    "sin": sin,
    "cos": cos,
    "atn": atn,
    "log": log,
    "exp": exp,
    "sqr": sqr,
    **{name: power(exponent) for exponent, name in OF_ONE_EXPONENT.items()},
}
"""By the names that generated text has for them."""
