"""What a machine has in memory, for whoever looks on: its listing, its variables, its paper.

Looking changes nothing and takes none of the machine's time. The terminal's panels read it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import islice
from typing import Any

from trs80arm.basic.kinds import DOUBLE, INTEGER, STRING, Kind
from trs80arm.basic.numbers.decimal import number_text
from trs80arm.deck import Deck, cassettes_of
from trs80arm.program_text import spell
from trs80arm.rig import Rig

MOST_ELEMENTS = 16
"""Elements of an array that are shown."""
_MARKS = {INTEGER: "%", STRING: "$", DOUBLE: "#"}

Line = tuple[int, bytes]
"""A program line as the machine has it: its number, and its crunched text."""


@dataclass(frozen=True)
class Variable:
    """A variable: its name as LIST would have it, with its dimensions, and what it holds."""

    name: str
    value: str


@dataclass(frozen=True)
class Inspection:
    """What is in a machine's memory at one moment.

    Attributes:
        lines: the program, crunched.
        next_line: the number of the line that is executed next; None while no program runs.
        variables: the simple ones in the order of their creation, then the arrays.
        paper: what is on the printer's paper, line by line.
        cassettes: the names of the cassettes.
        deck: the recorder.
    """

    lines: tuple[Line, ...] = ()
    next_line: int | None = None
    variables: tuple[Variable, ...] = ()
    paper: tuple[str, ...] = ()
    cassettes: tuple[str, ...] = ()
    deck: Deck = field(default_factory=Deck)

    @classmethod
    def of(cls, rig: Rig) -> Inspection:
        """Look into a machine."""
        basic = rig.basic
        return cls(
            tuple(basic.program.lines()),
            basic.next_line,
            tuple(_variables(rig)),
            tuple(rig.printer.text.splitlines()),
            cassettes_of(rig),
            Deck.of(rig),
        )


@lru_cache(maxsize=4096)
def line_text(line: Line) -> str:
    """A program line as LIST shows it."""
    number, crunched = line
    return f"{number} {spell(crunched)}"


def _variables(rig: Rig) -> Iterator[Variable]:
    variables = rig.basic.state.variables
    for scalar in variables.order:
        yield Variable(_name(scalar.name, scalar.kind), _value(rig, scalar.kind, scalar.value))
    for array in variables.arrays.values():
        dims = ",".join(str(dim - 1) for dim in array.dims)
        values = " ".join(
            _value(rig, array.kind, value).strip() for value in islice(array.data, MOST_ELEMENTS)
        )
        more = " ..." if len(array.data) > MOST_ELEMENTS else ""
        yield Variable(f"{_name(array.name, array.kind)}({dims})", values + more)


def _name(name: str, kind: Kind) -> str:
    return name + _MARKS.get(kind, "")


def _value(rig: Rig, kind: Kind, value: Any) -> str:
    if kind != STRING:
        return number_text(value)
    text = rig.basic.state.strings.bytes_of(value).decode("latin-1")
    return f'"{text}"'
