"""What an arm looks like at a moment, for whoever looks at it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from trs80arm.arm.geometry import JointAngles
from trs80arm.arm.model import Pose

Six = tuple[int, int, int, int, int, int]
"""One number for each motor."""


@dataclass(frozen=True, slots=True)
class ArmState:
    """What the arm looks like now.

    Attributes:
        rotors: six rotor positions, half-steps from where the arm was switched on.
        fields: six unwrapped field positions, half-steps.
        slipped: rotor less field; a multiple of 8 unless something holds the rotor back.
        coils: seven latch nibbles.
        motors_on: whether any of the six motors carries current.
        angles: of the joints, radians.
        pose: of the hand.
        force: of the grip, pounds.
        switch_closed: the grip switch.
        held: name of the part in the hand, or None.
    """

    rotors: Six
    fields: Six
    slipped: Six
    coils: tuple[int, ...]
    motors_on: bool
    angles: JointAngles
    pose: Pose
    force: float
    switch_closed: bool
    held: str | None


def six(numbers: Iterable[int]) -> Six:
    """Six numbers as a tuple."""
    base, shoulder, elbow, left, right, hand = numbers
    return base, shoulder, elbow, left, right, hand
