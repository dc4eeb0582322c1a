"""The arm as lines, for drawing and for sensors: links, palm, finger roots, inner faces of fingers.

What it takes up of the room, with its thickness, is `linkage`'s.
"""

from __future__ import annotations

from trs80arm.arm.geometry import JointAngles, forward
from trs80arm.arm.model import ArmModel
from trs80arm.arm.shapes import Vector

Segment = tuple[Vector, Vector]


class Body:
    """The arm in one position.

    Attributes:
        points: joints and hand axes.
        segments: upper arm, forearm, palm, finger roots, left finger, right finger.
        opening: inches between the inner faces of the fingers.
    """

    __slots__ = ("opening", "points", "segments")

    def __init__(self, model: ArmModel, angles: JointAngles, opening: float) -> None:
        points, finger_length = forward(model, angles), model.hand.finger_length
        self.points = points
        self.opening = opening
        tip, u, e = points.fingertip, points.pointing, points.across
        x, y, z = opening / 2 * e[0], opening / 2 * e[1], opening / 2 * e[2]
        root = (
            tip[0] - finger_length * u[0],
            tip[1] - finger_length * u[1],
            tip[2] - finger_length * u[2],
        )
        left_root = (root[0] + x, root[1] + y, root[2] + z)
        right_root = (root[0] - x, root[1] - y, root[2] - z)
        self.segments: tuple[Segment, ...] = (
            (points.shoulder, points.elbow),
            (points.elbow, points.wrist),
            (points.wrist, root),
            (left_root, right_root),
            (left_root, (tip[0] + x, tip[1] + y, tip[2] + z)),
            (right_root, (tip[0] - x, tip[1] - y, tip[2] - z)),
        )
