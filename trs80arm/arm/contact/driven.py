"""The arm in a scene: links on six coordinates, each driven by a motor through a cable that gives.

Motors command the coordinates. Where nothing is in the way they are there at once; what is
stretches the cables, and comes back to the motors as torque.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from trs80arm.arm.contact.bodies import NOWHERE, Link, Linkage
from trs80arm.arm.contact.bounds import NEARBY, spheres_around
from trs80arm.arm.contact.clock import TICK
from trs80arm.arm.contact.contacts import Contact, Mobile
from trs80arm.arm.contact.manifold import Placed
from trs80arm.arm.contact.recurrence import Recurrence, question
from trs80arm.arm.contact.sixes import Six
from trs80arm.arm.shapes import Vector

GRAVITY = 386.09
"""Inches per second squared."""
EASE = 0.02
"""Seconds in which the friction of the cables lets a strain ease off: nothing is shot away."""
EASED = 5e-5
"""Radians, and inches of the opening, by which a coordinate may lag that nothing holds back."""
BESIDE = 8
"""Solids of which it is known whether they are near to the arm that stands somewhere."""
STANDINGS = 256
"""Places of the arm whose links are known at once."""
HELD_FAST = 1e3
"""How many times as inert the fingers are while something rests between them."""


class Standing:
    """An arm that stands somewhere; what not everybody asks is worked out when asked for.

    Args:
        linkage: its links, or None.
        joints: its six coordinates.

    Attributes:
        linkage: its links.
        links: where they stand.
        solids: the same as solids.
    """

    __slots__ = ("_around", "_beside", "_reaches", "linkage", "links", "solids")

    def __init__(self, linkage: Linkage | None, joints: Sequence[float]) -> None:
        self.linkage = linkage
        self.links: Sequence[Link] = ()
        self.solids: Sequence[Placed] = ()
        if linkage is not None:
            self.links = links = linkage.links(joints)
            self.solids = [
                Placed(solid, link.place, link.turn)
                for solid, link in zip(linkage.solids, links, strict=True)
            ]
        self._around: tuple[Vector, Vector] | None = None
        self._beside: Recurrence[bool] | None = None
        self._reaches: dict[int, list[float]] = {}

    def reach(self, coordinate: int) -> Sequence[float]:
        """How far any point of each link moves at most for a unit of a coordinate, inches."""
        known = self._reaches.get(coordinate)
        if known is None:
            self._reaches[coordinate] = known = []
            for link, solid in zip(self.links, self.solids, strict=True):
                (a, b, c), (u, v, w) = link.screws[coordinate]
                turning = 0.0
                if a or b or c:
                    x, y, z = solid.middle
                    u, v, w = u + b * z - c * y, v + c * x - a * z, w + a * y - b * x
                    turning = solid.solid.radius * math.sqrt(a * a + b * b + c * c)
                known.append(math.sqrt(u * u + v * v + w * w) + turning)
        return known

    @property
    def around(self) -> tuple[Vector, Vector]:
        """An upright box around the spheres about all links."""
        if self._around is None:
            self._around = spheres_around(self.solids, [0.0] * len(self.solids))
        return self._around

    def beside(self, solid: Placed) -> bool:
        """Whether a solid is within `NEARBY` of a link."""
        if self._beside is None:
            self._beside = Recurrence(BESIDE)
        known = self._beside.get(solid.told)
        if known is None:
            # Most often it is by the fingers.
            near = any(link.near(solid, NEARBY) for link in reversed(self.solids))
            known = self._beside.keep(solid.told, near)
        return known

    @property
    def fingers(self) -> tuple[str, ...]:
        """Names of the links that the last coordinate moves."""
        names = () if self.linkage is None else self.linkage.names
        return tuple(
            name for name, link in zip(names, self.links, strict=True) if any(link.screws[5][1])
        )


class DrivenArm:
    """The arm of a scene; there may be none.

    Attributes:
        linkage: its links, or None.
        joints: its six coordinates as they are: as commanded, less what the cables give.
        torques: what contact does to each coordinate: ounce inches, and ounces at the opening.
        commands: where the motors want the coordinates.
        reached: the commands at the end of the last tick.
        began: the commands at the beginning of a step.
        way: rates of the coordinates in the last step.
        moved: whether it has been commanded elsewhere since the last tick.
        still: ticks for which it has been commanded nowhere else.
        standing: ticks for which only the hand has been.
    """

    _led: tuple[bytes, Standing] = b"", Standing(None, ())
    """Where it was last looked at whether it could go, by the question; no part of its state."""

    def __init__(self, linkage: Linkage | None) -> None:
        self._standing: Standing | None = None
        self._stood: Recurrence[Standing] = Recurrence(STANDINGS)
        self._linkage = linkage
        self.joints: list[float] = [0.0] * 6
        self.torques: list[float] = [0.0] * 6
        self.commands: list[float] = [0.0] * 6
        self.reached: list[float] = [0.0] * 6
        self.began: list[float] = [0.0] * 6
        self.way: list[float] = [0.0] * 6
        self.moved = False
        self.still = 0
        self.standing = 0

    def __getstate__(self) -> dict[str, Any]:
        # Links are where the joints have them. Where a step began is said anew at each, and depends
        # on how many were asked for at once.
        nowhere: dict[str, Any] = {"_standing": None, "_stood": Recurrence(STANDINGS)}
        state = {**self.__dict__, "began": [0.0] * 6, **nowhere}
        state.pop("_led", None)
        return state

    @property
    def linkage(self) -> Linkage | None:
        """Its links, or None."""
        return self._linkage

    @linkage.setter
    def linkage(self, linkage: Linkage | None) -> None:
        self._linkage = linkage
        self._standing, self._stood = None, Recurrence(STANDINGS)
        self._led = b"", Standing(None, ())

    @property
    def _there(self) -> Standing:
        """What follows from where the joints are."""
        if self._standing is None:
            asked = question(self.joints)
            known = self._stood.get(asked)
            if known is None:
                # Most ways that were looked at where they lead are gone.
                led, there = self._led
                if led == asked and there.linkage is self._linkage:
                    known = there
                else:
                    known = Standing(self._linkage, self.joints)
                self._stood.keep(asked, known)
            self._standing = known
        return self._standing

    @property
    def links(self) -> Sequence[Link]:
        """Where the links stand."""
        return self._there.links

    @property
    def solids(self) -> Sequence[Placed]:
        """The links as solids, where they stand."""
        return self._there.solids

    @property
    def around(self) -> tuple[Vector, Vector]:
        """An upright box around the spheres about all links."""
        return self._there.around

    def beside(self, solids: Sequence[Placed]) -> bool:
        """Whether any of some solids is within `NEARBY` of a link."""
        there = self._there
        return any(there.beside(solid) for solid in solids)

    @property
    def names(self) -> Sequence[str]:
        """Of the links."""
        return () if self.linkage is None else self.linkage.names

    @property
    def fingers(self) -> tuple[str, ...]:
        """Names of the links that the last coordinate moves."""
        return self._there.fingers

    @property
    def hand(self) -> Link:
        """The link in whose frame things are carried."""
        assert self.linkage is not None
        return self.links[self.linkage.hand]

    @property
    def gives(self) -> list[float]:
        """How far each coordinate is behind its command."""
        return [a - b for a, b in zip(self.commands, self.joints, strict=True)]

    # Being somewhere

    def put(self, joints: Sequence[float]) -> None:
        """Stand somewhere, the cables without tension."""
        self.commands = list(joints)
        self.reached = list(joints)
        self.joints = list(joints)
        self.torques = [0.0] * 6
        self.place()
        self.moved = True
        self.still = self.standing = 0

    def jump(self, joints: Sequence[float], *, loaded: bool) -> None:
        """Be elsewhere, having met nothing on the way.

        Args:
            joints: where.
            loaded: whether something rests in the hand, which keeps the opening at which it does.
        """
        opening = self.joints[5]
        self.commands = self.reached = list(joints)
        self.joints = list(joints)
        self.way = [0.0] * 6
        self.torques = [0.0] * 6
        if loaded:
            self.joints[5] = opening
            give = self.joints[5] - self.commands[5]
            self.torques[5] = give * self.linkage.stiffness[5] if self.linkage is not None else 0.0
        self.place()

    def command(self, joints: Sequence[float]) -> None:
        """Where the motors want the six coordinates from now on."""
        if list(joints) != self.commands:
            self.commands = list(joints)
            self.moved = True

    def place(self) -> None:
        """Have the links be where the joints have them from now on."""
        self._standing = None

    # Moving

    def rates(self, seconds: float, *, loaded: bool) -> Six:
        """Rates at which the coordinates go where they are commanded, if nothing is there.

        They follow a command at once, and ease off a strain with the cables' friction.

        Args:
            seconds: length of the step.
            loaded: whether something rests in the hand.
        """
        return _rates(self.joints, self.began, self.commands, seconds, loaded=loaded)

    def eased(
        self,
        joints: Sequence[float],
        before: Sequence[float],
        after: Sequence[float],
        *,
        loaded: bool,
    ) -> list[float]:
        """Joints after a tick in which nothing touches the arm but what rests in its hand.

        Args:
            joints: before.
            before: where the motors wanted them then.
            after: where they want them in the end.
            loaded: whether something rests in the hand, which keeps the opening at which it does.
        """
        rates = _rates(joints, before, after, TICK, loaded=loaded)
        moved = [at + rate * TICK for at, rate in zip(joints, rates, strict=True)]
        held = 1 if loaded else 0
        if all(abs(a - b) < EASED for a, b in zip(after[: 6 - held], moved, strict=False)):
            moved[: 6 - held] = after[: 6 - held]
        return moved

    def ease(self, joints: Sequence[float], commands: Sequence[float]) -> None:
        """Be where a tick has led in which nothing touched the arm.

        Args:
            joints: as `eased` has them.
            commands: where the motors want them.
        """
        assert self.linkage is not None
        self.joints, self.commands = list(joints), list(commands)
        self.reached = self.commands
        self.torques = [
            (here - there) * stiff
            for here, there, stiff in zip(joints, commands, self.linkage.stiffness, strict=True)
        ]
        self.place()

    def squeeze(self, commands: Sequence[float]) -> None:
        """Have the motors want the hand otherwise, which stays as it is around what it grips."""
        assert self.linkage is not None
        self.commands = self.reached = list(commands)
        self.torques[5] = (self.joints[5] - commands[5]) * self.linkage.stiffness[5]

    def mobile(self, rates: Six, seconds: float, *, loaded: bool) -> Mobile | None:
        """The arm for the solver; None without one.

        Args:
            rates: of the coordinates, if nothing is there.
            seconds: length of the step.
            loaded: whether something rests in the hand, and keeps its fingers where they are.
        """
        if self.linkage is None:
            return None
        a, b, c, d, e, f = (
            k * GRAVITY * seconds * (seconds + EASE) for k in self.linkage.stiffness
        )
        f *= HELD_FAST if loaded else 1.0
        inertias = (a, b, c, d, e, f)
        return Mobile(list(rates), NOWHERE, inertias=inertias, before=tuple(self.way))

    def reach(self, coordinate: int) -> Sequence[float]:
        """How far any point of each link moves at most for a unit of a coordinate, inches."""
        return self._there.reach(coordinate)

    def speeds(self, rates: Sequence[float]) -> list[float]:
        """Bounds on the speed of any point of each link, inches a second."""
        speeds = [0.0] * len(self.names)
        for coordinate, rate in enumerate(rates):
            # Most often all but one coordinate stand, or none.
            if rate:
                fast = abs(rate)
                for link, far in enumerate(self.reach(coordinate)):
                    speeds[link] += far * fast
        return speeds

    def repeat(
        self, joints: Sequence[float], torques: Sequence[float], way: Sequence[float]
    ) -> None:
        """Be where a tick of the same beginning has led, with the same torques and rates."""
        self.joints, self.torques, self.way = list(joints), list(torques), list(way)
        self.place()

    def touched(self, mobile: Mobile, contacts: Sequence[Contact]) -> bool:
        """Whether anything presses on it."""
        return any(
            contact.pressure > 0
            and (contact.first.mobile is mobile or contact.second.mobile is mobile)
            for contact in contacts
        )

    def at(self, joints: list[float]) -> Standing:
        """The arm if it stood somewhere; when it goes there next nothing is worked out again.

        Args:
            joints: its six coordinates there.
        """
        there = Standing(self._linkage, joints)
        self._led = question(joints), there
        return there

    def led(self, mobile: Mobile, seconds: float) -> Sequence[Placed]:
        """The links as solids, where a step leads them.

        Args:
            mobile: the arm as solved.
            seconds: length of the step.
        """
        moved = [at + rate * seconds for at, rate in zip(self.joints, mobile.speed, strict=True)]
        return self.at(moved).solids

    def move(self, mobile: Mobile, seconds: float, *, touched: bool, loaded: bool) -> None:
        """Move for a step; find what contact does to the motors.

        Args:
            mobile: the arm as solved.
            seconds: length of the step.
            touched: whether anything presses on it.
            loaded: whether something rests in the hand.
        """
        assert self.linkage is not None
        for k in range(6):
            self.joints[k] += mobile.speed[k] * seconds
        held = 1 if loaded else 0
        gives = self.gives
        if not touched and all(abs(give) < EASED for give in gives[: 6 - held]):
            # What holds a load keeps the opening at which it does.
            self.joints[: 6 - held] = self.commands[: 6 - held]
            gives[: 6 - held] = [0.0] * (6 - held)
        for k in range(6):
            self.torques[k] = -gives[k] * self.linkage.stiffness[k]
        self.place()


def _rates(
    joints: Sequence[float],
    before: Sequence[float],
    after: Sequence[float],
    seconds: float,
    *,
    loaded: bool,
) -> Six:
    """Rates at which joints go from where they are to where they are wanted in the end."""
    late = seconds + EASE
    found = []
    for there, here, then in zip(after, joints, before, strict=True):
        # How much of its motor's way a joint goes along with at once: all of it, but for what only
        # takes back a strain, which presses until it is gone.
        if there > then:
            least = here if here > then else then
            followed = there - (there if there < least else least)
        elif here == there and here:
            found.append(0.0)
            continue
        else:
            most = here if here < then else then
            followed = there - (there if there > most else most)
        found.append(((there - here) + EASE * followed / seconds) / late)
    a, b, c, d, e, f = found
    return a, b, c, d, e, 0.0 if loaded else f
