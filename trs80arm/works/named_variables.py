"""The variables of a BASIC program by their names, read and written from outside.

Reading takes none of the machine's time; writing is an assignment that the machine itself does
beside the program, checked as a typed one.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from trs80arm.basic import addresses
from trs80arm.basic.kinds import BY_SIZE, DOUBLE, INTEGER, SINGLE, STRING, Kind
from trs80arm.basic.numbers import double
from trs80arm.basic.variables import Key
from trs80arm.works.devices import Language

Value = int | float | str
"""What a variable holds, as Python has it."""
MARKS = {INTEGER: "%", SINGLE: "!", DOUBLE: "#", STRING: "$"}
"""What stands behind a name to say its type."""
_SUFFIXES = {mark: kind for kind, mark in MARKS.items()}
_NAME = re.compile(r"([A-Z][A-Z0-9]?)[A-Z0-9]*([%!#$]?)(?:\((.*)\))?")


def is_name(text: str) -> bool:
    """Whether that is written as a variable's name, or an element's."""
    return bool(_NAME.fullmatch(text))


def stored_value(basic: Language, name: str) -> Any:
    """What a variable, or an element of an array, holds: a number of the machine's, or text.

    Args:
        basic: the language with its memory.
        name: as in a program, `A`, `B$`, `C%(3,I)`; a subscript is a number or a variable's name.

    Raises:
        LookupError: there is none; one line that says why.
    """
    found = _NAME.fullmatch(name.strip().upper().replace(" ", ""))
    if found is None:
        raise LookupError(f"{name.strip()} is no name of a variable")
    key = _key(basic, found[1], found[2])
    variables = basic.state.variables
    if found[3] is None:
        scalar = variables.scalars.get(key)
        if scalar is None or scalar.offset is None:
            raise LookupError(f"there is no {_told(key)} yet")
        return _plain(basic, key[1], scalar.value)
    array = variables.arrays.get(key)
    if array is None:
        raise LookupError(f"there is no array {_told(key)}() yet")
    index, size = 0, 1
    subscripts = [_subscript(basic, part) for part in found[3].split(",")]
    if len(subscripts) != len(array.dims):
        raise LookupError(f"{_told(key)}() has {len(array.dims)} subscripts")
    for subscript, dim in zip(subscripts, array.dims, strict=True):
        if not 0 <= subscript < dim:
            raise LookupError(f"{_told(key)}() has no element {found[3]}")
        index += subscript * size
        size *= dim
    return _plain(basic, key[1], array.data[index])


def as_number(value: Any) -> float:
    """A number of any type, to be compared."""
    if isinstance(value, double.Double):
        return float(value.mantissa) * 2.0 ** (value.exponent - 128 - double.BITS)
    return float(value)


class NamedVariables(Mapping[str, Value]):
    """A program's variables by name: `variables["A1"]`, `variables["N$"] = "BOLT"`.

    Names are as in a program: two characters count, `%`, `!`, `#` and `$` say the type, and DEFINT
    and its like hold for names without. An element of an array is `variables["P(3,1)"]`; a
    subscript may be a variable's name. Numbers are `int` for an integer and `float` for the
    others, a double rounded to Python's 53 bits; strings are `str`, a character a byte.

    Iterated, it gives the simple variables in the order of their creation, then the arrays
    element by element. A variable that the program has not made yet is not there.

    Args:
        basic: the language with its memory.
        change: does an assignment beside the program, `Rig.change`.
    """

    def __init__(self, basic: Language, change: Callable[[str], None]) -> None:
        self._basic = basic
        self._change = change

    def __getitem__(self, name: str) -> Value:
        """What a variable holds.

        Raises:
            KeyError: there is none; what it holds says why.
        """
        try:
            value = stored_value(self._basic, name)
        except LookupError as error:
            raise KeyError(str(error)) from None
        return value if isinstance(value, int | str) else as_number(value)

    def __setitem__(self, name: str, value: Value) -> None:
        """Give a variable a value, in no time, as an assignment of the program would.

        A variable that is not there yet is made. RUN and CLEAR forget all of them.

        Raises:
            ChangeError: the machine does not take it, as `?OV Error` or `?TM Error`, or the name
                is none.
        """
        self._change(f"{name}={_literal(value)}")

    def __iter__(self) -> Iterator[str]:
        variables = self._basic.state.variables
        for scalar in variables.order:
            yield self._name((scalar.name, scalar.kind))
        for array in variables.arrays.values():
            name = self._name((array.name, array.kind))
            for index in range(len(array.data)):
                subscripts = []
                for dim in array.dims:
                    index, subscript = divmod(index, dim)
                    subscripts.append(str(subscript))
                yield f"{name}({','.join(subscripts)})"

    def __len__(self) -> int:
        variables = self._basic.state.variables
        return len(variables.order) + sum(len(each.data) for each in variables.arrays.values())

    def __repr__(self) -> str:
        return f"NamedVariables({dict(self)!r})"

    def _name(self, key: Key) -> str:
        """A name that means this very variable, with a mark only where it needs one."""
        return key[0] if _key(self._basic, key[0], "") == key else key[0] + MARKS[key[1]]


def _literal(value: Value) -> str:
    """A value as it would be typed."""
    if isinstance(value, str):
        # A quotation mark cannot stand within quotation marks.
        return "+CHR$(34)+".join(f'"{part}"' for part in value.split('"'))
    if not math.isfinite(value):
        raise ValueError(f"the machine has no number {value}")
    return repr(value + 0).upper()


def _told(key: Key) -> str:
    return key[0] + ("" if key[1] == SINGLE else MARKS[key[1]])


def _subscript(basic: Language, text: str) -> int:
    if text.isdecimal():
        return int(text)
    value = stored_value(basic, text)
    if isinstance(value, str):
        raise LookupError(f"{text} is no number")
    return int(as_number(value))


def _key(basic: Language, name: str, suffix: str) -> Key:
    if suffix:
        return name, _SUFFIXES[suffix]
    code = basic.state.memory.ram[addresses.TYPE_TABLE + ord(name[0]) - ord("A")]
    return name, BY_SIZE.get(code, SINGLE)


def _plain(basic: Language, kind: Kind, value: Any) -> Any:
    if kind == STRING:
        return basic.state.strings.bytes_of(value).decode("latin-1")
    return value
