"""The dialog that takes a listing from the clipboard: typed in at the machine's pace, or loaded."""

from __future__ import annotations

from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical
from textual.widgets import Button, TextArea

from trs80arm.desk.asking import Listing
from trs80arm.ui.screens.dialog import Dialog


class PasteScreen(Dialog[Listing]):
    """Asks for a listing."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("tab", "app.focus_next", show=False)]
    DEFAULT_CSS = """
    PasteScreen > .dialog { height: 90%; }
    PasteScreen TextArea { height: 1fr; border: none; }
    PasteScreen TextArea:focus { border: none; }
    """

    def compose(self) -> ComposeResult:
        """A place to paste into, and two ways in."""
        with Vertical(classes="dialog") as box:
            box.border_title = "Paste a listing"
            box.border_subtitle = "Tab to the buttons, Escape goes back"
            yield TextArea(tab_behavior="focus")
            with Horizontal(classes="buttons"):
                yield Button("Load at once", id="load", compact=True)
                yield Button("Type it in", id="type", compact=True)

    def on_button_pressed(self, event: Button.Pressed) -> None:
        """Answer."""
        text = self.query_one(TextArea).text
        self.dismiss(Listing(text, event.button.id == "load") if text.strip() else None)
