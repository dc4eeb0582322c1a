"""The hand among the parts: from what presses on the fingers, what they hold, and what hangs on it.

Contact knows of forces and gaps only. Here it is seen where both fingers meet something, which sets
the cable's tension and the grip switch; what they carry by friction; and what of it is a burden of
the motors.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from trs80arm.arm.bench import Bench
from trs80arm.arm.contact.contacts import Contact
from trs80arm.arm.contact.moment import Moment, Name
from trs80arm.arm.contact.recurrence import Recurrence, question
from trs80arm.arm.contact.rotations import apply_back
from trs80arm.arm.fixtures import Part
from trs80arm.arm.forces import Burden
from trs80arm.arm.grip import Grip
from trs80arm.arm.linkage import ArmLinkage, said
from trs80arm.arm.shapes import Vector, dot, minus
from trs80arm.arm.telling import Telling

FACING = 0.7
"""Cosine to the way in which the hand closes from which what presses on a finger is closed on."""
SLANT = 0.2
"""The same from which what the hand closes on passes on what presses on it."""
HAIR, BREATH = 0.75, 2.5
"""Half-steps of cable by which a part, or what gives a little, may measure otherwise."""
YIELDING = 0.1
"""Part of the cable's way by which what is between the fingers gives way, rather than resists."""
KNOWN = 512
"""Looks of which it is known what was seen."""

Five = tuple[float, float, float, float, float]
Leaning = Callable[[str], set[str]]
"""Names of what presses on a thing, and of what that presses on."""


class Sight(NamedTuple):
    """What was seen of the fingers after a tick, parts by their order in it.

    Attributes:
        grip: where the fingers have met something, and how it strains them; None where that is as
            it was, as what sleeps in the grip stays there.
        met: as `Grasp` remembers it.
        between: on what both fingers press.
        riders: what that has to carry.
        holds: whether they carry all that.
        closely: whether the next tick has to be looked at closely.
        burdens: as in `Grasp`.
        pushed: as in `Grasp`.
        leaned_on: as in `Grasp`.
        alone: as in `Grasp`.
        presser: what presses most on the arm, or None.
    """

    grip: tuple[int, float] | None
    met: tuple[float, int] | None
    between: list[Name]
    riders: list[Name]
    holds: bool
    closely: bool
    burdens: tuple[Burden, ...]
    pushed: Five
    leaned_on: bool
    alone: bool
    presser: list[Name]


class Grasp:
    """What the hand has in its grip.

    Attributes:
        grip: the hand's hold, kept in line with what contact finds.
        met: name of what presses most on the arm, or None.
        burdens: what hangs in the hand and touches nothing else.
        pushed: what else presses on the five joints, ounce-inches.
        leaned_on: whether parts touch the arm.
        alone: whether nothing touches the arm but what hangs in the hand.
        between: names of the parts on which both fingers press.
        riders: names of what stands on these, or hangs from them, and touches nothing else.
    """

    def __init__(self, bench: Bench, linkage: ArmLinkage, grip: Grip, telling: Telling) -> None:
        self.grip = grip
        self.met: str | None = None
        self.burdens: tuple[Burden, ...] = ()
        self.pushed: Five = (0.0,) * 5
        self.leaned_on = False
        self.alone = True
        self.between: tuple[str, ...] = ()
        self.riders: tuple[str, ...] = ()
        self._bench = bench
        self._linkage = linkage
        self._telling = telling
        self._held: tuple[str, ...] = ()
        self._met: tuple[float, int] | None = None
        self._tightest = 0
        self._closely = False
        self._sights: Recurrence[Sight] = Recurrence(KNOWN)

    def __getstate__(self) -> dict[str, Any]:
        # What was seen before is seen again.
        return {**self.__dict__, "_closely": False, "_sights": Recurrence(KNOWN)}

    def clear(self) -> None:
        """Begin anew: what touches the arm is seen on the first tick, if anything strains it."""
        self.burdens, self.pushed = (), (0.0,) * 5
        self.leaned_on, self.between, self.riders = False, (), ()
        self.alone = not any(self._bench.scene.torques)

    def look(self, *, loaded: bool) -> None:
        """See from what presses on the fingers what is between them, and whether it is held.

        Args:
            loaded: whether anything rests in the hand.
        """
        recurs = self._bench.scene.recurs
        if recurs is None or not self._all_in(recurs[1]):
            self._look(loaded=loaded)
            return
        asked, moment = recurs
        parts, grip = self._bench.parts, self.grip
        held = [parts[name].held for name in moment.names]
        all_asked = asked, question(loaded, grip.cable, grip.contact, self._met, held)
        known = self._sights.get(all_asked)
        if known is None:
            presser, saw = self._look(loaded=loaded)
            self._sights.keep(all_asked, self._sight(moment, presser, saw=saw))
        else:
            self._see_again(moment, known)

    def _all_in(self, moment: Moment) -> bool:
        """Whether all that matters to the hand is among what was concerned in a tick."""
        names, links, leaning = moment.names, self._linkage.names, self._bench.scene.leaning_on
        if len(self._bench.parts) == len(names):
            return True
        return all(part.name in names for part in self._in_hand) and all(
            leaning(name) <= set(names) for name in (*names, *links)
        )

    def _sight(self, moment: Moment, presser: str | None, *, saw: bool) -> Sight:
        """What was seen."""
        grip = self.grip
        return Sight(
            (grip.contact, grip.strain) if saw else None,
            self._met,
            moment.told(self.between),
            moment.told(self.riders),
            grip.part is not None,
            self._closely,
            self.burdens,
            self.pushed,
            self.leaned_on,
            self.alone,
            moment.told([] if presser is None else [presser]),
        )

    def _see_again(self, moment: Moment, sight: Sight) -> None:
        """See the same again."""
        if sight.grip is not None:
            self.grip.contact, self.grip.strain = sight.grip
            self._met = sight.met
            if sight.closely:
                self._bench.scene.look_closely()
            self.between = tuple(moment.named(sight.between))
            self.riders = tuple(moment.named(sight.riders))
            self._have(self.between if sight.holds else ())
        self.burdens, self.pushed = sight.burdens, sight.pushed
        self.leaned_on, self.alone = sight.leaned_on, sight.alone
        presser = moment.named(sight.presser)
        self.met = said(presser[0]) if presser else None

    def _look(self, *, loaded: bool) -> tuple[str | None, bool]:
        """`look`, anew.

        Args:
            loaded: whether anything rests in the hand.

        Returns:
            What presses most on the arm, and whether it was looked at what is between the fingers.
        """
        scene, (left, right) = self._bench.scene, self._linkage.fingers
        # What sleeps in the grip stays there.
        sleeping = {part.name for part in self._in_hand if part.asleep}
        sleeping |= scene.leaning_on(left) & scene.leaning_on(right)
        if sleeping:
            for contact in scene.contacts:
                sleeping.difference_update(contact.key[:2])
        leaning = self._neighbours()
        if not sleeping:
            self._measure()
            self._hold(leaning)
        self._weigh(leaning, loaded=loaded)
        presser = self._presser()
        self.met = None if presser is None else said(presser)
        return presser, not sleeping

    @property
    def firm(self) -> bool:
        """Whether the fingers press on something that gives way no more."""
        return self.grip.contact > 0 and not self.grip.strain

    @property
    def picks_up(self) -> bool:
        """Whether the fingers press so much by now that they hold what they did not hold before."""
        return self.grip.part is None and bool(self.between) and self._carried

    @property
    def _carried(self) -> bool:
        """Whether the pads' friction carries what they press on, with all that it carries."""
        weight, friction = self.hold
        return self.grip.carries(friction) >= weight

    @property
    def hold(self) -> tuple[float, float]:
        """Ounces of all that the pads have to carry, and the coefficient of its friction."""
        parts = self._bench.parts
        names = [name for name in self.between if name in parts]
        if not names:
            return 0.0, self._pad
        weights = [parts[name].weight for name in (*names, *self.riders) if name in parts]
        return math.fsum(weights), self._roughness(names)

    def weigh(self, *, loaded: bool) -> None:
        """See what hangs in the hand and touches nothing else, and what else presses on the arm.

        Args:
            loaded: whether anything rests in the hand.
        """
        self._weigh(self._neighbours(), loaded=loaded)

    def _weigh(self, leaning: Leaning, *, loaded: bool) -> None:
        """`weigh`, by what presses on each."""
        scene, links, parts = self._bench.scene, self._linkage.names, self._bench.parts
        touched: set[str] = set().union(*[leaning(link) for link in links])
        self.leaned_on = any(name in parts for name in touched)
        loads = [load.name for load in scene.carried]
        waiting = [] if loads else [part.name for part in self._in_hand]
        while waiting:
            name = waiting.pop()
            if name in loads or name in links:
                continue
            if name not in parts:
                loads = []
                break
            loads.append(name)
            waiting += sorted(leaning(name))
        self.alone = touched <= set(loads)
        hand = scene.links[self._linkage.hand]
        found = []
        for name in loads:
            part = parts[name]
            x, y, z = apply_back(hand.turn, minus(part.place, hand.place))
            found.append(Burden(part.weight, (x - self._linkage.model.hand_length, y, z)))
        self.burdens = tuple(found) if self.alone or loaded else ()
        a, b, c, d, e, _ = scene.torques
        self.pushed = (0.0,) * 5 if self.alone else (a, b, c, d, e)

    def _measure(self) -> None:
        """Where the fingers meet what is between them, or with what strain it holds them up."""
        scene, grip, model = self._bench.scene, self.grip, self._linkage.model
        steps, opening = model.hand_steps, scene.joints[5]
        pressed = scene.torques[5] > 0 and opening > 0
        # Fingers that have met the same, or are about to: it is known where.
        room = self._room
        met = None if room is None else (scene.met_at[5] - room) * steps
        grip.strain, self._closely = 0.0, False
        if pressed and (met is not None or self._between()):
            before, self._met = self._met, (opening * steps, grip.cable)
            resists = before is not None and (
                before[0] - self._met[0] <= YIELDING * max(0, before[1] - grip.cable) + HAIR / 3
            )
            if not resists:
                self._look_closely()
            if met is not None and (resists or before is None):
                self._met_with(met, HAIR)
                return
            if resists:
                self._met_with(self._met[0], BREATH)
                return
        else:
            self._met = None
            if met is not None:
                self._look_closely()
                self._met_with(met, HAIR)
                return
        # What is pushed along or squared gives way: only what it resists with strains the cable.
        grip.contact = 0
        if pressed and self._closes_on_something:
            grip.strain = scene.torques[5] / model.stiffness[5] * steps

    def _look_closely(self) -> None:
        """Have the next tick be looked at closely."""
        self._closely = True
        self._bench.scene.look_closely()

    @property
    def _room(self) -> float | None:
        """Inches by which the fingers can close on what they are about to squeeze.

        That is one thing, or several that are about to touch one another, from the left finger to
        the right; None where there is no such thing.
        """
        left, right = self._linkage.fingers
        gaps: dict[tuple[str, str], float] = {}
        across = self._across()
        for contact in self._bench.scene.contacts:
            if pair := _onward(contact, across):
                gaps[pair] = min(contact.gap, gaps.get(pair, math.inf))
        room = {left: 0.0}
        for _ in gaps:
            for (one, other), gap in gaps.items():
                if one in room:
                    room[other] = min(room[one] + gap, room.get(other, math.inf))
        return room.get(right)

    @property
    def _closes_on_something(self) -> bool:
        """Whether either finger has something before it in the way in which the hand closes."""
        fingers, across = self._linkage.fingers, self._across()
        return any(
            (contact.key[0] in fingers or contact.key[1] in fingers)
            and _faces(contact.normal, across)
            for contact in self._bench.scene.contacts
        )

    def _met_with(self, cable: float, give: float) -> None:
        """The fingers have met with so much cable paid out; what is rigid does not breathe."""
        if not self.grip.contact or abs(cable - self.grip.contact) > give:
            self.grip.contact = max(1, round(cable))

    def _across(self) -> Vector:
        """The way in which the hand closes."""
        turn = self._bench.scene.links[self._linkage.hand].turn
        return turn[1], turn[4], turn[7]

    def _between(self) -> list[str]:
        """Parts on which the fingers press, alone or by way of others between them."""
        parts = self._bench.parts
        left, right = self._linkage.fingers
        pressing = [contact for contact in self._bench.scene.contacts if contact.pressure > 0]
        if {left, right} - {contact.key[0] for contact in pressing}:
            return []
        across = self._across()
        pairs = {
            contact.key[:2]
            for contact in pressing
            if contact.key[0] not in (left, right) or _faces(contact.normal, across)
        }
        pressed = [name for one, name in pairs if one == left and name in parts]
        reached: set[str] = set()
        waiting = list(pressed)
        while waiting:
            name = waiting.pop()
            if name in reached or name not in parts:
                continue
            reached.add(name)
            waiting += [b if a == name else a for a, b in pairs if name in (a, b)]
        gripped = [name for name in reached if (right, name) in pairs]
        if not (pressed and gripped):
            return []
        onward = {pair for contact in pressing if (pair := _onward(contact, across))}
        inside = _beyond(left, onward) & _beyond(right, {(b, a) for a, b in onward})
        found = sorted({*pressed, *gripped, *(inside & parts.keys())})
        # What lies against one finger alone, and on what both hold, passes nothing on.
        passing = [pair for contact in pressing if (pair := _onward(contact, across, SLANT))]
        ahead, behind = {one for one, _ in passing}, {other for _, other in passing}
        return [name for name in found if name in ahead and name in behind] or found

    def _hold(self, leaning: Leaning) -> None:
        """What the fingers have in their grip, with all that is between them.

        Args:
            leaning: what presses on each.
        """
        between = self._between()
        self.between = tuple(between)
        self.riders = tuple(self._riding(between, leaning)) if between else ()
        self._have(between if between and self._carried else [])

    def _riding(self, names: Sequence[str], leaning: Leaning) -> list[str]:
        """What leans on some parts, or on what leans on these, and on nothing else."""
        parts = self._bench.parts
        seen, riders = set(names), []
        for start in sorted(set().union(*[leaning(name) for name in names])):
            group, waiting = [], [start]
            while waiting:
                name = waiting.pop()
                if name in seen:
                    continue
                group.append(name)
                if name in parts:
                    seen.add(name)
                    waiting += sorted(leaning(name))
            if all(name in parts for name in group):
                riders += group
        return sorted(riders)

    def pick_up(self) -> None:
        """Have what the fingers press on, and rests, in their grip from now on."""
        self._have(self.between)

    def _have(self, between: Sequence[str]) -> None:
        """Have some parts in the hand and no others."""
        grip, parts, before = self.grip, self._bench.parts, self._in_hand
        self._held = tuple(between)
        for body in self._bench.scene.ordered({*between, *[part.name for part in before]}):
            name, part = body.name, parts[body.name]
            if part.held == (name in between):
                continue
            part.held = not part.held
            if part.held:
                self._tightest = grip.cable
                self._telling.taken(name)
            else:
                self._telling.let_go(name, part, opened=grip.cable > self._tightest)
        self._tightest = min(self._tightest, grip.cable)
        grip.part = between[0] if between else None
        grip.weight = sum(parts[name].weight for name in between)

    def _neighbours(self) -> Leaning:
        """What presses on a thing: as found on this tick, and as it was when it fell asleep."""
        parts, leaning = self._bench.parts, self._bench.scene.leaning_on
        pressing: dict[str, set[str]] = {}
        for contact in self._bench.scene.contacts:
            if contact.pressure > 0:
                one, other, _ = contact.key
                pressing.setdefault(one, set()).add(other)
                pressing.setdefault(other, set()).add(one)

        def leaning_on(name: str) -> set[str]:
            part = parts.get(name)
            touched = () if part is None else part.touching
            return {*pressing.get(name, ()), *leaning(name), *touched}

        return leaning_on

    @property
    def _in_hand(self) -> list[Part]:
        """The parts that the hand has in its grip."""
        parts = self._bench.parts
        there = [parts[body.name] for body in self._bench.scene.ordered(self._held)]
        return [part for part in there if part.held]

    def _roughness(self, names: Sequence[str]) -> float:
        """Coefficient between the pads and the smoothest of some parts."""
        return math.sqrt(self._pad * min(self._bench.parts[name].friction for name in names))

    @property
    def _pad(self) -> float:
        """Coefficient of the finger pads."""
        return self._linkage.frictions[self._linkage.names.index(self._linkage.fingers[0])]

    def _presser(self) -> str | None:
        """What presses most on the arm."""
        links = self._linkage.names
        forces: dict[str, float] = {}
        for contact in self._bench.scene.contacts:
            one, other, _ = contact.key
            name = other if one in links else one if other in links else None
            if name is not None and contact.pressure > 0:
                forces[name] = forces.get(name, 0.0) + contact.pressure
        return max(forces, key=lambda name: forces[name]) if forces else None


def _beyond(start: str, pairs: set[tuple[str, str]]) -> set[str]:
    """All that is reached from something by pairs of which the first is reached."""
    found = {start}
    while more := {other for one, other in pairs if one in found} - found:
        found |= more
    return found


def _onward(contact: Contact, across: Vector, facing: float = FACING) -> tuple[str, str] | None:
    """Two things that the closing hand presses on each other, as from the left finger on."""
    along = dot(contact.normal, across)
    if abs(along) < facing:
        return None
    one, other, _ = contact.key
    return (one, other) if along < 0 else (other, one)


def _faces(normal: Vector, across: Vector) -> bool:
    """Whether a contact is one that the closing hand presses on."""
    return abs(dot(normal, across)) >= FACING
