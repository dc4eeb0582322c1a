"""ARMBASIC's driver: the routines behind @STEP, @CLOSE, @SET, @RESET and @READ.

In 1980 it was Z-80 code beside BASIC, turning the five commands into coil patterns on the card's
latches. The language begins a motion and lets the driver carry it on; the front end looks at its
mode and registers.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from enum import Enum
from typing import Any, Protocol

from trs80arm.machine.card import GRIP_CLOSED, MOTORS, Card
from trs80arm.machine.clock import Clock
from trs80arm.machine.coordination import Coordination, Pace
from trs80arm.machine.half_steps import COILS_OFF, HALF_STEPS, RING
from trs80arm.machine.jog_keys import JogKeys, KeyMatrix, KeysDown
from trs80arm.machine.keys import Key
from trs80arm.progress import Progress
from trs80arm.pulses import Columns, Pulses, Train

Counts = tuple[int, int, int, int, int, int]

_ELBOW, _HAND = 2, 5
_LONGEST_BURST = 4096
"""Ticks of a motion without a known end that are sent at once: it bounds the memory used."""


class Mode(Enum):
    """What the driver is doing."""

    IDLE = "idle"
    STEP = "step"
    CLOSE = "close"
    SET = "set"


@dataclass(frozen=True)
class DriverSettings:
    """What the record leaves open about ARMBASIC, as settings.

    Attributes:
        close_delay: D of an `@CLOSE` without one.
        set_delay: D of an `@SET` without one.
        keys: the keys of manual mode.
        break_now: whether BREAK ends an `@STEP` at once. Otherwise, as on the real machine, a
            motion is one statement and BREAK is seen when it has ended. (`@CLOSE` and `@SET`, which
            may never end of themselves, always look for BREAK.)
    """

    close_delay: int = 50
    set_delay: int = 50
    keys: JogKeys = field(default_factory=JogKeys)
    break_now: bool = False

    def __post_init__(self) -> None:
        for name, delay in (("close_delay", self.close_delay), ("set_delay", self.set_delay)):
            if not 0 <= delay <= 32767:
                raise ValueError(f"{name} must be 0 to 32767, not {delay}")


class Driver:
    """The five commands, and the six position registers.

    A motion is a state: `step`, `close` and `set` begin one, `advance` carries it on to the clock's
    limit. It takes the same course, write by write, however often it is left and taken up again.

    Registers count commanded half-steps in 16 bits and wrap around from 32767 to -32768. The hand's
    compensation for the elbow is not counted. The driver remembers for each motor the row of
    Figure 8 that it wrote last, through `@RESET` too; it knows nothing of patterns that a program
    sends with OUT. A motor without current gets it again with its own next step.

    Args:
        hand_per_elbow: half-steps that the hand's motor is given with each one of the elbow's; -1
            for the MiniMover, 0 for an arm whose @STEP leaves the hand alone.

    Attributes:
        settings: the choices that the record leaves open.
        registers: J1 to J6 as commanded since power-on or the last `@RESET`.
        reset_observers: called after each `@RESET`; they are not part of a snapshot.
    """

    def __init__(
        self,
        clock: Clock,
        card: Card,
        matrix: KeyMatrix,
        settings: DriverSettings | None = None,
        hand_per_elbow: int = -1,
    ) -> None:
        self.settings = settings or DriverSettings()
        self.registers: Counts = (0, 0, 0, 0, 0, 0)
        self.reset_observers: list[Callable[[], None]] = []
        self._clock = clock
        self._card = card
        self._matrix = matrix
        self._rows = [0] * len(MOTORS)
        self._hand_per_elbow = hand_per_elbow
        self._motion: Motion | None = None

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "reset_observers": []}

    @property
    def mode(self) -> Mode:
        """What the driver is doing."""
        return self._motion.mode if self._motion else Mode.IDLE

    @property
    def next_tick(self) -> int | None:
        """The T-state of the motion's next tick, or None; running past it does one motor step."""
        return self._motion.pace.time(self._motion.tick) if self._motion else None

    # -- the five commands --------------------------------------------------------------------

    def step(self, delay: int, steps: Sequence[int]) -> None:
        """`@STEP D,J1..J6`: begin a coordinated move.

        The hand motor of a MiniMover is given J6 - J3, so that the elbow does not change the
        hand's opening, and takes part in the coordination with that count: it has as many ticks as
        the largest count of any motor. A move of no steps writes nothing and takes no time.

        Args:
            delay: D, 0 or more; a tick takes 1.2 + 0.03 D ms.
            steps: six relative counts of half-steps.
        """
        j1, j2, j3, j4, j5, j6 = steps
        move = Coordination((j1, j2, j3, j4, j5, j6 + self._hand_per_elbow * j3))
        self._motion = _Step(Pace(self._clock.now, delay), move)

    def close(self, delay: int | None = None) -> None:
        """`@CLOSE [D]`: begin to close the hand, step by step, until the grip switch closes.

        If it is closed already there is no step. If it never closes, only BREAK ends the motion.
        """
        pace = Pace(self._clock.now, self.settings.close_delay if delay is None else delay)
        self._motion = _Close(pace, closed=self._card.grip_closed(self._clock.now))

    def set(self, delay: int | None = None) -> None:
        """`@SET [D]`: begin manual mode, which the key 0 ends.

        A 0 that is down already, as from ending the manual mode before, must be let go first.
        """
        pace = Pace(self._clock.now, self.settings.set_delay if delay is None else delay)
        self._motion = _Set(pace, let_go=self.settings.keys.leave not in self.look())

    def reset(self) -> None:
        """`@RESET`: registers to zero, the coils of all six motors off.

        The auxiliary latch, which is no motor of the arm, is left alone.
        """
        self._motion = None
        now = self._clock.now
        count = len(MOTORS)
        self._card.burst(Columns([now] * count, MOTORS, [COILS_OFF] * count))
        self.zero()

    def zero(self) -> None:
        """Registers to zero, and the coils as they are."""
        self.registers = (0, 0, 0, 0, 0, 0)
        for observer in self.reset_observers:
            observer()

    def read(self) -> Counts:
        """`@READ`: the six position registers."""
        return self.registers

    def begin(self, motion: Motion) -> None:
        """Begin a motion that is none of the five commands'."""
        self._motion = motion

    def stop(self) -> None:
        """Break the motion off where it is; the coils stay as they are."""
        self._motion = None

    @property
    def motion(self) -> Motion | None:
        """The motion under way."""
        return self._motion

    def advance(self) -> Progress:
        """Carry on with the motion until it ends or the clock reaches its limit.

        Steps that come before the limit are done; one that falls on it belongs to the next turn,
        with whatever the keys are then. `Clock.now` ends at the limit, or where the motion ended.
        """
        motion = self._motion
        if motion is None:
            return Progress.DONE
        progress = motion.advance(self)
        if progress is not Progress.BUSY:
            self._motion = None
        return progress

    # -- what the motions are made of ---------------------------------------------------------

    @property
    def limit(self) -> int:
        """The T-state before which steps are to be done now."""
        return self._clock.limit

    def until(self, time: int) -> Progress:
        """Let time pass to the end of a motion, or to the limit if that comes first."""
        if time > self._clock.limit:
            return self.wait()
        self._clock.now = max(self._clock.now, time)
        return Progress.DONE

    def wait(self) -> Progress:
        """Let time pass to the limit."""
        self._clock.now = max(self._clock.now, self._clock.limit)
        return Progress.BUSY

    def look(self) -> KeysDown:
        """Which of the keys are down that a motion can be led or ended with."""
        return self.settings.keys.look(self._matrix)

    def directions(self, down: KeysDown) -> tuple[int, ...]:
        """Where the keys of manual mode want the six motors to go, the hand with the elbow."""
        *arm, hand = self.settings.keys.directions(down)
        return (*arm, hand + self._hand_per_elbow * arm[_ELBOW])

    def grips(self, time: int) -> bool:
        """Whether the grip switch is closed."""
        return self._card.grip_closed(time)

    def send(self, pace: Pace, trains: Sequence[Train]) -> None:
        """Write the steps of all trains to the latches, in order of time and motor, and count."""
        self._card.burst(self._pulses(pace, *trains))
        for train in trains:
            self._count(train, len(train))

    def send_until_grip(self, pace: Pace, train: Train) -> int:
        """Write the steps of a train until the grip switch closes, and count.

        Returns:
            How many steps were done.
        """
        done = self._card.burst(self._pulses(pace, train), GRIP_CLOSED)
        self._count(train, done)
        return done

    def _pulses(self, pace: Pace, *trains: Train) -> Pulses:
        return Pulses(pace.start, *pace.ratio, trains, tuple(self._rows), HALF_STEPS)

    def _count(self, train: Train, steps: int) -> None:
        change = train.direction * steps
        self._rows[train.motor] = (self._rows[train.motor] + change) % RING
        registers = list(self.registers)
        registers[train.motor] = wrapped(registers[train.motor] + change)
        if train.motor == _ELBOW:
            # An elbow step brings a hand step with it that is no command; this takes it out.
            registers[_HAND] = wrapped(registers[_HAND] - self._hand_per_elbow * change)
        j1, j2, j3, j4, j5, j6 = registers
        self.registers = (j1, j2, j3, j4, j5, j6)


def wrapped(count: int) -> int:
    """A count as a 16-bit register holds it."""
    return (count + 0x8000) % 0x10000 - 0x8000


class Motion(Protocol):
    """A command under way.

    Attributes:
        pace: when its ticks come.
        tick: the next one to do.
    """

    pace: Pace
    tick: int

    @property
    def mode(self) -> Mode:
        """What the driver is doing while it is under way."""

    def advance(self, driver: Driver) -> Progress:
        """Do what comes before the driver's limit; `Clock.now` ends there, or where it ended."""


@dataclass
class _Step:
    """`@STEP` under way; `tick` is the next one to do."""

    pace: Pace
    move: Coordination
    tick: int = 0
    mode = Mode.STEP

    def advance(self, driver: Driver) -> Progress:
        if driver.settings.break_now and Key.BREAK in driver.look():
            return Progress.BREAK
        ticks = self.move.ticks
        stop = min(ticks, self.pace.first_tick_from(driver.limit))
        if stop > self.tick:
            driver.send(self.pace, self.move.trains(self.tick, stop))
            self.tick = stop
        return driver.until(self.pace.time(ticks))


@dataclass
class _Close:
    """`@CLOSE` under way: the switch is read after each step, before the wait for the next."""

    pace: Pace
    closed: bool
    tick: int = 0
    mode = Mode.CLOSE

    def advance(self, driver: Driver) -> Progress:
        if Key.BREAK in driver.look():
            return Progress.BREAK
        stop = self.pace.first_tick_from(driver.limit)
        while self.tick < stop and not self.closed:
            count = min(stop - self.tick, _LONGEST_BURST)
            train = Train(_HAND, -1, 0, count, phase=self.tick)
            done = driver.send_until_grip(self.pace, train)
            self.tick += done
            self.closed = done < count or driver.grips(self.pace.time(self.tick - 1))
        return driver.until(self.pace.time(self.tick)) if self.closed else driver.wait()


@dataclass
class _Set:
    """`@SET` under way: the keys are looked at in every tick, and all act at once.

    No motor makes two steps in one tick. Where elbow and hand keys together would ask that of the
    hand motor (the compensation being one step more the same way), elbow and hand take turns; a
    combined `@STEP` takes as long.
    """

    pace: Pace
    let_go: bool
    """Whether the key that ends the mode has been seen up."""
    tick: int = 0
    mode = Mode.SET

    def advance(self, driver: Driver) -> Progress:
        keys, down = driver.settings.keys, driver.look()
        if Key.BREAK in down:
            return Progress.BREAK
        if keys.leave not in down:
            self.let_go = True
        elif self.let_go:
            return Progress.DONE
        stop = self.pace.first_tick_from(driver.limit)
        directions = driver.directions(down)
        if any(directions):
            while self.tick < stop:
                burst_stop = min(stop, self.tick + _LONGEST_BURST)
                driver.send(self.pace, self._trains(directions, burst_stop))
                self.tick = burst_stop
        self.tick = max(self.tick, stop)
        return driver.wait()

    def _trains(self, directions: Sequence[int], stop: int) -> list[Train]:
        turns = abs(directions[_HAND]) == 2
        trains = []
        for motor, direction in enumerate(directions):
            every = 2 if turns and motor == _ELBOW else 1
            # The elbow's turns are the even ticks, wherever this burst begins.
            first = self.tick + self.tick % every
            count = max(0, -(-(stop - first) // every))
            if direction and count:
                sign = 1 if direction > 0 else -1
                trains.append(Train(motor, sign, 0, count, phase=first, over=every))
        return trains
