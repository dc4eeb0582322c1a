"""The kinds of value: the four types of Level II, and numbers whose type is not known yet."""

from __future__ import annotations

from enum import StrEnum
from typing import Final


class Kind(StrEnum):
    """A kind of value; members are strings, so they are found in a `dict` as fast as those."""

    INTEGER = "i"
    """16 bits, a Python `int`."""
    STRING = "t"
    """A descriptor: a list of length and address."""
    SINGLE = "s"
    """24 bits, a Python `float` that holds nothing else."""
    DOUBLE = "d"
    """56 bits, `numbers.double.Double`."""
    NUMBER = "n"
    """An integer or a single, known only when it is there."""
    ANY = "x"
    """A number of any type, known only when it is there (VAL, USR)."""


INTEGER: Final = Kind.INTEGER
STRING: Final = Kind.STRING
SINGLE: Final = Kind.SINGLE
DOUBLE: Final = Kind.DOUBLE
NUMBER: Final = Kind.NUMBER
ANY: Final = Kind.ANY

SIZES: Final = {INTEGER: 2, STRING: 3, SINGLE: 4, DOUBLE: 8}
"""Bytes of a value in memory; the same number is the type's code in the tables (2, 3, 4, 8)."""
BY_SIZE: Final = {size: kind for kind, size in SIZES.items()}
