"""What a device on the bench is to those who ask: to latch, clock, contact, inputs and drawings.

A device listens to some bits of the card's auxiliary latch and acts at the very T-state of a write,
or when a time that it has set itself is over; it answers on bits of the input nibble. What it moves
it moves on the contact clock's ticks. The list of a bench's devices is its `WorkCell`.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import ClassVar, Protocol

from trs80arm.arm.cell.seen import Seen
from trs80arm.arm.contact.bodies import Body, Fixed
from trs80arm.arm.contact.manifold import Placed
from trs80arm.arm.contact.scene import Scene
from trs80arm.arm.event_log import EventLog
from trs80arm.arm.events import EventKind, Happening
from trs80arm.arm.fixtures import Feeder, Obstacle, Part
from trs80arm.arm.linkage import fixed_name
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.shapes import Box

NEVER = 1 << 60
"""A T-state that does not come."""


class Site(Protocol):
    """What a device can do with the bench that it stands on."""

    scene: Scene

    @property
    def parts(self) -> dict[str, Part]:
        """By name, in the order in which they came."""

    def in_the_way(self, solids: Sequence[Placed], but: str = "") -> str | None:
        """Name of anything that some solids are in, the arm and what it holds included."""

    def feed(self, feeder: Feeder) -> Part:
        """Let a feeder give its next part."""


class Device(ABC):
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
    @abstractmethod
    def wires(self) -> Mapping[str, int]:
        """The bits of the auxiliary latch that it listens to, by the keys that name them."""

    @property
    @abstractmethod
    def state(self) -> str:
        """What it does now, in a word or two."""

    @property
    def possible(self) -> bool:
        """Whether its values can be those of a device."""
        return all(0 <= bit <= 3 for bit in self.wires.values())

    # The latch

    def connect(self, nibble: int) -> None:
        """Begin to listen to a latch that holds a nibble: a level is one, an edge is not."""

    @abstractmethod
    def write(self, time: int, before: int, nibble: int, site: Site, log: EventLog) -> None:
        """The latch holds another nibble.

        Args:
            time: of the write, T-states.
            before: what it held.
            nibble: what it holds.
            site: the bench.
            log: of the arm, for what there is to tell.
        """

    # The bench

    @property
    def obstacles(self) -> Sequence[Obstacle]:
        """What of it stands on the table now."""
        return ()

    def suit(self, settings: ArmSettings) -> None:
        """Take over the settings of the arm that works here."""

    def lay(self, scene: Scene) -> None:
        """Have what of it can be touched stand in a scene."""

    def begin(self) -> None:
        """Stand as at the beginning: parts have been put where they were then."""

    def carries(self, body: Body) -> bool:
        """Whether it takes along what a body that is at rest stands on."""
        return False

    # Time

    @property
    def stands(self) -> bool:
        """Whether nothing that it moves will be moved otherwise on the next tick."""
        return True

    def drive(self, scene: Scene) -> None:
        """Move on a tick what it moves: from `scene.time` to `scene.due`."""

    @property
    def alarm(self) -> int:
        """T-state at which it acts next of itself; `NEVER` where it does not."""
        return NEVER

    def ring(self, site: Site, log: EventLog) -> None:
        """That T-state has come.

        Args:
            site: the bench.
            log: for what there is to tell.
        """

    def tell(self, log: EventLog, time: int, what: str) -> None:
        """Write an event: the device's name, and what became of it."""
        log.tell(time, Happening(EventKind.DEVICE, f"{self.name} {what}"))


class AnsweringDevice(Device):
    """A device that has answers on the input nibble, each shown by a `Lamp`."""

    @abstractmethod
    def lit(self, key: str, seen: Seen) -> bool:
        """Whether an answer is given that it has on an input bit.

        Args:
            key: that names the answer in the bench file.
            seen: what there is to sense.
        """


@dataclass(frozen=True)
class Lamp:
    """An answer of a device on a bit of the input nibble.

    Attributes:
        device: that gives it.
        key: that names it in the bench file.
        name: by which people call it.
        bit: of the input nibble, 1 to 3.
        bank: of the selector.
        box: where drawings have it.
    """

    device: AnsweringDevice
    key: str
    name: str
    bit: int
    bank: int
    box: Box

    def answers(self, seen: Seen) -> bool:
        """Whether it is given."""
        return self.device.lit(self.key, seen)

    def shown(self, seen: Seen) -> Box:
        """Where drawings have it."""
        return self.box


def stand(scene: Scene, obstacle: Obstacle, friction: float, passes: tuple[str, ...] = ()) -> Fixed:
    """Have something stand fast in a scene.

    Args:
        scene: of the bench.
        obstacle: that stands.
        friction: coefficient of its surface.
        passes: names of links of the arm that never meet it.
    """
    name = fixed_name(obstacle.name)
    while name in scene.fixed:
        name = fixed_name(name)
    return scene.stand(Fixed(name, obstacle.standing, friction, passes=passes))


def rises(before: int, nibble: int, bit: int) -> bool:
    """Whether a bit of a latch goes from 0 to 1."""
    return bool(nibble & ~before & 1 << bit)
