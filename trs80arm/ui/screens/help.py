"""The help: topics that are searched, and the one of what is being done at the top."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical, VerticalScroll
from textual.widgets import Input, Markdown, Static

from trs80arm.shown import shown
from trs80arm.ui.help_topics import Topic
from trs80arm.ui.screens.dialog import Dialog

AT_ONCE = 2
"""Topics that are there when it opens: more than a screen has room for."""
PAGE = 12
"""Rows that are scrolled by at a time; what is no further below what is seen is there as well."""
WIDTH = 90
"""Columns that lines of a topic have about, for how long it will be."""


def _rows(topic: Topic) -> int:
    """How many rows a topic takes, about."""
    return sum(1 + len(line) // WIDTH for line in topic.page.splitlines())


class HelpScreen(Dialog[None]):
    """The help.

    Each paragraph and each row of a table is a widget of its own, so a topic is written when it is
    nearly scrolled to, or found.

    Args:
        topics: what it has.
        first: the title of the topic that it opens at.

    Attributes:
        found: the topics that have what is searched, in their order.
    """

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("down", "scroll(2)", show=False),
        Binding("up", "scroll(-2)", show=False),
        Binding("pagedown", f"scroll({PAGE})", show=False),
        Binding("pageup", f"scroll({-PAGE})", show=False),
    ]
    DEFAULT_CSS = """
    HelpScreen > .dialog { width: 100; height: 96%; }
    HelpScreen VerticalScroll { height: 1fr; scrollbar-gutter: stable; }
    HelpScreen Markdown { background: $surface; padding: 0; margin: 0; height: auto; }
    HelpScreen #nothing { display: none; height: auto; }
    """

    def __init__(self, topics: Sequence[Topic], first: str = "") -> None:
        super().__init__()
        self._topics = sorted(topics, key=lambda topic: topic.title != first)
        self.found = self._topics
        self._pages: dict[Topic, Markdown] = {}
        self._rest = Static("")

    def compose(self) -> ComposeResult:
        """What is searched, the topic that comes first, room for the others."""
        with Vertical(classes="dialog") as box:
            box.border_title = "Help"
            box.border_subtitle = "Type to search; arrows scroll, Escape goes back"
            yield Input(placeholder="type to search")
            with VerticalScroll(can_focus=False):
                yield Static("", id="nothing", markup=False)
                for topic in self.found[:AT_ONCE]:
                    self._pages[topic] = Markdown(topic.page)
                    yield self._pages[topic]
                yield self._rest

    def on_mount(self) -> None:
        """Let it be searched, and look after what is scrolled to."""
        self.query_one(Input).focus()
        self.watch(self.query_one(VerticalScroll), "scroll_y", self._write_what_is_near)

    def on_resize(self) -> None:
        """There may be room for more."""
        self.call_after_refresh(self._write_what_is_near)

    def _write_what_is_near(self) -> None:
        """Write the topics down to a little below what is seen, and leave room for the others."""
        place = self.query_one(VerticalScroll)
        end = place.scroll_offset.y + place.size.height + PAGE
        down = rest = 0
        is_new = False
        for topic in self.found:
            if topic not in self._pages and down < end:
                self._write(topic, place)
                is_new = True
            if topic not in self._pages:
                rest += _rows(topic)
            else:
                down += self._pages[topic].size.height or _rows(topic)
        self._rest.styles.height = rest
        if is_new:
            # They may turn out shorter.
            self.call_after_refresh(self._write_what_is_near)

    def _write(self, topic: Topic, place: VerticalScroll) -> None:
        """Put a topic between those that are there."""
        below = self._topics[self._topics.index(topic) + 1 :]
        behind = next((self._pages[other] for other in below if other in self._pages), self._rest)
        self._pages[topic] = Markdown(topic.page)
        place.mount(self._pages[topic], before=behind)

    def on_input_changed(self, event: Input.Changed) -> None:
        """Show what has the words."""
        wanted = event.value.casefold().split()
        self.found = [topic for topic in self._topics if topic.has(wanted)]
        for topic, page in self._pages.items():
            page.display = topic in self.found
        nothing = self.query_one("#nothing", Static)
        nothing.update(f"Nothing here has {shown(event.value)}.")
        nothing.display = not self.found
        self.query_one(VerticalScroll).scroll_home(animate=False)
        self._write_what_is_near()
        self.call_after_refresh(self._write_what_is_near)

    def action_scroll(self, by: int) -> None:
        """Look further down or up."""
        self.query_one(VerticalScroll).scroll_relative(y=by, animate=False)
