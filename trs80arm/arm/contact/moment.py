"""A tick as a question: all that it hangs on, whatever the parts are called; and what comes of it.

What happens in a tick hangs on the arm, on what is awake or carried, and on what lies so near that
they could come upon it: nothing else can be touched in that time. Who is concerned is closed:
nothing else is within `NEARBY` of any of them. They are told by their order, not by their names: a
feeder's next part is another one, and the same happens to it.
"""

from __future__ import annotations

import math
from bisect import bisect
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from trs80arm.arm.contact.bodies import Body, Fixed
from trs80arm.arm.contact.bounds import NEARBY, outside, spheres_within
from trs80arm.arm.contact.carrying import Carrying
from trs80arm.arm.contact.contacts import Contact, Key
from trs80arm.arm.contact.driven import DrivenArm
from trs80arm.arm.contact.manifold import Placed
from trs80arm.arm.contact.memory import Memory, Pressures
from trs80arm.arm.contact.recurrence import question
from trs80arm.arm.contact.rest import CALM_TICKS
from trs80arm.arm.contact.roster import Roster
from trs80arm.arm.contact.rotations import Matrix, Quaternion
from trs80arm.arm.shapes import Vector

FEW = 4
"""Bodies concerned in a tick that is remembered, at most."""

Name = int | str
"""Of a body that is concerned, its place among them; of anything else, its name."""
Pressed = list[tuple[tuple[Name, Name, int], Pressures]]
"""What two things press on each other with, as `Memory` has it."""


class End(NamedTuple):
    """What has become of a body: the attributes are those of `Body`."""

    place: Vector
    turn: Quaternion
    velocity: Vector
    spin: Vector
    still: int
    asleep: bool
    carried: tuple[Vector, Matrix] | None
    touching: tuple[Name, ...]
    placed: list[Placed]


class Outcome(NamedTuple):
    """What has come of a tick, but for what `Scene` itself takes note of.

    Attributes:
        ends: what has become of each body that is concerned.
        arm: its joints, the torques on them, and their rates.
        hold: from where to where the hand may be commanded, whether both fingers lie flat, which
            way down is in the hand, where the arm stands.
        gripped: as in `Carrying`.
        last: what presses.
        resting: what presses on those that sleep, of whom that has changed, in their order.
        contacts: what touches, as solved.
    """

    ends: list[End]
    arm: tuple[Sequence[float], Sequence[float], Sequence[float]]
    hold: tuple[tuple[float, float], bool, Vector, Sequence[float]]
    gripped: list[Name]
    last: Pressed
    resting: list[tuple[int, Pressed | None]]
    contacts: list[tuple[tuple[Name, Name, int], Contact]]


class Moment:
    """All that the outcome of a tick hangs on, at its beginning.

    Args:
        concerned: bodies, as they came to the scene.
        arm: of the scene.
        carrying: what its hand carries.
        memory: forces of the step before.

    Attributes:
        names: of those bodies.
    """

    def __init__(
        self, concerned: Sequence[Body], arm: DrivenArm, carrying: Carrying, memory: Memory
    ) -> None:
        self._bodies = concerned
        self._arm, self._carrying, self._memory = arm, carrying, memory
        self.names = [body.name for body in concerned]
        self._numbers: dict[str, int] = {name: k for k, name in enumerate(self.names)}
        self._rested = [self._resting(body) for body in concerned]
        self._places = [body.place for body in concerned]

    def question(self, fixed: Mapping[str, Fixed], others: object) -> bytes:
        """What comes of the tick is the same for the same of these.

        Args:
            fixed: what stands fast, by name.
            others: what else it hangs on.
        """
        arm, told, still = self._arm, self.told, self._arm.still
        return question(
            others,
            (arm.joints, arm.torques, arm.reached, arm.commands, arm.way),
            (still if still < CALM_TICKS else CALM_TICKS, arm.standing > 0),
            self._carrying.found,
            told(self._carrying.gripped),
            self._ranks(fixed),
            [(thing.form, thing.carries) for thing in fixed.values()],
            [
                (
                    *(body.form, body.friction, body.place, body.turn, body.velocity, body.spin),
                    *(body.still, body.asleep, body.carried, told(body.touching)),
                )
                for body in self._bodies
            ],
            self._rested,
            self._pressed(self._memory.last),
        )

    def _ranks(self, fixed: Mapping[str, Fixed]) -> object:
        """How names sort: they decide in what order what leans on each other is gone through."""
        names = sorted(self.names)
        others = sorted([*self._arm.names, *fixed])
        return self.told(names), [bisect(others, name) for name in names]

    def outcome(self, contacts: Sequence[Contact]) -> Outcome:
        """What has come of the tick since.

        Args:
            contacts: of its last step, as solved.
        """
        arm, told = self._arm, self.told
        rested = dict(enumerate(self._rested))
        now = {k: self._resting(body) for k, body in enumerate(self._bodies)}
        # In the order in which the memory has them; what is not in it any more before that.
        order = [self._numbers[name] for name in self._memory.resting if name in self._numbers]
        changed = [k for k in now if now[k] is None] + order
        return Outcome(
            [
                End(
                    *(body.place, body.turn, body.velocity, body.spin),
                    *(body.still, body.asleep, body.carried, tuple(told(body.touching))),
                    body.placed,
                )
                for body in self._bodies
            ],
            (tuple(arm.joints), tuple(arm.torques), tuple(arm.way)),
            self._carrying.found,
            told(self._carrying.gripped),
            self._pressed(self._memory.last),
            [(k, now[k]) for k in changed if now[k] != rested[k]],
            [(self._key(contact.key), contact) for contact in contacts],
        )

    def repeat(self, outcome: Outcome) -> None:
        """Have the same come of this tick."""
        for body, end in zip(self._bodies, outcome.ends, strict=True):
            body.velocity, body.spin, body.still = end.velocity, end.spin, end.still
            body.touching = tuple(self.named(end.touching))
            if end.place != body.place or end.turn != body.turn:
                body.put(end.place, end.turn, end.placed)
            if end.carried != body.carried:
                body.carried = end.carried
            if end.asleep != body.asleep:
                body.asleep = end.asleep
        self._arm.repeat(*outcome.arm)
        self._carrying.found = outcome.hold
        self._carrying.gripped = self.named(outcome.gripped)
        memory = self._memory
        memory.last = self._unpressed(outcome.last)
        for k, pressed in outcome.resting:
            name = self.names[k]
            memory.resting.pop(name, None)
            if pressed is not None:
                memory.resting[name] = self._unpressed(pressed)

    def contacts(self, outcome: Outcome) -> list[Contact]:
        """The contacts of the last step of a tick of which the same has come, as solved."""
        contacts = []
        for told, contact in outcome.contacts:
            key = self._unkey(told)
            contacts.append(contact if contact.key == key else replace(contact, key=key))
        return contacts

    def farthest(self) -> float:
        """Inches by which any of the bodies has been moved since."""
        places = zip(self._bodies, self._places, strict=True)
        return max((math.dist(body.place, place) for body, place in places), default=0.0)

    # Names

    def told(self, names: Iterable[str]) -> list[Name]:
        """Names, of those that are concerned by their order."""
        numbers = self._numbers
        return [numbers.get(name, name) for name in names]

    def named(self, told: Iterable[Name]) -> list[str]:
        """Names, as they were told of such a tick."""
        return [self.names[name] if isinstance(name, int) else name for name in told]

    def _key(self, key: Key) -> tuple[Name, Name, int]:
        numbers, (one, other, solids) = self._numbers, key
        return numbers.get(one, one), numbers.get(other, other), solids

    def _unkey(self, key: tuple[Name, Name, int]) -> Key:
        names, (one, other, solids) = self.names, key
        return (
            names[one] if isinstance(one, int) else one,
            names[other] if isinstance(other, int) else other,
            solids,
        )

    def _pressed(self, pressures: Mapping[Key, Pressures]) -> Pressed:
        return [(self._key(key), pressed) for key, pressed in pressures.items()]

    def _unpressed(self, pressed: Pressed) -> dict[Key, Pressures]:
        return {self._unkey(key): pressures for key, pressures in pressed}

    def _resting(self, body: Body) -> Pressed | None:
        resting = self._memory.resting.get(body.name)
        return None if resting is None else self._pressed(resting)


def concerned(
    bodies: Mapping[str, Body], roster: Roster, memory: Memory, arm: DrivenArm
) -> list[Body] | None:
    """The bodies that a tick can concern, as they came to the scene; None if they are many.

    Args:
        bodies: of the scene.
        roster: of them.
        memory: forces of the step before.
        arm: of the scene.
    """
    surely = {**roster.awake, **roster.carried}
    for one, other, _ in memory.last:
        if one in bodies:
            surely[one] = bodies[one]
        if other in bodies:
            surely[other] = bodies[other]
    if len(surely) <= FEW and _alone(surely, bodies, roster, arm):
        return roster.ordered(surely.values())
    waiting = list(surely.values())
    if arm.linkage is not None:
        waiting += _beside(arm, roster)
    found: dict[str, Body] = {}
    while waiting:
        body = waiting.pop()
        if body.name in found:
            continue
        found[body.name] = body
        if len(found) > FEW:
            return None
        (x, y, z), r = body.place, body.shape.radius + NEARBY
        near = roster.near((x - r, y - r, z - r), (x + r, y + r, z + r))
        waiting += [other for other in near if spheres_within(body, other, NEARBY)]
        waiting += [bodies[name] for name in body.touching if name in bodies]
    return roster.ordered(found.values())


def _alone(
    surely: Mapping[str, Body], bodies: Mapping[str, Body], roster: Roster, arm: DrivenArm
) -> bool:
    """Whether nothing else can be near to an arm and some bodies, or touch them."""
    if len(surely) == len(bodies):
        return True
    if any(
        name in bodies and name not in surely for body in surely.values() for name in body.touching
    ):
        return False
    low, high = ((math.inf,) * 3, (-math.inf,) * 3) if arm.linkage is None else arm.around
    (a, b, c), (d, e, f) = low, high
    for body in surely.values():
        (x, y, z), r = body.place, body.shape.radius
        a, b, c = min(a, x - r), min(b, y - r), min(c, z - r)
        d, e, f = max(d, x + r), max(e, y + r), max(f, z + r)
    if a > d:
        return True
    r = NEARBY
    around = (a - r, b - r, c - r), (d + r, e + r, f + r)
    for other in roster.near(*around):
        if other.name in surely or outside(other, around):
            continue
        if arm.beside(other.placed):
            return False
        if any(spheres_within(body, other, NEARBY) for body in surely.values()):
            return False
    return True


def _beside(arm: DrivenArm, roster: Roster) -> list[Body]:
    """What sleeps near a link of an arm."""
    (a, b, c), (d, e, f) = arm.around
    r = NEARBY
    around = (a - r, b - r, c - r), (d + r, e + r, f + r)
    return [
        body
        for body in roster.near(*around)
        if not outside(body, around) and arm.beside(body.placed)
    ]
