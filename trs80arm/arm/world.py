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

import numpy as np
import numpy.typing as npt

from trs80arm.arm.ahead import Ahead
from trs80arm.arm.bench import Bench, deep
from trs80arm.arm.body import Body
from trs80arm.arm.cell.home import HomeSwitch
from trs80arm.arm.cell.inputs import IDLE, nibble
from trs80arm.arm.cell.seen import Seen
from trs80arm.arm.contact.clock import TICK_STATES
from trs80arm.arm.contact.sixes import Six
from trs80arm.arm.contact.table import TABLE
from trs80arm.arm.event_log import EventLog
from trs80arm.arm.feeding import Feeding
from trs80arm.arm.forces import Burden
from trs80arm.arm.geometry import CableDrive, JointAngles
from trs80arm.arm.grasp import Grasp
from trs80arm.arm.grip import Grip
from trs80arm.arm.linkage import ArmLinkage, said
from trs80arm.arm.model import Motor
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.shapes import Vector
from trs80arm.arm.surroundings import HAIR, SPARE, Room, Surroundings
from trs80arm.arm.sweep import Ranges
from trs80arm.arm.telling import Telling

ABOUT = 0.05
"""Radians, and inches of the opening, about a place in which room is looked for at once."""
SWEPT = 4
"""Motions whose room is remembered while nothing else moves."""
CLOSELY = 8
"""Ticks for which it does not pay to look at what is swept over by half of them."""
HALVED = 2
"""How often a motion is halved before it is looked at place by place."""
GIVEN = 30
"""Ticks after which an arm that presses and stands has given all that it gives."""
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
        self._looked: tuple[list[float], Room] | None = None
        self._swept: list[Ranges] = []
        self._easing: list[list[float]] = []
        self._jumped = False
        self._busy = True
        self._loaded = False
        self._linkage = ArmLinkage(self.model, settings)
        self._telling = Telling(bench)
        self._grasp = Grasp(bench, self._linkage, self.grip, self._telling)
        self.around = Surroundings(bench, self._linkage)
        self._feeding = Feeding(bench, self._linkage, self.around)
        bench.cell.suit(settings)
        bench.lay()
        bench.scene.arm = self._linkage
        bench.scene.put_arm(self._commands(self._rotors))
        self._homes: list[HomeSwitch] | None = None
        driven = drive.driven(self._rotors)
        for switch in bench.homes:
            switch.begin(driven[switch.motor])

    def __getstate__(self) -> dict[str, Any]:
        # How far things are is found anew; when it was looked at hangs on how a run is cut.
        self.show()
        return {
            **self.__dict__,
            "_looked": None,
            "_swept": [],
            "_easing": [],
        }

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
        self._feeding.begin()
        self._grasp.clear()
        self._changed()
        # Some may have come to lie on the hand.
        self._grasp.weigh(loaded=self._loaded)
        bench.news.clear()
        self._telling.clear()
        self._ticked[:] = self._rotors
        self._jumped, self._busy = False, True
        self._forget()
        bench.cell.begin()

    def refill(self) -> str | None:
        """Begin again with the parts; the hand is left empty.

        Returns:
            Name of a part in whose place the arm stands, and nothing is done; or None.
        """
        solids = [solid for _, solid in self._linkage.standing(self._commands(self._rotors))]
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
    def free(self) -> bool:
        """Whether nothing moves of itself, and nothing but its load touches the arm.

        Its cables may still ease off.
        """
        scene = self.bench.scene
        return scene.quiet and self.bench.cell.stands and (self._grasp.alone or not self._strained)

    @property
    def gripped(self) -> bool:
        """Whether a part rests between the fingers, and on something else too.

        Then nothing moves as long as nothing but the hand does.
        """
        return self.bench.scene.gripped and self._grasp.firm and self.bench.cell.stands

    def skip(self, time: int) -> None:
        """Let ticks pass, up to a T-state, that would change nothing."""
        scene = self.bench.scene
        scene.time += (time - scene.time) // TICK_STATES * TICK_STATES

    def tick(self) -> None:
        """Let a tick pass; contact is looked at if there can be any."""
        if self._tick_gripping() or (self.free and self._tick_freely()):
            self.bench.scene.time = self.due
            self._ticked[:] = self._rotors
            self._let_alone()
            self._busy = self._strained and not self.gripped
            if self._feeding.vacant and not self._feeding.room(self._commands(self._rotors)):
                self.show()
                self._feed()
            return
        self.show()
        self._contact()

    def _tick_gripping(self) -> bool:
        """Squeeze what rests in the grip, if nothing else is to be done."""
        if not (self.gripped and self.bench.scene.quiet):
            return False
        commands = self._commands(self._rotors)
        carrying, picks_up = self.bench.scene.carrying, self._grasp.picks_up
        if not carrying.goes_on(commands) or (picks_up and not carrying.flat):
            return False
        self.bench.scene.squeeze(commands)
        if picks_up:
            self._grasp.pick_up()
            self._changed()
        return True

    def _let_alone(self) -> None:
        """On a tick nothing was near the fingers but what rests in the hand."""
        if not (self._loaded or self.gripped):
            self.grip.contact = 0

    def _tick_freely(self) -> bool:
        """Move as nothing is in the way, unless contact has to be looked at; whether it has not."""
        strained = self._strained
        if self._rotors == self._ticked and not strained:
            return True
        commands = self._commands(self._rotors)
        if not self._holds_on(commands):
            return False
        joints = self._led_to(commands)
        if not (
            self._surely_clear(joints)
            or self._known_clear(Ranges.about(joints, 0.0))
            or self._sweep_clear(Ranges.about(joints, ABOUT))
            or self._look(joints).enough
        ):
            return False
        if strained:
            self.bench.scene.ease(joints, commands)
        else:
            self._jumped = True
        return True

    def _led_to(self, commands: list[float]) -> list[float]:
        """The arm's six coordinates after a tick in which nothing is in the way."""
        driven = self.bench.scene.driven
        if self._strained:
            return driven.eased(driven.joints, driven.reached, commands, loaded=self._loaded)
        return [*commands[:5], driven.joints[5] if self._loaded else commands[5]]

    def _surely_clear(self, joints: Sequence[float]) -> bool:
        """Whether there must be room about somewhere, by the room there was where it was measured.

        How far the arm goes is a bound on how much nearer anything can be; the base takes nothing
        nearer to the table.

        Args:
            joints: where.
        """
        if self._looked is None or not self._looked[1].enough:
            return False
        there, room = self._looked
        way, down = self.around.travel(there, joints)
        return way <= room.beside - SPARE and (
            down <= room.low - SPARE or (down == 0.0 and room.low >= -HAIR / 2)
        )

    def _look(self, joints: list[float]) -> Room:
        """What room there is somewhere; remembered for bounds."""
        room = self.around.measured(joints)
        self._looked = joints, room
        return room

    def _sweep_clear(self, ranges: Ranges) -> bool:
        """Whether it is certain that there is room about while the joints are in some ranges."""
        if self._known_clear(ranges):
            return True
        if not self.around.sweep_clear(ranges):
            return False
        self._swept.append(ranges)
        del self._swept[:-SWEPT]
        return True

    def _known_clear(self, ranges: Ranges) -> bool:
        """Whether that was found before, and nothing else has moved since."""
        return any(ranges.within(each) for each in self._swept)

    def _forget(self) -> None:
        """Something may have moved: what was known of the room about is so no longer."""
        self._looked = None
        self._swept.clear()

    def _holds_on(self, commands: list[float]) -> bool:
        """Whether the hand still holds its load as it took it up."""
        carrying = self.bench.scene.carrying
        if not self._loaded:
            return True
        return carrying.openings[0] <= commands[-1] <= carrying.openings[1] and (
            self._rotors[3:5] == self._ticked[3:5]
            or carrying.upright_in(self._linkage.links(commands)[self._linkage.hand])
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
        asleep = {name for name, part in self.bench.parts.items() if part.asleep}
        self.bench.cell.drive(scene)
        scene.command(self._commands(self._rotors))
        scene.tick()
        self._loaded = bool(scene.carried)
        self._ticked[:] = self._rotors
        self._forget()
        if not scene.went_on:
            self._grasp.look(loaded=self._loaded)
        self._telling.look(asleep)
        self._changed()
        self._feed()
        resting = scene.quiet and self.bench.cell.stands
        giving = self._strained and not self._grasp.leaned_on and scene.arm_still < GIVEN
        self._busy = not resting or giving

    @property
    def _strained(self) -> bool:
        """Whether what touches the arm, but for its load, stretches its cables."""
        scene = self.bench.scene
        return any(scene.torques[:5]) or (scene.torques[5] != 0.0 and not scene.carried)

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
        self._busy = True
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
            self._let_alone()
            if self.gripped:
                self.bench.scene.squeeze(self._commands(ticked))
            elif self._strained and ticks < len(self._easing):
                self.bench.scene.ease(self._easing[ticks], self._commands(ticked))
            else:
                self._jumped = True
                if self._strained:
                    # What was to ease off has.
                    self.show()
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

    @property
    def hold(self) -> tuple[float, float]:
        """Ounces of all on which both fingers press, and the coefficient of its friction."""
        return self._grasp.hold

    # How far from everything

    def first_look(self, ahead: Ahead) -> int | None:
        """T-state of the first tick of a burst on which something has to be looked at, or None.

        Args:
            ahead: the burst, the arm being free, or gripping.
        """
        ticks = range(self.due, ahead.ends + 1, TICK_STATES)
        if not ticks:
            return None
        if self.gripped or self._strained:
            clear = self.ticks_clear(self._on_ticks(ahead, ticks))
        else:
            clear = len(ticks)
            if self._feeding.vacant:
                joints = self._unstrained(self._on_ticks(ahead, ticks))
                clear = self._feeding.places_unfed(joints)
            # Where the burst ends the arm will be on the next tick.
            ends = [*ticks[:clear], ahead.ends + 1]
            if not self._sweep_clear(self._ranges(ahead, ends)) and clear:
                clear = self._sweeps_clear(ahead, ends[:-1])
        return ticks[clear] if clear < len(ticks) else None

    def _sweeps_clear(self, ahead: Ahead, ticks: Sequence[int]) -> int:
        """How many T-states in a row the arm has room at, by what it sweeps over between them.

        Args:
            ahead: the burst, the arm being free.
            ticks: the T-states; what is written before is done.
        """
        pieces = [(0, len(ticks))]
        while pieces:
            begin, end = pieces.pop()
            if self._sweep_clear(self._ranges(ahead, ticks[begin:end])):
                continue
            if end - begin > max(CLOSELY, len(ticks) >> HALVED):
                middle = (begin + end) // 2
                pieces += [(middle, end), (begin, middle)]
                continue
            joints = self._unstrained(self._on_ticks(ahead, ticks[begin:end]))
            clear = self.around.places_clear(joints)
            if clear < end - begin:
                return begin + clear
        return len(ticks)

    def _on_ticks(self, ahead: Ahead, ticks: Sequence[int]) -> npt.NDArray[np.int64]:
        """Positions of all rotors on some ticks, 6 x ticks."""
        rotors = np.empty((6, len(ticks)), dtype=np.int64)
        rotors[:] = np.array(self._rotors)[:, None]
        turned = ahead.turned(np.array(ticks))
        for turning, by in zip(ahead.turnings, turned, strict=True):
            rotors[turning.latch] += by
        return rotors

    def _wanted(self, rotors: npt.NDArray[np.int64]) -> npt.NDArray[np.float64]:
        """Where motors want the arm's six coordinates, 6 x places, for positions of the rotors."""
        drive, model = self.drive, self.model
        opening = np.clip(drive.cable(rotors) / model.hand_steps, 0.0, model.hand.range)
        return np.array((*drive.driven(rotors), opening))

    def _unstrained(self, rotors: npt.NDArray[np.int64]) -> npt.NDArray[np.float64]:
        """The same with nothing in the arm's way but what rests in its hand."""
        joints = self._wanted(rotors)
        if self._loaded:
            joints[5] = self.bench.scene.joints[5]
        return joints

    def _ranges(self, ahead: Ahead, ticks: Sequence[int]) -> Ranges:
        """Between what the joints are on some ticks, nothing in their way."""
        model, drive, here = self.model, self.drive, self._rotors
        since, until = ticks[0], ticks[-1]
        low, high = list(here), list(here)
        for turning, (least, most) in zip(ahead.turnings, ahead.between(since, until), strict=True):
            low[turning.latch] += least
            high[turning.latch] += most
        ends = zip(drive.driven(low), drive.driven(high), strict=True)
        base, shoulder, elbow, _, _ = [(a, b) if a < b else (b, a) for a, b in ends]
        *_, left, right = drive.driven(here)
        both = 2 * model.drives[model.latch(Motor.LEFT_WRIST)].steps
        least, most = ahead.together_between(model.gears(1), since, until)
        pitch = (left + right) / 2 + least / both, (left + right) / 2 + most / both
        least, most = ahead.together_between(model.gears(-1), since, until)
        roll = (left - right) / 2 + least / both, (left - right) / 2 + most / both
        if self._loaded:
            opening = self.bench.scene.joints[5]
            return Ranges(base, shoulder, elbow, pitch, roll, (opening, opening))
        least, most = ahead.together_between(model.pays_out, since, until)
        cable, per_inch, widest = drive.cable(here), model.hand_steps, model.hand.range
        shut = min(widest, max(0, cable + least) / per_inch)
        wide = min(widest, max(0, cable + most) / per_inch)
        return Ranges(base, shoulder, elbow, pitch, roll, (shut, wide))

    def ticks_clear(self, rotors: npt.NDArray[np.int64]) -> int:
        """How many ticks in a row need not be looked at, the arm being free, or gripping.

        Args:
            rotors: positions on the ticks from the next on, 6 x ticks.
        """
        if self.gripped:
            return self._ticks_gripping(self._wanted(rotors).T.tolist())
        if self._strained:
            joints = self._wanted(rotors)
            self._ease(joints)
        else:
            joints = self._unstrained(rotors)
        count = len(joints[0])
        if self._feeding.vacant:
            count = self._feeding.places_unfed(joints)
        if count and self._sweep_clear(Ranges.of(joints[:, :count])):
            return count
        return self.around.places_clear(joints[:, :count]) if count else 0

    def _ticks_gripping(self, commands: Sequence[list[float]]) -> int:
        """How many ticks in a row what rests in the grip goes on resting there.

        Args:
            commands: on the ticks.
        """
        goes_on = self.bench.scene.carrying.goes_on
        if not self.grip.part:
            return 0
        for count, each in enumerate(commands):
            if not goes_on(each):
                return count
        return len(commands)

    def _ease(self, joints: npt.NDArray[np.float64]) -> None:
        """Have the arm lag behind where it is wanted while its cables ease off.

        Args:
            joints: where the motors want it on some ticks, 6 x ticks; made where it is.
        """
        driven, loaded = self.bench.scene.driven, self._loaded
        now, before = driven.joints, driven.reached
        self._easing = []
        for tick, commands in enumerate(joints.T.tolist()):
            now = driven.eased(now, before, commands, loaded=loaded)
            joints[:, tick] = now
            self._easing.append(now)
            before = commands
            if now[:5] == commands[:5] and (loaded or now[5] == commands[5]):
                # All that was to ease off has.
                if loaded:
                    joints[5, tick:] = now[5]
                break

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
        self._turn_homes()
        self.grip.cable = self.drive.cable(rotors)
        scene.jump(there)
        self._jumped = False
        self._forget()
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

    def _found_at(self, joints: Sequence[float]) -> str | None:
        """Name of what the arm and its load would be in with its joints there."""
        scene = self.bench.scene
        for name, solid in self._linkage.standing(joints, scene.carried):
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
        self._forget()
        self._busy = True
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
        if self._feeding.give(self._commands(self._rotors)):
            self._forget()
        self._changed()
