"""A picture of the arm as a panel: what the side view, the top view and the one in space share."""

from __future__ import annotations

from typing import ClassVar

from textual.app import ComposeResult
from textual.events import MouseScrollDown, MouseScrollUp
from textual.geometry import Size

from trs80arm.drawing.picture import Picture, Subject, seen
from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import Ink, Row
from trs80arm.options import ArmStyle
from trs80arm.ui.panels.panel import Panel
from trs80arm.ui.panels.pixel_sheet import PixelSheet
from trs80arm.ui.terminal.pixels import PixelScreen


class ArmView(Panel):
    """A picture of the arm; subclasses say of what.

    Attributes:
        picture: the picture; who changes how it looks calls `redraw`.
        pixels: the terminal, if it shows pixels.
    """

    ALLOW_SELECT = False
    SUBJECT: ClassVar[Subject]

    def __init__(self, *, id: str | None = None, classes: str | None = None) -> None:
        super().__init__(id=id, classes=classes)
        self.picture = Picture(self.SUBJECT)
        self.pixels: PixelScreen | None = None
        self._sheet = PixelSheet()
        self._moves = False

    def compose(self) -> ComposeResult:
        """The sheet for pixels, over the rows; where there are none it is never needed."""
        if self.pixels is not None:
            yield self._sheet

    def show(self, readings: Readings) -> None:
        """Show these readings, and lengthen the trail; a picture in which nothing moved stands."""
        self.picture.follow(readings)
        moves = self._readings is None or seen(readings) != seen(self._readings)
        if moves or self._in_pixels != self._sheet.display or self._moves:
            self._moves = moves and self._sheet.display
            super().show(readings)
        self._readings = readings

    def redraw(self) -> None:
        """Draw the last readings again, in pixels where they can be seen."""
        self._sheet.display = self._in_pixels
        if self._sheet.display and not self._sheet.is_attached:
            self.mount(self._sheet)
        super().redraw()

    def draw(self, readings: Readings, width: int, height: int) -> list[Row]:
        """The picture with its words."""
        colours = self.colours if self._sheet.display else None
        if self.pixels is None or colours is None:
            return self.picture.draw(readings, width, height)
        caption = self.picture.caption(readings, width, height)
        size = Size(width, height - 1 if caption else height)
        self._sheet.show(self.pixels, self.picture, readings, size, colours, moves=self._moves)
        return [*[()] * size.height, ((caption, Ink.LABEL),)]

    def on_mouse_scroll_up(self, event: MouseScrollUp) -> None:
        """Closer."""
        self.picture.zoom_in()
        self.redraw()
        event.stop()

    def on_mouse_scroll_down(self, event: MouseScrollDown) -> None:
        """Farther."""
        self.picture.zoom_out()
        self.redraw()
        event.stop()

    @property
    def _in_pixels(self) -> bool:
        """Whether it is to be in pixels: nothing may lie over them."""
        if self.pixels is None or self.picture.style is not ArmStyle.PIXELS:
            return False
        bare = self.is_attached and self.screen.is_active and not self.screen.query("Toast")
        return bare and self.colours is not None
