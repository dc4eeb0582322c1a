"""READ and the DATA items, and the variables of an INPUT."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from trs80arm.basic import costs, number_costs, tokens
from trs80arm.basic.characters import BLANKS, CLOSE, COLON, COMMA, END, OPEN, QUOTE
from trs80arm.basic.dialogue.input_statement import InputStatement
from trs80arm.basic.dialogue.tape_statements import InputTape
from trs80arm.basic.errors import BasicError, Code, LineError
from trs80arm.basic.execution import Leave, under_way
from trs80arm.basic.kinds import DOUBLE, Kind
from trs80arm.basic.numbers import convert, double, literal
from trs80arm.basic.runtime.part import Part
from trs80arm.basic.state import State
from trs80arm.basic.variables import Descriptor

ADDRESSES = 0x10000


def around_from(address: int) -> Iterator[int]:
    """Every address once, from one on and around the end of memory, as the Z-80 counts."""
    for place in range(address, address + ADDRESSES):
        yield place & 0xFFFF


class ListedTarget:
    """One variable of an INPUT's list, found when it is asked for.

    Attributes:
        address: of its name in the text.
    """

    _state: State
    _targets: Targets
    _number: int
    _found: Any

    def __init__(self, state: State, targets: Targets, number: int) -> None:
        self._state = state
        self._targets = targets
        self._number = number
        self._found = None

    @property
    def kind(self) -> Kind:
        """The variable's type; looking at it finds the variable, subscripts and all."""
        self._found = self._targets.find(self._number)
        kind: Kind = self._found.kind
        return kind

    def assign(self, value: Any) -> None:
        """Give the variable that was found a value."""
        self._found.assign(value)


class Targets:
    """The list of variables of an INPUT statement, read as the answer is."""

    _state: State
    _places: list[int]

    def __init__(self, state: State, address: int) -> None:
        self._state = state
        self._places = [address]

    def __len__(self) -> int:
        ram = self._state.memory.ram
        count, depth = 1, 0
        for address in around_from(self._places[0]):
            code = ram[address]
            if code in (0, COLON):
                break
            depth += (code == OPEN) - (code == CLOSE)
            count += code == COMMA and depth <= 0
        return count

    def __getitem__(self, number: int) -> ListedTarget:
        if number >= len(self):
            raise IndexError(number)
        return ListedTarget(self._state, self, number)

    def restart(self) -> None:
        """Begin again with the first variable."""
        del self._places[1:]

    @property
    def at_end(self) -> bool:
        """Whether the statement ends behind the variables found."""
        return self._state.memory.ram[self._places[-1]] in (END, COLON)

    def find(self, number: int) -> Any:
        """The variable of that number; what comes before it has been found already."""
        del self._places[number + 1 :]
        address = self._places[number]
        reference, end = self._state.engine.find_target(address)
        ram = self._state.memory.ram
        if ram[end] == COMMA:
            end += 1
            while ram[end] in BLANKS:
                end += 1
        self._places.append(end)
        return reference

    def finish(self) -> int:
        """Where the program goes on: behind the last variable, or behind the statement."""
        address = self._places[-1]
        if len(self._places) <= len(self):
            return self._state.program.statement_end(address)
        return address


_LAST = 0xFFF0
"""No program reaches so far up; the reader of a broken one stops here."""


class DataReader(Part):
    """The DATA pointer."""

    _place = 0

    def restore(self) -> None:
        """RESTORE."""
        self._control.data = self._state.program.start - 1

    def begin_read(self) -> None:
        """READ begins."""
        self._place = self._control.data

    def end_read(self) -> None:
        """READ has all it wants; after an error it would begin with the same items again."""
        self._control.data = self._place

    def _item(self) -> int:
        """The address of the next item; OD when there is none."""
        ram = self._ram
        control = self._control
        address = self._place & 0xFFFF
        if ram[address] == COMMA:
            return self._skip(address + 1)
        while True:
            if address >= _LAST:
                raise BasicError(Code.OD)
            if not ram[address]:
                if not (ram[address + 1] or ram[address + 2]):
                    raise BasicError(Code.OD)
                control.data_line = self._state.program.number_at(address + 1)
                address += 4
                self._clock.now += costs.DATA_LINE
            else:
                self._clock.now += costs.DATA_STATEMENT
            address = self._skip(address + 1)
            if ram[address] == tokens.DATA:
                return self._skip(address + 1)
            start = address
            address = self._state.program.statement_end(start)
            self._clock.now += costs.SKIPPED * (address - start)

    def _skip(self, address: int) -> int:
        if self._ram[address & 0xFFFF] in BLANKS:
            for place in around_from(address):
                if self._ram[place] not in BLANKS:
                    return place
        return address & 0xFFFF

    def _distance(self, start: int, ends: bytes) -> int:
        """How many characters there are from an address to one of the codes in `ends`."""
        for length, place in enumerate(around_from(start)):
            if self._ram[place] in ends:
                return length
        return ADDRESSES

    def end_item(self) -> None:
        """Behind an item must be a comma, a colon or the end; SN in the DATA line.

        The ROM looks only when the item is in its variable: `12X` leaves 12 there.
        """
        address = self._skip(self._place)
        if self._ram[address] not in (END, COLON, COMMA):
            raise LineError(Code.SN, self._control.data_line)
        self._place = address

    def read_number(self, kind: Kind) -> Any:
        """READ of a number; OV, and SN in READ's own line for `1%` into a double."""
        address = self._item()
        text = self._state.program.text_from(address)
        meter = number_costs.LiteralMeter()
        value, end = literal.scan(text, 0, double.ZERO if kind == DOUBLE else 0, meter)
        self._clock.now += costs.constant(value, meter.total) + costs.read(kind, value)
        self._place = address + end
        return convert.to_kind(kind, value)

    def read_string(self) -> Descriptor:
        """READ of a string: it stays where it is in the program."""
        address = self._item()
        ram = self._ram
        start = address
        if ram[address] == QUOTE:
            start = address + 1 & 0xFFFF
            length = self._distance(start, b'\0"')
            address = start + length
            if ram[address & 0xFFFF]:
                address += 1
        else:
            length = self._distance(start, b"\0:,")
            address += length
        self._clock.now += costs.STRING_LITERAL + costs.STRING_CHARACTER * length
        self._place = address
        return self._strings.literal(length, start)

    # -- INPUT --------------------------------------------------------------------------------

    def _ask(self, address: int) -> Targets:
        execution = under_way(self._state)
        assert execution is not None
        targets = Targets(self._state, address)
        execution.targets = targets
        return targets

    def begin_input(self, prompt: bytes, address: int) -> None:
        """INPUT: the dialogue asks; `address` is where the list of variables begins."""
        targets = self._ask(address)
        self._state.begin(InputStatement(prompt, targets))
        raise Leave(address)

    def begin_tape_input(self, _unit: int, address: int) -> None:
        """INPUT#-1."""
        targets = self._ask(address)
        self._state.begin(InputTape(targets))
        raise Leave(address)
