"""Arithmetic on singles written in line: the Python result is taken where it is the machine's.

`s * SPLIT` parts a result into its upper 24 bits and the rest. A sum is taken when there is no
rest; a product or quotient is rounded, a hair away from zero before, because halves are rounded up.
Near the ends of the range, and for zero, the routine of `numbers.single` is called.
"""

from __future__ import annotations

from typing import Final

SPLIT: Final = 2.0**29 + 1.0
AWAY: Final = 1.0 + 2.0**-52
_LEAST: Final = 1e-37
_MOST: Final = 1e37
_FAR: Final = 256.0
"""How many times as large one operand of unlike signs may be as the other (`single.add`)."""
NEAR_LEAST: Final = 1e-30
NEAR_MOST: Final = 1e30


def is_near(value: float) -> bool:
    """Whether a sum with this operand cannot be beyond the ends of the range if it has no rest.

    It is a whole number of last places of the operand or of the other, and it does not reach the
    last place of a number near the upper end.
    """
    return NEAR_LEAST <= abs(value) <= NEAR_MOST


def _usual(first: str) -> str:
    """Text that is true where a result is neither zero nor near the ends of the range.

    Args:
        first: text that gives the result and keeps it as `s`.
    """
    return f"({_LEAST} < {first} < {_MOST} or -{_MOST} < s < -{_LEAST})"


def _exact(first: str, sign: str, second: str) -> str:
    """Text that is true where a sum, kept as `s`, has no more than 24 bits; `s` stands last."""
    return f"(c := (s := {first} {sign} {second}) * {SPLIT}) - (c - s) == s"


def sum_(first: str, sign: str, second: str, otherwise: str, *, near: bool = False) -> str:
    """Text of a sum (`+`) or difference (`-`) of two operands, or `otherwise`.

    Args:
        first: the left operand.
        sign: `+` or `-`.
        second: the right operand.
        otherwise: the call for results that are not usual.
        near: one operand is known to be of usual size, so that a sum without a rest is usual too.
    """
    exact = _exact(first, sign, second)
    test = exact if near else f"{exact} and {_usual('s')}"
    return f"(s if {test} else {otherwise})"


def rounded_sum(
    first: str, sign: str, second: str, again: tuple[str, str], otherwise: str, *, near: bool
) -> str:
    """The same where a sum is likely to have a rest: it is rounded here too.

    Args:
        first: the left operand.
        sign: `+` or `-`.
        second: the right operand.
        again: text that gives the two operands again.
        otherwise: the call for results that are not usual, and for operands of unlike signs that
            are far apart.
        near: as in `sum_`.
    """
    exact = _exact(first, sign, second)
    test = exact if near else f"{exact} and {_usual('s')}"
    # A sum without a rest that is not usual goes the other way: it may be 0, and so the divisor.
    ratio = f"(c := {again[0]} / {again[1]})"
    alike, apart = ("> 0.0", f"-{_FAR} <= c <= -{1 / _FAR}")
    if sign == "-":
        alike, apart = ("< 0.0", f"{1 / _FAR} <= c <= {_FAR}")
    certain = f"{_usual('s')} and ({ratio} {alike} or {apart})"
    rounded = f"(c := (s := s * {AWAY}) * {SPLIT}) - (c - s)"
    return f"(s if {test} else {rounded} if {certain} else {otherwise})"


def short_step(value: str, step: str) -> str:
    """Text of the beginning of a comparison, true only where a sum has no rest; it is kept as `s`.

    The step must be of usual size (`is_near`).
    """
    return _exact(value, "+", step)


def product(first: str, sign: str, second: str, otherwise: str, guard: str = "") -> str:
    """Text of a product (`*`) or quotient (`/`) of two operands, or `otherwise`.

    Args:
        first: the left operand.
        sign: `*` or `/`.
        second: the right operand.
        otherwise: the call for results that are not usual.
        guard: what must be true before it may be computed, with its ` and `.
    """
    usual = _usual(f"(s := {first} {sign} {second} * {AWAY})")
    return f"((c := s * {SPLIT}) - (c - s) if {guard}{usual} else {otherwise})"
