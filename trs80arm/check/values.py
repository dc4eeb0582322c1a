"""Values of a program that is followed without being run: known or not, and from which DATA.

What is known is computed by the machine's own arithmetic. What is not (an answer to INPUT, a
sensor, a chance) is a name for itself: the same expression of the same unknowns is the same
unknown.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Final

from trs80arm.basic import tokens, words
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.numbers import convert, decimal, double, functions, literal
from trs80arm.basic.numbers.convert import Number
from trs80arm.basic.numbers.double import Double

Items = frozenset[int]
"""Places of DATA items in the order of READ."""
NO_ITEMS: Final[Items] = frozenset()
_LONGEST: Final = 255
"""Characters of a string."""


@dataclass(frozen=True, slots=True)
class Unknown:
    """A value that reading does not tell.

    Attributes:
        name: says which; that of a computed one is made of those that it was computed from.
        size: how many names are in it.
    """

    name: Any
    size: int = 1


Held = Number | bytes | Unknown


@dataclass(frozen=True, slots=True)
class Value:
    """A value and where it comes from.

    Attributes:
        held: a number, a string, or that it is unknown.
        items: the DATA that it was computed from.
        as_read: whether it is an item just as it was read.
    """

    held: Held
    items: Items = NO_ITEMS
    as_read: bool = False

    @property
    def known(self) -> bool:
        """Whether reading tells it."""
        return not isinstance(self.held, Unknown)


class Failure(Exception):  # noqa: N818 - the program's, not ours
    """A BASIC error, and the DATA that what failed was computed from."""

    def __init__(self, code: Code, items: Items = NO_ITEMS) -> None:
        super().__init__(code)
        self.code = code
        self.items = items


def number(held: Held) -> Number:
    """What is held, which must be a number; TM."""
    if isinstance(held, (int, float, Double)):
        return held
    raise BasicError(Code.TM)


def string(held: Held) -> bytes:
    """What is held, which must be a string; TM."""
    if isinstance(held, bytes):
        return held
    raise BasicError(Code.TM)


def added(a: Held, b: Held) -> Held:
    """A sum, or two strings in a row."""
    if isinstance(a, bytes) and isinstance(b, bytes):
        if len(a) + len(b) > _LONGEST:
            raise BasicError(Code.LS)
        return a + b
    return convert.add(number(a), number(b))


def compared(mask: int, a: Held, b: Held) -> int:
    """-1 where a relation holds, else 0; `mask` has 1 for greater, 2 for equal, 4 for less."""
    if isinstance(a, bytes) and isinstance(b, bytes):
        order = (a > b) - (a < b)
    else:
        order = convert.compare(number(a), number(b))
    return -(mask >> (1 - order) & 1)


OPERATIONS: Final[dict[int, Callable[[Held, Held], Held]]] = {
    tokens.PLUS: added,
    tokens.MINUS: lambda a, b: convert.sub(number(a), number(b)),
    tokens.TIMES: lambda a, b: convert.mul(number(a), number(b)),
    tokens.DIVIDE: lambda a, b: convert.div(number(a), number(b)),
    tokens.POWER: lambda a, b: functions.power(convert.to_single(a), convert.to_single(b)),
    tokens.AND: lambda a, b: convert.to_integer(a) & convert.to_integer(b),
    tokens.OR: lambda a, b: convert.to_integer(a) | convert.to_integer(b),
}
"""What an operator makes of two known operands."""


def _byte(held: Held) -> int:
    value = convert.to_integer(held)
    if not 0 <= value < 256:
        raise BasicError(Code.FC)
    return value


def _middle(text: Held, start: Held, length: Held = 255) -> bytes:
    first = _byte(start)
    if not first:
        raise BasicError(Code.FC)
    return string(text)[first - 1 :][: _byte(length)]


def _right(text: Held, length: Held) -> bytes:
    count = _byte(length)
    return string(text)[-count:] if count else b""


def _code(text: Held) -> int:
    if not string(text):
        raise BasicError(Code.FC)
    return string(text)[0]


def _repeated(count: Held, what: Held) -> bytes:
    code = _code(what) if isinstance(what, bytes) else _byte(what)
    return bytes((code,)) * _byte(count)


def _of_single(function: Callable[[float], float]) -> Callable[[Held], Held]:
    return lambda x: function(convert.to_single(x))


_BY_SPELLING: Final[dict[str, Callable[..., Held]]] = {
    **{
        name: _of_single(getattr(functions, name.lower()))
        for name in ("SQR", "LOG", "EXP", "COS", "SIN", "TAN", "ATN")
    },
    "SGN": lambda x: convert.sign(number(x)),
    "INT": lambda x: convert.int_(number(x)),
    "FIX": lambda x: convert.fix(number(x)),
    "ABS": lambda x: convert.absolute(number(x)),
    "CINT": convert.to_integer,
    "CSNG": convert.to_single,
    "CDBL": convert.to_double,
    "LEN": lambda text: len(string(text)),
    "ASC": _code,
    "CHR$": lambda code: bytes((_byte(code),)),
    "VAL": lambda text: literal.scan(string(text), 0, double.ZERO).value,
    "STR$": lambda x: decimal.number_text(number(x)).encode("latin-1"),
    "LEFT$": lambda text, length: string(text)[: _byte(length)],
    "RIGHT$": _right,
    "MID$": _middle,
    "STRING$": _repeated,
}
FUNCTIONS: Final = {words.TOKENS[name]: call for name, call in _BY_SPELLING.items()}
"""What a function makes of known arguments; the others look at the machine."""
CURVED: Final = frozenset(
    words.TOKENS[name] for name in ("SQR", "LOG", "EXP", "COS", "SIN", "TAN", "ATN")
)
"""The functions that geometry is done by."""
