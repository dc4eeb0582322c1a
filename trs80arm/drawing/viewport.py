"""The window through which a view looks at a scene: inches to cells, zoom, and drawing.

A fitted window grows when the arm leaves it and never shrinks by itself, so that the picture stands
still while the arm moves. A closer look follows the hand in whole cells.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise
from math import ceil, floor, hypot
from typing import Protocol

from trs80arm.drawing.canvas_ascii import AsciiCanvas, Point
from trs80arm.drawing.scene import Block, Bounds, Facet, Joint, Scene, Stroke, Trace, around

ASPECT = 2.0
"""How many times higher than wide a terminal's cell is."""
ZOOMS = (0.5, 0.7, 1.0, 1.4, 2.0, 3.0, 4.5)
"""The steps of the zoom, as multiples of the fitted scale."""
FIT = ZOOMS.index(1.0)
GROWTH = 2.5
"""Steps by which a fitted window grows, inches: the scale changes seldom while the arm rises."""
RAILS_FROM = 0.95
"""Rows of the canvas that a link must be deep to be drawn as two rails."""
ROUND_FROM = 1.4
"""Rows an inch from which joints are drawn as discs."""
_THIN = 0.1
"""Height of what is let into the table, inches."""
_EDGE = 0.02
"""How far within a cell something is that is just in it, cells."""
LEAST_COLUMNS, LEAST_ROWS = 5, 2.5
"""Cells that a tilted thing must cover to be drawn as its outline."""
RAIL_INSET = 0.4
"""How far rails end before the joints, as a share of their distance, so that they do not cross."""


class Framed(Protocol):
    """What a window is put on: `Scene` says what its attributes are."""

    @property
    def bounds(self) -> Bounds:
        """What belongs into the picture."""

    @property
    def focus(self) -> Point:
        """What a closer look is centred on."""

    @property
    def resting(self) -> float | None:
        """The height at which the hand holds what lies on the table, None from above."""


@dataclass(frozen=True)
class Window:
    """A part of the plane, in cells.

    Attributes:
        left: inches at the left edge of the canvas.
        top: inches at its upper edge.
        scale: rows an inch; columns are twice as many.
    """

    left: float
    top: float
    scale: float

    def cell(self, point: Point) -> Point:
        """A point of the plane in cells from the upper left corner."""
        return (
            (point[0] - self.left) * self.scale * ASPECT,
            (self.top - point[1]) * self.scale,
        )

    def aligned(self) -> Window:
        """The same with height 0 at the upper edge of the row in which it is."""
        return replace(self, top=floor(self.top * self.scale) / self.scale)


class Viewport:
    """The window of one view.

    Args:
        least: what is seen in any case, wherever the arm is; None for what belongs into the picture
            and no more.

    Attributes:
        zoom: index into `ZOOMS`.
    """

    def __init__(self, least: Bounds | None = None) -> None:
        self.zoom = FIT
        self._least = least
        self._bounds = least
        self._window: tuple[int, int, int, Bounds, Window] | None = None

    def fit(self) -> None:
        """Show everything, as large as it will go."""
        self.zoom = FIT
        self.forget()

    def forget(self) -> None:
        """Forget how far the arm has been; the zoom stays."""
        self._bounds = self._least
        self._window = None

    def window(self, scene: Framed, width: int, height: int) -> Window:
        """The window on a scene for a canvas of `width` x `height` cells."""
        bounds = self._bounds = _union(self._bounds, scene.bounds)
        known = self._window
        if known and known[:4] == (width, height, self.zoom, bounds):
            window = known[4]
        else:
            window = _fitted(bounds, width, height, ZOOMS[self.zoom])
            if scene.resting is not None:
                window = _grounded(window, scene.resting)
            if self.zoom > FIT:
                window = _centred(window, scene.focus, width, height)
        if self.zoom > FIT:
            window = _following(window, scene.focus, width, height)
        self._window = (width, height, self.zoom, bounds, window)
        return window


def _union(known: Bounds | None, new: Bounds) -> Bounds:
    """What must be seen now and what had to be seen before, by whole steps to the right and up."""
    new = (new[0], new[1], GROWTH * ceil(new[2] / GROWTH), GROWTH * ceil(new[3] / GROWTH))
    if known is None:
        return new
    return (
        min(known[0], new[0]),
        min(known[1], new[1]),
        max(known[2], new[2]),
        max(known[3], new[3]),
    )


def _fitted(bounds: Bounds, width: int, height: int, zoom: float) -> Window:
    left, bottom, right, top = bounds
    scale = zoom * min(width / ASPECT / (right - left), height / (top - bottom))
    # Whatever room is left over goes above and on both sides: the table stays at the bottom.
    spare = width / ASPECT / scale - (right - left)
    return Window(left - spare / 2, bottom + height / scale, scale)


def _grounded(window: Window, resting: float) -> Window:
    """The window moved by less than a row, so that what rests on the table is just in its row.

    What is lifted then leaves that row at once, and hand and part do so together.
    """
    table, part = window.cell((0.0, 0.0))[1], window.cell((0.0, resting))[1]
    if 2 * (table - part) >= 1:
        # Such a part is a row high or more, and lifted by a row it is seen to be. Thin things that
        # lie on the table are in the table's row.
        down = max(0.0, _THIN * window.scale + _EDGE - (table - floor(table)))
    else:
        down = floor(table) + _EDGE - part
    return replace(window, top=window.top + down / window.scale)


def _centred(window: Window, focus: Point, width: int, height: int) -> Window:
    scale = window.scale
    return replace(
        window,
        left=focus[0] - width / ASPECT / scale / 2,
        top=focus[1] + height / scale / 2,
    )


def _following(window: Window, focus: Point, width: int, height: int) -> Window:
    """The window moved, by whole cells, so that the focus is in its middle half."""
    x, y = window.cell(focus)
    right = _overshoot(x, width)
    down = _overshoot(y, height)
    scale = window.scale
    return replace(window, left=window.left + right / scale / ASPECT, top=window.top - down / scale)


def _overshoot(place: float, size: int) -> int:
    low, high = size / 4, size * 3 / 4
    if place < low:
        return -int(low - place + 1)
    return int(place - high + 1) if place > high else 0


def draw(scene: Scene, window: Window, canvas: AsciiCanvas) -> None:
    """Draw a scene's shapes on a canvas, back to front."""
    for shape in scene.shapes:
        match shape:
            case Stroke():
                _stroke(shape, window, canvas)
            case Joint(place, ink, glyph, small):
                round_it = window.scale > ROUND_FROM and not small
                canvas.joint(window.cell(place), ink, glyph, round_it=round_it)
            case Block(corner, opposite, ink, fill):
                canvas.box(window.cell(corner), window.cell(opposite), ink, fill)
            case Facet():
                _facet(shape, window, canvas)
            case Trace(points, ink, glyphs):
                canvas.dots(map(window.cell, points), ink, glyphs)


def _stroke(stroke: Stroke, window: Window, canvas: AsciiCanvas) -> None:
    start, end = stroke.start, stroke.end
    if stroke.dotted:
        _dots(window.cell(start), window.cell(end), stroke, canvas)
        return
    if stroke.width * window.scale < RAILS_FROM:
        canvas.line(window.cell(start), window.cell(end), stroke.ink)
        return
    dx, dy = end[0] - start[0], end[1] - start[1]
    length = hypot(dx, dy) or 1.0
    across = (-dy / length * stroke.width / 2, dx / length * stroke.width / 2)
    inset = RAIL_INSET * stroke.width / length
    start = (start[0] + dx * inset, start[1] + dy * inset)
    end = (end[0] - dx * inset, end[1] - dy * inset)
    for side in (-1, 1):
        canvas.line(
            window.cell((start[0] + side * across[0], start[1] + side * across[1])),
            window.cell((end[0] + side * across[0], end[1] + side * across[1])),
            stroke.ink,
        )


def _facet(facet: Facet, window: Window, canvas: AsciiCanvas) -> None:
    """A filled outline; one of few cells as the upright box around it."""
    corners = [window.cell(corner) for corner in facet.corners]
    left, top, right, bottom = around(corners)
    if right - left < LEAST_COLUMNS or bottom - top < LEAST_ROWS:
        canvas.box((left, bottom), (right, top), facet.ink, facet.fill)
        return
    for row in range(max(0, floor(top)), min(canvas.height, ceil(bottom))):
        crossed = [
            x0 + (row + 0.5 - y0) / (y1 - y0) * (x1 - x0)
            for (x0, y0), (x1, y1) in pairwise([*corners, corners[0]])
            if min(y0, y1) <= row + 0.5 < max(y0, y1)
        ]
        if crossed:
            first, last = ceil(min(crossed) - 0.5), floor(max(crossed) - 0.5)
            canvas.write(first, row, facet.fill * (last - first + 1), facet.ink)
    for start, end in pairwise([*corners, corners[0]]):
        canvas.line(start, end, facet.ink)


def _dots(start: Point, end: Point, stroke: Stroke, canvas: AsciiCanvas) -> None:
    """One mark for each row, or each second column, that the stroke passes."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    count = max(1, round(max(abs(dx) / 2, abs(dy))))
    points = ((start[0] + dx * n / count, start[1] + dy * n / count) for n in range(count + 1))
    canvas.dots(points, stroke.ink, "::")
