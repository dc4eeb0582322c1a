"""The MiniMover 5: six stepper motors, their cables, the joints and hand that they move.

The arm hangs on the card's cable. All that comes down the cable are writes to seven latches,
with times; all that goes up are four input bits. Nothing here knows of registers or programs:
what the arm was told and where it is are two things.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from trs80arm.arm.bench import Bench
from trs80arm.arm.body import Body
from trs80arm.arm.events import MOTOR_NAMES, ArmEvent, EventKind, Reason
from trs80arm.arm.geometry import (
    HAND_RANGE,
    HAND_STEPS,
    START_POSE,
    CableDrive,
    JointAngles,
    Motor,
    Pose,
    inverse,
    pose_of,
)
from trs80arm.arm.grip import Grip
from trs80arm.arm.limits import beyond_stop, load_fraction
from trs80arm.arm.motors import NEVER, ROWS, StepperMotor, shortest_period
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.world import World

Ints = Sequence[int] | npt.NDArray[np.int64]

ELBOW, HAND, AUXILIARY = int(Motor.ELBOW), int(Motor.HAND), 6


class MotorsOn(Exception):  # noqa: N818 (says what is, like OutOfReach)
    """The arm cannot be moved by hand while a motor holds it."""


class InTheWay(Exception):  # noqa: N818 (says what is, like OutOfReach)
    """Something on the bench is where the arm was to be moved by hand."""


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

    rotors: tuple[int, ...]
    fields: tuple[int, ...]
    slipped: tuple[int, ...]
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
        bench: what the arm works on.
        drive: the cables; it knows the pose in which the arm was switched on.
        motors: six, and the turntable's as the seventh.
        events: what happened, the latest `settings.events_kept` of it.
        event_count: events so far, those dropped from the list included.
    """

    def __init__(self, settings: ArmSettings | None = None, bench: Bench | None = None) -> None:
        self.settings = settings or ArmSettings()
        self.motors = [StepperMotor() for _ in range(7)]
        self.events: list[ArmEvent] = []
        self.event_count = 0
        self._time = 0
        self._losing: list[int | None] = [None] * 7
        self._touching: list[bool] = [False] * 7
        self._set_up(Bench.standard() if bench is None else bench)

    def _set_up(self, bench: Bench) -> None:
        """Stand at a bench, in the pose in which it has the arm switched on."""
        start = bench.start or START_POSE
        self.bench = bench
        self.drive = CableDrive(
            inverse(start.x, start.y, start.z, start.pitch, start.roll),
            round(start.opening * HAND_STEPS),
        )
        self._rotors = [0] * 6
        self._world = World(bench, self.settings, self.drive)
        self._world.start()

    def set_bench(self, bench: Bench) -> None:
        """Work on another bench, beginning in its starting pose; coils stay as they are."""
        self._set_up(bench)
        for latch, motor in enumerate(self.motors):
            motor.rotor = 0
            motor.release()
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
        for i in range(count):
            time = int(times[i])
            self._write(time, int(latches[i]), int(nibbles[i]))
            if (
                stop is not None
                and (i + 1 == count or int(times[i + 1]) != time)
                and self.inputs(time) & stop[0] == stop[1]
            ):
                return i + 1
        return count

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
        if nibble == motor.coils and row == motor.row:
            return
        self._time = max(self._time, time)
        motor.coils = nibble
        if row < 0:
            motor.release()
            self._losing[latch] = None
            self._touching[latch] = False
            return
        turn = motor.turn_field(row)
        period, loaded = self._period(latch, turn)
        if not motor.keep_pace(time, turn, period, self.settings.pull_out_lag):
            motor.dropped = Reason.LOAD if loaded else Reason.RATE
        self._follow(latch)
        if self._rotors_strained:
            self._follow_others(latch)

    @property
    def _rotors_strained(self) -> bool:
        return any(motor.strained for motor in self.motors)

    def _period(self, motor: int, turn: int) -> tuple[int, bool]:
        """T-states per half-step under the present load, and whether load is what counts."""
        margin = self.settings.speed_margin
        free = shortest_period(motor, 0.0, margin)
        if motor == AUXILIARY or turn == 0:
            return free, False
        load = load_fraction(
            motor,
            turn,
            self.drive.angles(self._rotors),
            self._world.grip.weight,
            self._world.grip.force if motor == HAND else 0.0,
        )
        if load <= 0.0:
            return free, False
        period = shortest_period(motor, load, margin)
        return min(period, NEVER), True

    def _follow(self, latch: int) -> None:
        """Let a rotor go where its field pulls it, as far as it can."""
        motor = self.motors[latch]
        reason: Reason | None = motor.dropped if motor.anchor is not None else None
        target = motor.target
        while motor.rotor != target:
            step = 1 if target > motor.rotor else -1
            blocked = self._step(latch, step)
            if blocked is not None:
                reason = blocked
                break
            motor.rotor += step
        self._count_rings(latch, target, reason)
        self._tell_news()

    def _follow_others(self, latch: int) -> None:
        """Rotors that were held back try again after another one has moved."""
        for other, motor in enumerate(self.motors):
            if other != latch and motor.strained:
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
        give = excess if motor.row < 0 else -(-excess // 8) * 8
        motor.rotor += give
        self._rotors[HAND] += give
        self._world.regrip(self._rotors)
        if motor.row < 0:
            motor.field = motor.rotor
        else:
            self._count_rings(HAND, motor.rotor, Reason.LOAD)

    def _count_rings(self, latch: int, target: int, reason: Reason | None) -> None:
        """Note rings that a rotor has lost or regained against its field."""
        motor = self.motors[latch]
        if reason is None:
            self._losing[latch] = None
            self._touching[latch] = False
        elif reason is Reason.CONTACT and not self._touching[latch]:
            self._touching[latch] = True
            name = self._world.met or "something"
            self._note(EventKind.CONTACT, f"{MOTOR_NAMES[latch]} blocked by {name}", latch)
        behind = motor.field - target
        if behind % 8 or behind // 8 == motor.ring:
            return
        lost = 8 * (motor.ring - behind // 8)
        motor.ring = behind // 8
        reason = reason or Reason.LOAD
        number = self._losing[latch]
        for i in range(len(self.events) - 1, -1, -1):
            event = self.events[i]
            if number is None or event.number < number:
                break
            if event.number == number and event.reason is reason:
                steps = event.steps + lost
                self.events[i] = replace(event, steps=steps, text=_slip_text(latch, steps, reason))
                return
        self._losing[latch] = self.event_count
        self._note(EventKind.SLIP, _slip_text(latch, lost, reason), latch, lost, reason)

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
        """Remember an event."""
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
            tuple(motor.rotor for motor in six),
            tuple(motor.field for motor in six),
            tuple(motor.rotor - motor.field for motor in six),
            tuple(motor.coils for motor in self.motors),
            any(motor.energised for motor in six),
            angles,
            pose_of(angles, self._world.body.opening),
            grip.force,
            grip.switch_closed,
            grip.held,
        )

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
        elif joint in ("base", "shoulder", "elbow", "pitch", "roll"):
            angles = replace(angles, **{joint: math.radians(value)})
        else:
            raise ValueError(f"no joint {joint}: base, shoulder, elbow, pitch, roll or hand")
        self._place(angles, cable)

    def move_to(self, pose: Pose) -> None:
        """Take the hand to a pose, by hand.

        Raises:
            MotorsOn: while any motor carries current.
            OutOfReach: if Table 4's subroutine would say so.
            InTheWay: if something on the bench is there.
            ValueError: if a joint or the hand does not go that far.
        """
        angles = inverse(pose.x, pose.y, pose.z, pose.pitch, pose.roll)
        self._place(angles, self._cable_for(pose.opening))

    def _cable_for(self, opening: float) -> int:
        if not 0 <= opening <= HAND_RANGE:
            raise ValueError(f"the hand opens from 0 to {HAND_RANGE:g} in, not {opening:g}")
        return round(opening * HAND_STEPS)

    def _place(self, angles: JointAngles, cable: int) -> None:
        """Put rotors where the operator's hands want the joints."""
        if any(motor.energised for motor in self.motors[:6]):
            raise MotorsOn("the motors are on: @RESET turns them off")
        rotors = list(self.drive.rotors(angles, cable))
        for motor in range(5):
            for step in (-1, 1):
                stop = beyond_stop(motor, step, self.drive, rotors, slack=1)
                if stop:
                    raise ValueError(f"the {MOTOR_NAMES[motor]} is beyond its stop: {stop}")
        name = self._world.place(self._rotors, rotors)
        if name is not None:
            raise InTheWay(f"{name} is in the way")
        self._rotors[:] = rotors
        for latch, rotor in enumerate(rotors):
            self.motors[latch].rotor = rotor
            self.motors[latch].release()
        self._tell_news()


def _slip_text(latch: int, steps: int, reason: Reason) -> str:
    """How a loss reads."""
    why = {
        Reason.RATE: "too fast",
        Reason.LOAD: "too much load",
        Reason.STOP: "at its stop",
        Reason.CONTACT: "blocked",
    }[reason]
    return f"{MOTOR_NAMES[latch]} slipped {abs(steps)} steps: {why}"
