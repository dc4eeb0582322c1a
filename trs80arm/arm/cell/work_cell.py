"""The work cell: all devices of a bench in one list, and the latch that drives them."""

from __future__ import annotations

from trs80arm.arm.cell.device import NEVER, Device, Site
from trs80arm.arm.contact.scene import Scene
from trs80arm.arm.event_log import EventLog
from trs80arm.arm.fixtures import Obstacle
from trs80arm.arm.settings import ArmSettings


class WorkCell:
    """The devices on the bench.

    Attributes:
        devices: in the order of the bench file.
        nibble: what the auxiliary latch holds.
    """

    def __init__(self) -> None:
        self.devices: list[Device] = []
        self.nibble = 0

    def listener(self, bit: int) -> Device | None:
        """Who listens to a bit of the auxiliary latch, or None: no two devices can."""
        for device in self.devices:
            if bit in device.wires.values():
                return device
        return None

    # The latch

    def connect(self, nibble: int) -> None:
        """Hang on a latch that holds a nibble."""
        self.nibble = nibble & 0b1111
        for device in self.devices:
            device.connect(self.nibble)

    def write(self, time: int, nibble: int, site: Site, log: EventLog) -> bool:
        """A write to the auxiliary latch; whether it changed anything that a device listens to.

        Args:
            time: T-states.
            nibble: as written.
            site: the bench.
            log: for what there is to tell.
        """
        before, self.nibble = self.nibble, nibble & 0b1111
        changed = before ^ self.nibble
        heard = False
        for device in self.devices:
            if any(changed >> bit & 1 for bit in device.wires.values()):
                device.write(time, before, self.nibble, site, log)
                heard = True
        return heard

    # The bench

    @property
    def obstacles(self) -> list[Obstacle]:
        """What of the devices stands on the table now."""
        return [each for device in self.devices for each in device.obstacles]

    def suit(self, settings: ArmSettings) -> None:
        """Take over the settings of the arm that works here."""
        for device in self.devices:
            device.suit(settings)

    def lay(self, scene: Scene) -> None:
        """Have the devices stand in a scene."""
        for device in self.devices:
            device.lay(scene)

    def begin(self) -> None:
        """Stand as at the beginning."""
        for device in self.devices:
            device.begin()

    # Time

    @property
    def stands(self) -> bool:
        """Whether nothing that devices move will be moved otherwise on the next tick."""
        return not self.devices or all(device.stands for device in self.devices)

    def drive(self, scene: Scene) -> None:
        """Move on a tick what devices move."""
        for device in self.devices:
            device.drive(scene)

    @property
    def alarm(self) -> int:
        """T-state at which a device acts next of itself."""
        return min([device.alarm for device in self.devices]) if self.devices else NEVER

    def ring(self, site: Site, log: EventLog) -> None:
        """That T-state has come: those act whose it is."""
        time = self.alarm
        for device in self.devices:
            if device.alarm == time:
                device.ring(site, log)
