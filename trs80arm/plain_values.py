"""Between plain values, as TOML and JSON hold them, and the rooms' settings classes.

A settings class says by its fields what a key may be; the settings file, flags, environment and
recordings all come through here. Nothing of the machine is known, only dataclasses and enums.
"""

from __future__ import annotations

import types
import typing
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from enum import Enum, IntEnum
from pathlib import Path
from typing import Any, TypeVar

T = TypeVar("T")


class SettingsError(Exception):
    """A setting that cannot be; one line that names the file, its line and the key."""


def keys_of(cls: type) -> set[str]:
    """The keys of a settings class."""
    return {field.name for field in fields(cls)}


def from_table(cls: type[T], table: Mapping[str, Any], where: str) -> T:
    """Make a settings class from a table of plain values.

    Args:
        cls: a dataclass of plain values, enums, tuples and other such classes.
        table: the values by name; those left out have their defaults.
        where: what errors call the table.

    Raises:
        SettingsError: a key is unknown, or its value cannot be.
    """
    hints = typing.get_type_hints(cls)
    values = {}
    for key, value in table.items():
        if key not in hints:
            raise SettingsError(f"{where}: unknown key {key}")
        try:
            values[key] = fit(hints[key], value)
        except (SettingsError, ValueError) as error:
            raise SettingsError(f"{where}: {key}: {error}") from None
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
        SettingsError: it cannot be that.
    """
    origin, arguments = typing.get_origin(hint), typing.get_args(hint)
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
            raise SettingsError("must be a table")
        return from_table(hint, value, hint.__name__)
    return _fit_plain(hint, value)


def _fit_tuple(arguments: tuple[Any, ...], value: Any) -> tuple[Any, ...]:
    if not isinstance(value, list | tuple):
        raise SettingsError(f"must be a list, not {value!r}")
    if arguments[-1] is Ellipsis:
        return tuple(fit(arguments[0], item) for item in value)
    if len(arguments) != len(value):
        raise SettingsError(f"must be a list of {len(arguments)}, not of {len(value)}")
    return tuple(fit(hint, item) for hint, item in zip(arguments, value, strict=True))


def _fit_enum(hint: type[Enum], value: Any) -> Enum:
    by_name = issubclass(hint, IntEnum)
    for member in hint:
        if str(member.name if by_name else member.value).lower() == str(value).lower():
            return member
    names = ", ".join(str(m.name.lower() if by_name else m.value) for m in hint)
    raise SettingsError(f"must be one of {names}, not {value!r}")


def _fit_plain(hint: Any, value: Any) -> Any:
    if hint is Path and isinstance(value, str):
        return Path(value).expanduser()
    if hint is float and isinstance(value, int) and not isinstance(value, bool):
        return float(value)
    if hint is str and isinstance(value, int | float) and not isinstance(value, bool):
        return str(value)
    if type(value) is not hint:
        words = {bool: "true or false", int: "a whole number", float: "a number", str: "a text"}
        raise SettingsError(f"must be {words.get(hint, hint.__name__)}, not {value!r}")
    return value
