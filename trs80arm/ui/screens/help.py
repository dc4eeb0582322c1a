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
"""Topics that are written at once: more than a screen has room for."""
WIDTH = 90
"""Columns that lines of a topic have about, for how long it will be."""


class TopicPage(Markdown):
    """A topic in its place; its text is written when somebody is about to see it.

    Writing takes a while, as each paragraph and each row of a table is a widget of its own.

    Args:
        topic: what it is on.
        at_once: whether it is written as soon as it is there.
    """

    def __init__(self, topic: Topic, *, at_once: bool) -> None:
        super().__init__(topic.page if at_once else None)
        self.topic = topic
        self._is_written = at_once
        if not at_once:
            # About as long as it will be, for the scroll bar.
            self.styles.height = sum(1 + len(line) // WIDTH for line in topic.page.splitlines())

    @property
    def is_written(self) -> bool:
        """Whether its text is there, or about to be."""
        return self._is_written

    def write(self) -> None:
        """Have its text there, if it is not yet."""
        if not self._is_written:
            self._is_written = True
            self.run_worker(self._write())

    async def _write(self) -> None:
        await self.update(self.topic.page)
        self.styles.height = "auto"


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
    HelpScreen Markdown { background: $surface; padding: 0; margin: 0; height: auto; }
    HelpScreen #nothing { display: none; height: auto; }
    """

    def __init__(self, topics: Sequence[Topic], first: str = "") -> None:
        super().__init__()
        self._topics = sorted(topics, key=lambda topic: topic.title != first)
        self._pages = [
            TopicPage(topic, at_once=place < AT_ONCE) for place, topic in enumerate(self._topics)
        ]

    def compose(self) -> ComposeResult:
        """What is searched, and the topics, the one that comes first at the top."""
        with Vertical(classes="dialog") as box:
            box.border_title = "Help"
            box.border_subtitle = "Type to search; arrows scroll, Escape goes back"
            yield Input(placeholder="type to search")
            with VerticalScroll(can_focus=False):
                yield Static("", id="nothing", markup=False)
                yield from self._pages

    def on_mount(self) -> None:
        """Let it be searched, and look after what is scrolled to."""
        self.query_one(Input).focus()
        self.watch(self.query_one(VerticalScroll), "scroll_y", self._write_what_is_near)

    def on_resize(self) -> None:
        """There may be room for more."""
        self.call_after_refresh(self._write_what_is_near)

    def _write_what_is_near(self) -> None:
        """Write the topics down to a screen below what is seen."""
        place = self.query_one(VerticalScroll)
        end = place.scroll_offset.y + 2 * place.size.height
        near = [page for page in self._pages if page.display and page.virtual_region.y < end]
        unwritten = [page for page in near if not page.is_written]
        for page in unwritten:
            page.write()
        if unwritten:
            # They may turn out shorter.
            self.call_after_refresh(self._write_what_is_near)

    def on_input_changed(self, event: Input.Changed) -> None:
        """Show what has the words."""
        wanted = event.value.casefold().split()
        found = [page for page in self._pages if page.topic.has(wanted)]
        for page in self._pages:
            page.display = page in found
        for page in found[:AT_ONCE]:
            page.write()
        nothing = self.query_one("#nothing", Static)
        nothing.update(f"Nothing here has {shown(event.value)}.")
        nothing.display = not found
        self.query_one(VerticalScroll).scroll_home(animate=False)
        self.call_after_refresh(self._write_what_is_near)

    def action_scroll(self, by: int) -> None:
        """Look further down or up."""
        self.query_one(VerticalScroll).scroll_relative(y=by, animate=False)
