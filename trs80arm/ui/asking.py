"""Questions of the desk as dialogs, and dialogs of the screen for who knows no application.

The larger dialogs are imported when they are opened: the first frame needs none.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, Protocol, TypeVar

from textual.app import App

from trs80arm.desk.asking import (
    FileQuestion,
    Listing,
    ListQuestion,
    ProgramQuestion,
    Question,
    Take,
)
from trs80arm.desk.reach import Reach
from trs80arm.ui.screens.dialog import Ask, AskPath, Choose, Dialog, show

Answer = TypeVar("Answer")


class Screens(Protocol):
    """Shows a dialog."""

    def open(self, dialog: Dialog[Answer], then: Callable[[Answer], object] | None = None) -> None:
        """Show it; `then` gets its answer, if it ends with one."""

    @property
    def help_here(self) -> str:
        """What the screen in front says of itself, in Markdown; empty if it says nothing."""


class Dialogs:
    """Asks by dialogs of an application.

    Args:
        app: the application.
        reach: which files can be named in them.
    """

    def __init__(self, app: App[Any], reach: Reach) -> None:
        self._app = app
        self._reach = reach

    def open(self, dialog: Dialog[Answer], then: Callable[[Answer], object] | None = None) -> None:
        """Show a dialog; `then` gets its answer, if it ends with one."""
        show(self._app, dialog, then)

    @property
    def help_here(self) -> str:
        """What the screen in front says of itself, in Markdown; empty if it says nothing."""
        return self._app.screen.HELP or ""

    def ask(self, question: Question, then: Take) -> None:
        """Ask by buttons."""
        self.open(Ask(question), then)

    def choose(self, question: ListQuestion, then: Take, seen: Take | None = None) -> None:
        """Let one of a list be chosen."""
        self.open(Choose(question, seen), then)

    def ask_file(self, question: FileQuestion, then: Callable[[Path], object]) -> None:
        """Ask for a file's name."""
        self.open(AskPath(question, self._reach), then)

    def ask_program(self, question: ProgramQuestion, then: Callable[[Path], object]) -> None:
        """Ask for a program, with a look into it."""
        from trs80arm.ui.screens.open import OpenScreen

        self.open(OpenScreen(question, self._reach), then)

    def ask_listing(self, then: Callable[[Listing], object]) -> None:
        """Ask for a listing to be pasted."""
        from trs80arm.ui.screens.paste import PasteScreen

        self.open(PasteScreen(), then)

    def is_asking(self, question: Question) -> bool:
        """Whether that question is on the screen."""
        screen = self._app.screen
        return isinstance(screen, Ask) and screen.question == question
