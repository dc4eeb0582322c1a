"""Every setting with its meaning, its default and what it may be, as the settings classes say.

The classes are the one truth: types and defaults are those of their fields, meanings those of the
sections `Attributes:` in their docstrings.
"""

from __future__ import annotations

import inspect
import re
import typing
from dataclasses import dataclass, field
from enum import Enum, IntEnum
from typing import Any

from trs80arm.plain_values import SettingsError, as_table, fit
from trs80arm.settings import plain_value, tables

_ENTRY = re.compile(r"^    (\w[\w, ]*): (.*)$")
"""A line of a section `Attributes:` that begins the words on one attribute or some."""


@dataclass(frozen=True)
class Setting:
    """One setting.

    Attributes:
        table: in which table of the file it stands.
        key: its name there.
        meaning: what it does.
        default: what it is unless it is set, as TOML and JSON have it.
        choices: the values that it may have, where these are few.
    """

    table: str
    key: str
    meaning: str
    default: Any = field(hash=False)
    choices: tuple[str, ...]

    @property
    def name(self) -> str:
        """`table.key`."""
        return f"{self.table}.{self.key}"

    def check(self, text: str) -> Any:
        """The value that a text says, as the file has it.

        Raises:
            SettingsError: it cannot have it; one line that says what was expected.
        """
        cls = tables()[self.table]
        value = plain_value(text, self.table, self.key)
        fitted = fit(typing.get_type_hints(cls)[self.key], value)
        try:
            cls(**{self.key: fitted})
        except ValueError as error:
            raise SettingsError(str(error)) from None
        return value


def catalogue() -> list[Setting]:
    """Every setting, in the order of the tables and of their fields."""
    found = []
    for table, cls in tables().items():
        meanings = meanings_of(cls)
        hints = typing.get_type_hints(cls)
        for key, default in as_table(cls(), with_defaults=True).items():
            choices = _choices(hints[key])
            found.append(Setting(table, key, meanings.get(key, ""), default, choices))
    return found


def meanings_of(cls: type) -> dict[str, str]:
    """What the attributes of a class are, from its docstring; nothing where Python dropped it."""
    section = (inspect.getdoc(cls) or "").partition("Attributes:\n")[2].partition("\n\n")[0]
    meanings: dict[str, str] = {}
    names: list[str] = []
    for line in section.splitlines():
        if match := _ENTRY.match(line):
            names = match[1].split(", ")
            words = match[2]
        else:
            words = line.strip()
        for name in names:
            meanings[name] = f"{meanings.get(name, '')} {words}".strip()
    return meanings


def _choices(hint: Any) -> tuple[str, ...]:
    if hint is bool:
        return ("true", "false")
    if isinstance(hint, type) and issubclass(hint, Enum):
        by_name = issubclass(hint, IntEnum)
        return tuple(member.name.lower() if by_name else str(member.value) for member in hint)
    return ()
