"""What the help has words on: topics that are searched, the one of what is being done first."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from importlib.resources import files
from inspect import cleandoc

from trs80arm.options import KeyMode
from trs80arm.rig import Waiting
from trs80arm.ui.keys.host_keys import TABLE

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

    @property
    def page(self) -> str:
        """It with its heading."""
        return f"## {self.title}\n\n{self.text}"

    def has(self, words: Iterable[str]) -> bool:
        """Whether all words, in small letters, are in it."""
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
    return [topic for part in (text, *map(cleandoc, panels)) for topic in topics_of(part)]


def topics_of(text: str) -> list[Topic]:
    """The topics of a page, one a heading."""
    _, *parts = _HEADING.split(text)
    return [
        Topic(title, words.strip()) for title, words in zip(parts[::2], parts[1::2], strict=True)
    ]


def _listed(entries: Iterable[tuple[str, str]]) -> str:
    """Two columns as they stand, closer together than a table."""
    lines = (f"{left:<{LEFT_COLUMN}} {right}" for left, right in entries)
    return "\n".join(["```text", *lines, "```"])
