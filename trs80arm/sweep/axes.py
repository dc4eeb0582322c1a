"""What a sweep varies, and over which values: `D=10:200:10`, `weight=1,4,8,12`."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from decimal import Decimal

MOST_CELLS = 10_000
"""Cells of a grid: it is to be seen as a table."""
MOST_NOISE = 12.0
"""Inches of error in placing."""
LENGTHS = ("dx", "dy")
PART_KEYS = ("weight", "friction", *LENGTHS, "dturn")
NOISE = "noise"
_VARIABLE = re.compile(r"[A-Z][A-Z0-9]*[%!#]?(@\d{1,5})?")
_CONSTANT = re.compile(r"\d{1,5}(-\d{1,5})?#\d{1,3}")
_SETTING = re.compile(r"(arm|driver|card|machine)\.[a-z_0-9]+")
_OF_PARTS = re.compile(rf"(?:(?P<part>.+)\.)?(?P<key>{'|'.join(PART_KEYS)})")


class SweepError(Exception):
    """A sweep that cannot be made; one line that says why."""


@dataclass(frozen=True)
class Axis:
    """One thing that is varied.

    Attributes:
        name: as it was given.
        values: that it takes, in the order given.
    """

    name: str
    values: tuple[float, ...]

    @property
    def in_program(self) -> bool:
        """Whether it is a constant of the program."""
        return bool(_VARIABLE.fullmatch(self.name) or _CONSTANT.fullmatch(self.name))

    @property
    def is_setting(self) -> bool:
        """Whether it is a setting of arm, driver, card or machine."""
        return bool(_SETTING.fullmatch(self.name))

    @property
    def of_parts(self) -> tuple[str, str] | None:
        """Which part, empty for all of them, and which key; None if it is nothing of parts."""
        found = _OF_PARTS.fullmatch(self.name)
        return (found["part"] or "", found["key"]) if found and not self.is_setting else None


def parse_axis(text: str) -> Axis:
    """Read `NAME=FROM:TO:STEP` or `NAME=VALUE,VALUE`.

    Raises:
        SweepError: it is not of that form, or nothing that can be varied is called so.
    """
    name, equals, told = text.partition("=")
    name = name.strip()
    if not equals:
        raise SweepError(f"--vary {text}: must be NAME=FROM:TO:STEP or NAME=VALUE,VALUE")
    axis = Axis(name, tuple(_values(text, told)))
    if not (axis.in_program or axis.is_setting or axis.of_parts or name == NOISE):
        raise SweepError(
            f"--vary {text}: {name or 'nothing'} is no BASIC variable (D, S@420), constant of a "
            f"line (470#1) or of several (470-490#1), setting (arm.pad_friction), {NOISE}, "
            f"nor {', '.join(PART_KEYS)} of parts"
        )
    if name == NOISE and not all(0 <= value <= MOST_NOISE for value in axis.values):
        raise SweepError(f"--vary {text}: noise is from 0 to {MOST_NOISE:g} inches")
    if len(set(axis.values)) != len(axis.values):
        raise SweepError(f"--vary {text}: a value comes twice")
    return axis


def _values(text: str, told: str) -> Iterator[float]:
    try:
        if ":" not in told:
            numbers = [Decimal(part.strip()) for part in told.split(",")]
        else:
            first, last, step = (Decimal(part.strip()) for part in told.split(":"))
            if step <= 0 or last < first:
                raise SweepError(f"--vary {text}: FROM:TO:STEP goes up by a step above 0")
            # In decimals: 0.1 to 0.3 by 0.1 ends at 0.3.
            count = (last - first) // step + 1
            if count > MOST_CELLS:
                raise SweepError(f"--vary {text}: more than {MOST_CELLS} values")
            numbers = [first + number * step for number in range(int(count))]
    except (ArithmeticError, ValueError):
        raise SweepError(f"--vary {text}: must be NAME=FROM:TO:STEP or NAME=VALUE,VALUE") from None
    for number in numbers:
        value = float(number)
        if not math.isfinite(value) or abs(value) > 1e30:
            raise SweepError(f"--vary {text}: {number} is no number to run with")
        yield value


def grid(axes: Sequence[Axis]) -> list[tuple[float, ...]]:
    """Every combination of the values of all axes, the last axis running fastest.

    Raises:
        SweepError: there are too many, or two axes are one.
    """
    names = [axis.name for axis in axes]
    for name in names:
        if names.count(name) > 1:
            raise SweepError(f"--vary {name}: given twice")
    count = math.prod(len(axis.values) for axis in axes)
    if count > MOST_CELLS:
        raise SweepError(f"the grid has {count} cells; {MOST_CELLS} at most")
    return list(itertools.product(*(axis.values for axis in axes)))
