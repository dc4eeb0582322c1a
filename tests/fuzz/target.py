"""What a door is: noise for it, and what must hold whatever comes through."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from random import Random
from typing import Any

from tests.fuzz.checks import hold

Case = Any
"""What JSON can hold."""


@dataclass(frozen=True)
class Target:
    """One door.

    Attributes:
        name: what it is called on the command line.
        make: a case from chance.
        play: does it, and raises whatever is wrong: any exception that is not the door's own.
    """

    name: str
    make: Callable[[Random], Case]
    play: Callable[[Case], None]


def one_line(error: Exception) -> None:
    """What is told of something that is no good is one line."""
    hold("\n" not in str(error), "an error of more than one line")
