"""Constants of a BASIC program, found and replaced, so that a run differs in one number.

A variable is varied where the program itself gives it a plain number, as in `D=50`: the number is
replaced in the program's text, and nothing else. So the program that runs is one that its author
could have typed, and the assignment comes when it comes in the program.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from trs80arm.basic import tokens, words
from trs80arm.basic.cruncher import crunch
from trs80arm.sweep.axes import SweepError

Line = tuple[int, bytes]
_SIGN = bytes((tokens.MINUS, tokens.PLUS))
_NUMBER = re.compile(rb"(?:\d+\.?\d*|\.\d+)(?:[ED][+-" + re.escape(_SIGN) + rb"]?\d+)?[%!#]?")
_NAME = re.compile(rb"([A-Z][A-Z0-9]?)[A-Z0-9]*([%!#$]?)")
_ASSIGNED = re.compile(
    rb" *([A-Z][A-Z0-9]?)[A-Z0-9 ]*([%!#]?) *"
    + re.escape(bytes((tokens.EQUAL,)))
    + rb" *((?:"
    + re.escape(bytes((tokens.MINUS,)))
    + rb" *)?"
    + _NUMBER.pattern
    + rb") *(?=:|$)"
)
_LONGEST = 240
_LET = words.TOKENS["LET"]


@dataclass(frozen=True)
class Constant:
    """A number in a line of a program.

    Attributes:
        line: the line's number.
        start: where in the crunched text it begins, its sign included.
        stop: where it ends.
        in_data: whether it is an item of DATA, which is not crunched.
    """

    line: int
    start: int
    stop: int
    in_data: bool = False


def find(lines: Sequence[Line], name: str) -> tuple[Constant, ...]:
    """The constants that a name means.

    Args:
        lines: the program, crunched.
        name: `D`, the one assignment of a plain number to D; `D@420`, that in line 420; `470#2`,
            the second number in the text of line 470, in DATA too; `470-490#2`, that of each line
            from 470 to 490.

    Raises:
        SweepError: there is none, or more than one assignment.
    """
    where, number_sign, place = name.partition("#")
    if number_sign and name[0].isdigit():
        first, _, last = where.partition("-")
        return tuple(_in_lines(lines, name, int(first), int(last or first), int(place)))
    variable, at, line = name.partition("@")
    head = _NAME.fullmatch(variable.encode())
    assert head is not None  # By the pattern of axes.
    wanted = head[1], head[2].replace(b"!", b"")
    assigned = [
        constant
        for constant, key in _assignments(lines)
        if key == wanted and (not at or constant.line == int(line))
    ]
    if not assigned:
        where = f"line {line} does not give" if at else "no line gives"
        raise SweepError(
            f"--vary {name}: {where} {variable} a plain number, as {variable}=50, "
            "that could be replaced"
        )
    if len(assigned) > 1:
        places = ", ".join(str(constant.line) for constant in assigned)
        more = "" if at else f"; say which, as {variable}@{assigned[0].line}"
        raise SweepError(
            f"--vary {name}: {variable} is given a plain number more than once, in {places}{more}"
        )
    return (assigned[0],)


def _in_lines(
    lines: Sequence[Line], name: str, first: int, last: int, place: int
) -> Iterator[Constant]:
    """The number of a place in each of some lines."""
    numbers = [number for number, _ in lines if first <= number <= last]
    if not numbers:
        where = f"line {first}" if first == last else f"lines {first} to {last}"
        raise SweepError(f"--vary {name}: the program has no {where}")
    for number in numbers:
        found = list(_numbers(lines, number))
        if not 1 <= place <= len(found):
            count = "1 number" if len(found) == 1 else f"{len(found) or 'no'} numbers"
            raise SweepError(f"--vary {name}: line {number} has {count}")
        yield found[place - 1]


def replaced(lines: Sequence[Line], changes: Mapping[Constant, float]) -> list[Line]:
    """The program with other numbers in the place of some constants.

    Raises:
        SweepError: a line gets too long.
    """
    changed = []
    for number, text in lines:
        here = sorted(
            (constant for constant in changes if constant.line == number),
            key=lambda constant: -constant.start,
        )
        for constant in here:
            new = number_text(changes[constant]).encode()
            new = new if constant.in_data else crunch(new).text
            text = text[: constant.start] + new + text[constant.stop :]
        if len(text) > _LONGEST:
            raise SweepError(f"line {number} gets too long to be typed")
        changed.append((number, text))
    return changed


def number_text(value: float) -> str:
    """A number as it is typed, whole ones without a point."""
    return str(int(value)) if value == int(value) and abs(value) < 1e9 else repr(value).upper()


def _pieces(text: bytes) -> Iterator[tuple[int, int, bool]]:
    """The stretches of a line outside strings and remarks, and whether each is of a DATA."""
    start = position = 0
    in_data = False
    while position < len(text):
        code = text[position]
        if code == 0x22:
            yield start, position, in_data
            end = text.find(b'"', position + 1)
            start = position = len(text) if end < 0 else end + 1
            continue
        if code == tokens.REM and not in_data:
            yield start, position, False
            return
        if code in (tokens.DATA, ord(":")):
            yield start, position, in_data
            start = position
            in_data = code == tokens.DATA
        position += 1
    yield start, position, in_data


def _numbers(lines: Sequence[Line], wanted: int) -> Iterator[Constant]:
    """The numbers of one line, in order."""
    for number, text in lines:
        if number != wanted:
            continue
        for start, stop, in_data in _pieces(text):
            position = start
            while position < stop:
                name = _NAME.match(text, position, stop)
                found = _NUMBER.match(text, position, stop)
                if found:
                    yield Constant(number, _with_sign(text, start, position), found.end(), in_data)
                position = max(position + 1, name.end() if name else 0, found.end() if found else 0)


def _with_sign(text: bytes, start: int, position: int) -> int:
    """Where a number begins whose first digit is at a position: at its minus, if it has one."""
    before = text[start:position].rstrip(b" ")
    if before[-1:] not in (b"-", bytes((tokens.MINUS,))):
        return position
    ahead = before[:-1].rstrip(b" ")[-1:]
    # Behind something that has a value it subtracts.
    return position if ahead and re.match(rb"[A-Z0-9.)%!#$]", ahead) else start + len(before) - 1


def _assignments(lines: Sequence[Line]) -> Iterator[tuple[Constant, tuple[bytes, bytes]]]:
    """The statements that give a simple variable a plain number, and the names of these."""
    begins = bytes((ord(":"), tokens.THEN, tokens.ELSE, _LET))
    for number, text in lines:
        for start, stop, in_data in _pieces(text):
            if in_data:
                continue
            places = [start] if start == 0 else []
            places += [place + 1 for place in range(start, stop) if text[place] in begins]
            for place in places:
                found = _ASSIGNED.match(text, place, stop)
                if found:
                    key = found[1], found[2].replace(b"!", b"")
                    yield Constant(number, found.start(3), found.end(3)), key
