"""What can be found in a program by reading it, and where."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from pathlib import Path


class Level(Enum):
    """How bad a finding is."""

    ERROR = "error"
    """The machine stops there, when it comes there."""
    WARNING = "warning"
    """It runs, hardly as it was meant."""


class Rule(Enum):
    """What is looked for: its name and a sentence."""

    NO_LINE = "no-program-line", "A line of the file is no program line."
    LINE_TWICE = "line-twice", "A line number stands twice; the later line counts."
    MEMORY = "memory", "The program does not fit into the largest machine."
    SYNTAX = "syntax", "The statement is no Level II BASIC or ARMBASIC (?SN, ?MO)."
    MISSING_LINE = "missing-line", "A jump goes to a line that is not there (?UL)."
    STEP_VALUES = "step-values", "@STEP has more values than a delay and six joints (?SN)."
    TYPE = "type", "A number stands where a string belongs, or a string for a number (?TM)."
    DISK_BASIC = "disk-basic", "The word belongs to Disk BASIC (?L3)."
    OTHER = "error", "The statement is an error whatever the variables hold."
    SAME_VARIABLE = "same-variable", "Two names are one variable: two characters of a name count."

    def __init__(self, label: str, sentence: str) -> None:
        self.label = label
        self.sentence = sentence


@dataclass(frozen=True)
class Finding:
    """One thing found in a program.

    Attributes:
        file: the program's file.
        place: which line of the file it is, from 1; of a crunched file or a cassette, which line of
            the program.
        rule: what was looked for.
        level: how bad it is.
        text: what it is, in one line.
        number: the number of the program line; None where it has none.
        column: which character of the line in the file, from 1; None where the file's line is not
            as the machine lists it.
    """

    file: Path
    place: int
    rule: Rule
    level: Level
    text: str
    number: int | None = None
    column: int | None = None
