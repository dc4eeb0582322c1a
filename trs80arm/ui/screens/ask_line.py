"""A dialog that asks for one line of text and uses it while it is still open."""

from __future__ import annotations

from collections.abc import Callable

from trs80arm.ui.screens.dialog import LineDialog


class AskLine(LineDialog[str]):
    """Asks for a line.

    Args:
        title: of the dialog.
        hint: what is to be typed.
        proposal: what stands there at first.
        take: uses the line; a `ValueError` or `LookupError` is shown, and the question stays.
    """

    DEFAULT_CSS = """
    AskLine > .dialog { width: 62; }
    """

    def __init__(self, title: str, hint: str, proposal: str, take: Callable[[str], object]) -> None:
        super().__init__(title, hint, proposal)
        self._take = take

    def answer(self, text: str) -> str:
        """The line, which has been used."""
        self._take(text)
        return text
