"""A turntable: a round plate let into the table, turned by a stepper motor.

Its four coils are the auxiliary latch's four bits, or a board between the two makes a half-step of
each pulse, which way a second bit says. The motor is one of the base's kind that turns nothing
heavy; it loses steps as any other.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import ClassVar

from trs80arm.arm.cell.device import Device, Site, rises
from trs80arm.arm.contact.bodies import Body
from trs80arm.arm.contact.clock import T_STATES_PER_SECOND
from trs80arm.arm.contact.driven import EASE
from trs80arm.arm.contact.scene import Scene
from trs80arm.arm.contact.table import TABLE, Plate
from trs80arm.arm.event_log import EventLog
from trs80arm.arm.events import EventKind, Happening, Reason
from trs80arm.arm.forces import Strength
from trs80arm.arm.model import Motor
from trs80arm.arm.motors import PHASES, RING, ROWS, StepperMotor
from trs80arm.arm.settings import ArmSettings

LATCH = 6
"""Number of the auxiliary latch's motor in events."""
TURNED_FAST = 0.01
"""Half-steps by which the plate may be behind its motor and stand."""


@dataclass
class Turntable(Device):
    """A turntable.

    Attributes:
        name: of it.
        plate: that turns.
        steps: half-steps per turn of the plate.
        pulse: bit on whose rising edge the motor makes a half-step; None where the latch's four
            bits are the motor's coils.
        direction: bit that turns it clockwise while it is 1.
        motor: its rotor's half-steps turn the plate counter-clockwise.
        turned: half-steps that the plate has been turned; it follows the motor smoothly.
    """

    kind: ClassVar[str] = "turntable"

    name: str
    plate: Plate
    steps: int = 96
    pulse: int | None = None
    direction: int | None = None
    motor: StepperMotor = field(default_factory=StepperMotor)
    turned: float = 0.0
    period: int = 0
    """T-states that the motor needs for a half-step."""
    lag: int = 4
    """Half-steps by which its rotor may trail."""

    def __post_init__(self) -> None:
        self.suit(ArmSettings())
        if self.pulse is not None:
            # The board holds the motor from the moment that it is switched on.
            self.motor.coils = PHASES[0]
            self.motor.turn_field(0)

    @property
    def rotor(self) -> int:
        """Half-steps that the motor has turned, positive counter-clockwise."""
        return self.motor.rotor

    @property
    def wires(self) -> Mapping[str, int]:
        """The bits of its coils, or of pulse and direction."""
        if self.pulse is None:
            return {f"coil {bit}": bit for bit in range(4)}
        if self.direction is None:
            return {"pulse": self.pulse}
        return {"pulse": self.pulse, "direction": self.direction}

    @property
    def state(self) -> str:
        """How far it has been turned."""
        return f"{360 * self.rotor / self.steps:.1f} deg"

    @property
    def possible(self) -> bool:
        """Whether it can be."""
        return super().possible and self.steps > 0

    # The latch

    def connect(self, nibble: int) -> None:
        """Hang on a latch: coils that carry current pull the rotor."""
        if self.pulse is not None:
            return
        motor = self.motor
        motor.release()
        motor.coils = nibble
        if ROWS[nibble] >= 0:
            motor.turn_field(ROWS[nibble])
            motor.rotor = motor.target

    def write(self, time: int, before: int, nibble: int, site: Site, log: EventLog) -> None:
        """Other coils carry current, or a half-step is asked for."""
        if self.pulse is None:
            self._switch(time, nibble, log)
        elif rises(before, nibble, self.pulse):
            back = self.direction is not None and nibble >> self.direction & 1
            self._switch(time, PHASES[(self.motor.row + (-1 if back else 1)) % RING], log)

    def _switch(self, time: int, coils: int, log: EventLog) -> None:
        """Have coils carry current: the rotor follows their field if it can."""
        motor, row = self.motor, ROWS[coils]
        motor.coils = coils
        if row < 0:
            motor.release()
            return
        turn = motor.turn_field(row)
        if not motor.keep_pace(time, turn, self.period, self.lag):
            motor.trouble = Reason.RATE
        target = motor.target
        motor.rotor = target
        if motor.anchor is not None:
            motor.followed = 0
        else:
            motor.follow(1)
        behind = motor.field - target
        if behind % RING == 0 and behind // RING != motor.ring:
            self._slipped(time, behind, log)

    def _slipped(self, time: int, behind: int, log: EventLog) -> None:
        """Note rings that the rotor has lost or regained against its field."""
        motor = self.motor
        steps = RING * motor.ring - behind
        motor.ring = behind // RING
        way = "back" if steps < 0 else "on"
        happening = Happening(EventKind.SLIP, self.name, way, motor.trouble)
        goes_on = motor.losing is not None
        motor.losing = log.tell(time, happening, LATCH, 0.0, steps, goes_on=goes_on)

    # The bench

    def suit(self, settings: ArmSettings) -> None:
        """Its motor is of the kind that turns the arm's base."""
        curve = Strength.of(settings.arm_model).curves[Motor.BASE]
        self.period = curve.period(0.0, settings.speed_margin)
        self.lag = settings.pull_out_lag

    def lay(self, scene: Scene) -> None:
        """Let the plate into the table; it stands."""
        self.plate.spin = 0.0
        scene.plates.append(self.plate)

    def begin(self) -> None:
        """The plate stands where its motor is."""
        self.turned = float(self.rotor)

    def carries(self, body: Body) -> bool:
        """Whether a body stands on the plate."""
        return TABLE in body.touching and self._under(body)

    # Time

    @property
    def stands(self) -> bool:
        """Whether the plate is where its motor is."""
        return self.rotor == self.turned

    def drive(self, scene: Scene) -> None:
        """Turn the plate as far as its motor has since the last tick."""
        # The motor jerks from half-step to half-step; the plate follows smoothly.
        seconds = (scene.due - scene.time) / T_STATES_PER_SECOND
        behind = (self.rotor - self.turned) * (math.tau / self.steps)
        spin = behind / (seconds + EASE)
        self.turned += spin * seconds * (self.steps / math.tau)
        if abs(self.rotor - self.turned) < TURNED_FAST:
            self.turned, spin = float(self.rotor), 0.0
        if spin != self.plate.spin:
            self.plate.spin = spin
            for body in list(scene.bodies.values()):
                if spin and body.asleep and body.carried is None and self._under(body):
                    scene.wake(body.name)

    def _under(self, body: Body) -> bool:
        """Whether anything of a body may be above the plate."""
        x, y, _ = body.place
        reach = self.plate.radius + body.shape.radius
        return (x - self.plate.x) ** 2 + (y - self.plate.y) ** 2 <= reach**2
