"""Where two convex solids touch: separating axes, and the corners of the area that they share.

For a pair of solids there is one direction in which they are farthest apart, or least deep in
each other: the normal of a face of one of them, or the common normal of an edge of each. The
points at which they touch are the corners of the face that lies against another, clipped by
it, or the nearest points of the two edges.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from trs80arm.arm.contact.recurrence import question
from trs80arm.arm.contact.rotations import Matrix
from trs80arm.arm.contact.solids import Solid
from trs80arm.arm.shapes import Vector, cross, dot, minus, plus

MOST_POINTS = 8
"""Points of an area of contact of which none is left out."""
_PREFERENCE = 1e-3
"""By how much an edge or the second solid's face must be the better axis, inches."""
_ALONGSIDE = 0.95
"""Cosine of the angle between an edges' normal and a face's from which on two faces all but lie on
each other: then the crossing of edges alone says too little, for what is pushed out there dives in
elsewhere."""
_TILTS = (0.003, 0.03, 0.3)
"""Slopes by which what lies on something may be tilted to lie on other points."""
_PARALLEL = 1e-6
_MANY = 48
"""Products of edges from which on arrays are quicker than a loop."""


class Placed:
    """A solid where it stands in the world; what follows from that is worked out when asked for.

    Attributes:
        solid: the solid itself.
        middle: of a sphere around it.
    """

    __slots__ = (
        "_box",
        "_edges",
        "_levels",
        "_normals",
        "_place",
        "_told",
        "_turn",
        "_vertices",
        "middle",
        "solid",
    )

    def __init__(self, solid: Solid, place: Vector, turn: Matrix) -> None:
        self.solid, self._place, self._turn = solid, place, turn
        a, b, c, d, e, f, g, h, i = turn
        x, y, z = solid.middle
        px, py, pz = place
        self.middle: Vector = (
            a * x + b * y + c * z + px,
            d * x + e * y + f * z + py,
            g * x + h * y + i * z + pz,
        )
        self._vertices: list[Vector] | None = None
        self._normals: list[Vector] | None = None
        self._levels: list[float] | None = None
        self._edges: list[Vector] | None = None
        self._box: tuple[Vector, Vector] | None = None
        self._told: bytes | None = None

    @property
    def told(self) -> bytes:
        """What it is and where: of two with the same everything is the same to the last bit."""
        if self._told is None:
            self._told = question(self.solid.form, self._place, self._turn)
        return self._told

    @property
    def radius(self) -> float:
        """Of the sphere around it."""
        return self.solid.radius

    @property
    def faces(self) -> tuple[tuple[int, ...], ...]:
        """As in `Solid`."""
        return self.solid.faces

    @property
    def vertices(self) -> list[Vector]:
        """As in `Solid`, in the world's frame."""
        if self._vertices is None:
            a, b, c, d, e, f, g, h, i = self._turn
            px, py, pz = self._place
            self._vertices = corners = []
            for x, y, z in self.solid.vertices:
                corner = (
                    a * x + b * y + c * z + px,
                    d * x + e * y + f * z + py,
                    g * x + h * y + i * z + pz,
                )
                corners.append(corner)
        return self._vertices

    @property
    def normals(self) -> list[Vector]:
        """As in `Solid`, in the world's frame."""
        if self._normals is None:
            self._normals = _turned(self._turn, self.solid.normals)
        return self._normals

    @property
    def levels(self) -> list[float]:
        """How far out along its normal each face is, in the world's frame."""
        if self._levels is None:
            corners = self.vertices
            self._levels = []
            for (nx, ny, nz), face in zip(self.normals, self.solid.faces, strict=True):
                x, y, z = corners[face[0]]
                self._levels.append(nx * x + ny * y + nz * z)
        return self._levels

    @property
    def edges(self) -> list[Vector]:
        """As in `Solid`, in the world's frame."""
        if self._edges is None:
            self._edges = _turned(self._turn, self.solid.edges)
        return self._edges

    @property
    def low(self) -> Vector:
        """Least x, y, z."""
        return self._around()[0]

    @property
    def high(self) -> Vector:
        """Greatest x, y, z."""
        return self._around()[1]

    def _around(self) -> tuple[Vector, Vector]:
        """The upright box around it."""
        if self._box is None:
            # By comparing alone, in a third of the time of asking for least and greatest of each.
            first, *others = self.vertices
            a, b, c = d, e, f = first
            for x, y, z in others:
                if x < a:
                    a = x
                elif x > d:
                    d = x
                if y < b:
                    b = y
                elif y > e:
                    e = y
                if z < c:
                    c = z
                elif z > f:
                    f = z
            self._box = (a, b, c), (d, e, f)
        return self._box

    def near(self, other: Placed, margin: float) -> bool:
        """Whether spheres and upright boxes around two solids are within a margin of each other."""
        (x, y, z), (u, v, w) = self.middle, other.middle
        x, y, z = x - u, y - v, z - w
        reach = self.solid.radius + other.solid.radius + margin
        if x * x + y * y + z * z > reach * reach:
            return False
        (a, b), (c, d) = self._around(), other._around()
        return (
            a[2] - margin <= d[2]
            and c[2] - margin <= b[2]
            and a[0] - margin <= d[0]
            and c[0] - margin <= b[0]
            and a[1] - margin <= d[1]
            and c[1] - margin <= b[1]
        )


def _turned(turn: Matrix, ways: Sequence[Vector]) -> list[Vector]:
    a, b, c, d, e, f, g, h, i = turn
    return [
        (a * x + b * y + c * z, d * x + e * y + f * z, g * x + h * y + i * z) for x, y, z in ways
    ]


class Manifold(NamedTuple):
    """How two solids touch.

    Attributes:
        normal: unit vector from the first into the second.
        points: where, with the gap there in inches, negative where they overlap.
        apart: inches by which the whole of the second is beyond the whole of the first along the
            normal: as long as they are, they cannot touch, wherever they slide.
    """

    normal: Vector
    points: list[tuple[Vector, float]]
    apart: float


def on_table(solid: Placed, margin: float) -> Manifold | None:
    """How a solid touches the table, all that is below height 0."""
    if solid.middle[2] > solid.solid.radius + margin or solid.low[2] > margin:
        return None
    points = [((x, y, z / 2), z) for x, y, z in solid.vertices if z <= margin]
    return Manifold((0.0, 0.0, 1.0), _fewer(points, (0.0, 0.0, 1.0)), solid.low[2])


def between(a: Placed, b: Placed, margin: float) -> Manifold | None:
    """How two solids touch, or None if they are farther apart than a margin (inches)."""
    of_a, face_a = _best_face(a, b, margin)
    if of_a > margin:
        return None
    of_b, face_b = _best_face(b, a, margin)
    if of_b > margin:
        return None
    second = of_b > of_a + _PREFERENCE
    x, y, z = b.normals[face_b] if second else a.normals[face_a]
    outwards = (-x, -y, -z) if second else (x, y, z)
    points = _against(b, face_b, a, margin) if second else _against(a, face_a, b, margin)
    least = max(of_a, of_b) + _PREFERENCE
    # No axis keeps them farther apart than a point of one from one of the other, nor apart at all
    # if they have a point in common.
    if not points or max(min(gap for _, gap in points), 0.0) > least:
        found = _best_edges(a, b, margin, least)
        if found is not None:
            apart, normal, one, other = found
            if apart > margin:
                return None
            along = dot(normal, outwards)
            lying = _fewer(points, outwards) if along > _ALONGSIDE else []
            touching = [(_crossing(a, b, normal, one, other), apart)]
            touching += [(point, gap / along) for point, gap in lying]
            return Manifold(normal, touching, apart)
        if not points:
            return None
    return Manifold(outwards, _fewer(points, outwards), of_b if second else of_a)


def _best_face(a: Placed, b: Placed, margin: float) -> tuple[float, int]:
    """Which face of one solid another is farthest beyond, and how far.

    Of what cannot be the best nothing but the distance of the other's middle is found out.
    """
    x, y, z = b.middle
    normals, levels, corners = a.normals, a.levels, b.vertices
    beyond = [
        nx * x + ny * y + nz * z - level
        for (nx, ny, nz), level in zip(normals, levels, strict=True)
    ]
    index = beyond.index(max(beyond))
    best = _beyond(normals[index], levels[index], corners)
    if best <= margin:
        for i, most in enumerate(beyond):
            if most > best and i != index:
                apart = _beyond(normals[i], levels[i], corners)
                if apart > best:
                    best, index = apart, i
                    if apart > margin:
                        break
    return best, index


def _beyond(normal: Vector, level: float, corners: Sequence[Vector]) -> float:
    """How far a solid's corners are beyond a face of another."""
    nx, ny, nz = normal
    return min([nx * x + ny * y + nz * z for x, y, z in corners]) - level


Edges = tuple[float, Vector, Vector, Vector]


def _best_edges(a: Placed, b: Placed, margin: float, least: float) -> Edges | None:
    """The edges whose common normal keeps two solids farther apart than `least`, if any do.

    Returns:
        Distance, normal from the first to the second, and the directions of both edges.
    """
    if len(a.edges) * len(b.edges) > _MANY:
        return _best_of_many_edges(a, b, least)
    found: Edges | None = None
    mx, my, mz = middle = minus(_center(b), _center(a))
    # No axis keeps two solids farther apart than a point of one and a point of the other.
    ux, uy, uz = minus(min(b.vertices, key=_along(middle)), max(a.vertices, key=_along(middle)))
    for one in a.edges:
        px, py, pz = one
        for qx, qy, qz in b.edges:
            nx, ny, nz = py * qz - pz * qy, pz * qx - px * qz, px * qy - py * qx
            square = nx * nx + ny * ny + nz * nz
            if square < _PARALLEL:
                continue
            scale = 1 / math.sqrt(square)
            if nx * mx + ny * my + nz * mz < 0:
                scale = -scale
            nx, ny, nz = nx * scale, ny * scale, nz * scale
            if nx * ux + ny * uy + nz * uz <= least:
                continue
            apart = min([nx * x + ny * y + nz * z for x, y, z in b.vertices]) - max(
                [nx * x + ny * y + nz * z for x, y, z in a.vertices]
            )
            if apart > least:
                least, found = apart, (apart, (nx, ny, nz), one, (qx, qy, qz))
                if apart > margin:
                    return found
    return found


def _best_of_many_edges(a: Placed, b: Placed, least: float) -> Edges | None:
    """`_best_edges` with arrays, element by element."""
    ax, ay, az = np.array(a.edges).T[:, :, None]
    bx, by, bz = np.array(b.edges).T[:, None, :]
    nx, ny, nz = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
    square = nx * nx + ny * ny + nz * nz
    good = square >= _PARALLEL
    if not good.any():
        return None
    which = np.argwhere(good)
    scale = 1 / np.sqrt(square[good])
    mx, my, mz = minus(_center(b), _center(a))
    nx, ny, nz = nx[good], ny[good], nz[good]
    scale = np.where(nx * mx + ny * my + nz * mz < 0, -scale, scale)
    nx, ny, nz = nx * scale, ny * scale, nz * scale
    x, y, z = np.array(b.vertices).T[:, None, :]
    low = (nx[:, None] * x + ny[:, None] * y + nz[:, None] * z).min(axis=1)
    x, y, z = np.array(a.vertices).T[:, None, :]
    high = (nx[:, None] * x + ny[:, None] * y + nz[:, None] * z).max(axis=1)
    apart = low - high
    best = int(np.argmax(apart))
    if apart[best] <= least:
        return None
    normal = (float(nx[best]), float(ny[best]), float(nz[best]))
    return float(apart[best]), normal, a.edges[which[best][0]], b.edges[which[best][1]]


def _along(way: Vector) -> Callable[[Vector], float]:
    """How far a point is out along a way."""
    x, y, z = way
    return lambda point: x * point[0] + y * point[1] + z * point[2]


def _center(solid: Placed) -> Vector:
    """Middle of the box around a solid."""
    a, b = solid.low, solid.high
    return (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2


def _crossing(a: Placed, b: Placed, normal: Vector, one: Vector, other: Vector) -> Vector:
    """Midway between two edges that face each other."""
    p, along = _edge(a, normal, one)
    q, across = _edge(b, (-normal[0], -normal[1], -normal[2]), other)
    between_them = minus(p, q)
    aa, bb, ab = dot(along, along), dot(across, across), dot(along, across)
    ad, bd = dot(along, between_them), dot(across, between_them)
    whole = aa * bb - ab * ab
    s = (ab * bd - bb * ad) / whole if whole > _PARALLEL * aa * bb else 0.5
    s = min(1.0, max(0.0, s))
    t = min(1.0, max(0.0, (ab * s + bd) / bb))
    here, there = plus(p, along, s), plus(q, across, t)
    return (here[0] + there[0]) / 2, (here[1] + there[1]) / 2, (here[2] + there[2]) / 2


def _edge(solid: Placed, way: Vector, direction: Vector) -> tuple[Vector, Vector]:
    """The edge farthest out along `way` of those that run along `direction`: start and course."""
    corners = solid.vertices
    best, found = -math.inf, (corners[0], direction)
    a, b, c = direction
    for face in solid.faces:
        start = corners[face[0]]
        for i in (*face[1:], face[0]):
            end = corners[i]
            (x, y, z), (u, v, w) = start, end
            u, v, w = u - x, v - y, w - z
            along = u * a + v * b + w * c
            if along > 0 and along * along >= (1 - _PARALLEL) * (u * u + v * v + w * w):
                out = dot(start, way)
                if out > best:
                    best, found = out, (start, (u, v, w))
            start = end
    return found


def _against(a: Placed, face: int, b: Placed, margin: float) -> list[tuple[Vector, float]]:
    """What of a solid lies against the face of another: points midway between, with their gaps."""
    nx, ny, nz = a.normals[face]
    along = [nx * x + ny * y + nz * z for x, y, z in b.normals]
    vertices = b.vertices
    area = [vertices[i] for i in b.faces[along.index(min(along))]]
    corners = a.vertices
    edge = a.faces[face]
    x, y, z = corners[edge[-1]]
    for i in edge:
        start = x, y, z
        u, v, w = corners[i]
        x, y, z = u - x, v - y, w - z
        area = _clipped(area, start, (y * nz - z * ny, z * nx - x * nz, x * ny - y * nx))
        if not area:
            return []
        x, y, z = u, v, w
    level = a.levels[face]
    points = []
    for x, y, z in area:
        gap = nx * x + ny * y + nz * z - level
        if gap <= margin:
            half = gap / 2
            points.append(((x - half * nx, y - half * ny, z - half * nz), gap))
    return points


def _clipped(area: list[Vector], start: Vector, outwards: Vector) -> list[Vector]:
    """What of a polygon is not beyond a plane."""
    nx, ny, nz = outwards
    x, y, z = start
    level = nx * x + ny * y + nz * z
    out = [nx * x + ny * y + nz * z - level for x, y, z in area]
    if max(out) <= 0:
        return area
    kept: list[Vector] = []
    before, at = out[-1], area[-1]
    for here, point in zip(out, area, strict=True):
        if (here > 0) != (before > 0):
            kept.append(plus(at, minus(point, at), before / (before - here)))
        if here <= 0:
            kept.append(point)
        before, at = here, point
    return kept


def _fewer(points: list[tuple[Vector, float]], normal: Vector) -> list[tuple[Vector, float]]:
    """Points of contact on which two solids could rest on each other, tilted a little any way.

    Of a round face those farthest out; of a cylinder on its side those of both ends.
    """
    if len(points) <= MOST_POINTS:
        return points
    u, v = tangents(normal)
    ways = [(u[0] * c + v[0] * s, u[1] * c + v[1] * s, u[2] * c + v[2] * s) for c, s in _COMPASS]
    out = [[x * a + y * b + z * c for (x, y, z), _ in points] for a, b, c in ways]
    kept: list[int] = []
    for tilt in _TILTS:
        for along in out:
            best, found = -math.inf, 0
            for k, (_, gap) in enumerate(points):
                value = tilt * along[k] - gap
                if value > best:
                    best, found = value, k
            if found not in kept:
                kept.append(found)
    return [points[k] for k in sorted(kept)]


_HALF = math.sqrt(0.5)
_COMPASS = (
    (1.0, 0.0),
    (_HALF, _HALF),
    (0.0, 1.0),
    (-_HALF, _HALF),
    (-1.0, 0.0),
    (-_HALF, -_HALF),
    (0.0, -1.0),
    (_HALF, -_HALF),
)


def tangents(normal: Vector) -> tuple[Vector, Vector]:
    """Two unit vectors square to a normal and to each other."""
    x, y, z = normal
    if abs(z) > 0.7:
        scale = 1 / math.sqrt(y * y + z * z)
        u = (0.0, z * scale, -y * scale)
    else:
        scale = 1 / math.sqrt(x * x + y * y)
        u = (-y * scale, x * scale, 0.0)
    return u, cross(normal, u)
