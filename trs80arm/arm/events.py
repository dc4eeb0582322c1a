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
            While a motor keeps losing for the same reason without having followed in between,
            its one event grows: it is replaced in the list by one with more steps.
        reason: why steps were lost, or None.
        text: one line for a person.
    """

    number: int
    time: int
    kind: EventKind
    motor: int | None
    steps: int
    reason: Reason | None
    text: str
