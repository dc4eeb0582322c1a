"""What a machine has in memory, for whoever looks on: its listing, its variables, its paper.

Looking changes nothing and takes none of the machine's time. The terminal's panels read it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import islice
from typing import Any

from trs80arm.basic.control import DIRECT, ForFrame
from trs80arm.basic.execution import DIRECT_LINE
from trs80arm.basic.kinds import DOUBLE, INTEGER, STRING, Kind
from trs80arm.basic.numbers.decimal import number_text
from trs80arm.deck import Deck, cassettes_of
from trs80arm.program_text import spell
from trs80arm.rig import Rig
from trs80arm.works.named_variables import as_number as as_number
from trs80arm.works.named_variables import is_name as is_name
from trs80arm.works.named_variables import stored_value

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
            basic.program.lines(),
            basic.next_line,
            tuple(_variables(rig)),
            tuple(rig.printer.text.splitlines()),
            cassettes_of(rig),
            Deck.of(rig),
        )


@dataclass(frozen=True)
class Spot:
    """A statement of a program, or of a direct line.

    Attributes:
        line: the number of its line; None for a direct line.
        number: which statement of the line it is, from 1.
        start: the column of `line_text` at which it begins.
        stop: the column behind it.
        text: the statement itself.
    """

    line: int | None
    number: int
    start: int
    stop: int
    text: str

    def __str__(self) -> str:
        if self.line is None:
            return f"the direct line: {self.text}"
        return f"{self.line}{f' (statement {self.number})' if self.number > 1 else ''}: {self.text}"


def next_spot(rig: Rig) -> Spot | None:
    """The statement that is executed next, or is under way now; None when none is."""
    address = rig.basic.next_address
    return None if address is None else spot_at(rig, address)


def is_statement(rig: Rig, address: int) -> bool:
    """Whether a statement stands behind a separator, and not the end of all of them."""
    ram = rig.memory.ram
    if ram[address]:
        return True
    program = address >= rig.basic.program.start - 1
    return program and bool(ram[address + 1] or ram[address + 2])


def spot_at(rig: Rig, address: int) -> Spot | None:
    """The statement behind a separator; None if there is none, as at the program's end."""
    program, ram = rig.basic.program, rig.memory.ram
    if address < program.start - 1:
        number, first = None, DIRECT_LINE + 1
        head = ""
    else:
        link = address + 1 if ram[address] == 0 else program.line_at(address)
        if link is None or not (ram[link] or ram[link + 1]):
            return None
        number, first = program.number_at(link), link + 4
        head = f"{number} "
    start = first if ram[address] == 0 else address + 1
    stops = _statements(rig, first)
    stop = next((stop for stop in stops if stop >= start), start)
    before = len(head) + len(spell(bytes(ram[first:start])))
    text = spell(bytes(ram[start:stop]))
    lead = len(text) - len(text.lstrip())
    place = sum(end < start for end in stops) + 1
    return Spot(number, place, before + lead, before + len(text), text.strip())


def _statements(rig: Rig, first: int) -> list[int]:
    """Where the statements of a line end, whose text begins at an address."""
    program = rig.basic.program
    stops = [program.statement_end(first)]
    while rig.memory.ram[stops[-1]]:
        stops.append(program.statement_end(stops[-1] + 1))
    return stops


def open_frames(rig: Rig) -> list[str]:
    """The loops and subroutines that are open, the innermost first."""
    found = []
    for frame in reversed(rig.basic.state.control.frames[1:]):
        where = "direct" if frame.line == DIRECT else str(frame.line)
        if isinstance(frame, ForFrame):
            name = _name(frame.scalar.name, frame.scalar.kind)
            limit, step = (number_text(value).strip() for value in (frame.limit, frame.step))
            by = "" if step == "1" else f" STEP {step}"
            found.append(f"{where}  FOR {name} TO {limit}{by}")
        else:
            found.append(f"{where}  GOSUB")
    return found


def depth(rig: Rig) -> int:
    """How many subroutines are open."""
    return sum(not isinstance(frame, ForFrame) for frame in rig.basic.state.control.frames[1:])


def value_of(rig: Rig, name: str) -> Any:
    """What a variable, or an element of an array, holds: a number of the machine's, or text.

    Args:
        rig: the machine.
        name: as in a program, `A`, `B$`, `C%(3,I)`; a subscript is a number or a variable's name.

    Raises:
        LookupError: there is none; one line that says why.
    """
    return stored_value(rig.basic, name)


def value_text(rig: Rig, name: str) -> str:
    """What a variable holds, as BASIC writes it.

    Raises:
        LookupError: there is none; one line that says why.
    """
    value = value_of(rig, name)
    if isinstance(value, str):
        return f'"{value}"'
    return number_text(value).strip()


def elements(rig: Rig, most: int) -> Iterator[Variable]:
    """All variables one by one, arrays element by element, each as it is named in a program."""
    yield from _scalars(rig)
    for array in rig.basic.state.variables.arrays.values():
        name = _name(array.name, array.kind)
        for index, value in enumerate(islice(array.data, most)):
            subscripts = []
            for dim in array.dims:
                index, subscript = divmod(index, dim)
                subscripts.append(str(subscript))
            yield Variable(f"{name}({','.join(subscripts)})", _value(rig, array.kind, value))


@lru_cache(maxsize=4096)
def line_text(line: Line) -> str:
    """A program line as LIST shows it."""
    number, crunched = line
    return f"{number} {spell(crunched)}"


def _scalars(rig: Rig) -> Iterator[Variable]:
    for scalar in rig.basic.state.variables.order:
        yield Variable(_name(scalar.name, scalar.kind), _value(rig, scalar.kind, scalar.value))


def _variables(rig: Rig) -> Iterator[Variable]:
    yield from _scalars(rig)
    for array in rig.basic.state.variables.arrays.values():
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
