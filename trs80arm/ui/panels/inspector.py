"""Panels of what is in the machine's memory: they are shown an `Inspection` beside the readings."""

from __future__ import annotations

from textwrap import wrap
from typing import ClassVar

from textual.events import MouseScrollDown, MouseScrollUp
from textual.message import Message

from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import Ink, Row
from trs80arm.inspection import Inspection, line_text
from trs80arm.ui.panels.panel import Panel

_AHEAD = 3
"""One line in so many of a listing's panel stands above the line that is executed."""


class Asked(Message):
    """A panel was clicked that stands for a command.

    Args:
        command: its name.
    """

    def __init__(self, command: str) -> None:
        super().__init__()
        self.command = command


class Inspector(Panel):
    """A panel of an inspection; subclasses say in `rows` what of it is seen."""

    NOTHING: ClassVar[str]
    """What it says while there is nothing to be seen, and what would change that."""

    def __init__(self, *, id: str | None = None, classes: str | None = None) -> None:
        super().__init__(id=id, classes=classes)
        self._inspection = Inspection()
        self._scrolled = 0

    def inspect(self, inspection: Inspection) -> None:
        """Show what is in memory from now on."""
        self._inspection = inspection

    def rows(self, inspection: Inspection) -> list[Row]:
        """All that there is to be seen."""
        raise TypeError(f"{type(self).__name__} does not say what is seen")

    def first(self, rows: list[Row], height: int) -> int:
        """The first row that is shown while nobody scrolls."""
        return 0

    def draw(self, readings: Readings, width: int, height: int) -> list[Row]:
        """The rows that fit, from where the wheel has scrolled to."""
        rows = self.rows(self._inspection)
        if not rows:
            return [((line, Ink.LABEL),) for line in wrap(self.NOTHING, width)]
        most = max(0, len(rows) - height)
        first = min(max(0, self.first(rows, height)), most)
        self._scrolled = min(max(self._scrolled, -first), most - first)
        return rows[first + self._scrolled :][:height]

    def scroll(self, rows: int) -> None:
        """Look so many rows further down, or up."""
        self._scrolled += rows
        self.redraw()

    def on_mouse_scroll_up(self, event: MouseScrollUp) -> None:
        """Look further up."""
        self.scroll(-1)

    def on_mouse_scroll_down(self, event: MouseScrollDown) -> None:
        """Look further down."""
        self.scroll(1)


class ListingPanel(Inspector):
    """The program in memory, with the line that is executed next."""

    NOTHING = "no program in memory: F2 opens one, or type lines that begin with a number"
    HELP = """
## Listing

The program in memory, as LIST shows it. `>` marks the line that is executed next. The mouse wheel
looks elsewhere.
"""

    def rows(self, inspection: Inspection) -> list[Row]:
        """A row for each line."""
        return [
            (
                (">" if line[0] == inspection.next_line else " ", Ink.ALARM),
                (line_text(line), Ink.STRONG if line[0] == inspection.next_line else Ink.PLAIN),
            )
            for line in inspection.lines
        ]

    def first(self, rows: list[Row], height: int) -> int:
        """So that the line that is executed is in the upper third."""
        numbers = [number for number, _ in self._inspection.lines]
        if self._inspection.next_line not in numbers:
            return 0
        return numbers.index(self._inspection.next_line) - height // _AHEAD


class VariablesPanel(Inspector):
    """The variables and what they hold."""

    NOTHING = "no variables: a program that runs makes them"
    HELP = """
## Variables

The program's variables in the order in which they were created, then its arrays with the first of
their elements. The mouse wheel looks further down.
"""

    def rows(self, inspection: Inspection) -> list[Row]:
        """A row for each variable."""
        variables = inspection.variables
        width = min(12, max((len(variable.name) for variable in variables), default=0)) + 1
        return [
            ((f"{variable.name:{width}}", Ink.LABEL), (variable.value, Ink.PLAIN))
            for variable in variables
        ]


class PaperPanel(Inspector):
    """The end of the printer's paper."""

    NOTHING = "nothing printed yet: LPRINT and LLIST print here"
    HELP = """
## Paper

What LPRINT and LLIST have printed, the newest at the bottom. PageUp and PageDown, or the mouse
wheel, look back and on. Ctrl+U, or a click, saves the paper or tears it off.
"""

    def rows(self, inspection: Inspection) -> list[Row]:
        """The paper's lines."""
        return [((line, Ink.PLAIN),) for line in inspection.paper]

    def on_click(self) -> None:
        """What can be done with the paper."""
        self.post_message(Asked("paper"))

    def first(self, rows: list[Row], height: int) -> int:
        """So that the newest is seen."""
        return len(rows) - height
