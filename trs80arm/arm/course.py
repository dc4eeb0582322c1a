"""An arm along a motion: where corners of its links and of its load are, at many places at once.

For bounds only, which decide nothing by themselves: the sines are the C library's. Whoever asks
leaves them a little room.
"""

from __future__ import annotations

import math
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
        self._linkage = linkage
        self._loads = loads
        self._opening = joints[5]
        base, shoulder, elbow, left, right = joints[:5]
        self._turns = np.array((base, shoulder, elbow, (left + right) / 2, (left - right) / 2))
        self._cosines, self._sines = np.cos(self._turns), np.sin(self._turns)
        self._frames: dict[Link, _Frame] = {}

    def corners(self, piece: int) -> list[Floats]:
        """Of each solid of a piece, links before loads: 3 x places x corners."""
        link, solids = self._solids(piece)
        place, along, across, up = (each[:, :, None] for each in self._frame(link))
        return [place + along * x + across * y + up * z for x, y, z in solids]

    def heights(self, piece: int) -> list[Floats]:
        """How high they are: places x corners."""
        link, solids = self._solids(piece)
        place, along, across, up = (each[:, None] for each in self._risen(link))
        return [place + along * x + across * y + up * z for x, y, z in solids]

    def _risen(self, link: Link) -> tuple[Floats, Floats, Floats, Floats]:
        """What of `_frame` is upwards."""
        model, (_, c2, c3, cp, cr), (_, s2, s3, sp, sr) = (
            self._linkage.model,
            self._cosines,
            self._sines,
        )
        nought = np.zeros_like(s2)
        if link is Link.UPPER_ARM:
            return nought + model.shoulder_height, s2, nought, c2
        if link is Link.FOREARM:
            return model.shoulder_height + model.link * s2, s3, nought, c3
        place, across = model.shoulder_height + model.link * (s2 + s3), sr * cp
        if link is not Link.HAND:
            side = 0.5 if link is FINGERS[0] else -0.5
            place = place + model.hand_length * sp + side * self._opening * across
        return place, sp, across, cp * cr

    def _solids(self, piece: int) -> tuple[Link, list[Floats]]:
        """The link of a piece, and its solids' corners there: each 3 x corners."""
        links = self._linkage.model.solids
        if piece < len(links):
            return links[piece].link, [np.array(self._linkage.solids[piece].vertices).T]
        load = self._loads[piece - len(links)]
        assert load.carried is not None
        place, turn = load.carried
        return Link.HAND, [
            np.array([plus(place, apply(turn, corner)) for corner in solid.vertices]).T
            for solid in load.shape.solids
        ]

    def _frame(self, link: Link) -> _Frame:
        """The frame of a link; the same as `ArmLinkage.links` has it."""
        if link not in self._frames:
            self._frames[link] = self._found(link)
        return self._frames[link]

    def _found(self, link: Link) -> _Frame:
        model = self._linkage.model
        c1, _, _, cp, cr = self._cosines
        s1, _, _, sp, sr = self._sines
        nought = np.zeros_like(c1)
        if link in (Link.UPPER_ARM, Link.FOREARM):
            level = np.array((-s1, c1, nought))
            ahead = self._ahead(1 if link is Link.UPPER_ARM else 2)
            start = np.array((nought, nought, nought + model.shoulder_height))
            if link is Link.FOREARM:
                start = start + model.link * self._ahead(1)
            return start, ahead, level, _cross(ahead, level)
        if link is Link.HAND:
            wrist = model.link * (self._ahead(1) + self._ahead(2))
            wrist[2] += model.shoulder_height
            pointing = self._ahead(3)
            across = np.array((-cr * s1 - sr * sp * c1, cr * c1 - sr * sp * s1, sr * cp))
            return wrist, pointing, across, _cross(pointing, across)
        wrist, pointing, across, up = self._frame(Link.HAND)
        side = 0.5 if link is FINGERS[0] else -0.5
        tip = wrist + model.hand_length * pointing
        return tip + side * self._opening * across, pointing, across, up

    def _ahead(self, turn: int) -> Floats:
        """The way in which something points that is raised by one of the angles."""
        c1, s1 = self._cosines[0], self._sines[0]
        c, s = self._cosines[turn], self._sines[turn]
        return np.array((c * c1, c * s1, s))


def fingertip(model: ArmModel, joints: Sequence[float]) -> tuple[float, float]:
    """`fingertips` for one place."""
    base, shoulder, elbow, left, right, _ = joints
    out = model.link * (math.cos(shoulder) + math.cos(elbow))
    out += model.hand_length * math.cos((left + right) / 2)
    return out * math.cos(base), out * math.sin(base)


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
