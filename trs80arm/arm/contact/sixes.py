"""Six numbers for each thing that moves: velocity and spin, or rates; an impulse and its moment."""

from __future__ import annotations

from collections.abc import Sequence

Six = tuple[float, float, float, float, float, float]
"""Numbers of one thing."""

STILL: Six = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
"""No motion, or no impulse."""


def six(values: Sequence[float]) -> Six:
    """Six numbers as a tuple of six."""
    a, b, c, d, e, f = values
    return a, b, c, d, e, f


def negative(sixes: Sequence[Sequence[float]]) -> list[Six]:
    """All of them with the other sign."""
    return [(-a, -b, -c, -d, -e, -f) for a, b, c, d, e, f in sixes]


def plus(sixes: Sequence[Six], others: Sequence[Six], factor: float = 1.0) -> list[Six]:
    """Their sum, of the others by some factor."""
    return [
        (
            a + factor * u,
            b + factor * v,
            c + factor * w,
            d + factor * x,
            e + factor * y,
            f + factor * z,
        )
        for (a, b, c, d, e, f), (u, v, w, x, y, z) in zip(sixes, others, strict=True)
    ]


def product(sixes: Sequence[Sequence[float]], others: Sequence[Six]) -> float:
    """The scalar product over all things."""
    total = 0.0
    for (a, b, c, d, e, f), (u, v, w, x, y, z) in zip(sixes, others, strict=True):
        total += a * u + b * v + c * w + d * x + e * y + f * z
    return total


def greatest(sixes: Sequence[Six]) -> float:
    """The greatest absolute value of all."""
    return max([max(max(each), -min(each)) for each in sixes])
