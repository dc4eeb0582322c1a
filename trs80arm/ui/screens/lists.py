"""The lists of the screens: they may have no room, and in dialogs a first click marks a row."""

from __future__ import annotations

from textual.events import Click
from textual.widgets import OptionList


class RowList(OptionList):
    """A list of rows, be there room for any or not.

    Without room Textual has made no lines, and fails when it looks for those of a page.
    """

    def action_page_up(self) -> None:
        """Mark the row a page up."""
        if self.scrollable_content_region:
            super().action_page_up()  # type: ignore[no-untyped-call]

    def action_page_down(self) -> None:
        """Mark the row a page down."""
        if self.scrollable_content_region:
            super().action_page_down()  # type: ignore[no-untyped-call]


class MarkingList(RowList):
    """A list in which a click marks a row, and a click on the marked row chooses it."""

    def on_click(self, event: Click) -> None:
        """Mark the row, and leave it at that unless it was marked before."""
        row = event.style.meta.get("option")
        if row is None or row == self.highlighted or self.get_option_at_index(row).disabled:
            return
        event.prevent_default()
        self.highlighted = row
