"""Where one looks from: solids in the world as faces and corners in the picture plane.

Both kinds of camera, parallel and in perspective, turn the plane of a face into an affine function
of the picture: the *nearness* at which a line of sight passes it (the depth's negative, or one over
the depth). That, and where the corners are, is all that the rasteriser needs; a shadow on the table
is the same for corners that the sun's rays have taken there.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import cos, inf, sin, sqrt

import numpy as np
import numpy.typing as npt

from trs80arm.arm.shapes import cross
from trs80arm.drawing.solids import Floats, Place, Solids

_EDGE_ON = 1e-4
"""A face that is turned to the eye by less than this is seen as a line, that is not at all."""
_NEAREST = 1.0
"""Inches before the eye at which things end to be seen."""


@dataclass(frozen=True, slots=True, eq=False)
class Projected:
    """Solids as a camera sees them.

    Attributes:
        nearness: of each face as an affine function of the picture: x, y and constant, m x 3.
        facing: whether each face is turned to the eye.
        corners: where each corner is in the picture, inches, n x 2.
    """

    nearness: Floats
    facing: npt.NDArray[np.bool_]
    corners: Floats


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
        return np.array(self.target), right, up, -np.array(cross(self.right, self.up))

    @cached_property
    def _turn(self) -> Floats:
        """The matrix from the world's axes to those of the picture and of depth."""
        return np.stack(self._axes[1:], axis=1)

    def towards(self, right: float, up: float, eye: float) -> Place:
        """A direction given to the right, up and towards the eye, as a unit vector of the world."""
        forward = cross(self.up, self.right)
        x, y, z = (
            right * a + up * b - eye * c
            for a, b, c in zip(self.right, self.up, forward, strict=True)
        )
        length = sqrt(x * x + y * y + z * z)
        return x / length, y / length, z / length

    @property
    def forward(self) -> Floats:
        """Unit vector into the picture."""
        return self._axes[3]

    def points(self, places: Floats) -> Floats:
        """Places of the world as x, y of the picture and depth behind the target, n x 3."""
        seen = (places - self._axes[0]) @ self._turn
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
            to_eye = towards
            nearness = np.stack(
                (normals @ right, normals @ up, normals @ target - solids.offsets), axis=1
            )
        else:
            to_eye = solids.offsets - normals @ (target - self.distance * forward)
            nearness = np.stack(
                (normals @ right / self.distance, normals @ up / self.distance, towards), axis=1
            )
        facing = to_eye < -_EDGE_ON
        nearness /= np.where(facing, to_eye, -1.0)[:, None]
        return Projected(nearness, facing, self.points(solids.corners)[:, :2])

    def shades(self, solids: Solids, sun: Place) -> Projected:
        """The shadows of solids on the table, as this camera sees them.

        They are those of the faces turned to the sun; shadows are not one nearer than the other.
        """
        rays, corners = np.array(sun), solids.corners
        grounded = corners - rays * (corners[:, 2] / rays[2])[:, None]
        facing = solids.normals @ rays > _EDGE_ON
        return Projected(np.zeros((len(facing), 3)), facing, self.points(grounded)[:, :2])
