"""Strip charts: a quantity over time, as rows of text."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

_BRAILLE = 0x2800
_DOTS = np.array([[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]])
"""The bit of each dot of a cell: four rows of two (Unicode, braille patterns)."""
_ASCII = {(False, False): " ", (True, False): "'", (False, True): ".", (True, True): ":"}


def fineness(*, ascii: bool) -> tuple[int, int]:
    """How many points a cell of a strip has across and down."""
    return (1, 2) if ascii else (2, 4)


def strip(
    values: npt.NDArray[np.float64], low: float, high: float, height: int, *, ascii: bool
) -> list[str]:
    """A line through values.

    Args:
        values: as many for a column as `fineness` says; NaN leaves a gap.
        low: what is at the lower edge.
        high: what is at the upper edge.
        height: rows.
        ascii: whether it is drawn in `'.:` instead of braille dots.
    """
    across, down = fineness(ascii=ascii)
    points = height * down
    span = high - low or 1.0
    known = np.isfinite(values)
    share = np.where(known, (high - np.where(known, values, low)) / span, 0.0)
    places = np.clip(np.round(share * (points - 1)), 0, points - 1).astype(np.int64)
    # From one point to the next the line goes all the way up or down.
    before = np.concatenate((places[:1], places[:-1]))
    joined = known & np.concatenate((known[:1], known[:-1]))
    first = np.where(joined, np.minimum(places, before + np.sign(places - before)), places)
    last = np.where(joined, np.maximum(places, before + np.sign(places - before)), places)
    rows = np.arange(points)[:, None]
    lit = known & (rows >= first) & (rows <= last)
    cells = lit.reshape(height, down, -1, across).transpose(0, 2, 1, 3)
    if ascii:
        return ["".join(_ASCII[bool(a), bool(b)] for [a], [b] in row) for row in cells]
    codes = (cells * _DOTS).sum((2, 3))
    return ["".join(chr(_BRAILLE + code) if code else " " for code in row) for row in codes]
