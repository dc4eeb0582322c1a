"""The settings as they are now, changed by their user, and written into their file on demand."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from trs80arm.reasons import reason
from trs80arm.settings import SettingsError, forget, remember
from trs80arm.settings_catalogue import Setting, catalogue

Values = Mapping[str, Mapping[str, Any]]
"""Plain values by table and key."""


@dataclass(frozen=True)
class Entry:
    """A setting as it is now.

    Attributes:
        setting: which it is.
        value: what it is, or is to be, as it would stand in the file.
        changed: whether it was changed and is not in the file yet.
        at_once: whether a change is seen at once, and not from the next start.
    """

    setting: Setting
    value: str
    changed: bool
    at_once: bool

    @property
    def default(self) -> str:
        """What it would be unless it were set."""
        return json.dumps(self.setting.default)


class SettingsBook:
    """Changes settings and saves them.

    Args:
        file: the settings file; None saves nothing.
        now: the values that are in use.
        at_once: who takes a new value at once, by `table.key`; the others wait for the next start.
    """

    def __init__(
        self,
        file: Path | None,
        now: Callable[[], Values],
        at_once: Mapping[str, Callable[[Any], object]],
    ) -> None:
        self.file = file
        self._now = now
        self._at_once = at_once
        self._changed: dict[Setting, Any] = {}

    def entries(self, wanted: str = "") -> list[Entry]:
        """The settings whose name, value or meaning have all the words that are wanted."""
        now = self._now()
        found = []
        for setting in catalogue():
            changed = setting in self._changed
            value = now.get(setting.table, {}).get(setting.key, setting.default)
            value = self._changed[setting] if changed else value
            entry = Entry(setting, json.dumps(value), changed, setting.name in self._at_once)
            text = f"{setting.name} {entry.value} {setting.meaning}".casefold()
            if all(word in text for word in wanted.casefold().split()):
                found.append(entry)
        return found

    def change(self, setting: Setting, text: str) -> str:
        """Set one, for now or for the next start.

        Returns:
            Why it cannot be that; empty if it is done.
        """
        try:
            value = setting.check(text)
        except SettingsError as error:
            return str(error)
        if (take := self._at_once.get(setting.name)) is not None:
            try:
                take(value)
            except ValueError as error:
                return str(error)
        self._changed[setting] = value
        return ""

    def save(self) -> str:
        """Write what was changed into the file; a default is taken out of it.

        Returns:
            What was done, or why not, in one line.
        """
        if self.file is None:
            return "There is no settings file to save to."
        if not self._changed:
            return "Nothing was changed that is not saved."
        try:
            for setting, value in list(self._changed.items()):
                if value == setting.default:
                    forget(self.file, setting.key, setting.table)
                else:
                    remember(self.file, setting.key, value, setting.table)
                del self._changed[setting]
        except SettingsError as error:
            return f"Not saved: {error}"
        except OSError as error:
            return f"Not saved in {self.file}: {reason(error)}"
        return f"Saved in {self.file}."
