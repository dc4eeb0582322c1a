"""What the arm with its load sweeps over on its way: boxes, for whole ranges of its joints.

Out from the base's axis, aside, and up: the base turns that plane, and all else moves in it or
across it. So a few sums say whether anything of the bench can come near, however the joints go
within their ranges. For bounds only, which decide nothing by themselves: the sines are the C
library's.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from trs80arm.arm.contact.bodies import Body
from trs80arm.arm.contact.manifold import Placed
from trs80arm.arm.contact.rotations import apply
from trs80arm.arm.linkage import FINGERS
from trs80arm.arm.model import ArmModel, Link
from trs80arm.arm.shapes import Vector, plus

Span = tuple[float, float]
"""From where to where: inches, radians."""


@dataclass(frozen=True, slots=True)
class Ranges:
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


class Extents:
    """The boxes that make up an arm and its load, each along the axes of what it is part of.

    Args:
        model: of the arm.
        names: of its solids.
        loads: what rests in its hand.
    """

    def __init__(self, model: ArmModel, names: Sequence[str], loads: Sequence[Body]) -> None:
        self.model = model
        self.pieces: list[tuple[str, Link, Span, Span, Span]] = []
        for name, solid in zip(names, model.solids, strict=True):
            x, y, z = [
                (at - half, at + half) for at, half in zip(solid.center, solid.half, strict=True)
            ]
            if solid.link in FINGERS:
                x = x[0] + model.hand_length, x[1] + model.hand_length
            self.pieces.append((name, solid.link, x, y, z))
        self.pieces += [("", Link.HAND, *_around_load(load)) for load in loads]


def _around_load(load: Body) -> tuple[Span, Span, Span]:
    """The box around a load, along the hand's own axes."""
    assert load.carried is not None
    place, turn = load.carried
    corners = [
        plus(place, apply(turn, corner)) for solid in load.shape.solids for corner in solid.vertices
    ]
    x, y, z = zip(*corners, strict=True)
    return (min(x), max(x)), (min(y), max(y)), (min(z), max(z))


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
        # Of each solid the name; how near the base's axis it comes, and how far; how low, and how
        # high; and from where to where it goes out, and aside, as seen with the base in the middle
        # of its way.
        self._swept = []
        for name, (a, b), (d, e), (low, high) in _swept(extents, ranges):
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
        *_, a, b, d, e = zip(*self._swept, strict=True)
        x, y = _rotated((min(a), max(b)), (min(d), max(e)), self._cosine, self._sine)
        return (
            (x[0] - margin, y[0] - margin, self.low - margin),
            (x[1] + margin, y[1] + margin, self._high + margin),
        )

    def clear_of(self, solid: Placed, passes: Sequence[str], gap: float) -> bool:
        """Whether nothing of it comes nearer to a solid that stands than a gap.

        Args:
            solid: in the world.
            passes: names of the links that do not matter.
            gap: inches.
        """
        (x0, y0, z0), (x1, y1, z1) = solid.low, solid.high
        z0, z1 = z0 - gap, z1 + gap
        if z0 > self._high or z1 < self.low:
            return True
        out, reach = math.hypot((x0 + x1) / 2, (y0 + y1) / 2), math.hypot(x1 - x0, y1 - y0) / 2
        near, far = out - reach - gap, out + reach + gap
        if near > self._far:
            return True
        c, s = self._cosine, self._sine
        corners = solid.vertices
        outs = [x * c + y * s for x, y, _ in corners]
        sides = [y * c - x * s for x, y, _ in corners]
        out0, out1, side0, side1 = min(outs), max(outs), min(sides), max(sides)
        out0, out1, side0, side1 = out0 - gap, out1 + gap, side0 - gap, side1 + gap
        for name, nearest, farthest, low, high, a, b, d, e in self._swept:
            if (
                z0 <= high
                and z1 >= low
                and near <= farthest
                and far >= nearest
                and out0 <= b
                and out1 >= a
                and side0 <= e
                and side1 >= d
                and name not in passes
            ):
                return False
        return True


def _swept(extents: Extents, ranges: Ranges) -> Iterator[tuple[str, Span, Span, Span]]:
    """Of each solid the name, and from where to where it goes: out from the base, aside, up."""
    model = extents.model
    link, height = (model.link, model.link), model.shoulder_height
    shoulder, elbow = _Turn(ranges.shoulder), _Turn(ranges.elbow)
    pitch, roll = _Turn(ranges.pitch), _Turn(ranges.roll)
    (a, b), (d, e) = shoulder.of(link, _NOUGHT)
    bend = a, b, d + height, e + height
    (u, v), (w, x) = elbow.of(link, _NOUGHT)
    wrist = a + u, b + v, bend[2] + w, bend[3] + x
    shut, wide = ranges.opening[0] / 2, ranges.opening[1] / 2
    left, right = FINGERS
    for name, piece, along, aside, above in extents.pieces:
        if piece is Link.UPPER_ARM:
            (a, b), (d, e) = shoulder.of(along, above)
            yield name, (a, b), aside, (d + height, e + height)
            continue
        if piece is Link.FOREARM:
            (a, b), (d, e) = elbow.of(along, above)
            start = bend
        else:
            if piece is left:
                aside = aside[0] + shut, aside[1] + wide
            elif piece is right:
                aside = aside[0] - wide, aside[1] - shut
            aside, above = roll.of(aside, above)
            (a, b), (d, e) = pitch.of(along, above)
            start = wrist
        yield name, (a + start[0], b + start[1]), aside, (d + start[2], e + start[3])


_NOUGHT = (0.0, 0.0)


class _Turn:
    """A turn by some angle of a range.

    Args:
        span: radians.
    """

    __slots__ = ("_bulge", "_high", "_low")

    def __init__(self, span: Span) -> None:
        low, high = span
        self._low = self._high = math.cos(low), math.sin(low)
        self._bulge = 0.0
        if high > low:
            self._high = math.cos(high), math.sin(high)
            # An arc goes beyond its chord by so much of its radius at most.
            self._bulge = 1 - math.cos(min(math.pi, (high - low) / 2))

    def of(self, x: Span, y: Span) -> tuple[Span, Span]:
        """A box, turned about where x and y are 0: what it sweeps over."""
        one = _rotated(x, y, *self._low)
        if self._bulge == 0.0:
            return one
        ((a, b), (d, e)), ((u, v), (w, z)) = one, _rotated(x, y, *self._high)
        out = self._bulge * math.hypot(max(-x[0], x[1]), max(-y[0], y[1]))
        return (
            ((a if a < u else u) - out, (b if b > v else v) + out),
            ((d if d < w else w) - out, (e if e > z else z) + out),
        )


def _rotated(x: Span, y: Span, c: float, s: float) -> tuple[Span, Span]:
    """The upright box around a box that was turned."""
    (x0, x1), (y0, y1) = x, y
    a, b, d, e = (x0 + x1) / 2, (x1 - x0) / 2, (y0 + y1) / 2, (y1 - y0) / 2
    across, along = c * a - s * d, s * a + c * d
    if c < 0.0:
        c = -c
    if s < 0.0:
        s = -s
    wide, long = c * b + s * e, s * b + c * e
    return (across - wide, across + wide), (along - long, along + long)
