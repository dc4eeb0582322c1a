"""What happened to the arm, for logs, traces and the screen.

The arm writes an event for each loss of steps and for each change in what it holds or touches;
whoever draws the arm or judges a run reads them.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class EventKind(Enum):
    """Kinds of event."""

    SLIP = "slip"
    CONTACT = "contact"
    TAKEN = "taken"
    PLACED = "placed"
    DROPPED = "dropped"
    PUSHED = "pushed"
    TOPPLED = "toppled"
    FED = "fed"
    DELIVERED = "delivered"
    CARRIED = "carried"
    DEVICE = "device"


class Reason(Enum):
    """Why a motor lost steps."""

    RATE = "rate"
    LOAD = "load"
    STOP = "stop"
    CONTACT = "contact"


@dataclass(frozen=True, slots=True)
class ArmEvent:
    """One thing that happened.

    Attributes:
        number: serial number, from 0, over the life of the arm.
        time: T-state of the latch write that brought it about.
        kind: what sort of event.
        motor: index of the motor (0 base to 5 hand, 6 turntable), or None.
        steps: half-steps lost, a multiple of 8, signed as rotor minus field; 0 for other kinds.
        reason: why steps were lost, or None.
        text: one line for a person.
        until: T-state at which it was last seen to go on.
        count: how often it was.
        force: the greatest that went with it, ounces at the end of the link, of the base at the
            fingertip; 0 where none did.

    However long something goes on it is one event: while it does, the event in the list is
    replaced by one with the same number and time that tells of all of it.
    """

    number: int
    time: int
    kind: EventKind
    motor: int | None
    steps: int
    reason: Reason | None
    text: str
    until: int = 0
    count: int = 1
    force: float = 0.0


@dataclass(frozen=True, slots=True)
class Happening:
    """What makes two reports one event.

    Attributes:
        kind: of the event.
        subject: whom it happens to; for what the bench tells, all that it tells.
        other: what with, or which way.
        reason: why steps are lost, or None.
    """

    kind: EventKind
    subject: str
    other: str = ""
    reason: Reason | None = None

    def text(self, steps: int, force: float) -> str:
        """One line for a person.

        Args:
            steps: lost by it.
            force: ounces.
        """
        if self.reason is not None:
            return f"{self.subject} slipped {abs(steps)} steps: {_WHY[self.reason]}"
        if self.kind is EventKind.CONTACT and self.other:
            pressing = f", at {force:.0f} oz" if force >= 1 else ""
            return f"{self.subject} blocked by {self.other}{pressing}"
        return self.subject


_WHY = {
    Reason.RATE: "too fast",
    Reason.LOAD: "too much load",
    Reason.STOP: "at its stop",
    Reason.CONTACT: "blocked",
}
"""How reasons read."""
