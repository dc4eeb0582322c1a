"""What the rows of the TeachMover's memory say: moves, and what a program does between them.

A row is the number of its step, its kind in the low byte of the second number, and what the kind
has to say. How a move is laid out is known (`Move`); that there are the other kinds is known from
the pendant's keys, and their numbers and layout are chosen: the value in the high byte of the
second number, a further one in the third. Rows of other kinds are kept, and do nothing.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import TypeAlias

from trs80arm.serial.memory import MOVE, Move, Row, kind_of

CLOSE, PUT_OUT, REST, JUMP = range(MOVE + 1, MOVE + 5)
"""The other kinds, chosen."""


class Condition(IntEnum):
    """When a jump is made; the numbers are chosen."""

    ALWAYS = 0
    INPUT_1 = 1
    INPUT_2 = 2
    INPUT_3 = 3
    GRIP = 4
    """The grip switch is closed."""


@dataclass(frozen=True)
class Close:
    """The hand closes until the grip switch does."""

    def row(self, number: int) -> Row:
        """It as the row of a step."""
        return _row(number, CLOSE)


@dataclass(frozen=True)
class PutOut:
    """The four output bits are set.

    Attributes:
        value: 0 to 15.
    """

    value: int

    def row(self, number: int) -> Row:
        """It as the row of a step."""
        return _row(number, PUT_OUT, self.value)


@dataclass(frozen=True)
class Rest:
    """The arm stands still.

    Attributes:
        seconds: 0 to 255.
    """

    seconds: int

    def row(self, number: int) -> Row:
        """It as the row of a step."""
        return _row(number, REST, self.seconds)


@dataclass(frozen=True)
class Jump:
    """The program goes on at another step, if something holds.

    Attributes:
        step: where; the next one behind it if there is none of that number.
        condition: when, as `Condition`; no other number ever holds.
    """

    step: int
    condition: int = Condition.ALWAYS

    def row(self, number: int) -> Row:
        """It as the row of a step."""
        return _row(number, JUMP, self.condition, self.step)


Instruction: TypeAlias = Move | Close | PutOut | Rest | Jump


def _row(number: int, kind: int, value: int = 0, other: int = 0) -> Row:
    return number, value << 8 | kind, other, 0, 0, 0, 0, 0


def instruction_of(row: Row) -> Instruction | None:
    """What a row says; None if its kind is none of these."""
    value = row[1] >> 8
    match kind_of(row):
        case kind if kind == MOVE:
            return Move.of(row)
        case kind if kind == CLOSE:
            return Close()
        case kind if kind == PUT_OUT:
            return PutOut(value & 0xF)
        case kind if kind == REST:
            return Rest(value)
        case kind if kind == JUMP:
            return Jump(row[2], value)
    return None


def told(row: Row) -> str:
    """A row in a few words, as the pendant's listing has it."""
    match instruction_of(row):
        case Move(speed, position):
            return f"move  SP {speed}  {' '.join(map(str, position))}"
        case Close():
            return "grip"
        case PutOut(value):
            return f"out {value}"
        case Rest(seconds):
            return f"pause {seconds} s"
        case Jump(step, condition):
            when = {0: "", 4: " if it grips"}.get(condition, f" if input {condition}")
            return f"jump to {step}{when}"
    return f"kind {kind_of(row)}, not known"
