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
        self._shown: list[tuple[Topic, Markdown]] = []

    def compose(self) -> ComposeResult:
        """What is searched, and the topic that comes first."""
        with Vertical(classes="dialog") as box:
            box.border_title = "Help"
            box.border_subtitle = "Type to search; arrows scroll, Escape goes back"
            yield Input(placeholder="type to search")
            with VerticalScroll(can_focus=False):
                yield Static("", id="nothing", markup=False)
                for topic in self._topics[:AT_ONCE]:
                    yield self._words_on(topic)

    def on_mount(self) -> None:
        """Let it be searched, and put the other topics below."""
        self.query_one(Input).focus()
        self.run_worker(self._put_the_others_below())

    async def _put_the_others_below(self) -> None:
        """One after the other, as each takes a while, so that keys come through."""
        place = self.query_one(VerticalScroll)
        for topic in self._topics[AT_ONCE:]:
            await place.mount(self._words_on(topic))

    def _words_on(self, topic: Topic) -> Markdown:
        words = Markdown(topic.page)
        words.display = topic.has(self._wanted)
        self._shown.append((topic, words))
        return words

    @property
    def _wanted(self) -> list[str]:
        """The words that are searched, none before there is a line to type them in."""
        lines = self.query(Input)
        return lines.first().value.casefold().split() if lines else []

    def on_input_changed(self, event: Input.Changed) -> None:
        """Show what has the words."""
        wanted = self._wanted
        for topic, words in self._shown:
            words.display = topic.has(wanted)
        nothing = self.query_one("#nothing", Static)
        nothing.update(f"Nothing here has {shown(event.value)}.")
        nothing.display = not any(topic.has(wanted) for topic in self._topics)
        self.query_one(VerticalScroll).scroll_home(animate=False)

    def action_scroll(self, by: int) -> None:
        """Look further down or up."""
        self.query_one(VerticalScroll).scroll_relative(y=by, animate=False)
