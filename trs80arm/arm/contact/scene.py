"""The one mechanism by which parts move: pushed, carried, tipped, stacked, dropped.

A scene holds loose bodies, things that stand fast, the table at height 0, and at most one arm. Time
goes in ticks (`clock`); in each, everything that is awake moves as contact with
Coulomb friction and gravity has it (`solver`). What comes to rest falls asleep, with all that
it leans on, and costs nothing until something touches it. What rests in the hand alone goes
with the hand. Nothing here knows what a stack or a plank is.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from typing import Any

from trs80arm.arm.contact.bodies import NOWHERE, Body, Fixed, Link, Linkage
from trs80arm.arm.contact.bounds import NEARBY, greatest_speed
from trs80arm.arm.contact.carrying import Carrying, carry
from trs80arm.arm.contact.clock import TICK, TICK_STATES
from trs80arm.arm.contact.coasting import Coast
from trs80arm.arm.contact.contacts import Contact, Key, Mobile
from trs80arm.arm.contact.diving import Ending
from trs80arm.arm.contact.driven import GRAVITY, DrivenArm
from trs80arm.arm.contact.manifold import Placed
from trs80arm.arm.contact.meeting import MARGIN, Meeting, islands, presses
from trs80arm.arm.contact.memory import Memory
from trs80arm.arm.contact.moment import Moment, Outcome, concerned
from trs80arm.arm.contact.prospect import Prospect
from trs80arm.arm.contact.recurrence import Recurrence
from trs80arm.arm.contact.rest import CALM_TICKS, Group, calm, groups, leaning
from trs80arm.arm.contact.roster import Roster
from trs80arm.arm.contact.rotations import matrix, times, transposed, turned
from trs80arm.arm.contact.rousing import Rousing
from trs80arm.arm.contact.sixes import Six
from trs80arm.arm.contact.solver import Problem
from trs80arm.arm.contact.table import Plate
from trs80arm.arm.shapes import Vector, plus

DRAG = 0.5
"""Part of its spin that a body loses in a second: what rolls comes to rest."""
FAR_TURN = 0.08
"""Angle (radians) that a body may turn in a step; for a greater one the step is halved."""
STRIDES = ((4, 3.0), (2, 6.0))
"""Ticks that are done at once while all that is awake moves steadily, and no faster than so many
inches a second in its outermost point."""
STEADY, UNEVEN = 0.25, 0.5
"""Inches a second by which a velocity may change in a step, or part of it: motors go in steps."""
FINEST = 16
"""Steps of a tick at most."""
OUTCOMES = 512
"""Ticks of which it is known what comes of them."""

_Result = tuple[Outcome, list[float], float, bool, float]
"""Of a tick: what came of it, at which joints, how fast and how steadily, in how long a step."""


class Scene:
    """Bodies, what stands fast, and an arm.

    Attributes:
        bodies: loose ones by name, in the order in which they came.
        fixed: what stands fast, by name.
        table_friction: coefficient of the table's surface.
        driven: the arm.
        carrying: how what rests in its hand is held.
        time: T-state of the last tick.
        plates: let into the table.
        met_at: the joints as they were where those contacts were found; no part of it either.
        went_on: whether the last tick went on as the one before: its contacts are still those.
        recurs: the last tick as a question, if all that came of it follows from that; no part of
            the scene's state.
        steps: of the solver so far, for measuring.
        solved: islands solved so far, for measuring.
    """

    def __init__(self, table_friction: float = 0.5, arm: Linkage | None = None) -> None:
        self.bodies: dict[str, Body] = {}
        self.fixed: dict[str, Fixed] = {}
        self.table_friction = table_friction
        self.driven = DrivenArm(arm)
        self.carrying = Carrying()
        self.time = 0
        self.plates: list[Plate] = []
        self._contacts: list[Contact] = []
        self._again: tuple[Moment, Outcome] | None = None
        self.met_at: list[float] = [0.0] * 6
        self.went_on = False
        self.recurs: tuple[bytes, Moment] | None = None
        self.steps = 0
        self.solved = 0
        self._seconds = TICK
        self._stride = 1
        self._steady = False
        self._fastest = 0.0
        self._reach = 0.0
        self._far = False
        self._coast: Coast | None = None
        self._roster = Roster()
        self._memory = Memory()
        self._outcomes: Recurrence[_Result] = Recurrence(OUTCOMES)

    def __getstate__(self) -> dict[str, Any]:
        # What was measured is no part of what is.
        gone: dict[str, Any] = {
            "_contacts": [],
            "_again": None,
            "met_at": [0.0] * 6,
            "went_on": False,
        }
        gone |= {"recurs": None, "steps": 0, "solved": 0, "_reach": 0.0, "_far": False}
        state = {**self.__dict__, **gone}
        # Who does what is asked of the bodies again; what was found before is found again.
        del state["_roster"], state["_outcomes"]
        return state

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._outcomes = Recurrence(OUTCOMES)
        self._roster = Roster()
        for body in self.bodies.values():
            self._roster.enter(body)

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
        self._memory.forget(name)

    def stand(self, thing: Fixed) -> Fixed:
        """Have something stand fast from now on."""
        self._coast = None
        self.fixed[thing.name] = thing
        return thing

    def take_away(self, name: str) -> None:
        """Have something fixed stand no more, if it does; what leaned on it wakes."""
        self._coast = None
        self.fixed.pop(name, None)
        self._memory.forget(name)
        for body in list(self.bodies.values()):
            if name in body.touching:
                self.wake(body.name)

    def clear(self) -> None:
        """Take all loose bodies away."""
        self._coast = None
        for body in self.bodies.values():
            self._roster.strike(body)
        self.bodies.clear()
        self._memory.clear()

    @property
    def arm(self) -> Linkage | None:
        """The arm, or None."""
        return self.driven.linkage

    @arm.setter
    def arm(self, linkage: Linkage | None) -> None:
        self.driven.linkage = linkage
        self.driven.place()
        self._outcomes = Recurrence(OUTCOMES)

    def put_arm(self, joints: Sequence[float]) -> None:
        """Have the arm stand somewhere, its cables without tension."""
        self._coast = None
        self.driven.put(joints)

    def command(self, joints: Sequence[float]) -> None:
        """Where the motors want the arm's six coordinates from now on."""
        self.driven.command(joints)

    def wake(self, name: str) -> None:
        """Look at a body again, and at all that it leans on or that leans on it."""
        self._coast = None
        waiting = [name]
        while waiting:
            body = self.bodies.get(waiting.pop())
            if body is None:
                continue
            if body.name in self.carrying.gripped:
                # It was at rest with the hand, and may go on being so while that moves.
                self.carrying.gripped = []
            else:
                body.still = 0
            if body.asleep:
                body.asleep = False
                body.carried = None
                self._memory.wake(body.name)
                waiting += body.touching
                body.touching = ()

    def carry(self, name: str, velocity: Vector) -> None:
        """Have the upper side of something carry what lies on it from now on, if it stands."""
        thing = self.fixed.get(name)
        if thing is not None and thing.carries != velocity:
            thing.carries = velocity
            self._coast = None
            for body in list(self.bodies.values()):
                if name in body.touching:
                    self.wake(body.name)

    def jump(self, joints: Sequence[float]) -> None:
        """Have the arm be elsewhere, with what it carries, having met nothing on the way."""
        self._coast = None
        self.driven.jump(joints, loaded=bool(self._roster.carried))
        self._carry()

    def ease(self, joints: Sequence[float], commands: Sequence[float]) -> None:
        """Have the arm and what it carries be where a tick led in which nothing touched it.

        Args:
            joints: its six coordinates.
            commands: where the motors want them.
        """
        self._coast = None
        self.driven.ease(joints, commands)
        self._carry()

    @property
    def gripped(self) -> bool:
        """Whether something rests between the fingers, and on something else too."""
        return bool(self.carrying.gripped)

    def squeeze(self, commands: Sequence[float]) -> None:
        """Have the hand squeeze what it grips otherwise, `carrying.goes_on` with that."""
        self.driven.squeeze(commands)

    def look_closely(self) -> None:
        """Have the next tick be a single one, and solved."""
        self._stride, self._coast = 1, None

    def take(self, names: Sequence[str]) -> None:
        """Have bodies that are at rest rest in the hand from now on."""
        self._coast = None
        for name in names:
            self._sleep(self.bodies[name], {}, in_hand=True)
        self.carrying.hold(self.driven, self.contacts, names)
        self._contacts = []

    # The arm

    @property
    def joints(self) -> list[float]:
        """The arm's six coordinates as they are: as commanded, less what the cables give."""
        return self.driven.joints

    @property
    def torques(self) -> list[float]:
        """What contact does to each coordinate: ounce inches, and ounces at the opening."""
        return self.driven.torques

    @property
    def links(self) -> Sequence[Link]:
        """The arm's links where they stand."""
        return self.driven.links

    @property
    def link_solids(self) -> Sequence[Placed]:
        """The same as solids."""
        return self.driven.solids

    def pressed(self, name: str) -> Iterator[tuple[Key, float]]:
        """What presses on a thing, by contact: impulse a second."""
        return self._memory.pressed(name)

    @property
    def arm_still(self) -> int:
        """Ticks for which the arm has been commanded nowhere else."""
        return self.driven.still

    @property
    def contacts(self) -> list[Contact]:
        """Of the last step, with what was found there; no part of the scene's state."""
        if self._again is not None:
            moment, outcome = self._again
            self._contacts, self._again = moment.contacts(outcome), None
        return self._contacts

    # Time

    @property
    def quiet(self) -> bool:
        """Whether nothing moves of itself."""
        return not self._roster.awake

    @property
    def carried(self) -> list[Body]:
        """What rests in the hand."""
        if not self._roster.carried:
            return []
        return self._roster.ordered(self._roster.carried.values())

    @property
    def awake(self) -> Collection[str]:
        """Names of what is not asleep."""
        return self._roster.awake.keys()

    def leaning_on(self, name: str) -> AbstractSet[str]:
        """Names of what touched a thing when it fell asleep, and sleeps still."""
        return self._roster.leaning.get(name, frozenset())

    def ordered(self, names: Iterable[str]) -> list[Body]:
        """The bodies among some names, as they came to the scene."""
        found = [self.bodies[name] for name in names if name in self.bodies]
        return self._roster.ordered(found)

    def sleepers(self, low: Vector, high: Vector) -> list[Body]:
        """What sleeps, and does not rest in the hand, in or about an upright box."""
        return self._roster.near(low, high)

    @property
    def due(self) -> int:
        """T-state of the next tick."""
        return self.time + self._stride * TICK_STATES

    def last_tick(self, time: int) -> int:
        """T-state of the last tick up to a T-state, if they come one by one."""
        return self.time + (time - self.time) // TICK_STATES * TICK_STATES

    def advance(self, time: int) -> None:
        """Do all ticks up to a T-state."""
        while self.due <= time:
            if not self.driven.moved and self.quiet:
                self.time = self.last_tick(time)
                return
            self.tick()

    def tick(self) -> None:
        """Let one tick pass, or some at once while all goes on steadily and slowly.

        While something turns fast it is done in several steps.
        """
        self.time, self.recurs = self.due, None
        arm = self.driven
        moved = arm.moved
        arm.moved = False
        before, after = arm.reached, arm.commands
        arm.still = 0 if moved else arm.still + self._stride
        arm.standing = 0 if before[:5] != after[:5] else arm.standing + self._stride
        coast = None if self._something_spins() else self._coast
        share = None if coast is None else coast.share(after)
        if coast is not None and share is not None:
            self._go_on(coast, share)
            arm.reached = after
            self.went_on = True
            return
        self._coast, self.went_on = None, False
        self._steady, self._fastest, self._reach, self._far = True, 0.0, 0.0, False
        moment = self._moment()
        asked = b"" if moment is None else moment.question(self.fixed, self._else(moved))
        known = self._outcomes.get(asked)
        if moment is not None and known is not None:
            self._repeat(moment, known)
            self.recurs = asked, moment
        else:
            self._part(before, after, 0, self._stride * FINEST, moved)
            if moment is not None and self._was_near(moment):
                self._outcomes.keep(asked, self._outcome(moment))
                self.recurs = asked, moment
        arm.commands = arm.reached = after
        if self._coast is None:
            self._stride = 1
            if self._steady and not self.quiet:
                fitting = (ticks for ticks, fast in STRIDES if self._fastest <= fast)
                self._stride = max(fitting, default=1)

    def _moment(self) -> Moment | None:
        """What this tick hangs on; None if that is much."""
        if self._something_spins():
            return None
        bodies = concerned(self.bodies, self._roster, self._memory, self.driven)
        if bodies is None:
            return None
        return Moment(bodies, self.driven, self.carrying, self._memory)

    def _else(self, moved: bool) -> object:
        """What it hangs on besides."""
        return self._stride, moved, self.table_friction

    def _was_near(self, moment: Moment) -> bool:
        """Whether nothing but what is concerned could be met on this tick, nor came to matter."""
        if self._far or self._coast is not None:
            return False
        seconds = self._stride * TICK
        # How it came there, and what is looked at from there as about to touch.
        way = max(moment.farthest(), seconds * self._fastest)
        looked_at = seconds * (self._fastest + GRAVITY * seconds) + self._reach + MARGIN
        return way + self._reach + looked_at < NEARBY

    def _outcome(self, moment: Moment) -> _Result:
        """What has come of this tick."""
        found = self._fastest, self._steady, self._seconds
        return moment.outcome(self.contacts), self.met_at, *found

    def _repeat(self, moment: Moment, known: _Result) -> None:
        """Have come of this tick what came of one that began like it."""
        outcome, met_at, self._fastest, self._steady, self._seconds = known
        moment.repeat(outcome)
        self._again, self.met_at = (moment, outcome), list(met_at)

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
        self.driven.began = _between(before, after, start / whole)
        self.driven.commands = after if end == whole else _between(before, after, end / whole)
        if not self._step(moved, end - start > 1):
            # What a step would have led to may be farther off than what has become of it.
            self._far = True
            middle = (start + end) // 2
            self._part(before, after, start, middle, moved)
            self._part(before, after, middle, end, moved)

    def _step(self, moved: bool, may_halve: bool) -> bool:
        """One step; whether it was made, or is too long for how fast something turns."""
        arm, h = self.driven, self._seconds
        rates = self._rates()
        reach = [h * speed for speed in arm.speeds(rates)]
        if moved and arm.linkage is not None:
            loaded = bool(self._roster.carried)
            Rousing(arm, self.carrying, self._roster, self.fixed, self.wake).rouse(reach)
            if loaded and not self._roster.carried:
                rates = self._rates()
                reach = [h * speed for speed in arm.speeds(rates)]
        self._reach += max(reach, default=0.0)
        awake = self._roster.ordered(self._roster.awake.values())
        mobiles = {body.name: self._mobile(body) for body in awake}
        arm_mobile = arm.mobile(rates, h, loaded=bool(self._roster.carried))
        look = moved or bool(awake) or any(arm.torques)
        contacts = self._meeting(arm_mobile, reach, mobiles).find(awake, arm=look)
        # Some may have been woken by what comes upon them.
        awake = [self.bodies[name] for name in mobiles]
        # What nothing is near to may turn as far as it does.
        near = {name for contact in contacts for name in contact.key[:2]}
        beside = [mobile for name, mobile in mobiles.items() if name in near]
        if may_halve and any(_turns_far(mobile, h) for mobile in beside):
            return False
        problems = [Problem(group, h) for group in islands(contacts) if presses(group, h)]
        for problem in problems:
            self.solved += 1
            self.steps += problem.solve()
        if may_halve and (
            any(_turns_far(mobile, h) for mobile in beside)
            or self._ending(arm_mobile, reach, mobiles).dives
        ):
            return False
        self._contacts, self._again, self.met_at = contacts, None, list(arm.joints)
        self._memory.keep(contacts, h, self.bodies)
        links, joints = arm.links, list(arm.joints)
        if arm_mobile is not None:
            self._move_arm(arm_mobile, contacts, moved)
        for body in awake:
            self._move(body, mobiles[body.name])
        self._rest(awake, contacts, links)
        if moved:
            self._carry()
        before = arm.way
        arm.way = [(a - b) / h for a, b in zip(arm.joints, joints, strict=True)]
        self._coast = None
        if self._steady and self._may_coast:
            prospect = Prospect(
                h,
                arm,
                arm_mobile,
                before,
                awake,
                mobiles,
                problems,
                contacts,
                self.fixed,
                self._roster,
            )
            self._coast = prospect.coast()
            self._far = self._far or prospect.far
        return True

    def _meeting(
        self, arm: Mobile | None, reach: Sequence[float], mobiles: dict[str, Mobile]
    ) -> Meeting:
        """The search for this step's contacts."""
        return Meeting(
            self._seconds,
            self._roster,
            self.fixed,
            self.table_friction,
            [plate for plate in self.plates if plate.spin],
            self.driven,
            arm,
            reach,
            self._memory,
            mobiles,
            self.wake,
            self._mobile,
        )

    def _ending(
        self, arm: Mobile | None, reach: Sequence[float], mobiles: dict[str, Mobile]
    ) -> Ending:
        """Where this step leads, as solved."""
        return Ending(
            self._seconds,
            self.bodies,
            self._roster,
            self.fixed,
            mobiles,
            self.driven,
            arm,
            reach,
        )

    @property
    def _may_coast(self) -> bool:
        """Whether a step of this length, with what is there, may go on as before."""
        return (
            self._stride > 1
            and self._seconds == self._stride * TICK
            and not self._roster.carried
            and not self._something_spins()
        )

    def _something_spins(self) -> bool:
        """Whether any plate turns."""
        return bool(self.plates) and any(plate.spin for plate in self.plates)

    def _go_on(self, coast: Coast, share: float) -> None:
        """A step in which everything goes on as it went in the one before."""
        h, arm = self._seconds, self.driven
        for move in coast.moves:
            body, seconds = self.bodies[move.name], h * share if move.driven else h
            still = move.spin == NOWHERE
            turn = body.turn if still else turned(body.turn, move.spin, seconds)
            body.put(plus(body.place, move.velocity, seconds), turn)
        if arm.linkage is not None and arm.commands != arm.reached:
            arm.joints = [a - b for a, b in zip(arm.commands, coast.gives, strict=True)]
            arm.place()

    def _rates(self) -> Six:
        """Rates at which the arm's coordinates go where they are commanded, if nothing is there."""
        return self.driven.rates(self._seconds, loaded=bool(self._roster.carried))

    def _mobile(self, body: Body) -> Mobile:
        """A body for the solver, gravity on it."""
        vx, vy, vz = body.velocity
        slower = 1 / (1 + DRAG * self._seconds)
        wx, wy, wz = body.spin
        speed = [vx, vy, vz - GRAVITY * self._seconds, wx * slower, wy * slower, wz * slower]
        before = (*body.velocity, *body.spin)
        turn = matrix(body.turn)
        inertia = times(times(turn, body.shape.inertia), transposed(turn))
        return Mobile(speed, body.place, body.shape.mass, inertia, before=before, turn=turn)

    # Moving

    def _move(self, body: Body, mobile: Mobile) -> None:
        """Move a body for a step with the velocities that the solver has found."""
        vx, vy, vz, wx, wy, wz = mobile.speed
        radius = body.shape.radius
        change = [a - b for a, b in zip(mobile.speed, mobile.before or (), strict=True)]
        speed = greatest_speed(mobile.speed, radius)
        self._fastest = max(self._fastest, speed)
        if greatest_speed(change, radius) > max(STEADY, UNEVEN * speed):
            self._steady = False
        body.velocity, body.spin = (vx, vy, vz), (wx, wy, wz)
        if vx or vy or vz or wx or wy or wz:
            place, turn, body.spin = body.led(mobile.speed, self._seconds)
            body.put(place, turn)

    def _move_arm(self, mobile: Mobile, contacts: list[Contact], moved: bool) -> None:
        """Move the arm for a step, if anything moves it."""
        arm = self.driven
        touched = arm.touched(mobile, contacts)
        if not touched and not moved and (not any(arm.torques) or self._leaned_on()):
            return
        arm.move(mobile, self._seconds, touched=touched, loaded=bool(self._roster.carried))

    def _leaned_on(self) -> bool:
        """Whether something that sleeps leans on the arm and on other things too."""
        return any(
            name not in self._roster.carried
            for link in self.driven.names
            for name in self.leaning_on(link)
        )

    def _carry(self) -> None:
        """Take along what rests in the hand."""
        if self.arm is not None:
            for body in self.carried:
                carry(body, self.driven.hand)

    # Rest

    def _rest(self, awake: list[Body], contacts: list[Contact], before: Sequence[Link]) -> None:
        """Let what hardly moves fall asleep, with all that it leans on.

        Args:
            awake: bodies.
            contacts: as solved.
            before: the arm's links before this step.
        """
        if not awake:
            return
        arm = self.driven
        links = set(arm.names)
        lean = leaning(contacts)
        seen: list[tuple[Group, bool, bool, list[int]]] = []
        for group in groups(awake, self.bodies, lean):
            held = bool(group.outside & links)
            loose = not group.outside - links
            hand = None
            if held and loose and arm.linkage is not None:
                hand = before[arm.linkage.hand], arm.hand
            counts = [calm(each, hand, self._seconds) for each in group.members]
            seen.append((group, held, loose, counts))
        # What something that moves has woken it may be about to touch.
        alone = all(all(counts) for *_, counts in seen)
        for group, held, loose, counts in seen:
            for each, count in zip(group.members, counts, strict=True):
                ticks = self._stride * (count if alone else 1)
                each.still = each.still + ticks if count else 0
            if any(each.still < CALM_TICKS for each in group.members) or not group.outside:
                continue
            gripped = group.outside.issuperset(arm.fingers) and arm.standing > 0
            if held and not loose and arm.still < CALM_TICKS and not gripped:
                continue
            names = [each.name for each in group.members]
            for each in group.members:
                self._sleep(each, lean, in_hand=held and loose)
            if held and (loose or gripped):
                self.carrying.hold(arm, contacts, names)
            if gripped and not loose:
                self.carrying.grip(names, arm.commands)

    def _sleep(self, body: Body, lean: Mapping[str, set[str]], *, in_hand: bool) -> None:
        body.asleep = True
        body.velocity = body.spin = NOWHERE
        body.touching = tuple(sorted(lean.get(body.name, ())))
        if in_hand and self.arm is not None:
            self.carrying.take(body, self.driven.hand)


def _between(before: Sequence[float], after: Sequence[float], share: float) -> list[float]:
    """Numbers part of the way from some to others."""
    return [a + (b - a) * share for a, b in zip(before, after, strict=True)]


def _turns_far(mobile: Mobile, seconds: float) -> bool:
    """Whether a body turns farther in a step than contact can be taken as straight."""
    a, b, c = mobile.speed[3:]
    return (a * a + b * b + c * c) * seconds * seconds > FAR_TURN * FAR_TURN
