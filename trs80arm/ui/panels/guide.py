"""Two lines above the status line in which the tour says what to press."""

from __future__ import annotations

import re

from textual.events import Click

from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import Ink, Row, Span
from trs80arm.ui.panels.inspector import Asked
from trs80arm.ui.panels.panel import Panel

ROWS = 2
_KEY = re.compile("`([^`]*)`")
"""What is to be typed or pressed, in words."""


class GuideBar(Panel):
    """Two lines of the tour, or none.

    Attributes:
        lines: what they say, keys between backticks; empty for none.
        title: what stands before the first one.
    """

    def __init__(self, *, id: str | None = None, classes: str | None = None) -> None:
        super().__init__(id=id, classes=classes)
        self.title = ""
        self.lines: tuple[str, ...] = ()
        self._readings = Readings()

    def say(self, title: str, lines: tuple[str, ...]) -> None:
        """Say something else from now on."""
        self.title, self.lines = title, lines
        self.redraw()

    def draw(self, readings: Readings, width: int, height: int) -> list[Row]:
        """The title and the first line, and the others below."""
        if not self.lines:
            return []
        first, *others = map(_spans, self.lines)
        return [((f"{self.title}  ", Ink.LAMP_ON), *first), *map(tuple, others)]

    def on_click(self, event: Click) -> None:
        """What can be done with the tour."""
        self.post_message(Asked("tour"))


def _spans(words: str) -> list[Span]:
    """Words with their keys in a stronger ink."""
    return [
        (part, Ink.STRONG if number % 2 else Ink.PLAIN)
        for number, part in enumerate(_KEY.split(words))
        if part
    ]
