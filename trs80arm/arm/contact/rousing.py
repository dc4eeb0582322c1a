"""Whom the arm wakes: what rests where its links, or what it carries, are about to be."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from trs80arm.arm.contact.bodies import Body, Fixed
from trs80arm.arm.contact.bounds import outside, spheres_around, within
from trs80arm.arm.contact.carrying import Carrying
from trs80arm.arm.contact.driven import DrivenArm
from trs80arm.arm.contact.manifold import Placed
from trs80arm.arm.contact.meeting import TOUCH
from trs80arm.arm.contact.roster import Roster
from trs80arm.arm.contact.table import TABLE


@dataclass(slots=True)
class Rousing:
    """An arm that moves among sleepers.

    Attributes:
        arm: of the scene.
        carrying: how what rests in its hand is held.
        roster: where the sleepers are, and who is carried.
        fixed: what stands fast, by name.
        wake: wakes a body.
    """

    arm: DrivenArm
    carrying: Carrying
    roster: Roster
    fixed: Mapping[str, Fixed]
    wake: Callable[[str], None]

    def rouse(self, reach: Sequence[float]) -> None:
        """Wake what the arm may touch in a step, and what it carries if that may touch anything.

        Args:
            reach: how far each link may move in the step, inches.
        """
        arm, loads = self.arm, self.roster.ordered(self.roster.carried.values())
        if loads and not self.carrying.upright_in(arm.hand):
            for load in loads:
                self.wake(load.name)
            loads = []
        margins = [way + TOUCH for way in reach]
        self._by_links(margins)
        for load in loads:
            if load.asleep:
                self._by_load(load, max(margins) + TOUCH)
        least, most = self.carrying.openings
        if loads and not least <= arm.commands[-1] <= most:
            for load in loads:
                self.wake(load.name)

    def _by_links(self, margins: Sequence[float]) -> None:
        """Wake what is within a margin of its link."""
        links = self.arm.solids
        around = spheres_around(links, margins)
        for body in self.roster.near(*around):
            if not outside(body, around) and any(
                within(link, solid, margin)
                for solid in body.placed
                for link, margin in zip(links, margins, strict=True)
            ):
                self.wake(body.name)

    def _by_load(self, load: Body, margin: float) -> None:
        """Wake something carried, and what is within a margin of it, unless they rest so."""
        for other, thing in self._others(load, margin):
            if other in load.touching:
                continue
            if any(within(mine, thing, margin) for mine in load.placed):
                self.wake(load.name)
                self.wake(other)

    def _others(self, load: Body, margin: float) -> Iterator[tuple[str, Placed | None]]:
        """All that something carried could come upon; None stands for the table."""
        yield TABLE, None
        for thing in self.fixed.values():
            for solid in thing.placed:
                yield thing.name, solid
        (x, y, z), r = load.place, load.shape.radius + margin
        around = (x - r, y - r, z - r), (x + r, y + r, z + r)
        for body in (*self.roster.awake.values(), *self.roster.near(*around)):
            for solid in body.placed:
                yield body.name, solid
