"""From the arm's units, inches and ounces, to those of the formats, metres and kilograms."""

from __future__ import annotations

from collections.abc import Iterable

METRES = 0.0254
"""In an inch."""
KILOGRAMS = 0.028349523125
"""In an ounce."""
GRAVITY = 9.80665
"""Metres per second squared, by which a weight in ounces is a force."""
NEWTONS = KILOGRAMS * GRAVITY
"""In an ounce of force."""
JOULES = NEWTONS * METRES
"""In an ounce-inch; newton-metres as well."""
INERTIA = KILOGRAMS * METRES**2
"""Kilogram square metres in an ounce square inch."""
_NOTHING = 1e-15


def number(value: float) -> str:
    """A number as the files have it: twelve digits, a hundred-thousandth of a nanoinch."""
    return f"{0.0 if abs(value) < _NOTHING else value:.12g}"


def numbers(values: Iterable[float], unit: float = 1.0) -> str:
    """Numbers with blanks between.

    Args:
        values: in the arm's unit.
        unit: how many of the file's that is.
    """
    return " ".join(number(value * unit) for value in values)
