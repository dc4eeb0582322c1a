"""The commands that take what is shown away with them: copied, or saved as text or picture."""

from __future__ import annotations

from typing import Protocol

from trs80arm.desk.asking import FileQuestion, Say
from trs80arm.desk.files import SessionFiles


class Window(Protocol):
    """What is shown, to be taken away."""

    @property
    def tube_text(self) -> str:
        """What the tube shows, as sixteen lines."""

    def copy_to_clipboard(self, text: str) -> None:
        """Put a text on the clipboard."""

    def export_screenshot(self) -> str:
        """The whole window as SVG."""


class TubeCommands:
    """Copies and saves what is shown.

    Args:
        window: what is shown.
        files: asks for names, and writes.
        say: a way to say something.
    """

    def __init__(self, window: Window, files: SessionFiles, say: Say) -> None:
        self._window = window
        self._files = files
        self._say = say

    def copy(self) -> None:
        """Copy the tube's text."""
        self._window.copy_to_clipboard(self._window.tube_text)
        self._say("The tube's text is copied (some terminals do not allow it).")

    def save_text(self) -> None:
        """Save the tube as text."""
        hint = "The tube's sixteen lines."
        self._save(hint, "screen.txt", self._window.tube_text + "\n")

    def save_picture(self) -> None:
        """Save the window as a picture."""
        self._save("The whole window as SVG.", "screen.svg", self._window.export_screenshot())

    def _save(self, hint: str, name: str, content: str) -> None:
        question = FileQuestion("Save the screen", hint, name, to_write=True)
        self._files.save_content(question, content.encode("utf-8"))
