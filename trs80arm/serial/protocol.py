"""The TeachMover's language: a line to a command and back, and what is answered.

Commands are ASCII and end in CR; what is understood of a line is written down in `docs/serial.md`,
with where it is known from. Reading is total: any bytes are a command or none, and who sends none
is answered with an error.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from trs80arm.serial.memory import Row, row_of

DELIMITER = "@"
"""What every command begins with until `@ARM` chooses another character."""
END = b"\r"

DONE = b"1" + END
"""The command was carried out."""
REFUSED = b"0" + END
"""It was no command, and nothing was done."""
STOPPED = b"2" + END
"""The pendant's stop key broke it off, or kept it from being begun."""

FASTEST = 245
"""The greatest speed SP; the slowest is 0."""
USUAL_SPEED = 221
"""SP where none is given: what the client of course ELE418 takes for a close without one."""
LONGEST_DELAY = 1000
"""The most milliseconds that `@DELAY` puts after a character; chosen."""

_FARTHEST = 32767
_NUMBER = re.compile(r"(?P<sign>[+-]?)(?=\.?[0-9])(?P<whole>[0-9]*)(?:\.[0-9]*)?")
_SHAPE = re.compile(r"[ \t\n]*([A-Za-z]{3})[A-Za-z]*(.*)", re.DOTALL)
_BLANKS = " \t\n"


@dataclass(frozen=True)
class Step:
    """`@STEP SP,J1..J6[,OUT]`: all motors move together by so many half-steps.

    Attributes:
        speed: SP, 0 to 245.
        steps: six relative counts, each -32768 to 32767.
        output: OUT as it was sent, any whole number; None where there is none.
    """

    speed: int
    steps: tuple[int, int, int, int, int, int]
    output: int | None = None


@dataclass(frozen=True)
class Close:
    """`@CLOSE [SP]`: the hand closes until the grip switch does."""

    speed: int = USUAL_SPEED


@dataclass(frozen=True)
class ByHand:
    """`@SET [SP]`: the pendant moves the arm until one of its function keys is pressed."""

    speed: int = USUAL_SPEED


@dataclass(frozen=True)
class Reset:
    """`@RESET`: registers to zero, motors without current."""


@dataclass(frozen=True)
class Read:
    """`@READ`: the registers, the last key, the inputs."""


@dataclass(frozen=True)
class Dump:
    """`@QDUMP`: the rows of the memory."""


@dataclass(frozen=True)
class Write:
    """`@QWRITE`: one row into the memory."""

    row: Row


@dataclass(frozen=True)
class Run:
    """`@RUN`: the program in the memory."""


@dataclass(frozen=True)
class Arm:
    """`@ARM`: the character that commands begin with from now on."""

    delimiter: str


@dataclass(frozen=True)
class Delay:
    """`@DELAY`: milliseconds of rest after each character of an answer."""

    milliseconds: int


Command: TypeAlias = Step | Close | ByHand | Reset | Read | Dump | Write | Run | Arm | Delay


def parse(line: bytes, delimiter: str = DELIMITER) -> Command | None:
    """What a line asks for; None if it is no command.

    Args:
        line: the bytes before the CR. What comes before the delimiter is passed over.
        delimiter: the character that commands begin with.
    """
    _, found, rest = line.decode("latin-1").partition(delimiter)
    shape = _SHAPE.fullmatch(rest) if found else None
    if shape is None:
        return None
    word, arguments = shape[1].upper(), shape[2].strip(_BLANKS)
    if word == "ARM":
        return Arm(arguments) if can_delimit(arguments) else None
    numbers = _numbers(arguments)
    return None if numbers is None else _command(word, numbers)


def can_delimit(text: str) -> bool:
    """Whether a text is one character that commands can begin with: printed, and no comma."""
    return len(text) == 1 and "!" <= text <= "~" and text != ","


def _command(word: str, numbers: list[int | None]) -> Command | None:
    """The command of a word, the first three letters of it, and its arguments."""
    match word:
        case "STE":
            return _step(numbers)
        case "CLO":
            speed = _speed(numbers)
            return None if speed is None else Close(speed)
        case "SET":
            speed = _speed(numbers)
            return None if speed is None else ByHand(speed)
        case "RES":
            return Reset()
        case "REA":
            return Read()
        case "QDU":
            return Dump()
        case "RUN":
            return Run()
        case "QWR":
            row = row_of(numbers)
            return None if row is None else Write(row)
        case "DEL":
            pause = numbers[0] if numbers else 0
            return Delay(pause) if pause is not None and 0 <= pause <= LONGEST_DELAY else None
    return None


def _step(numbers: list[int | None]) -> Step | None:
    """`@STEP`: SP and six counts, those left out 0; at least one argument, OUT the eighth."""
    if not 1 <= len(numbers) <= 8:
        return None
    speed = _speed(numbers)
    counts = [number or 0 for number in (numbers + [None] * 6)[1:7]]
    if speed is None or not all(-_FARTHEST - 1 <= count <= _FARTHEST for count in counts):
        return None
    j1, j2, j3, j4, j5, j6 = counts
    return Step(speed, (j1, j2, j3, j4, j5, j6), numbers[7] if len(numbers) == 8 else None)


def _speed(numbers: list[int | None]) -> int | None:
    """The first argument as SP, the usual one where it is left out; None if SP cannot be that."""
    speed = numbers[0] if numbers else None
    if speed is None:
        return USUAL_SPEED
    return speed if 0 <= speed <= FASTEST else None


def _numbers(text: str) -> list[int | None] | None:
    """The arguments, None for one that is left out; None for all if one is no number."""
    numbers: list[int | None] = []
    for piece in text.split(","):
        argument = piece.strip(_BLANKS)
        found = _NUMBER.fullmatch(argument)
        if argument and not found:
            return None
        numbers.append(_whole(found) if found else None)
    while numbers and numbers[-1] is None:
        numbers.pop()
    return numbers


def _whole(number: re.Match[str]) -> int:
    """A number without its fraction, which is cut off."""
    size = int(number["whole"] or 0)
    return -size if number["sign"] == "-" else size


def line(command: Command, delimiter: str = DELIMITER) -> bytes:
    """A command as a client sends it, with its CR; `parse` reads it back."""
    return (delimiter + _words(command)).encode("ascii") + END


def _words(command: Command) -> str:
    match command:
        case Step(speed, steps, output):
            return "STEP " + _joined((speed, *steps) + (() if output is None else (output,)))
        case Close(speed):
            return f"CLOSE {speed}"
        case ByHand(speed):
            return f"SET {speed}"
        case Reset():
            return "RESET"
        case Read():
            return "READ"
        case Dump():
            return "QDUMP"
        case Write(row):
            return "QWRITE " + _joined(row)
        case Run():
            return "RUN"
        case Arm(delimiter):
            return f"ARM {delimiter}"
        case Delay(milliseconds):
            return f"DELAY {milliseconds}"


def _joined(numbers: Iterable[int]) -> str:
    return ",".join(map(str, numbers))


def reading(counts: Sequence[int], key: int, inputs: int) -> bytes:
    """The answer to `@READ`.

    Args:
        counts: the six registers.
        key: code of the last key of the pendant, 0 to 14.
        inputs: the input byte.
    """
    return DONE + _joined((*counts, key * 256 + inputs)).encode("ascii") + END


def dump(rows: Iterable[Row]) -> bytes:
    """The answer to `@QDUMP`."""
    return DONE + b"".join(_joined(row).encode("ascii") + END for row in rows)
