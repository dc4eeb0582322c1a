"""The arm as contact sees it: boxes on links, and how each motor moves them.

Cables drive every link by its angle to the horizontal, so turning the upper arm only shifts what
hangs on its end; the wrist gears turn the hand about two axes at once.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

from trs80arm.arm.contact.bodies import NOWHERE, Body, Link, Screw
from trs80arm.arm.contact.carrying import load_at
from trs80arm.arm.contact.manifold import Placed
from trs80arm.arm.contact.rotations import Matrix
from trs80arm.arm.contact.solids import KNOWN, Solid, box
from trs80arm.arm.geometry import JointAngles, forward, forward_by, pitch_and_roll
from trs80arm.arm.model import ArmModel
from trs80arm.arm.model import Link as Piece
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.shapes import Vector, cross
from trs80arm.arm.trigonometry import sin_cos

_FIXED, _LINK = "\x01", "\x02"


def fixed_name(name: str) -> str:
    """What an obstacle is called among the things that touch; no part can be called that."""
    return _FIXED + name


def link_name(name: str) -> str:
    """What a link of the arm is called among the things that touch; no part can be called that."""
    return _LINK + name


def said(name: str) -> str:
    """The name of a thing that touches, as people know it."""
    return name.strip(_FIXED + _LINK)


@lru_cache(KNOWN)
def _solid(half: Vector, center: Vector) -> Solid:
    """A box of a link in the link's frame; arms of one model have the same ones."""
    return box((2 * half[0], 2 * half[1], 2 * half[2])).moved(center)


FINGERS = (Piece.LEFT_FINGER, Piece.RIGHT_FINGER)


@dataclass(frozen=True)
class ArmLinkage:
    """An arm of a model.

    Attributes:
        model: of the arm.
        settings: its friction.
    """

    model: ArmModel
    settings: ArmSettings

    @cached_property
    def names(self) -> Sequence[str]:
        """Of the links."""
        return tuple(link_name(solid.name) for solid in self.model.solids)

    @cached_property
    def solids(self) -> Sequence[Solid]:
        """Of the links, each in its own frame."""
        return tuple(_solid(s.half, s.center) for s in self.model.solids)

    @cached_property
    def frictions(self) -> Sequence[float]:
        """Of the links' surfaces; pads rub with `pad_friction` on a part as rough as the table."""
        table = self.settings.table_friction
        pad = self.settings.pad_friction**2 / table
        return tuple(pad if s.link in FINGERS else table for s in self.model.solids)

    @property
    def stiffness(self) -> Sequence[float]:
        """Of the cables."""
        return self.model.stiffness

    @cached_property
    def hand(self) -> int:
        """Index of the hand's own box."""
        return next(i for i, s in enumerate(self.model.solids) if s.link is Piece.HAND)

    @cached_property
    def fingers(self) -> tuple[str, ...]:
        """Names of the fingers."""
        return tuple(
            name for name, s in zip(self.names, self.model.solids, strict=True) if s.link in FINGERS
        )

    def links(self, joints: Sequence[float]) -> list[Link]:
        """Where the links are.

        Args:
            joints: angles of base, upper arm, forearm, left and right gear in radians, and the
                opening in inches.
        """
        base_angle, shoulder, elbow, left_gear, right_gear, opening = joints
        s1, c1 = one = sin_cos(base_angle)
        s2, c2 = two = sin_cos(shoulder)
        s3, c3 = three = sin_cos(elbow)
        bent, rolled = pitch_and_roll(left_gear, right_gear)
        points = forward_by(self.model, one, two, three, sin_cos(bent), sin_cos(rolled))
        link = self.model.link
        left: Vector = (-s1, c1, 0.0)
        right: Vector = (s1, -c1, 0.0)
        raised = (-link * s2 * c1, -link * s2 * s1, link * c2)
        swung = (-link * s3 * c1, -link * s3 * s1, link * c3)
        base: Screw = ((0.0, 0.0, 1.0), NOWHERE)
        still: Screw = (NOWHERE, NOWHERE)
        upper: tuple[Screw, ...] = (base, _about(points.shoulder, right), *[still] * 4)
        fore = (base, (NOWHERE, raised), _about(points.elbow, right), *[still] * 3)
        pitch, roll = _about(points.wrist, right), _about(points.wrist, points.pointing)
        hand = (
            base,
            (NOWHERE, raised),
            (NOWHERE, swung),
            _half(pitch, roll, 1.0),
            _half(pitch, roll, -1.0),
        )
        across, tip = points.across, points.fingertip
        turn = _frame(points.pointing, across)
        found = {
            Piece.UPPER_ARM: Link(points.shoulder, _frame((c2 * c1, c2 * s1, s2), left), upper),
            Piece.FOREARM: Link(points.elbow, _frame((c3 * c1, c3 * s1, s3), left), fore),
            Piece.HAND: Link(points.wrist, turn, (*hand, still)),
        }
        for piece, side in zip(FINGERS, (0.5, -0.5), strict=True):
            by = (side * across[0], side * across[1], side * across[2])
            place = (tip[0] + opening * by[0], tip[1] + opening * by[1], tip[2] + opening * by[2])
            found[piece] = Link(place, turn, (*hand, (NOWHERE, by)))
        return [found[solid.link] for solid in self.model.solids]

    def hand_at(self, joints: Sequence[float]) -> Link:
        """Where the hand is, with nothing said of how it moves.

        Args:
            joints: as for `links`.
        """
        points = forward(self.model, JointAngles.of_gears(*joints[:5]))
        return Link(points.wrist, _frame(points.pointing, points.across), ())

    def standing(
        self, joints: Sequence[float], carried: Iterable[Body] = ()
    ) -> list[tuple[str, Placed]]:
        """The links' solids with their names, and those of a load with none.

        Args:
            joints: of an arm that stands there.
            carried: what rests in its hand.
        """
        links = self.links(joints)
        found = [
            (name, Placed(solid, link.place, link.turn))
            for name, solid, link in zip(self.names, self.solids, links, strict=True)
        ]
        for load in carried:
            found += [("", solid) for solid in load_at(load, links[self.hand])]
        return found


def _frame(ahead: Vector, aside: Vector) -> Matrix:
    """The turn of what points ahead, and has its left aside."""
    a, b, c = ahead
    d, e, f = aside
    return a, d, b * f - c * e, b, e, c * d - a * f, c, f, a * e - b * d


def _about(point: Vector, axis: Vector) -> Screw:
    """Turning about an axis through a point."""
    return axis, cross(point, axis)


def _half(one: Screw, other: Screw, sign: float) -> Screw:
    """Half of both turns at once, the second one way or the other."""
    h = sign / 2
    (a, v), (b, w) = one, other
    return (
        (a[0] / 2 + h * b[0], a[1] / 2 + h * b[1], a[2] / 2 + h * b[2]),
        (v[0] / 2 + h * w[0], v[1] / 2 + h * w[1], v[2] / 2 + h * w[2]),
    )
