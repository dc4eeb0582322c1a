"""The help: one page, with the keys of the program and of the TRS-80."""

from __future__ import annotations

from collections.abc import Iterable
from importlib.resources import files

from textual.app import ComposeResult
from textual.containers import VerticalScroll
from textual.widgets import Markdown

from trs80arm.options import KeyMode
from trs80arm.ui.keys.host_keys import TABLE
from trs80arm.ui.screens.dialog import Dialog

LEFT_COLUMN = 18

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


def page(in_use: KeyMode, commands: Iterable[tuple[str, str]]) -> str:
    """The page, with why keys work as they do here, and the tables of keys.

    Args:
        in_use: how keys work at present.
        commands: the keys of the program, and what each does.
    """
    text = files("trs80arm.ui").joinpath("help/help.md").read_text(encoding="utf-8")
    return (
        text.replace("<!-- keys in use -->", KEYS_IN_USE[in_use])
        .replace("<!-- commands -->", _listed(commands))
        .replace("<!-- keys -->", _listed(TABLE))
    )


def _listed(entries: Iterable[tuple[str, str]]) -> str:
    """Two columns as they stand, closer together than a table."""
    lines = (f"{left:<{LEFT_COLUMN}} {right}" for left, right in entries)
    return "\n".join(["```", *lines, "```"])


class HelpScreen(Dialog[None]):
    """The page of help.

    Args:
        text: the page, in Markdown.
    """

    DEFAULT_CSS = """
    HelpScreen > .dialog { width: 100; height: 96%; }
    HelpScreen Markdown { background: $surface; padding: 0; margin: 0; }
    """

    def __init__(self, text: str) -> None:
        super().__init__()
        self._text = text

    def compose(self) -> ComposeResult:
        """The page, to be scrolled."""
        with VerticalScroll(classes="dialog") as box:
            box.border_title = "Help"
            box.border_subtitle = "Arrows scroll, Escape goes back"
            yield Markdown(self._text)

    def on_mount(self) -> None:
        """Let the arrows scroll."""
        self.query_one(VerticalScroll).focus()
