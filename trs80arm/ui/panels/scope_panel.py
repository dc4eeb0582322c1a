"""The scope: the latches as a logic analyser shows them, and what the joints did."""

from __future__ import annotations

from textual.events import MouseDown, MouseMove, MouseScrollDown, MouseScrollUp, MouseUp

from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import Row
from trs80arm.drawing.scope import LABEL, Scope
from trs80arm.ui.panels.panel import Panel

WHEEL = 8
"""Columns that a notch of the wheel goes back or on."""


class ScopePanel(Panel):
    """Latches and joints over time.

    Attributes:
        scope: how one looks; who changes it calls `redraw`.
    """

    ALLOW_SELECT = False
    HELP = """
## The scope

Time goes to the right; the figures below are seconds since power-on. All latches are shown at once,
each with its four phases where there is room, else with the row of the article's Figure 8 that it
holds (`1` to `8`, a dot for no current). `▒` is more than a column can show: come closer. For one
joint, there are the four phases of its motor and below them strip charts: angle, speed, how much of
its torque the motor has left, and the force of the grip.

Alt+Up and Alt+Down, or a click on the names, go from all latches to each joint. The wheel, or
Alt+Left and Alt+Right, goes back in time and on; at the end the picture follows by itself.
Ctrl+wheel, or Alt+PageUp and Alt+PageDown, shows more or less detail. A click puts the cursor, and
a drag measures the time between two places. The last 65,536 writes are kept.
"""

    def __init__(self, *, id: str | None = None, classes: str | None = None) -> None:
        super().__init__(id=id, classes=classes)
        self.scope = Scope()
        self._dragged = False

    @property
    def ascii(self) -> bool:
        """Whether signals are drawn in ASCII."""
        return self.scope.ascii

    @ascii.setter
    def ascii(self, value: bool) -> None:
        self.scope.ascii = value
        self.redraw()

    def draw(self, readings: Readings, width: int, height: int) -> list[Row]:
        """Words, signals, the time."""
        if readings.history is None:
            return []
        return self.scope.draw(readings.history, readings.model.motor_names, width, height)

    def scroll(self, columns: int) -> None:
        """Go back in time by so many columns, or on."""
        if self._readings is not None and self._readings.history is not None:
            self.scope.scroll(columns, self._readings.history)
            self.redraw()

    def on_mouse_down(self, event: MouseDown) -> None:
        """Put the cursor, and the mark with it; on the names, go to the next joint."""
        if event.x < LABEL:
            self.scope.next_joint(1)
        else:
            self._dragged = True
            self.capture_mouse()
            self.scope.put_cursor(event.x, mark=True)
        self.redraw()
        event.stop()

    def on_mouse_move(self, event: MouseMove) -> None:
        """Measure from where the mouse went down."""
        if self._dragged:
            self.scope.put_cursor(event.x)
            self.redraw()
            event.stop()

    def on_mouse_up(self, event: MouseUp) -> None:
        """The cursor stays where it is."""
        self._dragged = False
        self.release_mouse()
        event.stop()

    def on_mouse_scroll_up(self, event: MouseScrollUp) -> None:
        """Back in time; with Ctrl closer."""
        self._wheel(-WHEEL, 1, ctrl=event.ctrl)
        event.stop()

    def on_mouse_scroll_down(self, event: MouseScrollDown) -> None:
        """On in time; with Ctrl farther."""
        self._wheel(WHEEL, -1, ctrl=event.ctrl)
        event.stop()

    def _wheel(self, columns: int, way: int, *, ctrl: bool) -> None:
        if ctrl:
            self.scope.zoom(way)
            self.redraw()
        else:
            self.scroll(columns)
