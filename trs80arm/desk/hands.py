"""The operator's hands on the arm, while its motors are off: one joint turned, or the hand put."""

from __future__ import annotations

from dataclasses import dataclass

from trs80arm.arm.geometry import OutOfReach
from trs80arm.arm.minimover import InTheWay, MotorsOn
from trs80arm.desk.session import Session
from trs80arm.rig import Pose


@dataclass(frozen=True)
class MoveJoint:
    """Turn one joint.

    Attributes:
        joint: its name in `TURNED_BY_HAND`.
        value: where to: degrees, or inches for the hand.
    """

    joint: str
    value: float


@dataclass(frozen=True)
class MoveTo:
    """Put the hand to a pose."""

    pose: Pose


def move_by_hand(session: Session, move: MoveJoint | MoveTo) -> str:
    """Do a move.

    Returns:
        Why the arm does not go there; empty when it went.
    """
    try:
        if isinstance(move, MoveTo):
            session.rig.move_to(move.pose)
        else:
            session.rig.move_joint(move.joint, move.value)
    except (MotorsOn, InTheWay, OutOfReach, ValueError) as error:
        return str(error)
    return ""
