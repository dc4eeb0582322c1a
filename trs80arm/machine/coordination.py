"""When each step of a motion comes: the pace that D sets, and Figure 10's linear coordination.

The driver's timing, apart from what it writes. The motor with the most steps makes one in every
tick; the others are spread evenly over the same ticks, so that all begin and end together.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from trs80arm.pulses import Train

_T_STATES_PER_10_US = (11_088, 625)
"""1,774,080 T-states a second, as a fraction of hundredths of a millisecond in lowest terms."""
_BASE = 120
_PER_UNIT = 3
"""A tick takes 1.2 + 0.03 D milliseconds (article, ARMBASIC), here in hundredths of one."""


@dataclass(frozen=True)
class Pace:
    """The ticks of one motion: tick k is `1.2 + 0.03 D` ms times k after its start.

    The T-state of a tick is rounded down each time from the exact product, so that no error adds
    up: a million ticks take as long as they should, to the T-state.

    Attributes:
        start: the T-state of tick 0.
        delay: D, 0 or more.
    """

    start: int
    delay: int

    @property
    def ratio(self) -> tuple[int, int]:
        """T-states of a tick, as a fraction: above the line and below it."""
        over, under = _T_STATES_PER_10_US
        return (_BASE + _PER_UNIT * self.delay) * over, under

    def time(self, tick: int) -> int:
        """The T-state of a tick."""
        over, under = self.ratio
        return self.start + tick * over // under

    def first_tick_from(self, time: int) -> int:
        """The first tick that does not come before a T-state."""
        over, under = self.ratio
        return max(0, -(-(time - self.start) * under // over))


@dataclass(frozen=True)
class Coordination:
    """A coordinated move of several motors (article, Figure 10).

    Of N ticks, 0 to N-1, a motor with n steps makes step i, 0 to n-1, at tick `i (N-1) / (n-1)`,
    rounded down: the first step of every motor is in the first tick and the last one in the last,
    and between them the spacing is even within one tick. 21 steps against 3 come at ticks 0 to 20
    and 0, 10, 20. A single step cannot be both first and last; it ends with the others. (The
    article shows that all begin and end together; this phase of the steps between is a choice.)

    Attributes:
        counts: signed steps of each motor.
    """

    counts: Sequence[int]

    @property
    def ticks(self) -> int:
        """N: the count of the motor that has most to do."""
        return max(abs(count) for count in self.counts)

    def trains(self, first: int, stop: int) -> list[Train]:
        """The steps of all motors in the ticks `first <= tick < stop`."""
        last = self.ticks - 1
        found = []
        for motor, count in enumerate(self.counts):
            steps = abs(count)
            begin, end = _steps_before(steps, last, first), _steps_before(steps, last, stop)
            if begin < end:
                direction = 1 if count > 0 else -1
                if steps == 1:
                    train = Train(motor, direction, 0, 1, phase=last)
                elif steps > last:
                    train = Train(motor, direction, begin, end)
                else:
                    train = Train(motor, direction, begin, end, over=last, under=steps - 1)
                found.append(train)
        return found


def _steps_before(steps: int, last: int, tick: int) -> int:
    """How many of a motor's steps come before a tick, when the last of all is at tick `last`."""
    if tick > last:
        return steps
    if steps <= 1:
        return 0
    return -(-tick * (steps - 1) // last)
