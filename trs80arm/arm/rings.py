"""Rings around the base's axis: how far the arm is from things wherever the base turns.

Whatever turns with the base stays within a ring: from where to where outwards, and how high. Two
solids are at least as far apart as their rings are, however far the base has turned meanwhile.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from trs80arm.arm.contact.manifold import Placed
from trs80arm.arm.shapes import Vector, length, minus, plus

SLICES = 4
"""Pieces that something long is cut into, for a ring around the whole of it would be too wide."""


@dataclass(frozen=True, slots=True)
class Ring:
    """What is somewhere around the base's axis.

    Attributes:
        near, far: from where to where outwards, inches; `near` is negative behind the axis.
        low, high: heights, inches.
    """

    near: float
    far: float
    low: float
    high: float

    def apart(self, other: Ring) -> float:
        """Inches between two rings at least."""
        out = max(self.near - other.far, other.near - self.far, 0.0)
        up = max(self.low - other.high, other.low - self.high, 0.0)
        return math.sqrt(out * out + up * up)


def around(solid: Placed) -> Ring:
    """A solid, somewhere around the axis."""
    (a, b, c), (d, e, f) = solid.low, solid.high
    out = length((a + d) / 2, (b + e) / 2)
    reach = length(d - a, e - b) / 2
    return Ring(out - reach, out + reach, c, f)


def link_slices(solid: Placed, c: float, s: float) -> list[Ring]:
    """A link's box cut across, each slice turned with the base.

    Args:
        solid: the box.
        c: cosine of the way that the base points.
        s: its sine.
    """
    v = solid.vertices
    pairs = [(v[i], minus(v[k], v[i])) for i, k in ((0, 1), (3, 2), (4, 5), (7, 6))]
    cuts = [[plus(start, way, k / SLICES) for start, way in pairs] for k in range(SLICES + 1)]
    return [_swept([*one, *other], c, s) for one, other in pairwise(cuts)]


def rolled_slices(
    start: Vector, way: Vector, ahead: float, aside: float, c: float, s: float
) -> list[Ring]:
    """Something long cut across, turned with the base, and rolled about its own axis anyhow.

    Args:
        start: of its axis.
        way: in which the axis goes, of length 1.
        ahead: inches that it goes.
        aside: inches from the axis to the farthest of it.
        c: cosine of the way that the base points.
        s: its sine.
    """
    level, steep = length(way[0], way[1]) * aside, abs(way[2]) * aside
    ends = [plus(start, way, ahead * k / SLICES) for k in range(SLICES + 1)]
    rings = []
    for one, other in pairwise(ends):
        outs = [x * c + y * s for x, y, _ in (one, other)]
        rings.append(
            Ring(
                min(outs) - steep,
                length(max(abs(out) for out in outs) + steep, aside),
                min(one[2], other[2]) - level,
                max(one[2], other[2]) + level,
            )
        )
    return rings


def _swept(corners: Sequence[Vector], c: float, s: float) -> Ring:
    """What is between some corners, turned with the base from where it points to c, s."""
    ahead = min(x * c + y * s for x, y, _ in corners)
    far = max(length(x, y) for x, y, _ in corners)
    heights = [z for _, _, z in corners]
    return Ring(ahead, far, min(heights), max(heights))
