"""What the terminal tells: keys down and up, whether it can tell at all, and that it is gone.

The parser makes those of keys from the sequences of the Kitty keyboard protocol; the driver posts
them to the app beside the ordinary key events, which go on serving bindings, inputs and the
palette.
"""

from __future__ import annotations

from textual.message import Message


class KeyWentDown(Message):
    """A key went down.

    Attributes:
        base: the key's own code point or name, the same at press and release whatever the
            modifiers do meanwhile.
        name: Textual's name of the key with its modifiers, like `shift+left`.
        text: the character it types, None if none.
    """

    bubble = False

    def __init__(self, base: str, name: str, text: str | None) -> None:
        super().__init__()
        self.base = base
        self.name = name
        self.text = text


class KeyWentUp(Message):
    """A key was let go; `base` is that of its `KeyWentDown`."""

    bubble = False

    def __init__(self, base: str) -> None:
        super().__init__()
        self.base = base


class KeyReport(Message):
    """Whether the terminal reports releases: its answer, or the evidence of a release."""

    bubble = False

    def __init__(self, releases: bool) -> None:
        super().__init__()
        self.releases = releases


class TerminalWent(Message):
    """There is no terminal any more."""

    bubble = False
