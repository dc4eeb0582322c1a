"""How a program, or a direct line, ended."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from trs80arm.basic.errors import Code


class Ending(Enum):
    """What ended it."""

    END = "end"
    STOP = "stop"
    BREAK = "break"
    ERROR = "error"


@dataclass(frozen=True)
class Outcome:
    """How the last program run, or direct line, ended.

    Attributes:
        ending: what ended it.
        code: the error, if it was one.
        line: where; None in direct mode.
    """

    ending: Ending
    code: Code | None = None
    line: int | None = None
