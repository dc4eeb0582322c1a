"""The shapes of things in a bench file: box, cylinder or disc, prism, tray, block with hole, pegs.

Each is described around its own middle, upright; how it lies is said by turn, tilt and roll. The
reference of the keys is in `docs/arm.md`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from trs80arm.arm.bench import Bench
from trs80arm.arm.contact.forms import holed, peg_board, tray
from trs80arm.arm.contact.manifold import Placed
from trs80arm.arm.contact.rotations import Quaternion, oriented
from trs80arm.arm.contact.solids import Solid, box, cylinder, prism
from trs80arm.arm.shapes import Vector
from trs80arm.plain_values import Table

FAR = 60.0
"""Farthest that anything may be from the base axis, inches."""
SMALLEST = 0.1
"""Inches that anything is long, wide and high at least."""
LARGEST = 60.0
"""And at most."""
FAR = 60.0
"""Farthest that anything may be from the base axis, inches."""
THINNEST = 0.02
"""Inches that a wall is thick at least."""
MOST_CORNERS, MOST_PEGS = 24, 32

SHAPES = ("box", "cylinder", "disc", "prism", "tray", "holed", "pegs")
KEYS = {
    "box": "size",
    "cylinder": "diameter, height",
    "disc": "diameter, height",
    "prism": "outline, height",
    "tray": "size, wall",
    "holed": "size, hole",
    "pegs": "size, pegs, peg_diameter, peg_height",
}
"""What each shape is described by."""


def read_solids(item: Table, shape: str) -> tuple[Solid, ...]:
    """The solids of a thing of a shape, in the frame of its description.

    Raises:
        SettingsError: one line, if it cannot be.
    """
    if shape in ("cylinder", "disc"):
        diameter = item.number("diameter", SMALLEST, LARGEST)
        return (cylinder(diameter / 2, item.number("height", SMALLEST, LARGEST)),)
    if shape == "prism":
        height = item.number("height", SMALLEST, LARGEST)
        outline = _points(item, "outline", 3, MOST_CORNERS)
        try:
            solid = prism(outline, height)
        except ValueError:
            raise item.fail(
                "outline", "a convex outline, its corners counter-clockwise from above"
            ) from None
        if _narrowest(outline) < SMALLEST:
            raise item.fail("outline", f"an outline at least {SMALLEST:g} in wide, whichever way")
        return (solid,)
    size = read_size(item)
    if shape == "box":
        return (box(size),)
    if shape == "tray":
        most = min(size[0] / 2, size[1] / 2, size[2]) - THINNEST
        return tray(size, item.number("wall", THINNEST, max(THINNEST, most)))
    if shape == "holed":
        along, across = item.vector("hole", 2, THINNEST, LARGEST)
        if along > size[0] - 2 * THINNEST or across > size[1] - 2 * THINNEST:
            raise item.fail("hole", "a hole smaller than the block")
        return holed(size, (along, across))
    diameter = item.number("peg_diameter", SMALLEST, LARGEST)
    height = item.number("peg_height", SMALLEST, LARGEST)
    return peg_board(size, _pegs(item, size, diameter), diameter / 2, height)


def read_shape(item: Table) -> str:
    """The key `shape`: a box unless given."""
    shape = item.data.pop("shape", "box")
    if not isinstance(shape, str) or shape not in SHAPES:
        raise item.fail("shape", f"one of {', '.join(SHAPES)}")
    return shape


def read_size(item: Table) -> Vector:
    """The key `size`: along x, y and z."""
    x, y, z = item.vector("size", 3, SMALLEST, LARGEST)
    return x, y, z


def read_friction(item: Table) -> float | None:
    """The key `friction`; None for that of the table."""
    return item.number("friction", 0.01, 10) if "friction" in item.data else None


def refuse_overlap(bench: Bench, item: Table, key: str, solids: Sequence[Placed]) -> None:
    """Refuse what would stand in something else.

    Raises:
        SettingsError: it does.
    """
    name = bench.found_at(solids)
    if name is not None:
        raise item.fail(key, f"a free place; it overlaps {name}")


def read_turn(item: Table) -> Quaternion:
    """The keys `turn`, `tilt` and `roll`: degrees about z after y after x."""
    return oriented(*(item.number(key, -360, 360, 0.0) for key in ("turn", "tilt", "roll")))


def _pegs(item: Table, size: Vector, diameter: float) -> list[tuple[float, float]]:
    """Places of the pegs on a board, each on it and clear of the others."""
    pegs = _points(item, "pegs", 1, MOST_PEGS)
    for number, (x, y) in enumerate(pegs):
        if abs(x) > (size[0] - diameter) / 2 or abs(y) > (size[1] - diameter) / 2:
            raise item.fail("pegs", "pegs that stand on the board")
        for u, v in pegs[:number]:
            if (x - u) ** 2 + (y - v) ** 2 < diameter * diameter:
                raise item.fail("pegs", "pegs that are not in each other")
    return pegs


def _narrowest(outline: Sequence[tuple[float, float]]) -> float:
    """The least width of a convex outline, inches: it is square to one of the edges."""
    edges = zip(outline, (*outline[1:], outline[0]), strict=True)
    return min(
        max((bx - ax) * (y - ay) - (by - ay) * (x - ax) for x, y in outline)
        / math.dist((ax, ay), (bx, by))
        for (ax, ay), (bx, by) in edges
    )


def _points(item: Table, key: str, least: int, most: int) -> list[tuple[float, float]]:
    """Some points, each as x and y."""
    value = item.data.pop(key, None)
    expected = f"{least} to {most} points [x, y], each from {-LARGEST:g} to {LARGEST:g}"
    if not isinstance(value, list) or not least <= len(value) <= most:
        raise item.fail(key, expected)
    points = []
    for point in value:
        if not isinstance(point, list) or len(point) != 2:
            raise item.fail(key, expected)
        x, y = point
        if any(isinstance(v, bool) or not isinstance(v, int | float) for v in (x, y)):
            raise item.fail(key, expected)
        if not (abs(x) <= LARGEST and abs(y) <= LARGEST):
            raise item.fail(key, expected)
        points.append((float(x), float(y)))
    return points
