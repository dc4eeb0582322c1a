"""Turning things in space by algebra alone: quaternions and 3 x 3 matrices as tuples of floats.

Nothing here asks the platform's library for a sine: only +, -, *, / and the square root, which
IEEE 754 rounds correctly everywhere, so that contact is the same to the last bit on every machine.
"""

from __future__ import annotations

import math

from trs80arm.arm.shapes import Vector

Quaternion = tuple[float, float, float, float]
"""w, x, y, z of unit length."""
Matrix = tuple[float, float, float, float, float, float, float, float, float]
"""Three rows one after the other."""

STRAIGHT: Quaternion = (1.0, 0.0, 0.0, 0.0)
IDENTITY: Matrix = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
_MOST_ROUNDS = 16
_SETTLED = 1e-12


def matrix(q: Quaternion) -> Matrix:
    """The rotation matrix of a unit quaternion."""
    w, x, y, z = q
    return (
        1 - 2 * (y * y + z * z),
        2 * (x * y - w * z),
        2 * (x * z + w * y),
        2 * (x * y + w * z),
        1 - 2 * (x * x + z * z),
        2 * (y * z - w * x),
        2 * (x * z - w * y),
        2 * (y * z + w * x),
        1 - 2 * (x * x + y * y),
    )


def product(p: Quaternion, q: Quaternion) -> Quaternion:
    """First turn by `q`, then by `p`."""
    a, b, c, d = p
    w, x, y, z = q
    return (
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    )


def unit(q: Quaternion) -> Quaternion:
    """A quaternion scaled to unit length."""
    w, x, y, z = q
    length = math.sqrt(w * w + x * x + y * y + z * z)
    return w / length, x / length, y / length, z / length


def inverse(q: Quaternion) -> Quaternion:
    """The turn back."""
    return q[0], -q[1], -q[2], -q[3]


def turned(q: Quaternion, spin: Vector, seconds: float) -> Quaternion:
    """A turn after spinning for a while.

    Args:
        q: the turn before.
        spin: radians a second about the world's axes.
        seconds: for how long; the angle is one of a small step.
    """
    half = seconds / 2
    w, x, y, z = product((0.0, spin[0] * half, spin[1] * half, spin[2] * half), q)
    return unit((q[0] + w, q[1] + x, q[2] + y, q[3] + z))


def spun(
    q: Quaternion, spin: Vector, inertia: Matrix, inverse: Matrix, seconds: float
) -> tuple[Quaternion, Vector]:
    """How a body turns of itself: turn and spin after a while.

    Euler's equations by the implicit midpoint rule, with Cayley's map for the turn: both the energy
    of the spin and its momentum stay what they are, whatever the body's shape and however long the
    step (Lewis and Simo, 1994). With the spin merely kept, what spins about none of its principal
    axes would win energy as it turns.

    Args:
        q: the turn before.
        spin: radians a second about the world's axes.
        inertia: about the centre of mass, in the body's frame.
        inverse: of that.
        seconds: for how long; the angle is one of a small step.
    """
    m = matrix(q)
    first = last = apply_back(m, spin)
    x, y, z = first
    middle = first
    for _ in range(_MOST_ROUNDS):
        u, v, w = middle
        a, b, c = apply(inertia, middle)
        a, b, c = apply(inverse, (b * w - c * v, c * u - a * w, a * v - b * u))
        now = (x + a * seconds, y + b * seconds, z + c * seconds)
        far = max(abs(now[0] - last[0]), abs(now[1] - last[1]), abs(now[2] - last[2]))
        last = now
        middle = ((x + now[0]) / 2, (y + now[1]) / 2, (z + now[2]) / 2)
        if far <= _SETTLED * max(abs(x), abs(y), abs(z)):
            break
    after = turned(q, apply(m, middle), seconds)
    return after, apply(matrix(after), last)


def about(axis: Vector, degrees: float) -> Quaternion:
    """A turn about one of the axes.

    Args:
        axis: a unit vector.
        degrees: right-handed.
    """
    # A sixty-fourth of the turn by its series, then doubled: no library's sine.
    degrees -= 360 * math.floor(degrees / 360 + 0.5)
    a = degrees * (math.pi / 360 / 64)
    square = a * a
    sine = a * (1 - square / 6 * (1 - square / 20 * (1 - square / 42)))
    cosine = 1 - square / 2 * (1 - square / 12 * (1 - square / 30))
    q = (cosine, sine * axis[0], sine * axis[1], sine * axis[2])
    for _ in range(6):
        q = product(q, q)
    return unit(q)


def oriented(turn: float, tilt: float = 0.0, roll: float = 0.0) -> Quaternion:
    """A turn about x, then y, then the vertical.

    Args:
        turn: degrees about the vertical, counter-clockwise from above.
        tilt: degrees about y.
        roll: degrees about x.
    """
    q = product(about((0.0, 1.0, 0.0), tilt), about((1.0, 0.0, 0.0), roll))
    return product(about((0.0, 0.0, 1.0), turn), q)


def apply(m: Matrix, v: Vector) -> Vector:
    """A vector turned by a matrix."""
    x, y, z = v
    return (
        m[0] * x + m[1] * y + m[2] * z,
        m[3] * x + m[4] * y + m[5] * z,
        m[6] * x + m[7] * y + m[8] * z,
    )


def apply_back(m: Matrix, v: Vector) -> Vector:
    """A vector turned by the inverse of a rotation matrix."""
    x, y, z = v
    return (
        m[0] * x + m[3] * y + m[6] * z,
        m[1] * x + m[4] * y + m[7] * z,
        m[2] * x + m[5] * y + m[8] * z,
    )


def times(a: Matrix, b: Matrix) -> Matrix:
    """Product of two matrices."""
    a0, a1, a2, a3, a4, a5, a6, a7, a8 = a
    b0, b1, b2, b3, b4, b5, b6, b7, b8 = b
    return (
        a0 * b0 + a1 * b3 + a2 * b6,
        a0 * b1 + a1 * b4 + a2 * b7,
        a0 * b2 + a1 * b5 + a2 * b8,
        a3 * b0 + a4 * b3 + a5 * b6,
        a3 * b1 + a4 * b4 + a5 * b7,
        a3 * b2 + a4 * b5 + a5 * b8,
        a6 * b0 + a7 * b3 + a8 * b6,
        a6 * b1 + a7 * b4 + a8 * b7,
        a6 * b2 + a7 * b5 + a8 * b8,
    )


def transposed(m: Matrix) -> Matrix:
    """Rows for columns; the inverse of a rotation."""
    return m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]


def inverted(m: Matrix) -> Matrix:
    """The inverse of a matrix."""
    a, b, c, d, e, f, g, h, i = m
    u, v, w = e * i - f * h, f * g - d * i, d * h - e * g
    s = 1 / (a * u + b * v + c * w)
    return (
        u * s,
        (c * h - b * i) * s,
        (b * f - c * e) * s,
        v * s,
        (a * i - c * g) * s,
        (c * d - a * f) * s,
        w * s,
        (b * g - a * h) * s,
        (a * e - b * d) * s,
    )


def quaternion(m: Matrix) -> Quaternion:
    """The unit quaternion of a rotation matrix."""
    trace = m[0] + m[4] + m[8]
    if trace > 0:
        s = 2 * math.sqrt(trace + 1)
        return unit((s / 4, (m[7] - m[5]) / s, (m[2] - m[6]) / s, (m[3] - m[1]) / s))
    if m[0] >= m[4] and m[0] >= m[8]:
        s = 2 * math.sqrt(1 + m[0] - m[4] - m[8])
        return unit(((m[7] - m[5]) / s, s / 4, (m[1] + m[3]) / s, (m[2] + m[6]) / s))
    if m[4] >= m[8]:
        s = 2 * math.sqrt(1 + m[4] - m[0] - m[8])
        return unit(((m[2] - m[6]) / s, (m[1] + m[3]) / s, s / 4, (m[5] + m[7]) / s))
    s = 2 * math.sqrt(1 + m[8] - m[0] - m[4])
    return unit(((m[3] - m[1]) / s, (m[2] + m[6]) / s, (m[5] + m[7]) / s, s / 4))
