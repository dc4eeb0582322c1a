"""A TeachMover at the end of a wire: what it is told, and whether it did it.

Its commands are lines of ASCII, answered when they are done. It has registers of its own, as the
driver here has, and after each motion they are read and compared: they must have gone by what was
sent.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil

from trs80arm.serial.gathering import Leg
from trs80arm.serial.protocol import FASTEST, Close, Command, Read, Reset, Step, line
from trs80arm.serial.speeds import speed_of
from trs80arm.serial.wire import Wire, WireError

SECONDS = 2.0
"""How long an arm may take to answer, beside the time of what it was told to do."""
SLOWEST_CLOSING = 30.0
"""Seconds in which a hand is closed, however wide open it was."""
_BASE, _PER_UNIT = 1.2, 0.03
"""A tick takes 1.2 + 0.03 D milliseconds."""
_SLOW = 32767
"""D of what does not move."""
_WORD = 0x10000
_HAND = 5


@dataclass(frozen=True)
class Move:
    """`@STEP`: a leg of a motion."""

    leg: Leg


@dataclass(frozen=True)
class Grip:
    """`@CLOSE`: until the hand grips; in the model that took so many half-steps."""

    leg: Leg


@dataclass(frozen=True)
class Zero:
    """`@RESET`: registers to zero, motors off."""


@dataclass(frozen=True)
class Compare:
    """`@READ`: whether the registers are what they should be."""


Order = Move | Grip | Zero | Compare


class FarArm:
    """The arm at the end of a wire.

    Args:
        wire: to it.
        names: of its motors, in the order of its registers.
        play: half-steps by which its hand may close farther, or less far, than was thought.
    """

    def __init__(self, wire: Wire, names: Sequence[str], play: int) -> None:
        self._wire = wire
        self._names = names
        self._play = play
        self._expected = [0] * len(names)

    def meet(self) -> None:
        """See that it answers, and take its registers for the beginning; nothing moves.

        Raises:
            WireError: it does not answer as a TeachMover does.
        """
        self._expected = self._read()

    def do(self, order: Order) -> None:
        """Have it do something, and wait until it is done.

        Raises:
            WireError: it cannot be reached, or did not do it, or something else than that.
        """
        match order:
            case Move(leg):
                j1, j2, j3, j4, j5, j6 = leg.counts
                self._tell(Step(speed(leg.rate), (j1, j2, j3, j4, j5, j6)), leg.seconds)
                self._add(leg.counts)
            case Grip(leg):
                self._tell(Close(speed(leg.rate)), SLOWEST_CLOSING)
                self._add(leg.counts)
                self._take_hand()
            case Zero():
                self._tell(Reset(), 0.0)
                self._expected = [0] * len(self._names)
            case Compare():
                self._compare(self._read())

    def _add(self, counts: Sequence[int]) -> None:
        self._expected = [
            _signed(old + count) for old, count in zip(self._expected, counts, strict=True)
        ]

    def _take_hand(self) -> None:
        """Where the hand's register stands after closing, which the part in it has decided."""
        found = self._read()
        off = _signed(found[_HAND] - self._expected[_HAND])
        if abs(off) > self._play:
            way = "less far" if off > 0 else "farther"
            raise WireError(
                f"The hand on the wire closed {abs(off)} half-steps {way} than the model's: "
                "what it grips is not what stands on the bench here."
            )
        self._expected[_HAND] = found[_HAND]
        self._compare(found)

    def _compare(self, found: Sequence[int]) -> None:
        for name, here, there in zip(self._names, self._expected, found, strict=True):
            if here != there:
                raise WireError(
                    f"The arm on the wire is not where it should be: its register of the {name} "
                    f"has {there}, and {here} was asked for."
                )

    def _tell(self, command: Command, seconds: float) -> None:
        self._ask(command, 1, seconds)

    def _read(self) -> list[int]:
        _, values = self._ask(Read(), 2, 0.0)
        numbers = values.split(",")
        if len(numbers) != len(self._names) + 1:
            raise _nonsense("@READ", values)
        try:
            return [_signed(int(number)) for number in numbers[:-1]]
        except ValueError:
            raise _nonsense("@READ", values) from None

    def _ask(self, command: Command, answers: int, seconds: float) -> list[str]:
        sent = line(command)
        found = self._wire.send(sent, answers, 1.5 * seconds + SECONDS)
        told = sent.decode("ascii").strip()
        match [found[0].strip(), len(found)]:
            case ["1", length] if length == answers:
                return found
            case ["0", _]:
                raise WireError(f"The arm on the wire refused {told}: it answered 0.")
            case ["2", _]:
                raise WireError(f"The stop key of the arm on the wire was pressed, at {told}.")
        raise _nonsense(told.split()[0], found[0])


def speed(rate: float) -> int:
    """The SP that comes nearest to a rate in half-steps a second and is not faster.

    The slowest that there is makes some 45.
    """
    delay = ceil((1000 / rate - _BASE) / _PER_UNIT) if rate > 0 else _SLOW
    return min(FASTEST, speed_of(max(0, delay)))


def _nonsense(word: str, answer: str) -> WireError:
    told = answer if len(answer) <= 40 else f"{answer[:40]}..."
    return WireError(f"What came back over the wire after {word} is no answer: {told!r}.")


def _signed(number: int) -> int:
    """A count as a register of 16 bits holds it."""
    return (number + _WORD // 2) % _WORD - _WORD // 2
