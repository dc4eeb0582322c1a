"""How a command asks its user and tells him something: questions as plain values, two protocols.

The screen puts a question into a dialog, a test answers it at once. A question that its user goes
back from is not answered: `then` is never called.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol


@dataclass(frozen=True)
class Choice:
    """One of several answers: what it gives, what is shown, and a word about it."""

    value: str
    label: str
    note: str = ""


@dataclass(frozen=True)
class Question:
    """A question with a few answers; the first is what Enter says.

    Attributes:
        title: of the dialog.
        text: the question.
        answers: to choose from.
        again: what the screen's key that led here does when it is pressed again.
    """

    title: str
    text: str
    answers: tuple[Choice, ...]
    again: str = ""


@dataclass(frozen=True)
class ListQuestion:
    """One of a list, and the value that is chosen now."""

    title: str
    choices: tuple[Choice, ...]
    now: str = ""


@dataclass(frozen=True)
class FileQuestion:
    """The name of a file, or of a folder.

    Attributes:
        title: of the dialog.
        hint: what kind of file it will be.
        proposal: the name to begin with.
        to_write: whether the file will be written: one that exists is asked about.
        own: the file that may be replaced without a question.
        folder: whether it is a folder that is wanted; there need be none of that name yet.
        plain: whether it is a bare name that is wanted, and no file is looked at.
    """

    title: str
    hint: str
    proposal: Path | str
    to_write: bool
    own: Path | None = None
    folder: bool = False
    plain: bool = False


@dataclass(frozen=True)
class Shelf:
    """A titled list of files.

    Attributes:
        title: over it.
        files: what stands there.
        labels: what is shown for each file; their names if empty.
        shown: how many are shown before something is typed; None for all.
        discard: removes a file of the shelf for ever; None where that is not offered.
    """

    title: str
    files: Sequence[Path]
    labels: Sequence[str] = ()
    shown: int | None = None
    discard: Callable[[Path], object] | None = None

    def entries(self, part: str) -> list[tuple[Path, str]]:
        """The files that have `part` in their label, each with its label."""
        labels = self.labels or [path.name for path in self.files]
        pairs = [
            (path, label)
            for path, label in zip(self.files, labels, strict=True)
            if part.casefold() in label.casefold()
        ]
        return pairs if part else pairs[: self.shown]


@dataclass(frozen=True)
class ProgramQuestion:
    """A program file from some shelves, those that are empty left out, or from a folder.

    Attributes:
        shelves: that stand before the folder.
        folder: where one is.
        below: shelves that stand after it.
    """

    shelves: tuple[Shelf, ...]
    folder: Path
    below: tuple[Shelf, ...] = ()


@dataclass(frozen=True)
class Listing:
    """What was pasted, and whether it is to be loaded at once instead of typed."""

    text: str
    at_once: bool


Take = Callable[[str], object]
"""Is given the value of an answer."""


class Asking(Protocol):
    """A way to ask."""

    def ask(self, question: Question, then: Take) -> None:
        """Ask; `then` gets the value of the answer."""

    def choose(self, question: ListQuestion, then: Take, seen: Take | None = None) -> None:
        """Let one be chosen; `then` gets its value.

        `seen` gets the value of each that is looked at on the way, and at the end the present one
        again if none was chosen.
        """

    def ask_file(self, question: FileQuestion, then: Callable[[Path], object]) -> None:
        """Ask for a file's name."""

    def ask_program(self, question: ProgramQuestion, then: Callable[[Path], object]) -> None:
        """Ask for a program file."""

    def ask_listing(self, then: Callable[[Listing], object]) -> None:
        """Ask for a listing from the clipboard."""

    def is_asking(self, question: Question) -> bool:
        """Whether that question stands unanswered."""


class Say(Protocol):
    """A way to say something; an error is told more loudly."""

    def __call__(self, text: str, *, error: bool = False) -> None:
        """Say it."""
