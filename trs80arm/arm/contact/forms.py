"""Parts that are more than one convex solid: trays, blocks with a hole, peg boards.

Each is described around its own middle, upright, as a `size` along x, y and z. Inches.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from trs80arm.arm.contact.bodies import Shape
from trs80arm.arm.contact.rotations import Quaternion, apply, matrix
from trs80arm.arm.contact.solids import Solid, box, cylinder
from trs80arm.arm.shapes import Vector, dot, plus


def tray(size: Vector, wall: float) -> tuple[Solid, ...]:
    """A tray: a floor and four walls.

    Args:
        size: outer.
        wall: thickness of floor and walls.
    """
    x, y, z = size
    inner = y - 2 * wall
    floor = box((x, y, wall)).moved((0.0, 0.0, (wall - z) / 2))
    high, up = z - wall, wall / 2
    return (
        floor,
        box((x, wall, high)).moved((0.0, (y - wall) / 2, up)),
        box((x, wall, high)).moved((0.0, (wall - y) / 2, up)),
        box((wall, inner, high)).moved(((x - wall) / 2, 0.0, up)),
        box((wall, inner, high)).moved(((wall - x) / 2, 0.0, up)),
    )


def holed(size: Vector, hole: tuple[float, float]) -> tuple[Solid, ...]:
    """A block with a rectangular hole from top to bottom in its middle.

    Args:
        size: outer.
        hole: along x and y.
    """
    x, y, z = size
    along, across = hole
    side, end = (y - across) / 2, (x - along) / 2
    return (
        box((x, side, z)).moved((0.0, (y - side) / 2, 0.0)),
        box((x, side, z)).moved((0.0, (side - y) / 2, 0.0)),
        box((end, across, z)).moved(((x - end) / 2, 0.0, 0.0)),
        box((end, across, z)).moved(((end - x) / 2, 0.0, 0.0)),
    )


def peg_board(
    size: Vector, pegs: Sequence[tuple[float, float]], radius: float, height: float
) -> tuple[Solid, ...]:
    """A board with round pegs on it.

    Args:
        size: of the board.
        pegs: x and y of each from the board's middle.
        radius: of the pegs.
        height: of the pegs above the board.
    """
    up = (size[2] + height) / 2
    peg = cylinder(radius, height)
    return (box(size), *(peg.moved((x, y, up)) for x, y in pegs))


def flattened(shape: Shape, turn: Quaternion, factor: float) -> Shape:
    """A body's shape pressed together along the world's vertical, its weight kept.

    Args:
        shape: of the body.
        turn: how it lies.
        factor: by which its height becomes less.
    """
    m = matrix(turn)
    up = m[6], m[7], m[8]

    def press(point: Vector) -> Vector:
        return plus(point, up, (factor - 1) * dot(point, up))

    solids = [Solid.of([press(v) for v in solid.vertices], solid.faces) for solid in shape.solids]
    # Its middle stays its middle.
    return replace(Shape.of(solids, shape.mass), offset=press(shape.offset))


def standing(
    shape: Shape, x: float, y: float, bottom: float, turn: Quaternion
) -> tuple[Vector, Quaternion]:
    """Place of the centre of mass for a body whose lowest point is at a height.

    Args:
        shape: of the body.
        x: of the middle of its description.
        y: of the middle of its description.
        bottom: height of its lowest point.
        turn: how it lies.

    Returns:
        Place and turn.
    """
    m = matrix(turn)
    low = min(apply(m, v)[2] for solid in shape.solids for v in solid.vertices)
    ox, oy, _ = apply(m, shape.offset)
    return (x - ox, y - oy, bottom - low), turn
