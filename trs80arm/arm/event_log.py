"""What happened to the arm, one event for one happening however long it goes on.

`MiniMover` tells of slips, contacts and what the bench has to tell; whoever shows events reads
them here.
"""

from __future__ import annotations

from trs80arm.arm.contact.clock import T_STATES_PER_SECOND
from trs80arm.arm.events import ArmEvent, Happening

LULL = T_STATES_PER_SECOND // 2
"""T-states after which what happens again is another event."""
MANY = 256
"""Happenings that are remembered, to tell whether one goes on, before those that cannot are not."""


class EventLog:
    """Events in the order in which they began.

    Args:
        most: events that are kept.

    Attributes:
        events: the latest of them.
        count: events so far, those dropped from the list included.
    """

    def __init__(self, most: int) -> None:
        self.events: list[ArmEvent] = []
        self.count = 0
        self._most = most
        self._happening: dict[Happening, int] = {}

    def tell(
        self,
        time: int,
        happening: Happening,
        motor: int | None = None,
        force: float = 0.0,
        steps: int = 0,
        *,
        goes_on: bool = False,
    ) -> int:
        """Remember that something happens; however long it goes on it is one event.

        Args:
            time: T-states.
            happening: what it is.
            motor: to which it happens.
            force: ounces.
            steps: lost by it, half-steps.
            goes_on: whether it has not ended, however long ago it was last told of.

        Returns:
            The event's number.
        """
        number = self._happening.get(happening)
        if number is not None and self.events and number >= self.events[0].number:
            index = number - self.events[0].number
            event = self.events[index]
            if (goes_on and motor is not None) or time - event.until <= LULL:
                steps, force = event.steps + steps, max(event.force, force)
                self.events[index] = ArmEvent(
                    number,
                    event.time,
                    event.kind,
                    event.motor,
                    steps,
                    event.reason,
                    happening.text(steps, force),
                    until=time,
                    count=event.count + 1,
                    force=force,
                )
                return number
        number = self.count
        self._happening[happening] = number
        self.events.append(
            ArmEvent(
                number,
                time,
                happening.kind,
                motor,
                steps,
                happening.reason,
                happening.text(steps, force),
                until=time,
                force=force,
            )
        )
        self.count += 1
        if len(self.events) > self._most:
            del self.events[0]
        if len(self._happening) > MANY:
            self._forget(time)
        return number

    def _forget(self, time: int) -> None:
        """Remember only what can still go on: what is told of a motor, and what was told lately."""
        first = self.events[0].number
        self._happening = {
            one: at
            for one, at in self._happening.items()
            if at >= first
            and ((event := self.events[at - first]).motor is not None or time - event.until <= LULL)
        }
