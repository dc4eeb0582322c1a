"""A sheet of line drawing: lines, arcs, circles and words, as SVG or drawn by matplotlib.

For figures that are no charts: the parts of the arm, its cables, the card. A sheet knows nothing of
what it shows. Its SVG needs no other program, has its words as words, and is dark where its
reader's page is.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import Enum
from html import escape
from typing import Any

Point = tuple[float, float]

_FONT = "system-ui,-apple-system,'Segoe UI','Helvetica Neue',Helvetica,Arial,sans-serif"
_ARROW = 9.0
"""Length of an arrow's head, units."""
_SPREAD = 0.38
"""Half its width, as a share of that."""
_PAST = 6.0
"""How far the lines at a measure's ends go past it, units."""
_ROUND = 48
"""Corners of a circle or of a full turn, where it is drawn as a line."""


class Pen(Enum):
    """What a line or a word is drawn with: what it stands for, not a colour."""

    INK = "ink"
    """What there is."""
    SOFT = "soft"
    """Measures, axes and what is said beside."""
    FIRST = "first"
    SECOND = "second"
    THIRD = "third"
    FOURTH = "fourth"
    FIFTH = "fifth"
    SIXTH = "sixth"
    """What is to be told apart, as cables are."""


class Fill(Enum):
    """What is inside of a closed line."""

    NOTHING = "none"
    PAPER = "paper"
    SHADE = "shade"
    PEN = "pen"
    """The line's own."""


_LIGHT = {
    "paper": "#ffffff",
    "shade": "#eceff3",
    "ink": "#1b2430",
    "soft": "#66707c",
    "first": "#b3261e",
    "second": "#1769aa",
    "third": "#2e7d32",
    "fourth": "#8e24aa",
    "fifth": "#b26a00",
    "sixth": "#00796b",
}
_DARK = {
    "paper": "#14181d",
    "shade": "#252c35",
    "ink": "#e6eaef",
    "soft": "#98a3b0",
    "first": "#ff8a80",
    "second": "#7cc4ff",
    "third": "#8fd694",
    "fourth": "#dda0f0",
    "fifth": "#ffc266",
    "sixth": "#66d6c4",
}


@dataclass(frozen=True, slots=True)
class Line:
    """A line through points, perhaps closed.

    Attributes:
        points: x to the right and y upwards, units.
        pen: it is drawn with.
        width: of the line, units.
        fill: what is inside of it.
        closed: whether it goes back to its beginning.
        dashed: whether it is interrupted.
    """

    points: tuple[Point, ...]
    pen: Pen = Pen.INK
    width: float = 1.5
    fill: Fill = Fill.NOTHING
    closed: bool = False
    dashed: bool = False


@dataclass(frozen=True, slots=True)
class Words:
    """A line of words.

    Attributes:
        place: of the middle of its height; where it begins, is in its middle, or ends.
        text: what it says.
        pen: it is written with.
        size: of its letters, units.
        at: `start`, `middle` or `end`: what of it is at its place.
        bold: whether it is heavy.
    """

    place: Point
    text: str
    pen: Pen = Pen.INK
    size: float = 13.0
    at: str = "start"
    bold: bool = False


@dataclass
class Sheet:
    """Something drawn.

    Attributes:
        width, height: of the sheet, units; the origin is its lower left corner.
        shapes: what is drawn, later ones over earlier ones.
    """

    width: float
    height: float
    shapes: list[Line | Words] = field(default_factory=list)

    # -- drawing ----------------------------------------------------------------------------------

    def line(self, *points: Point, pen: Pen = Pen.INK, width: float = 1.5, **more: Any) -> None:
        """A line through points; `more` as `Line` has it."""
        self.shapes.append(Line(tuple(points), pen, width, **more))

    def arrow(
        self, *points: Point, pen: Pen = Pen.INK, width: float = 1.5, both: bool = False
    ) -> None:
        """A line with a head at its end, or at both ends."""
        self.line(*points, pen=pen, width=width)
        self._head(points[-2], points[-1], pen)
        if both:
            self._head(points[1], points[0], pen)

    def _head(self, tail: Point, tip: Point, pen: Pen) -> None:
        (x, y), way = tip, math.atan2(tip[1] - tail[1], tip[0] - tail[0])
        c, s = math.cos(way), math.sin(way)
        wide = _ARROW * _SPREAD
        sides = [
            (x - _ARROW * c - side * wide * s, y - _ARROW * s + side * wide * c) for side in (1, -1)
        ]
        self.line(sides[0], tip, sides[1], pen=pen, width=0.5, fill=Fill.PEN, closed=True)

    def box(self, x: float, y: float, wide: float, high: float, **more: Any) -> None:
        """A rectangle with its lower left corner somewhere; `more` as `Line` has it."""
        corners = ((x, y), (x + wide, y), (x + wide, y + high), (x, y + high))
        self.line(*corners, closed=True, **more)

    def circle(self, place: Point, radius: float, **more: Any) -> None:
        """A circle; `more` as `Line` has it."""
        self.line(*_arc(place, radius, 0, 360)[:-1], closed=True, **more)

    def arc(
        self,
        place: Point,
        radius: float,
        begin: float,
        end: float,
        *,
        pen: Pen = Pen.INK,
        width: float = 1.5,
        arrow: bool = False,
    ) -> None:
        """Part of a circle, from one angle to another, degrees, counter-clockwise if that grows."""
        points = _arc(place, radius, begin, end)
        if arrow:
            self.arrow(*points, pen=pen, width=width)
        else:
            self.line(*points, pen=pen, width=width)

    def bar(self, start: Point, end: Point, half: float, **more: Any) -> None:
        """A long rectangle around the line from one point to another; `more` as `Line` has it."""
        (x, y), way = start, math.atan2(end[1] - start[1], end[0] - start[0])
        across = -math.sin(way) * half, math.cos(way) * half
        corners = (
            (x + across[0], y + across[1]),
            (end[0] + across[0], end[1] + across[1]),
            (end[0] - across[0], end[1] - across[1]),
            (x - across[0], y - across[1]),
        )
        self.line(*corners, closed=True, **more)

    def measure(self, start: Point, end: Point, text: str, *, off: Point = (0.0, 0.0)) -> None:
        """A measure between two points, its line moved off them.

        Args:
            start: the one.
            end: the other.
            text: what it measures.
            off: how far its line is from them, units.
        """
        moved = [(x + off[0], y + off[1]) for x, y in (start, end)]
        length = math.hypot(*off) or 1.0
        past = off[0] / length * _PAST, off[1] / length * _PAST
        for (x, y), (to_x, to_y) in zip((start, end), moved, strict=True):
            self.line((x, y), (to_x + past[0], to_y + past[1]), pen=Pen.SOFT, width=0.7)
        self.arrow(*moved, pen=Pen.SOFT, width=1.0, both=True)
        middle = (moved[0][0] + moved[1][0]) / 2, (moved[0][1] + moved[1][1]) / 2
        self.label(middle, text)

    def label(self, place: Point, text: str, pen: Pen = Pen.SOFT, size: float = 13.0) -> None:
        """Words in the middle of something, on paper."""
        half = 0.29 * size * len(text) + 3
        x, y = place
        self.shapes.append(
            Line(
                (
                    (x - half, y - size * 0.62),
                    (x + half, y - size * 0.62),
                    (x + half, y + size * 0.62),
                    (x - half, y + size * 0.62),
                ),
                Pen.INK,
                0.0,
                Fill.PAPER,
                closed=True,
            )
        )
        self.words(place, text, pen=pen, size=size, at="middle")

    def words(self, place: Point, text: str, **more: Any) -> None:
        """Words; `more` as `Words` has it. `+-` and ` deg` become the signs that print has."""
        typeset = text.replace("+-", "\N{PLUS-MINUS SIGN}").replace(" deg", "\N{DEGREE SIGN}")
        self.shapes.append(Words(place, typeset, **more))

    def leader(self, place: Point, thing: Point, text: str, *, at: str = "start") -> None:
        """Words with a thin line to what they are about.

        Args:
            place: of the words.
            thing: what they are about.
            text: what they say.
            at: what of them is at their place.
        """
        x, y = place
        beside = {"start": -4.0, "end": 4.0}.get(at, 0.0)
        below = (-10.0 if thing[1] < y else 10.0) if at == "middle" else 0.0
        self.line((x + beside, y + below), thing, pen=Pen.SOFT, width=0.8)
        self.circle(thing, 2.0, pen=Pen.SOFT, width=0.5, fill=Fill.PEN)
        self.words(place, text, at=at)

    # -- files ------------------------------------------------------------------------------------

    def svg(self, title: str) -> str:
        """The sheet as an SVG file, light or dark as its reader's page is."""
        size = f'width="{self.width:g}" height="{self.height:g}"'
        return "\n".join(
            (
                '<?xml version="1.0" encoding="UTF-8"?>',
                f'<svg xmlns="http://www.w3.org/2000/svg" {size} '
                f'viewBox="0 0 {self.width:g} {self.height:g}" role="img" '
                f'font-family="{escape(_FONT)}">',
                f"<title>{escape(title)}</title>",
                f"<style>{_style(_LIGHT)}@media(prefers-color-scheme:dark){{{_style(_DARK)}}}"
                "</style>",
                '<rect class="f-paper" width="100%" height="100%"/>',
                *(self._element(shape) for shape in self.shapes),
                "</svg>\n",
            )
        )

    def _element(self, shape: Line | Words) -> str:
        if isinstance(shape, Words):
            x, y = shape.place
            anchor = "" if shape.at == "start" else f' text-anchor="{shape.at}"'
            bold = ' font-weight="600"' if shape.bold else ""
            return (
                f'<text class="f-{shape.pen.value}" x="{x:.1f}" '
                f'y="{self.height - y + 0.35 * shape.size:.1f}" '
                f'font-size="{shape.size:g}"{anchor}{bold}>{escape(shape.text)}</text>'
            )
        points = " ".join(f"{x:.1f},{self.height - y:.1f}" for x, y in shape.points)
        fill = shape.pen.value if shape.fill is Fill.PEN else shape.fill.value
        dashes = ' stroke-dasharray="5 4"' if shape.dashed else ""
        stroke = f" s-{shape.pen.value}" if shape.width else ""
        kind = "polygon" if shape.closed else "polyline"
        width = f' stroke-width="{shape.width:g}"' if shape.width else ""
        return f'<{kind} class="f-{fill}{stroke}"{width}{dashes} points="{points}"/>'

    def plot(self, axis: Any) -> None:
        """Draw the sheet by matplotlib, on white."""
        axis.set_xlim(0, self.width)
        axis.set_ylim(0, self.height)
        axis.set_aspect("equal")
        axis.axis("off")
        for order, shape in enumerate(self.shapes):
            colour = _LIGHT[shape.pen.value]
            if isinstance(shape, Words):
                axis.text(
                    *shape.place,
                    shape.text,
                    color=colour,
                    fontsize=shape.size * 0.62,
                    va="center_baseline",
                    ha={"start": "left", "middle": "center", "end": "right"}[shape.at],
                    weight="bold" if shape.bold else "normal",
                    zorder=order,
                )
                continue
            xs, ys = ([point[way] for point in shape.points] for way in (0, 1))
            if shape.fill is not Fill.NOTHING:
                inside = colour if shape.fill is Fill.PEN else _LIGHT[shape.fill.value]
                axis.fill(xs, ys, color=inside, linewidth=0, zorder=order)
            if shape.closed:
                xs, ys = [*xs, xs[0]], [*ys, ys[0]]
            style = "--" if shape.dashed else "-"
            axis.plot(xs, ys, style, color=colour, linewidth=shape.width * 0.7, zorder=order)


def _style(colours: dict[str, str]) -> str:
    """A palette as classes: `f-` for what is filled, `s-` for lines."""
    fills = "".join(f".f-{name}{{fill:{colour}}}" for name, colour in colours.items())
    strokes = "".join(f".s-{pen.value}{{stroke:{colours[pen.value]}}}" for pen in Pen)
    return f".f-none{{fill:none}}{fills}{strokes}polyline,polygon{{stroke-linejoin:round}}"


def _arc(place: Point, radius: float, begin: float, end: float) -> Sequence[Point]:
    """Points along a part of a circle, degrees."""
    steps = max(2, math.ceil(abs(end - begin) / 360 * _ROUND))
    angles = (math.radians(begin + (end - begin) * step / steps) for step in range(steps + 1))
    return [
        (place[0] + radius * math.cos(angle), place[1] + radius * math.sin(angle))
        for angle in angles
    ]
