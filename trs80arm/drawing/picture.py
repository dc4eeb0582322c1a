"""A picture of the arm as rows of text: a scene, a window onto it, a canvas, and words below.

It remembers what one looks at, zoom and trail and options, and nothing of a screen: the terminal
shows it in a panel, a test or a run without a screen prints its rows.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from math import degrees, dist, floor, radians, tau

import numpy as np

from trs80arm.drawing.camera import Camera
from trs80arm.drawing.canvas_ascii import AsciiCanvas
from trs80arm.drawing.cells import Cells, LastRows, Marks, SheetShape, apart
from trs80arm.drawing.pixels import Pixels
from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import Ink, Row, fitted, signed
from trs80arm.drawing.scale import rule_height, rule_table
from trs80arm.drawing.scene import (
    Extras,
    Scene,
    TrailPoint,
    differs_from_the_side,
    trail_point,
)
from trs80arm.drawing.side_scene import side_scene
from trs80arm.drawing.solids import Floats
from trs80arm.drawing.studio import Label, Mark, Orbit, Shot, side_shot, space_shot, take, top_shot
from trs80arm.drawing.styles import SOLID_STYLES
from trs80arm.drawing.top_scene import top_scene
from trs80arm.drawing.viewport import ASPECT, ZOOMS, Viewport, Window, draw
from trs80arm.options import ArmStyle

TRAIL_POINTS = 800
"""How many places of the fingertip a trail keeps."""
TRAIL_STEP = 0.1
"""How far the fingertip must have gone for the next one, inches."""
LOWEST, HIGHEST = radians(4), radians(89)
"""How far above the table one looks from in space."""
UNSEEN = 0.25
"""How many of the finest samples that a picture has the arm may move and not be drawn again."""
_WIDE = 2.0
"""How far from the hand's axis anything that turns with it may be, inches."""
WITH_CAPTION = 9
"""Rows from which a picture gives one up for its caption."""
_LEGENDS = ("  :: where the motors were told to be", "  :: as commanded", " :: told")


@dataclass(frozen=True)
class Subject:
    """What a picture is of.

    Attributes:
        shot: what there is to be seen, in solids.
        caption: what is written under it, as wordy as so many cells allow.
        scene: what is to be drawn in outlines; None where outlines say nothing.
    """

    shot: Callable[[Readings, Orbit, Extras], Shot]
    caption: Callable[[Readings, int], str]
    scene: Callable[[Readings, Extras], Scene] | None = None


class Picture:
    """A picture of the arm.

    Args:
        subject: what it is of.

    Attributes:
        style: with which characters it is drawn.
        labels: whether the caption is written below, and the scales.
        orbit: from where the view in space looks.
    """

    def __init__(self, subject: Subject) -> None:
        self.style = ArmStyle.ASCII
        self.labels = True
        self.orbit = Orbit()
        self._subject = subject
        self._viewport = Viewport()
        self._last = LastRows()
        self._look: object = None
        self._rows: list[Row] = []
        self._drawn = self._asked = Readings()
        self._grain = 0.0
        self._trail: deque[TrailPoint] = deque(maxlen=TRAIL_POINTS)
        self._with_trail = False
        self._envelope = False

    @property
    def envelope(self) -> bool:
        """Whether the reach of the fingertip is outlined."""
        return self._envelope

    @envelope.setter
    def envelope(self, value: bool) -> None:
        self._envelope = value
        self._look = None
        if not value:
            self._viewport.forget()

    @property
    def trail(self) -> bool:
        """Whether the way of the fingertip is marked."""
        return self._with_trail

    @trail.setter
    def trail(self, value: bool) -> None:
        self._with_trail = value
        self._trail.clear()

    def zoom_in(self) -> None:
        """Look closer; the picture then follows the hand."""
        self._look = None
        self._viewport.zoom = min(self._viewport.zoom + 1, len(ZOOMS) - 1)

    def zoom_out(self) -> None:
        """Look from further away."""
        self._look = None
        self._viewport.zoom = max(self._viewport.zoom - 1, 0)

    def zoom_fit(self) -> None:
        """Show the arm and all that stands near it, as large as it will go."""
        self._look = None
        self._viewport.fit()

    def turn(self, round_it: float, above: float) -> None:
        """Look from elsewhere in space.

        Args:
            round_it: radians counter-clockwise round the table.
            above: radians up, as far as straight above and to just over the table.
        """
        tilt = min(max(self.orbit.tilt + above, LOWEST), HIGHEST)
        self.orbit = Orbit((self.orbit.turn + round_it) % tau, tilt)
        self._viewport.forget()
        self._look = None

    def clear_trail(self) -> None:
        """Forget where the fingertip has been."""
        self._trail.clear()

    def follow(self, readings: Readings) -> None:
        """Lengthen the trail, if it is wanted."""
        if not self._with_trail:
            return
        point = trail_point(readings.posture)
        last = self._trail[-1] if self._trail else None
        if last is None or max(dist(last.side, point.side), dist(last.top, point.top)) > TRAIL_STEP:
            self._trail.append(point)

    def draw(self, readings: Readings, width: int, height: int) -> list[Row]:
        """The drawing with its words, `height` rows of `width` cells."""
        caption = self.caption(readings, width, height)
        if caption:
            height -= 1
        trail = self._trail[-1] if self._trail else None
        look = width, height, self.style, self.labels, self._envelope, self._with_trail, trail
        if look != self._look or self._shows_other(readings):
            self._rows = self._rows_of(readings, width, height)
            self._look, self._drawn = look, readings
        self._asked = readings
        return [*self._rows, *([fitted(((caption, Ink.LABEL),), width)] if caption else [])]

    def _rows_of(self, readings: Readings, width: int, height: int) -> list[Row]:
        extras = self._extras
        scene = self._subject.scene
        if self.style is ArmStyle.OUTLINE and scene is not None:
            return self._outlined(scene(readings, extras), width, height)
        return self._solid(self._subject.shot(readings, self.orbit, extras), width, height)

    def _shows_other(self, readings: Readings) -> bool:
        """Whether a picture of these readings could differ from the last one drawn.

        Of what moves, not before it has moved by a part of a sample; where it comes to stand, if
        it is elsewhere at all.
        """
        drawn, asked = self._drawn, self._asked
        if readings.posture == asked.posture and readings.things == asked.things:
            return seen(readings) != seen(drawn)
        return _lying(readings) != _lying(drawn) or _moved(readings, drawn) > UNSEEN * self._grain

    def caption(self, readings: Readings, width: int, height: int) -> str:
        """What is written in the last row of so many, or nothing."""
        captioned = self.labels and height >= WITH_CAPTION
        return self._subject.caption(readings, width) if captioned else ""

    def pixels(self, readings: Readings, width: int, height: int, grain: tuple[int, int]) -> Pixels:
        """The drawing without its caption, in samples much finer than a cell.

        Args:
            readings: what it is of.
            width: cells.
            height: cells.
            grain: how many samples a cell has across and down, even numbers.
        """
        shot = self._subject.shot(readings, self.orbit, self._extras)
        window = self._window(shot, width, height)
        pixels = Pixels.of(take(shot, width, height, grain, window), grain)
        self._mark(pixels.words, shot, window)
        return pixels

    @property
    def _extras(self) -> Extras:
        return Extras(self._envelope, tuple(self._trail))

    def _outlined(self, scene: Scene, width: int, height: int) -> list[Row]:
        canvas = AsciiCanvas(width, height)
        window = self._viewport.window(scene, width, height)
        self._grain = 1 / (window.scale * ASPECT)
        draw(scene, window, canvas)
        return canvas.rows()

    def _solid(self, shot: Shot, width: int, height: int) -> list[Row]:
        style = SOLID_STYLES.get(self.style, SOLID_STYLES[ArmStyle.ASCII])
        window = self._window(shot, width, height)
        across, down = style.samples
        self._grain = 1 / (window.scale * max(ASPECT * across, down))
        cells = style.draw(take(shot, width, height, style.samples, window))
        self._mark(cells, shot, window)
        return self._last.of(cells)

    def _window(self, shot: Shot, width: int, height: int) -> Window:
        window = self._viewport.window(shot, width, height)
        return window if shot.resting is None else window.aligned()

    def _mark(self, cells: Cells, shot: Shot, window: Window) -> None:
        """Dots on the table and in the air, scales and figures."""
        shape = cells.glyphs.shape
        for mark in shot.marks:
            if window.scale >= mark.least:
                cells.mark(_dots(mark, shot.camera, window, shape))
        if self.labels:
            if shot.resting is not None:
                rule_table(cells, window)
                rule_height(cells, window)
            if shot.labels:
                cells.mark(_labels(tuple(shot.labels), shot.camera, window, shape))


def seen(readings: Readings) -> tuple[object, ...]:
    """All that a picture shows of the machine."""
    return readings.posture, readings.believed, readings.things, readings.fittings


def _lying(readings: Readings) -> tuple[object, ...]:
    """What a picture shows that does not move with the arm."""
    loose = [thing for thing in readings.things if not thing.held]
    return readings.held, readings.believed, readings.fittings, loose


def _moved(now: Readings, before: Readings) -> float:
    """How far any part of the arm is from where it was, inches."""
    a, b = now.posture.points, before.posture.points
    pairs = ((a.elbow, b.elbow), (a.wrist, b.wrist), (a.fingertip, b.fingertip))
    turned = dist(a.across, b.across)
    return max(
        *(dist(one, other) for one, other in pairs),
        _WIDE * turned,
        abs(now.posture.opening - before.posture.opening) / 2,
    )


@lru_cache(16)
def _dots(mark: Mark, camera: Camera, window: Window, shape: SheetShape) -> Marks:
    x, y = _places(camera, window, mark.places)
    return Marks.dots(x, y, mark.glyphs, mark.ink, shape)


@lru_cache(16)
def _labels(labels: tuple[Label, ...], camera: Camera, window: Window, shape: SheetShape) -> Marks:
    x, y = _places(camera, window, np.array([label.place for label in labels]))
    return Marks.written(
        apart(
            (floor(column) - len(label.text) // 2, floor(row), label.text, label.ink)
            for label, column, row in zip(labels, x.tolist(), y.tolist(), strict=True)
        ),
        shape,
    )


def _places(camera: Camera, window: Window, places: Floats) -> tuple[Floats, Floats]:
    """Places of the world in cells, across and down."""
    seen = camera.points(places)
    return (
        (seen[:, 0] - window.left) * window.scale * ASPECT,
        (window.top - seen[:, 1]) * window.scale,
    )


def angles_text(readings: Readings, width: int) -> str:
    """The five angles in degrees, as wordy as there is room for in less than `width` cells."""
    angles = readings.angles
    values = [
        *map(degrees, (angles.base, angles.shoulder, angles.elbow, angles.pitch)),
        readings.pose.roll,
    ]
    for names, digits in (
        (("base ", "shoulder ", "elbow ", "pitch ", "roll "), 1),
        (("B", "S", "E", "P", "R"), 1),
        (("B", "S", "E", "P", "R"), 0),
    ):
        text = " ".join(
            name + signed(value, digits) for name, value in zip(names, values, strict=True)
        )
        if len(text) < width:
            return text
    return ""


def _side_caption(readings: Readings, width: int) -> str:
    """The angles, and what the dots mean while there are any."""
    if not readings.believed or not differs_from_the_side(readings):
        return angles_text(readings, width)
    for legend in _LEGENDS:
        angles = angles_text(readings, width - len(legend))
        if angles:
            return angles + legend
    return angles_text(readings, width)


def _top_caption(readings: Readings, width: int) -> str:
    """The place of the fingertip, and the roll."""
    pose = readings.pose
    place = f"x{signed(pose.x, 1)} y{signed(pose.y, 1)} z{signed(pose.z, 1)}"
    longer = f"{place} roll{signed(pose.roll, 0)}"
    return longer if len(longer) <= width else place if len(place) <= width else ""


FROM_THE_SIDE = Subject(
    lambda readings, _, extras: side_shot(readings, extras), _side_caption, side_scene
)
"""The plane in which the arm stands, seen from the arm's right."""
FROM_ABOVE = Subject(
    lambda readings, _, extras: top_shot(readings, extras), _top_caption, top_scene
)
"""The table; the arm's front is to the right."""
IN_SPACE = Subject(space_shot, _top_caption)
"""Arm and bench in perspective, from wherever one likes to look."""
