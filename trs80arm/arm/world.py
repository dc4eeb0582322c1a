"""Where arm and bench meet: the arm among the parts, the hand's grip, sensors, feeders.

The arm says here where its rotors are. Contact is looked at on the ticks of the clock only, so
that it does not matter in what pieces time passes; the clock stands while all rests, and begins
anew with what is done next. While nothing moves of itself and the arm is farther from everything
than it can go in a tick, nothing is looked at even then. A rotor always turns; what is in the way
stretches the cables, and comes back to the motors as torque.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from trs80arm.arm.ahead import Ahead
from trs80arm.arm.bench import Bench
from trs80arm.arm.body import Body
from trs80arm.arm.cell.home import HomeSwitch
from trs80arm.arm.cell.inputs import IDLE, nibble
from trs80arm.arm.cell.seen import Seen
from trs80arm.arm.contact.clock import PAUSE, TICK_STATES
from trs80arm.arm.contact.sixes import Six
from trs80arm.arm.event_log import EventLog
from trs80arm.arm.feeding import Feeding
from trs80arm.arm.forces import Burden
from trs80arm.arm.geometry import CableDrive, JointAngles
from trs80arm.arm.grasp import Grasp
from trs80arm.arm.grip import Grip
from trs80arm.arm.linkage import ArmLinkage
from trs80arm.arm.model import HAND, Motor
from trs80arm.arm.outlook import Outlook, Standing
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.shapes import Vector
from trs80arm.arm.surroundings import Surroundings
from trs80arm.arm.telling import Telling

GIVEN = 30
"""Ticks after which an arm that presses and stands has given all that it gives."""


class World:
    """Body of the arm, hold of the hand, and the bench.

    Attributes:
        grip: the hand's hold.
        grasp: what it has in its grip, and what presses on the arm.
        linkage: links and fingers as solids.
        around: how far everything is.
    """

    def __init__(self, bench: Bench, settings: ArmSettings, drive: CableDrive) -> None:
        self.bench = bench
        self.settings = settings
        self.drive = drive
        self.model = drive.model
        self.grip = Grip(self.model, drive.home_cable)
        self._rotors = [0] * 6
        self._ticked = [0] * 6
        self._jumped = False
        self._rests: int | None = None
        self._loaded = False
        self._commanded: tuple[Sequence[int], bool, list[float]] | None = None
        self.linkage = ArmLinkage(self.model, settings)
        self._telling = Telling(bench)
        self.grasp = Grasp(bench, self.linkage, self.grip, self._telling)
        self.around = Surroundings(bench, self.linkage)
        self._feeding = Feeding(bench, self.linkage, self.around)
        self._outlook = Outlook(bench, drive, self.grip, self.around, self._feeding)
        bench.cell.suit(settings)
        bench.lay()
        bench.scene.arm = self.linkage
        bench.scene.put_arm(self.wanted)
        self._homes: list[HomeSwitch] | None = None
        driven = drive.driven(self._rotors)
        for switch in bench.homes:
            switch.begin(driven[switch.motor])

    def __getstate__(self) -> dict[str, Any]:
        # What is carried is seen where it is.
        self.show()
        return {**self.__dict__, "_commanded": None}

    def start(self) -> None:
        """Begin: everything on the bench comes to rest, feeders give their first parts."""
        bench = self.bench
        commands = self.wanted
        # What falls on the arm comes to lie on it, or slides off.
        bench.scene.put_arm(commands)
        bench.settle()
        bench.remember()
        if not any(bench.scene.torques):
            bench.scene.put_arm(commands)
        self._feeding.begin()
        self.grasp.clear()
        self._changed()
        # Some may have come to lie on the hand.
        self.grasp.weigh(loaded=self._loaded)
        bench.news.clear()
        self._telling.clear()
        self._ticked[:] = self._rotors
        self._jumped, self._rests = False, None
        self._outlook.forget()
        bench.cell.begin()

    # Time

    @property
    def due(self) -> int:
        """T-state of the next tick."""
        return self.bench.scene.due

    @property
    def idle(self) -> bool:
        """Whether a tick would change nothing."""
        return self._rests is not None

    @property
    def free(self) -> bool:
        """Whether nothing moves of itself, and nothing but its load touches the arm.

        Its cables may still ease off.
        """
        scene = self.bench.scene
        return scene.quiet and self.bench.cell.stands and (self.grasp.alone or not self._strained)

    @property
    def gripped(self) -> bool:
        """Whether a part rests between the fingers, and on something else too.

        Then nothing moves as long as nothing but the hand does.
        """
        return self.bench.scene.gripped and self.grasp.firm and self.bench.cell.stands

    def begins(self, time: int) -> None:
        """A latch is written: where all has been at rest for a pause, ticks are counted from here.

        Args:
            time: T-state, up to which all has passed.
        """
        if self._rests is not None and time - self._rests >= PAUSE:
            self.bench.scene.time = self._rests = time

    def skip(self, time: int) -> None:
        """Let ticks pass, up to a T-state, that would change nothing."""
        self.bench.scene.time = self.bench.scene.last_tick(time)

    def tick(self) -> None:
        """Let a tick pass; contact is looked at if there can be any."""
        scene, stands, strained = self.bench.scene, self.bench.cell.stands, self._strained
        gripped = scene.gripped and stands and self.grasp.firm
        free = scene.quiet and stands and (self.grasp.alone or not strained)
        if (gripped and self._tick_gripping()) or (free and self._tick_freely(strained)):
            scene.time = scene.due
            self._ticked[:] = self._rotors
            if not (gripped or self._loaded):
                # Nothing was near the fingers.
                self.grip.contact = 0
            # What touches nothing is not strained by going on so.
            eases = strained and not gripped and self._strained
            self._rests = None if eases else scene.time
            if self._feeding.vacant and self._feeding.may_give(self.wanted):
                self.show()
                self._feed()
            return
        self.show()
        self._contact()

    def _tick_gripping(self) -> bool:
        """Squeeze what rests in the grip, if nothing else is to be done; whether it was not."""
        if not self.bench.scene.quiet:
            return False
        commands = self.wanted
        carrying, picks_up = self.bench.scene.carrying, self.grasp.picks_up
        if not carrying.goes_on(commands) or (picks_up and not carrying.flat):
            return False
        self.bench.scene.squeeze(commands)
        if picks_up:
            self.grasp.pick_up()
            self._changed()
        return True

    def _tick_freely(self, strained: bool) -> bool:
        """Move as nothing is in the way, unless contact has to be looked at; whether it has not."""
        if self._rotors == self._ticked and not strained:
            return True
        commands = self.wanted
        if self._loaded and not self._holds_on(commands):
            return False
        joints = self._led_to(commands, strained)
        if not self._outlook.clear_at(joints):
            return False
        if strained:
            self.bench.scene.ease(joints, commands)
        else:
            self._jumped = True
        return True

    def _led_to(self, commands: list[float], strained: bool) -> list[float]:
        """The arm's six coordinates after a tick in which nothing is in the way."""
        driven = self.bench.scene.driven
        if strained:
            return driven.eased(driven.joints, driven.reached, commands, loaded=self._loaded)
        return [*commands[:5], driven.joints[5] if self._loaded else commands[5]]

    def _holds_on(self, commands: list[float]) -> bool:
        """Whether the hand still holds its load as it took it up."""
        carrying = self.bench.scene.carrying
        return carrying.openings[0] <= commands[-1] <= carrying.openings[1] and (
            self._rotors[3:5] == self._ticked[3:5]
            or carrying.upright_in(self.linkage.hand_at(commands))
        )

    def tilt(self) -> float:
        """Radians by which the hand may still turn against the vertical under its load."""
        scene = self.bench.scene
        if not scene.carried:
            return math.inf
        return scene.carrying.tilt_left(self.linkage.hand_at(self.wanted))

    def held_cables(self) -> tuple[float, float]:
        """Least and most cable of the hand's, half-steps, at which a load stays as it is."""
        low, high = self.bench.scene.carrying.openings
        return low * self.model.hand_steps, high * self.model.hand_steps

    def _contact(self) -> None:
        """One tick in which contact is looked at."""
        scene = self.bench.scene
        awake = set(scene.awake)
        self.bench.cell.drive(scene)
        scene.command(self.wanted)
        scene.tick()
        self._loaded = bool(scene.carried)
        self._ticked[:] = self._rotors
        self._outlook.forget()
        if not scene.went_on:
            self.grasp.look(loaded=self._loaded)
        self._telling.look(awake, self.grasp.riders if self.grip.part is not None else ())
        self._changed()
        self._feed()
        resting = scene.quiet and self.bench.cell.stands
        giving = self._strained and not self.grasp.leaned_on and scene.arm_still < GIVEN
        self._rests = scene.time if resting and not giving else None

    @property
    def _strained(self) -> bool:
        """Whether what touches the arm, but for its load, stretches its cables."""
        scene = self.bench.scene
        a, b, c, d, e, f = scene.driven.torques
        if a or b or c or d or e:
            return True
        return f != 0.0 and not scene.carried

    # The arm

    @property
    def homes(self) -> list[HomeSwitch]:
        """The home switches, which have to see where joints turn back."""
        if self._homes is None:
            self._homes = self.bench.homes
        return self._homes

    def _turn_homes(self) -> None:
        """The cams of the home switches turn with the joints."""
        if self.homes:
            driven = self.drive.driven(self._rotors)
            for switch in self.homes:
                switch.turn(driven[switch.motor])

    def moved(self, rotors: Sequence[int], latch: int) -> None:
        """Follow a rotor.

        Args:
            rotors: positions of all.
            latch: of the motor that has moved.
        """
        self._rotors[latch] = rotors[latch]
        self.grip.cable = self.drive.cable(self._rotors)
        self._rests = None
        if self.homes:
            self._turn_homes()

    def arrive(self, rotors: Sequence[int], ticked: Sequence[int], time: int) -> None:
        """Be somewhere that free motion has led to.

        Args:
            rotors: positions of all.
            ticked: those that they had on the last tick.
            time: T-state of the last write.
        """
        self._rotors[:] = rotors
        self.grip.cable = self.drive.cable(rotors)
        self._turn_homes()
        if time >= self.due:
            ticks = (time - self.due) // TICK_STATES
            self.skip(time)
            self._ticked[:] = ticked
            if not (self._loaded or self.gripped):
                self.grip.contact = 0
            if self.gripped:
                self.bench.scene.squeeze(self.commands(ticked))
            elif self._strained and (eased := self._outlook.eased(ticks)) is not None:
                self.bench.scene.ease(eased, self.commands(ticked))
            else:
                self._jumped = True
                if self._strained:
                    # What was to ease off has.
                    self.show()
        self._rests = None

    def show_load(self) -> None:
        """Have what is carried be where it was on the last tick."""
        if self._jumped and self._loaded:
            self.show()

    def show(self) -> None:
        """Have links and load be where they were on the last tick, for whoever looks."""
        if self._jumped:
            self._jumped = False
            self.bench.scene.jump(self.commands(self._ticked))

    @property
    def wanted(self) -> list[float]:
        """Where motors want the arm's six coordinates: radians, and inches of opening."""
        return self.commands(self._rotors)

    def commands(self, rotors: Sequence[int]) -> list[float]:
        """Where they would want them with the rotors there; not to be changed."""
        taut = self._outlook.taut
        if self._commanded is not None:
            there, so, commands = self._commanded
            if so == taut and there == rotors:
                return commands
        commands = self._outlook.wanted_at(rotors)
        self._commanded = list(rotors), taut, commands
        return commands

    @property
    def angles(self) -> JointAngles:
        """Angles of the joints as they stand, radians."""
        if self.strained:
            return JointAngles.of_gears(*self.bench.scene.joints[:5])
        return self.drive.angles(self._rotors)

    @property
    def body(self) -> Body:
        """Links and fingers as they stand."""
        return Body(self.model, self.angles, self.grip.opening)

    @property
    def torques(self) -> Six:
        """What contacts do to the motors, by `Motor`: ounce-inches, ounces on the opening.

        Positive where they push the angle up or the hand open. What hangs in the hand alone is
        not in it but among the burdens: it weighs on the motors, and what it takes to set it in
        motion the rotors' trailing makes up for.
        """
        a, b, c, d, e = self.grasp.pushed
        return a, b, c, d, e, 16 * self.grip.force

    def torque(self, motor: Motor) -> float:
        """One of the same."""
        return 16 * self.grip.force if motor is HAND else self.grasp.pushed[motor]

    @property
    def strained(self) -> bool:
        """Whether anything presses on the arm or is pushed by it."""
        return any(self.grasp.pushed)

    @property
    def untouched(self) -> bool:
        """Whether nothing bears on the motors but the arm's own weight."""
        grasp = self.grasp
        return not (self.grip.squeeze or grasp.burdens or any(grasp.pushed))

    @property
    def blocked(self) -> bool:
        """Whether what presses on the arm is something else than what it has in the hand."""
        return self.strained and self.met is not None and self.met != self.grip.part

    @property
    def met(self) -> str | None:
        """Name of what presses most on the arm, or None."""
        return self.grasp.met

    def burdens(self) -> tuple[Burden, ...]:
        """What hangs in the hand, all that stands on it included."""
        return self.grasp.burdens

    @property
    def bearing(self) -> tuple[Sequence[tuple[float, Vector]], int]:
        """All on which it depends what motors bear in free motion, beside where they stand.

        That is burdens with their places, and the cable at which the fingers have met something.
        """
        burdens = [(burden.weight, burden.place) for burden in self.grasp.burdens]
        return burdens, self.grip.contact

    @property
    def hold(self) -> tuple[float, float]:
        """Ounces of all that the pads have to carry, and the coefficient of its friction."""
        return self.grasp.hold

    # What lies ahead

    def first_look(self, ahead: Ahead) -> int | None:
        """T-state of the first tick of a burst on which something has to be looked at, or None.

        Args:
            ahead: the burst, the arm being free, or gripping.
        """
        return self._outlook.first_look(self._standing, ahead)

    def ticks_clear(self, rotors: npt.NDArray[np.int64]) -> int:
        """How many ticks in a row need not be looked at, the arm being free, or gripping.

        Args:
            rotors: positions on the ticks from the next on, 6 x ticks.
        """
        return self._outlook.ticks_clear(self._standing, rotors)

    @property
    def _standing(self) -> Standing:
        return Standing(self._rotors, self._loaded, self.gripped, self._strained)

    # The operator's hands

    def settle(self, ticks: int) -> None:
        """Look at contact for some ticks, or until all is at rest, while no time passes.

        Args:
            ticks: at most.
        """
        scene = self.bench.scene
        time = scene.time
        for _ in range(ticks):
            if self.idle:
                break
            self._contact()
        scene.time = time
        if self.idle:
            self._rests = time

    def carry(self, names: Sequence[str]) -> None:
        """Have some parts go along with the hand."""
        self.bench.scene.take(names)
        self._loaded = True
        self.grasp.weigh(loaded=True)

    def let_loose(self) -> None:
        """Have what goes along with the hand be looked at again."""
        scene = self.bench.scene
        for load in scene.carried:
            scene.wake(load.name)
        self._rests = None

    def stand(self, rotors: Sequence[int]) -> None:
        """Be somewhere else at once, with what goes along with the hand.

        Args:
            rotors: positions to take up.
        """
        there = self.commands(rotors)
        self._rotors[:] = self._ticked[:] = rotors
        self._turn_homes()
        self.grip.cable = self.drive.cable(rotors)
        self.bench.scene.jump(there)
        self._jumped = False
        self._outlook.forget()

    def look_anew(self) -> None:
        """The arm has been put somewhere: have all be looked at, feeders too."""
        self._stirred()
        self._feed()

    # Devices

    def write_auxiliary(self, time: int, nibble: int, log: EventLog) -> None:
        """A write to the auxiliary latch: devices do what it says.

        Args:
            time: T-states.
            nibble: as written.
            log: for what there is to tell.
        """
        if self.bench.cell.devices:
            self.show()
        if self.bench.cell.write(time, nibble, self.bench, log):
            self._stirred()

    @property
    def alarm(self) -> int:
        """T-state at which a device acts next of itself."""
        return self.bench.cell.alarm

    def ring(self, log: EventLog) -> None:
        """That T-state has come."""
        self.show()
        self.bench.cell.ring(self.bench, log)
        self._stirred()

    def _stirred(self) -> None:
        """A device has done something: have all be looked at."""
        self._outlook.forget()
        self._rests = None
        self._changed()

    # What else looks at the bench

    def sensed(self, time: int, output: int, pull: Vector | None) -> int:
        """Bits 1 to 3 of the input nibble: 1 idle, 0 where a sensor answers.

        Args:
            time: T-state, up to which all has passed.
            output: nibble on the auxiliary output.
            pull: by which an operator pulls at the hand, ounces; or None.
        """
        bench = self.bench
        if not bench.sensors:
            return IDLE
        return nibble(bench.sensors, bench.selector, output, self.seen(time, pull))

    def seen(self, time: int, pull: Vector | None) -> Seen:
        """What there is to sense; the arguments are those of `sensed`."""
        self.show()
        return Seen(self, time, pull)

    def _changed(self) -> None:
        """Parts have moved: see which feeders have room, and whether the hand has a load."""
        self._loaded = bool(self.bench.scene.carried)
        self._feeding.look()

    def _feed(self) -> None:
        """Feeders whose place is free, and clear of the hand, give their next part."""
        if not self._feeding.vacant:
            return
        if self._feeding.give(self.wanted):
            self._outlook.forget()
            self._changed()
