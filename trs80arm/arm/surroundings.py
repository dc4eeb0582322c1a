"""How far the arm, with what it carries, is from everything: bounds that spare it being looked at.

Inches, and inches that a unit of each coordinate moves anything of the arm at most. Nothing here
decides what happens: only whether it is certain that nothing does.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from trs80arm.arm.bench import Bench
from trs80arm.arm.contact.bodies import Fixed
from trs80arm.arm.contact.carrying import load_at
from trs80arm.arm.contact.distance import boxes_apart, distance, separation
from trs80arm.arm.contact.manifold import Placed
from trs80arm.arm.contact.recurrence import Recurrence, question
from trs80arm.arm.contact.rotations import apply
from trs80arm.arm.course import Course, Floats, beyond, in_a_row
from trs80arm.arm.linkage import FINGERS, ArmLinkage
from trs80arm.arm.model import Link, Motor
from trs80arm.arm.shapes import Vector, length, plus
from trs80arm.arm.sweep import Extents, Ranges, Sweep

FAR = 100.0
"""More inches than there are."""
NEAR = 0.001
"""Inches from which on contact with anything but the table is looked at."""
HAIR = 1e-9
"""Inches below the table that are not below it."""
SPARE = 1e-6
"""Inches by which bounds are taken too narrow."""
FINGER = 0.5
"""Inches that a finger goes for an inch of the opening."""
GAP = NEAR + SPARE
"""Inches from which on something is surely not looked at."""
SWEPT = 256
"""Motions known of which it was found what they sweep over."""
MEASURED = 512
"""Places of the arm of which it is known what room it has there."""
BESIDE = 8
"""Sleepers by each of these motions of which it is known what comes near them."""
AXES = 6
"""Ways along which two solids are seen apart in turn, at most."""


class Room(NamedTuple):
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


Near = tuple[int, Placed | None]
"""A piece of the arm or of its load, by its number in `Extents`, and what it may come near: a solid
that stands, or the table where it is None."""


class Swept(NamedTuple):
    """What a motion of the arm sweeps over, known until something stands elsewhere.

    Attributes:
        sweep: itself.
        around: an upright box about it.
        near: what of what stands fast it comes near to, and the table.
        pieces: what comes near to solids that sleep, by what these are and where.
    """

    sweep: Sweep
    around: tuple[Vector, Vector]
    near: Sequence[Near]
    pieces: Recurrence[Sequence[int]]

    def pieces_near(self, solid: Placed) -> Sequence[int]:
        """Which pieces of the arm come near to a solid that sleeps."""
        known = self.pieces.get(solid.told)
        if known is None:
            known = self.pieces.keep(solid.told, self.sweep.pieces_near(solid, (), GAP))
        return known


@dataclass(slots=True)
class _Mine:
    """What follows from the shape of the arm and of its load.

    Attributes:
        load: what is carried, and where in the hand.
        extents: the boxes that it is made of.
        levers: inches that anything goes for a unit of each coordinate, at most; None as long as
            nobody has asked.
    """

    load: list[object]
    extents: Extents
    levers: tuple[float, ...] | None = None


class Surroundings:
    """What is around an arm, and how far."""

    def __init__(self, bench: Bench, linkage: ArmLinkage) -> None:
        self._bench = bench
        self._linkage = linkage
        self._empty: _Mine | None = None
        self._mine: _Mine | None = None
        self._swept: Recurrence[Swept] = Recurrence(SWEPT)
        self._measured: Recurrence[Room] = Recurrence(MEASURED)
        self._stands: list[Fixed] = []

    def __getstate__(self) -> dict[str, object]:
        again: dict[str, object] = {
            "_empty": None,
            "_mine": None,
            "_swept": Recurrence(SWEPT),
            "_measured": Recurrence(MEASURED),
            "_stands": [],
        }
        return {**self.__dict__, **again}

    def _arm(self) -> _Mine:
        """The arm with what it carries now."""
        carried = self._bench.scene.carried
        known = self._mine if carried else self._empty
        load: list[object] = [(load.name, load.carried) for load in carried]
        if known is None or known.load != load:
            known = _Mine(load, Extents(self._linkage.model, self._linkage.names, carried))
            if carried:
                self._mine = known
            else:
                self._empty = known
        return known

    def _levers(self) -> tuple[float, ...]:
        mine = self._arm()
        if mine.levers is None:
            mine.levers = self._longest_levers()
        return mine.levers

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
            Motor.HAND: FINGER,
        }
        return tuple(levers[motor] for motor in Motor)

    def travel(self, before: Sequence[float], after: Sequence[float]) -> tuple[float, float]:
        """Inches that any point of arm and load goes at most between two places, and goes down."""
        a, b, c, d, e, f = self._levers()
        down = (
            b * abs(after[1] - before[1])
            + c * abs(after[2] - before[2])
            + d * abs(after[3] - before[3])
            + e * abs(after[4] - before[4])
            + f * abs(after[5] - before[5])
        )
        return down + a * abs(after[0] - before[0]), down

    def travels(self, before: Sequence[float], joints: Floats) -> Floats:
        """`travel` from one place to many, 6 x places."""
        gone = np.abs(joints - np.array(before)[:, None])
        ways: Floats = (np.array(self._levers())[:, None] * gone).sum(axis=0)
        return ways

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

    def measured(self, joints: Sequence[float], near: Sequence[Near] | None = None) -> Room:
        """How far the arm and what it carries would be from all else.

        Args:
            joints: the arm's six coordinates.
            near: what alone may be near what there; None where that is not known.
        """
        scene = self._bench.scene
        if near is not None:
            # Of a load nothing else matters but where it is in the hand.
            loads = [(load.form, load.carried) for load in scene.carried]
            about = [(piece, None if solid is None else solid.told) for piece, solid in near]
            asked = question(joints, loads, about)
            known = self._measured.get(asked)
            return known or self._measured.keep(asked, self._measured_of(joints, near))
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

    def _measured_of(self, joints: Sequence[float], near: Sequence[Near]) -> Room:
        """`measured` of a few, all others being far."""
        scene = self._bench.scene
        there, carried = scene.driven.at(list(joints)), scene.carried
        links = len(there.links)
        loads: dict[int, list[Placed]] = {}
        least = low = FAR
        for piece, other in near:
            if piece < links:
                solids = [there.solids[piece]]
            else:
                if piece not in loads:
                    loads[piece] = load_at(carried[piece - links], there.links[self._linkage.hand])
                solids = loads[piece]
            for solid in solids:
                if other is None:
                    low = min(low, solid.low[2])
                else:
                    least = _nearer(solid, other, least)
        return Room(least - NEAR, low)

    def near(self, ranges: Ranges) -> list[Near]:
        """What the arm, with what it carries, may come near on its way: nothing if it has room.

        Args:
            ranges: between which its joints stay.
        """
        swept = self._sweep(ranges)
        found = list(swept.near)
        for body in self._bench.scene.sleepers(*swept.around):
            for solid in body.placed:
                found += [(piece, solid) for piece in swept.pieces_near(solid)]
        return found

    def _sweep(self, ranges: Ranges) -> Swept:
        """What is swept over, and what of what stands fast is near it."""
        extents, stands = self._arm().extents, list(self._bench.scene.fixed.values())
        if stands != self._stands:
            self._swept, self._stands = Recurrence(SWEPT), stands
        asked = question(ranges.numbers, extents.key)
        known = self._swept.get(asked)
        if known is not None:
            return known
        sweep = Sweep(extents, ranges)
        found: list[Near] = [(piece, None) for piece in sweep.pieces_below(-HAIR / 2)]
        for thing in stands:
            for solid in thing.placed:
                pieces = sweep.pieces_near(solid, thing.passes, GAP)
                found += [(piece, solid) for piece in pieces]
        known = Swept(sweep, sweep.around(GAP), found, Recurrence(BESIDE))
        return self._swept.keep(asked, known)

    def places_clear(self, joints: Floats, near: Sequence[Near]) -> int:
        """At how many of some places in a row the arm has room, with what it carries.

        Seen along the way in which a solid is beyond another, rather than by how far it goes: what
        goes past something close by is no nearer to it.

        Args:
            joints: the arm's six coordinates, 6 x places.
            near: what alone may be near what there.
        """
        course = Course(self._linkage, joints, self._bench.scene.carried)
        count = len(joints[0])
        for piece, other in near:
            if other is None:
                for heights in course.heights(piece):
                    count = in_a_row(heights[:count].min(axis=1) >= -HAIR / 2)
                continue
            for corners in course.corners(piece):
                if not count:
                    return 0
                count = _clear_of(corners[:, :count], other)
        return count


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
    clear = gaps >= GAP
    count = in_a_row(clear)
    for _ in range(AXES):
        if count == len(clear):
            break
        here = [(x, y, z) for x, y, z in corners[:, count].T.tolist()]
        out, way = separation(here, other.vertices)
        if out < NEAR:
            break
        clear[count:] |= beyond(corners[:, count:], other.vertices, way) >= GAP
        if not clear[count]:
            break
        count = in_a_row(clear)
    return count


def _nearer(solid: Placed, other: Placed, least: float) -> float:
    """`least`, or the distance of two solids if that is less."""
    if boxes_apart(solid, other) >= least:
        return least
    return min(least, distance(solid, other))
