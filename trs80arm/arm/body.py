"""The arm as something that takes up room: links and fingers as segments, the held part as a box.

Contact is judged on this skeleton: forearm, palm, finger roots, two fingers, upper arm. The
inner faces of the fingers are what counts, so a part fits between them when the hand is opened
wider than the part. `MiniMover` makes one of these for each position that it tries.
"""

from __future__ import annotations

from copy import copy
from dataclasses import dataclass

from trs80arm.arm.geometry import ArmPoints, JointAngles, forward
from trs80arm.arm.model import ArmModel
from trs80arm.arm.shapes import Box, Vector, cross, dot, minus, plus

Segment = tuple[Vector, Vector]


class Body:
    """The arm in one position.

    Attributes:
        points: joints and hand axes.
        segments: upper arm, forearm, palm, finger roots, left finger, right finger.
        opening: inches between the inner faces of the fingers.
    """

    __slots__ = ("opening", "points", "segments")

    def __init__(
        self, model: ArmModel, angles: JointAngles, opening: float, finger_length: float
    ) -> None:
        points = forward(model, angles)
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

    def opened(self, opening: float) -> Body:
        """The same with the fingers (`opening` inches) apart."""
        body = copy(self)
        e = self.points.across
        by = (opening - self.opening) / 2
        (left_root, left), (right_root, right) = self.segments[4:]
        left_root, left = plus(left_root, e, by), plus(left, e, by)
        right_root, right = plus(right_root, e, -by), plus(right, e, -by)
        body.segments = (
            *self.segments[:3],
            (left_root, right_root),
            (left_root, left),
            (right_root, right),
        )
        body.opening = opening
        return body

    @property
    def lowest_tip(self) -> float:
        """Height of the lower fingertip, inches."""
        return min(self.segments[4][1][2], self.segments[5][1][2])


@dataclass(frozen=True, slots=True)
class Hold:
    """How a part sits in the hand.

    Attributes:
        center: of the part from the fingertip, along the hand's axes (pointing, across, their
            product), inches.
        axes: of the part, along the hand's axes.
        half: half the part's size, inches.
    """

    center: Vector
    axes: tuple[Vector, Vector, Vector]
    half: Vector

    @classmethod
    def of(cls, box: Box, points: ArmPoints) -> Hold:
        """How a box sits in a hand that is here."""
        frame = _frame(points)
        a, b, c = (_into(axis, frame) for axis in box.axes)
        return cls(_into(minus(box.center, points.fingertip), frame), (a, b, c), box.half)

    def box(self, points: ArmPoints) -> Box:
        """The part when the hand is here."""
        frame = _frame(points)
        a, b, c = (_out_of(axis, frame) for axis in self.axes)
        return Box(plus(points.fingertip, _out_of(self.center, frame)), (a, b, c), self.half)


Frame = tuple[Vector, Vector, Vector]


def _frame(points: ArmPoints) -> Frame:
    """The hand's axes: pointing, across, and square to both."""
    return points.pointing, points.across, cross(points.pointing, points.across)


def _into(v: Vector, frame: Frame) -> Vector:
    """A vector in the hand's axes."""
    return dot(v, frame[0]), dot(v, frame[1]), dot(v, frame[2])


def _out_of(v: Vector, frame: Frame) -> Vector:
    """A vector given in the hand's axes, in the world's."""
    return plus(
        plus((0.0, 0.0, 0.0), frame[0], v[0]), plus(_scaled(frame[1], v[1]), frame[2], v[2])
    )


def _scaled(v: Vector, factor: float) -> Vector:
    """A multiple of a vector."""
    return v[0] * factor, v[1] * factor, v[2] * factor
