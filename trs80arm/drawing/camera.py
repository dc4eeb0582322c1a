"""Where one looks from: solids in the world as planes and boxes of the picture plane.

Both kinds of camera, parallel and in perspective, turn the plane of a face into an affine function
of the picture: the *nearness* at which a line of sight passes it (the depth's negative, or one over
the depth). A line of sight is inside a convex solid between the least nearness of the faces turned
to the eye and the greatest of those turned away. That is all that the rasteriser needs, and the
shadow on the table is the same with the sun's rays in place of lines of sight.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import cos, inf, sin

import numpy as np
import numpy.typing as npt

from trs80arm.drawing.solids import Floats, Place, Solids

_EDGE_ON = 1e-4
"""A face that is nearer than this to a line of sight is taken to be turned by so much."""
_NEAREST = 1.0
"""Inches before the eye at which things end to be seen."""


@dataclass(frozen=True, slots=True, eq=False)
class Projected:
    """Solids as a camera sees them.

    Attributes:
        nearness: of each face as an affine function of the picture: x, y and constant, m x 3.
        facing: whether each face is turned to the eye.
        boxes: left, bottom, right and top of each solid in the picture, inches.
    """

    nearness: Floats
    facing: npt.NDArray[np.bool_]
    boxes: Floats


@dataclass(frozen=True)
class Camera:
    """An eye.

    Attributes:
        target: what it looks at: the origin of the picture plane.
        right: unit vector to the right in the picture.
        up: unit vector up in the picture.
        distance: of the eye from the target, inches; infinite for a parallel view.
    """

    target: Place
    right: Place
    up: Place
    distance: float = inf

    @classmethod
    def around(cls, target: Place, turn: float, tilt: float, distance: float) -> Camera:
        """An eye that goes round a target.

        Args:
            target: what it looks at.
            turn: radians from which it looks, counter-clockwise from above; 0 looks along x.
            tilt: radians above the table.
            distance: inches.
        """
        c, s, d, h = cos(turn), sin(turn), cos(tilt), sin(tilt)
        return cls(target, (s, -c, 0.0), (h * c, h * s, d), distance)

    @cached_property
    def _axes(self) -> tuple[Floats, Floats, Floats, Floats]:
        right, up = np.array(self.right), np.array(self.up)
        return np.array(self.target), right, up, -np.cross(right, up)

    @property
    def forward(self) -> Floats:
        """Unit vector into the picture."""
        return self._axes[3]

    def points(self, places: Floats) -> Floats:
        """Places of the world as x, y of the picture and depth behind the target, n x 3."""
        target, right, up, forward = self._axes
        seen = (places - target) @ np.stack((right, up, forward), axis=1)
        if self.distance < inf:
            depth = np.maximum(seen[:, 2] + self.distance, _NEAREST)
            seen[:, :2] *= (self.distance / depth)[:, None]
        return seen

    def sees(self, solids: Solids) -> Projected:
        """Solids in this camera's picture."""
        target, right, up, forward = self._axes
        normals = solids.normals
        towards = normals @ forward
        if self.distance == inf:
            towards = np.where(np.abs(towards) < _EDGE_ON, -_EDGE_ON, towards)
            before = solids.offsets - normals @ target
            nearness = np.stack((normals @ right, normals @ up, -before), axis=1)
            nearness /= towards[:, None]
            facing = towards < 0
        else:
            before = solids.offsets - normals @ (target - self.distance * forward)
            before = np.where(np.abs(before) < _EDGE_ON, -_EDGE_ON, before)
            nearness = np.stack(
                (normals @ right / self.distance, normals @ up / self.distance, towards), axis=1
            )
            nearness /= before[:, None]
            facing = before < 0
        return Projected(nearness, facing, self._boxes(solids.corners, solids))

    def shades(self, solids: Solids, sun: Place) -> Projected:
        """The shadows of solids on the table, as this camera sees them.

        A point of the table is in the shadow of a solid if its ray to the sun passes through it.
        The "nearness" is the height of the ray in some measure, and says nothing by itself.
        """
        target, right, up, forward = self._axes
        rays = np.array(sun)
        # The point of the table under a point of the picture, as homogeneous coordinates that are
        # affine in the picture: place = (x * across + y * upward + middle) / weight.
        if self.distance == inf:
            across = right - forward * (right[2] / forward[2])
            upward = up - forward * (up[2] / forward[2])
            middle = target - forward * (target[2] / forward[2])
            weights = np.array([0.0, 0.0, 1.0])
        else:
            eye = target - self.distance * forward
            ways = [right / self.distance, up / self.distance, forward]
            weights = np.array([-way[2] for way in ways])
            across, upward, middle = (
                eye * w + way * eye[2] for way, w in zip(ways, weights, strict=True)
            )
        normals, offsets = solids.normals, solids.offsets
        towards = normals @ rays
        towards = np.where(np.abs(towards) < _EDGE_ON, -_EDGE_ON, towards)
        nearness = np.stack(
            [
                normals @ way - offsets * weight
                for way, weight in zip((across, upward, middle), weights, strict=True)
            ],
            axis=1,
        )
        nearness /= towards[:, None]
        corners = solids.corners
        grounded = corners - rays * (corners[:, 2] / rays[2])[:, None]
        return Projected(nearness, towards < 0, self._boxes(grounded, solids))

    def _boxes(self, corners: Floats, solids: Solids) -> Floats:
        seen = self.points(corners)[:, :2]
        low = np.minimum.reduceat(seen, solids.first_corner)
        high = np.maximum.reduceat(seen, solids.first_corner)
        return np.concatenate((low, high), axis=1)
