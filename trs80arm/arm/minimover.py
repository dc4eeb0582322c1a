"""The MiniMover 5: six stepper motors, their cables, the joints and hand that they move.

The arm hangs on the card's cable. All that comes down the cable are writes to seven latches,
with times; all that goes up are four input bits. Nothing here knows of registers or programs:
what the arm was told and where it is are two things.
"""

from __future__ import annotations

import math
from collections.abc import Hashable, Iterable, Sequence
from dataclasses import dataclass, fields, replace
from typing import Any

from trs80arm.arm.bench import Bench, BenchError
from trs80arm.arm.body import Body
from trs80arm.arm.burst import LONGEST, run_free
from trs80arm.arm.cell.device import NEVER
from trs80arm.arm.cell.inputs import Answer
from trs80arm.arm.event_log import EventLog
from trs80arm.arm.events import ArmEvent, EventKind, Happening, Reason
from trs80arm.arm.forces import Burden, Strength, Vector, cosine, torques
from trs80arm.arm.geometry import CableDrive, JointAngles, OutOfReach, forward, inverse, pose_of
from trs80arm.arm.grip import Grip
from trs80arm.arm.limits import beyond_any_stop, beyond_stop, steps_to_stops
from trs80arm.arm.loads import GripLoad, Loads, motor_load, per_cent
from trs80arm.arm.model import Link, Motor, Pose
from trs80arm.arm.motors import RING, ROWS, StepperMotor
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.stride import stride
from trs80arm.arm.world import World
from trs80arm.pulses import Burst, Columns, Series

__all__ = ["ArmState", "InTheWay", "MiniMover", "MotorsOn", "OutOfReach", "Pose"]

TURNED_BY_HAND = (*(angle.name for angle in fields(JointAngles)), "hand")
"""What the operator's hands can turn one by one."""
SHORT = 24
"""Writes in a burst below which a plain loop is quicker than arrays."""
FEW = 4
"""Writes done one by one where something may happen, before it is looked at again."""

STRONGEST = 1000.0
"""Ounces that an operator pulls by at most."""

GIVEN_WAY = 4
"""Half-steps by which a motor without current is turned in a tick, at most."""

ELBOW, HAND, AUXILIARY = int(Motor.ELBOW), int(Motor.HAND), 6


class MotorsOn(Exception):  # noqa: N818 (says what is, like OutOfReach)
    """The arm cannot be moved by hand while a motor holds it."""


class InTheWay(Exception):  # noqa: N818 (says what is, like OutOfReach)
    """Something on the bench is where the arm was to be moved by hand."""


Six = tuple[int, int, int, int, int, int]
"""One number for each motor."""


@dataclass(frozen=True, slots=True)
class ArmState:
    """What the arm looks like now.

    Attributes:
        rotors: six rotor positions, half-steps from where the arm was switched on.
        fields: six unwrapped field positions, half-steps.
        slipped: rotor less field; a multiple of 8 unless something holds the rotor back.
        coils: seven latch nibbles.
        motors_on: whether any of the six motors carries current.
        angles: of the joints, radians.
        pose: of the hand.
        force: of the grip, pounds.
        switch_closed: the grip switch.
        held: name of the part in the hand, or None.
    """

    rotors: Six
    fields: Six
    slipped: Six
    coils: tuple[int, ...]
    motors_on: bool
    angles: JointAngles
    pose: Pose
    force: float
    switch_closed: bool
    held: str | None


class MiniMover:
    """The arm on its bench.

    Attributes:
        settings: the open choices.
        model: what make of arm it is.
        bench: what the arm works on.
        drive: the cables; it knows the pose in which the arm was switched on.
        motors: six.
        strength: what its motors can do, and what its own weight asks of them.
        log: of what happened.
        peaks: the greatest share of what each motor has that any half-step took
            since `forget_peaks`, whole per cent, rounded up.
        known_uses: what was worked out of motors' parts in strides lately.
    """

    def __init__(self, settings: ArmSettings | None = None, bench: Bench | None = None) -> None:
        self.settings = settings or ArmSettings()
        self.model = self.settings.arm_model
        self.motors = [StepperMotor() for _ in range(6)]
        self.strength = Strength.of(self.model)
        self._most_squeeze = self.model.hand.most_squeeze
        self._motor_kinds = tuple(drive.turns for drive in self.model.drives)
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
        return {**self.__dict__, "_stops_off": 0, "_heaviest": None, "known_uses": {}}

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
        self.known_uses: dict[Hashable, int] = {}

    def refill(self) -> None:
        """Put every part of the bench back to where it was at the start.

        Raises:
            InTheWay: the arm stands where one of them was; all are left as they are.
        """
        name = self._world.refill()
        if name is not None:
            raise InTheWay(f"the arm is in the way: it stands where {name} was")

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
        done = self._follow_burst(burst, stop)
        self._world.show_load()
        return done

    def _follow_burst(self, burst: Burst, stop: tuple[int, int] | None) -> int:
        """`follow`, without having the load be shown where it is."""
        count = len(burst)
        if count < SHORT or (stop is not None and stop[0] & 0b1110 and self.bench.sensors):
            return self._follow_singly(burst, None, stop)[0]
        rest, patience = burst, FEW
        while rest:
            if len(rest) >= SHORT:
                self._pass(rest.begins)
            if len(rest) >= SHORT and self._free:
                near, beyond = self._before_alarm(rest)
                left, ended = self._stride(near, stop)
                done = len(near) - len(left)
                if ended:
                    return count - len(rest) + done
                # Where something happens it goes on happening for a while.
                patience = FEW if done else min(2 * patience, 8 * SHORT)
                rest = left if beyond is None else rest.split(done)[1]
                if not rest:
                    break
            few, rest = rest.split(min(len(rest), patience if self._free else FEW))
            done, ended = self._follow_singly(few, rest.begins if rest else None, stop)
            if ended:
                return count - len(rest) - len(few) + done
        return count

    def _before_alarm(self, burst: Burst) -> tuple[Burst, Burst | None]:
        """The writes before a device acts of itself, and the rest of them if it does by the end."""
        alarm = self._world.alarm
        if alarm == NEVER or alarm > burst.ends:
            return burst, None
        return burst.until(alarm)

    def _stride(self, burst: Burst, stop: tuple[int, int] | None) -> tuple[Burst, bool]:
        """As much of a burst at once as can be; what is left, and whether it was stopped there."""
        ahead = self._hand_ahead(burst, stop)
        if ahead < len(burst):
            near = burst.split(ahead)[0]
            left = stride(self, near, stop) if near else near
            done = 0 if left is None else len(near) - len(left)
            return burst.split(done)[1], False
        left = stride(self, burst, stop)
        if left is not None:
            return left, False
        some, beyond = burst.split(min(len(burst), LONGEST))
        then = beyond.begins if beyond else None
        done, ended = run_free(self, some.columns(), then, stop)
        return burst.split(done)[1], ended

    def _hand_ahead(self, burst: Burst, stop: tuple[int, int] | None) -> int:
        """Writes at the beginning of a burst up to which the hand alone cannot come to its end.

        Its end is where it is shut or wide open, squeezes as hard as it can, or closes the switch.
        """
        grip, model = self.grip, self.model
        if not burst.only(HAND):
            return len(burst)
        if grip.contact:
            hand = model.hand
            most = hand.most_squeeze if stop is None else hand.switch_steps
            room = most - 1 - int(grip.squeeze)
        elif grip.cable > 0:
            room = min(int(model.hand.range * model.hand_steps) - grip.cable, grip.cable)
        else:
            return len(burst)
        return max(0, min(len(burst), room - 2))

    @property
    def _free(self) -> bool:
        """Whether every motor is in step and no more than its own weight and load bears on it.

        Or what else does cannot change, as what it grips rests; what still gives way strains the
        hand's cable in ways of its own.
        """
        world = self._world
        if world.grip.strain or not all(motor.settled for motor in self.motors):
            return False
        return (world.free and not self._bears) or (world.gripped and self._pull is None)

    def _follow_singly(
        self, burst: Burst, then: int | None, stop: tuple[int, int] | None
    ) -> tuple[int, bool]:
        """Do writes one by one.

        Args:
            burst: the writes.
            then: T-state of the write after them, if they are the beginning of a burst.
            stop: as for `follow`.

        Returns:
            How many were done, and whether they were stopped there.
        """
        writes, write = burst.columns(), self._write
        times, latches, nibbles = writes.times, writes.latches, writes.nibbles
        if stop is None:
            for time, latch, nibble in zip(times, latches, nibbles, strict=True):
                write(int(time), int(latch), int(nibble))
            return len(times), False
        mask, value = stop
        for done, latch in enumerate(latches, start=1):
            time = int(times[done - 1])
            write(time, int(latch), int(nibbles[done - 1]))
            after = times[done] if done < len(times) else then
            if after != time and self.inputs(time) & mask == value:
                return done, True
        return len(times), False

    def advance(self, time: int) -> None:
        """Let time pass, up to a T-state: what falls goes on falling, what presses presses."""
        self._pass(time)
        self._world.show_load()

    def _pass(self, time: int) -> None:
        """`advance`, without having the load be shown where it is."""
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
        world = self._world
        while world.due <= time:
            if world.idle:
                world.skip(time)
                break
            self._time = max(self._time, world.due)
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

    def _write(self, time: int, latch: int, nibble: int) -> None:
        """One latch write."""
        if not 0 <= latch <= AUXILIARY:
            return
        nibble &= 15
        if self._world.due <= time or self._world.alarm <= time:
            self._pass(time)
        self._time = max(self._time, time)
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
        most = 1 if motor.row < 0 else RING
        turn = motor.turn_field(row)
        if turn:
            motor.asked((time,) * min(abs(turn), most), 1 if turn > 0 else -1)
        against, outside = self._resistance(latch, turn, self._rotors)
        curve = self.strength.curves[self._motor_kinds[latch]]
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

    def period_at(self, latch: int, turn: int, rotors: Sequence[int]) -> int:
        """T-states that a motor needs for a half-step where nothing but weight bears on the arm.

        Args:
            latch: of the motor.
            turn: which way it turns.
            rotors: where all stand.
        """
        turns, burdens = self._motor_kinds[latch], self._world.burdens()
        if turns is Motor.HAND:
            squeeze = max(0, self.grip.contact - self.drive.cable(rotors))
            against = 16 * (squeeze / self.model.hand.pound_steps) if turn < 0 else 0.0
        elif turns is Motor.BASE and not burdens:
            against = 0.0
        else:
            weight = self._weight(turns, burdens, rotors)
            lifts = turns is Motor.BASE or turn * self.model.drives[latch].sign > 0
            against = max(0.0, weight if lifts else -weight)
        return self.strength.curves[turns].period(against, self.settings.speed_margin)

    def _resistance(self, latch: int, turn: int, rotors: Sequence[int]) -> tuple[float, float]:
        """Torque that a motor turns against, at least 0, and how much of it is not own weight."""
        if turn == 0:
            return 0.0, 0.0
        turns, world = self._motor_kinds[latch], self._world
        burdens, pushed = world.burdens(), self._pushed(turns)
        own = self._weight(turns, (), rotors)
        weight = self._weight(turns, burdens, rotors) if burdens else own
        if turns is Motor.BASE:
            against = weight - pushed if turn > 0 else weight + pushed
            return max(0.0, against), against
        up = turn * self.model.drives[latch].sign > 0
        against, alone = (weight - pushed, own) if up else (pushed - weight, -own)
        return max(0.0, against), against - alone

    def _weight(self, turns: Motor, burdens: Sequence[Burden], rotors: Sequence[int]) -> float:
        """Torque with which weight pulls a motor's angle down (the base: drags it)."""
        if turns is Motor.HAND or (turns is Motor.BASE and not burdens):
            return 0.0
        driven = self.drive.driven(rotors)
        return float(self.strength.weight(turns, driven, burdens, cosine))

    def _pushed(self, turns: Motor) -> float:
        """Torque of contacts and of the operator's hand; positive pushes the angle up."""
        pushed = self._world.torques[turns]
        if self._pull is not None:
            angles = self._world.angles
            tip = forward(self.model, angles).fingertip
            pushed += torques(self.model, angles, Link.HAND, tip, self._pull)[turns]
        return pushed

    @property
    def _bears(self) -> bool:
        """Whether motors that stand might have to give way.

        Something presses on the arm or is pushed by it, the hand is pulled at or has something
        heavy in it, or its cable is too tight. Full load is nothing to a motor that stands.
        """
        world = self._world
        if self._pull is not None or world.strained:
            return True
        if world.grip.squeeze > self._most_squeeze:
            return True
        burdens = world.burdens()
        if not burdens:
            return False
        return sum([burden.weight for burden in burdens]) > self.model.full_load

    def _give_way(self) -> None:
        """Motors that stand and bear more than they hold are turned by it.

        With its current on a rotor falls by a ring at a time, without it by a few half-steps;
        what is met on the way is known on the next tick.
        """
        for latch, drive in enumerate(self.model.drives):
            motor, curve = self.motors[latch], self.strength.curves[drive.turns]
            most = self._most(drive.turns) + abs(self._pushed(drive.turns))
            if most <= (curve.holds if motor.row >= 0 else curve.friction):
                continue
            for _ in range(1 if motor.row >= 0 else GIVEN_WAY):
                pull = self._pushed(drive.turns)
                if drive.turns is not Motor.BASE:
                    pull -= self._weight(drive.turns, self._world.burdens(), self._rotors)
                if abs(pull) <= (curve.holds if motor.row >= 0 else curve.friction):
                    break
                if not self._turned(latch, drive.sign if pull > 0 else -drive.sign):
                    break
                if self._world.strained:
                    break

    def _most(self, turns: Motor) -> float:
        """The most torque that weight can be on a motor."""
        burdens = self._world.burdens()
        if self._heaviest is None or self._heaviest[0] is not burdens:
            most = [self.strength.most(motor, burdens) for motor in Motor]
            most[Motor.BASE] = 0.0
            self._heaviest = burdens, most
        return self._heaviest[1][turns]

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
            if beyond_stop(latch, step, self.drive, rotors):
                rotors[latch] -= step
                return Reason.STOP
            self._stops_off = steps_to_stops(self.drive, rotors)
        world.moved(rotors, latch)
        if not (self._bears or world.grip.squeeze):
            return None
        turns = self._motor_kinds[latch]
        if self._resistance(latch, step, rotors)[0] <= self.strength.curves[turns].stall:
            return None
        rotors[latch] -= step
        world.moved(rotors, latch)
        return Reason.CONTACT if self._in_the_way(latch) else Reason.LOAD

    def _in_the_way(self, latch: int) -> bool:
        """Whether something is in a motor's way: never the hand's, which only squeezes."""
        return self._world.blocked and self._motor_kinds[latch] is not Motor.HAND

    def _held_up(self, latch: int, reason: Reason) -> None:
        """Something holds a rotor back; what it is is news the first time."""
        if reason is Reason.CONTACT:
            name = self._world.met or "something"
            force = self._force(latch)
            happening = Happening(EventKind.CONTACT, self.model.motor_names[latch], name)
            self.log.tell(self._time, happening, latch, force)
        self.motors[latch].trouble = reason

    def _force(self, latch: int) -> float:
        """Ounces at the end of the link that contacts put on a motor."""
        turns, model = self._motor_kinds[latch], self.model
        levers = (model.reach, model.link, model.link, model.hand_length, model.hand_length, 1.0)
        return abs(self._world.torques[turns]) / levers[turns]

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
        return tuple(self._borne(turns) for turns in self._motor_kinds)

    def _borne(self, turns: Motor) -> float:
        """What one motor bears."""
        if turns is Motor.HAND:
            return -16 * self._world.grip.force
        burdens = self._world.burdens()
        return self._weight(turns, burdens, self._rotors) - self._pushed(turns)

    def loads(self, time: int) -> Loads:
        """What motors and hand bear at a T-state, not before the last write, and what they have."""
        motors = []
        for latch, drive in enumerate(self.model.drives):
            motor, turns = self.motors[latch], drive.turns
            rate, torque = motor.rate(time), self._borne(turns)
            if rate:
                against = self._resistance(latch, motor.way, self._rotors)[0]
            else:
                # What is carried drags on a base that turns, and does nothing to one that stands.
                torque = -self._pushed(turns) if turns is Motor.BASE else torque
                against = abs(torque)
            motors.append(
                motor_load(
                    motor,
                    drive,
                    self.strength.curves[turns],
                    torque=torque + 0.0,
                    against=against,
                    rate=rate,
                    margin=self.settings.speed_margin,
                    peak=self.peaks[latch],
                )
            )
        weight, friction = self._world.hold
        return Loads(tuple(motors), GripLoad(self.grip.force, weight, friction))

    def state(self) -> ArmState:
        """A snapshot for display."""
        self._world.show()
        angles = self._world.angles
        grip = self._world.grip
        six = self.motors
        return ArmState(
            _six(motor.rotor for motor in six),
            _six(motor.field for motor in six),
            _six(motor.rotor - motor.field for motor in six),
            (*(motor.coils for motor in six), self.bench.cell.nibble),
            any(motor.energised for motor in six),
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
        if not math.isfinite(value):
            raise ValueError(f"{value} is nowhere")
        angles = self.drive.angles(self._rotors)
        cable = self.drive.cable(self._rotors)
        if joint == "hand":
            cable = self._cable_for(value)
        elif joint in TURNED_BY_HAND:
            angles = replace(angles, **{joint: math.radians(value)})
        else:
            raise ValueError(f"no joint {joint}: {', '.join(TURNED_BY_HAND[:-1])} or hand")
        self._place(angles, cable)

    def move_to(self, pose: Pose) -> None:
        """Take the hand to a pose, by hand.

        Raises:
            MotorsOn: while any motor carries current.
            OutOfReach: if Table 4's subroutine would say so.
            InTheWay: if something on the bench is there.
            ValueError: if a joint or the hand does not go that far.
        """
        angles = inverse(self.model, pose.x, pose.y, pose.z, pose.pitch, pose.roll)
        self._place(angles, self._cable_for(pose.opening))

    def move_joints(self, angles: JointAngles) -> None:
        """Turn all five joints by hand; the hand's cable stays as it is.

        Raises:
            MotorsOn: while any motor carries current.
            InTheWay: if something on the bench is there.
            ValueError: if a joint does not go that far.
        """
        self._place(angles, self.drive.cable(self._rotors))

    def _cable_for(self, opening: float) -> int:
        widest = self.model.hand.range
        if not 0 <= opening <= widest:
            raise ValueError(f"the hand opens from 0 to {widest:g} in, not {opening:g}")
        return round(opening * self.model.hand_steps)

    def _place(self, angles: JointAngles, cable: int) -> None:
        """Put rotors where the operator's hands want the joints."""
        if any(motor.energised for motor in self.motors):
            raise MotorsOn("the motors are on: @RESET turns them off")
        rotors = list(self.drive.rotors(angles, cable))
        stop = beyond_any_stop(self.drive, rotors)
        if stop is not None:
            raise ValueError(f"that is beyond a stop: {stop}")
        name = self._world.place(self._rotors, rotors)
        if name is not None:
            raise InTheWay(f"{name} is in the way")
        self._rotors[:] = rotors
        self._stops_off = 0
        for latch, rotor in enumerate(rotors):
            self.motors[latch].rotor = rotor
            self.motors[latch].release()
        if self._bears:
            self._give_way()
        self._tell_news()


def _six(numbers: Iterable[int]) -> Six:
    """Six numbers as a tuple."""
    base, shoulder, elbow, left, right, hand = numbers
    return base, shoulder, elbow, left, right, hand
