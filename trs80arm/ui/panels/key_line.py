"""Keys and what they do, in lines to read and to click."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from textual import events

from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import Ink, Row, Span
from trs80arm.ui.panels.panel import Panel


@dataclass(frozen=True)
class KeyHint:
    """A key of a screen.

    Attributes:
        key: as it is called.
        word: what it does.
        action: of the screen, which a click does.
    """

    key: str
    word: str
    action: str


@dataclass(frozen=True)
class _Place:
    hint: KeyHint
    x: int
    y: int

    @property
    def stop(self) -> int:
        return self.x + len(self.hint.key) + 1 + len(self.hint.word)


class KeyLine(Panel):
    """The keys of a screen, as many as there is room for, those that matter most first."""

    ALLOW_SELECT = False

    def __init__(self, hints: Sequence[KeyHint]) -> None:
        super().__init__()
        self._hints = hints

    def on_mount(self) -> None:
        """They are there from the beginning."""
        self.show(Readings())

    def places(self, width: int, height: int) -> list[_Place]:
        """Where each stands."""
        found: list[_Place] = []
        x = y = 0
        for hint in self._hints:
            place = _Place(hint, x, y)
            if place.stop > width:
                y += 1
                place = _Place(hint, 0, y)
            if y >= height:
                break
            found.append(place)
            x = place.stop + 2
        return found

    def draw(self, readings: Readings, width: int, height: int) -> list[Row]:
        """The lines."""
        rows: list[list[Span]] = [[] for _ in range(height)]
        for place in self.places(width, height):
            row = rows[place.y]
            if row:
                row.append(("  ", Ink.PLAIN))
            row += [(place.hint.key, Ink.STRONG), (f" {place.hint.word}", Ink.PLAIN)]
        return [tuple(row) for row in rows]

    async def on_click(self, event: events.Click) -> None:
        """Do what was clicked."""
        for place in self.places(*self.size):
            if place.y == event.y and place.x <= event.x < place.stop:
                await self.screen.run_action(place.hint.action)
