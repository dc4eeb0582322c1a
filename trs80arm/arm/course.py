"""An arm along a motion: where corners of its links and of its load are, at many places at once.

For bounds only, which decide nothing by themselves: the sines are the C library's. Whoever asks
leaves them a little room.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from trs80arm.arm.contact.bodies import Body
from trs80arm.arm.contact.rotations import apply
from trs80arm.arm.linkage import FINGERS, ArmLinkage
from trs80arm.arm.model import ArmModel, Link
from trs80arm.arm.shapes import Vector, plus

Floats = npt.NDArray[np.float64]

_Frame = tuple[Floats, Floats, Floats, Floats]
"""Origin, and the axes along, across and up; each 3 x places."""


class Course:
    """Solids of an arm and of what it carries along a motion.

    Args:
        linkage: the arm.
        joints: its six coordinates, 6 x places.
        loads: what rests in the hand.
    """

    def __init__(self, linkage: ArmLinkage, joints: Floats, loads: Sequence[Body]) -> None:
        self._frames = _frames(linkage, joints)
        self._solids: list[tuple[Link, Floats]] = [
            (piece.link, np.array(solid.vertices))
            for piece, solid in zip(linkage.model.solids, linkage.solids, strict=True)
        ]
        for load in loads:
            assert load.carried is not None
            place, turn = load.carried
            for solid in load.shape.solids:
                corners = [plus(place, apply(turn, corner)) for corner in solid.vertices]
                self._solids.append((Link.HAND, np.array(corners)))
        self._corners: dict[int, Floats] = {}

    def __len__(self) -> int:
        return len(self._solids)

    def box(self, index: int) -> tuple[Floats, Floats]:
        """An upright box in which a solid always is: least and greatest x, y, z."""
        link, local = self._solids[index]
        place, along, across, up = self._frames[link]
        low, high = local.min(axis=0), local.max(axis=0)
        x, y, z = (low + high) / 2
        middle = place + along * x + across * y + up * z
        radius = float(np.sqrt(((high - low) ** 2).sum())) / 2
        return middle.min(axis=1) - radius, middle.max(axis=1) + radius

    def corners(self, index: int) -> Floats:
        """Of a solid, links before loads: 3 x places x corners."""
        if index not in self._corners:
            link, local = self._solids[index]
            place, along, across, up = (each[:, :, None] for each in self._frames[link])
            x, y, z = local.T
            self._corners[index] = place + along * x + across * y + up * z
        return self._corners[index]


def fingertips(model: ArmModel, joints: Floats) -> tuple[Floats, Floats]:
    """X and y of the fingertip at many places.

    Args:
        model: of the arm.
        joints: its six coordinates, 6 x places.
    """
    base, shoulder, elbow, left, right, _ = joints
    out = model.link * (np.cos(shoulder) + np.cos(elbow))
    out += model.hand_length * np.cos((left + right) / 2)
    return out * np.cos(base), out * np.sin(base)


def _frames(linkage: ArmLinkage, joints: Floats) -> dict[Link, _Frame]:
    """The frames of the links; the same as `ArmLinkage.links` has them."""
    model = linkage.model
    base, shoulder, elbow, left, right, opening = joints
    pitch, roll = (left + right) / 2, (left - right) / 2
    c1, s1, c2, s2 = np.cos(base), np.sin(base), np.cos(shoulder), np.sin(shoulder)
    c3, s3, cp, sp = np.cos(elbow), np.sin(elbow), np.cos(pitch), np.sin(pitch)
    cr, sr = np.cos(roll), np.sin(roll)
    nought = np.zeros_like(base)
    upper = np.array((c2 * c1, c2 * s1, s2))
    fore = np.array((c3 * c1, c3 * s1, s3))
    pointing = np.array((cp * c1, cp * s1, sp))
    level = np.array((-s1, c1, nought))
    across = np.array((-cr * s1 - sr * sp * c1, cr * c1 - sr * sp * s1, sr * cp))
    up = _cross(pointing, across)
    start = np.array((nought, nought, nought + model.shoulder_height))
    bend = start + model.link * upper
    wrist = bend + model.link * fore
    tip = wrist + model.hand_length * pointing
    frames = {
        Link.UPPER_ARM: (start, upper, level, _cross(upper, level)),
        Link.FOREARM: (bend, fore, level, _cross(fore, level)),
        Link.HAND: (wrist, pointing, across, up),
    }
    for finger, side in zip(FINGERS, (0.5, -0.5), strict=True):
        frames[finger] = (tip + side * opening * across, pointing, across, up)
    return frames


def _cross(a: Floats, b: Floats) -> Floats:
    return np.array(
        (
            a[1] * b[2] - a[2] * b[1],
            a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0],
        )
    )


def beyond(corners: Floats, other: Sequence[Vector], way: Vector) -> Floats:
    """Inches by which a solid is beyond another along a way, for each place.

    Args:
        corners: of the solid, 3 x places x corners.
        other: corners of the other, that stands.
        way: of length 1.
    """
    x, y, z = way
    most = max(x * a + y * b + z * c for a, b, c in other)
    least: Floats = (x * corners[0] + y * corners[1] + z * corners[2]).min(axis=1)
    return least - most


def in_a_row(good: npt.NDArray[np.bool_]) -> int:
    """How many places come before the first that is not good."""
    bad = int(np.argmin(good)) if len(good) else 0
    return len(good) if good[bad : bad + 1].all() else bad
