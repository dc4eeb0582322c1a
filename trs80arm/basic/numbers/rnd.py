"""RND: the random numbers of Level II, a generator of 24 bits at 16554 (40AAH) in memory.

The seed belongs to the machine's memory, where programs PEEK and POKE it; these functions only say
how it goes on (Level II facts, RND).
"""

from __future__ import annotations

from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.numbers import single

MULTIPLIER = 4253261
INCREMENT = 372837


def advance(seed: int) -> int:
    """The 24-bit seed after `seed`."""
    return (seed * MULTIPLIER + INCREMENT) & 0xFFFFFF


def rnd(seed: int, n: int) -> tuple[int, float]:
    """RND(n): the new seed and the value.

    Args:
        seed: 24 bits.
        n: the argument, already rounded down to an integer (OV above 32767 comes from there).

    Returns:
        The new seed and a single: between 0 and 1 for n = 0, else a whole number from 1 to n. The
        one is added before the fraction is cut, so the largest fraction can round up to n + 1:
        RND(1) is 2 when the new seed is FFFFFFH.

    Raises:
        BasicError: FC for a negative argument.
    """
    if n < 0:
        raise BasicError(Code.FC)
    seed = advance(seed)
    fraction = seed / 16777216.0
    if not n:
        return seed, fraction
    return seed, single.floor(single.add(single.mul(fraction, float(n)), 1.0))
