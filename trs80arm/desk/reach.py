"""Which files of the computer a sitting reaches: all that its user can name, or one folder's.

A visitor of a served terminal has a folder of his own and the programs that come along. Whatever
he types is looked at here before anything is asked of the system, so that he does not even learn
which other files there are.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from trs80arm.bundled import programs_folder
from trs80arm.desk.asking import FileQuestion
from trs80arm.paths import is_file, is_folder, refusal, typed_path

OUTSIDE = "Only the files of your own folder can be reached here."


@dataclass(frozen=True)
class Reach:
    """What may be named.

    Attributes:
        folder: the one folder that can be reached, and nothing above it; None for all files.
    """

    folder: Path | None = None

    @property
    def home(self) -> Path:
        """Where names begin that say no folder."""
        return Path.cwd() if self.folder is None else self.folder

    def typed(self, text: str) -> Path:
        """The path that was typed."""
        return typed_path(text) if self.folder is None else self.folder / text.strip()

    def refusal(self, path: Path, *, to_write: bool) -> str:
        """Why a path cannot be reached; empty if it can. Links are followed."""
        if self.folder is None:
            return ""
        along = None if to_write else programs_folder()
        try:
            place = Path(os.path.realpath(path))
            folders = [Path(os.path.realpath(folder)) for folder in (self.folder, along) if folder]
        except (OSError, ValueError):
            return OUTSIDE
        return "" if any(place.is_relative_to(folder) for folder in folders) else OUTSIDE

    def proposal(self, path: Path | str) -> Path | str:
        """A name to begin with: of a path that cannot be written, the last part alone."""
        if self.folder is None or not self.refusal(self.folder / path, to_write=True):
            return path
        return Path(path).name


ALL_FILES: Final = Reach()
"""For who sits at the computer itself."""


def proposed(reach: Reach, question: FileQuestion) -> str:
    """The name that a question for a file begins with."""
    return str(question.proposal if question.plain else reach.proposal(question.proposal))


def file_problem(reach: Reach, question: FileQuestion, text: str) -> str:
    """Why what was typed is no answer to a question for a file; empty if it is one.

    A file that would be replaced is no problem here: see `replaces`.
    """
    if not text:
        return "Type a name."
    path = reach.typed(text)
    if question.plain:
        return "" if path.name == text else "Type a plain name, without a folder."
    if outside := reach.refusal(path, to_write=question.to_write):
        return outside
    if question.folder:
        return refusal(path) or ("" if is_folder(path) else _no_new_folder(path))
    if is_folder(path):
        return f"{path} is a folder."
    if not question.to_write:
        return "" if is_file(path) else f"There is no file {path}."
    if not is_folder(path.parent):
        return f"There is no folder {path.parent}."
    return refusal(path)


def replaces(question: FileQuestion, path: Path) -> bool:
    """Whether a file would be replaced that its owner did not name before."""
    looked_at = question.to_write and not (question.folder or question.plain)
    return looked_at and path != question.own and path.exists()


def _no_new_folder(path: Path) -> str:
    """Why no folder of that name can be made; empty if it can."""
    if is_file(path):
        return f"{path} is a file."
    return "" if is_folder(path.parent) else f"There is no folder {path.parent}."
