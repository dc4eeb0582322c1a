"""A machine that works on a part put into its nest, with a handshake of four phases.

On the rising edge of `start` it closes its hood over the nest and works for so long, to the
T-state. It answers `busy` meanwhile and `done` after that, until `start` falls. A press lowers the
part as well. Without a part in the nest, or with something in the hood's way, it answers `error`
until `start` falls; when `start` falls while it works it stops, and the part is as it was.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import ClassVar

from trs80arm.arm.cell.device import NEVER, AnsweringDevice, Site, rises, stand
from trs80arm.arm.cell.seen import Seen
from trs80arm.arm.contact.clock import T_STATES_PER_SECOND
from trs80arm.arm.contact.forms import flattened
from trs80arm.arm.contact.scene import Scene
from trs80arm.arm.event_log import EventLog
from trs80arm.arm.fixtures import Obstacle, Part
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.shapes import Box, Vector, dot, minus

IDLE, BUSY, DONE, ERROR = "idle", "busy", "done", "error"
"""What it does; the last three are its answers too."""
DIPS = 0.02
"""Inches by which a part at rest may be out of the nest."""
NOTHING = "no part is at rest in its nest, or not one alone"
"""Why it cannot start."""


@dataclass
class Machine(AnsweringDevice):
    """A machine.

    Attributes:
        name: of it.
        nest: the room under the hood, in which the part has to be.
        hood: walls and roof, while they are closed.
        block: what the nest is on, or None where that is the table.
        seconds: that it works.
        start: bit that starts it.
        press: height to which it lowers parts that are higher, inches; None where it presses none.
        phase: what it does.
        until: T-state at which it has done, while it is busy.
        part: name of the part that it works on.
        thing: name of the hood among the things that touch, while it is closed.
        rough: coefficient of its surfaces.
    """

    kind: ClassVar[str] = "machine"

    name: str
    nest: Box
    hood: Obstacle
    block: Obstacle | None
    seconds: float
    start: int
    press: float | None = None
    phase: str = IDLE
    until: int = NEVER
    part: str = ""
    thing: str = ""
    rough: float = 0.5

    @property
    def wires(self) -> Mapping[str, int]:
        """The bit that starts it."""
        return {"start": self.start}

    @property
    def state(self) -> str:
        """What it does."""
        return self.phase

    @property
    def possible(self) -> bool:
        """Whether it can be."""
        known = self.phase in (IDLE, BUSY, DONE, ERROR)
        return super().possible and known and 0 <= self.until <= NEVER and self.seconds > 0

    # The handshake

    def write(self, time: int, before: int, nibble: int, site: Site, log: EventLog) -> None:
        """Start to work; or take the answer back, or stop."""
        if rises(before, nibble, self.start):
            self._begin_work(time, site, log)
        elif rises(nibble, before, self.start):
            if self.phase == BUSY:
                self._open(site.scene)
                self.tell(log, time, f"stopped, {self.part} as it was")
            self.phase = IDLE

    def _begin_work(self, time: int, site: Site, log: EventLog) -> None:
        part = self._nested(site)
        there = None if part is None else site.in_the_way(self.hood.placed)
        if part is None or there is not None:
            self.phase = ERROR
            self.tell(log, time, "cannot start: " + (f"{there} is in the way" if part else NOTHING))
            return
        self.phase, self.part = BUSY, part.name
        self.until = time + round(self.seconds * T_STATES_PER_SECOND)
        self.thing = stand(site.scene, self.hood, self.rough).name
        self.tell(log, time, f"works on {part.name}")

    def _nested(self, site: Site) -> Part | None:
        """The part at rest in the nest; None if there is none, or not it alone."""
        there = [part for part in site.parts.values() if self._inside(part.place)]
        if len(there) != 1:
            return None
        (part,) = there
        free = part.asleep and not part.held and part.carried is None
        corners = [corner for solid in part.placed for corner in solid.vertices]
        return part if free and all(map(self._inside, corners)) else None

    def _inside(self, point: Vector) -> bool:
        """Whether a point is in the nest."""
        off = minus(point, self.nest.center)
        return all(
            abs(dot(off, axis)) <= half + DIPS
            for axis, half in zip(self.nest.axes, self.nest.half, strict=True)
        )

    @property
    def alarm(self) -> int:
        """When it has done."""
        return self.until if self.phase == BUSY else NEVER

    def ring(self, site: Site, log: EventLog) -> None:
        """It has done."""
        time = self.until
        self._open(site.scene)
        self.phase = DONE
        part, did = site.parts.get(self.part), "has done with"
        if part is not None and self.press is not None:
            high = part.top - part.bottom
            if high > self.press + DIPS:
                _lower(part, self.press / high)
                did = "has pressed"
        self.tell(log, time, f"{did} {self.part}")

    def _open(self, scene: Scene) -> None:
        """Open the hood."""
        scene.take_away(self.thing)
        self.thing, self.until = "", NEVER

    def lit(self, key: str, seen: Seen) -> bool:
        """Whether it is busy, has done, or could not start."""
        return self.phase == key

    # The bench

    @property
    def obstacles(self) -> Sequence[Obstacle]:
        """The block under the nest, and the hood while it is closed."""
        block = () if self.block is None else (self.block,)
        return (*block, self.hood) if self.phase == BUSY else block

    def suit(self, settings: ArmSettings) -> None:
        """Take over the friction of the table."""
        self.rough = settings.table_friction

    def lay(self, scene: Scene) -> None:
        """Have the block stand."""
        if self.block is not None:
            stand(scene, self.block, self.rough)
        if self.phase == BUSY:
            self.thing = stand(scene, self.hood, self.rough).name

    def begin(self) -> None:
        """Whatever it did is over, and the hood is open."""
        self.phase, self.part, self.thing, self.until = IDLE, "", "", NEVER


def _lower(part: Part, factor: float) -> None:
    """Press a part that is at rest to so much of its height."""
    (x, y, z), bottom = part.place, part.bottom
    part.shape = flattened(part.shape, part.turn, factor)
    part.put((x, y, bottom + (z - bottom) * factor), part.turn)
    part.began = (part.place, part.upwards)
