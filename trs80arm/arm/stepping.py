"""A pulse generator for the arm's latches, as on a designer's test bench.

It steps motors through Figure 8 without computer or language, so that experiments and figures can
measure the arm alone. Its even spreading of steps is that of Figure 10.
"""

from __future__ import annotations

from collections.abc import Sequence

from trs80arm.arm.contact.clock import T_STATES_PER_SECOND
from trs80arm.arm.geometry import JointAngles
from trs80arm.arm.minimover import MiniMover
from trs80arm.arm.model import Motor
from trs80arm.arm.motors import PHASES
from trs80arm.pulses import Pulses, Train

SWITCH_CLOSED = (1, 0)
"""Stop condition for a burst: the grip switch closes."""


def _train(motor: int, count: int, longest: int) -> Train:
    """The steps of a motor, spread evenly over those of the one that has most, from tick 1 on."""
    steps, sign = abs(count), 1 if count > 0 else -1
    under = 2 * steps
    # Step i comes at the first tick by which i + 1/2 of its steps would have been made.
    return Train(motor, sign, 0, steps, longest + under - 1, 2 * longest, under)


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
            stop: as for `MiniMover.follow`.
            compensate: whether the hand takes back what each step of the elbow pays out, in an
                arm whose language does that.

        Returns:
            Steps done of the motor that has most.
        """
        asked = [*counts, *[0] * (6 - len(counts))]
        model = self.arm.model
        back = model.hand_per_elbow if compensate else 0
        # What makes up for the elbow comes with its steps.
        wanted = list(asked)
        wanted[Motor.HAND] += back * asked[Motor.ELBOW]
        longest = max(abs(count) for count in wanted)
        if not longest:
            return 0
        trains = tuple(_train(motor, count, longest) for motor, count in enumerate(wanted) if count)
        burst = Pulses(self.time, period, 1, trains, tuple(self._rows), PHASES)
        done = self.arm.follow(burst, stop)
        if not done:
            return 0
        if done < len(burst):
            burst = burst.split(done)[0]
        for train in burst.trains:
            steps = train.direction * len(train)
            self._rows[train.motor] += steps
            if train.motor < 6:
                self.counts[train.motor] += steps
                if train.motor == Motor.ELBOW:
                    self.counts[Motor.HAND] -= back * steps
        last = (burst.ends - self.time) // period
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
