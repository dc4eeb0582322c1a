"""A folder for each visitor of a served terminal, by the name that his browser was given.

A visitor who comes back finds his files; when the server ends they go. Nothing of whoever serves is
taken over: not the settings, not the state folder, not where cassettes and paper are kept.
"""

from __future__ import annotations

import re
import secrets
import shutil
import tempfile
from collections.abc import Mapping
from pathlib import Path

MOST = 200
"""Visitors that have a folder; there are none for more."""
_NAME = re.compile(r"[A-Za-z0-9_-]{16,64}")
_OWN_VARIABLES = "TRS80ARM_"


class VisitorFolders:
    """The folders of all visitors, in one temporary folder."""

    def __init__(self) -> None:
        self._all: Path | None = None

    @staticmethod
    def new_name() -> str:
        """A name that nobody guesses."""
        return secrets.token_urlsafe(16)

    @staticmethod
    def is_name(text: str) -> bool:
        """Whether a browser's word can be a name that was given."""
        return _NAME.fullmatch(text) is not None

    def of(self, name: str) -> Path | None:
        """The folder of a visitor, made if it is not there; None where there are too many.

        Raises:
            OSError: it cannot be made.
        """
        if self._all is None:
            self._all = Path(tempfile.mkdtemp(prefix="trs80arm-visitors-"))
        folder = self._all / name
        if not folder.is_dir():
            if sum(1 for _ in self._all.iterdir()) >= MOST:
                return None
            for part in ("files", "state"):
                (folder / part).mkdir(parents=True)
            (folder / "settings.toml").touch()
        return folder

    def forget(self) -> None:
        """Remove them all."""
        if self._all is not None:
            shutil.rmtree(self._all, ignore_errors=True)
            self._all = None


def words_for(folder: Path) -> list[str]:
    """What the command line of a visitor's program says of files."""
    files = folder / "files"
    return [
        *("--own-folder", str(files)),
        *("--tapes", str(files / "tapes")),
        *("--config", str(folder / "settings.toml")),
    ]


def environment_for(folder: Path, environment: Mapping[str, str]) -> dict[str, str]:
    """The environment of a visitor's program: without the settings of whoever serves."""
    kept = {name: it for name, it in environment.items() if not name.startswith(_OWN_VARIABLES)}
    return kept | {"TRS80ARM_STATE": str(folder / "state")}
