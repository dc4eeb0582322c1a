"""The second plug of the card: a real arm does what the model does, leg by leg.

It is clipped on to the latches beside the model, which is its twin. Every pattern that anybody
writes is seen here, whoever wrote it, and becomes orders to the arm on the wire. The twin goes
first, by less than a second: a motion in which it slips, or that is faster or farther than it may
be, is not sent. Nothing here sends anything itself; `Courier` does.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable

from trs80arm.arm.events import EventKind
from trs80arm.machine.card import MOTORS
from trs80arm.machine.driver import Mode
from trs80arm.pulses import Series
from trs80arm.rig import Input, Rig
from trs80arm.serial.far_arm import Compare, Grip, Move, Order, Zero
from trs80arm.serial.gathering import Gathering, Leg
from trs80arm.serial.limits import PlugSettings
from trs80arm.serial.wire import WireError

Turn = tuple[int, ...]
"""T-state, motor and half-steps, as `Gathering.turns` has them."""
MODEL = "teachmover"
"""The model that the twin has to be of: the wire's language has its registers."""
FASTER = 1.02
"""How much faster than allowed a leg may come out, by the rounding of ticks."""
BY_HAND = ("set_bench", "move_joint", "move_to", "pull")
"""What moves the twin and cannot move the arm on the wire."""


class Plug:
    """Turns what the twin does into orders for the arm on the wire.

    Args:
        rig: the machine with the twin; it is watched until `unplug`.
        settings: how fast and far the arm may go.

    Attributes:
        orders: what is still to be sent, in order.
        fault: why nothing is sent any more, in one sentence; empty while all is well.
        half_steps: how many were seen so far.

    Raises:
        WireError: the twin is no TeachMover.
    """

    each_step = False

    def __init__(self, rig: Rig, settings: PlugSettings) -> None:
        if rig.arm.model.name != MODEL:
            raise WireError(
                f"the arm on the wire is a TeachMover, and the model beside it a "
                f"{rig.arm.model.title}: --arm {MODEL}"
            )
        self._rig = rig
        self._settings = settings
        self._arm = rig.arm
        self.orders: deque[Order] = deque()
        self.fault = ""
        self.half_steps = 0
        self._gathering = Gathering(motor.rotor for motor in rig.arm.motors)
        self._closing: list[Turn] = []
        self._closed = False
        self._gone = [0] * len(MOTORS)
        self._compared = True
        self._since = rig.clock.now
        self._ends = (rig.watch_latches(self), rig.record(self._did))

    def unplug(self) -> None:
        """Look on no more, and forget what is not sent yet."""
        for end in self._ends:
            end()
        self.orders.clear()

    # -- what the machine does --------------------------------------------------------------------

    def wrote(self, times: Series, latches: Series, nibbles: Series) -> None:
        """Latches were written, and the twin has followed."""
        if not self._same():
            return
        turns = list(self._gathering.turns(times, latches, nibbles))
        self.half_steps += len(turns)
        if self._rig.driver.mode is Mode.CLOSE:
            self._add(self._gathering.end())
            self._closing += turns
            self._closed = self._rig.card.grip_closed(self._rig.clock.now)
            return
        self._end_closing()
        self._add(self._gathering.take(turns))
        if len(times) >= len(MOTORS) and not any(nibbles):
            # All coils off at one instant: that is @RESET.
            self._add(self._gathering.end())
            self._order(Zero())

    def _end_closing(self) -> None:
        """What there was of an @CLOSE: the hand grips, or the operator broke it off."""
        turns, self._closing = self._closing, []
        gathered = Gathering([0] * len(MOTORS))
        legs = [*gathered.take(turns), *gathered.end()]
        if legs and self._closed:
            counts = [sum(each) for each in zip(*(leg.counts for leg in legs), strict=True)]
            leg = Leg(tuple(counts), legs[0].rate)
            if self._allowed(leg):
                self._order(Grip(leg))
        else:
            self._add(legs)

    def _add(self, legs: Iterable[Leg]) -> None:
        for leg in legs:
            if self._allowed(leg):
                self._order(Move(leg))

    def _order(self, order: Order) -> None:
        if not self.fault:
            self.orders.append(order)
            self._compared = isinstance(order, Compare)

    def _did(self, done: Input) -> None:
        """The operator did something."""
        if done.action in BY_HAND:
            self.fail("The model was put elsewhere, where the arm on the wire is not.")

    # -- whether the arm may follow ---------------------------------------------------------------

    def _allowed(self, leg: Leg) -> bool:
        """Whether a leg may be sent; else nothing is any more."""
        if self.fault or self._slipped():
            return False
        names = self._arm.model.motor_names
        motor = max(range(len(MOTORS)), key=lambda each: abs(leg.counts[each]))
        if leg.rate > self._settings.speed * FASTER:
            self.fail(
                f"The {names[motor]} would make {leg.rate:.0f} half-steps a second, and the arm "
                f"on the wire may make {self._settings.speed}: a larger D, or --plug-speed."
            )
        for each, count in enumerate(leg.counts):
            self._gone[each] += count
            if abs(self._gone[each]) > self._settings.range:
                self.fail(
                    f"The {names[each]} would go {abs(self._gone[each])} half-steps from where it "
                    f"stood, and may go {self._settings.range}: --plug-range."
                )
        return not self.fault

    def _slipped(self) -> bool:
        """Whether the twin has lost steps, as the arm on the wire would.

        Once the coils are off a motor does not know any more that it has.
        """
        slips = [event for event in self._arm.events if event.kind is EventKind.SLIP]
        if not any(event.until > self._since for event in slips) and not any(
            motor.ring for motor in self._arm.motors
        ):
            return False
        told = slips[-1].text if slips else "a motor slipped"
        self.fail(f"The arm on the wire was stopped before what befell the model: {told}.")
        return True

    def _same(self) -> bool:
        """Whether all is well, and the machine's arm is still the twin."""
        if self._rig.arm is not self._arm:
            self.fail("The model is another one, or was taken back in time; the arm was not.")
        return not self.fault

    def fail(self, fault: str) -> None:
        """Send nothing any more; the first reason is the one that is told."""
        if not self.fault:
            self.fault = fault
        self.orders.clear()

    # -- whoever lets time pass -------------------------------------------------------------------

    def look(self) -> None:
        """See what is over by now, and whether the twin is still the machine's arm."""
        rig = self._rig
        if not self._same():
            return
        if rig.driver.mode is not Mode.CLOSE:
            self._end_closing()
        self._add(self._gathering.settle(rig.clock.now))
        if rig.driver.mode is Mode.IDLE and not self._gathering.under_way:
            self._compare()

    def finish(self) -> None:
        """Take what is going on for over."""
        self.look()
        if not self.fault:
            self._end_closing()
            self._add(self._gathering.end())
            self._compare()

    def _compare(self) -> None:
        """Have the registers compared, if anything was sent since."""
        if not self._compared and not self._slipped():
            self._order(Compare())
