"""The help: topics that are searched, and the one of what is being done at the top."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical, VerticalScroll
from textual.widgets import Input, Markdown

from trs80arm.ui.help_topics import Topic, page
from trs80arm.ui.screens.dialog import Dialog


class HelpScreen(Dialog[None]):
    """The help.

    Args:
        topics: what it has.
        first: the title of the topic that it opens at.
    """

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("down", "scroll(2)", show=False),
        Binding("up", "scroll(-2)", show=False),
        Binding("pagedown", "scroll(12)", show=False),
        Binding("pageup", "scroll(-12)", show=False),
    ]
    DEFAULT_CSS = """
    HelpScreen > .dialog { width: 100; height: 96%; }
    HelpScreen VerticalScroll { height: 1fr; }
    HelpScreen Markdown { background: $surface; padding: 0; margin: 0; }
    """

    def __init__(self, topics: Sequence[Topic], first: str = "") -> None:
        super().__init__()
        self._topics = topics
        self._first = first

    def compose(self) -> ComposeResult:
        """What is searched, and the page."""
        with Vertical(classes="dialog") as box:
            box.border_title = "Help"
            box.border_subtitle = "Type to search; arrows scroll, Escape goes back"
            yield Input(placeholder="type to search")
            with VerticalScroll(can_focus=False):
                yield Markdown(page(self._topics, self._first))

    def on_mount(self) -> None:
        """Let it be searched."""
        self.query_one(Input).focus()

    async def on_input_changed(self, event: Input.Changed) -> None:
        """Show what has the words."""
        await self.query_one(Markdown).update(page(self._topics, self._first, event.value))
        self.query_one(VerticalScroll).scroll_home(animate=False)

    def action_scroll(self, by: int) -> None:
        """Look further down or up."""
        self.query_one(VerticalScroll).scroll_relative(y=by, animate=False)
