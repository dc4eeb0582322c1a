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


def _usual(first: str) -> str:
    """Text that is true where a result is neither zero nor near the ends of the range.

    Args:
        first: text that gives the result and keeps it as `s`.
    """
    return f"({_LEAST} < {first} < {_MOST} or -{_MOST} < s < -{_LEAST})"


def sum_(first: str, sign: str, second: str, otherwise: str) -> str:
    """Text of a sum (`+`) or difference (`-`) of two operands, or `otherwise`."""
    exact = f"(c := (s := {first} {sign} {second}) * {SPLIT}) - (c - s) == s"
    return f"(s if {exact} and {_usual('s')} else {otherwise})"


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
