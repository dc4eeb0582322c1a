"""When feeders give their next part: nothing stands at their place, and the hand is clear of it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from trs80arm.arm.bench import Bench, deep
from trs80arm.arm.contact.manifold import Placed
from trs80arm.arm.course import Course, Floats, in_a_row
from trs80arm.arm.fixtures import Feeder
from trs80arm.arm.geometry import CableDrive, forward
from trs80arm.arm.linkage import ArmLinkage
from trs80arm.arm.shapes import Vector, length
from trs80arm.arm.surroundings import FAR, SPARE

CLEARANCE = 2.5
"""A feeder gives its next part when the fingertip is this far from its middle, inches."""


class Feeding:
    """The feeders of a bench, and an arm that works there.

    Attributes:
        vacant: feeders with parts to give at whose place nothing stands.
    """

    def __init__(self, bench: Bench, linkage: ArmLinkage, drive: CableDrive) -> None:
        self.vacant: list[Feeder] = []
        self._bench = bench
        self._linkage = linkage
        self._drive = drive
        self._standing: dict[int, tuple[object, ...]] = {}

    def __getstate__(self) -> dict[str, Any]:
        # What stands at the feeders' places is found anew.
        return {**self.__dict__, "_standing": {}}

    def begin(self) -> None:
        """Give the first parts, but where the arm is."""
        for feeder in self._bench.waiting_feeders():
            if not self._touches(feeder.placed):
                self._bench.feed(feeder)

    def look(self) -> None:
        """Parts have moved: see which feeders have room."""
        bench = self._bench
        self.vacant = []
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
            found = bench.found_at(feeder.placed)
            if found is None:
                self.vacant.append(feeder)
            elif found in bench.parts:
                part = bench.parts[found]
                self._standing[number] = (found, part.place, part.turn)

    def give(self, rotors: Sequence[int]) -> bool:
        """Have vacant feeders give their next part that are clear of the hand; whether any has.

        Args:
            rotors: positions.
        """
        tip, given = self._fingertip(rotors), False
        for feeder in self.vacant:
            placed = feeder.placed
            if (
                _too_near(feeder, tip) <= 0.0
                and self._bench.room_for(placed)
                and not self._touches(placed)
            ):
                self._bench.feed(feeder)
                given = True
        return given

    def room(self, rotors: Sequence[int]) -> float:
        """Inches that the fingertip may go until a vacant feeder can give; 0 where one can.

        Args:
            rotors: positions.
        """
        tip = self._fingertip(rotors)
        return max(0.0, min((_too_near(feeder, tip) for feeder in self.vacant), default=FAR))

    def places_unfed(self, joints: Floats) -> int:
        """At how many of some places in a row no vacant feeder can give its next part.

        Args:
            joints: the arm's six coordinates, 6 x places.
        """
        x, y, _ = Course(self._linkage, joints, ()).fingertip
        count = len(x)
        for feeder in self.vacant:
            far = CLEARANCE + feeder.place.radius - SPARE
            out = (x - feeder.x) ** 2 + (y - feeder.y) ** 2
            count = min(count, in_a_row(out < far * far))
        return count

    def _fingertip(self, rotors: Sequence[int]) -> Vector:
        return forward(self._linkage.model, self._drive.angles(rotors)).fingertip

    def _touches(self, solids: Sequence[Placed]) -> bool:
        """Whether a link or finger is in some solids."""
        return any(deep(mine, other) for mine in self._bench.scene.link_solids for other in solids)


def _too_near(feeder: Feeder, tip: Vector) -> float:
    """Inches by which a fingertip is too near to a feeder for its next part."""
    out = length(tip[0] - feeder.x, tip[1] - feeder.y)
    return CLEARANCE + feeder.place.radius - out
