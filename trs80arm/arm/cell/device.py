"""What a device on the bench is to those who ask: to latch, clock, contact and drawings.

A device listens to some bits of the card's auxiliary latch, at the very T-state of a write. What it
moves it moves on the contact clock's ticks. The list of a bench's devices is its `WorkCell`.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

from trs80arm.arm.contact.scene import Scene
from trs80arm.arm.event_log import EventLog
from trs80arm.arm.settings import ArmSettings

NIBBLE = 0b1111
"""All bits of the auxiliary latch."""


class Device:
    """One device. What a kind of device does not do it leaves as it is here: nothing.

    Attributes:
        kind: what it is, as its table in a bench file is called.
        name: of it.
    """

    kind: ClassVar[str]
    name: str

    @property
    def title(self) -> str:
        """What people call it: its kind and name."""
        return self.kind if self.name == self.kind else f"{self.kind} '{self.name}'"

    @property
    def wires(self) -> Mapping[str, int]:
        """The bits of the auxiliary latch that it listens to, by the keys that name them."""
        raise NotImplementedError

    # The latch

    def connect(self, nibble: int) -> None:
        """Begin to listen to a latch that holds a nibble: a level is one, an edge is not."""

    def write(self, time: int, before: int, nibble: int, log: EventLog) -> None:
        """The latch holds another nibble.

        Args:
            time: of the write, T-states.
            before: what it held.
            nibble: what it holds.
            log: of the arm, for what there is to tell.
        """

    # The bench

    def suit(self, settings: ArmSettings) -> None:
        """Take over the settings of the arm that works here."""

    def lay(self, scene: Scene) -> None:
        """Have what of it can be touched stand in a scene."""

    def begin(self) -> None:
        """Stand as at the beginning: parts have been put where they were then."""

    # Time

    @property
    def stands(self) -> bool:
        """Whether nothing that it moves will be moved otherwise on the next tick."""
        return True

    def drive(self, scene: Scene) -> None:
        """Move on a tick what it moves: from `scene.time` to `scene.due`."""


def rises(before: int, nibble: int, bit: int) -> bool:
    """Whether a bit of a latch goes from 0 to 1."""
    return bool(nibble & ~before & 1 << bit)
