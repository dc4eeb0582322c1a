"""Between plain values, as TOML and JSON hold them, and the classes and files that they set up.

The one validator: the settings file, flags, environment, recordings, snapshots and bench files all
come through here. A settings class says by its fields what a key may be (`from_table`); a file with
more in it takes the keys of its tables one by one (`Table`). Every key is looked at, unknown ones
are refused, and whatever is wrong is one line that names the place and what was expected there.
Nothing of the machine is known, only dataclasses and enums.
"""

from __future__ import annotations

import math
import types
import typing
from collections.abc import Mapping
from dataclasses import dataclass, fields, is_dataclass
from enum import Enum, IntEnum
from functools import cache
from pathlib import Path
from typing import Annotated, Any, TypeVar

from trs80arm.shown import shown

T = TypeVar("T")


class SettingsError(Exception):
    """A value that cannot be; one line that names file, place and key."""


@dataclass(frozen=True)
class Range:
    """What numbers may be, for `Annotated[float, Range(0, 3)]`; both ends belong to it."""

    low: float
    high: float


_REQUIRED: Any = object()
_WORDS = {bool: "true or false", int: "a whole number", float: "a number", str: "a text"}


class Table:
    """One table of a file, whose keys are taken one by one; `done` refuses what is left.

    Args:
        source: the file, as errors call it.
        path: where in it the table is; empty for the whole file.
        data: the table's values.

    Raises:
        SettingsError: from every method: the key lacks, or its value cannot be.
    """

    def __init__(self, source: str, path: str, data: object) -> None:
        self.source = source
        self.path = path
        if not isinstance(data, Mapping):
            raise SettingsError(f"{source}: {path}: expected a table")
        self.data: dict[str, Any] = dict(data)

    def fail(self, key: str, expected: str) -> SettingsError:
        """The error that a key is not what was expected."""
        return SettingsError(shown(f"{self.source}: {self._name(key)}: expected {expected}"))

    def _name(self, key: str) -> str:
        return f"{self.path}.{key}" if self.path else key

    def take(self, key: str, hint: Any, default: Any = _REQUIRED) -> Any:
        """The value of a key as what a field of a type wants; `default` where there is none."""
        if key not in self.data and default is not _REQUIRED:
            return default
        try:
            return fit(hint, self.data.pop(key, None))
        except SettingsError as error:
            raise SettingsError(shown(f"{self.source}: {self._name(key)}: {error}")) from None

    def number(self, key: str, low: float, high: float, default: Any = _REQUIRED) -> float:
        """A finite number."""
        return float(self.take(key, Annotated[float, Range(low, high)], default))

    def integer(self, key: str, low: int, high: int, default: Any = _REQUIRED) -> int:
        """A whole number."""
        return int(self.take(key, Annotated[int, Range(low, high)], default))

    def vector(self, key: str, count: int, low: float, high: float) -> tuple[float, ...]:
        """Some finite numbers."""
        try:
            return _fit_tuple((Annotated[float, Range(low, high)],) * count, self.data.pop(key, 0))
        except SettingsError:
            raise self.fail(key, f"{count} numbers from {low:g} to {high:g}") from None

    def text(self, key: str, default: str | None = None) -> str:
        """A name that can be shown: not empty, no control characters."""
        value = self.data.pop(key, default)
        if not isinstance(value, str) or not value.strip() or not value.isprintable():
            raise self.fail(key, "a name")
        return value

    def tables(self, key: str) -> list[Table]:
        """The tables of an array of them, `[[key]]`."""
        value = self.data.pop(key, [])
        if not isinstance(value, list):
            raise self.fail(key, f"tables, written [[{key}]]")
        name = self._name(key)
        return [Table(self.source, f"{name}[{i}]", item) for i, item in enumerate(value, 1)]

    def table(self, key: str) -> Table | None:
        """A table within, `[key]`; None where there is none."""
        value = self.data.pop(key, None)
        if value is None:
            return None
        if not isinstance(value, Mapping):
            raise self.fail(key, f"a table, written [{key}]")
        return Table(self.source, self._name(key), value)

    def done(self, known: str) -> None:
        """Everything has been taken; the keys there are, for the error if not."""
        for key in self.data:
            raise self.fail(key, f"nothing by that name; the keys here are {known}")


def keys_of(cls: type) -> set[str]:
    """The keys of a settings class."""
    return {field.name for field in fields(cls)}


@cache
def _hints(cls: Any) -> dict[str, Any]:
    """The types of a class's fields, with their ranges."""
    return typing.get_type_hints(cls, include_extras=True)


def from_table(cls: type[T], table: Mapping[str, Any], where: str) -> T:
    """Make a settings class from a table of plain values.

    Args:
        cls: a dataclass of plain values, enums, tuples and other such classes.
        table: the values by name; those left out have their defaults.
        where: what errors call the table.

    Raises:
        SettingsError: a key is unknown, or its value cannot be.
    """
    taken = Table(where, "", table)
    known: Any = cls
    hints = _hints(known)
    values = {key: taken.take(key, hints[key]) for key in table if key in keys_of(cls)}
    taken.done(", ".join(sorted(keys_of(cls))))
    try:
        return cls(**values)
    except (TypeError, ValueError) as error:
        raise SettingsError(f"{where}: {error}") from None


def as_table(settings: Any, *, with_defaults: bool = False) -> dict[str, Any]:
    """The plain values of a settings class: those that differ from the defaults, or all."""
    defaults = type(settings)()
    table = {}
    for field in fields(settings):
        value = getattr(settings, field.name)
        if with_defaults or value != getattr(defaults, field.name):
            table[field.name] = _plain(value)
    return table


def _plain(value: Any) -> Any:
    if is_dataclass(value):
        return as_table(value)
    if isinstance(value, IntEnum):
        return value.name.lower()
    if isinstance(value, Enum):
        return str(value.value)
    if isinstance(value, Path):
        return str(value)
    if isinstance(value, tuple):
        return ["" if item is None else _plain(item) for item in value]
    return value


def fit(hint: Any, value: Any) -> Any:
    """A plain value as what a field of that type wants.

    Raises:
        SettingsError: it cannot be that; the message says what was expected.
    """
    origin, arguments = typing.get_origin(hint), typing.get_args(hint)
    if origin is Annotated:
        return _fit_range(arguments[0], arguments[1], value)
    if origin in (typing.Union, types.UnionType):
        if value in (None, ""):
            return None
        [wanted] = [argument for argument in arguments if argument is not type(None)]
        return fit(wanted, value)
    if origin is tuple:
        return _fit_tuple(arguments, value)
    if isinstance(hint, type) and issubclass(hint, Enum):
        return _fit_enum(hint, value)
    if is_dataclass(hint) and isinstance(hint, type):
        if not isinstance(value, Mapping):
            raise SettingsError("expected a table")
        return from_table(hint, value, hint.__name__)
    return _fit_plain(hint, value)


def _fit_range(hint: Any, within: Range, value: Any) -> Any:
    word = _WORDS[hint]
    try:
        number = _fit_plain(hint, value)
    except SettingsError:
        number = math.nan
    if not within.low <= number <= within.high:
        ends = (f"{end:g}" if hint is float else str(end) for end in (within.low, within.high))
        raise SettingsError(f"expected {word} from {' to '.join(ends)}")
    return number


def _fit_tuple(arguments: tuple[Any, ...], value: Any) -> tuple[Any, ...]:
    if not isinstance(value, list | tuple):
        raise SettingsError("expected a list")
    if arguments[-1] is Ellipsis:
        return tuple(fit(arguments[0], item) for item in value)
    if len(arguments) != len(value):
        raise SettingsError(f"expected a list of {len(arguments)}")
    return tuple(fit(hint, item) for hint, item in zip(arguments, value, strict=True))


def _fit_enum(hint: type[Enum], value: Any) -> Enum:
    by_name = issubclass(hint, IntEnum)
    if isinstance(value, str | int | float):
        for member in hint:
            if str(member.name if by_name else member.value).lower() == _text(value).lower():
                return member
    names = ", ".join(str(m.name.lower() if by_name else m.value) for m in hint)
    raise SettingsError(f"expected one of {names}")


def _fit_plain(hint: Any, value: Any) -> Any:
    if hint is Path and isinstance(value, str) and "\0" not in value:
        return _path(value)
    if hint is float and isinstance(value, int) and not isinstance(value, bool):
        value = float(value) if abs(value) < 2**1000 else math.inf
    if hint is str and isinstance(value, int | float) and not isinstance(value, bool):
        return _text(value)
    if type(value) is not hint or (hint is float and not math.isfinite(value)):
        raise SettingsError(f"expected {_WORDS.get(hint, 'a path')}")
    return value


def _path(text: str) -> Path:
    try:
        return Path(text).expanduser()
    except RuntimeError:
        raise SettingsError("expected a path; nobody of that name has a home") from None


def _text(value: str | float) -> str:
    """A number as a text; of one with more digits than Python spells out nothing can be said."""
    try:
        return str(value)
    except ValueError:
        raise SettingsError("expected a number with fewer digits") from None
