"""A stepper motor of the arm: four coils, a field, and a rotor that follows it or not.

The card's latch decides which coils carry current (article, Figures 7 and 8). Field and rotor
are two things: the rotor goes to the nearest equilibrium of the field, so whatever it loses it
loses in whole rings of eight half-steps. `MiniMover` asks a motor where a pattern pulls its
rotor, and tells it how far the rotor got.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from trs80arm.arm.contact.clock import T_STATES_PER_SECOND
from trs80arm.arm.events import Reason
from trs80arm.arm.forces import NEVER

__all__ = ["PHASES", "RING", "ROWS", "StepperMotor"]

PHASES = (0b0101, 0b0100, 0b0110, 0b0010, 0b1010, 0b1000, 0b1001, 0b0001)
"""Figure 8 from top to bottom, phi1 the high bit; downwards is clockwise, a positive count."""

RING = 8
"""Half-steps after which the pattern, and the rotor's equilibria, repeat."""

HALF_STEPS_PER_TURN = 96
"""Of the motor's own shaft: 48 full steps (article, Stepping Motor Control)."""

AT_REST = T_STATES_PER_SECOND // 10
"""T-states without a pulse after which a motor stands, however slowly it was stepped."""


def _row(nibble: int) -> int:
    """Row of Figure 8 whose field `nibble` makes, or -1 where the coils make none."""
    # The two coils of a pair share a magnetic path and oppose each other (Figure 7).
    x = (nibble >> 3 & 1) - (nibble >> 2 & 1)
    y = (nibble >> 1 & 1) - (nibble & 1)
    for row, pattern in enumerate(PHASES):
        if (x, y) == (
            (pattern >> 3 & 1) - (pattern >> 2 & 1),
            (pattern >> 1 & 1) - (pattern & 1),
        ):
            return row
    return -1


ROWS = tuple(_row(nibble) for nibble in range(16))
"""Row of Figure 8 for each of the sixteen coil patterns; -1 where there is no field."""


@dataclass(slots=True)
class StepperMotor:
    """Coils, field and rotor of one motor.

    Attributes:
        coils: the latch's nibble, phi1 its high bit.
        row: row of Figure 8 that the field points to, -1 without a field.
        field: unwrapped position of the field in half-steps.
        rotor: position of the rotor in half-steps.
        ring: rings that the equilibrium holding the rotor lies behind the field; the rotor has
            slipped by -8 times this.
        anchor: place around which a rotor that has dropped out of step quivers; None in step.
        trouble: why it last was held back or dropped out of step.
        followed: writes that the rotor has followed since then, up to a ring.
        losing: number of the event that says how many steps it is losing, or None.
        moved: time of the last write that turned the field, T-states.
        done: time at which the rotor has caught up with all writes so far, T-states.
        pulses: times of the last half-steps asked of it, a ring of them and one, T-states.
        way: the direction of the last one, 1 or -1; 0 before the first.
    """

    coils: int = 0
    row: int = -1
    field: int = 0
    rotor: int = 0
    ring: int = 0
    anchor: int | None = None
    trouble: Reason = Reason.RATE
    followed: int = RING
    losing: int | None = None
    moved: int = -NEVER
    done: int = -NEVER
    pulses: tuple[int, ...] = (-NEVER,) * (RING + 1)
    way: int = 0

    @property
    def energised(self) -> bool:
        """Whether any coil carries current."""
        return self.coils != 0

    @property
    def target(self) -> int:
        """Where the field pulls the rotor: its nearest equilibrium, or where it is.

        Against a field that points exactly the other way the rotor has no torque and stays.
        """
        if self.row < 0:
            return self.rotor
        if self.anchor is not None:
            return self.anchor + (self.row - self.anchor + 4) % RING - 4
        pull = (self.row - self.rotor) % RING
        if pull == 4:
            return self.rotor
        return self.rotor + (pull if pull < 4 else pull - RING)

    @property
    def settled(self) -> bool:
        """Whether the rotor stands in step, where the field points, or there is no field."""
        return self.row < 0 or (self.anchor is None and (self.rotor - self.row) % RING == 0)

    def release(self) -> None:
        """No field: nothing pulls the rotor, and slip is counted anew from where it stands."""
        self.row = -1
        self.field = self.rotor
        self.ring = 0
        self.anchor = None
        self.follow(RING)

    def follow(self, writes: int) -> None:
        """The rotor has followed some writes; after a ring of them its trouble is over."""
        self.followed += writes
        if self.followed >= RING:
            self.followed, self.losing = RING, None

    def turn_field(self, row: int) -> int:
        """Let the field point to a row of Figure 8.

        Returns:
            Half-steps that it turned, -3 to 3. A reversal (4 rows) has no direction and
            counts 0; so does the first field after none, which the rotor jumps to.
        """
        if self.row < 0:
            pull = (row - self.rotor) % RING
            self.field = self.rotor + (0 if pull == 4 else (pull if pull < 4 else pull - RING))
            self.row = row
            return self.field - self.rotor
        turn = (row - self.field) % RING
        self.row = row
        if turn == 4:
            return 0
        turn = turn if turn < 4 else turn - RING
        self.field += turn
        return turn

    def asked(self, times: Iterable[int], way: int) -> None:
        """Half-steps were asked of it.

        Args:
            times: of the last of them, T-states; more than a ring of them and one need not be.
            way: the direction of the last.
        """
        self.pulses = (*self.pulses, *times)[-RING - 1 :]
        self.way = way

    def asked_once(self, time: int, way: int) -> None:
        """One more half-step was asked of it.

        Args:
            time: of it, T-states.
            way: its direction.
        """
        self.pulses = (*self.pulses[-RING:], time)
        self.way = way

    @property
    def pace(self) -> float:
        """Half-steps per second that were asked of it over the last ring of them."""
        return RING * T_STATES_PER_SECOND / max(1, self.pulses[-1] - self.pulses[0])

    def rate(self, time: int) -> float:
        """Half-steps per second at which it turns, signed as they count; 0 where it stands.

        It stands when for a tenth of a second, or twice as long as one pulse came after the other
        over the last ring of them, there was none.

        Args:
            time: T-state, not before the last write.
        """
        idle = time - self.pulses[-1]
        if self.row < 0 or idle > AT_REST:
            return 0.0
        often = (self.pulses[-1] - self.pulses[0]) / RING
        if idle > 2 * often:
            return 0.0
        return self.way * T_STATES_PER_SECOND / max(often, idle, 1.0)

    def keep_pace(self, time: int, turn: int, period: int, lag: int) -> bool:
        """Whether the rotor is in step after a write that turned the field.

        Args:
            time: of the write, T-states.
            turn: half-steps that the field turned.
            period: T-states that the rotor needs for a half-step under its present load.
            lag: half-steps that it may be behind.
        """
        work = abs(turn) * period
        if self.anchor is not None:
            if time - self.moved < work:
                self.moved = time
                return False
            self.anchor = None
            self.done = time
        self.moved = time
        self.done = max(self.done, time) + work
        if self.done - time > lag * period:
            self.anchor = self.rotor
            return False
        return True
