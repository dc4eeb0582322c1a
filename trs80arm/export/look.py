"""What a picture of the arm has between its links: a neck on the body, axles, and the wrist.

The solids of a model are the room that links take up, which leaves the joints free so that links
next to each other do not touch. What is here can touch nothing and weighs nothing; it is seen.
"""

from __future__ import annotations

from collections.abc import Mapping

from trs80arm.arm.contact.rotations import about
from trs80arm.arm.contact.solids import Solid, box, cylinder
from trs80arm.arm.model import ArmModel, Link, LinkSolid
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.shapes import Vector

_OUT = 0.1
"""How far an axle looks out of its link on each side, inches. The look is not on record."""
_LEVEL = about((1.0, 0.0, 0.0), 90.0)
_ALONG = about((0.0, 1.0, 0.0), 90.0)


def between_links(model: ArmModel, settings: ArmSettings) -> Mapping[str, tuple[Solid, ...]]:
    """Solids by the name of the chain's link with which they move, in its frame, inches.

    Args:
        model: of the arm.
        settings: the size of its body.
    """
    upper, fore, hand, left, right = (
        next(piece for piece in model.solids if piece.link is link)
        for link in (
            *(Link.UPPER_ARM, Link.FOREARM, Link.HAND),
            *(Link.LEFT_FINGER, Link.RIGHT_FINGER),
        )
    )
    side, neck = settings.body_radius, model.shoulder_height - settings.body_top
    shoulder = box((side, upper.half[1] * 1.6, neck)).moved((0.0, 0.0, -neck / 2))
    palm = _end(hand, -1)
    root = _end(hand, 1) - model.hand_length
    return {
        "turret": (*([shoulder] if side else []), _axle(upper, upper.half[2] * 0.6)),
        "upper_arm": (_axle(upper, upper.half[2] * 0.6, model.link),),
        "forearm": _bar(fore, _end(fore, 1), model.link),
        "wrist": (_axle(hand, fore.half[2]),),
        "hand": (cylinder(hand.half[2] * 0.7, palm).moved((palm / 2, 0.0, 0.0), _ALONG),),
        "left_finger": _bar(left, root, _end(left, -1)),
        "right_finger": _bar(right, root, _end(right, -1)),
    }


def _axle(through: LinkSolid, radius: float, at: float = 0.0) -> Solid:
    """A cylinder from side to side of a link, so far along it."""
    place: Vector = (at, 0.0, 0.0)
    return cylinder(radius, 2 * (through.half[1] + _OUT)).moved(place, _LEVEL)


def _bar(like: LinkSolid, start: float, end: float) -> tuple[Solid, ...]:
    """A link's solid gone on, slimmer, from somewhere along it to somewhere else, if further on."""
    if end - start < _OUT:
        return ()
    _, y, z = like.half
    middle = (start + end) / 2, like.center[1], like.center[2]
    return (box((end - start, 1.4 * y, 1.4 * z)).moved(middle),)


def _end(piece: LinkSolid, way: int) -> float:
    """Where along its link a solid ends, inches."""
    return piece.center[0] + way * piece.half[0]
