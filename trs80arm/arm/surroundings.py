"""How far the arm, with what it carries, is from everything: bounds that spare it being looked at.

Inches, and inches that a half-step of each motor moves anything of the arm at most. Nothing here
decides what happens: only whether it is certain that nothing does.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from trs80arm.arm.bench import Bench
from trs80arm.arm.contact.distance import boxes_apart, distance
from trs80arm.arm.contact.manifold import Placed
from trs80arm.arm.contact.rotations import apply
from trs80arm.arm.fixtures import Feeder
from trs80arm.arm.geometry import CableDrive, forward
from trs80arm.arm.linkage import FINGERS, ArmLinkage
from trs80arm.arm.model import Link, Motor
from trs80arm.arm.rings import Ring, around, link_slices, rolled_slices
from trs80arm.arm.shapes import Box, Vector, plus
from trs80arm.arm.trigonometry import sin_cos

FAR = 100.0
"""More inches than there are."""
NEAR = 0.005
"""Inches beyond what the arm goes in a tick within which contact is looked at."""
FEED_CLEARANCE = 2.5
"""A feeder gives its next part when the fingertip is this far from its middle, inches."""


class Surroundings:
    """What is around an arm, and how far."""

    def __init__(self, bench: Bench, linkage: ArmLinkage, drive: CableDrive) -> None:
        self._bench = bench
        self._linkage = linkage
        self._drive = drive
        self._levers: tuple[float, ...] = ()

    def __getstate__(self) -> dict[str, object]:
        return {**self.__dict__, "_levers": ()}

    def load_changed(self) -> None:
        """The hand has another load, or none."""
        self._levers = ()

    def levers(self) -> tuple[float, ...]:
        """Inches that a half-step of each motor moves anything of the arm or its load, at most."""
        if not self._levers:
            self._levers = self._longest_levers()
        return self._levers

    def _longest_levers(self) -> tuple[float, ...]:
        model = self._linkage.model
        ahead, aside = self.extent(model.hand.range)
        out = math.hypot(ahead, aside)
        swung = max(
            math.hypot(abs(solid.center[0]) + solid.half[0], solid.half[2])
            for solid in model.solids
            if solid.link in (Link.UPPER_ARM, Link.FOREARM)
        )
        wide = max(solid.half[1] for solid in model.solids)
        levers = {
            Motor.BASE: math.hypot(2 * swung, wide) + out,
            Motor.SHOULDER: swung,
            # Raising the forearm opens the hand as well.
            Motor.ELBOW: swung + 0.5 * model.drives[2].steps / model.hand_steps,
            # A gear turns pitch and roll by half as much.
            Motor.LEFT_WRIST: (out + aside) / 2,
            Motor.RIGHT_WRIST: (out + aside) / 2,
            Motor.HAND: 0.5,
        }
        return tuple(levers[drive.turns] / drive.steps for drive in model.drives)

    def travel(self, before: Sequence[int], after: Sequence[int]) -> float:
        """Inches that any point of arm and load goes at most between two places."""
        a, b, c, d, e, f = self.levers()
        return (
            a * abs(after[0] - before[0])
            + b * abs(after[1] - before[1])
            + c * abs(after[2] - before[2])
            + d * abs(after[3] - before[3])
            + e * abs(after[4] - before[4])
            + f * abs(after[5] - before[5])
        )

    def extent(self, opening: float) -> tuple[float, float]:
        """How far hand, fingers and load reach from the wrist, ahead and to any side, inches."""
        ahead, aside = self._linkage.model.hand_length, 0.0
        for solid in self._linkage.model.solids:
            _, wide, thick = (
                abs(at) + half for at, half in zip(solid.center, solid.half, strict=True)
            )
            if solid.link in FINGERS:
                aside = max(aside, math.hypot(wide + opening / 2, thick))
            elif solid.link is Link.HAND:
                aside = max(aside, math.hypot(wide, thick))
        for load in self._bench.scene.carried:
            assert load.carried is not None
            place, turn = load.carried
            for corner in (each for part in load.shape.solids for each in part.vertices):
                x, y, z = plus(place, apply(turn, corner))
                ahead, aside = max(ahead, abs(x)), max(aside, math.hypot(y, z))
        return ahead, aside

    def measured(self) -> float:
        """How far the arm and what it carries are from all else but the table."""
        scene = self._bench.scene
        least = FAR
        mine = list(zip(self._linkage.names, scene.link_solids, strict=True))
        for load in scene.carried:
            mine += [("", solid) for solid in load.placed]
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
        return least

    def until_fed(self, vacant: Sequence[Feeder], rotors: Sequence[int]) -> float:
        """Inches that the fingertip may go until a feeder can give; 0 where one can.

        Args:
            vacant: feeders at whose place nothing stands.
            rotors: positions.
        """
        tip = self.fingertip(rotors)
        return max(0.0, min((too_near(feeder, tip) for feeder in vacant), default=FAR))

    def fingertip(self, rotors: Sequence[int]) -> Vector:
        """Where the fingertip is with the rotors somewhere."""
        return forward(self._linkage.model, self._drive.angles(rotors)).fingertip

    def over_rings(self, vacant: Sequence[Feeder], rotors: Sequence[int], opening: float) -> float:
        """How far all is from the arm wherever the base turns, as it was on the last tick.

        Args:
            vacant: feeders at whose place nothing stands.
            rotors: positions on the last tick.
            opening: of the hand, inches.
        """
        scene = self._bench.scene
        s, c = sin_cos(scene.joints[0])
        arm = scene.link_solids[:2]
        mine = [ring for solid in arm for ring in link_slices(solid, c, s)]
        joined = len(mine)
        mine += self._hand_rings(c, s, opening)
        least = min(each.low for each in mine)
        x, y, _ = self.fingertip(rotors)
        for feeder in vacant:
            out = math.hypot(x, y) + math.hypot(feeder.x, feeder.y)
            least = min(least, FEED_CLEARANCE + feeder.place.radius - out)
        # Base and body are joined to the arm's first links, and always behind a line across it.
        for thing in scene.fixed.values():
            for solid in thing.placed:
                if thing.passes:
                    ahead = max(math.hypot(x, y) for x, y, _ in solid.vertices if x >= 0)
                    behind = max(math.hypot(x, y) for x, y, _ in solid.vertices)
                    ring = Ring(-behind, ahead, solid.low[2], solid.high[2])
                    least = min(least, *(each.apart(ring) for each in mine[joined:]))
                else:
                    ring = around(solid)
                    least = min(least, *(each.apart(ring) for each in mine))
        for body in scene.bodies.values():
            if body.carried is None:
                x, y, z = body.place
                out, reach = math.hypot(x, y), body.shape.radius
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

    def boxes(self) -> list[tuple[Box, bool]]:
        """Boxes around everything that the arm could touch, and whether it is the arm's own."""
        own = len(self._bench.obstacles[:2])
        found = [
            (obstacle.box, number < own) for number, obstacle in enumerate(self._bench.obstacles)
        ]
        parts = self._bench.parts.values()
        return found + [(part.box, False) for part in parts if part.carried is None]


def too_near(feeder: Feeder, tip: Vector) -> float:
    """Inches by which a fingertip is too near to a feeder for its next part."""
    out = math.hypot(tip[0] - feeder.x, tip[1] - feeder.y)
    return FEED_CLEARANCE + feeder.place.radius - out


def _nearer(solid: Placed, other: Placed, least: float) -> float:
    """`least`, or the distance of two solids if that is less."""
    if boxes_apart(solid, other) >= least:
        return least
    return min(least, distance(solid, other))
