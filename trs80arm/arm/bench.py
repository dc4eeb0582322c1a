"""The bench that an arm works on: a table, what stands on it, feeders, trays, sensors.

What parts do, on their own or under the arm, is `contact`'s; here they are put on the bench and
taken from it. Everything is computed in the same order every time.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from trs80arm.arm.cell.device import stand
from trs80arm.arm.cell.home import HomeSwitch
from trs80arm.arm.cell.inputs import Answering, Selector
from trs80arm.arm.cell.work_cell import WorkCell
from trs80arm.arm.contact.bodies import Shape
from trs80arm.arm.contact.forms import standing
from trs80arm.arm.contact.manifold import Placed, between
from trs80arm.arm.contact.rotations import (
    STRAIGHT,
    Quaternion,
    apply,
    matrix,
    oriented,
)
from trs80arm.arm.contact.scene import Scene
from trs80arm.arm.contact.solids import Solid, box
from trs80arm.arm.contact.table import TABLE
from trs80arm.arm.events import EventKind
from trs80arm.arm.fixtures import Feeder, Obstacle, Part, Tray
from trs80arm.arm.goals import Goal, Score, score
from trs80arm.arm.linkage import link_name, said
from trs80arm.arm.model import Pose
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.shapes import SKIN, Box, Vector, plus, upright

LONGEST_FALL = 4000
"""Ticks after which a bench that is set up is taken to be at rest: 18 seconds."""


class BenchError(Exception):
    """A bench that cannot be; one line naming the file, the key and what was expected."""


class Bench:
    """Table, parts and fixtures.

    Attributes:
        name: of the bench, for titles.
        settings: of the arm that works here.
        start: pose in which the arm is switched on, or None for the arm's own.
        scene: the parts in contact.
        feeders, trays, obstacles: as the file lists them.
        sensors: what is on the free bits of the input nibble.
        selector: of the banks in which they are seen, or None.
        cell: the devices on the auxiliary latch.
        goals: what shall be where at the end.
        beginning: the parts as they stand at the beginning, all at rest.
        news: what happened since the arm last asked, as (kind, text).
    """

    def __init__(self, name: str = "bench", settings: ArmSettings | None = None) -> None:
        self.name = name
        self.settings = settings or ArmSettings()
        self.start: Pose | None = None
        self.scene = Scene(self.settings.table_friction)
        self.feeders: list[Feeder] = []
        self.trays: list[Tray] = []
        self.obstacles: list[Obstacle] = list(_own_base(self.settings))
        self.sensors: list[Answering] = []
        self.selector: Selector | None = None
        self.cell = WorkCell()
        self.goals: list[Goal] = []
        self.news: list[tuple[EventKind, str]] = []
        self.beginning: list[Part] = []

    @classmethod
    def standard(cls) -> Bench:
        """The bench of an arm for which none was named: a table and one part.

        The part is of aluminium: an inch high, half an inch wide, 0.4 oz. It stands at (8, 0),
        Table 4's point A.
        """
        bench = cls("table")
        bench.add_part("block", (0.5, 0.5, 1.0), 0.4, 8.0, 0.0, 0.0)
        return bench

    @property
    def homes(self) -> list[HomeSwitch]:
        """The home switches among the sensors."""
        return [sensor for sensor in self.sensors if isinstance(sensor, HomeSwitch)]

    @property
    def parts(self) -> dict[str, Part]:
        """By name, in the order in which they came."""
        return self.scene.bodies  # type: ignore[return-value]  # It has no others.

    def add_part(
        self,
        name: str,
        size: Vector,
        weight: float,
        x: float,
        y: float,
        bottom: float = 0.0,
        turn: float = 0.0,
    ) -> Part:
        """Put a box on the bench, exactly there.

        Args:
            name: unique.
            size: inches.
            weight: ounces.
            x: of its centre.
            y: of its centre.
            bottom: height of its base.
            turn: radians.
        """
        turned = oriented(math.degrees(turn))
        part = self.make((box(size),), name, weight, x, y, bottom, turned)
        self.scene.add(part)
        return part

    def make(
        self,
        solids: Sequence[Solid],
        name: str,
        weight: float,
        x: float,
        y: float,
        bottom: float = 0.0,
        turn: Quaternion = STRAIGHT,
        friction: float | None = None,
    ) -> Part:
        """A part of any shape, not yet on the bench.

        Args:
            solids: that make it up.
            name: unique.
            weight: ounces.
            x: of the middle of its description.
            y: of the middle of its description.
            bottom: height of its lowest point.
            turn: how it lies.
            friction: coefficient of its surface; the table's unless given.
        """
        return self._make(Shape.of(solids, weight), name, x, y, bottom, turn, friction)

    def _make(
        self,
        shape: Shape,
        name: str,
        x: float,
        y: float,
        bottom: float,
        turn: Quaternion,
        friction: float | None,
    ) -> Part:
        rough = self.settings.table_friction if friction is None else friction
        return Part(name, shape, rough, *standing(shape, x, y, bottom, turn))

    def suit(self, settings: ArmSettings) -> None:
        """Take over the settings of the arm that works here: its base, and friction."""
        if settings == self.settings:
            return
        for part in self.parts.values():
            if part.friction == self.settings.table_friction:
                part.friction = settings.table_friction
        self.settings = settings
        self.scene.table_friction = settings.table_friction
        self.obstacles[:2] = _own_base(settings)

    def remember(self) -> None:
        """Take the parts as they are for those to begin with, unless feeders have given any."""
        if not any(feeder.given for feeder in self.feeders):
            self.beginning = [replace(part, held=False) for part in self.parts.values()]

    def refill(self) -> None:
        """Put the parts back to where they were at the beginning, feeders and trays too."""
        self.cell.begin()
        self.scene.clear()
        for part in self.beginning:
            self.scene.add(replace(part))
        for feeder in self.feeders:
            feeder.given = 0
        for tray in self.trays:
            tray.taken = 0

    def score(self) -> Score:
        """How well the goals are done as the parts are now."""
        return score(self.goals, self.parts, self.trays)

    # What is where

    def lay(self) -> None:
        """Have the obstacles and the devices stand where they are."""
        own = tuple(link_name(solid.name) for solid in self.settings.arm_model.solids[:2])
        self.scene.fixed = {}
        for number, obstacle in enumerate(self.obstacles):
            # Upper arm and forearm are joined to base and body.
            passes = own if number < len(_OWN) else ()
            stand(self.scene, obstacle, self.settings.table_friction, passes)
        self.scene.plates = []
        self.cell.lay(self.scene)

    def room_for(self, solids: Sequence[Placed]) -> bool:
        """Whether solids are in neither the table nor anything that stands there."""
        return not any(solid.low[2] < -SKIN for solid in solids) and self.found_at(solids) is None

    def found_at(self, solids: Sequence[Placed]) -> str | None:
        """Name of an obstacle or part, the one in the hand left out, that some solids are in."""
        for obstacle in (*self.obstacles, *self.cell.obstacles):
            if any(deep(mine, other) for mine in solids for other in obstacle.placed):
                return obstacle.name
        for part in self.parts.values():
            if not part.held and any(deep(mine, other) for mine in solids for other in part.placed):
                return part.name
        return None

    def in_the_way(self, solids: Sequence[Placed], but: str = "") -> str | None:
        """Name of anything that some solids are in, the arm and what it holds included.

        Args:
            solids: where they are to stand.
            but: name of a part that does not matter.
        """
        links = zip(self.scene.driven.names, self.scene.link_solids, strict=True)
        there = [(said(name), [solid]) for name, solid in links]
        there += [(each.name, each.placed) for each in (*self.obstacles, *self.cell.obstacles)]
        there += [(part.name, part.placed) for part in self.parts.values() if part.name != but]
        for name, theirs in there:
            if any(deep(mine, other) for mine in solids for other in theirs):
                return name
        return None

    # How parts come, rest and go

    def settle(self) -> None:
        """Let everything fall that has lost what it stood on; it takes no time on the clock."""
        self.lay()
        scene = self.scene
        for part in self.parts.values():
            if part.carried is None:
                part.asleep, part.still, part.touching = False, 0, ()
        time = scene.time
        for _ in range(LONGEST_FALL):
            if scene.quiet:
                break
            scene.tick()
        scene.time = time
        for part in self.parts.values():
            part.began = (part.place, part.upwards)
        self.deliver()

    def deliver(self) -> None:
        """Trays take away what has come to rest in them."""
        for tray in self.trays:
            for part in list(self.parts.values()):
                if not part.asleep or part.held or part.carried is not None:
                    continue
                if tray.under(part):
                    tray.taken += 1
                    self.scene.remove(part.name)
                    self.news.append((EventKind.DELIVERED, f"{tray.name} takes {part.name}"))

    def waiting_feeders(self) -> list[Feeder]:
        """Feeders with a part to give, and nothing at their place but what the hand holds."""
        return [
            feeder
            for feeder in self.feeders
            if not (feeder.empty or feeder.commanded) and self.found_at(feeder.placed) is None
        ]

    def feed(self, feeder: Feeder) -> Part:
        """Let a feeder give its next part; it stands there."""
        feeder.given += 1
        name = f"{feeder.name} {feeder.given}"
        while name in self.parts:
            name += "'"
        self.news.append((EventKind.FED, f"{feeder.name} gives {name}"))
        turn = oriented(math.degrees(feeder.turn))
        place = feeder.x, feeder.y, feeder.bottom
        part = self._make(feeder.shape, name, *place, turn, feeder.friction)
        self.scene.add(part)
        if not feeder.bottom:
            part.asleep, part.touching = True, (TABLE,)
        part.began = (part.place, part.upwards)
        return part


def obstacle(
    name: str, solids: Sequence[Solid], x: float, y: float, bottom: float, turn: Quaternion
) -> Obstacle:
    """An obstacle of any shape; the arguments are those of `Bench.make`."""
    m = matrix(turn)
    low = min(apply(m, corner)[2] for solid in solids for corner in solid.vertices)
    (a, b, c), (d, e, f) = extremes(solids)
    axes = (m[0], m[3], m[6]), (m[1], m[4], m[7]), (m[2], m[5], m[8])
    middle = apply(m, ((a + d) / 2, (b + e) / 2, (c + f) / 2))
    at = (x, y, bottom - low)
    half = ((d - a) / 2, (e - b) / 2, (f - c) / 2)
    stand = tuple(solid.moved((0.0, 0.0, 0.0), turn).moved(at) for solid in solids)
    return Obstacle(name, Box(plus(at, middle), axes, half), stand)


def extremes(solids: Sequence[Solid]) -> tuple[Vector, Vector]:
    """Least and greatest x, y, z of some solids."""
    xs, ys, zs = zip(*(corner for solid in solids for corner in solid.vertices), strict=True)
    return (min(xs), min(ys), min(zs)), (max(xs), max(ys), max(zs))


def around(solids: Sequence[Solid]) -> Vector:
    """Size of the box around some solids."""
    (a, b, c), (d, e, f) = extremes(solids)
    return d - a, e - b, f - c


def deep(one: Placed, other: Placed, depth: float = SKIN) -> bool:
    """Whether two solids are in each other by more than a depth (inches)."""
    if not one.near(other, -depth):
        return False
    met = between(one, other, 0.0)
    return met is not None and min(gap for _, gap in met.points) < -depth


_OWN = ("base", "body")
"""What of the arm stands on the table."""


def _own_base(settings: ArmSettings) -> Iterator[Obstacle]:
    """Base plate and body of the arm, which its own hand can run into."""
    length = settings.base_front + settings.base_rear
    middle = (settings.base_front - settings.base_rear) / 2
    plate = (length, settings.base_width, settings.base_height)
    base, body = _OWN
    yield Obstacle(base, upright(middle, 0.0, 0.0, plate, 0.0))
    side = 2 * settings.body_radius
    height = settings.body_top - settings.base_height
    yield Obstacle(body, upright(0.0, 0.0, settings.base_height, (side, side, height), 0.0))
