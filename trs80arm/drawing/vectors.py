"""The arm from the side and from above as one SVG, for pages and snapshots.

The scenes of `side_scene.py` and `top_scene.py` in their own lines, an inch to `SCALE` units; below
them the registers beside the joints. Equal readings give equal text.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from html import escape

from trs80arm.drawing.canvas_ascii import Point
from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import Ink
from trs80arm.drawing.scene import Block, Bounds, Facet, Joint, Scene, Shape, Stroke, Trace
from trs80arm.drawing.side_scene import side_scene
from trs80arm.drawing.top_scene import top_scene

SCALE = 20
"""Units an inch."""
EDGE = 18
"""Units of margin round each view."""
LINE = 18
"""Units from one line of text to the next."""
_STRONG = 3
_JOINT = 4
_LETTERS = 13

COLOURS = {
    Ink.ARM: "#1f4e79",
    Ink.HAND: "#1f4e79",
    Ink.PART: "#c0392b",
    Ink.GHOST: "#b58900",
    Ink.TRAIL: "#b58900",
    Ink.FAINT: "#b0b0b0",
}
"""Of what is drawn; all else is grey."""
_OTHER = "#606060"
_HOLLOW = "_"


def svg(readings: Readings) -> str:
    """Both views and the table of registers and joints as an SVG file's text."""
    views = [_view(side_scene(readings)), _view(top_scene(readings))]
    across = float(EDGE)
    drawn: list[str] = []
    for lines, width, _ in views:
        drawn += [f'<g transform="translate({_n(across)} {EDGE})">', *lines, "</g>"]
        across += width + 2 * EDGE
    tall = max(height for _, _, height in views) + 2 * EDGE
    table = list(_table(readings))
    drawn += [
        f'<text x="{EDGE}" y="{_n(tall + LINE * (row + 1))}">{escape(text)}</text>'
        for row, text in enumerate(table)
    ]
    width, height = across - EDGE, tall + LINE * (len(table) + 1)
    return "\n".join(
        [
            '<svg xmlns="http://www.w3.org/2000/svg" xml:space="preserve" '
            f'viewBox="0 0 {_n(width)} {_n(height)}" '
            f'font-family="monospace" font-size="{_LETTERS}" stroke-linecap="round">',
            '<rect width="100%" height="100%" fill="#ffffff"/>',
            *drawn,
            "</svg>\n",
        ]
    )


def _table(readings: Readings) -> Iterator[str]:
    """Registers beside joints, a motor a line, and the pose."""
    yield f"{'':<16}{'register':>9}{'joint':>9}"
    names = readings.model.motor_names
    for name, register, joint in zip(names, readings.registers, readings.joints, strict=False):
        yield f"{name:<16}{register:>9}{joint:>9}"
    pose = readings.pose
    values = [("x", pose.x), ("y", pose.y), ("z", pose.z), ("opening", pose.opening)]
    yield "  ".join(f"{name} {round(value, 2) + 0.0:.2f}" for name, value in values)


def _view(scene: Scene) -> tuple[list[str], float, float]:
    """The shapes of a scene, and how wide and high they are."""
    left, bottom, right, top = scene.bounds
    lines = [line for shape in scene.shapes for line in _drawn(shape, scene.bounds)]
    return lines, (right - left) * SCALE, (top - bottom) * SCALE


def _drawn(shape: Shape, bounds: Bounds) -> Iterator[str]:
    colour = COLOURS.get(shape.ink, _OTHER)
    match shape:
        case Stroke(start, end, _, width, dotted):
            (x0, y0), (x1, y1) = (_place(_within(each, bounds), bounds) for each in (start, end))
            dots = ' stroke-dasharray="2 6"' if dotted else ""
            line = f'<line x1="{_n(x0)}" y1="{_n(y0)}" x2="{_n(x1)}" y2="{_n(y1)}"'
            if width:
                wide = f'stroke-width="{_n(width * SCALE)}" stroke-opacity="0.3"'
                yield f'{line} stroke="{colour}" {wide}/>'
            yield f'{line} stroke="{colour}" stroke-width="{_STRONG}"{dots}/>'
        case Joint(place):
            x, y = _place(place, bounds)
            yield f'<circle cx="{_n(x)}" cy="{_n(y)}" r="{_JOINT}" fill="{colour}"/>'
        case Block((x0, y0), (x1, y1), _, fill):
            yield _outline([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], colour, fill, bounds)
        case Facet(corners, _, fill):
            yield _outline(corners, colour, fill, bounds)
        case Trace(points):
            for point in points:
                x, y = _place(point, bounds)
                yield f'<circle cx="{_n(x)}" cy="{_n(y)}" r="1" fill="{colour}"/>'


def _outline(corners: Iterable[Point], colour: str, fill: str, bounds: Bounds) -> str:
    places = (_place(_within(corner, bounds), bounds) for corner in corners)
    points = " ".join(f"{_n(x)},{_n(y)}" for x, y in places)
    inside = "none" if fill == _HOLLOW else colour
    return (
        f'<polygon points="{points}" fill="{inside}" fill-opacity="0.4" '
        f'stroke="{colour}" stroke-linejoin="round"/>'
    )


def _within(point: Point, bounds: Bounds) -> Point:
    """The nearest point of the view: the table goes on, the drawing does not."""
    left, bottom, right, top = bounds
    return min(max(point[0], left), right), min(max(point[1], bottom), top)


def _place(point: Point, bounds: Bounds) -> Point:
    """Inches to units, downwards."""
    return (point[0] - bounds[0]) * SCALE, (bounds[3] - point[1]) * SCALE


def _n(value: float) -> str:
    """A number of units, to the hundredth, as short as it goes."""
    return f"{round(value, 2) + 0.0:g}"
