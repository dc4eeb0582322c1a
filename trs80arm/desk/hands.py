"""The operator's hands on the arm, while its motors are off: one joint turned, or the hand put."""

from __future__ import annotations

from dataclasses import astuple, dataclass, replace
from math import degrees

from trs80arm.arm.by_hand import InTheWay, MotorsOn
from trs80arm.arm.geometry import JointAngles, OutOfReach
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


PLACES = ("x", "y", "z", "pitch", "roll", "opening")
"""What the figures of a pose are, in order."""


def joint_values(angles: JointAngles, opening: float) -> tuple[float, ...]:
    """The joints as hands know them, in the order of `TURNED_BY_HAND`: degrees, and inches."""
    return (*map(degrees, astuple(angles)), opening)


def typed_move(text: str, joint: str, now: Pose) -> MoveJoint | MoveTo:
    """What somebody wants who types figures: one for a joint, three to six for a pose.

    Args:
        text: the figures, with blanks or commas between them.
        joint: whose a single figure is.
        now: the pose that keeps what is not typed.

    Raises:
        ValueError: they are no such figures; one line.
    """
    try:
        numbers = [float(word) for word in text.replace(",", " ").split()]
    except ValueError:
        raise ValueError("numbers are wanted") from None
    if len(numbers) == 1:
        return MoveJoint(joint, numbers[0])
    if 3 <= len(numbers) <= len(PLACES):
        return MoveTo(replace(now, **dict(zip(PLACES, numbers, strict=False))))
    raise ValueError("one figure for the joint, or 3 to 6 for a pose")


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
