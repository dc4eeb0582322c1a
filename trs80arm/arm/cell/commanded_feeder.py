"""A feeder that gives its next part on command: on a rising edge of its bit.

While its place is taken, by a part or by the hand, it ignores the command. It may answer that a
part is there.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

from trs80arm.arm.bench import deep
from trs80arm.arm.cell.device import AnsweringDevice, Site, rises
from trs80arm.arm.cell.seen import Seen
from trs80arm.arm.event_log import EventLog
from trs80arm.arm.fixtures import Feeder


@dataclass
class CommandedFeeder(AnsweringDevice):
    """A feeder on the auxiliary latch.

    Attributes:
        name: of the feeder.
        feeder: with its parts; it is one of the bench's.
        give: bit on whose rising edge it gives the next.
    """

    kind: ClassVar[str] = "feeder"

    name: str
    feeder: Feeder
    give: int

    @property
    def wires(self) -> Mapping[str, int]:
        """The bit that commands it."""
        return {"give": self.give}

    @property
    def state(self) -> str:
        """How many parts it has given."""
        return "empty" if self.feeder.empty else f"{self.feeder.given} given"

    def write(self, time: int, before: int, nibble: int, site: Site, log: EventLog) -> None:
        """Give the next part, if there is one and room for it."""
        if not rises(before, nibble, self.give):
            return
        if self.feeder.empty:
            self.tell(log, time, "is empty")
            return
        there = site.in_the_way(self.feeder.placed)
        if there is None:
            site.feed(self.feeder)
        else:
            self.tell(log, time, f"cannot give: {there} is at its place")

    def lit(self, key: str, seen: Seen) -> bool:
        """Whether a part is at its place."""
        return any(deep(mine, other) for mine in self.feeder.placed for other in seen.parts)
