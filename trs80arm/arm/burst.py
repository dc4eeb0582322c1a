"""Whole motions at once: a burst of latch writes as arrays, while nothing happens.

Bursts come here whose bounds are not enough for a stride. Everything that could make a difference,
a stop near, something on the bench near, a motor out of step, a feeder about to feed, ends the
stretch that is done in one go, and the arm does what follows write by write. The tests for "nothing
near" are wider than the ones for contact, so both ways give the same state to the last half-step.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from trs80arm.arm.contact.clock import TICK_STATES
from trs80arm.arm.keeping_pace import against, done_with
from trs80arm.arm.motors import RING, ROWS
from trs80arm.arm.peaks import greatest
from trs80arm.pulses import Columns

if TYPE_CHECKING:
    from trs80arm.arm.minimover import MiniMover

LONGEST = 4096
"""Writes looked at in one go."""
MARGIN = 0.02
"""Width of the zone, in radians and inches, that is left to the write-by-write way."""

Array = npt.NDArray[np.int64]
Floats = npt.NDArray[np.float64]

_ROWS = np.array(ROWS, dtype=np.int64)


def run_free(
    arm: MiniMover, writes: Columns, then: int | None, stop: tuple[int, int] | None
) -> tuple[int, bool]:
    """Do the beginning of a burst in which nothing happens.

    Args:
        arm: the arm, every motor of it settled.
        writes: of the burst.
        then: T-state of the write after them, if they are the beginning of a burst.
        stop: as for `MiniMover.follow`, the grip switch only.

    Returns:
        How many writes were done, and whether the stop condition ended the burst there.
    """
    writes = writes.arrays()
    times = np.asarray(writes.times)
    ends = np.append(times[1:] != times[:-1], then is None or then != writes.ends)
    stretch = _Stretch(arm, times, np.asarray(writes.latches), np.asarray(writes.nibbles), ends)
    count = stretch.free()
    ended = False
    if stop is not None and count:
        last = np.flatnonzero(ends[:count])
        closed = stretch.squeeze[last] >= arm.model.hand.switch_steps
        inputs = np.where(closed, 0b1110, 0b1111)
        met = np.flatnonzero((inputs & stop[0]) == stop[1])
        if len(met):
            count, ended = int(last[met[0]]) + 1, True
    stretch.commit(count)
    return count, ended


class _Stretch:
    """A burst as arrays: turns of the fields, positions of the rotors, write by write."""

    def __init__(
        self,
        arm: MiniMover,
        times: Array,
        latches: Array,
        nibbles: Array,
        ends: npt.NDArray[np.bool_],
    ) -> None:
        self.arm = arm
        self.ends = ends
        self.times = times
        self.latches = latches
        self.nibbles = nibbles & 15
        self.rows = _ROWS[self.nibbles]
        self.free_until = len(times)
        self._cut((latches < 0) | (latches > 5) | (self.rows < 0))
        n = self.free_until
        turns = np.zeros(n, dtype=np.int64)
        self.writes: list[Array] = []
        for latch in range(6):
            motor = arm.motors[latch]
            mine = np.flatnonzero(latches[:n] == latch)
            patterns = self.nibbles[mine]
            # A latch that is given what it holds does nothing.
            mine = mine[patterns != np.concatenate(([motor.coils], patterns[:-1]))]
            self.writes.append(mine)
            if not len(mine):
                continue
            rows = self.rows[mine]
            first = motor.field if motor.row >= 0 else motor.rotor
            before = np.concatenate(([first & 7], rows[:-1]))
            turns[mine] = (rows - before + 3) % 8 - 3
        self._cut(turns == 4)
        if arm.world.homes:
            self._cut(self._turning_back(turns))
        n = self.free_until
        self.turns = turns[:n]
        self.writes = [mine[mine < n] for mine in self.writes]
        moves = np.zeros((n, 6), dtype=np.int64)
        moves[np.arange(n), latches[:n]] = self.turns
        rotors = np.cumsum(moves, axis=0)
        rotors += np.array(arm.rotors, dtype=np.int64)
        self.rotors = rotors
        self.before = rotors - moves
        drive, grip = arm.drive, arm.grip
        self.cable = drive.cable(rotors.T)
        self.squeeze = np.maximum(0, grip.contact - self.cable)
        self.done: dict[int, Array] = {}
        self.against: dict[int, Floats] = {}

    def _turning_back(self, turns: Array) -> npt.NDArray[np.bool_]:
        """Writes that turn a motor another way than its first: a home switch has to see where."""
        back = np.zeros(len(turns), dtype=np.bool_)
        for mine in self.writes:
            ways = np.sign(turns[mine])
            first = ways[np.argmax(ways != 0)] if len(mine) else 0
            back[mine] = ways * first < 0
        return back

    def _cut(self, bad: npt.NDArray[np.bool_]) -> None:
        """End the stretch before the first write at which `bad` holds."""
        bad = bad[: self.free_until]
        first = int(np.argmax(bad)) if len(bad) else 0
        if len(bad) and bad[first]:
            self.free_until = first

    def free(self) -> int:
        """How many writes can be done in one go."""
        if self.free_until:
            self._keep_pace()
            self._hand()
            self._joints()
        return self.free_until

    def _keep_pace(self) -> None:
        """Motors that drop out of step."""
        arm = self.arm
        lag = arm.settings.pull_out_lag
        margin = arm.settings.speed_margin
        for latch, mine in enumerate(self.writes):
            if not len(mine):
                continue
            motor, drive = arm.motors[latch], arm.model.drives[latch]
            turns = self.turns[mine]
            torque = self.against[latch] = against(arm, latch, turns, self.before[mine].T)
            periods = arm.strength.curves[drive.turns].periods(torque, margin)
            times = self.times[mine]
            done = done_with(times, np.abs(turns) * periods, motor.done)
            late = done - times > lag * periods
            if late.any():
                self.free_until = min(self.free_until, int(mine[int(np.argmax(late))]))
            self.done[latch] = done

    def _hand(self) -> None:
        """Cable near its ends, and a grip too weak for what it carries."""
        grip, model = self.arm.grip, self.arm.model
        hand = model.hand
        bad = self.squeeze > hand.most_squeeze - 2
        bad |= self.cable > hand.range * model.hand_steps - 2
        # Something may lie on the hand that is not between its fingers.
        if grip.contact or self.arm.bench.scene.carried:
            bad |= self._disturbed()
        self._cut(bad)

    def _disturbed(self) -> npt.NDArray[np.bool_]:
        """Where the load, or what is between the fingers, has to be looked at again."""
        arm, n = self.arm, len(self.cable)
        if not arm.world.burdens():
            return np.ones(n, dtype=np.bool_)
        low, high = arm.world.held_cables()
        # A step of the elbow and the hand's that makes up for it are one instant.
        bad: npt.NDArray[np.bool_] = self.ends[:n] & (
            (self.cable[:n] < low) | (self.cable[:n] > high)
        )
        left, right = (arm.drive.driven(self.rotors[:n].T)[motor] for motor in (3, 4))
        *_, left_now, right_now = arm.drive.driven(arm.rotors)
        pitch = (left_now + right_now) / 2
        turned = np.abs((left + right) / 2 - pitch)
        rolled = np.abs((left - right) - (left_now - right_now)) / 2
        bad |= turned + abs(math.cos(pitch)) * rolled > arm.world.tilt()
        return bad

    def _joints(self) -> None:
        """Stops, and everything on the bench."""
        n = self.free_until
        if not n:
            return
        limits = self.arm.model.limits
        base, shoulder, elbow, left, right = self.arm.drive.driven(self.rotors[:n].T)
        pitch = (left + right) / 2
        bend = elbow - shoulder
        low, high = limits.shoulder
        bent, straight = limits.elbow
        bad = np.abs(base) > limits.base - MARGIN
        bad |= (shoulder > high - MARGIN) | (shoulder < low + MARGIN)
        bad |= (bend > straight - MARGIN) | (bend < bent + MARGIN)
        bad |= np.abs(pitch - elbow) > limits.pitch - MARGIN
        bad |= np.maximum(np.abs(left), np.abs(right)) > limits.gear - MARGIN
        self._cut(bad)
        if self.free_until:
            self._bench()

    def _bench(self) -> None:
        """Ticks on which contact would have to be looked at."""
        n, arm = self.free_until, self.arm
        ticks = np.arange(arm.world.due, int(self.times[n - 1]) + 1, TICK_STATES)
        before = np.searchsorted(self.times[:n], ticks) - 1
        rotors = np.where(before[:, None] < 0, np.array(arm.rotors), self.rotors[before])
        clear = arm.world.ticks_clear(rotors.T) if len(ticks) else 0
        if clear < len(ticks):
            self.free_until = int(np.searchsorted(self.times[:n], ticks[clear]))

    def commit(self, count: int) -> None:
        """Leave the arm as the first `count` writes leave it."""
        if not count:
            return
        arm = self.arm
        for latch, mine in enumerate(self.writes):
            k = int(np.searchsorted(mine, count))
            if not k:
                continue
            last = int(mine[k - 1])
            motor = arm.motors[latch]
            turned = int(self.rotors[last, latch]) - motor.rotor
            steps, times = self.turns[mine[:k]], self.times[mine[:k]]
            asked = np.abs(steps)
            if motor.row < 0:
                asked[0] = min(asked[0], 1)
            arm.note_use(latch, greatest(arm, latch, times, asked, self.against[latch][:k]))
            pulses = np.repeat(times, asked)[-RING - 1 :].tolist()
            if pulses:
                motor.asked(pulses, int(np.sign(steps[steps != 0][-1])))
            motor.follow(k)
            motor.moved = int(self.times[last])
            motor.done = int(self.done[latch][k - 1])
            motor.field = (motor.field if motor.row >= 0 else motor.rotor) + turned
            motor.rotor += turned
            motor.row = int(self.rows[last])
            motor.coils = int(self.nibbles[last])
        time = int(self.times[count - 1])
        before = int(np.searchsorted(self.times[:count], arm.bench.scene.last_tick(time)))
        ticked = self.rotors[before - 1].tolist() if before else list(arm.rotors)
        arm.arrive(self.rotors[count - 1].tolist(), ticked, time)
