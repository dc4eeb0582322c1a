"""The help: topics that are searched, and the one of what is being done at the top."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from importlib.resources import files
from inspect import cleandoc
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical, VerticalScroll
from textual.widgets import Input, Markdown

from trs80arm.options import KeyMode
from trs80arm.rig import Waiting
from trs80arm.ui.keys.host_keys import TABLE
from trs80arm.ui.screens.dialog import Dialog

LEFT_COLUMN = 18
AFTER_A_SLIP = "After a slip"
WHILE_WAITING = {
    Waiting.NOTHING: "While a program runs",
    Waiting.SET: "Manual mode",
    Waiting.INPUT: "A program asks for something",
    Waiting.EDIT: "In EDIT",
    Waiting.AUTO: "In AUTO",
    Waiting.PAUSE: "Stopped by SHIFT @",
    Waiting.MEMORY_SIZE: "MEMORY SIZE?",
}
"""The topic of what the machine waits for; at its prompt none comes before the first."""

KEYS_IN_USE = {
    KeyMode.EVENTS: "`KEYS: events`: this terminal tells when a key is let go, so keys are really "
    "held, several at once.",
    KeyMode.REPEAT: "`KEYS: repeat`: this terminal does not tell when a key is let go (tmux and "
    "screen never do; WezTerm does with `enable_kitty_keyboard = true`). A tap moves a joint a "
    "little, auto-repeat keeps it moving. For two joints at once use latch mode (Ctrl+D), or the "
    "mouse on the keyboard (Ctrl+K): left holds, right latches.",
    KeyMode.LATCH: "`KEYS: latch`: in `@SET` a press turns a key on and the next one off; Space or "
    "Escape lets all go. Ctrl+D leaves latch mode.",
}
_HEADING = re.compile(r"^##? +(.*)$", re.MULTILINE)


@dataclass(frozen=True)
class Topic:
    """One thing that the help has words on, in Markdown."""

    title: str
    text: str

    def has(self, words: Iterable[str]) -> bool:
        """Whether all words are in it."""
        text = f"{self.title} {self.text}".casefold()
        return all(word in text for word in words)


def topics(
    in_use: KeyMode, commands: Iterable[tuple[str, str]], panels: Iterable[str]
) -> list[Topic]:
    """Everything that the help has.

    Args:
        in_use: how keys work at present.
        commands: the keys of the program, and what each does.
        panels: what the panels say of themselves, each with its heading.
    """
    text = files("trs80arm.ui").joinpath("help/help.md").read_text(encoding="utf-8")
    text = (
        text.replace("<!-- keys in use -->", KEYS_IN_USE[in_use])
        .replace("<!-- commands -->", _listed(commands))
        .replace("<!-- keys -->", _listed(TABLE))
    )
    return [topic for part in (text, *map(cleandoc, panels)) for topic in _topics_of(part)]


def _topics_of(text: str) -> list[Topic]:
    _, *parts = _HEADING.split(text)
    return [
        Topic(title, words.strip()) for title, words in zip(parts[::2], parts[1::2], strict=True)
    ]


def page(topics: Sequence[Topic], first: str, wanted: str = "") -> str:
    """The topics that have the wanted words, as one page.

    Args:
        topics: all of them.
        first: the title of the one that comes first; of any other they stand in their order.
        wanted: words, each of which has to be in a topic.
    """
    words = wanted.casefold().split()
    found = [topic for topic in topics if topic.has(words)]
    found.sort(key=lambda topic: topic.title != first)
    if not found:
        return f"Nothing here has `{wanted.replace('`', '')}`."
    return "\n\n".join(f"## {topic.title}\n\n{topic.text}" for topic in found)


def _listed(entries: Iterable[tuple[str, str]]) -> str:
    """Two columns as they stand, closer together than a table."""
    lines = (f"{left:<{LEFT_COLUMN}} {right}" for left, right in entries)
    return "\n".join(["```", *lines, "```"])


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
