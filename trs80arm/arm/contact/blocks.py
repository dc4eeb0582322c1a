"""Momentum and stiffness of each thing that moves: the blocks of the system of all its unknowns.

A block is the triangle of a symmetric 6 x 6 matrix, as in `elimination`.
"""

from __future__ import annotations

from collections.abc import Sequence
from operator import add

from trs80arm.arm.contact.contacts import Mobile
from trs80arm.arm.contact.sixes import STILL, Six
from trs80arm.arm.shapes import Vector

_DIAGONAL = (0, 2, 5, 9, 14, 20)
"""Where in the triangle it is."""


def mass_block(mobile: Mobile) -> list[float]:
    """Mass and inertia, of a body or of the arm's coordinates."""
    out = [0.0] * 21
    if mobile.inertias is not None:
        for k, inertia in zip(_DIAGONAL, mobile.inertias, strict=True):
            out[k] = inertia
    else:
        assert mobile.inertia is not None
        out[0] = out[2] = out[5] = mobile.mass
        out[9], _, _, out[13], out[14], _, out[18], out[19], out[20] = mobile.inertia
    return out


def missing_momentum(mass: list[float], speed: Six, wanted: Sequence[float]) -> list[float]:
    """Momentum that is missing: of a body, or of the arm's coordinates."""
    a, b, c, d, e, f = speed
    u, v, w, x, y, z = wanted
    d, e, f = d - x, e - y, f - z
    return [
        mass[0] * (a - u),
        mass[2] * (b - v),
        mass[5] * (c - w),
        mass[9] * d + mass[13] * e + mass[18] * f,
        mass[13] * d + mass[14] * e + mass[19] * f,
        mass[18] * d + mass[19] * e + mass[20] * f,
    ]


def add_up(block: list[float], stiffness: list[float]) -> None:
    """Add a stiffness against a body to its block."""
    block[:] = map(add, block, stiffness)


def add_linked(
    block: list[float], columns: list[tuple[int, Six]], stiffness: list[float]
) -> list[Six]:
    """Add a stiffness against a link to the arm's own block.

    Returns:
        What couples the arm to the other thing: a column for each coordinate.
    """
    (a, b, c, d, e, f, g, h, i, j, k, m, n, o, p, q, r, s, t, u, v) = stiffness
    out: list[Six] = [STILL] * 6
    for at, (x, y, z, ex, ey, ez) in columns:
        fx, fy, fz = a * x + b * y + d * z, b * x + c * y + e * z, d * x + e * y + f * z
        mx, my, mz = g * x + h * y + i * z, k * x + m * y + n * z, q * x + r * y + s * z
        if ex or ey or ez:
            fx += g * ex + k * ey + q * ez
            fy += h * ex + m * ey + r * ez
            fz += i * ex + n * ey + s * ez
            mx += j * ex + o * ey + t * ez
            my += o * ex + p * ey + u * ez
            mz += t * ex + u * ey + v * ez
        out[at] = (-fx, -fy, -fz, -mx, -my, -mz)
        start = at * (at + 1) // 2
        for other, (x, y, z, ex, ey, ez) in columns:
            if other > at:
                break
            # Cables move most links without turning them.
            product = fx * x + fy * y + fz * z
            if ex or ey or ez:
                product += mx * ex + my * ey + mz * ez
            block[start + other] += product
    return out


def add_own(
    block: list[float],
    between: list[Six],
    own: list[tuple[int, Six]],
    alike: list[tuple[int, Six]],
    stiffness: list[float],
) -> None:
    """Add what a stiffness does by coordinates that move one link alone.

    Args:
        block: the arm's own.
        between: what couples it to the other thing.
        own: columns of those coordinates.
        alike: columns of the link's others, by which it has been added.
        stiffness: against the link.
    """
    (a, b, c, d, e, f, g, h, i, j, k, m, n, o, p, q, r, s, t, u, v) = stiffness
    for place, (at, (x, y, z, ex, ey, ez)) in enumerate(own):
        fx = a * x + b * y + d * z + g * ex + k * ey + q * ez
        fy = b * x + c * y + e * z + h * ex + m * ey + r * ez
        fz = d * x + e * y + f * z + i * ex + n * ey + s * ez
        mx = g * x + h * y + i * z + j * ex + o * ey + t * ez
        my = k * x + m * y + n * z + o * ex + p * ey + u * ez
        mz = q * x + r * y + s * z + t * ex + u * ey + v * ez
        va, vb, vc, vd, ve, vf = between[at]
        between[at] = (va - fx, vb - fy, vc - fz, vd - mx, ve - my, vf - mz)
        for other, (x, y, z, ex, ey, ez) in (*alike, *own[: place + 1]):
            low, high = (other, at) if other < at else (at, other)
            block[high * (high + 1) // 2 + low] += (
                fx * x + fy * y + fz * z + mx * ex + my * ey + mz * ez
            )


def add_shifted(block: list[float], lever: Vector, stiffness: list[float]) -> list[Six]:
    """Add a stiffness to the block of a body whose centre of mass is elsewhere.

    Args:
        block: of the body.
        lever: from its centre of mass to the reference point.
        stiffness: there.

    Returns:
        What couples it to the other body: a column for each of this one's unknowns.
    """
    x, y, z = lever
    (a, b, c, d, e, f, g, h, i, j, k, m, n, o, p, q, r, s, t, u, v) = stiffness
    # A (a b d, b c e, d e f) acts on velocities, B (columns g h i, k m n, q r s) between them and
    # spins, C (j o t, o p u, t u v) on spins. A spin is a velocity there of spin x lever.
    g2, k2, q2 = g - (b * z - d * y), k - (d * x - a * z), q - (a * y - b * x)
    h2, m2, r2 = h - (c * z - e * y), m - (e * x - b * z), r - (b * y - c * x)
    i2, n2, s2 = i - (e * z - f * y), n - (f * x - d * z), s - (d * y - e * x)
    # Moments of the columns of B about the centre of mass.
    gx, gy, gz = h * z - i * y, i * x - g * z, g * y - h * x
    kx, ky, kz = m * z - n * y, n * x - k * z, k * y - m * x
    qx, qy, qz = r * z - s * y, s * x - q * z, q * y - r * x
    block[0] += a
    block[1] += b
    block[2] += c
    block[3] += d
    block[4] += e
    block[5] += f
    block[6] += g2
    block[7] += h2
    block[8] += i2
    block[9] += j - gx - (h2 * z - i2 * y)
    block[10] += k2
    block[11] += m2
    block[12] += n2
    block[13] += o - kx - (i2 * x - g2 * z)
    block[14] += p - ky - (n2 * x - k2 * z)
    block[15] += q2
    block[16] += r2
    block[17] += s2
    block[18] += t - qx - (g2 * y - h2 * x)
    block[19] += u - qy - (k2 * y - m2 * x)
    block[20] += v - qz - (q2 * y - r2 * x)
    return [
        (-a, -b, -d, -g, -k, -q),
        (-b, -c, -e, -h, -m, -r),
        (-d, -e, -f, -i, -n, -s),
        (-g2, -h2, -i2, gx - j, kx - o, qx - t),
        (-k2, -m2, -n2, gy - o, ky - p, qy - u),
        (-q2, -r2, -s2, gz - t, kz - u, qz - v),
    ]
