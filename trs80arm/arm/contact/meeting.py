"""What touches what in one step: all contacts of what is awake, and of the arm.

What moves upon a sleeper wakes it, and is then met by it in turn.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from trs80arm.arm.contact.bodies import NOWHERE, Body, Fixed
from trs80arm.arm.contact.bounds import greatest_speed, met, spheres_within
from trs80arm.arm.contact.contacts import SOLIDS, Contact, Key, Mobile, Motion, Side
from trs80arm.arm.contact.driven import DrivenArm
from trs80arm.arm.contact.manifold import Manifold, on_table
from trs80arm.arm.contact.memory import Memory, Pressures
from trs80arm.arm.contact.roster import Roster
from trs80arm.arm.contact.table import TABLE, Plate, surface
from trs80arm.arm.shapes import Vector, dot, minus, plus

MARGIN = 0.02
"""Gap within which two things are looked at as about to touch, inches."""
TOUCH = 0.003
"""Gap at which they do, inches."""
SAME = 0.01
"""Square of the distance within which a point of contact is the one of the step before, inches."""
NOTHING = 1e-6
"""Inches a second at which something comes closer without pressing, and inches of an overlap."""

_FAST = Side(None)


@dataclass(slots=True)
class Meeting:
    """One step's search for contacts.

    Attributes:
        seconds: length of the step.
        roster: who is awake, and where the sleepers are.
        fixed: what stands fast, by name.
        table_friction: coefficient of the table's surface.
        plates: let into the table, that turn.
        arm: of the scene.
        arm_mobile: the arm for the solver, or None.
        reach: how far each link may move in this step, inches.
        memory: forces of the step before.
        mobiles: what is awake, for the solver; grows by what is woken.
        wake: wakes a body.
        make: makes a body one for the solver.
        contacts: found.
    """

    seconds: float
    roster: Roster
    fixed: Mapping[str, Fixed]
    table_friction: float
    plates: Sequence[Plate]
    arm: DrivenArm
    arm_mobile: Mobile | None
    reach: Sequence[float]
    memory: Memory
    mobiles: dict[str, Mobile]
    wake: Callable[[str], None]
    make: Callable[[Body], Mobile]
    contacts: list[Contact] = field(default_factory=list)
    _ways: dict[str, float] = field(default_factory=dict)

    def find(self, awake: Sequence[Body], *, arm: bool) -> list[Contact]:
        """All contacts.

        Args:
            awake: bodies.
            arm: whether those of the arm with what stands fast are wanted.
        """
        done: set[str] = set()
        queue = list(awake)
        while queue:
            body = queue.pop(0)
            if body.name in done:
                continue
            done.add(body.name)
            margin = MARGIN + self._way(body)
            self._body(body, margin)
            for other in self._about(body, margin, done):
                wider = margin
                if other.name in self.mobiles:
                    wider += self._way(other)
                self._pair(body, other, wider, queue)
        if arm and self.arm_mobile is not None:
            self._arm(self.arm_mobile)
        return self.contacts

    def _way(self, body: Body) -> float:
        """Inches that any point of a body goes in this step, at most."""
        way = self._ways.get(body.name)
        if way is None:
            speed = self.mobiles[body.name].speed
            way = self.seconds * greatest_speed(speed, body.shape.radius)
            self._ways[body.name] = way
        return way

    def _body(self, body: Body, margin: float) -> None:
        """A body against table, what stands fast, and links."""
        side = Side(self.mobiles[body.name])
        for i, solid in enumerate(body.placed):
            found = on_table(solid, margin)
            if found is not None:
                rough = math.sqrt(body.friction * self.table_friction)
                self._add((TABLE, body.name, i), found, _FAST, side, rough)
            for thing in self.fixed.values():
                for k, other in enumerate(thing.placed):
                    found = met(other, solid, margin)
                    if found is not None:
                        key = (thing.name, body.name, SOLIDS * k + i)
                        rough = math.sqrt(thing.friction * body.friction)
                        self._add(key, found, _FAST, side, rough, thing)
            if self.arm_mobile is None or self.arm.linkage is None:
                continue
            for k, link in enumerate(self.arm.solids):
                found = met(link, solid, margin + self.reach[k])
                if found is not None:
                    key = (self.arm.names[k], body.name, i)
                    rough = math.sqrt(self.arm.linkage.frictions[k] * body.friction)
                    other_side = Side(self.arm_mobile, self.arm.links[k].screws)
                    self._add(key, found, other_side, side, rough)

    def _about(self, body: Body, margin: float, done: set[str]) -> list[Body]:
        """What else that is not done yet could touch a body, as it came to the scene."""
        roster, mobiles = self.roster, self.mobiles
        (x, y, z), r = body.place, body.shape.radius + margin
        found = roster.near((x - r, y - r, z - r), (x + r, y + r, z + r))
        found += [*roster.awake.values(), *roster.carried.values()]
        return roster.ordered(
            [
                other
                for other in found
                if other.name not in done
                and spheres_within(
                    body, other, margin + (self._way(other) if other.name in mobiles else 0.0)
                )
            ]
        )

    def _pair(self, body: Body, other: Body, margin: float, queue: list[Body]) -> None:
        """Contacts of two bodies, the second of which may wake by them."""
        mobiles = self.mobiles
        for i, solid in enumerate(body.placed):
            for k, theirs in enumerate(other.placed):
                found = met(theirs, solid, margin)
                if found is None:
                    continue
                if other.asleep and not body.still and self._comes_upon(body, found):
                    self.wake(other.name)
                    for woken in self.roster.ordered(self.roster.awake.values()):
                        if woken.name not in mobiles:
                            mobiles[woken.name] = self.make(woken)
                            queue.append(woken)
                # What lies calmly against a sleeper lets it sleep.
                sides = Side(mobiles.get(other.name)), Side(mobiles[body.name])
                rough = math.sqrt(body.friction * other.friction)
                self._add((other.name, body.name, SOLIDS * k + i), found, *sides, rough)

    def _comes_upon(self, body: Body, found: Manifold) -> bool:
        """Whether a body touches a sleeper, or will in this step: what passes by does not."""
        motion = Side(self.mobiles[body.name]).motion
        return any(
            gap <= max(TOUCH, -dot(_velocity(motion, point), found.normal) * self.seconds)
            for point, gap in found.points
        )

    def _arm(self, mobile: Mobile) -> None:
        """Links against what stands fast."""
        assert self.arm.linkage is not None
        for k, link in enumerate(self.arm.solids):
            name, rough = self.arm.names[k], self.arm.linkage.frictions[k]
            margin = MARGIN + self.reach[k]
            found = on_table(link, margin)
            if found is not None:
                side = Side(mobile, self.arm.links[k].screws)
                friction = math.sqrt(rough * self.table_friction)
                self._add((TABLE, name, 0), found, _FAST, side, friction)
            for thing in self.fixed.values():
                if name in thing.passes:
                    continue
                for i, solid in enumerate(thing.placed):
                    found = met(solid, link, margin)
                    if found is not None:
                        side = Side(mobile, self.arm.links[k].screws)
                        friction = math.sqrt(rough * thing.friction)
                        self._add((thing.name, name, i), found, _FAST, side, friction, thing)

    def _add(
        self,
        key: Key,
        found: Manifold,
        first: Side,
        second: Side,
        friction: float,
        thing: Fixed | None = None,
    ) -> None:
        """Contacts of a manifold."""
        points = found.points
        if self.plates and key[0] == TABLE:
            # Where the table turns, each of its points goes another way.
            for point, gap in points:
                carried = surface(self.plates, point, self.seconds)
                contact = Contact(key, [(point, gap)], found.normal, first, second, friction)
                self._append(contact, found.apart, carried)
            return
        carried = NOWHERE
        if thing is not None and thing.carries != NOWHERE:
            carried = thing.surface(found.normal)
        contact = Contact(key, points, found.normal, first, second, friction)
        self._append(contact, found.apart, carried)

    def _append(self, contact: Contact, apart: float, carried: Vector) -> None:
        """Add a contact, beginning with the forces of the step before.

        Args:
            contact: itself.
            apart: as in `Manifold`.
            carried: velocity of the first side's surface, if that stands fast.
        """
        known, mobile = self.memory.known(contact.key), contact.second.mobile
        contact.apart = apart
        if carried != NOWHERE:
            contact.surface = carried
        if known and mobile is not None:
            within = mobile.within
            contact.pressures = [self._pressed(known, within(point)) for point, _ in contact.points]
        self.contacts.append(contact)

    def _pressed(self, known: Pressures, place: Vector) -> float:
        """Impulse that pressed in the step before where a point is now."""
        x, y, z = place
        best, nearest = 0.0, SAME
        for (i, j, k), pressure in known:
            i, j, k = i - x, j - y, k - z
            square = i * i + j * j + k * k
            if square < nearest:
                best, nearest = pressure, square
        return best * self.seconds


def islands(contacts: Sequence[Contact]) -> list[list[Contact]]:
    """Contacts that have a mobile in common, together; in the order in which they came."""
    leader: dict[int, int] = {}

    def find(name: int) -> int:
        while leader.setdefault(name, name) != name:
            leader[name] = leader[leader[name]]
            name = leader[name]
        return name

    for contact in contacts:
        if contact.first.mobile is not None:
            leader[find(id(contact.first.mobile))] = find(id(contact.second.mobile))
    groups: dict[int, list[Contact]] = {}
    for contact in contacts:
        groups.setdefault(find(id(contact.second.mobile)), []).append(contact)
    return list(groups.values())


def presses(contacts: Sequence[Contact], seconds: float) -> bool:
    """Whether anything has to press for contacts that belong together to be kept.

    Where nothing has to, everything moves as it would if they were not there, and needs no solving;
    their pressures are then none.

    Args:
        contacts: with the velocities that would be without them.
        seconds: length of the step.
    """
    for contact in contacts:
        for off, (_, gap) in zip(_relatives(contact), contact.points, strict=True):
            opening = dot(off, contact.normal)
            if opening < (-gap / seconds if gap > 0 else 0.0) - NOTHING or gap < -NOTHING:
                return True
    for contact in contacts:
        contact.press([0.0] * len(contact.points))
    return False


def sliding(contact: Contact) -> float:
    """How fast the second side slides along the first at most where they press, inches a second."""
    most = 0.0
    for off, pressure in zip(_relatives(contact), contact.pressures, strict=False):
        if pressure > 0:
            off = plus(off, contact.normal, -dot(off, contact.normal))
            most = max(most, math.sqrt(dot(off, off)))
    return most


def _relatives(contact: Contact) -> Iterator[Vector]:
    """Velocities of the second side against the first at each point."""
    first, second = contact.first.motion, contact.second.motion
    for point, _ in contact.points:
        off = minus(_velocity(second, point), _velocity(first, point))
        yield minus(off, contact.surface) if contact.surface is not None else off


def _velocity(motion: Motion | None, point: Vector) -> Vector:
    """Of what moves so, at a point; None stands fast."""
    return NOWHERE if motion is None else motion.at(point)
