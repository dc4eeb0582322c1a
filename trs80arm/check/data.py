"""The items of a program's DATA, in the order in which READ takes them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from trs80arm.basic import characters, tokens
from trs80arm.basic.errors import BasicError
from trs80arm.basic.numbers import literal
from trs80arm.basic.numbers.convert import Number
from trs80arm.check.statements import Statement


@dataclass(frozen=True)
class Item:
    """One item of DATA.

    Attributes:
        line: the number of its line.
        position: how much of the line's crunched text stands before it.
        text: as READ into a string variable takes it.
        number: as READ into a number takes it; None where that is an error (?SN).
    """

    line: int
    position: int
    text: bytes
    number: Number | None


def items(program: Iterable[Statement]) -> Iterator[Item]:
    """The items of all DATA statements of a program."""
    for statement in program:
        if statement.word == tokens.DATA and not statement.arm:
            yield from _of_statement(statement)


def _of_statement(statement: Statement) -> Iterator[Item]:
    text, place = statement.text, 0
    while True:
        while place < len(text) and text[place] in characters.BLANKS:
            place += 1
        start = place
        if text[place : place + 1] == b'"':
            close = text.find(b'"', place + 1)
            close = len(text) if close < 0 else close
            string, place = text[start + 1 : close], close + 1
        else:
            comma = text.find(b",", place)
            place = len(text) if comma < 0 else comma
            string = text[start:place]
        yield Item(statement.line, statement.text_at + start, string, _number(text[start:]))
        comma = text.find(b",", place)
        if comma < 0:
            return
        place = comma + 1


def _number(text: bytes) -> Number | None:
    """The number that an item begins with, if nothing stands behind it."""
    try:
        value, end = literal.scan(text)
    except BasicError:
        return None
    rest = text[end:].lstrip(characters.BLANKS)
    return value if not rest or rest.startswith(b",") else None
