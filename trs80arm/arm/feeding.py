"""When feeders give their next part: nothing stands at their place, and the hand is clear of it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from trs80arm.arm.bench import Bench, deep
from trs80arm.arm.contact.manifold import Placed
from trs80arm.arm.contact.rotations import Quaternion
from trs80arm.arm.contact.solids import Solid
from trs80arm.arm.course import Floats, fingertip, fingertips, in_a_row
from trs80arm.arm.fixtures import Feeder, Part
from trs80arm.arm.geometry import JointAngles, forward
from trs80arm.arm.linkage import ArmLinkage
from trs80arm.arm.shapes import SKIN, Vector, length
from trs80arm.arm.surroundings import SPARE, Surroundings
from trs80arm.arm.sweep import Ranges, fingertip_out

DEPTHS = (2.0, 1.0, 0.5, 0.2, 0.1)
"""Inches by which a link may be in a feeder's place: how far it has to go at least to be out."""
CLEARANCE = 2.5
"""A feeder gives its next part when the fingertip is this far from its middle, inches."""


class Given(NamedTuple):
    """A part as a feeder gave it.

    Attributes:
        name: of the part.
        place: where it stood.
        turn: how.
        thick: inches that any point of it has to go at least until it may be off its place.
        radius: of the sphere around it, inches.
    """

    name: str
    place: Vector
    turn: Quaternion
    thick: float
    radius: float

    @classmethod
    def of(cls, part: Part) -> Given:
        """A part that was given just now."""
        solids = part.shape.solids
        thick = max([_depth(solid) for solid in solids]) / 2
        return cls(part.name, part.place, part.turn, thick, part.shape.radius)

    def still(self, parts: Mapping[str, Part]) -> bool:
        """Whether it is sure that it is in its place, and not in the hand."""
        part = parts.get(self.name)
        if part is None or part.held:
            return False
        gone = math.dist(part.place, self.place)
        # A turn takes no point farther than twice the way of its quaternion, times its distance.
        return gone + 2 * math.dist(part.turn, self.turn) * self.radius < self.thick


def _depth(solid: Solid) -> float:
    """How far the middle of a solid is from its faces, at least."""
    x, y, z = solid.middle
    depths = []
    for (u, v, w), face in zip(solid.normals, solid.faces, strict=True):
        a, b, c = solid.vertices[face[0]]
        depths.append(u * (a - x) + v * (b - y) + w * (c - z))
    return min(depths)


class Feeding:
    """The feeders of a bench, and an arm that works there.

    Attributes:
        vacant: feeders with parts to give at whose place nothing stands, by number.
    """

    def __init__(self, bench: Bench, linkage: ArmLinkage, around: Surroundings) -> None:
        self.vacant: dict[int, Feeder] = {}
        self._bench = bench
        self._linkage = linkage
        self._around = around
        self._standing: dict[int, tuple[object, ...]] = {}
        self._given: dict[int, Given] = {}
        self._barred: dict[int, tuple[list[float], float]] = {}

    def __getstate__(self) -> dict[str, Any]:
        # What stands at the feeders' places is found anew.
        return {**self.__dict__, "_standing": {}, "_given": {}, "_barred": {}}

    def begin(self) -> None:
        """Give the first parts, but where the arm is."""
        for feeder in self._bench.waiting_feeders():
            if not self._touches(feeder.placed):
                self._bench.feed(feeder)

    def look(self) -> None:
        """Parts have moved: see which feeders have room."""
        bench = self._bench
        self.vacant = {}
        for number, feeder in enumerate(bench.feeders):
            name, *stood = self._standing.get(number, ("",))
            part = bench.parts.get(str(name))
            if (
                feeder.empty
                or feeder.commanded
                or (part is not None and not part.held and [part.place, part.turn] == stood)
            ):
                # What stood at its place still does.
                continue
            if number in self._given and self._given[number].still(bench.parts):
                continue
            found = bench.found_at(feeder.placed)
            if found is None:
                self.vacant[number] = feeder
            elif found in bench.parts:
                part = bench.parts[found]
                self._standing[number] = (found, part.place, part.turn)

    def give(self, joints: Sequence[float]) -> bool:
        """Have vacant feeders give their next part that are clear of the arm; whether any has.

        Args:
            joints: where motors want the arm's six coordinates; its links stand as in the scene.
        """
        given = False
        for number, feeder in self.vacant.items():
            placed = feeder.placed
            if self._surely_near(feeder, joints) or self._near(feeder, joints):
                continue
            if not self._bench.room_for(placed):
                continue
            if self._touches(placed):
                by = next((by for by in DEPTHS if self._touches(placed, SKIN + by)), 0.0)
                self._barred[number] = list(self._bench.scene.joints), by
                continue
            self._given[number] = Given.of(self._bench.feed(feeder))
            given = True
        return given

    def may_give(self, joints: Sequence[float]) -> bool:
        """Whether a vacant feeder may be able to give its next part, for all that is sure.

        Args:
            joints: the arm's six coordinates.
        """
        for number, feeder in self.vacant.items():
            stood, by = self._barred.get(number, (joints, 0.0))
            barred = by > 0.0 and self._around.travel(stood, joints)[0] < by
            if not (barred or self._surely_near(feeder, joints)):
                return True
        return False

    def surely_unfed(self, ranges: Ranges) -> bool:
        """Whether no vacant feeder can give its next part, wherever the arm is in some ranges."""
        if not self.vacant:
            return True
        near, out = fingertip_out(self._linkage.model, ranges)
        if near < 0.0:
            return False
        for feeder in self.vacant.values():
            far = CLEARANCE + feeder.radius - SPARE
            way, bearing = math.hypot(feeder.x, feeder.y), math.atan2(feeder.y, feeder.x)
            aside = max(abs(ranges.base[0] - bearing), abs(ranges.base[1] - bearing))
            across = 2 * way * math.cos(min(aside, math.pi))
            if max(at * (at - across) for at in (near, out)) + way * way >= far * far:
                return False
        return True

    @property
    def bars(self) -> list[object]:
        """All that `places_unfed` depends on, besides the places."""
        return [
            (feeder.x, feeder.y, feeder.radius, self._barred.get(number))
            for number, feeder in self.vacant.items()
        ]

    def places_unfed(self, joints: Floats) -> int:
        """At how many of some places in a row no vacant feeder can give its next part.

        Args:
            joints: the arm's six coordinates, 6 x places.
        """
        x, y = fingertips(self._linkage.model, joints)
        count = len(x)
        for number, feeder in self.vacant.items():
            far = CLEARANCE + feeder.radius - SPARE
            unfed = (x - feeder.x) ** 2 + (y - feeder.y) ** 2 < far * far
            if number in self._barred:
                stood, by = self._barred[number]
                unfed |= self._around.travels(stood, joints) < by - SPARE
            count = min(count, in_a_row(unfed))
        return count

    def _near(self, feeder: Feeder, joints: Sequence[float]) -> bool:
        """Whether the fingertip is too near to a feeder for its next part."""
        x, y, _ = forward(self._linkage.model, JointAngles.of_gears(*joints[:5])).fingertip
        return length(x - feeder.x, y - feeder.y) < CLEARANCE + feeder.radius

    def _surely_near(self, feeder: Feeder, joints: Sequence[float]) -> bool:
        """Whether it is for sure; the sines are the C library's, and leave a little room."""
        x, y = fingertip(self._linkage.model, joints)
        return length(x - feeder.x, y - feeder.y) < CLEARANCE + feeder.radius - SPARE

    def _touches(self, solids: Sequence[Placed], depth: float = SKIN) -> bool:
        """Whether a link or finger is in some solids by more than a depth, inches."""
        links = self._bench.scene.link_solids
        return any(deep(mine, other, depth) for mine in links for other in solids)
