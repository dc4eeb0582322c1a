"""The keyboard of the TRS-80 on the screen: to see what is down, and to click.

The left button holds a key as long as it is down, wherever it is let go; the right one latches it.
On the keys of manual mode stands the joint that they move, as in the article's Figure 11.
"""

from __future__ import annotations

from dataclasses import dataclass

from rich.segment import Segment
from rich.style import Style
from textual.reactive import reactive
from textual.strip import Strip

from trs80arm.drawing.readings import Readings
from trs80arm.machine.jog_keys import JogKeys
from trs80arm.machine.keys import ARROWS, INDENTS, PLAIN_ARROWS, ROWS_OF_KEYS
from trs80arm.rig import Key
from trs80arm.ui.panels.keys_by_mouse import KeysByMouse

_SPACE = {Key.SPACE: "          SPACE          "}
_CAPS, _ASCII_CAPS = ARROWS | _SPACE, PLAIN_ARROWS | _SPACE
JOINTS = "Base shoulder elbow wrist wrist hand"
"""J1 to J6 in a line of 80 columns."""
TALL = 9
"""Rows from which on each row of keys has a row of labels under it."""


@dataclass(frozen=True)
class _Cap:
    """One key on the screen: its columns are `start` to `stop` - 1."""

    key: Key
    start: int
    stop: int
    text: str
    label: str


class MatrixView(KeysByMouse):
    """The clickable keyboard."""

    HELP = """
    # The keyboard

    The TRS-80's keys as they lie. Hold one with the left mouse button; the right one latches it, so
    that several can be down at once. The keys of manual mode name their joints: `+` is a positive
    count, `-` a negative one.
    """
    ALLOW_SELECT = False
    COMPONENT_CLASSES = {  # noqa: RUF012
        "matrix--key",
        "matrix--down",
        "matrix--jog",
        "matrix--label",
    }
    DEFAULT_CSS = """
    MatrixView .matrix--key { color: $word; background: $panel; }
    MatrixView .matrix--jog { color: $key; background: $panel; text-style: bold; }
    MatrixView .matrix--down { color: $on-warning; background: $warning; text-style: bold; }
    MatrixView .matrix--label { color: $text-muted; }
    """

    ascii = reactive(False, init=False)
    """Whether arrows are drawn with plain characters."""

    def __init__(self, *, id: str | None = None) -> None:
        super().__init__(id=id)
        self._jog = JogKeys()
        self._down: frozenset[Key] = frozenset()

    def show(self, readings: Readings) -> None:
        """Show which keys are down, and what they do in manual mode."""
        if (readings.keys_down, readings.jog) != (self._down, self._jog):
            self._down, self._jog = readings.keys_down, readings.jog
            self.refresh()

    @property
    def _tall(self) -> bool:
        return self.size.height >= TALL

    def _label(self, key: Key) -> str:
        for joint, (plus, minus) in enumerate(
            zip(self._jog.positive, self._jog.negative, strict=True), start=1
        ):
            if key in (plus, minus):
                return f"J{joint}{'+' if key is plus else '-'}"
        return "END" if key is self._jog.leave else ""

    def _caps(self, row: int) -> list[_Cap]:
        """The keys of a row and where they are."""
        gap = 1
        width = 5 if self.size.width >= 76 else 4
        caps: list[_Cap] = []
        at = INDENTS[row]
        for key in ROWS_OF_KEYS[row]:
            text = (_ASCII_CAPS if self.ascii else _CAPS).get(key, key.value)
            stop = at + max(width - gap, len(text) + (2 if len(text) > 1 else 0))
            caps.append(_Cap(key, at, stop, text, self._label(key)))
            at = stop + gap
        return caps

    def _row_at(self, y: int) -> tuple[int, bool] | None:
        """The row of keys that a line of the widget shows, and whether it is its label line."""
        row, second = divmod(y, 2) if self._tall else (y, 0)
        return (row, bool(second)) if row < len(ROWS_OF_KEYS) else None

    def key_at(self, x: int, y: int) -> Key | None:
        """The key under a cell of the widget."""
        place = self._row_at(y)
        if place is None:
            return None
        return next((cap.key for cap in self._caps(place[0]) if cap.start <= x < cap.stop), None)

    def render_line(self, y: int) -> Strip:
        """A row of keys, a row of labels, or the line that says what the keys do."""
        width, ground = self.size.width, self.rich_style
        place = self._row_at(y)
        if place is None:
            last = y == len(ROWS_OF_KEYS) * (2 if self._tall else 1)
            text = self._legend(width) if last else ""
            style = self.get_component_rich_style("matrix--label")
            return Strip([Segment(text[:width].ljust(width), style)], width)
        row, is_label = place
        segments: list[Segment] = []
        at = 0
        for cap in self._caps(row):
            segments.append(Segment(" " * (cap.start - at), ground))
            if is_label:
                style = self.get_component_rich_style("matrix--label")
                segments.append(Segment(cap.label.center(cap.stop - cap.start), style))
            else:
                segments.append(Segment(self._face(cap), self._style(cap)))
            at = cap.stop
        return Strip(segments).adjust_cell_length(width, ground)

    def _face(self, cap: _Cap) -> str:
        """A key's top; one that is down shows it without colour, too."""
        width = cap.stop - cap.start
        if cap.key in self._down:
            return f"[{cap.text.strip()[: width - 2].center(width - 2)}]"
        return cap.text.center(width)

    def _style(self, cap: _Cap) -> Style:
        if cap.key in self._down:
            return self.get_component_rich_style("matrix--down")
        return self.get_component_rich_style("matrix--jog" if cap.label else "matrix--key")

    def _legend(self, width: int) -> str:
        """What the keys do in manual mode, as wordy as there is room for."""
        plus = "".join(self._jog.positive)
        minus = "".join(self._jog.negative)
        keys = f"@SET: {plus} forward, {minus} back, {self._jog.leave} ends."
        return f"{keys} {JOINTS}" if len(keys) + len(JOINTS) < width else keys
