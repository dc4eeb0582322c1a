"""Where a step would lead, and whether into something.

Contacts are those that are to be seen when a step begins. What is fast may touch otherwise before
it ends: a corner comes in over the rim of a face, an edge on which it turns gives way to another.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from trs80arm.arm.contact.bodies import Body, Fixed
from trs80arm.arm.contact.bounds import box_around, greatest_speed, overlap
from trs80arm.arm.contact.contacts import Mobile
from trs80arm.arm.contact.driven import DrivenArm
from trs80arm.arm.contact.manifold import Placed
from trs80arm.arm.contact.roster import Roster

FAST = 0.06
"""Inches that a thing may go in a step without its being looked at where that leads."""
DIVE = 0.01
"""Inches by which a step may lead two things deeper into each other."""

Solids = Sequence[Placed]


@dataclass(slots=True)
class Ending:
    """The end of a step that is solved, and not made yet.

    Attributes:
        seconds: its length.
        bodies: of the scene, by name.
        roster: where the sleepers are.
        fixed: what stands fast, by name.
        mobiles: what is awake, as solved.
        arm: of the scene.
        arm_mobile: the arm as solved, or None.
        reach: how far each link may move in the step, inches.
    """

    seconds: float
    bodies: Mapping[str, Body]
    roster: Roster
    fixed: Mapping[str, Fixed]
    mobiles: Mapping[str, Mobile]
    arm: DrivenArm
    arm_mobile: Mobile | None
    reach: Sequence[float]
    _after: dict[str, Solids] = field(default_factory=dict)

    @property
    def dives(self) -> bool:
        """Whether the step leads anything that is fast into something else."""
        fast = [
            name
            for name, mobile in self.mobiles.items()
            if self.seconds * greatest_speed(mobile.speed, self.bodies[name].shape.radius) > FAST
        ]
        if self.arm_mobile is not None:
            fast += [
                name for name, way in zip(self.arm.names, self.reach, strict=True) if way > FAST
            ]
        return any(
            self._in_deeper(self._led(name), before, self._led(other), there)
            for k, name in enumerate(fast)
            for before in [self._standing(name)]
            for other, there in self._others(name)
            if other not in fast[:k]
        )

    def _others(self, name: str) -> Iterator[tuple[str, Solids]]:
        """What something could be led into, with its solids as they stand."""
        link = name in self.arm.names
        for thing in self.fixed.values():
            if name not in thing.passes:
                yield thing.name, thing.placed
        for other in self.mobiles:
            if other != name:
                yield other, self._standing(other)
        if link:
            return
        for other in self.arm.names:
            yield other, self._standing(other)
        for body in self.roster.near(*box_around(self._led(name), 0.0)):
            yield body.name, body.placed

    def _standing(self, name: str) -> Solids:
        """The solids of a body or a link, where they stand as the step begins."""
        if name in self.arm.names:
            return [self.arm.solids[self.arm.names.index(name)]]
        return self.bodies[name].placed

    def _led(self, name: str) -> Solids:
        """The solids of a thing where the step ends."""
        found = self._after.get(name)
        if found is None:
            if name in self.mobiles:
                body = self.bodies[name]
                place, turn, _ = body.led(self.mobiles[name].speed, self.seconds)
                found = body.shape.at(place, turn)
            elif self.arm_mobile is not None and name in self.arm.names:
                links = self.arm.led(self.arm_mobile, self.seconds)
                self._after |= {
                    link: [solid] for link, solid in zip(self.arm.names, links, strict=True)
                }
                found = self._after[name]
            elif name in self.fixed:
                found = self.fixed[name].placed
            else:
                found = self._standing(name)
            self._after[name] = found
        return found

    @staticmethod
    def _in_deeper(mine: Solids, mine_before: Solids, other: Solids, other_before: Solids) -> bool:
        """Whether two things are deeper in each other than before."""
        for i, one in enumerate(mine):
            for k, two in enumerate(other):
                deep = overlap(one, two)
                if deep > DIVE and deep > DIVE + overlap(mine_before[i], other_before[k]):
                    return True
        return False
