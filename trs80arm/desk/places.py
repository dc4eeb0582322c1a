"""Where the program keeps things: the state folder, recent files, what comes along."""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from datetime import datetime
from pathlib import Path

from platformdirs import user_state_path

from trs80arm.paths import is_file, read_beginning
from trs80arm.saving import write_whole

APP = "trs80arm"
MOST_RECENT = 12
STATES = "states"
"""The folder of saved states in the state folder."""
_LARGEST_LIST = 1 << 20
"""Bytes of the list of recent files."""
PROGRAM_SUFFIXES = (".bas", ".txt", ".lst", ".cas")


def state_folder() -> Path:
    """The folder for recovery copies, recent files and remembered choices.

    `TRS80ARM_STATE` names another one.
    """
    return Path(os.environ.get("TRS80ARM_STATE") or user_state_path(APP, appauthor=False))


def sitting_name() -> str:
    """A name that no other sitting has, now or later: the second at which it began, its process."""
    return f"{datetime.now():%Y%m%d-%H%M%S}-{os.getpid()}"


def read_memo(path: Path, largest: int) -> object:
    """What a file of the state folder remembers; None if it cannot be read.

    Args:
        path: the file, JSON.
        largest: bytes of it that are read.
    """
    try:
        return json.loads(read_beginning(path, largest))
    except (OSError, ValueError, RecursionError):
        return None


def write_memo(path: Path, what: object) -> None:
    """Have a file of the state folder remember something; one that cannot is no trouble."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        write_whole(path, json.dumps(what).encode())
    except OSError:
        return


class RecentFiles:
    """The program files opened lately, newest first.

    Args:
        path: the file that remembers them; one that cannot be read is an empty list.
    """

    def __init__(self, path: Path) -> None:
        self._path = path

    def all(self) -> list[Path]:
        """Those that still exist."""
        names = read_memo(self._path, _LARGEST_LIST)
        if not isinstance(names, list):
            return []
        return [path for path in map(Path, filter(_is_text, names)) if is_file(path)]

    def add(self, path: Path) -> None:
        """Put a file in front; a state folder that cannot be written is no trouble."""
        newest = path.resolve()
        paths = [newest, *(other for other in self.all() if other != newest)][:MOST_RECENT]
        write_memo(self._path, [str(path) for path in paths])


def _is_text(value: object) -> bool:
    return isinstance(value, str)


def program_files(folder: Path) -> Sequence[Path]:
    """The program files of a folder, by name."""
    try:
        found = [path for path in folder.iterdir() if path.suffix.lower() in PROGRAM_SUFFIXES]
    except (OSError, ValueError):
        return ()
    return sorted(filter(is_file, found))
