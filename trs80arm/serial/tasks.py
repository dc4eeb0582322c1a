"""What the TeachMover's computer is at work on: commands that take time.

Each is a small object of plain values that can be left at any T-state and gone on with.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from trs80arm.machine.clock import T_STATES_PER_SECOND, Clock
from trs80arm.machine.coordination import Pace
from trs80arm.machine.driver import Driver, Mode
from trs80arm.progress import Progress
from trs80arm.pulses import Train
from trs80arm.serial.instructions import Close, Jump, PutOut, Rest, instruction_of
from trs80arm.serial.memory import Move, Row, TeachMemory, number_of
from trs80arm.serial.speeds import delay_of

_LONGEST_BURST = 4096
"""Ticks that are sent at once: it bounds the memory used."""
_INSTRUCTION = T_STATES_PER_SECOND // 100
"""T-states that a step takes beside what it does; chosen."""


class At(Protocol):
    """What a task works with: the computer that does it."""

    clock: Clock
    driver: Driver
    memory: TeachMemory
    speed: int

    def put_out(self, value: int) -> None:
        """Set the output bits."""

    def holds(self, condition: int) -> bool:
        """Whether a `Condition` holds now."""


class Task(Protocol):
    """A command under way."""

    @property
    def word(self) -> str:
        """The command that asked for it, as `STEP`."""

    def advance(self, at: At) -> Progress:
        """Carry on until it ends or the clock reaches its limit."""


@dataclass
class Motion:
    """A motion of the driver's, begun already.

    Attributes:
        word: the command that asked for it.
    """

    word: str

    def advance(self, at: At) -> Progress:
        """As in `Task`."""
        return at.driver.advance()


@dataclass
class Playing:
    """`@RUN`, and the pendant's STEP and RUN: what is in the memory, step after step.

    Attributes:
        number: the step that is done; the next one is the first with a greater number.
        once: whether the first step is the last.
        again: whether the last step is followed by the first.
        until: T-state at which it goes on.
        ended: whether the last step is being done.
    """

    number: int = 0
    once: bool = False
    again: bool = False
    until: int = 0
    ended: bool = False

    @property
    def word(self) -> str:
        """As in `Task`."""
        return "STEP" if self.once else "RUN"

    def advance(self, at: At) -> Progress:
        """As in `Task`."""
        while (progress := at.driver.advance()) is Progress.DONE:
            if at.driver.until(self.until) is Progress.BUSY:
                return Progress.BUSY
            if self.ended:
                break
            row = next((row for row in at.memory if number_of(row) > self.number), None)
            # What is done between two moves takes a moment, or a program that jumps round and
            # round would be no motion and no end.
            self.until = at.clock.now + _INSTRUCTION
            if row is not None:
                self.number = number_of(row)
                self._do(row, at)
            elif self.again and len(at.memory):
                self.number = 0
                continue
            else:
                break
            self.ended = self.once
        return progress

    def _do(self, row: Row, at: At) -> None:
        """What a row says."""
        match instruction_of(row):
            case Move(speed, position):
                here = at.driver.registers
                steps = [end - begin for end, begin in zip(position, here, strict=True)]
                at.driver.step(delay_of(speed), steps)
            case Close():
                at.driver.close(delay_of(at.speed))
            case PutOut(value):
                at.put_out(value)
            case Rest(seconds):
                self.until += seconds * T_STATES_PER_SECOND
            case Jump(step, condition) if at.holds(condition):
                self.number = step - 1


@dataclass
class Manual:
    """A motion of the driver's: the pendant's keys move the arm until somebody ends it.

    Attributes:
        pace: of its ticks.
        directions: which way each motor goes now, 1, -1 or 0.
        tick: the next one.
    """

    pace: Pace
    directions: tuple[int, ...]
    tick: int = 0
    mode = Mode.SET

    def advance(self, driver: Driver) -> Progress:
        """Make the steps that come before the limit."""
        stop = self.pace.first_tick_from(driver.limit)
        while any(self.directions) and self.tick < stop:
            end = min(stop, self.tick + _LONGEST_BURST)
            count, first = end - self.tick, self.tick
            driver.send(
                self.pace,
                [
                    Train(motor, way, 0, count, phase=first)
                    for motor, way in enumerate(self.directions)
                    if way
                ],
            )
            self.tick = end
        self.tick = max(self.tick, stop)
        return driver.wait()
