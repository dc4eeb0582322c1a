"""What the palette finds: the commands of the table by title and by other words, and themes."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial

from textual.command import DiscoveryHit, Hit, Hits, Provider

from trs80arm.ui.commands.command import key_names
from trs80arm.ui.commands.table import COMMANDS

_BY_WORD = 0.5
"""The score of a command that is found by another word for it; a title's is up to 1 and more."""


@dataclass(frozen=True)
class _Entry:
    """A line of the palette: what it says, what finds it as well, and what it does."""

    title: str
    help: str
    also: str
    do: Callable[[], object]


class Palette(Provider):
    """The commands in the palette, each with its key, and every theme by its name."""

    def _entries(self) -> Iterator[_Entry]:
        for command in COMMANDS:
            if command.name == "palette":
                continue
            keys = ", ".join(key_names(command))
            title = f"{command.title}  ({keys})" if keys else command.title
            do = partial(self.app.run_action, f"do('{command.name}')")
            yield _Entry(title, command.help, command.also, do)

    def _themes(self) -> Iterator[_Entry]:
        for name in self.app.available_themes:
            do = partial(setattr, self.app, "theme", name)
            yield _Entry(f"Theme: {name}", "Show everything in these colours.", "colour color", do)

    async def discover(self) -> Hits:
        """All commands, before anything is typed."""
        for entry in self._entries():
            yield DiscoveryHit(entry.title, entry.do, help=entry.help)

    async def search(self, query: str) -> Hits:
        """Those that fit what was typed; a title that does goes before another word for it."""
        matcher = self.matcher(query)
        for entry in (*self._entries(), *self._themes()):
            by_title = matcher.match(entry.title)
            known = f"{entry.title} {entry.also}".casefold().split()
            by_word = all(
                any(word.startswith(part) for word in known) for part in query.casefold().split()
            )
            if by_title > 0 or by_word:
                score = max(by_title, _BY_WORD if by_word else 0.0)
                yield Hit(score, matcher.highlight(entry.title), entry.do, help=entry.help)
