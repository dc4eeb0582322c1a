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
from trs80arm.arm.contact.carrying import load_at
from trs80arm.arm.contact.clock import T_STATES_PER_SECOND, TICK_STATES
from trs80arm.arm.contact.driven import EASE
from trs80arm.arm.contact.manifold import Placed
from trs80arm.arm.contact.table import TABLE
from trs80arm.arm.fixtures import Feeder
from trs80arm.arm.forces import Burden
from trs80arm.arm.geometry import CableDrive, JointAngles
from trs80arm.arm.grasp import Grasp
from trs80arm.arm.grip import Grip
from trs80arm.arm.linkage import ArmLinkage, said
from trs80arm.arm.model import Motor
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.surroundings import FAR, NEAR, Surroundings, too_near
from trs80arm.arm.telling import Telling

Six = tuple[float, float, float, float, float, float]
NONE: Six = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
GIVEN = 30
"""Ticks after which an arm that presses and stands has given all that it gives."""
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
        vacant: feeders at whose place nothing stands.
        around: how far everything is.
    """

    def __init__(self, bench: Bench, settings: ArmSettings, drive: CableDrive) -> None:
        self.bench = bench
        self.settings = settings
        self.drive = drive
        self.model = drive.model
        self.grip = Grip(self.model, drive.home_cable)
        self.vacant: list[Feeder] = []
        self._rotors = [0] * 6
        self._ticked = [0] * 6
        self._looked: list[int] | None = None
        self._clear = self._beside = 0.0
        self._jumped = False
        self._busy = True
        self._loaded = False
        self._plate = 0.0
        self._linkage = ArmLinkage(self.model, settings)
        self._telling = Telling(bench)
        self._grasp = Grasp(bench, self._linkage, self.grip, self._telling)
        self.around = Surroundings(bench, self._linkage, drive)
        bench.lay()
        bench.scene.arm = self._linkage
        bench.scene.put_arm(self._commands(self._rotors))

    def __getstate__(self) -> dict[str, Any]:
        # How far things are is found anew; when it was looked at hangs on how a run is cut.
        self.show()
        return {**self.__dict__, "_looked": None, "_clear": 0.0, "_beside": 0.0}

    def start(self) -> None:
        """Begin: everything on the bench comes to rest, feeders give their first parts."""
        bench = self.bench
        commands = self._commands(self._rotors)
        # What falls on the arm comes to lie on it, or slides off.
        bench.scene.put_arm(commands)
        bench.settle()
        bench.remember()
        if not any(bench.scene.torques):
            bench.scene.put_arm(commands)
        for feeder in bench.waiting_feeders():
            if not self._touches(feeder.placed):
                bench.feed(feeder)
        bench.news.clear()
        self._telling.clear()
        self._grasp.clear()
        self._changed()
        self._ticked[:] = self._rotors
        self._jumped, self._busy, self._looked = False, True, None
        self._plate = float(bench.turntable.rotor) if bench.turntable is not None else 0.0

    def refill(self) -> str | None:
        """Begin again with the parts; the hand is left empty.

        Returns:
            Name of a part in whose place the arm stands, and nothing is done; or None.
        """
        solids = [solid for _, solid in self._links_at(self._commands(self._rotors))]
        for part in self.bench.beginning:
            if any(deep(mine, other, SUNK) for mine in solids for other in part.placed):
                return part.name
        self.grip.forget()
        self.bench.refill()
        self.start()
        return None

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
            if self.vacant and not self.around.until_fed(self.vacant, self._rotors):
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
        base = self.around.levers()[0]
        now = self.around.travel(ticked, rotors)
        # The base turns nothing nearer to the table.
        level = now - base * abs(rotors[0] - ticked[0])
        gone = FAR if self._looked is None else self.around.travel(self._looked, ticked)
        if gone + now < self._clear:
            return True
        clear = self._clearance_at_tick()
        return now < clear or (now < self._beside and level == 0.0)

    def _holds_on(self) -> bool:
        """Whether the hand still holds its load as it took it up."""
        scene = self.bench.scene
        if not self._loaded:
            return True
        commands = self._commands(self._rotors)
        return scene.carrying.openings[0] <= commands[-1] <= scene.carrying.openings[1] and (
            self._rotors[3:5] == self._ticked[3:5]
            or scene.carrying.upright_in(self._linkage.links(commands)[self._linkage.hand])
        )

    def tilt(self) -> float:
        """Radians by which the hand may still turn against the vertical under its load."""
        scene = self.bench.scene
        if not scene.carried:
            return math.inf
        links = self._linkage.links(self._commands(self._rotors))
        return scene.carrying.tilt_left(links[self._linkage.hand])

    def held_cables(self) -> tuple[float, float]:
        """Least and most cable of the hand's, half-steps, at which a load stays as it is."""
        low, high = self.bench.scene.carrying.openings
        return low * self.model.hand_steps, high * self.model.hand_steps

    def _contact(self) -> None:
        """One tick in which contact is looked at."""
        scene = self.bench.scene
        self._turn_plate()
        asleep = {name for name, part in self.bench.parts.items() if part.asleep}
        scene.command(self._commands(self._rotors))
        scene.tick()
        self._loaded = bool(scene.carried)
        self._ticked[:] = self._rotors
        self._looked = None
        self.around.load_changed()
        if not scene.went_on:
            self._grasp.look(loaded=self._loaded)
        self._telling.look(asleep)
        self._changed()
        self._feed()
        resting = scene.quiet and self._plate_stands
        giving = self._strained and not self._grasp.leaned_on and scene.arm_still < GIVEN
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
        a, b, c, d, e = self._grasp.pushed
        return a, b, c, d, e, 16 * self.grip.force

    @property
    def strained(self) -> bool:
        """Whether anything presses on the arm or is pushed by it."""
        return any(self._grasp.pushed)

    @property
    def blocked(self) -> bool:
        """Whether what presses on the arm is something else than what it has in the hand."""
        return self.strained and self.met is not None and self.met != self.grip.part

    @property
    def met(self) -> str | None:
        """Name of what presses most on the arm, or None."""
        return self._grasp.met

    def burdens(self) -> tuple[Burden, ...]:
        """What hangs in the hand, all that stands on it included."""
        return self._grasp.burdens

    # How far from everything

    def _clearance_at_tick(self) -> float:
        """Inches by which all that moves is clear of all that it could touch, on the last tick."""
        if self._looked != self._ticked:
            self.show()
            self._looked = list(self._ticked)
            self._beside = self.around.measured() - NEAR
            low = min(solid.low[2] for solid in self.bench.scene.link_solids)
            for load in self.bench.scene.carried:
                low = min(low, *(solid.low[2] for solid in load.placed))
            self._clear = min(self._beside, low - NEAR)
        return self._clear

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
        clear = self._clearance_at_tick() - self.around.travel(self._ticked, self._rotors)
        if self.vacant and not turning:
            clear = min(clear, self.around.until_fed(self.vacant, self._rotors) - NEAR)
        if turning and clear > 0.0:
            rings = self.around.over_rings(self.vacant, self._ticked, self.grip.opening)
            clear = min(clear, rings - self.around.travel(self._ticked, self._rotors))
        return max(0.0, clear)

    def finger_steps(self) -> int:
        """Half-steps that the hand alone can be stepped, either way, before anything happens."""
        grip, model = self.grip, self.model
        if grip.contact or grip.cable < 0:
            return 0
        lever = self.around.levers()[model.latch(Motor.HAND)]
        most = model.hand.range * model.hand_steps - grip.cable
        return max(0, int(min(self.clearance(turning=False) / lever, most, grip.cable)) - 2)

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
            self._loaded = True
            self.around.load_changed()
            self._grasp.weigh(loaded=True)

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

    def _links_at(self, joints: Sequence[float]) -> list[tuple[str, Placed]]:
        """The arm's links, with their names, where joints would have them."""
        linkage = self._linkage
        return [
            (name, Placed(solid, link.place, link.turn))
            for name, solid, link in zip(
                linkage.names, linkage.solids, linkage.links(joints), strict=True
            )
        ]

    def _found_at(self, joints: Sequence[float]) -> str | None:
        """Name of what the arm and its load would be in with its joints there."""
        scene, linkage = self.bench.scene, self._linkage
        mine = self._links_at(joints)
        hand = linkage.links(joints)[linkage.hand]
        for load in scene.carried:
            mine += [("", solid) for solid in load_at(load, hand)]
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
        tip = self.around.fingertip(self._rotors)
        for feeder in self.vacant:
            placed = feeder.placed
            if (
                too_near(feeder, tip) <= 0.0
                and self.bench.room_for(placed)
                and not self._touches(placed)
            ):
                self.bench.feed(feeder)
                self._looked = None
        self._changed()
