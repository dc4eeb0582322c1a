"""A dialog that asks for one line of text, and says at once what is wrong with it."""

from __future__ import annotations

from collections.abc import Callable

from textual.app import ComposeResult
from textual.containers import Vertical
from textual.markup import escape
from textual.widgets import Input, Static

from trs80arm.shown import shown
from trs80arm.ui.screens.dialog import Dialog


class AskLine(Dialog[str]):
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
        super().__init__()
        self._title = title
        self._hint = hint
        self._proposal = proposal
        self._take = take

    def compose(self) -> ComposeResult:
        """The line."""
        with Vertical(classes="dialog") as box:
            box.border_title = escape(self._title)
            box.border_subtitle = "Enter does it, Escape goes back"
            yield Static(self._hint, classes="hint", markup=False)
            yield Input(self._proposal, select_on_focus=False)
            yield Static("", classes="wrong", markup=False)

    def on_input_submitted(self, event: Input.Submitted) -> None:
        """Use it, or say why it cannot be used."""
        try:
            self._take(event.value)
        except (ValueError, LookupError) as error:
            self.query_one(".wrong", Static).update(shown(str(error.args[0])))
        else:
            self.dismiss(event.value)
