"""A sheet that lies over a drawn panel and shows its picture in pixels."""

from __future__ import annotations

from math import sqrt

from textual.geometry import Region, Size
from textual.strip import Strip
from textual.widget import Widget

from trs80arm.drawing.picture import Picture
from trs80arm.drawing.pixels import Colours
from trs80arm.drawing.readings import Readings
from trs80arm.ui.terminal.pixels import PixelPicture, PixelScreen

FINE = 2
"""How many samples a pixel has each way in a picture of what stands; of what moves it is one."""
MOST_SAMPLES = 600_000
"""How many samples a picture has at most, a quarter of it while it moves; beyond it is blurred."""


class PixelSheet(Widget, can_focus=False):
    """A picture in pixels on the cells of this widget, which has no frame of its own."""

    ALLOW_SELECT = False
    DEFAULT_CSS = """
    PixelSheet { width: 100%; height: 100%; display: none; }
    """

    def __init__(self) -> None:
        super().__init__()
        self._picture: PixelPicture | None = None
        self._before: PixelPicture | None = None
        self._strips: list[Strip] = []
        self._at = Region()

    def show(
        self,
        screen: PixelScreen,
        picture: Picture,
        readings: Readings,
        size: Size,
        colours: Colours,
        *,
        moves: bool,
    ) -> None:
        """Show a picture of these readings.

        Args:
            screen: the terminal.
            picture: how it is to look.
            readings: what it is of.
            size: of this widget, once it is laid out.
            colours: the ground's, and each ink's.
            moves: whether the next picture will differ, so that this one need not be fine.
        """
        self.styles.height = size.height
        grain = _grain(screen.cell, size.area, 1 if moves else FINE)
        pixels = picture.pixels(readings, size.width, size.height, grain)
        self._before, self._picture = self._picture, screen.picture(pixels, colours)
        self._at = Region()
        self.refresh()

    def render_lines(self, crop: Region) -> list[Strip]:
        """The picture's rows; one that is shown the first time takes the place of another."""
        if self._picture is None or self._picture.size != self.size:
            return [Strip.blank(crop.width, self.rich_style) for _ in range(crop.height)]
        if self._at != self.region:
            self._at = self.region
            self._strips = self._picture.strips(self.region.x, self.region.y)
            if self._before is not None:
                last = self._strips[-1]
                self._strips[-1] = Strip([*last, self._before.farewell], last.cell_length)
        return self._strips[crop.y : crop.bottom]


def _grain(cell: tuple[int, int], cells: int, fine: float) -> tuple[int, int]:
    """How many samples a cell of so many pixels has, if there are so many cells: even numbers."""
    most = MOST_SAMPLES * (fine / FINE) ** 2
    fine = min(fine, sqrt(most / (cells * cell[0] * cell[1])))
    across, down = (2 * max(1, round(pixels * fine / 2)) for pixels in cell)
    return across, down
