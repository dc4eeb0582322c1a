"""Where compiled functions stand in the program, and how they move with it when a line is edited.

Generated text names no address. Where one belongs there is a placeholder, a number that is no
address, and beside the text is the list of what the placeholders stand for. So the text of a
statement is the same wherever it stands, what Python makes of it is made once, and a function whose
place in memory has changed is had from the same code by another list.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from types import CellType, CodeType, FunctionType
from typing import Any, Final, NamedTuple

from trs80arm.basic.control import ForFrame, GosubFrame
from trs80arm.basic.program import Change, Program

_FIRST: Final = 10**20
"""The first placeholder; no number of the language is a whole one as large."""
_PLACEHOLDER: Final = re.compile(rf"\b1\d{{{len(str(_FIRST)) - 1}}}\b")
Framed = Callable[[int], GosubFrame | list[ForFrame]]
"""Makes what a function keeps for a subroutine or a loop that it opens, by where that goes back."""


def placeholder(index: int) -> str:
    """What stands in generated text for an address of the list."""
    return str(_FIRST + index)


def with_addresses(text: str, addresses: Sequence[int]) -> str:
    """Generated text, addresses in it."""
    return _PLACEHOLDER.sub(lambda found: str(addresses[int(found[0]) - _FIRST]), text)


class Code(NamedTuple):
    """What Python made of generated text.

    Attributes:
        code: with placeholders among its constants.
        placeholders: where in the constants they are, and which.
    """

    code: CodeType
    placeholders: tuple[tuple[int, int], ...]

    @classmethod
    def of(cls, code: CodeType) -> Code:
        """Code, its placeholders found."""
        constants = enumerate(code.co_consts)
        found = ((i, c - _FIRST) for i, c in constants if isinstance(c, int) and c >= _FIRST)
        return cls(code, tuple(found))

    def at(self, addresses: Sequence[int]) -> CodeType:
        """The code with addresses for placeholders."""
        if not self.placeholders:
            return self.code
        constants = list(self.code.co_consts)
        for place, index in self.placeholders:
            constants[place] = addresses[index]
        return self.code.replace(co_consts=tuple(constants))


@dataclass(frozen=True, slots=True)
class Relocatable:
    """A function, but for the addresses in it.

    Attributes:
        code: what it does.
        environment: the names that it may use.
        cells: what it closes over, in the order of its code.
        frames: which of these it opens loops and subroutines with, how each is made, and the
            index of the address that it is made by.
        first_line: text lines in front of the first emitted one.
    """

    code: Code
    environment: dict[str, Any]
    cells: tuple[CellType, ...]
    frames: tuple[tuple[int, Framed, int], ...]
    first_line: int

    def at(self, addresses: Sequence[int]) -> FunctionType:
        """The function whose placeholders stand for certain addresses."""
        cells = self.cells
        if self.frames:
            own = list(cells)
            for place, framed, index in self.frames:
                own[place] = CellType(framed(addresses[index]))
            cells = tuple(own)
        return FunctionType(self.code.at(addresses), self.environment, "statement", None, cells)


def lines_passed(program: Program, number: int, behind: int | None) -> int:
    """How many lines the ROM passes before it stops at a number.

    Args:
        program: in memory.
        number: of the line that it looks for.
        behind: the number of the line that it begins behind, None for the program's start.
    """
    first = 0 if behind is None else program.place(behind) + 1
    return max(0, program.place(number) - first)


class Search(NamedTuple):
    """A line that a jump looks for.

    Attributes:
        number: of the line.
        behind: as of `lines_passed`.
        passed: how many lines the ROM passes.
    """

    number: int
    behind: int | None
    passed: int

    def holds(self, program: Program) -> bool:
        """Whether as many lines are passed still."""
        return lines_passed(program, self.number, self.behind) == self.passed


class Location(NamedTuple):
    """Where a function stands.

    Attributes:
        addresses: what its placeholders stand for, its own beginning first.
        spans: the lowest and the highest address of each piece of text that it was made from.
        high: the highest of these.
        searches: the lines that its jumps look for.
    """

    addresses: tuple[int, ...]
    spans: tuple[tuple[int, int], ...]
    high: int
    searches: tuple[Search, ...]

    def after(self, changes: Sequence[Change], program: Program) -> Location | None:
        """Where it stands when the program was changed, None if its text is another one.

        Every address in it lies in one of its spans or is the separator in front of one.
        """
        addresses, spans, high, searches = self
        touched = False
        for first, behind, by in changes:
            if high < first:
                continue
            if any(end >= first and start < behind for start, end in spans):
                return None
            if not by:
                continue
            if behind - 1 in addresses and any(start < behind for start, _ in spans):
                # The end of what stands before the edit, or the beginning of what stands behind.
                return None
            touched = True
            addresses = tuple([each + by if each + 1 >= behind else each for each in addresses])
            spans = tuple([_moved(span, behind, by) for span in spans])
            high = max(end for _, end in spans)
        if not touched:
            return self
        if not all(search.holds(program) for search in searches):
            return None
        return Location(addresses, spans, high, searches)


def _moved(span: tuple[int, int], behind: int, by: int) -> tuple[int, int]:
    """A piece of text, so many bytes further up if it stands behind an edit."""
    start, end = span
    return (start + by, end + by) if start >= behind else span
