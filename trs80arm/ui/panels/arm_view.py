"""A picture of the arm as a panel: what the side view and the top view have in common."""

from __future__ import annotations

from typing import ClassVar

from trs80arm.drawing.picture import Picture, Subject
from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import Row
from trs80arm.ui.panels.panel import Panel


class ArmView(Panel):
    """A picture of the arm; subclasses say of what.

    Attributes:
        picture: the picture; who changes how it looks calls `redraw`.
    """

    ALLOW_SELECT = False
    SUBJECT: ClassVar[Subject]

    def __init__(self, *, id: str | None = None, classes: str | None = None) -> None:
        super().__init__(id=id, classes=classes)
        self.picture = Picture(self.SUBJECT)
        self._drawn: object = None

    def show(self, readings: Readings) -> None:
        """Show these readings, and lengthen the trail; a picture in which nothing moved stands."""
        self.picture.follow(readings)
        seen = (readings.posture, readings.believed, readings.things, readings.fittings)
        if seen != self._drawn:
            super().show(readings)
        self._drawn, self._readings = seen, readings

    def draw(self, readings: Readings, width: int, height: int) -> list[Row]:
        """The picture with its words."""
        return self.picture.draw(readings, width, height)
