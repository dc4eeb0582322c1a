"""Whether all goes on as in the last step, and for how long: what `coasting` sets out with."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from trs80arm.arm.contact.bodies import NOWHERE, UPPER, Body, Fixed
from trs80arm.arm.contact.bounds import box_around
from trs80arm.arm.contact.coasting import MOST_STEPS, Coast, Move, Mover, apart, even, join, pace
from trs80arm.arm.contact.contacts import SOLIDS, Contact, Mobile, total
from trs80arm.arm.contact.driven import DrivenArm
from trs80arm.arm.contact.roster import Roster
from trs80arm.arm.contact.sixes import STILL, Six
from trs80arm.arm.contact.solver import Problem
from trs80arm.arm.contact.table import TABLE
from trs80arm.arm.shapes import cross, dot, minus, plus


@dataclass(slots=True)
class Prospect:
    """A step that was solved, with all that moved in it.

    Attributes:
        seconds: its length.
        arm: of the scene.
        arm_mobile: the arm as solved, or None.
        way: rates of the arm's coordinates in the step before.
        awake: bodies.
        mobiles: those as solved.
        problems: likewise.
        contacts: likewise.
        fixed: what stands fast, by name.
        roster: where the sleepers are.
        far: whether it has mattered what is farther off than a tick can reach.
    """

    seconds: float
    arm: DrivenArm
    arm_mobile: Mobile | None
    way: Sequence[float]
    awake: Sequence[Body]
    mobiles: Mapping[str, Mobile]
    problems: Sequence[Problem]
    contacts: Sequence[Contact]
    fixed: Mapping[str, Fixed]
    roster: Roster
    far: bool = False

    def coast(self) -> Coast | None:
        """How all goes on as in this step, if it does."""
        h, mobiles = self.seconds, self.mobiles
        # Some may have come to rest in the step.
        awake = [body for body in self.awake if not body.asleep]
        if all(body.still for body in awake):
            return None
        levers = [1.0] * 6
        if self.arm.linkage is not None:
            levers = [max(self.arm.reach(coordinate)) for coordinate in range(6)]
        faster = pace(levers, self.way, self.arm.way)
        driven: set[str] = set()
        for problem in self.problems:
            members = {id(mobile) for mobile in problem.mobiles}
            if id(self.arm_mobile) in members:
                driven |= {name for name, mobile in mobiles.items() if id(mobile) in members}
        for body in awake:
            own = faster if body.name in driven else 1.0
            if not even(mobiles[body.name], body.shape.radius, own):
                return None
        if not all(problem.settled for problem in self.problems):
            return None
        links, bodies = self._movers(awake)
        join(links, bodies, touching := {contact.key[:2] for contact in self.contacts})
        moves = [body.move(body.name in driven) for body in bodies]
        speeds: dict[int, Six] = dict.fromkeys(map(id, mobiles.values()), STILL)
        for move in moves:
            speeds[id(mobiles[move.name])] = (*move.velocity, *move.spin)
        if self.arm_mobile is not None:
            a, b, c, d, e, f = self.arm.way
            speeds[id(self.arm_mobile)] = (a, b, c, d, e, f)
        spans = {id(mobiles[body.name]): 2 * body.shape.radius for body in self.awake}
        lasting = MOST_STEPS * h
        for problem in self.problems:
            lasting = problem.lasting(speeds, spans, {TABLE}, lasting)
        if lasting >= h:
            passing = {(thing.name, link) for thing in self.fixed.values() for link in thing.passes}
            pressing = {contact.key[:2] for contact in self.contacts if contact.pressure}
            resting = {pair for pair in touching if pair[0] == TABLE}
            lasting = self._apart(bodies, links, pressing | resting | passing, lasting)
        if lasting >= h:
            lasting = self._carried(moves, lasting)
        if lasting < h:
            return None
        course = [rate * h for rate in self.arm.way]
        return Coast(course, list(self.arm.commands), levers, self.arm.gives, moves, lasting / h)

    def _movers(self, awake: Sequence[Body]) -> tuple[list[Mover], list[Mover]]:
        """The arm's links and what is awake, as they went in the last step."""
        links = []
        for name, link, solid in zip(self.arm.names, self.arm.links, self.arm.solids, strict=True):
            spin, velocity = total(link.screws, self.arm.way)
            middle, radius = solid.middle, solid.radius
            velocity = plus(velocity, cross(spin, middle))
            links.append(Mover(name, [solid], middle, radius, velocity, spin))
        return links, [
            Mover(body.name, body.placed, body.place, body.shape.radius, body.velocity, body.spin)
            for body in awake
        ]

    def _carried(self, moves: Sequence[Move], seconds: float) -> float:
        """For how much of some time all that belts carry stays on them, as it moves now."""
        going = {move.name: move for move in moves}
        for contact in self.contacts:
            name, other, number = contact.key
            thing, move = self.fixed.get(name), going.get(other)
            if thing is None or move is None or thing.carries == NOWHERE:
                continue
            middle = self.mobiles[other].place
            solid = thing.placed[number // SOLIDS]
            for normal, level in zip(solid.normals, solid.levels, strict=True):
                if abs(normal[2]) > UPPER:
                    continue
                for point, _ in contact.points:
                    velocity = plus(move.velocity, cross(move.spin, minus(point, middle)))
                    room, closing = level - dot(normal, point), dot(normal, velocity)
                    if closing > 0 and closing * seconds > room:
                        seconds = max(0.0, room / closing)
        return seconds

    def _apart(
        self,
        bodies: list[Mover],
        links: list[Mover],
        heedless: set[tuple[str, str]],
        seconds: float,
    ) -> float:
        """For how much of some time nothing comes upon anything new, as all moves now."""
        self.far = True
        others = [Mover(thing.name, thing.placed) for thing in self.fixed.values()]
        near: dict[str, Body] = {}
        for mover in (*bodies, *links):
            if (TABLE, mover.name) not in heedless:
                seconds = min(seconds, mover.above())
            seconds = min(seconds, mover.straight())
            speed = math.sqrt(dot(mover.velocity, mover.velocity)) + mover.turning
            for body in self.roster.near(*box_around(mover.solids, speed * seconds)):
                near[body.name] = body
        others += [Mover(body.name, body.placed) for body in self.roster.ordered(near.values())]
        return apart(bodies, links, others, heedless, seconds)
