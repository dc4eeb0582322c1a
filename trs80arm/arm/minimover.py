"""The MiniMover 5: six stepper motors, their cables, the joints and hand that they move.

The arm hangs on the card's cable. All that comes down the cable are writes to seven latches,
with times; all that goes up are four input bits. Nothing here knows of registers or programs:
what the arm was told and where it is are two things.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, fields, replace

import numpy as np
import numpy.typing as npt

from trs80arm.arm.bench import Bench, BenchError
from trs80arm.arm.body import Body
from trs80arm.arm.burst import LONGEST, run_free
from trs80arm.arm.events import ArmEvent, EventKind, Reason
from trs80arm.arm.geometry import CableDrive, JointAngles, OutOfReach, inverse, pose_of
from trs80arm.arm.grip import Grip
from trs80arm.arm.limits import beyond_any_stop, beyond_stop, load_fraction
from trs80arm.arm.model import Motor, Pose
from trs80arm.arm.motors import RING, ROWS, StepperMotor, shortest_period
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.world import World

__all__ = ["ArmState", "InTheWay", "MiniMover", "MotorsOn", "OutOfReach", "Pose"]

Ints = Sequence[int] | npt.NDArray[np.int64]

TURNED_BY_HAND = (*(angle.name for angle in fields(JointAngles)), "hand")
"""What the operator's hands can turn one by one."""
SHORT = 48
"""Writes in a burst below which a plain loop is quicker than arrays."""

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
        motors: six, and the turntable's as the seventh.
        free_periods: T-states per half-step that each motor needs without load.
        events: what happened, the latest `settings.events_kept` of it.
        event_count: events so far, those dropped from the list included.
    """

    def __init__(self, settings: ArmSettings | None = None, bench: Bench | None = None) -> None:
        self.settings = settings or ArmSettings()
        self.model = self.settings.arm_model
        self.motors = [StepperMotor() for _ in range(7)]
        # The turntable's motor is of the base's kind.
        drives = (*self.model.drives, self.model.drives[Motor.BASE])
        self.free_periods = tuple(
            shortest_period(drive, 0.0, self.settings.speed_margin) for drive in drives
        )
        self.events: list[ArmEvent] = []
        self.event_count = 0
        self._time = 0
        self._held_back: set[int] = set()
        self._set_up(Bench.standard() if bench is None else bench)

    def _set_up(self, bench: Bench) -> None:
        """Stand at a bench, in the pose in which it has the arm switched on."""
        bench.suit(self.settings)
        self.bench = bench
        try:
            self.drive = CableDrive.from_pose(self.model, bench.start or self.model.start)
        except OutOfReach as error:
            raise BenchError(
                f"{bench.name}: arm.at: expected a place that the {self.model.title} can reach; "
                f"{error}"
            ) from None
        self._rotors = [0] * 6
        self._world = World(bench, self.settings, self.drive)
        self._world.start()

    def set_bench(self, bench: Bench) -> None:
        """Work on another bench, beginning in its starting pose; coils stay as they are."""
        self._set_up(bench)
        for latch, motor in enumerate(self.motors):
            motor.rotor = 0
            motor.release()
            self._held_back.discard(latch)
            if ROWS[motor.coils] >= 0:
                motor.turn_field(ROWS[motor.coils])
                self._follow(latch)

    def refill(self) -> None:
        """Put every part of the bench back to where it was at the start."""
        self._world.refill()

    # The cable

    def apply(
        self, times: Ints, latches: Ints, nibbles: Ints, stop: tuple[int, int] | None = None
    ) -> int:
        """A burst of latch writes.

        Args:
            times: T-states, not decreasing.
            latches: 0 base, 1 shoulder, 2 elbow, 3 left wrist, 4 right wrist, 5 hand,
                6 auxiliary.
            nibbles: coil patterns, phi1 the high bit.
            stop: (mask, value): the burst ends after the last write of the first time at which
                the input nibble and mask give value.

        Returns:
            How many of the writes were done.
        """
        count = len(times)
        if count < SHORT or (stop is not None and stop[0] & 0b1110 and self.bench.sensors):
            return self._apply_singly(times, latches, nibbles, stop, 0, count)[0]
        when = np.asarray(times, dtype=np.int64)
        where = np.asarray(latches, dtype=np.int64)
        what = np.asarray(nibbles, dtype=np.int64)
        lists = when.tolist(), where.tolist(), what.tolist()
        ends = np.append(when[1:] != when[:-1], True)
        done, patience = 0, SHORT
        while done < count:
            ran = 0
            if count - done >= SHORT and all(motor.settled for motor in self.motors):
                window = slice(done, min(count, done + LONGEST))
                ran, ended = run_free(
                    self, when[window], where[window], what[window], stop, ends[window]
                )
                done += ran
                if ended:
                    return done
            # Where something happens it goes on happening for a while.
            patience = SHORT if ran > patience else min(2 * patience, 8 * SHORT)
            done, ended = self._apply_singly(*lists, stop, done, min(count, done + patience))
            if ended:
                return done
        return done

    def _apply_singly(
        self,
        times: Ints,
        latches: Ints,
        nibbles: Ints,
        stop: tuple[int, int] | None,
        start: int,
        end: int,
    ) -> tuple[int, bool]:
        """Writes `start` to `end` of a burst, one by one; how far, and whether they stopped."""
        write = self._write
        if stop is None:
            for i in range(start, end):
                write(int(times[i]), int(latches[i]), int(nibbles[i]))
            return end, False
        mask, value = stop
        for i in range(start, end):
            time = int(times[i])
            write(time, int(latches[i]), int(nibbles[i]))
            last = i + 1 == len(times) or int(times[i + 1]) != time
            if last and self.inputs(time) & mask == value:
                return i + 1, True
        return end, False

    def arrive(self, rotors: list[int], time: int) -> None:
        """Be where free motion has led to."""
        self._rotors[:] = rotors
        self._time = max(self._time, time)
        self._world.arrive(rotors)

    def inputs(self, time: int) -> int:
        """The input nibble: bit 0 is the grip switch, bits 1 to 3 the bench's sensors.

        All idle at 1 and answer with 0. The arm does not move between writes, so the time does
        not matter to it.
        """
        return (0 if self._world.grip.switch_closed else 1) | self._world.sensed()

    def _write(self, time: int, latch: int, nibble: int) -> None:
        """One latch write."""
        if not 0 <= latch <= AUXILIARY:
            return
        nibble &= 15
        motor = self.motors[latch]
        row = ROWS[nibble]
        self._time = max(self._time, time)
        if nibble == motor.coils and row == motor.row:
            return
        motor.coils = nibble
        if row < 0:
            motor.release()
            self._held_back.discard(latch)
            return
        turn = motor.turn_field(row)
        period, loaded = self._period(latch, turn)
        if not motor.keep_pace(time, turn, period, self.settings.pull_out_lag):
            motor.trouble = Reason.LOAD if loaded else Reason.RATE
        self._follow(latch)
        if self._held_back:
            self._follow_others(latch)

    def _period(self, motor: int, turn: int) -> tuple[int, bool]:
        """T-states per half-step under the present load, and whether load is what counts."""
        grip = self._world.grip
        squeeze = grip.squeeze if motor == HAND else 0
        if turn == 0 or motor == AUXILIARY or not (squeeze or grip.weight):
            return self.free_periods[motor], False
        angles = self.drive.angles(self._rotors)
        load = load_fraction(motor, turn, self.model, angles, grip.weight, squeeze)
        if load <= 0.0:
            return self.free_periods[motor], False
        return shortest_period(self.model.drives[motor], load, self.settings.speed_margin), True

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
        if latch == AUXILIARY:
            return None if self._world.turn_table(step) else Reason.CONTACT
        rotors = self._rotors
        rotors[latch] += step
        stop = beyond_stop(latch, step, self.drive, rotors)
        blocked = Reason.STOP if stop else self._world.try_move(latch, step, rotors)
        if blocked is not None:
            rotors[latch] -= step
        if latch == ELBOW:
            # Cable that the forearm pulls in beyond what the hand motor can hold turns it.
            excess = self._world.grip.excess(self.drive.cable(rotors))
            if excess > 0:
                self._yield_hand(excess)
        return blocked

    def _yield_hand(self, excess: int) -> None:
        """The hand's rotor is pulled round by its own cable."""
        motor = self.motors[HAND]
        give = excess if motor.row < 0 else -(-excess // RING) * RING
        motor.rotor += give
        self._rotors[HAND] += give
        self._world.regrip(self._rotors)
        if motor.row < 0:
            motor.field = motor.rotor
        else:
            motor.trouble, motor.followed = Reason.LOAD, 0
            self._count_rings(HAND, motor.rotor)

    def _held_up(self, latch: int, reason: Reason) -> None:
        """Something holds a rotor back; what it is is news the first time."""
        motor = self.motors[latch]
        if reason is Reason.CONTACT and not (
            motor.trouble is Reason.CONTACT and motor.followed < RING
        ):
            name = self._world.met or "something"
            self._note(
                EventKind.CONTACT, f"{self.model.motor_names[latch]} blocked by {name}", latch
            )
        motor.trouble = reason

    def _count_rings(self, latch: int, target: int) -> None:
        """Note rings that a rotor has lost or regained against its field."""
        motor = self.motors[latch]
        behind = motor.field - target
        if behind % RING or behind // RING == motor.ring:
            return
        steps = RING * motor.ring - behind
        motor.ring = behind // RING
        reason = motor.trouble
        for i in range(len(self.events) - 1, -1, -1):
            event = self.events[i]
            if motor.losing is None or event.number < motor.losing:
                break
            same = event.reason is reason and (event.steps < 0) == (steps < 0)
            if event.number == motor.losing and same:
                steps += event.steps
                text = _slip_text(self.model.motor_names[latch], steps, reason)
                self.events[i] = replace(event, steps=steps, text=text)
                return
        motor.losing = self.event_count
        self._note(
            EventKind.SLIP,
            _slip_text(self.model.motor_names[latch], steps, reason),
            latch,
            steps,
            reason,
        )

    def _tell_news(self) -> None:
        """Turn what the bench has to tell into events."""
        for kind, text in self.bench.news:
            self._note(kind, text)
        self.bench.news.clear()

    def _note(
        self,
        kind: EventKind,
        text: str,
        motor: int | None = None,
        steps: int = 0,
        reason: Reason | None = None,
    ) -> None:
        """Remember an event; what goes on and on is one."""
        if kind in (EventKind.CONTACT, EventKind.PUSHED) and self.events:
            last = self.events[-1]
            if (last.kind, last.motor, last.text) == (kind, motor, text):
                return
        self.events.append(ArmEvent(self.event_count, self._time, kind, motor, steps, reason, text))
        self.event_count += 1
        if len(self.events) > self.settings.events_kept:
            del self.events[0]

    # Looking at it

    def state(self) -> ArmState:
        """A snapshot for display."""
        angles = self.drive.angles(self._rotors)
        grip = self._world.grip
        six = self.motors[:6]
        return ArmState(
            _six(motor.rotor for motor in six),
            _six(motor.field for motor in six),
            _six(motor.rotor - motor.field for motor in six),
            tuple(motor.coils for motor in self.motors),
            any(motor.energised for motor in six),
            angles,
            pose_of(self.model, angles, self._world.body.opening),
            grip.force,
            grip.switch_closed,
            grip.held,
        )

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
        if any(motor.energised for motor in self.motors[:6]):
            raise MotorsOn("the motors are on: @RESET turns them off")
        rotors = list(self.drive.rotors(angles, cable))
        stop = beyond_any_stop(self.drive, rotors)
        if stop is not None:
            raise ValueError(f"that is beyond a stop: {stop}")
        name = self._world.place(self._rotors, rotors)
        if name is not None:
            raise InTheWay(f"{name} is in the way")
        self._rotors[:] = rotors
        for latch, rotor in enumerate(rotors):
            self.motors[latch].rotor = rotor
            self.motors[latch].release()
        self._tell_news()


def _six(numbers: Iterable[int]) -> Six:
    """Six numbers as a tuple."""
    base, shoulder, elbow, left, right, hand = numbers
    return base, shoulder, elbow, left, right, hand


def _slip_text(motor: str, steps: int, reason: Reason) -> str:
    """How a loss reads."""
    why = {
        Reason.RATE: "too fast",
        Reason.LOAD: "too much load",
        Reason.STOP: "at its stop",
        Reason.CONTACT: "blocked",
    }[reason]
    return f"{motor} slipped {abs(steps)} steps: {why}"
