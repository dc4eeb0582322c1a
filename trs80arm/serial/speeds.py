"""How fast SP is: the speeds of `@STEP`, 0 to 245, as half-steps a second.

Known are that a greater SP is faster, that the memory keeps 255 - SP, that 240, 190 and 140 are
fast, medium and slow, and that 183 makes 141 half-steps a second (TeachVal III). Chosen is that a
tick takes as long as ARMBASIC's, 1.2 + 0.03 D ms, and that D falls evenly to 0 at 255. Then 183 is
141.2 half-steps a second, 0 is 45, 240 is 417; and 245, 497, is more than a shoulder keeps up with,
as the authors of a client say, who advise against more than 240.
"""

from __future__ import annotations

_OVER, _UNDER = 30, 11
"""D for each unit of 255 - SP, as a fraction."""


def delay_of(speed: int) -> int:
    """The D of ARMBASIC whose pace a speed has.

    Args:
        speed: SP, 0 to 255.
    """
    return (255 - speed) * _OVER // _UNDER


def speed_of(delay: int) -> int:
    """The greatest speed that is not faster than a D of ARMBASIC; 0 for all that are slower.

    Args:
        delay: D, 0 or more.
    """
    return max(0, 255 - -(-delay * _UNDER // _OVER))
