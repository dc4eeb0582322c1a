"""Where arm and bench meet: the arm among the parts, the hand's grip, sensors, feeders.

The arm says here where its rotors are. Contact is looked at on the ticks of the clock only, so that
it does not matter in what pieces time passes; and while nothing moves of itself and the arm is
farther from everything than it can go in a tick, not even then. A rotor always turns; what is
in the way stretches the cables, and comes back to the motors as torque.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from trs80arm.arm.bench import Bench, deep
from trs80arm.arm.body import Body
from trs80arm.arm.contact.distance import boxes_apart, distance
from trs80arm.arm.contact.manifold import Placed
from trs80arm.arm.contact.rotations import apply, apply_back
from trs80arm.arm.contact.scene import EASE, T_STATES_PER_SECOND, TABLE, TICK_STATES
from trs80arm.arm.events import EventKind
from trs80arm.arm.fixtures import Feeder, Part
from trs80arm.arm.forces import Burden
from trs80arm.arm.geometry import CableDrive, JointAngles, forward
from trs80arm.arm.grip import Grip
from trs80arm.arm.linkage import FINGERS, ArmLinkage, said
from trs80arm.arm.model import Link, Motor
from trs80arm.arm.rings import Ring, around, link_slices, rolled_slices
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.shapes import Box, Vector, dot, minus, plus
from trs80arm.arm.trigonometry import sin_cos

Six = tuple[float, float, float, float, float, float]
NONE: Six = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
FAR = 100.0
"""More inches than there are."""
NEAR = 0.005
"""Inches beyond what the arm goes in a tick within which contact is looked at."""
FEED_CLEARANCE = 2.5
"""A feeder gives its next part when the fingertip is this far from its middle, inches."""
GIVEN = 30
"""Ticks after which an arm that presses and stands has given all that it gives."""
PUSHED_FAR = 0.02
"""Inches that a part must have been moved for it to be told."""
FELL = 0.25
"""Inches that it must have come down to have fallen."""
TOPPLED = 0.7
"""Cosine of the turn of a part's own vertical beyond which it has fallen over."""
FACING = 0.7
"""Cosine to the way in which the hand closes from which what presses on a finger is closed on."""
HAIR, BREATH = 0.75, 2.5
"""Half-steps of cable by which a part, or what gives a little, may measure otherwise."""
YIELDING = 0.1
"""Part of the cable's way by which what is between the fingers gives way, rather than resists."""
TURNED_FAST = 0.01
"""Half-steps by which the turntable may be behind its motor and stand."""
BY_HAND = 12
"""Half-steps by which an operator turns the hand's motor in a tick."""
LET_GO = 400
"""Ticks in which all comes to rest after the operator's hands, at most."""
SUNK = 0.03
"""Inches to which an arm can be put by hand into what gives."""


class World:
    """Body of the arm, hold of the hand, and the bench.

    Attributes:
        grip: the hand's hold.
        met: name of what presses most on the arm, or None.
        vacant: feeders at whose place nothing stands.
    """

    def __init__(self, bench: Bench, settings: ArmSettings, drive: CableDrive) -> None:
        self.bench = bench
        self.settings = settings
        self.drive = drive
        self.model = drive.model
        self.grip = Grip(self.model, drive.home_cable)
        self.met: str | None = None
        self.vacant: list[Feeder] = []
        self._rotors = [0] * 6
        self._ticked = [0] * 6
        self._looked: list[int] | None = None
        self._clear = self._beside = 0.0
        self._levers: tuple[float, ...] = ()
        self._jumped = False
        self._busy = True
        self._loaded = self._leaned_on = False
        self._met: tuple[float, int] | None = None
        self._burdens: tuple[Burden, ...] = ()
        self._pushed: tuple[float, float, float, float, float] = (0.0,) * 5
        self._plate = 0.0
        self._moved: dict[str, Vector] = {}
        self._let_go: set[str] = set()
        self._linkage = ArmLinkage(self.model, settings)
        bench.lay()
        bench.scene.arm = self._linkage
        bench.scene.put_arm(self._commands(self._rotors))

    def __getstate__(self) -> dict[str, Any]:
        # How far things are is found anew; when it was looked at hangs on how a run is cut.
        self.show()
        return {**self.__dict__, "_looked": None, "_clear": 0.0, "_beside": 0.0, "_levers": ()}

    def start(self) -> None:
        """Begin: everything on the bench comes to rest, feeders give their first parts."""
        bench = self.bench
        bench.scene.arm = None
        bench.settle()
        bench.remember()
        bench.scene.arm = self._linkage
        bench.scene.put_arm(self._commands(self._rotors))
        for feeder in bench.waiting_feeders():
            if not self._touches(feeder.placed):
                bench.feed(feeder)
        bench.news.clear()
        self._moved.clear()
        self._let_go.clear()
        self._burdens, self._pushed = (), (0.0,) * 5
        self._changed()
        self._ticked[:] = self._rotors
        self._jumped, self._busy, self._looked = False, True, None
        self._plate = float(bench.turntable.rotor) if bench.turntable is not None else 0.0

    def refill(self) -> None:
        """Begin again with the parts; the hand is left empty."""
        self.grip.forget()
        self.bench.refill()
        self.start()

    # Time

    @property
    def due(self) -> int:
        """T-state of the next tick."""
        return self.bench.scene.due

    @property
    def idle(self) -> bool:
        """Whether a tick would change nothing."""
        return not self._busy

    @property
    def at_rest(self) -> bool:
        """Whether nothing moves of itself, and nothing but its load touches the arm."""
        scene = self.bench.scene
        return scene.quiet and not self._strained and self._plate_stands

    def skip(self, time: int) -> None:
        """Let ticks pass, up to a T-state, that would change nothing."""
        scene = self.bench.scene
        scene.time += (time - scene.time) // TICK_STATES * TICK_STATES

    def tick(self) -> None:
        """Let a tick pass; contact is looked at if there can be any."""
        if self._no_contact():
            self.bench.scene.time = self.due
            self._jumped = self._jumped or self._ticked != self._rotors
            self._ticked[:] = self._rotors
            self._busy = False
            if self.vacant and not self._until_fed():
                self.show()
                self._feed()
            return
        self.show()
        self._contact()

    def _no_contact(self) -> bool:
        """Whether it is certain that nothing touches the arm, or its load anything, in a tick."""
        if not self.at_rest:
            return False
        rotors, ticked = self._rotors, self._ticked
        if rotors == ticked:
            return True
        if not self._holds_on():
            return False
        base = self.levers()[0]
        now = self._travel(ticked, rotors)
        # The base turns nothing nearer to the table.
        level = now - base * abs(rotors[0] - ticked[0])
        if self._looked is not None and self._travel(self._looked, ticked) + now < self._clear:
            return True
        clear = self._clearance_at_tick()
        return now < clear or (now < self._beside and level == 0.0)

    def _holds_on(self) -> bool:
        """Whether the hand still holds its load as it took it up."""
        scene = self.bench.scene
        if not self._loaded:
            return True
        commands = self._commands(self._rotors)
        return scene.held_openings[0] <= commands[-1] <= scene.held_openings[1] and (
            self._rotors[3:5] == self._ticked[3:5]
            or scene.upright_in(self._linkage.links(commands)[self._linkage.hand])
        )

    def tilt(self) -> float:
        """Radians by which the hand may still turn against the vertical under its load."""
        scene = self.bench.scene
        if not scene.carried:
            return math.inf
        links = self._linkage.links(self._commands(self._rotors))
        return scene.tilt_left(links[self._linkage.hand])

    def held_cables(self) -> tuple[float, float]:
        """Least and most cable of the hand's, half-steps, at which a load stays as it is."""
        low, high = self.bench.scene.held_openings
        return low * self.model.hand_steps, high * self.model.hand_steps

    def _travel(self, before: Sequence[int], after: Sequence[int]) -> float:
        """Inches that any point of arm and load goes at most between two places."""
        a, b, c, d, e, f = self.levers()
        return (
            a * abs(after[0] - before[0])
            + b * abs(after[1] - before[1])
            + c * abs(after[2] - before[2])
            + d * abs(after[3] - before[3])
            + e * abs(after[4] - before[4])
            + f * abs(after[5] - before[5])
        )

    def _contact(self) -> None:
        """One tick in which contact is looked at."""
        scene = self.bench.scene
        self._turn_plate()
        asleep = {name for name, part in self.bench.parts.items() if part.asleep}
        scene.command(self._commands(self._rotors))
        scene.tick()
        self._loaded = bool(scene.carried)
        self._ticked[:] = self._rotors
        self._looked, self._levers = None, ()
        if not scene.went_on:
            self._grasp()
        self._tell(asleep)
        self._changed()
        self._feed()
        resting = scene.quiet and self._plate_stands
        giving = self._strained and not self._leaned_on and scene.arm_still < GIVEN
        self._busy = not resting or giving

    @property
    def _strained(self) -> bool:
        """Whether what touches the arm, but for its load, stretches its cables."""
        scene = self.bench.scene
        return any(scene.torques[:5]) or (scene.torques[5] != 0.0 and not scene.carried)

    @property
    def _plate_stands(self) -> bool:
        table = self.bench.turntable
        return table is None or table.rotor == self._plate

    def _turn_plate(self) -> None:
        """The turntable turns as far as its motor has since the last tick."""
        table, plate = self.bench.turntable, self.bench.scene.plate
        if table is None or plate is None:
            return
        # Its motor jerks from half-step to half-step; the plate follows smoothly.
        scene = self.bench.scene
        seconds = (scene.due - scene.time) / T_STATES_PER_SECOND
        behind = (table.rotor - self._plate) * (math.tau / table.steps)
        spin = behind / (seconds + EASE)
        self._plate += spin * seconds * (table.steps / math.tau)
        if abs(table.rotor - self._plate) < TURNED_FAST:
            self._plate, spin = float(table.rotor), 0.0
        if spin != plate.spin:
            plate.spin = spin
            for part in list(self.bench.parts.values()):
                if spin and part.asleep and part.carried is None and table.under(part):
                    scene.wake(part.name)

    # The arm

    def moved(self, rotors: Sequence[int], latch: int) -> None:
        """Follow a rotor.

        Args:
            rotors: positions of all.
            latch: of the motor that has moved.
        """
        self._rotors[latch] = rotors[latch]
        self.grip.cable = self.drive.cable(self._rotors)
        self._busy = True

    def arrive(self, rotors: Sequence[int], ticked: Sequence[int], time: int) -> None:
        """Be somewhere that free motion has led to.

        Args:
            rotors: positions of all.
            ticked: those that they had on the last tick.
            time: T-state of the last write.
        """
        self._rotors[:] = rotors
        self.grip.cable = self.drive.cable(rotors)
        if time >= self.due:
            self.skip(time)
            self._ticked[:] = ticked
            self._jumped = True
        self._busy = True

    def show_load(self) -> None:
        """Have what is carried be where it was on the last tick."""
        if self._jumped and self._loaded:
            self.show()

    def show(self) -> None:
        """Have links and load be where they were on the last tick, for whoever looks."""
        if self._jumped:
            self._jumped = False
            self.bench.scene.jump(self._commands(self._ticked))

    def _commands(self, rotors: Sequence[int]) -> list[float]:
        """Where motors want the joints: radians, and inches of opening."""
        base, shoulder, elbow, left, right = self.drive.driven(rotors)
        cable = self.drive.cable(rotors)
        # Its cable goes on past nothing only against what is between the fingers.
        if not (self.grip.contact and self.bench.scene.torques[5] > 0):
            cable = max(0, cable)
        opening = min(self.model.hand.range, cable / self.model.hand_steps)
        return [base, shoulder, elbow, left, right, opening]

    @property
    def angles(self) -> JointAngles:
        """Angles of the joints as they stand, radians."""
        if self.strained:
            return JointAngles.of_gears(*self.bench.scene.joints[:5])
        return self.drive.angles(self._rotors)

    @property
    def body(self) -> Body:
        """Links and fingers as they stand."""
        return Body(self.model, self.angles, self.grip.opening, self.settings.finger_length)

    @property
    def torques(self) -> Six:
        """What contacts do to the motors, by `Motor`: ounce-inches, ounces on the opening.

        Positive where they push the angle up or the hand open. What hangs in the hand alone is
        not in it but among the burdens: it weighs on the motors, and what it takes to set it in
        motion the rotors' trailing makes up for.
        """
        a, b, c, d, e = self._pushed
        return a, b, c, d, e, 16 * self.grip.force

    @property
    def strained(self) -> bool:
        """Whether anything presses on the arm or is pushed by it."""
        return any(self._pushed)

    @property
    def blocked(self) -> bool:
        """Whether what presses on the arm is something else than what it has in the hand."""
        return self.strained and self.met is not None and self.met != self.grip.part

    def burdens(self) -> tuple[Burden, ...]:
        """What hangs in the hand, all that stands on it included."""
        return self._burdens

    def _weigh(self) -> None:
        """See what hangs in the hand and touches nothing else, and what else presses on the arm."""
        scene, links, parts = self.bench.scene, self._linkage.names, self.bench.parts
        leaning: dict[str, set[str]] = {}
        for one, other in self._leaning():
            leaning.setdefault(one, set()).add(other)
            leaning.setdefault(other, set()).add(one)
        touched = {name for link in links for name in leaning.get(link, ())}
        self._leaned_on = any(name in parts for name in touched)
        loads = [load.name for load in scene.carried]
        waiting = [] if loads else [name for name, part in parts.items() if part.held]
        while waiting:
            name = waiting.pop()
            if name in loads or name in links:
                continue
            if name not in parts:
                loads = []
                break
            loads.append(name)
            waiting += sorted(leaning.get(name, ()))
        alone = touched <= set(loads)
        hand = scene.links[self._linkage.hand]
        found = []
        for name in loads:
            part = self.bench.parts[name]
            x, y, z = apply_back(hand.turn, minus(part.place, hand.place))
            found.append(Burden(part.weight, (x - self.model.hand_length, y, z)))
        self._burdens = tuple(found) if alone or self._loaded else ()
        a, b, c, d, e, _ = scene.torques
        self._pushed = (0.0,) * 5 if alone else (a, b, c, d, e)

    # How far from everything

    def levers(self) -> tuple[float, ...]:
        """Inches that a half-step of each motor moves anything of the arm or its load, at most."""
        if not self._levers:
            self._levers = self._longest_levers()
        return self._levers

    def _longest_levers(self) -> tuple[float, ...]:
        model = self.model
        ahead, aside = self.extent(model.hand.range)
        out = math.hypot(ahead, aside)
        swung = max(
            math.hypot(abs(solid.center[0]) + solid.half[0], solid.half[2])
            for solid in model.solids
            if solid.link in (Link.UPPER_ARM, Link.FOREARM)
        )
        wide = max(solid.half[1] for solid in model.solids)
        levers = {
            Motor.BASE: math.hypot(2 * swung, wide) + out,
            Motor.SHOULDER: swung,
            # Raising the forearm opens the hand as well.
            Motor.ELBOW: swung + 0.5 * model.drives[2].steps / model.hand_steps,
            # A gear turns pitch and roll by half as much.
            Motor.LEFT_WRIST: (out + aside) / 2,
            Motor.RIGHT_WRIST: (out + aside) / 2,
            Motor.HAND: 0.5,
        }
        return tuple(levers[drive.turns] / drive.steps for drive in model.drives)

    def extent(self, opening: float) -> tuple[float, float]:
        """How far hand, fingers and load reach from the wrist, ahead and to any side, inches."""
        ahead, aside = self.model.hand_length, 0.0
        for solid in self.model.solids:
            _, wide, thick = (
                abs(at) + half for at, half in zip(solid.center, solid.half, strict=True)
            )
            if solid.link in FINGERS:
                aside = max(aside, math.hypot(wide + opening / 2, thick))
            elif solid.link is Link.HAND:
                aside = max(aside, math.hypot(wide, thick))
        for load in self.bench.scene.carried:
            assert load.carried is not None
            place, turn = load.carried
            for corner in (each for part in load.shape.solids for each in part.vertices):
                x, y, z = plus(place, apply(turn, corner))
                ahead, aside = max(ahead, abs(x)), max(aside, math.hypot(y, z))
        return ahead, aside

    def _clearance_at_tick(self) -> float:
        """Inches by which all that moves is clear of all that it could touch, on the last tick."""
        if self._looked != self._ticked:
            self.show()
            self._looked = list(self._ticked)
            self._beside = self._measured() - NEAR
            low = min(solid.low[2] for solid in self.bench.scene.link_solids)
            for load in self.bench.scene.carried:
                low = min(low, *(solid.low[2] for solid in load.placed))
            self._clear = min(self._beside, low - NEAR)
        return self._clear

    def _measured(self) -> float:
        """How far the arm and what it carries are from all else but the table."""
        scene = self.bench.scene
        least = FAR
        mine = list(zip(self._linkage.names, scene.link_solids, strict=True))
        for load in scene.carried:
            mine += [("", solid) for solid in load.placed]
        for thing in scene.fixed.values():
            for other in thing.placed:
                for name, solid in mine:
                    if name not in thing.passes:
                        least = _nearer(solid, other, least)
        for body in scene.bodies.values():
            if body.carried is not None:
                continue
            for other in body.placed:
                for _, solid in mine:
                    least = _nearer(solid, other, least)
        return least

    def _until_fed(self) -> float:
        """Inches that the fingertip may go until a feeder can give; 0 where one can."""
        tip = forward(self.model, self.drive.angles(self._rotors)).fingertip
        return max(0.0, min((self._within(feeder, tip) for feeder in self.vacant), default=FAR))

    @staticmethod
    def _within(feeder: Feeder, tip: Vector) -> float:
        """Inches by which a fingertip is too near to a feeder for its next part."""
        out = math.hypot(tip[0] - feeder.x, tip[1] - feeder.y)
        return FEED_CLEARANCE + feeder.place.radius - out

    def clearance(self, *, turning: bool) -> float:
        """Inches that any point of arm and load may go before anything can happen, at least.

        Args:
            turning: whether the base may turn meanwhile, as far as it likes; things are then taken
                for rings around its axis.

        Returns:
            0 where something may happen with the next half-step.
        """
        if not self.at_rest:
            return 0.0
        clear = self._clearance_at_tick() - self._travel(self._ticked, self._rotors)
        if self.vacant and not turning:
            clear = min(clear, self._until_fed() - NEAR)
        if turning and clear > 0.0:
            clear = min(clear, self._over_rings() - self._travel(self._ticked, self._rotors))
        return max(0.0, clear)

    def _over_rings(self) -> float:
        """How far all is from the arm wherever the base turns, as it was on the last tick."""
        scene = self.bench.scene
        s, c = sin_cos(scene.joints[0])
        arm = scene.link_solids[:2]
        mine = [ring for solid in arm for ring in link_slices(solid, c, s)]
        joined = len(mine)
        mine += self._hand_rings(c, s)
        least = min(each.low for each in mine)
        x, y, _ = forward(self.model, self.drive.angles(self._ticked)).fingertip
        for feeder in self.vacant:
            out = math.hypot(x, y) + math.hypot(feeder.x, feeder.y)
            least = min(least, FEED_CLEARANCE + feeder.place.radius - out)
        # Base and body are joined to the arm's first links, and always behind a line across it.
        for thing in scene.fixed.values():
            for solid in thing.placed:
                if thing.passes:
                    ahead = max(math.hypot(x, y) for x, y, _ in solid.vertices if x >= 0)
                    behind = max(math.hypot(x, y) for x, y, _ in solid.vertices)
                    ring = Ring(-behind, ahead, solid.low[2], solid.high[2])
                    least = min(least, *(each.apart(ring) for each in mine[joined:]))
                else:
                    ring = around(solid)
                    least = min(least, *(each.apart(ring) for each in mine))
        for body in scene.bodies.values():
            if body.carried is None:
                x, y, z = body.place
                out, reach = math.hypot(x, y), body.shape.radius
                ring = Ring(out - reach, out + reach, z - reach, z + reach)
                if all(each.apart(ring) > least for each in mine):
                    continue
                for solid in body.placed:
                    ring = around(solid)
                    least = min(least, *(each.apart(ring) for each in mine))
        return least - NEAR

    def _hand_rings(self, c: float, s: float) -> list[Ring]:
        """Hand and load cut across, rolled about the hand's axis however they may be."""
        frame = self.bench.scene.links[self._linkage.hand]
        ahead, aside = self.extent(self.grip.opening)
        way = (frame.turn[0], frame.turn[3], frame.turn[6])
        return rolled_slices(frame.place, way, ahead, aside, c, s)

    def finger_steps(self) -> int:
        """Half-steps that the hand alone can be stepped, either way, before anything happens."""
        grip, model = self.grip, self.model
        if grip.contact or grip.cable < 0:
            return 0
        lever = self.levers()[model.latch(Motor.HAND)]
        most = model.hand.range * model.hand_steps - grip.cable
        return max(0, int(min(self.clearance(turning=False) / lever, most, grip.cable)) - 2)

    def boxes(self) -> list[tuple[Box, bool]]:
        """Boxes around everything that the arm could touch, and whether it is the arm's own."""
        own = len(self.bench.obstacles[:2])
        found = [
            (obstacle.box, number < own) for number, obstacle in enumerate(self.bench.obstacles)
        ]
        parts = self.bench.parts.values()
        return found + [(part.box, False) for part in parts if part.carried is None]

    # The operator's hands

    def place(self, before: Sequence[int], rotors: list[int]) -> str | None:
        """Put the arm somewhere else by hand.

        Args:
            before: positions as they are.
            rotors: positions to take up; the hand's is changed to where it could get.

        Returns:
            Name of what is there already, or None if the arm now is.
        """
        scene = self.bench.scene
        self.show()
        self._come_to_rest()
        wanted = self.drive.cable(rotors)
        if wanted > self.grip.cable:
            self._turn_hand(list(before), wanted)
        rotors[Motor.HAND] += self.grip.cable - self.drive.cable(rotors)
        self._lift()
        there = self._commands(rotors)
        name = self._found_at([*there[:5], scene.joints[5]])
        if name is not None:
            for load in scene.carried:
                scene.wake(load.name)
            self._busy = True
            return said(name)
        self._rotors[:] = self._ticked[:] = rotors
        self.grip.cable = self.drive.cable(rotors)
        scene.jump(there)
        self._jumped, self._looked = False, None
        self._turn_hand(rotors, wanted)
        self._busy = True
        self._changed()
        self._feed()
        return None

    def _lift(self) -> None:
        """Take along what the hand has in its grip, and what rests on that alone."""
        scene, parts = self.bench.scene, self.bench.parts
        if scene.carried:
            return
        taken = {name for name, part in parts.items() if part.held}
        while taken:
            with_them = taken | set(self._linkage.names)
            riders = {
                name
                for name, part in parts.items()
                if name not in taken and part.touching and set(part.touching) <= with_them
            }
            if not riders:
                break
            taken |= riders
        if taken:
            scene.take([name for name in parts if name in taken])
            self._loaded, self._levers = True, ()
            self._weigh()

    def _turn_hand(self, rotors: list[int], wanted: int) -> None:
        """Pay out or pull in hand cable by hand, and let everything come to rest at once."""
        scene, hand = self.bench.scene, self.model.latch(Motor.HAND)
        while True:
            by = max(-BY_HAND, min(BY_HAND, wanted - self.grip.cable))
            if by < 0:
                by = max(by, min(0, int(self.grip.squeeze) - self.model.hand.most_squeeze))
            if by == 0:
                break
            rotors[hand] += self.model.drives[hand].sign * by
            self.moved(rotors, hand)
            time = scene.time
            self._contact()
            scene.time = time
        self._come_to_rest()

    def _come_to_rest(self) -> None:
        """Let everything come to rest; nobody but the operator's hands is in a hurry."""
        scene = self.bench.scene
        time = scene.time
        for _ in range(LET_GO):
            if not self._busy:
                break
            self._contact()
        scene.time = time

    def _found_at(self, joints: Sequence[float]) -> str | None:
        """Name of what the arm and its load would be in with its joints there."""
        scene, linkage = self.bench.scene, self._linkage
        links = linkage.links(joints)
        mine = [
            (name, Placed(solid, link.place, link.turn))
            for name, solid, link in zip(linkage.names, linkage.solids, links, strict=True)
        ]
        hand = links[linkage.hand]
        for load in scene.carried:
            mine += [("", solid) for solid in scene.load_at(load, hand)]
        for name, solid in mine:
            if solid.low[2] < -SUNK:
                return TABLE
            for thing in scene.fixed.values():
                if name not in thing.passes and any(
                    deep(solid, other, SUNK) for other in thing.placed
                ):
                    return thing.name
            for body in scene.bodies.values():
                if body.carried is None and any(deep(solid, other, SUNK) for other in body.placed):
                    return body.name
        return None

    def occupied(self) -> str | None:
        """Name of what is where the arm stands."""
        self.bench.lay()
        name = self._found_at(self._commands(self._rotors))
        return None if name is None else said(name)

    def turn_table(self, step: int) -> None:
        """Turn the turntable's motor by a half-step."""
        if self.bench.turntable is not None:
            self.bench.turntable.rotor += step
            self._busy = True

    # The hand

    def _grasp(self) -> None:
        """See from what presses on the fingers what is between them, and whether it is held."""
        parts = self.bench.parts
        between = set(self._linkage.fingers)
        # What sleeps in the grip stays there.
        if not any(
            part.asleep and (part.held or between <= set(part.touching)) for part in parts.values()
        ):
            self._measure()
            self._hold()
        self._weigh()
        self.met = self._presser()

    def _measure(self) -> None:
        """Where the fingers meet what is between them, or with what strain it holds them up."""
        scene, grip, fingers = self.bench.scene, self.grip, self._linkage.fingers
        across = self._across()
        gaps: dict[str, dict[str, float]] = {}
        for contact in scene.contacts:
            one, other, _ = contact.key
            if one not in fingers:
                one, other = other, one
            if one in fingers and _faces(contact.normal, across):
                each = gaps.setdefault(other, {})
                each[one] = min(contact.gap, each.get(one, contact.gap))
        steps, opening = self.model.hand_steps, scene.joints[5]
        pressed = scene.torques[5] > 0 and opening > 0
        # Fingers that have met the same thing, or are about to: it is known where.
        both = [scene.met_at[5] - sum(each.values()) for each in gaps.values() if len(each) == 2]
        grip.strain = 0.0
        if pressed and (both or self._between()):
            before, self._met = self._met, (opening * steps, grip.cable)
            resists = before is not None and (
                before[0] - self._met[0] <= YIELDING * (before[1] - grip.cable) + HAIR / 3
            )
            if not resists:
                scene.look_closely()
            if resists or (before is None and both):
                self._met_with(
                    max(both) * steps if both else self._met[0], HAIR if both else BREATH
                )
                return
        else:
            self._met = None
            if both:
                scene.look_closely()
                self._met_with(max(both) * steps, HAIR)
                return
        # What is pushed along or squared gives way: only what it resists with strains the cable.
        grip.contact = 0
        if pressed:
            grip.strain = scene.torques[5] / self.model.stiffness[5] * steps

    def _met_with(self, cable: float, give: float) -> None:
        """The fingers have met with so much cable paid out; what is rigid does not breathe."""
        if not self.grip.contact or abs(cable - self.grip.contact) > give:
            self.grip.contact = max(1, round(cable))

    def _across(self) -> Vector:
        """The way in which the hand closes."""
        turn = self.bench.scene.links[self._linkage.hand].turn
        return turn[1], turn[4], turn[7]

    def _between(self) -> list[str]:
        """Parts on which the fingers press, alone or by way of others between them."""
        parts = self.bench.parts
        left, right = self._linkage.fingers
        across = self._across()
        pairs = {
            contact.key[:2]
            for contact in self.bench.scene.contacts
            if contact.pressure > 0
            and (contact.key[0] not in (left, right) or _faces(contact.normal, across))
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
        return sorted(set(pressed) | set(gripped)) if pressed and gripped else []

    def _hold(self) -> None:
        """What the fingers have in their grip, with all that is between them."""
        grip, parts = self.grip, self.bench.parts
        between = self._between()
        weight = sum(parts[name].weight for name in between)
        if between and grip.carries(self._roughness(between)) < weight:
            between = []
        for name, part in parts.items():
            if part.held == (name in between):
                continue
            part.held = not part.held
            if part.held:
                self.bench.news.append((EventKind.TAKEN, f"{name} in the hand"))
                self._moved.pop(name, None)
            else:
                self._moved[name] = part.place
                self._let_go.add(name)
                part.began = (part.place, part.upwards)
        grip.part = between[0] if between else None
        grip.weight = weight if between else 0.0

    def _leaning(self) -> set[tuple[str, str]]:
        """What presses on what: as found on this tick, and as it was when it fell asleep."""
        pairs = {c.key[:2] for c in self.bench.scene.contacts if c.pressure > 0}
        for name, part in self.bench.parts.items():
            if part.asleep:
                pairs.update((other, name) for other in part.touching)
        return pairs

    def _roughness(self, names: Sequence[str]) -> float:
        """Coefficient between the pads and the smoothest of some parts."""
        pad = self._linkage.frictions[self._linkage.names.index(self._linkage.fingers[0])]
        return math.sqrt(pad * min(self.bench.parts[name].friction for name in names))

    def _presser(self) -> str | None:
        """What presses most on the arm."""
        links = self._linkage.names
        forces: dict[str, float] = {}
        for contact in self.bench.scene.contacts:
            one, other, _ = contact.key
            name = other if one in links else one if other in links else None
            if name is not None and contact.pressure > 0:
                forces[name] = forces.get(name, 0.0) + contact.pressure
        return said(max(forces, key=lambda name: forces[name])) if forces else None

    def _tell(self, asleep: set[str]) -> None:
        """News of what has come to rest."""
        for name, part in self.bench.parts.items():
            if not part.asleep:
                if name in asleep:
                    self._moved.setdefault(name, part.place)
                    if part.began is None:
                        part.began = (part.place, part.upwards)
            elif name not in asleep and not part.held and part.carried is None:
                self._settled(name, part)
        self.bench.deliver()

    def _settled(self, name: str, part: Part) -> None:
        """News of one part that has come to rest."""
        news, began, start = self.bench.news, part.began, self._moved.pop(name, None)
        released = name in self._let_go
        self._let_go.discard(name)
        part.began = (part.place, part.upwards)
        if began is None:
            return
        place, up = began
        fell = place[2] - part.place[2]
        far = 0.0 if start is None else math.dist(start, part.place)
        if dot(up, part.upwards) < TOPPLED:
            news.append((EventKind.TOPPLED, f"{name} fell over"))
        elif fell > FELL:
            news.append((EventKind.DROPPED, f"{name} fell {fell:.2f} in"))
        elif released:
            news.append((EventKind.PLACED, f"{name} set down"))
        elif far > PUSHED_FAR:
            news.append((EventKind.PUSHED, f"{name} pushed {far:.2f} in"))

    # What else looks at the bench

    def sensed(self) -> int:
        """Bits 1 to 3 of the input nibble: 1 idle, 0 where a sensor answers."""
        bits = 0b1110
        if self.bench.sensors:
            self.show()
            solids = [solid for part in self.bench.parts.values() for solid in part.placed]
            segments = list(self.body.segments[1:])
            for sensor in self.bench.sensors:
                if bits >> sensor.bit & 1 and sensor.answers(solids, segments):
                    bits &= ~(1 << sensor.bit)
        return bits

    def _changed(self) -> None:
        """Parts have moved: see which feeders have room, and whether the hand has a load."""
        self._loaded = bool(self.bench.scene.carried)
        self.vacant = self.bench.waiting_feeders() if self.bench.feeders else []

    def _touches(self, solids: Sequence[Placed]) -> bool:
        """Whether a link or finger is in some solids."""
        return any(deep(mine, other) for mine in self.bench.scene.link_solids for other in solids)

    def _feed(self) -> None:
        """Feeders whose place is free, and clear of the hand, give their next part."""
        if not self.vacant:
            return
        tip = forward(self.model, self.drive.angles(self._rotors)).fingertip
        for feeder in self.vacant:
            placed = feeder.placed
            if (
                self._within(feeder, tip) <= 0.0
                and self.bench.room_for(placed)
                and not self._touches(placed)
            ):
                self.bench.feed(feeder)
                self._looked = None
        self._changed()


def _faces(normal: Vector, across: Vector) -> bool:
    """Whether a contact is one that the closing hand presses on."""
    return abs(dot(normal, across)) >= FACING


def _nearer(solid: Placed, other: Placed, least: float) -> float:
    """`least`, or the distance of two solids if that is less."""
    if boxes_apart(solid, other) >= least:
        return least
    return min(least, distance(solid, other))
