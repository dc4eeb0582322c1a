"""A conveyor: a belt on a frame, which carries by friction what lies on it.

One output bit runs it, a second may turn it round. It comes to its speed, and to a stand, in the
time of its ramp; so what stands on it need not slide, if friction is enough for that.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import ClassVar

from trs80arm.arm.cell.device import Device, Site, stand
from trs80arm.arm.contact.bodies import Body
from trs80arm.arm.contact.clock import T_STATES_PER_SECOND
from trs80arm.arm.contact.scene import Scene
from trs80arm.arm.event_log import EventLog
from trs80arm.arm.fixtures import Obstacle
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.shapes import Vector


@dataclass
class Conveyor(Device):
    """A belt.

    Attributes:
        name: of it.
        frame: what stands; the belt is its upper side and runs along its first axis.
        speed: inches a second.
        ramp: seconds from a stand to that.
        run: bit that runs it while it is 1.
        reverse: bit that turns it round while it is 1, or None.
        friction: coefficient of the belt; the table's unless given.
        goal: speed that it goes to, inches a second, negative when turned round.
        since: T-state at which it was told.
        start: speed that it had then.
        way: inches that it had gone then, backwards counting less.
        seen: speed that contact knows of.
        rough: coefficient of the belt, as it is.
    """

    kind: ClassVar[str] = "conveyor"

    name: str
    frame: Obstacle
    speed: float
    ramp: float
    run: int
    reverse: int | None = None
    friction: float | None = None
    goal: float = 0.0
    since: int = 0
    start: float = 0.0
    way: float = 0.0
    seen: float = 0.0
    rough: float = 0.5
    thing: str = ""
    """What it is called among the things that touch."""

    @property
    def wires(self) -> Mapping[str, int]:
        """The bits that run it and turn it round."""
        return {"run": self.run} | ({} if self.reverse is None else {"reverse": self.reverse})

    @property
    def state(self) -> str:
        """Whether it runs, and which way."""
        return "stands" if not self.goal else "runs" if self.goal > 0 else "runs back"

    @property
    def possible(self) -> bool:
        """Whether it can be."""
        return super().possible and self.speed > 0 and self.ramp > 0

    # How it runs

    def velocity(self, time: int) -> float:
        """Inches a second at a T-state not before it was last told otherwise."""
        change = self.goal - self.start
        seconds = (time - self.since) / T_STATES_PER_SECOND
        gained = self.speed / self.ramp * seconds
        if gained >= abs(change):
            return self.goal
        return self.start + (gained if change > 0 else -gained)

    def gone(self, time: int) -> float:
        """Inches that the belt has gone by then."""
        change = self.goal - self.start
        seconds = (time - self.since) / T_STATES_PER_SECOND
        lasts = abs(change) / self.speed * self.ramp
        on = min(seconds, lasts)
        return (
            self.way
            + (self.start + self.velocity(time)) / 2 * on
            + self.goal * max(0.0, seconds - lasts)
        )

    def _wanted(self, nibble: int) -> float:
        """The speed that a nibble in the latch asks for."""
        if not nibble >> self.run & 1:
            return 0.0
        back = self.reverse is not None and nibble >> self.reverse & 1
        return -self.speed if back else self.speed

    def connect(self, nibble: int) -> None:
        """Run as the latch has it, at once."""
        self.goal = self.start = self._wanted(nibble)

    def write(self, time: int, before: int, nibble: int, site: Site, log: EventLog) -> None:
        """Start, stop or turn round."""
        goal = self._wanted(nibble)
        if goal == self.goal:
            return
        self.tell(log, time, "stopped" if not goal else "turned round" if self.goal else "started")
        self.way, self.start = self.gone(time), self.velocity(time)
        self.goal, self.since = goal, time

    # The bench

    @property
    def obstacles(self) -> Sequence[Obstacle]:
        """Frame and belt."""
        return (self.frame,)

    def suit(self, settings: ArmSettings) -> None:
        """Take over the friction of the table, unless the belt has its own."""
        self.rough = settings.table_friction if self.friction is None else self.friction

    def lay(self, scene: Scene) -> None:
        """Have the frame stand, its belt at rest."""
        self.thing = stand(scene, self.frame, self.rough).name
        self.seen = 0.0

    def carries(self, body: Body) -> bool:
        """Whether a body lies on the belt, or against its frame."""
        return self.thing in body.touching

    # Time

    @property
    def stands(self) -> bool:
        """Whether contact knows the speed that it goes to."""
        return self.seen == self.goal

    def drive(self, scene: Scene) -> None:
        """Have the belt carry what lies on it, at the speed that it has at the end of the tick."""
        self.seen = self.velocity(scene.due)
        x, y, _ = self.frame.box.axes[0]
        velocity: Vector = (self.seen * x, self.seen * y, 0.0)
        scene.carry(self.thing, velocity)
