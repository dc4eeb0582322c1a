"""What can be found in a program by reading it, and where."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from pathlib import Path
from typing import Final


class Level(Enum):
    """How bad a finding is."""

    ERROR = "error"
    """The machine stops there, or the arm cannot follow, when it comes there."""
    WARNING = "warning"
    """It runs, hardly as it was meant."""
    NOTE = "note"
    """It runs, and may be meant; worth a look."""


class Rule(Enum):
    """What is looked for.

    Attributes:
        label: its name.
        level: how bad what it finds is.
        sentence: what it finds.
        remedy: what it means for the program, and what to do.
    """

    NO_LINE = (
        "no-program-line",
        Level.ERROR,
        "A line of the file is no program line.",
        "Begin the line with a number of 0 to 65529, and use the machine's characters only.",
    )
    LINE_TWICE = (
        "line-twice",
        Level.WARNING,
        "A line number stands twice; the later line counts.",
        "As when typed, the earlier line is lost. Give one of them another number.",
    )
    MEMORY = (
        "memory",
        Level.ERROR,
        "The program does not fit into the largest machine.",
        "A 48K machine ends with ?OM while it loads. Make the program shorter, or two of it.",
    )
    SYNTAX = (
        "syntax",
        Level.ERROR,
        "The statement is no Level II BASIC or ARMBASIC (?SN, ?MO).",
        "The machine stops before the place that is named. Compare it with the manual.",
    )
    MISSING_LINE = (
        "missing-line",
        Level.ERROR,
        "A jump goes to a line that is not there (?UL).",
        "Write the line, or mend the number behind GOTO, GOSUB, THEN, ELSE, ON, RUN or RESUME.",
    )
    STEP_VALUES = (
        "step-values",
        Level.ERROR,
        "@STEP has more values than a delay and six joints (?SN).",
        "Count them: the delay, then J1 to J6.",
    )
    TYPE = (
        "type",
        Level.ERROR,
        "A number stands where a string belongs, or a string for a number (?TM).",
        "Only names with a $ hold strings, unless DEFSTR says so; STR$ and VAL convert.",
    )
    DISK_BASIC = (
        "disk-basic",
        Level.ERROR,
        "The word belongs to Disk BASIC (?L3).",
        "Level II has no disk. Use CSAVE, CLOAD, PRINT#-1 and INPUT#-1 instead.",
    )
    OTHER = (
        "error",
        Level.ERROR,
        "The statement is an error whatever the variables hold.",
        "The machine stops there with the code that is named.",
    )
    SAME_VARIABLE = (
        "same-variable",
        Level.WARNING,
        "Two names are one variable: two characters of a name count.",
        "Give one of them a name with other first characters.",
    )
    NEXT_WITHOUT_FOR = (
        "next-without-for",
        Level.ERROR,
        "No way leads to the NEXT from a FOR of its variable (?NF).",
        "Write the FOR, or mend the name behind NEXT. A loop does not reach into a subroutine.",
    )
    OUT_OF_REACH = (
        "out-of-reach",
        Level.ERROR,
        "DATA send the arm where it cannot go.",
        "The program turns the point away, or a motor would slip at a stop. Move the point.",
    )
    OUT_OF_DATA = (
        "out-of-data",
        Level.ERROR,
        "A READ finds no DATA left (?OD).",
        "Count the items, or end the list with one that the program looks for.",
    )
    DATA_TYPE = (
        "data-type",
        Level.ERROR,
        "DATA that are no number are read into one (?SN in the line of the DATA).",
        "Compare the order of the items with that of the variables behind READ.",
    )
    FOR_WITHOUT_NEXT = (
        "for-without-next",
        Level.WARNING,
        "No way leads from the FOR to a NEXT of its variable; it is gone through once.",
        "Write the NEXT, or mend its name. A loop does not reach into a subroutine.",
    )
    NO_RETURN = (
        "no-return",
        Level.NOTE,
        "No way leads from the line that a GOSUB goes to to a RETURN.",
        "What is never returned from stays in memory, up to ?OM. Use GOTO, or write the RETURN.",
    )
    UNREACHED = (
        "unreached",
        Level.NOTE,
        "No way leads to the statement.",
        "It stands behind a GOTO, END or RETURN, and nothing jumps there. Take it out.",
    )
    NEVER_SET = (
        "never-set",
        Level.NOTE,
        "Nothing sets the variable that is read; it is 0, or the empty string.",
        "It may be another name misspelt. Set it where the program begins.",
    )
    UNKNOWN_RULE = (
        "unknown-rule",
        Level.WARNING,
        "A remark allows what is no rule.",
        "The names of the rules stand in the manual.",
    )

    def __init__(self, label: str, level: Level, sentence: str, remedy: str) -> None:
        self.label = label
        self.level = level
        self.sentence = sentence
        self.remedy = remedy


RULES: Final = {rule.label: rule for rule in Rule}
"""The rules by their names."""


@dataclass(frozen=True)
class Finding:
    """One thing found in a program.

    Attributes:
        file: the program's file.
        place: which line of the file it is, from 1; of a crunched file or a cassette, which line of
            the program.
        rule: what was looked for.
        text: what it is, in one line.
        number: the number of the program line; None where it has none.
        column: which character of the line in the file, from 1; None where the file's line is not
            as the machine lists it.
    """

    file: Path
    place: int
    rule: Rule
    text: str
    number: int | None = None
    column: int | None = None

    @property
    def level(self) -> Level:
        """How bad it is."""
        return self.rule.level
