"""A pulse generator for the arm's latches, as on a designer's test bench.

It steps motors through Figure 8 without computer or language, so that experiments and figures can
measure the arm alone. Its even spreading of steps is that of Figure 10.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import zip_longest

import numpy as np
import numpy.typing as npt

from trs80arm.arm.contact.clock import T_STATES_PER_SECOND
from trs80arm.arm.geometry import JointAngles
from trs80arm.arm.minimover import MiniMover
from trs80arm.arm.model import Motor
from trs80arm.arm.motors import PHASES

SWITCH_CLOSED = (1, 0)
"""Stop condition for a burst: the grip switch closes."""


_PHASES = np.array(PHASES)


def _spread(count: int, longest: int) -> npt.NDArray[np.int64]:
    """At which of the steps of the motor that has most another one steps, from 1 on."""
    steps = np.arange(longest + 1)
    return np.flatnonzero(np.diff((2 * count * steps + longest) // (2 * longest))) + 1


def delay_period(delay: int) -> int:
    """T-states per step at an ARMBASIC delay: 1.2 + 0.03 D milliseconds (article, @STEP)."""
    return round((1.2 + 0.03 * delay) * T_STATES_PER_SECOND / 1000)


class PulseGenerator:
    """Steps the motors of an arm.

    Attributes:
        arm: the arm.
        time: T-states.
        counts: half-steps commanded to each motor so far, compensation not included; these are
            what the position registers of ARMBASIC would hold.
    """

    def __init__(self, arm: MiniMover) -> None:
        self.arm = arm
        self.time = 0
        self.counts = [0] * 6
        self._rows = [0] * 7

    def step(
        self,
        counts: Sequence[int],
        period: int,
        stop: tuple[int, int] | None = None,
        compensate: bool = True,
    ) -> int:
        """Move motors together, all beginning and ending at once.

        Args:
            counts: half-steps for the motors, from the base on; missing ones are 0.
            period: T-states from step to step of the motor that has most.
            stop: as for `MiniMover.apply`.
            compensate: whether the hand takes back what each step of the elbow pays out, in an
                arm whose language does that.

        Returns:
            Steps done of the motor that has most.
        """
        wanted = [count for count, _ in zip_longest(counts, range(6), fillvalue=0)]
        longest = max(abs(count) for count in wanted)
        if not longest:
            return 0
        model = self.arm.model
        back = model.hand_per_elbow if compensate else 0
        trains = []
        for motor, count in enumerate(wanted):
            if not count:
                continue
            when, sign = _spread(abs(count), longest), 1 if count > 0 else -1
            trains.append((when, motor, sign, 2 * motor))
            if motor == Motor.ELBOW and back:
                # What makes up for a step of the elbow follows it at once.
                trains.append((when, Motor.HAND, back * sign, 2 * motor + 1))
        places = np.concatenate([when * (2 * len(wanted)) + slot for when, _, _, slot in trains])
        order = np.argsort(places)
        places = places[order]
        ticks = places // (2 * len(wanted))
        latches = np.repeat([latch for _, latch, _, _ in trains], [len(each[0]) for each in trains])
        latches = latches[order]
        signs = np.repeat([sign for _, _, sign, _ in trains], [len(each[0]) for each in trains])
        signs = signs[order]
        rows = np.empty(len(order), dtype=np.int64)
        for latch in {latch for _, latch, _, _ in trains}:
            mine = latches == latch
            rows[mine] = self._rows[latch] + np.cumsum(signs[mine])
        done = self.arm.apply(self.time + ticks * period, latches, _PHASES[rows % 8], stop)
        for _, latch, sign, slot in trains:
            steps = int(np.count_nonzero(places[:done] % (2 * len(wanted)) == slot))
            self._rows[latch] += sign * steps
            if not slot % 2:
                self.counts[latch] += sign * steps
        last = int(ticks[done - 1]) if done else 0
        self.time += last * period
        return last

    def turn(self, motor: int, count: int, period: int) -> int:
        """Step one motor, with no compensation; half-steps done."""
        return self.step([0] * motor + [count], period, compensate=False)

    def close(self, period: int, squeeze: int = 0) -> int:
        """Close the hand until its switch closes, then by `squeeze` more; half-steps closed."""
        done = 0
        if not self.arm.grip.switch_closed:
            done = self.step([0, 0, 0, 0, 0, -2100], period, SWITCH_CLOSED)
        if squeeze:
            done += self.step([0, 0, 0, 0, 0, -squeeze], delay_period(100))
        return done

    def wait(self, seconds: float) -> None:
        """Let time pass in which nothing is stepped: what falls comes to rest."""
        self.time += round(seconds * T_STATES_PER_SECOND)
        self.arm.advance(self.time)

    def align(self) -> None:
        """Begin at the rows of Figure 8 at which the rotors stand, so that none is jerked."""
        for motor, rotor in enumerate(self.arm.rotors):
            self._rows[motor] = rotor

    def off(self) -> None:
        """All coils without current, and the counts at zero: what @RESET does."""
        self.time += 1
        self.arm.apply([self.time] * 6, range(6), [0] * 6)
        self.counts = [0] * 6

    def go(self, angles: JointAngles, period: int) -> None:
        """Step to joint angles (radians) from where the arm really is."""
        drive, rotors = self.arm.drive, self.arm.rotors
        target = drive.rotors(angles, drive.cable(rotors))
        counts = [there - here for there, here in zip(target, rotors, strict=True)]
        self.step(counts[:5], period)
