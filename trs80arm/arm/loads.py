"""Why it slips, or does not: what each motor bears and what it has, cables, and the hand's hold.

One set of readings, taken from the forces that move and stop the arm (`forces.py`) and from
nothing else, for whoever shows them: panel, line mode, traces, `trs80arm run --json`.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, tau

from trs80arm.arm.forces import Curve, Strength
from trs80arm.arm.model import ArmModel, Drive, Motor
from trs80arm.arm.motors import HALF_STEPS_PER_TURN, StepperMotor

NEAR = 0.85
"""Share of what a motor has, or of what a grip holds, from which on it is near to giving way."""
MOST_PER_CENT = 999
"""What a share is said to be when it is even more."""


@dataclass(frozen=True, slots=True)
class MotorLoad:
    """What a motor bears, and what it has to bear it with.

    Attributes:
        name: of the motor, as people call it.
        motor: what it turns.
        torque: ounce-inches at the joint that pull its angle down, ounces that press the fingers
            together; negative the other way. On a base that turns: the drag of its load.
        rotor_torque: the same at the motor's shaft, ounce-inches, its gearing taken as free of
            friction.
        cable: ounces by which its cable is pulled, beyond what it is tensioned with.
        rate: half-steps per second, signed as they count; 0 where it stands.
        against: how much of the torque is against the way it turns; standing, all of it.
        has: torque that it has for that: at its rate, or standing, or, without current, by the
            friction of its gears.
        used: the share of what it has that is used, where 1 is as much as it can: against and rate
            together, for a motor has the less torque the faster it turns (`Curve.used`).
        peak: the greatest share at any half-step since `@RESET`, whole per cent, rounded up.
        energised: whether its current is on.
    """

    name: str
    motor: Motor
    torque: float
    rotor_torque: float
    cable: float
    rate: float
    against: float
    has: float
    used: float
    peak: int
    energised: bool

    @property
    def margin(self) -> float:
        """The share of what it has that is left; negative where it trails and may slip."""
        return 1.0 - self.used

    @property
    def left(self) -> float:
        """Torque that it still has; negative where it has less than it bears."""
        return self.has - self.against

    @property
    def per_cent(self) -> int:
        """`used` in whole per cent, rounded up as `peak` is."""
        return per_cent(self.used)

    @property
    def grips(self) -> bool:
        """Whether it is the hand's."""
        return self.motor is Motor.HAND

    @property
    def unit(self) -> str:
        """Of the torques at the joint."""
        return "oz" if self.grips else "oz in"


@dataclass(frozen=True, slots=True)
class GripLoad:
    """The hand's hold on what is between its fingers, by friction.

    Attributes:
        force: of the grip, pounds.
        weight: of all that both fingers press on, and of what rides on that, ounces; 0 where there
            is nothing.
        friction: coefficient between the pads and the smoothest of it.
    """

    force: float
    weight: float
    friction: float

    @property
    def needed(self) -> float:
        """Pounds of force that holding it takes: two pads, each by its friction."""
        return self.weight / (32 * self.friction) if self.weight else 0.0

    @property
    def carries(self) -> float:
        """Ounces that the force there is holds."""
        return 32 * self.friction * self.force

    @property
    def used(self) -> float | None:
        """Share of the force that holding needs, where more than 1 falls; None with nothing."""
        if not self.weight:
            return None
        return self.needed / self.force if self.force else float("inf")


@dataclass(frozen=True, slots=True)
class Loads:
    """What motors and hand bear at one moment.

    Attributes:
        motors: by latch, J1 to J6.
        grip: the hand's hold.
    """

    motors: tuple[MotorLoad, ...]
    grip: GripLoad

    @property
    def hardest(self) -> MotorLoad:
        """The motor that uses most of what it has."""
        return max(self.motors, key=lambda load: load.used)

    def of(self, motor: Motor) -> MotorLoad:
        """What the motor that turns something bears."""
        return next(load for load in self.motors if load.motor is motor)


def unloaded(model: ArmModel) -> Loads:
    """An arm that nothing weighs on, its motors off: what is read before anything is."""
    strength = Strength.of(model)
    motors = (
        motor_load(
            StepperMotor(),
            drive,
            strength.curves[drive.turns],
            torque=0.0,
            against=0.0,
            rate=0.0,
            margin=1.0,
            peak=0,
        )
        for drive in model.drives
    )
    return Loads(tuple(motors), GripLoad(0.0, 0.0, 1.0))


def motor_load(
    motor: StepperMotor,
    drive: Drive,
    curve: Curve,
    *,
    torque: float,
    against: float,
    rate: float,
    margin: float,
    peak: int,
) -> MotorLoad:
    """The readings of a motor.

    Args:
        motor: itself.
        drive: its gearing and cable.
        curve: what it can do.
        torque: as `MotorLoad` has it.
        against: the same.
        rate: the same.
        margin: multiple of its rate at which it drops out.
        peak: as `MotorLoad` has it.
    """
    if rate:
        has, used = curve.has(rate / margin), curve.used(against, rate / margin)
    else:
        has = curve.holds if motor.energised else curve.friction
        used = against / has
    per_radian = HALF_STEPS_PER_TURN / tau
    return MotorLoad(
        drive.turns.name.lower().replace("_", " "),
        drive.turns,
        torque,
        torque * per_radian / drive.steps,
        abs(torque) / drive.pulley,
        rate,
        against,
        has,
        used,
        peak,
        motor.energised,
    )


def per_cent(share: float) -> int:
    """A share in whole per cent: rounded up, so that 100 is not reached before it is too much."""
    return min(MOST_PER_CENT, ceil(100 * share - 1e-6)) if share < MOST_PER_CENT else MOST_PER_CENT
