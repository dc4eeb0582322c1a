"""Convex solids as arrays: what is drawn, before anyone looks at it.

A solid is corners and the planes of its faces. Many are kept in one `Solids`, as arrays over all of
their corners and planes, so that a frame's work is a few operations on arrays. What stays when they
move, their `Shape`, is put together once. Inches.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from itertools import repeat
from math import cos, pi, sin
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Floats: TypeAlias = npt.NDArray[np.float64]
Ints: TypeAlias = npt.NDArray[np.int64]
Place: TypeAlias = tuple[float, float, float]


@dataclass(frozen=True, eq=False)
class Shape:
    """What of some convex solids does not depend on where they are.

    Attributes:
        corners: how many there are.
        first_corner: where each solid's corners begin.
        first_face: where each solid's faces begin.
        materials: index of each solid's material.
        bodies: a number for each solid; solids of one number are seen as one thing.
        edges: the corners from which and to which each edge of each face leads, 2 x k;
            counter-clockwise round each face as seen from outside, face by face.
        edge_faces: the face that each edge belongs to, k.
        faces: how many there are.
    """

    corners: int
    first_corner: Ints
    faces: int
    first_face: Ints
    materials: Ints
    bodies: Ints
    edges: Ints
    edge_faces: Ints

    @cached_property
    def face_counts(self) -> Ints:
        """How many faces each solid has."""
        return np.diff(self.first_face, append=self.faces)

    @cached_property
    def face_materials(self) -> Ints:
        """Index of each face's material."""
        return np.repeat(self.materials, self.face_counts)

    @cached_property
    def face_bodies(self) -> Ints:
        """The number of the thing that each face is part of."""
        return np.repeat(self.bodies, self.face_counts)

    def faces_of(self, *materials: int) -> npt.NDArray[np.bool_]:
        """Which faces are of one of these materials."""
        return _faces_of(self, materials)


@lru_cache(256)
def _faces_of(shape: Shape, materials: tuple[int, ...]) -> npt.NDArray[np.bool_]:
    return np.isin(shape.face_materials, materials)


@lru_cache(256)
def _thick(shape: Shape, bodies: tuple[int, ...]) -> tuple[Ints, Ints, npt.NDArray[np.bool_]]:
    """The corners of some bodies, made of boxes; the three faces that meet in each; their faces."""
    faces = np.isin(shape.face_bodies, bodies)
    edge = faces[shape.edge_faces].nonzero()[0]
    edge = edge[np.argsort(shape.edges[0, edge], kind="stable")]
    return shape.edges[0, edge[::3]], shape.edge_faces[edge].reshape(-1, 3).T, faces


@lru_cache(512)
def _shape(count: int, faces: tuple[tuple[int, ...], ...], material: int, body: int) -> Shape:
    """That of one solid of so many corners, with these faces."""
    first = np.zeros(1, dtype=np.int64)
    edges = [(a, b) for face in faces for a, b in zip(face, (*face[1:], face[0]), strict=True)]
    return Shape(
        count,
        first,
        len(faces),
        first,
        np.array([material]),
        np.array([body]),
        np.array(edges, dtype=np.int64).T.copy(),
        np.repeat(np.arange(len(faces)), [len(face) for face in faces]),
    )


@lru_cache(256)
def _joined(shapes: tuple[Shape, ...]) -> Shape:
    """That of all solids of some shapes, in their order."""
    corners = np.cumsum([0, *(shape.corners for shape in shapes)]).tolist()
    faces = np.cumsum([0, *(shape.faces for shape in shapes)]).tolist()

    def all_of(values: Iterable[Ints], begins: Iterable[int] = repeat(0)) -> Ints:
        parts = [part + at for part, at in zip(values, begins, strict=False)]
        return np.concatenate(parts, axis=-1) if parts else np.zeros(0, dtype=np.int64)

    return Shape(
        corners[-1],
        all_of((shape.first_corner for shape in shapes), corners),
        faces[-1],
        all_of((shape.first_face for shape in shapes), faces),
        all_of(shape.materials for shape in shapes),
        all_of(shape.bodies for shape in shapes),
        all_of((shape.edges for shape in shapes), corners).reshape(2, -1),
        all_of((shape.edge_faces for shape in shapes), faces),
    )


@dataclass(frozen=True, slots=True, eq=False)
class Solids:
    """Some convex solids.

    Attributes:
        shape: what of them does not depend on where they are.
        corners: of all solids, one after the other, n x 3.
        normals: of all faces, outwards, unit vectors, m x 3.
        offsets: of the faces: their normal times any point of them, m.
    """

    shape: Shape
    corners: Floats
    normals: Floats
    offsets: Floats

    @classmethod
    def of(
        cls,
        corners: Sequence[Sequence[float]],
        faces: Sequence[Sequence[int]],
        material: int = 0,
        body: int = 0,
    ) -> Solids:
        """One solid.

        Args:
            corners: inches.
            faces: indices of corners, counter-clockwise as seen from outside.
            material: its index.
            body: the thing that it is part of.
        """
        points = np.asarray(corners, dtype=np.float64)
        a, b, c = (points[[face[place] for face in faces]] for place in range(3))
        normals = np.cross(b - a, c - b)
        normals /= np.sqrt((normals * normals).sum(1))[:, None]
        shape = _shape(len(points), tuple(map(tuple, faces)), int(material), body)
        return cls(shape, points, normals, (normals * a).sum(1))

    @classmethod
    def joined(cls, groups: Iterable[Solids]) -> Solids:
        """All solids of some groups, in their order."""
        all_of = [group for group in groups if group.shape.faces]
        if len(all_of) == 1:
            return all_of[0]
        shape = _joined(tuple(group.shape for group in all_of))
        if not all_of:
            return cls(shape, np.zeros((0, 3)), np.zeros((0, 3)), np.zeros(0))
        return cls(
            shape,
            np.concatenate([group.corners for group in all_of]),
            np.concatenate([group.normals for group in all_of]),
            np.concatenate([group.offsets for group in all_of]),
        )

    def placed(self, origin: npt.ArrayLike, axes: npt.ArrayLike) -> Solids:
        """The same in a frame.

        Args:
            origin: where the frame's origin is.
            axes: its three unit vectors.
        """
        turn, place = np.asarray(axes, dtype=np.float64), np.asarray(origin, dtype=np.float64)
        normals = self.normals @ turn
        return Solids(
            self.shape, self.corners @ turn + place, normals, self.offsets + normals @ place
        )

    def some(self, chosen: Iterable[int]) -> Solids:
        """Only those solids, by their places."""
        shape = self.shape
        corner = [*shape.first_corner.tolist(), shape.corners]
        face = [*shape.first_face.tolist(), shape.faces]
        edge = np.searchsorted(shape.edge_faces, face).tolist()
        first = np.zeros(1, dtype=np.int64)
        return Solids.joined(
            Solids(
                Shape(
                    corner[place + 1] - corner[place],
                    first,
                    face[place + 1] - face[place],
                    first,
                    shape.materials[place : place + 1],
                    shape.bodies[place : place + 1],
                    shape.edges[:, edge[place] : edge[place + 1]] - corner[place],
                    shape.edge_faces[edge[place] : edge[place + 1]] - face[place],
                ),
                self.corners[corner[place] : corner[place + 1]],
                self.normals[face[place] : face[place + 1]],
                self.offsets[face[place] : face[place + 1]],
            )
            for place in chosen
        )

    def thickened(self, bodies: Iterable[int], by: float) -> Solids:
        """The same with some bodies, made of boxes, so many inches larger on all sides."""
        shape = self.shape
        corner, meeting, faces = _thick(shape, tuple(bodies))
        corners = self.corners.copy()
        corners[corner] += by * self.normals[meeting].sum(0)
        return Solids(shape, corners, self.normals, self.offsets + by * faces)

    def made_of(self, material: int) -> Solids:
        """The same of another material."""
        materials = np.full_like(self.shape.materials, material)
        return replace(self, shape=replace(self.shape, materials=materials))


NOTHING = Solids.joined(())
"""No solid at all."""


class Articulated:
    """Solids in some groups, each of which moves in a frame of its own.

    Args:
        groups: them, each in its frame.
    """

    def __init__(self, groups: Sequence[Solids]) -> None:
        self._solids = Solids.joined(groups)
        numbers = np.arange(len(groups))
        self._of_corner = np.repeat(numbers, [len(group.corners) for group in groups])
        self._of_face = np.repeat(numbers, [len(group.offsets) for group in groups])

    def placed_each(self, origins: npt.ArrayLike, axes: npt.ArrayLike) -> Solids:
        """All of them where their groups' frames are.

        Args:
            origins: of the frames.
            axes: the three unit vectors of each.
        """
        solids, places = self._solids, np.asarray(origins, dtype=np.float64)
        turns = np.asarray(axes, dtype=np.float64)
        normals = _turned(solids.normals, turns[self._of_face])
        return Solids(
            solids.shape,
            _turned(solids.corners, turns[self._of_corner]) + places[self._of_corner],
            normals,
            solids.offsets + (normals * places[self._of_face]).sum(1),
        )


def _turned(vectors: Floats, axes: Floats) -> Floats:
    """Vectors, each in axes of its own."""
    turned: Floats = np.matmul(vectors[:, None, :], axes)[:, 0]
    return turned


def prism(
    outline: Sequence[tuple[float, float]],
    low: float,
    high: float,
    material: int = 0,
    body: int = 0,
    *,
    along: int = 2,
    bevel: tuple[float, float] = (0.0, 0.0),
) -> Solids:
    """A prism.

    Args:
        outline: its section, convex, counter-clockwise as seen from the high end, in the two axes
            after the one along which it lies (x: y and z; y: z and x; z: x and y).
        low: where it begins on that axis.
        high: where it ends.
        material: its index.
        body: the thing that it is part of.
        along: the axis: 0 x, 1 y, 2 z.
        bevel: by how much the edges of the low and of the high end are cut off.
    """
    count = len(outline)
    lower, upper = bevel
    rings = [(low, lower), *([(low + lower, 0.0)] if lower else [])]
    rings += [*([(high - upper, 0.0)] if upper else []), (high, upper)]
    middle = (sum(x for x, _ in outline) / count, sum(y for _, y in outline) / count)
    corners = []
    for place, inset in rings:
        for x, y in _shrunk(outline, middle, inset):
            point = [0.0, 0.0, 0.0]
            point[along], point[(along + 1) % 3], point[(along + 2) % 3] = place, x, y
            corners.append(point)
    last = (len(rings) - 1) * count
    faces = [tuple(range(count - 1, -1, -1)), tuple(range(last, last + count))]
    for ring in range(len(rings) - 1):
        at = ring * count
        faces += [
            (at + i, at + (i + 1) % count, at + count + (i + 1) % count, at + count + i)
            for i in range(count)
        ]
    return Solids.of(corners, faces, material, body)


def _shrunk(
    outline: Sequence[tuple[float, float]], middle: tuple[float, float], inset: float
) -> list[tuple[float, float]]:
    """An outline drawn in towards its middle, along each axis by so much at its widest."""
    if not inset:
        return list(outline)
    wide = max(abs(x - middle[0]) for x, _ in outline)
    high = max(abs(y - middle[1]) for _, y in outline)
    a, b = max(0.1, 1 - inset / wide), max(0.1, 1 - inset / high)
    return [(middle[0] + a * (x - middle[0]), middle[1] + b * (y - middle[1])) for x, y in outline]


def box(low: Sequence[float], high: Sequence[float], material: int = 0, body: int = 0) -> Solids:
    """An upright box between two opposite corners."""
    (a, b, c), (x, y, z) = low, high
    return prism(((a, b), (x, b), (x, y), (a, y)), c, z, material, body)


def cylinder(
    middle: tuple[float, float],
    radius: float,
    low: float,
    high: float,
    material: int = 0,
    body: int = 0,
    *,
    along: int = 2,
    sides: int = 12,
) -> Solids:
    """A cylinder along an axis; `middle` is in the two axes after it, as in `prism`."""
    x, y = middle
    outline = [
        (x + radius * cos(angle), y + radius * sin(angle))
        for angle in (2 * pi * (side + 0.5) / sides for side in range(sides))
    ]
    return prism(outline, low, high, material, body, along=along)


def rounded(
    low: tuple[float, float], high: tuple[float, float], radius: float
) -> list[tuple[float, float]]:
    """The outline of a rectangle with its corners cut off, counter-clockwise."""
    (left, bottom), (right, top) = low, high
    radius = min(radius, (right - left) / 2, (top - bottom) / 2)
    centres = (
        (right - radius, top - radius),
        (left + radius, top - radius),
        (left + radius, bottom + radius),
        (right - radius, bottom + radius),
    )
    return [
        (x + radius * cos(angle), y + radius * sin(angle))
        for quarter, (x, y) in enumerate(centres)
        for angle in (pi / 2 * quarter, pi / 2 * (quarter + 1))
    ]
