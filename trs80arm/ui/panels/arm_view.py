"""What the side view and the top view have in common: canvas, zoom, envelope and trail."""

from __future__ import annotations

from collections import deque
from math import dist

from trs80arm.drawing.canvas_ascii import AsciiCanvas
from trs80arm.drawing.canvas_braille import BrailleCanvas
from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import Ink, Row, fitted
from trs80arm.drawing.scene import Extras, Scene, TrailPoint, trail_point
from trs80arm.drawing.viewport import ZOOMS, Viewport, draw
from trs80arm.ui.panels.panel import Panel

TRAIL_POINTS = 800
"""How many places of the fingertip a trail keeps."""
WITH_CAPTION = 9
"""Rows from which a view gives one up for its caption."""
TRAIL_STEP = 0.1
"""How far the fingertip must have gone for the next one, inches."""


class ArmView(Panel):
    """A drawing of the arm; subclasses choose the scene and the words."""

    ALLOW_SELECT = False

    def __init__(self, *, id: str | None = None, classes: str | None = None) -> None:
        super().__init__(id=id, classes=classes)
        self._viewport = Viewport()
        self._trail: deque[TrailPoint] = deque(maxlen=TRAIL_POINTS)
        self._braille = False
        self._envelope = False
        self._with_trail = False
        self._labels = True

    @property
    def braille(self) -> bool:
        """Whether the view is drawn in braille dots instead of plain ASCII."""
        return self._braille

    @braille.setter
    def braille(self, value: bool) -> None:
        self._braille = value
        self.redraw()

    @property
    def envelope(self) -> bool:
        """Whether the reach of the fingertip is outlined."""
        return self._envelope

    @envelope.setter
    def envelope(self, value: bool) -> None:
        self._envelope = value
        if not value:
            self._viewport.forget()
        self.redraw()

    @property
    def trail(self) -> bool:
        """Whether the way of the fingertip is marked."""
        return self._with_trail

    @trail.setter
    def trail(self, value: bool) -> None:
        self._with_trail = value
        self._trail.clear()
        self.redraw()

    @property
    def labels(self) -> bool:
        """Whether the angles are written into the view."""
        return self._labels

    @labels.setter
    def labels(self, value: bool) -> None:
        self._labels = value
        self.redraw()

    def zoom_in(self) -> None:
        """Look closer; the view then follows the hand."""
        self._viewport.zoom = min(self._viewport.zoom + 1, len(ZOOMS) - 1)
        self.redraw()

    def zoom_out(self) -> None:
        """Look from further away."""
        self._viewport.zoom = max(self._viewport.zoom - 1, 0)
        self.redraw()

    def zoom_fit(self) -> None:
        """Show the arm and all that stands near it, as large as it will go."""
        self._viewport.fit()
        self.redraw()

    def clear_trail(self) -> None:
        """Forget where the fingertip has been."""
        self._trail.clear()
        self.redraw()

    def show(self, readings: Readings) -> None:
        """Show these readings, and lengthen the trail."""
        if self._with_trail:
            point = trail_point(readings.posture)
            last = self._trail[-1] if self._trail else None
            if last is None or max(dist(last.side, point.side), dist(last.top, point.top)) > (
                TRAIL_STEP
            ):
                self._trail.append(point)
        super().show(readings)

    def scene(self, readings: Readings, extras: Extras) -> Scene:
        """What is to be drawn."""
        raise TypeError(f"{type(self).__name__} does not say what it draws")

    def caption(self, readings: Readings, width: int) -> str:
        """What is written under the drawing, as wordy as `width` cells allow."""
        raise TypeError(f"{type(self).__name__} does not say what is written under it")

    def draw(self, readings: Readings, width: int, height: int) -> list[Row]:
        """The drawing with its words."""
        caption = self.caption(readings, width) if self._labels and height >= WITH_CAPTION else ""
        if caption:
            height -= 1
        scene = self.scene(readings, Extras(self._envelope, tuple(self._trail)))
        canvas = (BrailleCanvas if self._braille else AsciiCanvas)(width, height)
        draw(scene, self._viewport.window(scene, width, height), canvas)
        rows = canvas.rows()
        return [*rows, fitted(((caption, Ink.LABEL),), width)] if caption else rows
