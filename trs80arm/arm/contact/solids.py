"""Convex solids and what follows from their shape: faces, edges, volume, moments.

A part is one of these or several that never move against each other (a tray with walls, a block
with a hole, a peg board). Everything is a polyhedron: a cylinder or disc is a prism of
`CYLINDER_SIDES` sides, half of a quarter of a percent off the circle at most. Inches.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

from trs80arm.arm.contact.recurrence import question
from trs80arm.arm.contact.rotations import Matrix, Quaternion, apply, matrix
from trs80arm.arm.shapes import Vector, cross, dot, minus, plus

CYLINDER_SIDES = 24
KNOWN = 256
"""Solids of each kind that are known at once."""
_SAME = 1e-9


@dataclass(frozen=True, slots=True)
class Solid:
    """A convex polyhedron.

    Attributes:
        vertices: its corners, in the frame of the body that it belongs to.
        faces: indices of corners, counter-clockwise as seen from outside.
        normals: unit vectors, one for each face, outwards.
        edges: unit vectors along its edges, one for each set of parallels.
        middle: of its corners, inside it; of a sphere around it.
        radius: of that sphere, inches.
    """

    vertices: tuple[Vector, ...]
    faces: tuple[tuple[int, ...], ...]
    normals: tuple[Vector, ...]
    edges: tuple[Vector, ...]
    middle: Vector
    radius: float

    @property
    def form(self) -> bytes:
        """All that it is: of two with the same everything is the same to the last bit."""
        numbers = self.vertices, self.faces, self.normals, self.edges
        return question(*numbers, self.middle, self.radius)

    @classmethod
    def of(cls, vertices: Sequence[Vector], faces: Sequence[Sequence[int]]) -> Solid:
        """A polyhedron from its corners and faces.

        Args:
            vertices: inches.
            faces: indices, counter-clockwise as seen from outside.
        """
        normals: list[Vector] = []
        edges: list[Vector] = []
        for face in faces:
            a, b, c = (vertices[i] for i in face[:3])
            normals.append(_unit(cross(minus(b, a), minus(c, b))))
            for i, k in zip(face, (*face[1:], face[0]), strict=True):
                way = _unit(minus(vertices[k], vertices[i]))
                if all(abs(dot(way, other)) < 1 - _SAME for other in edges):
                    edges.append(way)
        middle = (0.0, 0.0, 0.0)
        for vertex in vertices:
            middle = plus(middle, vertex, 1 / len(vertices))
        return cls(
            tuple(vertices),
            tuple(tuple(face) for face in faces),
            tuple(normals),
            tuple(edges),
            middle,
            math.sqrt(max(dot(way, way) for way in (minus(v, middle) for v in vertices))),
        )

    def moved(self, by: Vector, turn: Quaternion = (1.0, 0.0, 0.0, 0.0)) -> Solid:
        """The same solid, turned and then shifted in its body's frame."""
        m = matrix(turn)
        return Solid(
            tuple(plus(apply(m, v), by) for v in self.vertices),
            self.faces,
            tuple(apply(m, n) for n in self.normals),
            tuple(apply(m, e) for e in self.edges),
            plus(apply(m, self.middle), by),
            self.radius,
        )


def box(size: Vector) -> Solid:
    """A box around the origin.

    Args:
        size: along x, y and z, inches.
    """
    x, y, z = size
    return _box(x, y, z)


@lru_cache(KNOWN)
def _box(wide: float, deep: float, high: float) -> Solid:
    """`box`: benches of many machines have the same ones."""
    x, y, z = wide / 2, deep / 2, high / 2
    return prism(((-x, -y), (x, -y), (x, y), (-x, y)), 2 * z)


def prism(outline: Sequence[tuple[float, float]], height: float) -> Solid:
    """An upright prism, its middle height at 0.

    Args:
        outline: of its base, convex, counter-clockwise from above, inches.
        height: inches.

    Raises:
        ValueError: the outline is not convex or not counter-clockwise.
    """
    count = len(outline)
    for i, (ax, ay) in enumerate(outline):
        bx, by = outline[(i + 1) % count]
        # All others lie to the left of every edge: an outline that crosses itself turns left too.
        others = (outline[(i + k) % count] for k in range(2, count))
        if count < 3 or any(
            (bx - ax) * (y - ay) - (by - ay) * (x - ax) <= _SAME for x, y in others
        ):
            raise ValueError("an outline is convex, its corners counter-clockwise from above")
    z = height / 2
    vertices = [(x, y, -z) for x, y in outline] + [(x, y, z) for x, y in outline]
    sides = [(i, (i + 1) % count, (i + 1) % count + count, i + count) for i in range(count)]
    bottom = tuple(range(count - 1, -1, -1))
    return Solid.of(vertices, [bottom, tuple(range(count, 2 * count)), *sides])


@lru_cache(KNOWN)
def cylinder(radius: float, height: float) -> Solid:
    """An upright cylinder or disc: a prism of as much cross-section as the circle has.

    Args:
        radius: inches.
        height: inches.
    """
    reach = radius * _ROUND
    return prism([(reach * x, reach * y) for x, y in _CIRCLE], height)


def _circle(count: int) -> list[tuple[float, float]]:
    """Corners of a regular polygon in the unit circle, by halving angles; symmetrical.

    The count is 3 times a power of two.
    """
    points = [(1.0, 0.0), (-0.5, math.sqrt(3) / 2), (-0.5, -math.sqrt(3) / 2)]
    while len(points) < count:
        doubled = []
        for i, (x, y) in enumerate(points):
            u, v = points[(i + 1) % len(points)]
            mx, my = x + u, y + v
            length = math.sqrt(mx * mx + my * my)
            doubled += [(x, y), (mx / length, my / length)]
        points = doubled
    return points


_CIRCLE = _circle(CYLINDER_SIDES)


def _area(points: Sequence[tuple[float, float]]) -> float:
    total = 0.0
    for i, (x, y) in enumerate(points):
        u, v = points[(i + 1) % len(points)]
        total += x * v - y * u
    return total / 2


_ROUND = math.sqrt(math.pi / _area(_CIRCLE))
"""Radius of the corners of a polygon that has the circle's area."""


@dataclass(frozen=True, slots=True)
class Moments:
    """Volume and its distribution at unit density.

    Attributes:
        volume: cubic inches.
        middle: centre of mass.
        inertia: about the centre of mass.
    """

    volume: float
    middle: Vector
    inertia: Matrix


def moments(solids: Sequence[Solid]) -> Moments:
    """Volume, centre of mass and moments of inertia of some solids that do not overlap."""
    volume = 0.0
    first = [0.0, 0.0, 0.0]
    second = [[0.0] * 3 for _ in range(3)]
    for solid in solids:
        for face in solid.faces:
            a = solid.vertices[face[0]]
            for i in range(1, len(face) - 1):
                b, c = solid.vertices[face[i]], solid.vertices[face[i + 1]]
                det = dot(a, cross(b, c))
                total = plus(plus(a, b), c)
                volume += det / 6
                for j in range(3):
                    first[j] += det / 24 * total[j]
                    for k in range(3):
                        corners = a[j] * a[k] + b[j] * b[k] + c[j] * c[k]
                        second[j][k] += det / 120 * (total[j] * total[k] + corners)
    middle = (first[0] / volume, first[1] / volume, first[2] / volume)
    cov = [[second[j][k] - volume * middle[j] * middle[k] for k in range(3)] for j in range(3)]
    trace = cov[0][0] + cov[1][1] + cov[2][2]
    inertia = [[(trace if j == k else 0.0) - cov[j][k] for k in range(3)] for j in range(3)]
    (a0, a1, a2), (a3, a4, a5), (a6, a7, a8) = inertia
    return Moments(volume, middle, (a0, a1, a2, a3, a4, a5, a6, a7, a8))


def _unit(v: Vector) -> Vector:
    length = math.sqrt(dot(v, v))
    return v[0] / length, v[1] / length, v[2] / length
