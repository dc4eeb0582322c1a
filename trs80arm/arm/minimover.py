"""The MiniMover 5: six stepper motors, their cables, the joints and hand that they move.

The arm hangs on the card's cable. All that comes down the cable are writes to seven latches,
with times; all that goes up are four input bits. Nothing here knows of registers or programs:
what the arm was told and where it is are two things.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from trs80arm.arm.bearing import borne, loads, pushes, pushing, resistance, weighing
from trs80arm.arm.bench import Bench, BenchError
from trs80arm.arm.body import Body
from trs80arm.arm.by_hand import STRONGEST, cable_for, placed, refill, turned
from trs80arm.arm.cell.inputs import Answer
from trs80arm.arm.contact.recurrence import Recurrence
from trs80arm.arm.event_log import EventLog
from trs80arm.arm.events import ArmEvent, EventKind, Happening, Reason
from trs80arm.arm.following import follow_burst
from trs80arm.arm.forces import Burden, Strength, Vector
from trs80arm.arm.geometry import CableDrive, JointAngles, OutOfReach, forward, inverse, pose_of
from trs80arm.arm.grip import Grip
from trs80arm.arm.limits import beyond_stop, steps_to_stops
from trs80arm.arm.loads import Loads, per_cent
from trs80arm.arm.model import BASE, HAND, Motor, Pose
from trs80arm.arm.motors import RING, ROWS, StepperMotor
from trs80arm.arm.passage import Passage
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.state import ArmState, six
from trs80arm.arm.world import World
from trs80arm.pulses import Burst, Columns, Series

__all__ = ["MiniMover", "OutOfReach", "Pose"]

GIVEN_WAY = 4
"""Half-steps by which a motor without current is turned in a tick, at most."""

KNOWN = 1024
"""Bursts that are remembered."""

AUXILIARY = 6


class MiniMover:
    """The arm on its bench.

    Attributes:
        settings: the open choices.
        model: what make of arm it is.
        bench: what the arm works on.
        drive: the cables; it knows the pose in which the arm was switched on.
        motors: six.
        motor_kinds: what each latch's motor turns.
        strength: what its motors can do, and what its own weight asks of them.
        log: of what happened.
        peaks: the greatest share of what each motor has that any half-step took
            since `forget_peaks`, whole per cent, rounded up.
        known_passages: what was found of bursts lately, whenever they began.
    """

    def __init__(self, settings: ArmSettings | None = None, bench: Bench | None = None) -> None:
        self.settings = settings or ArmSettings()
        self.model = self.settings.arm_model
        self.motors = [StepperMotor() for _ in range(6)]
        self.strength = Strength.of(self.model)
        self._most_squeeze = self.model.hand.most_squeeze
        self.motor_kinds = tuple(drive.turns for drive in self.model.drives)
        self._stops_off = 0
        self.peaks = [0] * 6
        self.log = EventLog(self.settings.events_kept)
        self._time = 0
        self._held_back: set[int] = set()
        self._pull: Vector | None = None
        self._heaviest: tuple[tuple[Burden, ...], list[float]] | None = None
        self._stand_at(self.prepare(Bench.standard() if bench is None else bench))

    def __getstate__(self) -> dict[str, Any]:
        # What is on the bench is seen before the world is: all of it has to be where it is.
        self._world.show()
        # The distance to the stops is found anew; how it was counted hangs on how a run is cut.
        return {
            **self.__dict__,
            "_stops_off": 0,
            "_heaviest": None,
            "known_passages": Recurrence(KNOWN),
        }

    def prepare(self, bench: Bench) -> World:
        """A bench laid out for this arm, everything on it at rest; the arm is not at it yet.

        Raises:
            BenchError: the arm cannot reach the place where the bench has it.
        """
        bench.suit(self.settings)
        try:
            drive = CableDrive.from_pose(self.model, bench.start or self.model.start)
        except OutOfReach as error:
            raise BenchError(
                f"{bench.name}: arm.at: expected a place that the {self.model.title} can reach; "
                f"{error}"
            ) from None
        world = World(bench, self.settings, drive)
        world.start()
        return world

    def work_at(self, world: World) -> None:
        """Stand at a bench that was prepared, in its starting pose; coils stay as they are."""
        nibble = self.bench.cell.nibble
        self._stand_at(world)
        self.bench.cell.connect(nibble)
        for latch, motor in enumerate(self.motors):
            motor.rotor = 0
            motor.release()
            self._held_back.discard(latch)
            if ROWS[motor.coils] >= 0:
                motor.turn_field(ROWS[motor.coils])
                self._follow(latch)

    def _stand_at(self, world: World) -> None:
        self._world, self.bench, self.drive = world, world.bench, world.drive
        self._rotors = [0] * 6
        self._stops_off = 0
        self.known_passages: Recurrence[Passage] = Recurrence(KNOWN)

    def refill(self) -> None:
        """Put every part of the bench back to where it was at the start.

        Raises:
            InTheWay: the arm stands where one of them was; all are left as they are.
        """
        refill(self._world)

    # The cable

    def apply(
        self, times: Series, latches: Series, nibbles: Series, stop: tuple[int, int] | None = None
    ) -> int:
        """`follow` for single writes, one column each of T-states, latches and nibbles."""
        return self.follow(Columns(times, latches, nibbles), stop)

    def follow(self, burst: Burst, stop: tuple[int, int] | None = None) -> int:
        """Do a burst of latch writes.

        Args:
            burst: to latches 0 base, 1 shoulder, 2 elbow, 3 left wrist, 4 right wrist, 5 hand,
                6 auxiliary; the patterns have phi1 as the high bit.
            stop: (mask, value): the burst ends after the last write of the first time at which
                the input nibble and mask give value.

        Returns:
            How many of the writes were done.
        """
        done = follow_burst(self, burst, stop)
        self._world.show_load()
        return done

    @property
    def free(self) -> bool:
        """Whether every motor is in step and no more than its own weight and load bears on it.

        Or what else does cannot change, as what it grips rests; what still gives way strains the
        hand's cable in ways of its own.
        """
        world = self._world
        if world.grip.strain:
            return False
        for motor in self.motors:
            if not motor.settled:
                return False
        return (world.free and not self._bears) or (world.gripped and self._pull is None)

    def advance(self, time: int) -> None:
        """Let time pass, up to a T-state: what falls goes on falling, what presses presses."""
        self.let_pass(time)
        self._world.show_load()

    def let_pass(self, time: int) -> None:
        """`advance`, without having the load be shown where it is."""
        if self.bench.cell.devices:
            world = self._world
            while (alarm := world.alarm) <= time:
                # What a device does of itself it does at that very T-state, before a tick there.
                self._tick(alarm - 1)
                self._time = max(self._time, alarm)
                world.ring(self.log)
                self._tell_news()
        self._tick(time)

    def _tick(self, time: int) -> None:
        """Let all ticks up to a T-state pass."""
        world, scene = self._world, self.bench.scene
        while scene.due <= time:
            if world.idle:
                world.skip(time)
                break
            self._time = max(self._time, scene.due)
            world.tick()
            if self._bears:
                self._give_way()
            if self.bench.news:
                self._tell_news()

    def arrive(self, rotors: list[int], ticked: list[int], time: int) -> None:
        """Be where free motion has led to.

        Args:
            rotors: positions of all.
            ticked: those that they had on the last tick of the world's.
            time: T-state of the last write.
        """
        self._rotors[:] = rotors
        self._stops_off = 0
        self._time = max(self._time, time)
        self._world.arrive(rotors, ticked, time)

    def inputs(self, time: int) -> int:
        """The input nibble: bit 0 is the grip switch, bits 1 to 3 the bench's sensors.

        All idle at 1 and answer with 0.
        """
        self.advance(time)
        switch = 0 if self._world.grip.switch_closed else 1
        return switch | self._world.sensed(time, self.bench.cell.nibble, self._pull)

    def answers(self, time: int) -> tuple[Answer, ...]:
        """What each sensor of the bench says at a T-state, in whatever bank it is."""
        self.advance(time)
        seen = self._world.seen(time, self._pull)
        return tuple(Answer.of(sensor, seen) for sensor in self.bench.sensors)

    def write(self, time: int, latch: int, nibble: int) -> None:
        """One latch write."""
        if not 0 <= latch <= AUXILIARY:
            return
        nibble &= 15
        bench = self.bench
        if bench.scene.due <= time or (bench.cell.devices and bench.cell.alarm <= time):
            self.let_pass(time)
        self._world.begins(time)
        if time > self._time:
            self._time = time
        if latch == AUXILIARY:
            self._write_auxiliary(time, nibble)
            return
        motor = self.motors[latch]
        row = ROWS[nibble]
        if nibble == motor.coils and row == motor.row:
            return
        motor.coils = nibble
        if row < 0:
            motor.release()
            self._held_back.discard(latch)
            if self._bears:
                self._give_way()
            return
        # The first field after none finds a rotor that may be anywhere: no more than a half-step.
        first = motor.row < 0
        turn = motor.turn_field(row)
        if turn == 1 or turn == -1 or (first and turn):
            motor.asked_once(time, 1 if turn > 0 else -1)
        elif turn:
            motor.asked((time,) * abs(turn), 1 if turn > 0 else -1)
        against, outside = resistance(self, latch, turn, self._rotors)
        curve = self.strength.curves[self.motor_kinds[latch]]
        period = curve.period(against, self.settings.speed_margin)
        in_step = motor.keep_pace(time, turn, period, self.settings.pull_out_lag)
        if turn:
            share = curve.used(against, motor.pace / self.settings.speed_margin)
            if 100 * share > self.peaks[latch]:
                self.note_use(latch, per_cent(share))
        if not in_step:
            if outside > 0.0 and self._in_the_way(latch):
                self._held_up(latch, Reason.CONTACT)
            else:
                motor.trouble = Reason.LOAD if outside > 0.0 else Reason.RATE
        self._follow(latch)
        if self._held_back:
            self._follow_others(latch)
        if self._bears:
            self._give_way()

    def _write_auxiliary(self, time: int, nibble: int) -> None:
        """A write to the auxiliary latch."""
        if nibble == self.bench.cell.nibble:
            return
        self._world.write_auxiliary(time, nibble, self.log)
        self._tell_news()
        if self._held_back:
            self._follow_others(AUXILIARY)
        if self._bears:
            self._give_way()

    def note_use(self, latch: int, used: int) -> None:
        """A motor has used so much of what it has, per cent."""
        if used > self.peaks[latch]:
            self.peaks[latch] = used

    def forget_peaks(self) -> None:
        """The greatest use of the motors counts anew."""
        self.peaks[:] = [0] * 6

    @property
    def _bears(self) -> bool:
        """Whether motors that stand might have to give way.

        Something presses on the arm or is pushed by it, the hand is pulled at or has something
        heavy in it, or its cable is too tight. Full load is nothing to a motor that stands.
        """
        grasp = self._world.grasp
        if self._pull is not None or any(grasp.pushed):
            return True
        if self._world.grip.squeeze > self._most_squeeze:
            return True
        burdens = grasp.burdens
        return bool(burdens) and sum([each.weight for each in burdens]) > self.model.full_load

    def _give_way(self) -> None:
        """Motors that stand and bear more than they hold are turned by it.

        With its current on a rotor falls by a ring at a time, without it by a few half-steps;
        what is met on the way is known on the next tick.
        """
        heaviest, pushed = self._most_weight(), pushes(self)
        for latch, drive in enumerate(self.model.drives):
            motor, curve = self.motors[latch], self.strength.curves[drive.turns]
            most = heaviest[drive.turns] + abs(pushed[drive.turns])
            if most <= (curve.holds if motor.row >= 0 else curve.friction):
                continue
            for _ in range(1 if motor.row >= 0 else GIVEN_WAY):
                pull = pushing(self, drive.turns)
                if drive.turns is not BASE:
                    pull -= weighing(self, drive.turns, self._world.burdens(), self._rotors)
                if abs(pull) <= (curve.holds if motor.row >= 0 else curve.friction):
                    break
                if not self._turned(latch, drive.sign if pull > 0 else -drive.sign):
                    break
                if self._world.strained:
                    break
            pushed = pushes(self)

    def _most_weight(self) -> Sequence[float]:
        """The most torque that weight can be on each motor, by `Motor`."""
        burdens = self._world.burdens()
        if self._heaviest is None or self._heaviest[0] is not burdens:
            most = [self.strength.most(motor, burdens) for motor in Motor]
            most[BASE] = 0.0
            self._heaviest = burdens, most
        return self._heaviest[1]

    def _turned(self, latch: int, step: int) -> bool:
        """Let a rotor be turned to its next place of rest by what pulls; whether it could."""
        motor = self.motors[latch]
        for _ in range(RING if motor.row >= 0 else 1):
            self._rotors[latch] += step
            self._stops_off = 0
            if beyond_stop(latch, step, self.drive, self._rotors):
                self._rotors[latch] -= step
                return False
            motor.rotor += step
            self._world.moved(self._rotors, latch)
        if motor.row < 0:
            motor.field = motor.rotor
        else:
            motor.trouble, motor.followed = Reason.LOAD, 0
            self._count_rings(latch, motor.rotor)
        return True

    def _follow(self, latch: int) -> None:
        """Let a rotor go where its field pulls it, as far as it can."""
        motor = self.motors[latch]
        trouble = motor.anchor is not None
        target = motor.target
        while motor.rotor != target:
            step = 1 if target > motor.rotor else -1
            blocked = self._step(latch, step)
            if blocked is not None:
                trouble = True
                self._held_up(latch, blocked)
                break
            motor.rotor += step
        if motor.rotor == target:
            self._held_back.discard(latch)
        else:
            self._held_back.add(latch)
        if trouble:
            motor.followed = 0
        else:
            motor.follow(1)
        if motor.field - target != RING * motor.ring:
            self._count_rings(latch, target)
        if self.bench.news:
            self._tell_news()

    def _follow_others(self, latch: int) -> None:
        """Rotors that were held back try again after another one has moved."""
        for other in sorted(self._held_back - {latch}):
            self._follow(other)

    def _step(self, latch: int, step: int) -> Reason | None:
        """Turn one rotor by one half-step, with all that hangs on it.

        Returns:
            What blocks it, or None if it has moved.
        """
        world, rotors = self._world, self._rotors
        rotors[latch] += step
        if self._stops_off > 0:
            self._stops_off -= 1
        else:
            self._stops_off = steps_to_stops(self.drive, rotors)
            if not self._stops_off and beyond_stop(latch, step, self.drive, rotors):
                rotors[latch] -= step
                return Reason.STOP
        world.moved(rotors, latch)
        if not (self._bears or world.grip.squeeze):
            return None
        turns = self.motor_kinds[latch]
        stall = self.strength.curves[turns].stall
        most = self._most_weight()[turns] + abs(world.torque(turns))
        if most <= stall and self._pull is None and turns is not BASE:
            # However the arm stands, it is no more than that.
            return None
        if resistance(self, latch, step, rotors)[0] <= stall:
            return None
        rotors[latch] -= step
        world.moved(rotors, latch)
        return Reason.CONTACT if self._in_the_way(latch) else Reason.LOAD

    def _in_the_way(self, latch: int) -> bool:
        """Whether something is in a motor's way: never the hand's, which only squeezes."""
        return self._world.blocked and self.motor_kinds[latch] is not HAND

    def _held_up(self, latch: int, reason: Reason) -> None:
        """Something holds a rotor back; what it is is news the first time."""
        if reason is Reason.CONTACT:
            name = self._world.met or "something"
            force = self._force(latch)
            happening = Happening(EventKind.CONTACT, self.model.motor_names[latch], name)
            self.log.tell(self._time, happening, latch, force)
        self.motors[latch].trouble = reason

    def _force(self, latch: int) -> float:
        """Ounces at the hand, along the way it turns it, of what contacts put on a motor."""
        turns, model = self.motor_kinds[latch], self.model
        if turns is BASE:
            x, y, _ = forward(model, self._world.angles).fingertip
            lever = max(math.sqrt(x * x + y * y), model.hand_length)
        else:
            # A link swings the hand about without turning it, and one wrist motor pitches it by
            # half.
            half = model.hand_length / 2
            lever = (0.0, model.link, model.link, half, half, 1.0)[turns]
        return abs(self._world.torques[turns]) / lever

    def _count_rings(self, latch: int, target: int) -> None:
        """Note rings that a rotor has lost or regained against its field."""
        motor = self.motors[latch]
        behind = motor.field - target
        if behind % RING or behind // RING == motor.ring:
            return
        steps = RING * motor.ring - behind
        motor.ring = behind // RING
        reason = motor.trouble
        name = self.model.motor_names[latch]
        way = "back" if steps < 0 else "on"
        happening = Happening(EventKind.SLIP, name, way, reason)
        goes_on = motor.losing is not None
        motor.losing = self.log.tell(
            self._time, happening, latch, self._force(latch), steps, goes_on=goes_on
        )

    def _tell_news(self) -> None:
        """Turn what the bench has to tell into events."""
        for kind, text in self.bench.news:
            self.log.tell(self._time, Happening(kind, text))
        self.bench.news.clear()

    # Looking at it

    def borne(self) -> tuple[float, ...]:
        """What the motors bear now, by latch: ounce-inches at the joint, ounces at the fingers.

        Positive pulls a joint's angle down, or the fingers together. Weight, what is in the hand,
        what pushes and presses.
        """
        return borne(self)

    def loads(self, time: int) -> Loads:
        """What motors and hand bear at a T-state, not before the last write, and what they have."""
        return loads(self, time)

    def state(self) -> ArmState:
        """A snapshot for display."""
        self._world.show()
        angles = self._world.angles
        grip = self._world.grip
        motors = self.motors
        return ArmState(
            six(motor.rotor for motor in motors),
            six(motor.field for motor in motors),
            six(motor.rotor - motor.field for motor in motors),
            (*(motor.coils for motor in motors), self.bench.cell.nibble),
            any(motor.energised for motor in motors),
            angles,
            pose_of(self.model, angles, self._world.body.opening),
            grip.force,
            grip.switch_closed,
            grip.part,
        )

    @property
    def events(self) -> list[ArmEvent]:
        """What happened, the latest `settings.events_kept` of it."""
        return self.log.events

    @property
    def event_count(self) -> int:
        """Events so far, those dropped from the list included."""
        return self.log.count

    @property
    def rotors(self) -> tuple[int, ...]:
        """Rotor positions of the six motors, half-steps."""
        return tuple(self._rotors)

    @property
    def world(self) -> World:
        """Where arm and bench meet."""
        return self._world

    @property
    def body(self) -> Body:
        """Links and fingers as they stand, for drawing."""
        return self._world.body

    @property
    def pulled(self) -> Vector | None:
        """Ounces along x, y and z with which the operator pulls at the fingertip, or None."""
        return self._pull

    @property
    def grip(self) -> Grip:
        """The hand's hold on things."""
        return self._world.grip

    # The operator's hands

    def pull(self, force: Vector | None) -> None:
        """Pull at the hand until told otherwise.

        Motors with their current on hold against it up to what they can, and lose rings beyond
        that; without current the joints give way as soon as it is more than the friction of their
        gears.

        Args:
            force: ounces along x, y and z, at the fingertip; None to let go.

        Raises:
            ValueError: it is more than any hand, or no number.
        """
        if force and not all(abs(part) <= STRONGEST for part in force):
            raise ValueError(f"a hand pulls by up to {STRONGEST:g} oz")
        self._pull = force if force and any(force) else None
        if self._pull is not None:
            self._give_way()
            self._tell_news()

    def move_joint(self, joint: str, value: float) -> None:
        """Turn one joint by hand.

        Args:
            joint: "base", "shoulder", "elbow", "pitch" or "roll" with `value` in degrees (elbow
                and pitch from the horizontal, as everywhere; roll relative to the arm), or
                "hand" with `value` in inches.
            value: where to.

        Raises:
            MotorsOn: while any motor carries current.
            InTheWay: if something on the bench is there.
            ValueError: if the joint does not go that far, or there is no such joint.
        """
        self._place(*turned(self, joint, value))

    def move_to(self, pose: Pose) -> None:
        """Take the hand to a pose, by hand.

        Raises:
            MotorsOn: while any motor carries current.
            OutOfReach: if Table 4's subroutine would say so.
            InTheWay: if something on the bench is there.
            ValueError: if a joint or the hand does not go that far.
        """
        angles = inverse(self.model, pose.x, pose.y, pose.z, pose.pitch, pose.roll)
        self._place(angles, cable_for(self, pose.opening))

    def move_joints(self, angles: JointAngles) -> None:
        """Turn all five joints by hand; the hand's cable stays as it is.

        Raises:
            MotorsOn: while any motor carries current.
            InTheWay: if something on the bench is there.
            ValueError: if a joint does not go that far.
        """
        self._place(angles, self.drive.cable(self._rotors))

    def _place(self, angles: JointAngles, cable: int) -> None:
        """Put rotors where the operator's hands want the joints."""
        rotors = placed(self, angles, cable)
        self._rotors[:] = rotors
        self._stops_off = 0
        for motor, rotor in zip(self.motors, rotors, strict=True):
            motor.rotor = rotor
            motor.release()
        if self._bears:
            self._give_way()
        self._tell_news()
