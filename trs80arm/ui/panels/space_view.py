"""The arm in space: in perspective, from wherever one likes to look."""

from __future__ import annotations

from math import radians

from textual.events import MouseDown, MouseMove, MouseUp

from trs80arm.drawing.picture import IN_SPACE
from trs80arm.ui.panels.arm_view import ArmView

A_COLUMN, A_ROW = radians(2.0), radians(4.0)
"""How far a drag by a cell turns the view."""


class SpaceView(ArmView):
    """Arm and bench in perspective; the mouse turns them."""

    SUBJECT = IN_SPACE
    HELP = """
## The arm in space

Arm and bench in perspective. Drag with the mouse, or press Ctrl+Left and Ctrl+Right, to walk round
them; drag up and down, or press Ctrl+PageUp and Ctrl+PageDown, to look from higher up or lower
down. The wheel, or Ctrl+Up and Ctrl+Down, goes closer and farther; a closer look follows the hand.
The dots on the table are inches, the figures count them from the axis of the base, and what is dark
on it is the shadow. The hand is as it is rolled.
"""

    def __init__(self, *, id: str | None = None, classes: str | None = None) -> None:
        super().__init__(id=id, classes=classes)
        self._dragged = False

    def on_mouse_down(self, event: MouseDown) -> None:
        """Take hold of the picture."""
        self._dragged = True
        self.capture_mouse()
        event.stop()

    def on_mouse_up(self, event: MouseUp) -> None:
        """Let go of it."""
        self._dragged = False
        self.release_mouse()
        event.stop()

    def on_mouse_move(self, event: MouseMove) -> None:
        """Turn it with the mouse."""
        if self._dragged:
            self.picture.turn(-event.delta_x * A_COLUMN, event.delta_y * A_ROW)
            self.redraw()
            event.stop()
