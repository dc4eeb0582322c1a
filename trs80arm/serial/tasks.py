"""What the TeachMover's computer is at work on: commands that take time.

Each is a small object of plain values that can be left at any T-state and gone on with.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from trs80arm.machine.coordination import Pace
from trs80arm.machine.driver import Driver, Mode
from trs80arm.progress import Progress
from trs80arm.pulses import Train
from trs80arm.serial.memory import MOVE, Move, TeachMemory, kind_of, number_of
from trs80arm.serial.speeds import delay_of

_LONGEST_BURST = 4096
"""Ticks that are sent at once: it bounds the memory used."""


class At(Protocol):
    """What a task works with: the computer that does it."""

    driver: Driver
    memory: TeachMemory


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
    """`@RUN`: the moves in the memory, one after the other, once.

    Attributes:
        number: the step that is done; the next one is the first with a greater number.
    """

    number: int = 0

    @property
    def word(self) -> str:
        """As in `Task`."""
        return "RUN"

    def advance(self, at: At) -> Progress:
        """As in `Task`."""
        while (progress := at.driver.advance()) is Progress.DONE:
            row = next((row for row in at.memory if number_of(row) > self.number), None)
            if row is None:
                break
            self.number = number_of(row)
            if kind_of(row) == MOVE:
                move = Move.of(row)
                here = at.driver.registers
                at.driver.step(
                    delay_of(move.speed),
                    [end - begin for end, begin in zip(move.position, here, strict=True)],
                )
        return progress


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
