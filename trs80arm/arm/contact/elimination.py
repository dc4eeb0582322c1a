"""Symmetric systems of six unknowns a body, most of which are not coupled to most others.

Gauss's elimination a body at a time, in the form L D Lᵀ, on plain floats: of a row of bodies each
is coupled to the next alone, and what is not coupled costs nothing. Each sum is written out, so
that its order is the same everywhere; for six numbers that is also quicker than arrays.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from trs80arm.arm.contact.sixes import STILL, Six

Triangle = Sequence[float]
"""A symmetric 6 x 6 matrix: the 21 numbers on and below its diagonal, row by row."""
Columns = Sequence[Six]
"""A 6 x 6 matrix, column by column."""
_Step = tuple[int, Triangle, list[tuple[int, list[Six]]]]
"""Of the elimination: a body, its factor, and what couples it to each of those that come later."""


def order(count: int, pairs: set[tuple[int, int]]) -> list[int]:
    """Bodies in the order in which to eliminate them: first those coupled to the fewest others.

    Args:
        count: of bodies.
        pairs: of bodies that are coupled.
    """
    if not pairs:
        return list(range(count))
    beside: list[set[int]] = [set() for _ in range(count)]
    for one, other in pairs:
        beside[one].add(other)
        beside[other].add(one)
    left = set(range(count))
    out = []
    while left:
        body = min(left, key=lambda one: (len(beside[one]), one))
        left.remove(body)
        out.append(body)
        around = beside[body]
        for one in around:
            # Whatever it is coupled to is coupled through it.
            beside[one] |= around
            beside[one] -= {one, body}
    return out


class Eliminated:
    """A positive definite system, ready to be solved for any right-hand side.

    Args:
        blocks: of each body's own unknowns; they are used up.
        beside: what couples a body to a later one, by both in the order of elimination: rows of the
            earlier, columns of the later one's unknowns.
        sequence: bodies in the order of elimination.
    """

    def __init__(
        self,
        blocks: list[list[float]],
        beside: Mapping[tuple[int, int], Columns],
        sequence: Sequence[int],
    ) -> None:
        coupled: list[dict[int, Columns]] = [{} for _ in sequence]
        for (one, other), columns in beside.items():
            coupled[one][other] = columns
        self._steps: list[_Step] = []
        for body in sequence:
            factor, mine = _factor(blocks[body]), coupled[body]
            others: Iterable[int] = mine
            if len(mine) > 1:
                others = sorted(mine, key=sequence.index)
            ahead = [(other, *_reduced(factor, mine[other])) for other in others]
            for i, (other, half, whole) in enumerate(ahead):
                _subtract_own(blocks[other], half, whole)
                for third, _, theirs in ahead[i + 1 :]:
                    between = coupled[other].get(third)
                    coupled[other][third] = _less(between, half, theirs)
            self._steps.append((body, factor, [(other, whole) for other, _, whole in ahead]))

    def solve(self, right: Sequence[Sequence[float]]) -> list[Six]:
        """Unknowns of each body.

        Args:
            right: right-hand sides, six a body.
        """
        rest = [list(six) for six in right]
        scaled: list[tuple[_Step, Six]] = []
        for step in self._steps:
            body, factor, ahead = step
            a, b, c, d, e, f = half = _forward(factor, rest[body])
            for other, whole in ahead:
                theirs = rest[other]
                for p, (u, v, w, x, y, z) in enumerate(whole):
                    theirs[p] -= a * u + b * v + c * w + d * x + e * y + f * z
            scaled.append((step, _scaled(factor, half)))
        out: list[Six] = [STILL] * len(rest)
        for (body, factor, ahead), (a, b, c, d, e, f) in reversed(scaled):
            for other, whole in ahead:
                for value, (u, v, w, x, y, z) in zip(out[other], whole, strict=True):
                    a -= value * u
                    b -= value * v
                    c -= value * w
                    d -= value * x
                    e -= value * y
                    f -= value * z
            out[body] = _backward(factor, (a, b, c, d, e, f))
        return out


def _factor(block: Sequence[float]) -> Triangle:
    """L below the diagonal and the inverse of D on it."""
    a00, a10, a11, a20, a21, a22, a30, a31, a32, a33, a40, a41, a42, a43, a44 = block[:15]
    a50, a51, a52, a53, a54, a55 = block[15:]
    i0 = 1 / a00
    l10, l20, l30, l40, l50 = a10 * i0, a20 * i0, a30 * i0, a40 * i0, a50 * i0
    i1 = 1 / (a11 - l10 * a10)
    u21, u31 = a21 - l20 * a10, a31 - l30 * a10
    u41, u51 = a41 - l40 * a10, a51 - l50 * a10
    l21, l31, l41, l51 = u21 * i1, u31 * i1, u41 * i1, u51 * i1
    i2 = 1 / (a22 - l20 * a20 - l21 * u21)
    u32 = a32 - l30 * a20 - l31 * u21
    u42 = a42 - l40 * a20 - l41 * u21
    u52 = a52 - l50 * a20 - l51 * u21
    l32, l42, l52 = u32 * i2, u42 * i2, u52 * i2
    i3 = 1 / (a33 - l30 * a30 - l31 * u31 - l32 * u32)
    u43 = a43 - l40 * a30 - l41 * u31 - l42 * u32
    u53 = a53 - l50 * a30 - l51 * u31 - l52 * u32
    l43, l53 = u43 * i3, u53 * i3
    i4 = 1 / (a44 - l40 * a40 - l41 * u41 - l42 * u42 - l43 * u43)
    u54 = a54 - l50 * a40 - l51 * u41 - l52 * u42 - l53 * u43
    l54 = u54 * i4
    i5 = 1 / (a55 - l50 * a50 - l51 * u51 - l52 * u52 - l53 * u53 - l54 * u54)
    return (
        *(i0, l10, i1, l20, l21, i2, l30, l31, l32, i3, l40, l41, l42, l43, i4),
        *(l50, l51, l52, l53, l54, i5),
    )


def _forward(factor: Triangle, right: Sequence[float]) -> Six:
    """Solve L x = right."""
    _, b0, _, c0, c1, _, d0, d1, d2, _, e0, e1, e2, e3, _, f0, f1, f2, f3, f4, _ = factor
    a, b, c, d, e, f = right
    b -= b0 * a
    c -= c0 * a + c1 * b
    d -= d0 * a + d1 * b + d2 * c
    e -= e0 * a + e1 * b + e2 * c + e3 * d
    f -= f0 * a + f1 * b + f2 * c + f3 * d + f4 * e
    return a, b, c, d, e, f


def _scaled(factor: Triangle, right: Six) -> Six:
    """Solve D x = right."""
    a, b, c, d, e, f = right
    return (
        a * factor[0],
        b * factor[2],
        c * factor[5],
        d * factor[9],
        e * factor[14],
        f * factor[20],
    )


def _backward(factor: Triangle, right: Six) -> Six:
    """Solve Lᵀ x = right."""
    _, b0, _, c0, c1, _, d0, d1, d2, _, e0, e1, e2, e3, _, f0, f1, f2, f3, f4, _ = factor
    a, b, c, d, e, f = right
    e -= f4 * f
    d -= e3 * e + f3 * f
    c -= d2 * d + e2 * e + f2 * f
    b -= c1 * c + d1 * d + e1 * e + f1 * f
    a -= b0 * b + c0 * c + d0 * d + e0 * e + f0 * f
    return a, b, c, d, e, f


def _reduced(factor: Triangle, columns: Columns) -> tuple[list[Six], list[Six]]:
    """Solve L x = column for each, and D y = x: `_forward` and `_scaled` of all."""
    i0, b0, i1, c0, c1, i2, d0, d1, d2, i3, e0, e1, e2, e3, i4, f0, f1, f2, f3, f4, i5 = factor
    half: list[Six] = []
    whole: list[Six] = []
    for a, b, c, d, e, f in columns:
        b -= b0 * a
        c -= c0 * a + c1 * b
        d -= d0 * a + d1 * b + d2 * c
        e -= e0 * a + e1 * b + e2 * c + e3 * d
        f -= f0 * a + f1 * b + f2 * c + f3 * d + f4 * e
        half.append((a, b, c, d, e, f))
        whole.append((a * i0, b * i1, c * i2, d * i3, e * i4, f * i5))
    return half, whole


def _subtract_own(block: list[float], half: Columns, whole: Columns) -> None:
    """Take from a body's own block what has been eliminated."""
    (u, v, w, x, y, z), (u1, v1, w1, x1, y1, z1), (u2, v2, w2, x2, y2, z2) = whole[:3]
    (u3, v3, w3, x3, y3, z3), (u4, v4, w4, x4, y4, z4), (u5, v5, w5, x5, y5, z5) = whole[3:]
    first, second, third, fourth, fifth, sixth = half
    a, b, c, d, e, f = first
    block[0] -= a * u + b * v + c * w + d * x + e * y + f * z
    a, b, c, d, e, f = second
    block[1] -= a * u + b * v + c * w + d * x + e * y + f * z
    block[2] -= a * u1 + b * v1 + c * w1 + d * x1 + e * y1 + f * z1
    a, b, c, d, e, f = third
    block[3] -= a * u + b * v + c * w + d * x + e * y + f * z
    block[4] -= a * u1 + b * v1 + c * w1 + d * x1 + e * y1 + f * z1
    block[5] -= a * u2 + b * v2 + c * w2 + d * x2 + e * y2 + f * z2
    a, b, c, d, e, f = fourth
    block[6] -= a * u + b * v + c * w + d * x + e * y + f * z
    block[7] -= a * u1 + b * v1 + c * w1 + d * x1 + e * y1 + f * z1
    block[8] -= a * u2 + b * v2 + c * w2 + d * x2 + e * y2 + f * z2
    block[9] -= a * u3 + b * v3 + c * w3 + d * x3 + e * y3 + f * z3
    a, b, c, d, e, f = fifth
    block[10] -= a * u + b * v + c * w + d * x + e * y + f * z
    block[11] -= a * u1 + b * v1 + c * w1 + d * x1 + e * y1 + f * z1
    block[12] -= a * u2 + b * v2 + c * w2 + d * x2 + e * y2 + f * z2
    block[13] -= a * u3 + b * v3 + c * w3 + d * x3 + e * y3 + f * z3
    block[14] -= a * u4 + b * v4 + c * w4 + d * x4 + e * y4 + f * z4
    a, b, c, d, e, f = sixth
    block[15] -= a * u + b * v + c * w + d * x + e * y + f * z
    block[16] -= a * u1 + b * v1 + c * w1 + d * x1 + e * y1 + f * z1
    block[17] -= a * u2 + b * v2 + c * w2 + d * x2 + e * y2 + f * z2
    block[18] -= a * u3 + b * v3 + c * w3 + d * x3 + e * y3 + f * z3
    block[19] -= a * u4 + b * v4 + c * w4 + d * x4 + e * y4 + f * z4
    block[20] -= a * u5 + b * v5 + c * w5 + d * x5 + e * y5 + f * z5


def _less(between: Columns | None, half: Columns, whole: Columns) -> list[Six]:
    """Take it from what couples two bodies; rows go with `half`, columns with `whole`."""
    a, b, c, d, e, f = half
    out: list[Six] = []
    for q, (u, v, w, x, y, z) in enumerate(whole):
        g, h, i, j, k, m = between[q] if between is not None else STILL
        out.append(
            (
                g - (a[0] * u + a[1] * v + a[2] * w + a[3] * x + a[4] * y + a[5] * z),
                h - (b[0] * u + b[1] * v + b[2] * w + b[3] * x + b[4] * y + b[5] * z),
                i - (c[0] * u + c[1] * v + c[2] * w + c[3] * x + c[4] * y + c[5] * z),
                j - (d[0] * u + d[1] * v + d[2] * w + d[3] * x + d[4] * y + d[5] * z),
                k - (e[0] * u + e[1] * v + e[2] * w + e[3] * x + e[4] * y + e[5] * z),
                m - (f[0] * u + f[1] * v + f[2] * w + f[3] * x + f[4] * y + f[5] * z),
            )
        )
    return out
