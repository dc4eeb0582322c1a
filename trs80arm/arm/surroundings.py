"""How far the arm, with what it carries, is from everything: bounds that spare it being looked at.

Inches, and inches that a unit of each coordinate moves anything of the arm at most. Nothing here
decides what happens: only whether it is certain that nothing does.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from trs80arm.arm.bench import Bench
from trs80arm.arm.contact.distance import boxes_apart, distance, separation
from trs80arm.arm.contact.manifold import Placed
from trs80arm.arm.contact.rotations import apply
from trs80arm.arm.course import Course, Floats, beyond, in_a_row
from trs80arm.arm.linkage import FINGERS, ArmLinkage
from trs80arm.arm.model import Link, Motor
from trs80arm.arm.rings import Ring, around, link_slices, rolled_slices
from trs80arm.arm.shapes import Vector, length, plus
from trs80arm.arm.trigonometry import sin_cos

FAR = 100.0
"""More inches than there are."""
NEAR = 0.001
"""Inches from which on contact with anything but the table is looked at."""
HAIR = 1e-9
"""Inches below the table that are not below it."""
SPARE = 1e-6
"""Inches by which bounds are taken too narrow."""
AXES = 6
"""Ways along which two solids are seen apart in turn, at most."""


@dataclass(frozen=True, slots=True)
class Room:
    """What room the arm has somewhere.

    Attributes:
        beside: inches to anything but the table, less those at which contact is looked at.
        low: height of the lowest point of the arm and what it carries, inches.
    """

    beside: float
    low: float

    @property
    def enough(self) -> bool:
        """Whether contact need not be looked at."""
        return self.beside >= 0.0 and self.low >= -HAIR


class Surroundings:
    """What is around an arm, and how far."""

    def __init__(self, bench: Bench, linkage: ArmLinkage) -> None:
        self._bench = bench
        self._linkage = linkage
        self._levers: tuple[float, ...] = ()
        self._load: list[object] = []

    def __getstate__(self) -> dict[str, object]:
        return {**self.__dict__, "_levers": (), "_load": []}

    def levers(self) -> tuple[float, ...]:
        """Inches that anything of arm and load goes for a unit of each coordinate, at most."""
        load: list[object] = [(load.name, load.carried) for load in self._bench.scene.carried]
        if not self._levers or self._load != load:
            self._levers, self._load = self._longest_levers(), load
        return self._levers

    def _longest_levers(self) -> tuple[float, ...]:
        model = self._linkage.model
        ahead, aside = self.extent(model.hand.range)
        out = length(ahead, aside)
        swung = max(
            length(abs(solid.center[0]) + solid.half[0], solid.half[2])
            for solid in model.solids
            if solid.link in (Link.UPPER_ARM, Link.FOREARM)
        )
        wide = max(solid.half[1] for solid in model.solids)
        levers = {
            Motor.BASE: length(2 * swung, wide) + out,
            Motor.SHOULDER: swung,
            Motor.ELBOW: swung,
            # A gear turns pitch and roll by half as much.
            Motor.LEFT_WRIST: (out + aside) / 2,
            Motor.RIGHT_WRIST: (out + aside) / 2,
            Motor.HAND: 0.5,
        }
        return tuple(levers[motor] for motor in Motor)

    def ways(self, turned: Sequence[float]) -> list[float]:
        """Inches that any point of arm and load goes at most.

        Args:
            turned: how far each coordinate goes, radians, and inches of the opening.

        Returns:
            By coordinate.
        """
        return [lever * abs(by) for lever, by in zip(self.levers(), turned, strict=True)]

    def travel(self, before: Sequence[float], after: Sequence[float]) -> tuple[float, float]:
        """Inches that any point of arm and load goes at most between two places, and goes down."""
        a, b, c, d, e, f = self.levers()
        down = (
            b * abs(after[1] - before[1])
            + c * abs(after[2] - before[2])
            + d * abs(after[3] - before[3])
            + e * abs(after[4] - before[4])
            + f * abs(after[5] - before[5])
        )
        return down + a * abs(after[0] - before[0]), down

    def extent(self, opening: float) -> tuple[float, float]:
        """How far hand, fingers and load reach from the wrist, ahead and to any side, inches."""
        ahead, aside = self._linkage.model.hand_length, 0.0
        for solid in self._linkage.model.solids:
            _, wide, thick = (
                abs(at) + half for at, half in zip(solid.center, solid.half, strict=True)
            )
            if solid.link in FINGERS:
                aside = max(aside, length(wide + opening / 2, thick))
            elif solid.link is Link.HAND:
                aside = max(aside, length(wide, thick))
        for load in self._bench.scene.carried:
            assert load.carried is not None
            place, turn = load.carried
            for corner in (each for part in load.shape.solids for each in part.vertices):
                x, y, z = plus(place, apply(turn, corner))
                ahead, aside = max(ahead, abs(x)), max(aside, length(y, z))
        return ahead, aside

    def measured(self, joints: Sequence[float]) -> Room:
        """How far the arm and what it carries would be from all else.

        Args:
            joints: the arm's six coordinates.
        """
        scene = self._bench.scene
        mine = self._linkage.standing(joints, scene.carried)
        least = FAR
        for thing in scene.fixed.values():
            for other in thing.placed:
                for name, solid in mine:
                    if name not in thing.passes:
                        least = _nearer(solid, other, least)
        for body in scene.bodies.values():
            if body.carried is not None:
                continue
            for other in body.placed:
                for _, solid in mine:
                    least = _nearer(solid, other, least)
        return Room(least - NEAR, min(solid.low[2] for _, solid in mine))

    def places_clear(self, joints: Floats) -> int:
        """At how many of some places in a row the arm has room, with what it carries.

        Seen along the way in which a solid is beyond another, rather than by how far it goes: what
        goes past something close by is no nearer to it.

        Args:
            joints: the arm's six coordinates, 6 x places.
        """
        scene = self._bench.scene
        course = Course(self._linkage, joints, scene.carried)
        count = len(joints[0])
        names = self._linkage.names
        for k in range(len(course)):
            low, high = course.box(k)
            if low[2] < -HAIR / 2:
                count = in_a_row(course.corners(k)[2, :count].min(axis=1) >= -HAIR / 2)
            (a, b, c), (d, e, f) = low.tolist(), high.tolist()
            reach = (a - NEAR, b - NEAR, c - NEAR), (d + NEAR, e + NEAR, f + NEAR)
            for other in self._near(reach, names[k] if k < len(names) else ""):
                if not count:
                    return 0
                count = _clear_of(course.corners(k)[:, :count], other)
        return count

    def _near(self, around: tuple[Vector, Vector], name: str) -> Iterator[Placed]:
        """What is in or about an upright box, and can touch a link (or what is carried)."""
        (a, b, c), (d, e, f) = around
        scene = self._bench.scene
        solids = [
            solid
            for thing in scene.fixed.values()
            if name not in thing.passes
            for solid in thing.placed
        ]
        for body in scene.sleepers(*around):
            solids += body.placed
        for solid in solids:
            (u, v, w), (x, y, z) = solid.low, solid.high
            if a <= x and u <= d and b <= y and v <= e and c <= z and w <= f:
                yield solid

    def over_rings(self, opening: float) -> float:
        """How far all is from the arm wherever the base turns, as it was on the last tick.

        Args:
            opening: of the hand, inches.
        """
        scene = self._bench.scene
        s, c = sin_cos(scene.joints[0])
        arm = scene.link_solids[:2]
        mine = [ring for solid in arm for ring in link_slices(solid, c, s)]
        joined = len(mine)
        mine += self._hand_rings(c, s, opening)
        least = min(each.low for each in mine)
        # Base and body are joined to the arm's first links, and always behind a line across it.
        for thing in scene.fixed.values():
            for solid in thing.placed:
                if thing.passes:
                    ahead = max(length(x, y) for x, y, _ in solid.vertices if x >= 0)
                    behind = max(length(x, y) for x, y, _ in solid.vertices)
                    ring = Ring(-behind, ahead, solid.low[2], solid.high[2])
                    least = min(least, *(each.apart(ring) for each in mine[joined:]))
                else:
                    ring = around(solid)
                    least = min(least, *(each.apart(ring) for each in mine))
        for body in scene.bodies.values():
            if body.carried is None:
                x, y, z = body.place
                out, reach = length(x, y), body.shape.radius
                ring = Ring(out - reach, out + reach, z - reach, z + reach)
                if all(each.apart(ring) > least for each in mine):
                    continue
                for solid in body.placed:
                    ring = around(solid)
                    least = min(least, *(each.apart(ring) for each in mine))
        return least - NEAR

    def _hand_rings(self, c: float, s: float, opening: float) -> list[Ring]:
        """Hand and load cut across, rolled about the hand's axis however they may be."""
        frame = self._bench.scene.links[self._linkage.hand]
        ahead, aside = self.extent(opening)
        way = (frame.turn[0], frame.turn[3], frame.turn[6])
        return rolled_slices(frame.place, way, ahead, aside, c, s)


def _clear_of(corners: Floats, other: Placed) -> int:
    """At how many places in a row a solid is clear of another that stands.

    Args:
        corners: of the solid, 3 x places x corners.
        other: what stands.
    """
    low, high = corners.min(axis=2), corners.max(axis=2)
    gaps = np.maximum(low - np.array(other.high)[:, None], np.array(other.low)[:, None] - high).max(
        axis=0
    )
    clear = gaps >= NEAR + SPARE
    count = in_a_row(clear)
    for _ in range(AXES):
        if count == len(clear):
            break
        here = [(x, y, z) for x, y, z in corners[:, count].T.tolist()]
        out, way = separation(here, other.vertices)
        if out < NEAR:
            break
        clear[count:] |= beyond(corners[:, count:], other.vertices, way) >= NEAR + SPARE
        if not clear[count]:
            break
        count = in_a_row(clear)
    return count


def _nearer(solid: Placed, other: Placed, least: float) -> float:
    """`least`, or the distance of two solids if that is less."""
    if boxes_apart(solid, other) >= least:
        return least
    return min(least, distance(solid, other))
