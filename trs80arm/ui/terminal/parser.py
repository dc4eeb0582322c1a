"""Textual's parser of terminal input, taught to tell key presses from releases.

It overrides two private hooks of `XTermParser`: `_sequence_to_key_events` and `parse_mouse_code`.
What concerns event types is taken off a sequence and posted as messages of our own; the cleaned
sequence goes on to Textual, so that all that Textual does with keys stays as it is. Sequences that
Textual would stumble over are dropped. Pinned by `tests/ui/test_terminal_hooks.py`.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable

from textual import events
from textual._xterm_parser import XTermParser
from textual.keys import Keys
from textual.message import Message

from trs80arm.ui.terminal.messages import KeyReport, KeyWentDown, KeyWentUp

PRESS, REPEAT, RELEASE = 1, 2, 3
REPORTS_EVENT_TYPES = 0b10
"""The bit of the protocol's flags that promises releases."""

_KEY = re.compile(r"\x1b\[(\d*(?::\d*)*)(?:;(\d*)(?::(\d+))?)?(?:;([\d:]*))?([u~ABCDEFHPQRS])")
_FLAGS = re.compile(r"\x1b\[\?(\d+)u")
_ATTRIBUTES = re.compile(r"\x1b\[\?[\d;]*c")
_CURSOR_REPORT = re.compile(r"\x1b\[\d+;\d+R")
_SHIFT_ONLY = 2
"""The modifier field when SHIFT alone is held: one, and bit 0."""
_LOCKS = 0b1100_0000
"""Caps Lock and Num Lock among the modifiers; they change no key's meaning here."""


class KeyParser(XTermParser):
    """The parser of a terminal to which event types were asked for.

    Attributes:
        releases: whether the terminal reports releases, as far as is known.
    """

    def __init__(self, debug: bool = False, *, releases: bool = False) -> None:
        """Begin to parse.

        Args:
            debug: Textual's own switch.
            releases: whether the terminal is known to report releases, whatever it answers.
        """
        super().__init__(debug)
        self.releases = releases
        self._insist = releases
        self._noticed: list[Message] = []

    def feed(self, data: str) -> Iterable[Message]:
        """Parse a piece of input; our own messages come just before what they are about."""
        for message in super().feed(data):
            yield from self._take_noticed()
            yield message
        yield from self._take_noticed()

    def tick(self) -> Iterable[Message]:
        """Let time pass for the parser, which ends a lone Escape."""
        for message in super().tick():
            yield from self._take_noticed()
            yield message
        yield from self._take_noticed()

    def parse_mouse_code(self, code: str) -> Message | None:
        """The mouse's message; none where Textual's sums fail, as with a screen of no cells."""
        try:
            return super().parse_mouse_code(code)
        except (ArithmeticError, ValueError):
            return None

    def _take_noticed(self) -> list[Message]:
        noticed, self._noticed = self._noticed, []
        return noticed

    def _found_releases(self, releases: bool) -> None:
        self.releases = releases or self._insist
        self._noticed.append(KeyReport(self.releases))

    def _sequence_to_key_events(self, sequence: str, alt: bool = False) -> Iterable[events.Key]:
        if flags := _FLAGS.fullmatch(sequence):
            self._found_releases(bool(int(flags[1]) & REPORTS_EVENT_TYPES))
            return [events.Key(Keys.Ignore, sequence)]
        if _ATTRIBUTES.fullmatch(sequence):
            return [events.Key(Keys.Ignore, sequence)]
        match = _KEY.fullmatch(sequence)
        if match is None or _CURSOR_REPORT.fullmatch(sequence):
            return super()._sequence_to_key_events(sequence, alt)
        return self._typed(*match.groups(default=""))

    def _typed(
        self, codes: str, modifiers: str, kind: str, text: str, end: str
    ) -> list[events.Key]:
        if not all(map(_is_character, re.findall(r"\d+", f"{codes}:{text}"))):
            return [events.Key(Keys.Ignore, "")]
        code, *alternates = codes.split(":")
        if kind and not self.releases:
            self._found_releases(True)
        base = f"{code or 1}{end}"
        if int(kind or PRESS) == RELEASE:
            self._noticed.append(KeyWentUp(base))
            return [events.Key(Keys.Ignore, "")]
        if not text and alternates and alternates[0] and _bare(modifiers) == _SHIFT_ONLY:
            text = alternates[0]
        keys = list(super()._sequence_to_key_events(_cleaned(code, modifiers, text, end)))
        for key in keys:
            if key.character is None and key.key in ("space", "shift+space"):
                key.character = " "
        if self.releases and keys and int(kind or PRESS) == PRESS:
            key = keys[0]
            self._noticed.append(KeyWentDown(base, key.key, key.character))
        return keys


def _is_character(code: str) -> bool:
    """Whether a number that the terminal sent can be a character: not beyond the last, no half."""
    return len(code) <= 7 and int(code) <= sys.maxunicode and not 0xD800 <= int(code) <= 0xDFFF


def _bare(modifiers: str) -> int:
    """The modifier field without the locks."""
    return (int(modifiers or 1) - 1 & ~_LOCKS) + 1


def _cleaned(code: str, modifiers: str, text: str, end: str) -> str:
    """The sequence as Textual knows it: no event type, no alternates, no modifier of one."""
    held = _bare(modifiers)
    # Textual reads the fields of a key without text only where there are modifiers.
    fields = [code or "1"]
    if held != 1 or text:
        fields.append(str(held))
    if text:
        fields.append(text)
    if len(fields) == 1 and end not in "u~":
        return f"\x1b[{end}"
    return "\x1b[" + ";".join(fields) + end
