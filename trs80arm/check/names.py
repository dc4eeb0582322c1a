"""Names of variables as they are written, of which Level II looks at two characters."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Final

from trs80arm.basic import tokens

_REST: Final = bytes((tokens.REM,))
_DATA: Final = bytes((tokens.DATA,))
_WORDS: Final = re.compile(
    rb'"[^"]*"?'  # A string,
    rb"|" + re.escape(_REST) + rb".*"  # a remark,
    rb"|" + re.escape(_DATA) + rb'(?:"[^"]*"?|[^:"])*'  # data,
    rb"|[0-9.][0-9. ]*(?:[ED](?=[ 0-9\xcd\xce])[ \xcd\xce]*[0-9 ]*)?"  # a number,
    rb"|(?P<name>[A-Z](?: *[A-Z0-9])*)(?P<kind> *[%!#$])?(?P<array> *\()?",  # a name.
    re.DOTALL,
)


@dataclass(frozen=True)
class Clash:
    """A name that is the same variable as another one.

    Attributes:
        line: the number of the line where it stands first.
        position: how much of the line's crunched text stands before it.
        name: the name.
        other: the name that is the same variable.
        other_line: the number of the line where that stands first.
    """

    line: int
    position: int
    name: str
    other: str
    other_line: int


def clashes(lines: Iterable[tuple[int, bytes]]) -> Iterator[Clash]:
    """Names in a program that differ only behind their second character.

    Args:
        lines: the program: line numbers and crunched texts.
    """
    first: dict[tuple[str, str, bool], tuple[str, int]] = {}
    told: set[str] = set()
    for line, text in lines:
        for found in _WORDS.finditer(text):
            if found["name"] is None:
                continue
            name = found["name"].replace(b" ", b"").decode("ascii")
            kind = (found["kind"] or b"").strip().decode("ascii")
            key = name[:2], kind, found["array"] is not None
            other, other_line = first.setdefault(key, (name, line))
            spelled = name + kind
            if other != name and spelled not in told:
                told.add(spelled)
                yield Clash(line, found.start(), spelled, other + kind, other_line)
