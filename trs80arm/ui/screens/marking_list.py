"""The list of the dialogs: a first click marks a row, so that it can be looked at before."""

from __future__ import annotations

from textual.events import Click
from textual.widgets import OptionList


class MarkingList(OptionList):
    """A list in which a click marks a row, and a click on the marked row chooses it."""

    def on_click(self, event: Click) -> None:
        """Mark the row, and leave it at that unless it was marked before."""
        row = event.style.meta.get("option")
        if row is None or row == self.highlighted or self.get_option_at_index(row).disabled:
            return
        event.prevent_default()
        self.highlighted = row
