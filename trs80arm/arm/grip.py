"""The hand's hold: cable, opening, force, switch, and what is between the fingers.

Springs open the hand and the cable closes it. Once the fingers have met something, a part or
each other, further cable stretches a spring instead: force grows by a pound in 52 steps (article,
on joint 6; Figures 5 and 6). `World` keeps it in line with what contact finds.
"""

from __future__ import annotations

from dataclasses import dataclass

from trs80arm.arm.model import ArmModel


@dataclass
class Grip:
    """What the hand does with its cable.

    Attributes:
        model: of the arm.
        cable: half-steps of cable paid out; 0 where an empty hand has just closed.
        contact: half-steps of cable at which the fingers met what is between them; 0 while there
            is nothing.
        strain: half-steps of cable by which something that gives way holds the fingers up.
        part: name of the part that both fingers press on and can carry, or None.
        weight: of all that they have in their grip, ounces.
    """

    model: ArmModel
    cable: int = 0
    contact: int = 0
    strain: float = 0.0
    part: str | None = None
    weight: float = 0.0

    @property
    def squeeze(self) -> float:
        """Half-steps of cable taken up since the fingers met."""
        taken_up = self.contact - self.cable
        return self.strain + taken_up if taken_up > 0 else self.strain

    @property
    def force(self) -> float:
        """Gripping force, pounds."""
        return self.squeeze / self.model.hand.pound_steps

    @property
    def opening(self) -> float:
        """Between the fingers, inches; beyond the hand's range the cable is slack."""
        model = self.model
        out = max(self.cable, self.contact) + self.strain
        return min(model.hand.range, max(0.0, out) / model.hand_steps)

    @property
    def switch_closed(self) -> bool:
        """Whether the tension in the cable closes the grip switch."""
        return self.squeeze >= self.model.hand.switch_steps

    def carries(self, friction: float) -> float:
        """Ounces that the two pads can carry by friction."""
        return 32 * friction * self.force

    def forget(self) -> None:
        """Nothing is between the fingers any more."""
        self.contact, self.strain, self.part, self.weight = 0, 0.0, None, 0.0
