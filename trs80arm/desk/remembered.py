"""Choices made in the program, remembered in the settings file for the next time."""

from __future__ import annotations

from pathlib import Path

from trs80arm.desk.asking import Say
from trs80arm.reasons import reason
from trs80arm.settings import SettingsError, remember


class Remembered:
    """Writes choices of the table `[terminal]` into the settings file.

    Args:
        file: the settings file; None remembers nothing.
        say: tells when it cannot be written.
    """

    def __init__(self, file: Path | None, say: Say) -> None:
        self._file = file
        self._say = say

    def choose(self, key: str, value: str | bool) -> None:
        """Remember a choice, or say why not."""
        if self._file is None:
            return
        try:
            remember(self._file, key, value)
        except SettingsError as error:
            self._say(f"Not remembered: {error}", error=True)
        except OSError as error:
            self._say(f"Not remembered in {self._file}: {reason(error)}", error=True)
