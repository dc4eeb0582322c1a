"""The one mechanism by which parts move: pushed, carried, tipped, stacked, dropped.

A scene holds loose bodies, things that stand fast, the table at height 0, and at most one arm. Time
goes in ticks on a grid of the clock; in each, everything that is awake moves as contact with
Coulomb friction and gravity has it (`solver`). What comes to rest falls asleep, with all that
it leans on, and costs nothing until something touches it. What rests in the hand alone goes
with the hand. Nothing here knows what a stack or a plank is.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from trs80arm.arm.contact.bodies import NOWHERE, Body, Fixed, Link, Linkage
from trs80arm.arm.contact.coasting import MOST_STEPS, Coast, Mover, apart, even, join, pace
from trs80arm.arm.contact.manifold import Manifold, Placed, between, on_table
from trs80arm.arm.contact.roster import Roster
from trs80arm.arm.contact.rotations import (
    Matrix,
    apply,
    apply_back,
    matrix,
    quaternion,
    spun,
    times,
    transposed,
    turned,
)
from trs80arm.arm.contact.solver import Contact, Key, Mobile, Problem, Side, Six, total
from trs80arm.arm.shapes import Vector, cross, dot, minus, plus

T_STATES_PER_SECOND = 1_774_080
TICK_STATES = 8192
"""T-states from tick to tick."""
TICK = TICK_STATES / T_STATES_PER_SECOND
"""The same in seconds: 4.6 milliseconds."""
GRAVITY = 386.09
"""Inches per second squared."""
SKIN = 0.01
"""Depth to which things may be found in each other, inches."""
MARGIN = 0.02
"""Gap within which two things are looked at as about to touch, inches."""
TOUCH = 0.003
"""Gap at which they do, inches."""
STILL = 0.03
"""Speed of a body's outermost point below which it hardly moves, inches a second."""
CALM_TICKS = 10
"""Ticks for which everything that leans on each other must be still to fall asleep."""
EASE = 0.02
"""Seconds in which the friction of the cables lets a strain ease off: nothing is shot away."""
EASED = 5e-5
"""Radians, and inches of the opening, by which a coordinate may lag that nothing holds back."""
HELD_FAST = 1e3
"""How many times as inert the fingers are while something rests between them."""
DRAG = 0.5
"""Part of its spin that a body loses in a second: what rolls comes to rest."""
FAR_TURN = 0.08
"""Angle (radians) that a body may turn in a step; for a greater one the step is halved."""
STRIDES = ((4, 3.0), (2, 6.0))
"""Ticks that are done at once while all that is awake moves steadily, and no faster than so many
inches a second in its outermost point."""
STEADY, UNEVEN = 0.25, 0.5
"""Inches a second by which a velocity may change in a step, or part of it: motors go in steps."""
FINEST = 8
"""Steps of a tick at most."""
TILT = 0.9962
"""Cosine of the turn of the hand, against the vertical, at which what it carries is looked at
again: five degrees."""
LOOSER, TIGHTER = 1e-9, 0.015
"""Inches of cable by which a hand may let up or tighten before its load is looked at again."""
TABLE = "\x01the table"
"""No name that anybody can give begins with an unprintable character."""
_DOWN: Vector = (0.0, 0.0, -1.0)

Pressures = list[tuple[Vector, float]]
"""Where two things press on each other, from the middle of the second if that is a body, and with
how much (impulse a second)."""


@dataclass(slots=True)
class Plate:
    """A round plate let into the table, that turns.

    Attributes:
        x: of its axis.
        y: of its axis.
        radius: inches.
        spin: radians a second, counter-clockwise from above.
    """

    x: float
    y: float
    radius: float
    spin: float = 0.0

    def surface(self, point: Vector) -> Vector:
        """Velocity of the table's surface at a point, inches a second."""
        x, y = point[0] - self.x, point[1] - self.y
        if x * x + y * y > self.radius * self.radius:
            return NOWHERE
        return (-self.spin * y, self.spin * x, 0.0)


class Scene:
    """Bodies, what stands fast, and an arm.

    Attributes:
        bodies: loose ones by name, in the order in which they came.
        fixed: what stands fast, by name.
        table_friction: coefficient of the table's surface.
        arm: the arm, or None.
        joints: the arm's six coordinates as they are: as commanded, less what the cables give.
        torques: what contact does to each coordinate: ounce inches, and ounces at the opening.
        time: T-state of the last tick.
        plate: let into the table, or None.
        contacts: of the last step, with what was found there; no part of the scene's state.
        met_at: the joints as they were where those contacts were found; no part of it either.
        went_on: whether the last tick went on as the one before: its contacts are still those.
        steps: of the solver so far, for measuring.
        solved: islands solved so far, for measuring.
    """

    def __init__(self, table_friction: float = 0.5, arm: Linkage | None = None) -> None:
        self.bodies: dict[str, Body] = {}
        self.fixed: dict[str, Fixed] = {}
        self.table_friction = table_friction
        self.arm = arm
        self.joints: list[float] = [0.0] * 6
        self.torques: list[float] = [0.0] * 6
        self.time = 0
        self.plate: Plate | None = None
        self.contacts: list[Contact] = []
        self.met_at: list[float] = [0.0] * 6
        self.went_on = False
        self.steps = 0
        self.solved = 0
        self._commands: list[float] = [0.0] * 6
        self._reached: list[float] = [0.0] * 6
        self._from: list[float] = [0.0] * 6
        self._seconds = TICK
        self._stride = 1
        self._steady = False
        self._fastest = 0.0
        self._coast: Coast | None = None
        self._way: list[float] = [0.0] * 6
        self._links: list[Link] = []
        self._link_solids: list[Placed] = []
        self._roster = Roster()
        self._pressures: dict[Key, Pressures] = {}
        self._resting: dict[str, dict[Key, Pressures]] = {}
        self._arm_moved = False
        self._arm_still = 0
        self._down_in_hand: Vector = _DOWN
        self._held_at = 0.0

    def __getstate__(self) -> dict[str, Any]:
        # Links are where the joints have them; what was measured is no part of what is.
        # Where a tick began is said anew at each, and depends on how many were asked for at once.
        nowhere = [0.0] * 6
        gone: dict[str, Any] = {"contacts": [], "met_at": nowhere, "went_on": False}
        gone["_from"] = list(nowhere)
        state = {**self.__dict__, **gone, "_links": [], "_link_solids": [], "steps": 0, "solved": 0}
        # Who does what is asked of the bodies again.
        del state["_roster"]
        return state

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._roster = Roster()
        for body in self.bodies.values():
            self._roster.enter(body)
        self._place_links()

    # Setting up

    def add(self, body: Body) -> Body:
        """Put a loose body into the scene, awake."""
        self.bodies[body.name] = body
        self._roster.enter(body)
        self.wake(body.name)
        return body

    def remove(self, name: str) -> None:
        """Take a loose body away; what leaned on it wakes."""
        body = self.bodies[name]
        self.wake(name)
        del self.bodies[body.name]
        self._roster.strike(body)
        self._forget(name)

    def clear(self) -> None:
        """Take all loose bodies away."""
        self._coast = None
        for body in self.bodies.values():
            self._roster.strike(body)
        self.bodies.clear()
        self._pressures.clear()
        self._resting.clear()

    def put_arm(self, joints: Sequence[float]) -> None:
        """Have the arm stand somewhere, its cables without tension."""
        self._commands = list(joints)
        self._reached = list(joints)
        self.joints = list(joints)
        self.torques = [0.0] * 6
        self._coast = None
        self._place_links()
        self._arm_moved = True
        self._arm_still = 0

    def command(self, joints: Sequence[float]) -> None:
        """Where the motors want the arm's six coordinates from now on."""
        if list(joints) != self._commands:
            self._commands = list(joints)
            self._arm_moved = True

    def wake(self, name: str) -> None:
        """Look at a body again, and at all that it leans on or that leans on it."""
        self._coast = None
        waiting = [name]
        while waiting:
            body = self.bodies.get(waiting.pop())
            if body is None:
                continue
            body.still = 0
            if body.asleep:
                body.asleep = False
                body.carried = None
                self._pressures.update(self._resting.pop(body.name, {}))
                waiting += body.touching
                body.touching = ()

    def turn(self, name: str, spin: float) -> None:
        """Have the surface of something fixed turn (radians a second) from now on."""
        thing = self.fixed[name]
        if thing.spin != spin:
            thing.spin = spin
            self._coast = None
            for body in list(self.bodies.values()):
                if name in body.touching:
                    self.wake(body.name)

    def jump(self, joints: Sequence[float]) -> None:
        """Have the arm be elsewhere, with what it carries, having met nothing on the way."""
        opening = self.joints[5]
        self._coast = None
        self._commands = self._reached = list(joints)
        self.joints = list(joints)
        if self.carried:
            # The hand keeps the opening at which it holds its load.
            self.joints[5] = opening
            give = self.joints[5] - self._commands[5]
            self.torques = [0.0] * 5 + [give * self.arm.stiffness[5] if self.arm else 0.0]
        else:
            self.torques = [0.0] * 6
        self._place_links()
        self._carry()

    def look_closely(self) -> None:
        """Have the next tick be a single one, and solved."""
        self._stride, self._coast = 1, None

    def take(self, names: Sequence[str]) -> None:
        """Have bodies that are at rest rest in the hand from now on."""
        self._coast = None
        for name in names:
            self._sleep(self.bodies[name], {}, True)
        self.contacts = []

    @property
    def link_solids(self) -> Sequence[Placed]:
        """The arm's links where they stand."""
        return self._link_solids

    @property
    def links(self) -> Sequence[Link]:
        """The arm's links where they stand."""
        return self._links

    @property
    def held_openings(self) -> tuple[float, float]:
        """From where to where the hand can be commanded while what rests in it goes on doing so."""
        return self._held_at - TIGHTER, self._held_at + LOOSER

    def upright_in(self, hand: Link) -> bool:
        """Whether it does with the hand turned like that: not much against the vertical."""
        return dot(apply_back(hand.turn, _DOWN), self._down_in_hand) >= TILT

    def tilt_left(self, hand: Link) -> float:
        """Radians by which a hand turned like that may turn further, at least."""
        now = max(-1.0, min(1.0, dot(apply_back(hand.turn, _DOWN), self._down_in_hand)))
        return math.acos(TILT) - math.acos(now)

    def load_at(self, load: Body, hand: Link) -> list[Placed]:
        """Where the solids of something carried would be with the hand elsewhere."""
        assert load.carried is not None
        place, turn = load.carried
        at, turned_to = plus(hand.place, apply(hand.turn, place)), times(hand.turn, turn)
        return [Placed(solid, at, turned_to) for solid in load.shape.solids]

    @property
    def arm_still(self) -> int:
        """Ticks for which the arm has been commanded nowhere else."""
        return self._arm_still

    # Time

    @property
    def quiet(self) -> bool:
        """Whether nothing moves of itself."""
        return not self._roster.awake

    @property
    def carried(self) -> list[Body]:
        """What rests in the hand."""
        return self._roster.ordered(self._roster.carried.values())

    @property
    def due(self) -> int:
        """T-state of the next tick."""
        return self.time + self._stride * TICK_STATES

    def advance(self, time: int) -> None:
        """Do all ticks up to a T-state."""
        while self.due <= time:
            if not self._arm_moved and self.quiet:
                self.time += (time - self.time) // TICK_STATES * TICK_STATES
                return
            self.tick()

    def tick(self) -> None:
        """Let one tick pass, or some at once while all goes on steadily and slowly.

        While something turns fast it is done in several steps.
        """
        self.time = self.due
        moved = self._arm_moved
        self._arm_moved = False
        self._arm_still = 0 if moved else self._arm_still + self._stride
        before, after = self._reached, self._commands
        coast = None if self._something_spins() else self._coast
        share = None if coast is None else coast.share(after)
        if coast is not None and share is not None:
            self._go_on(coast, share)
            self._reached = after
            self.went_on = True
            return
        self._coast, self.went_on = None, False
        self._steady, self._fastest = True, 0.0
        self._part(before, after, 0, self._stride * FINEST, moved)
        self._commands = self._reached = after
        if self._coast is None:
            self._stride = 1
            if self._steady and not self.quiet:
                fitting = (ticks for ticks, fast in STRIDES if self._fastest <= fast)
                self._stride = max(fitting, default=1)

    def _part(
        self, before: list[float], after: list[float], start: int, end: int, moved: bool
    ) -> None:
        """Part of a tick in one step, or in two halves if something turns too far in it.

        Args:
            before: commands at the beginning of the tick.
            after: commands at its end.
            start: of the part, in `FINEST` parts of a tick.
            end: of the part.
            moved: whether the arm is commanded elsewhere in this tick.
        """
        whole = self._stride * FINEST
        self._seconds = TICK * (end - start) / FINEST
        self._from = _between(before, after, start / whole)
        self._commands = after if end == whole else _between(before, after, end / whole)
        if not self._step(moved, end - start > 1):
            middle = (start + end) // 2
            self._part(before, after, start, middle, moved)
            self._part(before, after, middle, end, moved)

    def _step(self, moved: bool, may_halve: bool) -> bool:
        """One step; whether it was made, or is too long for how fast something turns."""
        rates = self._rates()
        if moved and self.arm is not None:
            self._wake_what_the_arm_meets(rates)
            rates = self._rates()
        awake = self._roster.ordered(self._roster.awake.values())
        mobiles = {body.name: self._mobile(body) for body in awake}
        arm = self._arm_mobile(rates)
        look = moved or bool(awake) or any(self.torques)
        contacts = self._contacts(awake, mobiles, arm, rates, look)
        # Some may have been woken by what comes upon them.
        awake = [self.bodies[name] for name in mobiles]
        problems = [Problem(group, self._seconds) for group in _islands(contacts)]
        for problem in problems:
            self.solved += 1
            self.steps += problem.solve()
        if may_halve and any(_turns_far(mobiles[b.name], self._seconds) for b in awake):
            return False
        self._keep(contacts)
        before, joints = self._links, list(self.joints)
        if arm is not None:
            self._move_arm(arm, contacts, moved)
        for body in awake:
            self._move(body, mobiles[body.name])
        self._rest(awake, mobiles, contacts, before)
        if moved:
            self._carry()
        before_that, h = self._way, self._seconds
        self._way = [(a - b) / h for a, b in zip(self.joints, joints, strict=True)]
        self._coast = self._coasting(problems, mobiles, arm, before_that) if self._steady else None
        return True

    # Going on as before

    def _coasting(
        self,
        problems: list[Problem],
        mobiles: dict[str, Mobile],
        arm: Mobile | None,
        way: list[float],
    ) -> Coast | None:
        """How all goes on as in this step, if it does.

        Args:
            problems: as solved.
            mobiles: what was awake.
            arm: as solved.
            way: rates of the arm's coordinates in the step before.
        """
        h = self._seconds
        awake = [self.bodies[name] for name in mobiles]
        if self._stride == 1 or h != self._stride * TICK:
            return None
        if self._roster.carried or self._something_spins():
            return None
        if all(body.still for body in awake) or any(body.asleep for body in awake):
            return None
        levers = [1.0] * 6
        if self.arm is not None:
            reach = [self._link_reach(k) for k in range(len(self._links))]
            levers = [max(each) for each in zip(*reach, strict=True)]
        faster = pace(levers, way, self._way)
        driven: set[str] = set()
        for problem in problems:
            members = {id(mobile) for mobile in problem.mobiles}
            if id(arm) in members:
                driven |= {name for name, mobile in mobiles.items() if id(mobile) in members}
        for body in awake:
            own = faster if body.name in driven else 1.0
            if not even(mobiles[body.name], body.shape.radius, own):
                return None
        if not all(problem.settled for problem in problems):
            return None
        links, bodies = self._movers(awake)
        join(links, bodies, touching := {contact.key[:2] for contact in self.contacts})
        moves = [body.move(body.name in driven) for body in bodies]
        speeds = {id(mobiles[move.name]): (*move.velocity, *move.spin) for move in moves}
        if arm is not None:
            a, b, c, d, e, f = self._way
            speeds[id(arm)] = (a, b, c, d, e, f)
        spans = {id(mobiles[body.name]): 2 * body.shape.radius for body in awake}
        lasting = MOST_STEPS * h
        for problem in problems:
            lasting = min(lasting, problem.lasting(speeds, spans, {TABLE}))
        if lasting >= h:
            passing = {(thing.name, link) for thing in self.fixed.values() for link in thing.passes}
            lasting = self._apart(bodies, links, touching | passing, lasting)
        if lasting < h:
            return None
        gives = [a - b for a, b in zip(self._commands, self.joints, strict=True)]
        course = [rate * h for rate in self._way]
        return Coast(course, list(self._commands), levers, gives, moves, lasting / h)

    def _something_spins(self) -> bool:
        """Whether any surface turns that stands fast itself."""
        plate = self.plate is not None and self.plate.spin != 0
        return plate or any(thing.spin for thing in self.fixed.values())

    def _movers(self, awake: list[Body]) -> tuple[list[Mover], list[Mover]]:
        """The arm's links and what is awake, as they went in the last step."""
        links = []
        if self.arm is not None:
            for name, link, solid in zip(
                self.arm.names, self._links, self._link_solids, strict=True
            ):
                spin, velocity = total(link.screws, self._way)
                middle, radius = _sphere(solid)
                velocity = plus(velocity, cross(spin, middle))
                links.append(Mover(name, [solid], middle, radius, velocity, spin))
        return links, [
            Mover(body.name, body.placed, body.place, body.shape.radius, body.velocity, body.spin)
            for body in awake
        ]

    def _apart(
        self,
        bodies: list[Mover],
        links: list[Mover],
        heedless: set[tuple[str, str]],
        seconds: float,
    ) -> float:
        """For how much of some time nothing comes upon anything new, as all moves now."""
        others = [Mover(thing.name, thing.placed) for thing in self.fixed.values()]
        near: dict[str, Body] = {}
        for mover in (*bodies, *links):
            if (TABLE, mover.name) not in heedless:
                seconds = min(seconds, mover.above())
            seconds = min(seconds, mover.straight())
            speed = math.sqrt(dot(mover.velocity, mover.velocity)) + mover.turning
            for body in self._roster.near(*_around(mover.solids, speed * seconds)):
                near[body.name] = body
        others += [Mover(body.name, body.placed) for body in self._roster.ordered(near.values())]
        return apart(bodies, links, others, heedless, seconds)

    def _go_on(self, coast: Coast, share: float) -> None:
        """A step in which everything goes on as it went in the one before."""
        h = self._seconds
        for move in coast.moves:
            body, seconds = self.bodies[move.name], h * share if move.driven else h
            still = move.spin == NOWHERE
            turn = body.turn if still else turned(body.turn, move.spin, seconds)
            body.put(plus(body.place, move.velocity, seconds), turn)
        if self.arm is not None and self._commands != self._reached:
            self.joints = [a - b for a, b in zip(self._commands, coast.gives, strict=True)]
            self._place_links()

    def _rates(self) -> Six:
        """Rates at which the arm's coordinates go where they are commanded, if nothing is there.

        They follow a command at once, and ease off a strain with the cables' friction.
        """
        h = self._seconds
        a, b, c, d, e, f = (
            ((there - here) + EASE * (there - before) / h) / (h + EASE)
            for there, here, before in zip(self._commands, self.joints, self._from, strict=True)
        )
        return a, b, c, d, e, 0.0 if self._roster.carried else f

    def _mobile(self, body: Body) -> Mobile:
        """A body for the solver, gravity on it."""
        vx, vy, vz = body.velocity
        slower = 1 / (1 + DRAG * self._seconds)
        wx, wy, wz = body.spin
        speed = [vx, vy, vz - GRAVITY * self._seconds, wx * slower, wy * slower, wz * slower]
        before = (*body.velocity, *body.spin)
        return Mobile(speed, body.place, body.shape.mass, body.inertia(), before=before)

    def _arm_mobile(self, rates: Six) -> Mobile | None:
        """The arm for the solver."""
        if self.arm is None:
            return None
        a, b, c, d, e, f = (
            k * GRAVITY * self._seconds * (self._seconds + EASE) for k in self.arm.stiffness
        )
        # What rests in the hand keeps its fingers where they are.
        f *= HELD_FAST if self._roster.carried else 1.0
        return Mobile(list(rates), NOWHERE, inertias=(a, b, c, d, e, f))

    # What touches

    def _wake_what_the_arm_meets(self, rates: Six) -> None:
        """Bodies at rest that links, or what the hand carries, come upon."""
        assert self.arm is not None
        loads = self.carried
        if loads and self._tilted():
            for body in loads:
                self.wake(body.name)
            loads = []
        reach = [
            self._link_speed(i, rates) * self._seconds + TOUCH for i in range(len(self._links))
        ]
        around = _around(self._link_solids, max(reach))
        for body in self._roster.near(*around):
            if _outside(body, around):
                continue
            for solid in body.placed:
                if any(
                    _within(link, solid, margin)
                    for link, margin in zip(self._link_solids, reach, strict=True)
                ):
                    self.wake(body.name)
                    break
        for load in loads:
            if not load.asleep:
                continue
            margin = max(reach) + TOUCH
            for other, thing in self._others(load, margin):
                if other in load.touching:
                    continue
                if any(_within(mine, thing, margin) for mine in load.placed):
                    self.wake(load.name)
                    self.wake(other)
        least, most = self.held_openings
        if loads and not least <= self._commands[-1] <= most:
            for load in loads:
                self.wake(load.name)

    def _others(self, load: Body, margin: float) -> Iterator[tuple[str, Placed | None]]:
        """All that something carried could come upon; None stands for the table."""
        yield TABLE, None
        for thing in self.fixed.values():
            for solid in thing.placed:
                yield thing.name, solid
        (x, y, z), r = load.place, load.shape.radius + margin
        around = (x - r, y - r, z - r), (x + r, y + r, z + r)
        for body in (*self._roster.awake.values(), *self._roster.near(*around)):
            for solid in body.placed:
                yield body.name, solid

    def _tilted(self) -> bool:
        """Whether the hand has turned against the vertical since it took up its load."""
        assert self.arm is not None
        return not self.upright_in(self._links[self.arm.hand])

    def _link_reach(self, index: int) -> list[float]:
        """How far any point of a link moves at most for a unit of each coordinate, inches."""
        middle, radius = _sphere(self._link_solids[index])
        out = []
        for spin, velocity in self._links[index].screws:
            v = plus(velocity, cross(spin, middle))
            out.append(math.sqrt(dot(v, v)) + radius * math.sqrt(dot(spin, spin)))
        return out

    def _link_speed(self, index: int, rates: Six) -> float:
        """A bound on the speed of any point of a link, inches a second."""
        far = 0.0
        for most, rate in zip(self._link_reach(index), rates, strict=True):
            far += most * abs(rate)
        return far

    def _contacts(
        self,
        awake: list[Body],
        mobiles: dict[str, Mobile],
        arm: Mobile | None,
        rates: Six,
        look: bool,
    ) -> list[Contact]:
        """All contacts of what is awake."""
        contacts: list[Contact] = []
        fast = Side(None)
        done: set[str] = set()
        queue = list(awake)
        reach = [self._seconds * self._link_speed(k, rates) for k in range(len(self._link_solids))]
        while queue:
            body = queue.pop(0)
            if body.name in done:
                continue
            done.add(body.name)
            mine = mobiles[body.name]
            side = Side(mine)
            margin = MARGIN + self._seconds * _speed(mine.speed, body.shape.radius)
            for i, solid in enumerate(body.placed):
                met = on_table(solid, margin)
                if met is not None:
                    self._add(contacts, (TABLE, body.name, i), met, fast, side, self._on(body))
                for thing in self.fixed.values():
                    for k, other in enumerate(thing.placed):
                        met = _met(other, solid, margin)
                        if met is not None:
                            key = (thing.name, body.name, 64 * k + i)
                            rough = math.sqrt(thing.friction * body.friction)
                            self._add(contacts, key, met, fast, side, rough, thing)
                if arm is not None and self.arm is not None:
                    rough_links = self.arm.frictions
                    for k, link in enumerate(self._link_solids):
                        met = _met(link, solid, margin + reach[k])
                        if met is not None:
                            key = (self.arm.names[k], body.name, i)
                            rough = math.sqrt(rough_links[k] * body.friction)
                            other_side = Side(arm, self._links[k].screws)
                            self._add(contacts, key, met, other_side, side, rough)
            for other_body in self._about(body, margin):
                if other_body.name in done:
                    continue
                theirs = mobiles.get(other_body.name)
                wider = margin
                if theirs is not None:
                    wider += self._seconds * _speed(theirs.speed, other_body.shape.radius)
                if _close(body, other_body, wider):
                    self._pair(contacts, body, other_body, mobiles, wider, queue)
        if arm is not None and look:
            self._arm_contacts(contacts, arm, reach)
        return contacts

    def _about(self, body: Body, margin: float) -> list[Body]:
        """What is awake, and what else could be within a margin of a body."""
        roster = self._roster
        (x, y, z), r = body.place, body.shape.radius + margin
        asleep = roster.near((x - r, y - r, z - r), (x + r, y + r, z + r))
        return roster.ordered([*roster.awake.values(), *roster.carried.values(), *asleep])

    def _pair(
        self,
        contacts: list[Contact],
        body: Body,
        other: Body,
        mobiles: dict[str, Mobile],
        margin: float,
        queue: list[Body],
    ) -> None:
        """Contacts of two bodies, the second of which may wake by them."""
        for i, solid in enumerate(body.placed):
            for k, theirs in enumerate(other.placed):
                met = _met(theirs, solid, margin)
                if met is None:
                    continue
                if other.asleep and not body.still and _about_to_touch(met, margin):
                    self.wake(other.name)
                    for woken in self._roster.ordered(self._roster.awake.values()):
                        if woken.name not in mobiles:
                            mobiles[woken.name] = self._mobile(woken)
                            queue.append(woken)
                # What lies calmly against a sleeper lets it sleep.
                sides = Side(mobiles.get(other.name)), Side(mobiles[body.name])
                rough = math.sqrt(body.friction * other.friction)
                self._add(contacts, (other.name, body.name, 64 * k + i), met, *sides, rough)

    def _arm_contacts(self, contacts: list[Contact], arm: Mobile, reach: list[float]) -> None:
        """Links against what stands fast; `reach` is how far each may move in this step."""
        assert self.arm is not None
        fast = Side(None)
        for k, link in enumerate(self._link_solids):
            side = Side(arm, self._links[k].screws)
            name, rough = self.arm.names[k], self.arm.frictions[k]
            margin = MARGIN + reach[k]
            met = on_table(link, margin)
            if met is not None:
                friction = math.sqrt(rough * self.table_friction)
                self._add(contacts, (TABLE, name, 0), met, fast, side, friction)
            for thing in self.fixed.values():
                if name in thing.passes:
                    continue
                for i, solid in enumerate(thing.placed):
                    met = _met(solid, link, margin)
                    if met is not None:
                        friction = math.sqrt(rough * thing.friction)
                        self._add(contacts, (thing.name, name, i), met, fast, side, friction, thing)

    def _on(self, body: Body) -> float:
        """Friction of a body on the table."""
        return math.sqrt(body.friction * self.table_friction)

    def _add(
        self,
        contacts: list[Contact],
        key: Key,
        met: Manifold,
        first: Side,
        second: Side,
        friction: float,
        thing: Fixed | None = None,
    ) -> None:
        """Contacts of a manifold, beginning with the forces of the tick before."""
        known = self._pressures.get(key, [])
        x, y, z = second.mobile.place if second.mobile is not None else NOWHERE
        for point, gap in met.points:
            surface = NOWHERE
            if thing is not None and thing.spin:
                u, v = point[0] - thing.axis[0], point[1] - thing.axis[1]
                surface = (-thing.spin * v, thing.spin * u, 0.0)
            elif self.plate is not None and self.plate.spin and key[0] == TABLE:
                surface = self.plate.surface(point)
            contact = Contact(key, point, gap, met.normal, first, second, friction, surface)
            best, nearest = None, 0.01
            a, b, c = point[0] - x, point[1] - y, point[2] - z
            for (i, j, k), pressure in known:
                square = (i - a) * (i - a) + (j - b) * (j - b) + (k - c) * (k - c)
                if square < nearest:
                    best, nearest = pressure, square
            if best is not None:
                contact.pressure = best * self._seconds
            contacts.append(contact)

    def _keep(self, contacts: list[Contact]) -> None:
        """Remember the forces for the next tick."""
        self.contacts, self.met_at = contacts, list(self.joints)
        kept: dict[Key, Pressures] = {}
        for contact in contacts:
            mobile = contact.second.mobile
            if contact.pressure > 0 and mobile is not None:
                kept.setdefault(contact.key, []).append(
                    (minus(contact.point, mobile.place), contact.pressure / self._seconds)
                )
        for key, pressures in self._pressures.items():
            # What sleeps still presses.
            body = self.bodies.get(key[1])
            if key not in kept and body is not None and body.asleep:
                self._resting.setdefault(body.name, {})[key] = pressures
        self._pressures = kept

    def _forget(self, name: str) -> None:
        self._resting.pop(name, None)
        for pressures in (self._pressures, *self._resting.values()):
            for key in [key for key in pressures if name in key[:2]]:
                del pressures[key]

    # Moving

    def _move(self, body: Body, mobile: Mobile) -> None:
        """Move a body for a tick with the velocities that the solver has found."""
        vx, vy, vz, wx, wy, wz = mobile.speed
        radius = body.shape.radius
        change = [a - b for a, b in zip(mobile.speed, mobile.before or (), strict=True)]
        speed = _speed(mobile.speed, radius)
        self._fastest = max(self._fastest, speed)
        if _speed(change, radius) > max(STEADY, UNEVEN * speed):
            self._steady = False
        h = self._seconds
        body.velocity, body.spin, turn = (vx, vy, vz), (wx, wy, wz), body.turn
        if wx or wy or wz:
            turn, body.spin = spun(turn, body.spin, body.shape.inertia, body.shape.ease, h)
        if vx or vy or vz or wx or wy or wz:
            body.put(plus(body.place, body.velocity, h), turn)

    def _move_arm(self, arm: Mobile, contacts: list[Contact], moved: bool) -> None:
        """Move the arm for a tick; find what contact does to its motors."""
        assert self.arm is not None
        touched = any(
            contact.pressure > 0 and (contact.first.mobile is arm or contact.second.mobile is arm)
            for contact in contacts
        )
        if not touched and not moved and (not any(self.torques) or self._leaned_on()):
            return
        for k in range(6):
            self.joints[k] += arm.speed[k] * self._seconds
        held = 1 if self._roster.carried else 0
        gives = [a - b for a, b in zip(self._commands, self.joints, strict=True)]
        if not touched and all(abs(give) < EASED for give in gives[: 6 - held]):
            # What holds a load keeps the opening at which it does.
            self.joints[: 6 - held] = self._commands[: 6 - held]
            gives[: 6 - held] = [0.0] * (6 - held)
        for k in range(6):
            self.torques[k] = -gives[k] * self.arm.stiffness[k]
        self._place_links()

    def _leaned_on(self) -> bool:
        """Whether something that sleeps leans on the arm and on other things too."""
        assert self.arm is not None
        return any(
            body.asleep and body.carried is None and name in body.touching
            for body in self.bodies.values()
            for name in self.arm.names
        )

    def _place_links(self) -> None:
        if self.arm is not None:
            self._links = self.arm.links(self.joints)
            self._link_solids = [
                Placed(solid, link.place, link.turn)
                for solid, link in zip(self.arm.solids, self._links, strict=True)
            ]

    def _carry(self) -> None:
        """Take along what rests in the hand."""
        if self.arm is None:
            return
        link = self._links[self.arm.hand]
        for body in self.carried:
            assert body.carried is not None
            place, turn = body.carried
            body.put(plus(link.place, apply(link.turn, place)), quaternion(times(link.turn, turn)))

    # Rest

    def _rest(
        self,
        awake: list[Body],
        mobiles: dict[str, Mobile],
        contacts: list[Contact],
        before: list[Link],
    ) -> None:
        """Let what hardly moves fall asleep, with all that it leans on."""
        if not awake:
            return
        leaning: dict[str, set[str]] = {}
        links = set(self.arm.names) if self.arm is not None else set()
        for contact in contacts:
            if contact.pressure > 0:
                one, other = contact.key[:2]
                leaning.setdefault(one, set()).add(other)
                leaning.setdefault(other, set()).add(one)
        seen: set[str] = set()
        for body in awake:
            if body.name in seen or body.asleep:
                continue
            group, outside = self._group(body, leaning, seen, links)
            held = bool(outside & links)
            loose = not outside - links
            for each in group:
                each.still = (
                    each.still + self._stride if self._calm(each, held and loose, before) else 0
                )
            if any(each.still < CALM_TICKS for each in group) or not outside:
                continue
            if held and not loose and self._arm_still < CALM_TICKS:
                continue
            for each in group:
                self._sleep(each, leaning, held and loose)

    def _group(
        self, body: Body, leaning: dict[str, set[str]], seen: set[str], links: set[str]
    ) -> tuple[list[Body], set[str]]:
        """Bodies that lean on each other, and what else they lean on."""
        group, outside, waiting = [], set(), [body.name]
        while waiting:
            name = waiting.pop()
            if name in seen:
                continue
            member = self.bodies.get(name)
            if member is None or member.asleep:
                outside.add(name)
                continue
            seen.add(name)
            group.append(member)
            waiting += sorted(leaning.get(name, ()))
        return group, outside

    def _calm(self, body: Body, with_hand: bool, before: list[Link]) -> bool:
        """Whether a body hardly moves, in the hand if it lies there."""
        velocity, spin = body.velocity, body.spin
        if with_hand and self.arm is not None:
            now, then = self._links[self.arm.hand], before[self.arm.hand]
            here = apply_back(now.turn, minus(body.place, now.place))
            earlier = minus(minus(body.place, then.place), _scaled(velocity, self._seconds))
            velocity = _scaled(minus(here, apply_back(then.turn, earlier)), 1 / self._seconds)
            if now.turn != then.turn:
                spin = minus(spin, _spin(then.turn, now.turn, self._seconds))
        return _speed([*velocity, *spin], body.shape.radius) < STILL

    def _sleep(self, body: Body, leaning: dict[str, set[str]], in_hand: bool) -> None:
        body.asleep = True
        body.velocity = body.spin = NOWHERE
        body.touching = tuple(sorted(leaning.get(body.name, ())))
        if in_hand and self.arm is not None:
            link = self._links[self.arm.hand]
            place = apply_back(link.turn, minus(body.place, link.place))
            body.carried = place, times(transposed(link.turn), matrix(body.turn))
            self._down_in_hand = apply_back(link.turn, _DOWN)
            self._held_at = self._commands[-1]


def _about_to_touch(met: Manifold, margin: float) -> bool:
    """Whether a gap is closed, or will be in this step."""
    return min(gap for _, gap in met.points) <= max(TOUCH, margin - MARGIN)


def _between(before: Sequence[float], after: Sequence[float], share: float) -> list[float]:
    """Numbers part of the way from some to others."""
    return [a + (b - a) * share for a, b in zip(before, after, strict=True)]


def _turns_far(mobile: Mobile, seconds: float) -> bool:
    """Whether a body turns farther in a step than contact can be taken as straight."""
    a, b, c = mobile.speed[3:]
    return (a * a + b * b + c * c) * seconds * seconds > FAR_TURN * FAR_TURN


def _scaled(v: Vector, factor: float) -> Vector:
    return v[0] * factor, v[1] * factor, v[2] * factor


def _spin(before: Matrix, now: Matrix, seconds: float) -> Vector:
    """Radians a second at which a frame has turned in the last step."""
    m = times(now, transposed(before))
    half = 1 / (2 * seconds)
    return (m[7] - m[5]) * half, (m[2] - m[6]) * half, (m[3] - m[1]) * half


def _speed(speed: Sequence[float], radius: float) -> float:
    """A bound on the speed of any point of a body, inches a second."""
    a, b, c, d, e, f = speed
    return math.sqrt(a * a + b * b + c * c) + radius * math.sqrt(d * d + e * e + f * f)


def _close(body: Body, other: Body, margin: float) -> bool:
    """Whether the spheres around two bodies are within a margin of each other."""
    d = minus(body.place, other.place)
    reach = body.shape.radius + other.shape.radius + margin
    return dot(d, d) <= reach * reach


def _met(first: Placed, second: Placed, margin: float) -> Manifold | None:
    """How two solids touch, if they are near."""
    return between(first, second, margin) if first.near(second, margin) else None


def _around(solids: Sequence[Placed], margin: float) -> tuple[Vector, Vector]:
    """The upright box around some solids, wider by a margin: least and greatest x, y, z."""
    xs, ys, zs = zip(*(solid.low for solid in solids), strict=True)
    us, vs, ws = zip(*(solid.high for solid in solids), strict=True)
    low = (min(xs) - margin, min(ys) - margin, min(zs) - margin)
    return low, (max(us) + margin, max(vs) + margin, max(ws) + margin)


def _sphere(solid: Placed) -> tuple[Vector, float]:
    """Middle and radius of a sphere around a solid."""
    (a, b, c), (d, e, f) = solid.low, solid.high
    x, y, z = (d - a) / 2, (e - b) / 2, (f - c) / 2
    return (a + x, b + y, c + z), math.sqrt(x * x + y * y + z * z)


def _outside(body: Body, around: tuple[Vector, Vector]) -> bool:
    """Whether the sphere around a body is outside an upright box."""
    (a, b, c), (d, e, f) = around
    x, y, z = body.place
    r = body.shape.radius
    return x + r < a or x - r > d or y + r < b or y - r > e or z + r < c or z - r > f


def _within(mine: Placed, solid: Placed | None, margin: float) -> bool:
    """Whether a solid is within a margin of another, or of the table."""
    if solid is None:
        return mine.low[2] <= margin
    return mine.near(solid, margin) and _gap(mine, solid, margin) <= margin


def _gap(a: Placed, b: Placed, margin: float) -> float:
    """Least gap of two solids, inches; more than the margin if they are farther apart."""
    met = between(a, b, margin)
    return math.inf if met is None else min(gap for _, gap in met.points)


def _islands(contacts: list[Contact]) -> list[list[Contact]]:
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
