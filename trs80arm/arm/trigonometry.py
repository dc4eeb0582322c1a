"""Sine, cosine and arc tangent, the same to the last bit on every computer.

The C library's differ in the last place from one platform to the next, and what the arm touches
or lifts may hang on it. These use nothing but the operations that IEEE 754 rounds in one way
(+, -, *, / and floor), in a fixed order. The polynomials are those of Sun's fdlibm; the results
are within one unit in the last place of the true values for the angles that joints take.
"""

from __future__ import annotations

from math import floor

_TWO_OVER_PI = 0.6366197723675814
# pi/2 in three parts; the first two have room for a factor of twenty bits.
_HALF_PI_1 = 1.57079632673412561417
_HALF_PI_2 = 6.07710050630396597660e-11
_HALF_PI_3 = 2.02226624879595063154e-21


def sin_cos(angle: float) -> tuple[float, float]:
    """Sine and cosine of an angle in radians, no more than some thousand turns."""
    quarters = floor(angle * _TWO_OVER_PI + 0.5)
    r = ((angle - quarters * _HALF_PI_1) - quarters * _HALF_PI_2) - quarters * _HALF_PI_3
    z = r * r
    sine = r + r * z * (
        -1.66666666666666324348e-01
        + z
        * (
            8.33333333332248946124e-03
            + z
            * (
                -1.98412698298579493134e-04
                + z
                * (
                    2.75573137070700676789e-06
                    + z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)
                )
            )
        )
    )
    cosine = 1.0 - (
        0.5 * z
        - z
        * z
        * (
            4.16666666666666019037e-02
            + z
            * (
                -1.38888888888741095749e-03
                + z
                * (
                    2.48015872894767294178e-05
                    + z
                    * (
                        -2.75573143513906633035e-07
                        + z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)
                    )
                )
            )
        )
    )
    quadrant = quarters & 3
    if quadrant == 0:
        return sine, cosine
    if quadrant == 1:
        return cosine, -sine
    if quadrant == 2:
        return -sine, -cosine
    return -cosine, sine


_ATAN_HIGH = (
    4.63647609000806093515e-01,
    7.85398163397448278999e-01,
    9.82793723247329054082e-01,
    1.57079632679489655800,
)
_ATAN_LOW = (
    2.26987774529616870924e-17,
    3.06161699786838301793e-17,
    1.39033110312309984516e-17,
    6.12323399573676603587e-17,
)
_ATAN = (
    3.33333333333329318027e-01,
    -1.99999999998764832476e-01,
    1.42857142725034663711e-01,
    -1.11111104054623557880e-01,
    9.09088713343650656196e-02,
    -7.69187620504482999495e-02,
    6.66107313738753120669e-02,
    -5.83357013379057348645e-02,
    4.97687799461593236017e-02,
    -3.65315727442169155270e-02,
    1.62858201153657823623e-02,
)


def arc_tangent(value: float) -> float:
    """The angle between -pi/2 and pi/2, in radians, whose tangent is `value`."""
    x = abs(value)
    if x < 0.4375:
        part, reduced = -1, x
    elif x < 0.6875:
        part, reduced = 0, (2.0 * x - 1.0) / (2.0 + x)
    elif x < 1.1875:
        part, reduced = 1, (x - 1.0) / (x + 1.0)
    elif x < 2.4375:
        part, reduced = 2, (x - 1.5) / (1.0 + 1.5 * x)
    elif x < 1e17:
        part, reduced = 3, -1.0 / x
    else:
        return _ATAN_HIGH[3] if value > 0 else -_ATAN_HIGH[3]
    z = reduced * reduced
    w = z * z
    a = _ATAN
    even = z * (a[0] + w * (a[2] + w * (a[4] + w * (a[6] + w * (a[8] + w * a[10])))))
    odd = w * (a[1] + w * (a[3] + w * (a[5] + w * (a[7] + w * a[9]))))
    if part < 0:
        angle = reduced - reduced * (even + odd)
    else:
        angle = _ATAN_HIGH[part] - ((reduced * (even + odd) - _ATAN_LOW[part]) - reduced)
    return angle if value >= 0 else -angle
