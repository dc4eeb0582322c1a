"""The hand's hold: cable, opening, force, switch, and the part between the fingers.

Springs open the hand and the cable closes it. Once the fingers have met something, a part or
each other, further cable stretches a spring instead: force grows by a pound in 52 steps (article,
on joint 6; Figures 5 and 6). `World` keeps it in line with the bench.
"""

from __future__ import annotations

from dataclasses import dataclass

from trs80arm.arm.body import Hold
from trs80arm.arm.model import ArmModel
from trs80arm.arm.shapes import Box


@dataclass
class Grip:
    """What the hand does with its cable.

    Attributes:
        model: of the arm.
        cable: half-steps of cable paid out; 0 where an empty hand has just closed.
        contact: half-steps of cable at which the fingers met what is between them.
        part: name of the part that the fingers press on, or None.
        fixed: an obstacle that they press on instead, or None.
        hold: how that part sits in the hand if friction carries it, or None.
        weight: of the part carried, ounces.
        slid: how far the part has been pushed along the fingers in this grip, inches.
    """

    model: ArmModel
    cable: int = 0
    contact: int = 0
    part: str | None = None
    fixed: Box | None = None
    hold: Hold | None = None
    weight: float = 0.0
    slid: float = 0.0

    @property
    def squeeze(self) -> int:
        """Half-steps of cable taken up since the fingers met."""
        return max(0, self.contact - self.cable)

    @property
    def force(self) -> float:
        """Gripping force, pounds."""
        return self.squeeze / self.model.hand.pound_steps

    @property
    def opening(self) -> float:
        """Between the fingers, inches."""
        return self.opening_at(self.cable)

    def opening_at(self, cable: int) -> float:
        """Opening (inches) with so much cable paid out; beyond the widest the cable is slack."""
        model = self.model
        return min(model.hand.range, max(cable, self.contact) / model.hand_steps)

    @property
    def switch_closed(self) -> bool:
        """Whether the tension in the cable closes the grip switch."""
        return self.squeeze >= self.model.hand.switch_steps

    @property
    def held(self) -> str | None:
        """Name of the part carried."""
        return self.part if self.hold is not None else None

    def excess(self, cable: int) -> int:
        """Half-steps of squeeze beyond what the hand motor can hold."""
        return max(0, self.contact - cable - self.model.hand.most_squeeze)

    def carries(self, friction: float) -> float:
        """Ounces that the two pads can carry by friction."""
        return 32 * friction * self.force

    def forget(self) -> None:
        """Nothing is between the fingers any more."""
        self.contact, self.part, self.fixed = 0, None, None
        self.hold, self.weight, self.slid = None, 0.0, 0.0
