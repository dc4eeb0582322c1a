"""What happened to the arm, newest last: slips, contacts, parts taken, placed and dropped."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from textwrap import wrap

from textual.events import MouseScrollDown, MouseScrollUp

from trs80arm.arm.events import ArmEvent, EventKind
from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import Ink, Row, clock_text
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.ui.panels.panel import Panel

_GLYPHS = {
    EventKind.SLIP: "!",
    EventKind.CONTACT: "x",
    EventKind.TAKEN: "^",
    EventKind.PLACED: "_",
    EventKind.DROPPED: "v",
}
_TROUBLE = {EventKind.SLIP, EventKind.DROPPED, EventKind.TOPPLED}
"""What goes wrong by itself; a contact does when it is a motor that is blocked."""


@dataclass(frozen=True)
class Entry:
    """A line of the log: the latest of some like events, how many, and their steps in all."""

    event: ArmEvent
    count: int
    steps: int


def collapsed(events: Sequence[ArmEvent], most: int) -> list[Entry]:
    """The last `most` lines of the log, oldest first; repeats are one line with a count.

    Events repeat each other when kind, motor and reason are the same and, but for slips, which
    differ in their steps, the text.
    """
    entries: list[Entry] = []
    for event in reversed(events):
        if entries and _alike(entries[-1].event, event):
            known = entries[-1]
            entries[-1] = Entry(known.event, known.count + 1, known.steps + event.steps)
            continue
        if len(entries) == most:
            break
        entries.append(Entry(event, 1, event.steps))
    entries.reverse()
    return entries


def _alike(one: ArmEvent, other: ArmEvent) -> bool:
    same = (one.kind, one.motor, one.reason) == (other.kind, other.motor, other.reason)
    return same and (one.kind is EventKind.SLIP or one.text == other.text)


class EventsLog(Panel):
    """The log of events; the wheel looks back."""

    HELP = """
## Events

What happened to the arm, with the machine's time: `!` a motor slipped, `x` something was in the
way, `^` a part was taken, `_` placed, `v` dropped. Repeats are counted on one line. The mouse wheel
looks back.
"""

    def __init__(self, *, id: str | None = None, classes: str | None = None) -> None:
        super().__init__(id=id, classes=classes)
        self._back = 0
        self._known: tuple[object, ...] = ()
        self._lines: list[Row] = []

    def draw(self, readings: Readings, width: int, height: int) -> list[Row]:
        """The last lines that fit, less those that the wheel has scrolled by."""
        events = readings.events
        known = (len(events), events[-1] if events else None, width, height, self._back)
        if known != self._known:
            self._known = known
            entries = collapsed(events, height + self._back)
            rows = [row for entry in entries for row in _rows(entry, width)]
            self._back = max(0, min(self._back, len(rows) - height))
            stop = len(rows) - self._back
            self._lines = rows[max(0, stop - height) : stop]
        return self._lines or [(("nothing has happened yet", Ink.LABEL),)]

    def on_mouse_scroll_up(self, event: MouseScrollUp) -> None:
        """Look back."""
        self._back += 1
        self.redraw()

    def on_mouse_scroll_down(self, event: MouseScrollDown) -> None:
        """Look forward again, to the newest."""
        self._back = max(0, self._back - 1)
        self.redraw()


def _rows(entry: Entry, width: int) -> list[Row]:
    """An entry as one line, or more where the panel is narrow."""
    event = entry.event
    time = clock_text(event.time / T_STATES_PER_SECOND)
    blocked = event.kind is EventKind.CONTACT and event.motor is not None
    ink = Ink.ALARM if blocked or event.kind in _TROUBLE else Ink.PLAIN
    count = f" x{entry.count}" if entry.count > 1 else ""
    if count and entry.steps:
        count = f", {abs(entry.steps)} in all{count}"
    glyph = _GLYPHS.get(event.kind, "-")
    indent = len(time) + 3
    texts = wrap(event.text + count, max(8, width - indent)) or [""]
    first: Row = ((f"{time} ", Ink.LABEL), (f"{glyph} {texts[0]}", ink))
    return [first, *(((" " * indent + text, ink),) for text in texts[1:])]
