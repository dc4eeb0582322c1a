"""What stands on the bench, as robotics formats have it: rigid things made of convex solids.

Inches, ounces.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from dataclasses import dataclass

from trs80arm.arm.bench import Bench
from trs80arm.arm.contact.bodies import NOWHERE
from trs80arm.arm.contact.rotations import STRAIGHT, Matrix, Quaternion, quaternion
from trs80arm.arm.contact.solids import Solid
from trs80arm.arm.shapes import Box, Vector, cross, dot

OWN = 2
"""How many of a bench's obstacles are the arm's own: its base plate and its body."""
_SQUARE = 1e-9


@dataclass(frozen=True)
class Thing:
    """Something on the bench.

    Attributes:
        name: of letters, digits and underlines, no two alike.
        solids: that make it up, in its frame.
        place: of its frame; a part's centre of mass.
        turn: of its frame.
        mass: ounces; 0 for what nothing moves.
        inertia: about the centre of mass in its frame, ounce square inches; None for such things.
        friction: coefficient of its surface.
    """

    name: str
    solids: tuple[Solid, ...]
    place: Vector
    turn: Quaternion
    mass: float
    inertia: Matrix | None
    friction: float


def fixed(bench: Bench, taken: set[str]) -> tuple[list[Thing], list[Thing]]:
    """What nothing moves: the arm's base and body, and the obstacles with the devices.

    Args:
        bench: on which they stand.
        taken: names that are taken; those of these things are added.
    """
    rough = bench.settings.table_friction
    things = [
        Thing(plain(each.name, taken), each.standing, NOWHERE, STRAIGHT, 0.0, None, rough)
        for each in (*bench.obstacles, *bench.cell.obstacles)
    ]
    return things[:OWN], things[OWN:]


def loose(bench: Bench, taken: set[str]) -> list[Thing]:
    """The parts, where they are now.

    Args:
        bench: on which they stand.
        taken: names that are taken; those of the parts are added.
    """
    return [
        Thing(
            plain(part.name, taken),
            part.shape.solids,
            part.place,
            part.turn,
            part.weight,
            part.shape.inertia,
            part.friction,
        )
        for part in bench.parts.values()
    ]


def plain(name: str, taken: set[str]) -> str:
    """A name as every format and program takes it, unlike all others, to which it is added.

    Args:
        name: as people know it.
        taken: names that are taken.
    """
    word = re.sub(r"[^A-Za-z0-9]+", "_", name).strip("_") or "thing"
    found, number = word, 1
    while found in taken:
        number += 1
        found = f"{word}_{number}"
    taken.add(found)
    return found


def as_box(solid: Solid) -> Box | None:
    """The box that a solid is; None if it is another solid."""
    if len(solid.vertices) != 8 or len(solid.edges) != 3:
        return None
    a, b, c = (_forward(edge) for edge in solid.edges)
    if not _upright(a, (b, c)) or not _upright(b, (c,)):
        return None
    if dot(cross(a, b), c) < 0:
        c = (-c[0], -c[1], -c[2])
    spans = [[dot(axis, corner) for corner in solid.vertices] for axis in (a, b, c)]
    x, y, z = ((max(span) - min(span)) / 2 for span in spans)
    return Box(solid.middle, (a, b, c), (x, y, z))


def turn_of(box: Box) -> Quaternion:
    """How a box lies."""
    a, b, c = box.axes
    return quaternion((a[0], b[0], c[0], a[1], b[1], c[1], a[2], b[2], c[2]))


def triangles(solid: Solid) -> list[tuple[Vector, Sequence[Vector]]]:
    """The surface of a solid as triangles, each with the way it faces."""
    found: list[tuple[Vector, Sequence[Vector]]] = []
    for normal, face in zip(solid.normals, solid.faces, strict=True):
        first = solid.vertices[face[0]]
        for i in range(1, len(face) - 1):
            found.append((normal, (first, solid.vertices[face[i]], solid.vertices[face[i + 1]])))
    return found


def _forward(axis: Vector) -> Vector:
    """An axis or its opposite, so that an upright box has the axes of its frame."""
    x, y, z = axis
    return axis if max(axis, key=abs) > 0 else (-x, -y, -z)


def _upright(axis: Vector, others: Collection[Vector]) -> bool:
    return all(abs(dot(axis, other)) < _SQUARE for other in others)
