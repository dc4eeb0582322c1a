"""What the arm with its load sweeps over on its way: boxes, for whole ranges of its joints.

Out from the base's axis, aside, and up: the base turns that plane, and all else moves in it or
across it. So a few sums say whether anything of the bench can come near, however the joints go
within their ranges. For bounds only, which decide nothing by themselves: the sines are the C
library's.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from trs80arm.arm.contact.bodies import Body
from trs80arm.arm.contact.manifold import Placed
from trs80arm.arm.contact.recurrence import question
from trs80arm.arm.contact.rotations import apply
from trs80arm.arm.linkage import FINGERS
from trs80arm.arm.model import ArmModel, Link
from trs80arm.arm.shapes import Vector, plus

Span = tuple[float, float]
"""From where to where: inches, radians."""


class Ranges(NamedTuple):
    """Between what the joints are on the way: radians, and inches of the opening."""

    base: Span
    shoulder: Span
    elbow: Span
    pitch: Span
    roll: Span
    opening: Span

    def within(self, other: Ranges) -> bool:
        """Whether other ranges hold all of these."""
        return (
            other.base[0] <= self.base[0]
            and self.base[1] <= other.base[1]
            and other.shoulder[0] <= self.shoulder[0]
            and self.shoulder[1] <= other.shoulder[1]
            and other.elbow[0] <= self.elbow[0]
            and self.elbow[1] <= other.elbow[1]
            and other.pitch[0] <= self.pitch[0]
            and self.pitch[1] <= other.pitch[1]
            and other.roll[0] <= self.roll[0]
            and self.roll[1] <= other.roll[1]
            and other.opening[0] <= self.opening[0]
            and self.opening[1] <= other.opening[1]
        )

    def hold(self, joints: Sequence[float]) -> bool:
        """Whether a place is within them.

        Args:
            joints: the arm's six coordinates.
        """
        base, shoulder, elbow, left, right, opening = joints
        return (
            self.base[0] <= base <= self.base[1]
            and self.shoulder[0] <= shoulder <= self.shoulder[1]
            and self.elbow[0] <= elbow <= self.elbow[1]
            and self.pitch[0] <= (left + right) / 2 <= self.pitch[1]
            and self.roll[0] <= (left - right) / 2 <= self.roll[1]
            and self.opening[0] <= opening <= self.opening[1]
        )

    @property
    def numbers(self) -> tuple[Span, ...]:
        """All of them."""
        return self.base, self.shoulder, self.elbow, self.pitch, self.roll, self.opening

    @classmethod
    def about(cls, joints: Sequence[float], by: float) -> Ranges:
        """One place, and what is about it.

        Args:
            joints: the arm's six coordinates.
            by: radians, and inches of the opening, to either side.
        """
        base, shoulder, elbow, left, right, opening = joints
        pitch, roll = (left + right) / 2, (left - right) / 2
        return cls(
            (base - by, base + by),
            (shoulder - by, shoulder + by),
            (elbow - by, elbow + by),
            (pitch - by, pitch + by),
            (roll - by, roll + by),
            (opening - by, opening + by),
        )

    @classmethod
    def among(cls, places: Sequence[Sequence[float]]) -> Ranges:
        """Some places, the arm's six coordinates each."""
        base, shoulder, elbow, left, right, opening = zip(*places, strict=True)
        pitch = [(a + b) / 2 for a, b in zip(left, right, strict=True)]
        roll = [(a - b) / 2 for a, b in zip(left, right, strict=True)]
        return cls(
            (min(base), max(base)),
            (min(shoulder), max(shoulder)),
            (min(elbow), max(elbow)),
            (min(pitch), max(pitch)),
            (min(roll), max(roll)),
            (min(opening), max(opening)),
        )

    @classmethod
    def of(cls, joints: npt.NDArray[np.float64]) -> Ranges:
        """Some places.

        Args:
            joints: the arm's six coordinates, 6 x places.
        """
        base, shoulder, elbow, left, right, opening = joints
        six = np.array((base, shoulder, elbow, (left + right) / 2, (left - right) / 2, opening))
        lows, highs = six.min(axis=1).tolist(), six.max(axis=1).tolist()
        one, two, three, four, five, last = zip(lows, highs, strict=True)
        return cls(one, two, three, four, five, last)


Piece = tuple[str, Link, float, float, float, float, float, float]
"""A box of the arm: the solid's name, its link, and from where to where it goes along the link's
axes, in inches: ahead, aside and up."""


class Extents:
    """The boxes that make up an arm and its load, each along the axes of what it is part of.

    Args:
        model: of the arm.
        names: of its solids.
        loads: what rests in its hand.

    Attributes:
        model: of the arm.
        pieces: the boxes; one for each of the arm's solids, and one for each load.
        key: the same for the same boxes of a load.
    """

    def __init__(self, model: ArmModel, names: Sequence[str], loads: Sequence[Body]) -> None:
        self.model = model
        self.pieces: list[Piece] = []
        for name, solid in zip(names, model.solids, strict=True):
            (x, y, z), (a, b, c) = solid.center, solid.half
            if solid.link in FINGERS:
                x += model.hand_length
            self.pieces.append((name, solid.link, x - a, x + a, y - b, y + b, z - c, z + c))
        boxes = [_around_load(load) for load in loads]
        self.pieces += [("", Link.HAND, *box) for box in boxes]
        self.key = question(boxes)


def _around_load(load: Body) -> tuple[float, float, float, float, float, float]:
    """The box around a load, along the hand's own axes."""
    assert load.carried is not None
    place, turn = load.carried
    corners = [
        plus(place, apply(turn, corner)) for solid in load.shape.solids for corner in solid.vertices
    ]
    x, y, z = zip(*corners, strict=True)
    return min(x), max(x), min(y), max(y), min(z), max(z)


class Sweep:
    """What an arm with its load sweeps over.

    Args:
        extents: of arm and load.
        ranges: of the joints.
    """

    def __init__(self, extents: Extents, ranges: Ranges) -> None:
        low, high = ranges.base
        middle, half = (low + high) / 2, (high - low) / 2
        self._cosine, self._sine = math.cos(middle), math.sin(middle)
        turned, back = math.sin(min(half, math.pi / 2)), 1 - math.cos(min(half, math.pi))
        # Of each piece the name; how near the base's axis it comes, and how far; how low, and how
        # high; and from where to where it goes out, and aside, as seen with the base in the middle
        # of its way.
        self._swept = []
        for name, a, b, d, e, low, high in _swept(extents, ranges):
            ahead, aside = (b if b > -a else -a), (e if e > -d else -d)
            far = math.sqrt(ahead * ahead + aside * aside)
            wider, broader = aside * turned + ahead * back, ahead * turned + aside * back
            self._swept.append(
                (name, a, far, low, high, a - wider, b + wider, d - broader, e + broader)
            )
        _, _, fars, lows, highs, *_ = zip(*self._swept, strict=True)
        self.low, self._high, self._far = min(lows), max(highs), max(fars)

    def around(self, margin: float) -> tuple[Vector, Vector]:
        """An upright box around all of it: least and greatest x, y, z.

        Args:
            margin: inches by which it is wider.
        """
        *_, lefts, rights, nears, fars = zip(*self._swept, strict=True)
        a, b, d, e = min(lefts), max(rights), min(nears), max(fars)
        c, s = self._cosine, self._sine
        x0, x1, y0, y1 = _turned((c, s, c, s, 0.0), a, b, d, e)
        return (
            (x0 - margin, y0 - margin, self.low - margin),
            (x1 + margin, y1 + margin, self._high + margin),
        )

    def pieces_below(self, height: float) -> list[int]:
        """Which pieces may come below a height."""
        if self.low >= height:
            return []
        return [number for number, (_, _, _, low, *_) in enumerate(self._swept) if low < height]

    def pieces_near(self, solid: Placed, passes: Sequence[str], gap: float) -> list[int]:
        """Which pieces may come nearer to a solid that stands than a gap, by number.

        Args:
            solid: in the world.
            passes: names of the links that do not matter.
            gap: inches.
        """
        (x0, y0, z0), (x1, y1, z1) = solid.low, solid.high
        z0, z1 = z0 - gap, z1 + gap
        if z0 > self._high or z1 < self.low:
            return []
        out, reach = math.hypot((x0 + x1) / 2, (y0 + y1) / 2), math.hypot(x1 - x0, y1 - y0) / 2
        near, far = out - reach - gap, out + reach + gap
        if near > self._far:
            return []
        about = [
            (number, piece)
            for number, piece in enumerate(self._swept)
            if z0 <= piece[4]
            and z1 >= piece[3]
            and near <= piece[2]
            and far >= piece[1]
            and piece[0] not in passes
        ]
        if not about:
            return []
        c, s = self._cosine, self._sine
        corners = solid.vertices
        outs = [x * c + y * s for x, y, _ in corners]
        sides = [y * c - x * s for x, y, _ in corners]
        out0, out1, side0, side1 = min(outs), max(outs), min(sides), max(sides)
        out0, out1, side0, side1 = out0 - gap, out1 + gap, side0 - gap, side1 + gap
        return [
            number
            for number, (*_, a, b, d, e) in about
            if out0 <= b and out1 >= a and side0 <= e and side1 >= d
        ]


_Swept = tuple[str, float, float, float, float, float, float]
_Turn = tuple[float, float, float, float, float]
"""Cosine and sine at the beginning of a turn, the same at its end, and by how much of its radius
an arc goes beyond its chord at most."""


def _swept(extents: Extents, ranges: Ranges) -> list[_Swept]:
    """Of each piece the name, and from where to where it goes: out from the base, aside, up."""
    model = extents.model
    link, height = model.link, model.shoulder_height
    shoulder, elbow = _turn(*ranges.shoulder), _turn(*ranges.elbow)
    pitch, roll = _turn(*ranges.pitch), _turn(*ranges.roll)
    # Where the elbow and the wrist are: out, and up.
    x0, x1, z0, z1 = _turned(shoulder, link, link, 0.0, 0.0)
    x2, x3, z2, z3 = _turned(elbow, link, link, 0.0, 0.0)
    z0, z1 = z0 + height, z1 + height
    x2, x3, z2, z3 = x0 + x2, x1 + x3, z0 + z2, z1 + z3
    shut, wide = ranges.opening[0] / 2, ranges.opening[1] / 2
    left, right = FINGERS
    found: list[_Swept] = []
    for name, piece, a, b, d, e, low, high in extents.pieces:
        if piece is Link.UPPER_ARM:
            a, b, low, high = _turned(shoulder, a, b, low, high)
            found.append((name, a, b, d, e, low + height, high + height))
        elif piece is Link.FOREARM:
            a, b, low, high = _turned(elbow, a, b, low, high)
            found.append((name, a + x0, b + x1, d, e, low + z0, high + z1))
        else:
            if piece is left:
                d, e = d + shut, e + wide
            elif piece is right:
                d, e = d - wide, e - shut
            d, e, low, high = _turned(roll, d, e, low, high)
            a, b, low, high = _turned(pitch, a, b, low, high)
            found.append((name, a + x2, b + x3, d, e, low + z2, high + z3))
    return found


def _turn(low: float, high: float | None = None) -> _Turn:
    """A turn by some angle of a range (radians), or by one."""
    c, s = math.cos(low), math.sin(low)
    if high is None or high <= low:
        return c, s, c, s, 0.0
    return c, s, math.cos(high), math.sin(high), 1 - math.cos(min(math.pi, (high - low) / 2))


def _turned(
    turn: _Turn, x0: float, x1: float, y0: float, y1: float
) -> tuple[float, float, float, float]:
    """A box, turned about where x and y are 0: what it sweeps over."""
    c, s, cosine, sine, bulge = turn
    x, y, wide, high = (x0 + x1) / 2, (y0 + y1) / 2, (x1 - x0) / 2, (y1 - y0) / 2
    p, q = c * x - s * y, s * x + c * y
    c, s = (c if c > 0.0 else -c), (s if s > 0.0 else -s)
    h, k = c * wide + s * high, s * wide + c * high
    a, b, d, e = p - h, p + h, q - k, q + k
    if bulge == 0.0:
        return a, b, d, e
    p, q = cosine * x - sine * y, sine * x + cosine * y
    c, s = (cosine if cosine > 0.0 else -cosine), (sine if sine > 0.0 else -sine)
    h, k = c * wide + s * high, s * wide + c * high
    out = bulge * math.hypot(x1 if x1 > -x0 else -x0, y1 if y1 > -y0 else -y0)
    u, v, w, z = p - h, p + h, q - k, q + k
    return (
        (a if a < u else u) - out,
        (b if b > v else v) + out,
        (d if d < w else w) - out,
        (e if e > z else z) + out,
    )


def fingertip_out(model: ArmModel, ranges: Ranges) -> Span:
    """How far out from the base's axis the fingertip is, from the least to the greatest, inches."""
    near = far = 0.0
    lengths = (model.link, model.link, model.hand_length)
    for length, span in zip(lengths, (ranges.shoulder, ranges.elbow, ranges.pitch), strict=True):
        a, b, _, _ = _turned(_turn(*span), length, length, 0.0, 0.0)
        near, far = near + a, far + b
    return near, far
