"""The bench that the MiniMover 5 works on: a table, what stands on it, and how that falls.

The arm pushes, takes, carries and lets go of parts; the bench says what is in the way and puts
every part where a part can be: on something, inside nothing. Everything is computed at once and
in the same order every time; a fall takes no time.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace

from trs80arm.arm.events import EventKind
from trs80arm.arm.fixtures import Feeder, Obstacle, Part, Sensor, Tray, Turntable
from trs80arm.arm.model import Pose
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.shapes import (
    SKIN,
    UP,
    Box,
    Vector,
    common_ground,
    overlap,
    plus,
    surrounds,
    upright,
)

NUDGES = tuple(
    (r * math.cos(k * math.pi / 4), r * math.sin(k * math.pi / 4), 0.0)
    for r in (0.02, 0.05, 0.1, 0.2)
    for k in range(8)
)
"""Small shifts tried, in this order, when a part set upright would overlap its neighbour."""

SINK = 0.02
"""What a part may have sunk into what carries it, a part held aslant say, inches."""


class BenchError(Exception):
    """A bench that cannot be; one line naming the file, the key and what was expected."""


class Bench:
    """Table, parts and fixtures.

    Attributes:
        name: of the bench, for titles.
        settings: of the arm that works here.
        start: pose in which the arm is switched on, or None for the arm's own.
        parts: by name, in the order in which they came.
        feeders, trays, obstacles, sensors: as the file lists them.
        turntable: on the auxiliary latch, or None.
        news: what happened since the arm last asked, as (kind, text).
    """

    def __init__(self, name: str = "bench", settings: ArmSettings | None = None) -> None:
        self.name = name
        self.settings = settings or ArmSettings()
        self.start: Pose | None = None
        self.parts: dict[str, Part] = {}
        self.feeders: list[Feeder] = []
        self.trays: list[Tray] = []
        self.obstacles: list[Obstacle] = list(_own_base(self.settings))
        self.sensors: list[Sensor] = []
        self.turntable: Turntable | None = None
        self.news: list[tuple[EventKind, str]] = []
        self._beginning: list[Part] = []

    @classmethod
    def standard(cls) -> Bench:
        """The bench of an arm for which none was named: a table and one part.

        The part is of aluminium: an inch high, half an inch wide, 0.4 oz. It stands at (8, 0),
        Table 4's point A.
        """
        bench = cls("table")
        bench.add_part("block", (0.5, 0.5, 1.0), 0.4, 8.0, 0.0, 0.0)
        return bench

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
        """Put a part on the bench, exactly there.

        Args:
            name: unique.
            size: inches.
            weight: ounces.
            x: of its centre.
            y: of its centre.
            bottom: height of its base.
            turn: radians.
        """
        part = Part(name, size, weight, upright(x, y, bottom, size, turn))
        self.parts[name] = part
        return part

    def suit(self, settings: ArmSettings) -> None:
        """Take over the settings of the arm that works here: its base, and friction."""
        if settings == self.settings:
            return
        self.settings = settings
        self.obstacles[:2] = _own_base(settings)
        for part in self.parts.values():
            part.box = self._free(part.box, part)

    def remember(self) -> None:
        """Take the parts as they are for those to begin with, unless feeders have given any."""
        if not any(feeder.given for feeder in self.feeders):
            self._beginning = [replace(part, held=False) for part in self.parts.values()]

    def refill(self) -> None:
        """Put the parts back to where they were at the beginning, feeders and trays too."""
        self.parts = {part.name: replace(part) for part in self._beginning}
        for feeder in self.feeders:
            feeder.given = 0
        for tray in self.trays:
            tray.taken = 0

    # What is where

    def standing(self) -> Iterator[Part]:
        """Parts that nobody holds."""
        return (part for part in self.parts.values() if not part.held)

    @property
    def held(self) -> Part | None:
        """The part in the hand."""
        return next((part for part in self.parts.values() if part.held), None)

    def things(self, but: Part | None = None) -> Iterator[Box]:
        """All boxes that are in a part's way: obstacles, the arm's base, parts, but one."""
        for obstacle in self.obstacles:
            yield obstacle.box
        for part in self.parts.values():
            if part is not but:
                yield part.box

    def room_for(self, box: Box, but: Part | None = None) -> bool:
        """Whether a box overlaps neither the table nor anything but one part."""
        return box.bottom >= -SKIN and not any(overlap(box, other) for other in self.things(but))

    def support(self, box: Box, but: Part | None = None) -> tuple[float, list[Box]]:
        """What an upright box would come down on.

        Returns:
            Height of the highest tops below it, and the boxes that have them; 0 and none
            for the table.
        """
        height, under = 0.0, []
        for other in self.things(but):
            top = other.top
            if top > box.bottom + SINK or top < height - SKIN or not _above(box, other):
                continue
            if top > height + SKIN:
                height, under = top, [other]
            else:
                under.append(other)
        return height, under

    # How parts move

    def release(self, part: Part) -> None:
        """The hand lets go of a part: it rights itself, falls, and everything comes to rest."""
        before = part.box.bottom
        part.held = False
        self._right(part)
        self._fall(part)
        if part.name not in self.parts:
            return
        fell = before - part.box.bottom
        if fell > 0.25:
            self.news.append((EventKind.DROPPED, f"{part.name} fell {fell:.2f} in"))
        else:
            self.news.append((EventKind.PLACED, f"{part.name} set down"))
        self._deliver()
        self.settle()

    def settle(self) -> None:
        """Let everything fall that has lost what it stood on."""
        for _ in range(4 * len(self.parts) + 4):
            moved = False
            for part in sorted(self.standing(), key=lambda p: p.box.bottom):
                height, under = self.support(part.box, part)
                if abs(part.box.bottom - height) > 1e-6 or not _balanced(part.box, under):
                    self._fall(part)
                    moved = True
            self._deliver()
            if not moved:
                return

    def push(self, part: Part, by: Vector, height: float, depth: int = 4) -> bool:
        """Push a part aside.

        Args:
            part: standing on the bench.
            by: displacement, inches; its vertical component counts as none.
            height: at which it is pushed, inches above the table.
            depth: how many more parts it may push in turn.

        Returns:
            Whether it gave way; a part against something fixed does not.
        """
        by = (by[0], by[1], 0.0)
        length = math.hypot(by[0], by[1])
        friction = self.settings.table_friction
        if length < 1e-12:
            return False
        along = _side_along(part.box, by)
        if height - part.box.bottom > 2 * part.box.half[along] / (2 * friction):
            self._topple(part, by)
            self.settle()
            return True
        target = part.box.moved(by)
        riders = [p for p in self.standing() if p is not part and _rests_on(p.box, part.box)]
        for other in list(self.standing()):
            if other is not part and other not in riders and overlap(target, other.box):
                at = max(other.box.bottom, target.bottom)
                if depth == 0 or not self.push(other, by, at, depth - 1):
                    return False
                if other.name in self.parts and overlap(target, other.box):
                    return False
        if part.name not in self.parts or not self.room_for(target, part):
            return part.name not in self.parts
        part.box = target
        for rider in riders:
            moved = rider.box.moved(by)
            if rider.name in self.parts and self.room_for(moved, rider):
                rider.box = moved
        self.settle()
        return True

    def turn_table(self, rotor: int, free: Callable[[Box], bool]) -> bool:
        """Turn the turntable with all that stands on it.

        Args:
            rotor: half-steps to turn it to.
            free: whether the arm leaves room for a box.

        Returns:
            Whether it could; something in the way of a part on it, the arm included, blocks it.
        """
        table = self.turntable
        if table is None:
            return True
        angle = (rotor - table.rotor) * 2 * math.pi / table.steps
        carried = [part for part in self.standing() if table.under(part.box)]
        turned = [_turned(part.box, table.x, table.y, angle) for part in carried]
        others = [o.box for o in self.obstacles] + [
            part.box for part in self.parts.values() if part not in carried
        ]
        if any(overlap(box, other) for box in turned for other in others):
            return False
        if any(free(part.box) and not free(box) for part, box in zip(carried, turned, strict=True)):
            return False
        for part, box in zip(carried, turned, strict=True):
            part.box = box
        table.rotor = rotor
        return True

    def weight_on(self, part: Part) -> float:
        """Ounces of all that stands on a part, on one another too."""
        riders, found = [part], 0.0
        seen = {part.name}
        while riders:
            under = riders.pop()
            for other in self.standing():
                if other.name not in seen and _rests_on(other.box, under.box):
                    seen.add(other.name)
                    riders.append(other)
                    found += other.weight
        return found

    def bears(self, part: Part) -> bool:
        """Whether anything stands on a part."""
        return any(_rests_on(other.box, part.box) for other in self.standing())

    def waiting_feeders(self) -> list[Feeder]:
        """Feeders with a part to give and nothing standing at their place."""
        return [
            feeder for feeder in self.feeders if not feeder.empty and self.room_for(feeder.place)
        ]

    def feed(self, feeder: Feeder) -> Part:
        """Let a feeder give its next part."""
        feeder.given += 1
        name = f"{feeder.name} {feeder.given}"
        while name in self.parts:
            name += "'"
        self.news.append((EventKind.FED, f"{feeder.name} gives {name}"))
        return self.add_part(name, feeder.size, feeder.weight, feeder.x, feeder.y, 0.0, feeder.turn)

    # Falling

    def _right(self, part: Part) -> None:
        """Set a part upright on its nearest side, where there is room for it."""
        box = part.box
        vertical = max(range(3), key=lambda i: abs(box.axes[i][2]))
        first = (vertical + 1) % 3
        second = (vertical + 2) % 3
        axis = box.axes[first]
        turn = math.atan2(axis[1], axis[0])
        size = (2 * box.half[first], 2 * box.half[second], 2 * box.half[vertical])
        x, y, _ = box.center
        bottom = max(0.0, box.bottom)
        part.box = self._free(upright(x, y, bottom, size, turn), part)

    def _free(self, box: Box, part: Part) -> Box:
        """`box`, shifted a little, or lifted, to where it overlaps nothing."""
        if self.room_for(box, part):
            return box
        for nudge in NUDGES:
            if self.room_for(box.moved(nudge), part):
                return box.moved(nudge)
        while True:
            tops = [other.top for other in self.things(part) if overlap(box, other)]
            if not tops:
                return box
            box = box.moved((0.0, 0.0, max(tops) - box.bottom))

    def _fall(self, part: Part) -> None:
        """Let an upright part fall to what is below; off an edge it falls beside."""
        height, under = self.support(part.box, part)
        box = part.box.moved((0.0, 0.0, height - part.box.bottom))
        if not self.room_for(box, part):
            # A part held aslant is in the way although it is not below.
            box = self._free(box, part)
        part.box = box
        if not _balanced(box, under):
            points = [p for other in under for p in common_ground(box, other)]
            x = sum(p[0] for p in points) / len(points)
            y = sum(p[1] for p in points) / len(points)
            self._topple(part, (box.center[0] - x, box.center[1] - y, 0.0))

    def _topple(self, part: Part, way: Vector) -> None:
        """Lay a part on its side, beside where it stood, in the given direction."""
        length = math.hypot(way[0], way[1])
        way = (way[0] / length, way[1] / length, 0.0) if length > 1e-12 else (1.0, 0.0, 0.0)
        box = part.box
        along = _side_along(box, way)
        half = list(box.half)
        half[along], half[2] = half[2], half[along]
        first = box.center[2] - box.half[2]
        turn = math.atan2(box.axes[0][1], box.axes[0][0])
        size = (2 * half[0], 2 * half[1], 2 * half[2])
        start = box.half[along]
        self.news.append((EventKind.TOPPLED, f"{part.name} fell over"))
        for k in range(400):
            # Farther and farther, swinging out to both sides of the way it fell.
            swing = (0.0, 0.5, -0.5, 1.0, -1.0)[k % 5]
            reach = start + 0.1 * (k // 5)
            c, s = math.cos(swing), math.sin(swing)
            x = box.center[0] + reach * (way[0] * c - way[1] * s)
            y = box.center[1] + reach * (way[0] * s + way[1] * c)
            lying = upright(x, y, max(first, 0.0), size, turn)
            if not self.room_for(lying, part):
                continue
            height, under = self.support(lying, part)
            lying = upright(x, y, height, size, turn)
            if _balanced(lying, under) and self.room_for(lying, part):
                part.box = lying
                return
        # Beyond everything there is always room.
        far = max(other.center[0] + other.radius for other in self.things(part))
        part.box = upright(far + max(size), 0.0, 0.0, size, turn)

    def _deliver(self) -> None:
        """Trays take away what stands in them."""
        for tray in self.trays:
            for part in list(self.standing()):
                if tray.under(part.box):
                    tray.taken += 1
                    del self.parts[part.name]
                    self.news.append((EventKind.DELIVERED, f"{tray.name} takes {part.name}"))


def _own_base(settings: ArmSettings) -> Iterator[Obstacle]:
    """Base plate and body of the arm, which its own hand can run into."""
    length = settings.base_front + settings.base_rear
    middle = (settings.base_front - settings.base_rear) / 2
    plate = (length, settings.base_width, settings.base_height)
    yield Obstacle("base", upright(middle, 0.0, 0.0, plate, 0.0))
    side = 2 * settings.body_radius
    height = settings.body_top - settings.base_height
    yield Obstacle("body", upright(0.0, 0.0, settings.base_height, (side, side, height), 0.0))


def _above(box: Box, other: Box) -> bool:
    """Whether two upright boxes share ground, more than an edge."""
    dx, dy = box.center[0] - other.center[0], box.center[1] - other.center[1]
    reach = box.radius + other.radius
    if dx * dx + dy * dy > reach * reach:
        return False
    for axis in (*box.axes[:2], *other.axes[:2]):
        gap = abs(dx * axis[0] + dy * axis[1])
        for one in (box, other):
            gap -= sum(
                h * abs(a[0] * axis[0] + a[1] * axis[1])
                for h, a in zip(one.half[:2], one.axes[:2], strict=True)
            )
        if gap >= -SKIN:
            return False
    return True


def _rests_on(box: Box, other: Box) -> bool:
    """Whether one upright box stands on another."""
    return abs(box.bottom - other.top) < SINK and _above(box, other)


def _balanced(box: Box, under: list[Box]) -> bool:
    """Whether what is under a box holds up its middle; the table always does."""
    if not under:
        return True
    points = [point for other in under for point in common_ground(box, other)]
    if not points:
        return True
    return surrounds(points, box.center[0], box.center[1])


def _side_along(box: Box, way: Vector) -> int:
    """Which of an upright box's two horizontal axes is nearer to a direction."""
    u, v = box.axes[0], box.axes[1]
    across = abs(u[0] * way[0] + u[1] * way[1]) < abs(v[0] * way[0] + v[1] * way[1])
    return 1 if across else 0


def _turned(box: Box, x: float, y: float, angle: float) -> Box:
    """A box turned about a vertical axis through (x, y)."""
    c, s = math.cos(angle), math.sin(angle)
    dx, dy = box.center[0] - x, box.center[1] - y

    def turn(a: Vector) -> Vector:
        return (c * a[0] - s * a[1], s * a[0] + c * a[1], a[2])

    center = plus((x, y, box.center[2]), (c * dx - s * dy, s * dx + c * dy, 0.0))
    return Box(center, (turn(box.axes[0]), turn(box.axes[1]), UP), box.half)
