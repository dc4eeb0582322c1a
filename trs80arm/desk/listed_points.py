"""Points read back from a listing: the way back from `taught_programs`, for edited listings too.

A listing in Table 3's style is followed statement by statement as far as it is a list of `@STEP`s
and `@CLOSE`s with numbers, or with variables that are given numbers. Of one in Table 4's style the
DATA lines are read, in the order in which its READ takes them. What is neither is refused with the
number of the line that cannot be read; nothing is guessed.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace

from trs80arm.arm.geometry import OutOfReach
from trs80arm.arm.model import Pose
from trs80arm.desk.jogging import Stance
from trs80arm.desk.taught_programs import HOME, Manner
from trs80arm.desk.teach import Lesson, Position, listing_comment, listing_name

LAST_X = -100.0
"""An X below it ends the DATA lines, as in Table 4's line 309."""


class ListingError(ValueError):
    """A listing that cannot be read back; the message begins with the line's number."""


@dataclass(frozen=True)
class Points:
    """What a listing says.

    Attributes:
        positions: in order.
        manner: the speed of its program, and whether it goes round and round.
    """

    positions: tuple[Position, ...]
    manner: Manner


@dataclass(frozen=True)
class _Statement:
    """A statement, its blanks left out, or a REM as it stands; and the number of its line."""

    line: int
    text: str

    def refused(self, why: str) -> ListingError:
        """The statement cannot be read."""
        return ListingError(f"Line {self.line}: {why}")


def read_points(listing: str, stance: Stance) -> Points:
    """The points of a listing.

    Args:
        listing: the program as text.
        stance: the arm that they are for; registers count from where its registers are zero.

    Raises:
        ListingError: it cannot be read back.
    """
    statements = list(_statements(listing))
    reads = [s for s in statements if re.fullmatch(r"READ[A-Z]\w*(,[A-Z]\w*)+", s.text)]
    if reads and any(statement.text.startswith("DATA") for statement in statements):
        return _Coordinates(statements, stance).read(reads[0])
    return _Steps(stance).read(statements)


def _statements(listing: str) -> Iterator[_Statement]:
    for row in listing.splitlines():
        if not row.strip():
            continue
        match = re.match(r"\s*(\d+) ?(.*)", row)
        if match is None:
            raise ListingError(f"No line number: {row.strip()[:40]}")
        number, rest = int(match[1]), match[2]
        while rest.strip():
            remark = re.match(r"\s*(REM|')(.*)", rest, re.IGNORECASE)
            if remark:
                yield _Statement(number, f"REM {remark[2].strip()}")
                break
            text, rest = _first_statement(rest)
            if text:
                yield _Statement(number, text)


def _first_statement(text: str) -> tuple[str, str]:
    """Up to the first colon outside of quotes, without blanks there; and what follows."""
    found: list[str] = []
    quoted = False
    for place, character in enumerate(text):
        if character == '"':
            quoted = not quoted
        elif character == ":" and not quoted:
            return "".join(found), text[place + 1 :]
        if quoted or character != " ":
            found.append(character if quoted else character.upper())
    return "".join(found), ""


# -- Table 4's style -------------------------------------------------------------------------------


class _Coordinates:
    """Reads DATA lines: X, Y, Z, pitch and roll, what the hand does, and the speed."""

    def __init__(self, statements: Sequence[_Statement], stance: Stance) -> None:
        self._statements = statements
        self._stance = stance

    def read(self, read: _Statement) -> Points:
        """The points; the first row is where the arm is set to begin."""
        width = read.text.count(",") + 1
        if width not in (7, 8):
            raise read.refused(
                "READ takes X, Y, Z, pitch, roll, hand and speed, or with CLOSE before the hand"
            )
        rows = list(self._rows(width))
        if not rows:
            raise ListingError("There is no point in the DATA lines.")
        _, start, _ = rows[0]
        hand = round(start[-2])
        holds, squeeze = False, 0
        points: list[Position] = []
        lesson = Lesson()
        speed = round(start[-1])
        tightened, carried = False, ""
        for number, (statement, row, remark) in enumerate(rows[1:]):
            name, carried = remark or carried, ""
            *place, steps, delay = row
            closes = steps < 0 if width == 7 else place.pop() != 0
            steps = round(steps)
            previous = rows[number][1][:5]
            if holds and not closes and steps < 0 and list(place) == previous and not tightened:
                # The hand tightens before it sets off: that belongs to the next point.
                squeeze -= steps
                tightened, carried = True, name
                continue
            tightened = False
            if closes:
                holds, squeeze = True, max(0, -steps)
            elif holds and steps > squeeze:
                holds, squeeze = False, 0
                _held_by(points, hand - steps)
            elif holds:
                squeeze -= steps
            else:
                hand += steps
            stated = self._registers(statement, place, hand)
            words, _, comment = name.partition(":")
            position = Position(
                listing_name(words) or lesson.free_name(),
                stated.registers,
                stated.pose,
                holds,
                squeeze,
                Position.taken(self._stance).zero,
                listing_comment(comment),
                None if round(delay) == speed else round(delay),
            )
            lesson.insert(position)
            points.append(position)
        if not points:
            raise ListingError("There is one point only, where the arm is set to begin.")
        repeats = not any(
            statement.line == 1000 and statement.text == "GOTO2000"
            for statement in self._statements
        )
        return Points(_without_return(points, repeats), Manner(speed, repeats))

    def _registers(self, statement: _Statement, place: Sequence[float], hand: int) -> Stance:
        x, y, z, pitch, roll = place
        opening = hand / self._stance.model.hand_steps
        try:
            steps = self._stance.steps_to(Pose(x, y, z, pitch, roll, opening))
        except OutOfReach as error:
            raise statement.refused(f"out of reach: {error}") from None
        return self._stance.after(steps)

    def _rows(self, width: int) -> Iterator[tuple[_Statement, list[float], str]]:
        """The rows, each with its statement and the remark before it."""
        values: list[tuple[_Statement, float]] = []
        remark = ""
        for statement in self._statements:
            if statement.text.startswith("REM"):
                remark = statement.text[4:]
            elif statement.text.startswith("DATA"):
                for word in statement.text[4:].split(","):
                    try:
                        values.append((statement, float(word)))
                    except ValueError:
                        raise statement.refused(f"{word[:20]!r} is no number") from None
                while len(values) >= width:
                    row, values = values[:width], values[width:]
                    if row[0][1] < LAST_X:
                        return
                    yield row[0][0], [value for _, value in row], remark
                    remark = ""
                if values and values[0][1] < LAST_X:
                    return
            else:
                remark = ""
        if values:
            raise values[0][0].refused(f"{width} numbers are wanted, {len(values)} are there")


def _held_by(points: list[Position], hand: int) -> None:
    """Say where the register of the hand was in the points just now in which it held something.

    How far a hand closes no listing says, but how far it opens again. It is taken to be as wide
    open then as before it took hold.
    """
    for place in reversed(range(len(points))):
        point = points[place]
        if not point.grips:
            return
        points[place] = replace(point, registers=(*point.registers[:5], hand))


def _without_return(points: Sequence[Position], repeats: bool) -> tuple[Position, ...]:
    """The points without the last one if that only closes the round."""
    first, last = points[0], points[-1]
    closed = first.registers[:5] == last.registers[:5] and first.grips == last.grips
    if repeats and len(points) > 1 and closed:
        return tuple(points[:-1])
    return tuple(points)


# -- Table 3's style -------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Sum:
    """What an expression comes to: a number, and registers with their factors."""

    number: int
    registers: tuple[tuple[int, int], ...] = ()

    def plus(self, other: _Sum, times: int) -> _Sum:
        """This and so many times another one."""
        factors = dict(self.registers)
        for joint, factor in other.registers:
            factors[joint] = factors.get(joint, 0) + times * factor
        left = tuple(sorted((joint, factor) for joint, factor in factors.items() if factor))
        return _Sum(self.number + times * other.number, left)


@dataclass
class _Steps:
    """Follows a program of `@STEP`s, and keeps where the arm is by its registers."""

    stance: Stance
    registers: list[int] = field(init=False)
    variables: dict[str, _Sum] = field(default_factory=dict)
    speed: int = 50
    speed_name: str = "S"
    points: list[Position] = field(default_factory=list)
    holds: bool = False
    squeeze: int = 0
    name: str = ""
    comment: str = ""
    delay: int | None = None
    arm_moved: bool = False
    hand_moved: bool = False
    relative: bool = True
    repeats: bool = False
    begun: dict[int, int] = field(default_factory=dict)
    """How many points come before each line."""
    first: int = 0
    """The point with which a round begins."""

    def __post_init__(self) -> None:
        self.registers = list(self.stance.registers)

    def read(self, statements: Sequence[_Statement]) -> Points:
        """The points.

        Raises:
            ListingError: a statement is none of those that can be read.
        """
        for statement in statements:
            before = len(self.points) + (self.arm_moved or self.hand_moved)
            self.begun.setdefault(statement.line, before)
            if not self._take(statement):
                break
        self._arrive()
        if not self.points:
            raise ListingError("There is no @STEP in the listing.")
        points = tuple(self.points[self.first :])
        if self.repeats:
            kept = _without_return(points, repeats=True)
            if len(kept) == len(points) > 1:
                raise ListingError(
                    f"Line {statement.line}: GOTO goes back, but the arm does not: the steps of a "
                    "round do not add up to nothing"
                )
            points = kept
        return Points(points, Manner(self.speed, self.repeats))

    def _take(self, statement: _Statement) -> bool:
        """Follow a statement; whether the program goes on behind it."""
        text = statement.text
        if text.startswith("REM"):
            self._remark(text[4:])
        elif text.startswith("@STEP"):
            self._step(statement, text[5:])
        elif text.startswith("@CLOSE"):
            self._close()
        elif text.startswith("@READ"):
            self._read(statement, text[5:])
        elif text == "@RESET" and not self.points and not self.arm_moved:
            self.registers = [0] * 6
        elif text.startswith(("PRINT", "CLS")):
            pass
        elif text.startswith(("END", "STOP")):
            return False
        elif match := re.fullmatch(r"GOTO(\d+)", text):
            if int(match[1]) not in self.begun:
                raise statement.refused("GOTO can only go back to begin again")
            # What leads to where the round begins is no part of it.
            self.first = max(0, self.begun[int(match[1])] - 1)
            self.repeats = True
            return False
        elif match := re.fullmatch(r"(?:LET)?(?!FOR)([A-Z][A-Z0-9]*)=(.+)", text):
            value = self._value(statement, match[2])
            self.variables[match[1]] = value
            if match[1] == self.speed_name and not value.registers:
                self.speed = value.number
        else:
            raise statement.refused(
                f"{text[:24]} cannot be read back; what can is @STEP, @CLOSE, and variables that "
                "are given numbers"
            )
        return True

    def _remark(self, text: str) -> None:
        words, _, comment = text.partition(":")
        match = re.fullmatch(r"(?:.* )?TO (.+?)(?: FROM WHEREVER THE ARM IS)?", words.upper())
        if match is None:
            return
        self._arrive()
        self.name, self.comment = listing_name(match[1]), listing_comment(comment)

    def _step(self, statement: _Statement, text: str) -> None:
        first, *words = text.split(",")
        if not first or not words or len(words) > 6:
            raise statement.refused("@STEP is followed by D and one to six numbers of steps")
        delay = self._value(statement, first)
        if delay.registers:
            raise statement.refused(f"{first} is no D")
        values = [self._value(statement, word) for word in words]
        steps = [self._steps(statement, joint, value) for joint, value in enumerate(values)]
        steps += [0] * (6 - len(steps))
        own = None if first == self.speed_name else delay.number
        if any(value.registers for value in values):
            # To registers that are said: where the arm was before does not matter.
            self._arrive()
            self._go(steps, own, even_if_there=True)
        elif any(steps[:5]):
            if self.arm_moved or (self.hand_moved and not (self.holds and self.squeeze)):
                self._arrive()
            if not self.points and not self.arm_moved and self.relative:
                self._begin_here()
            self._go(steps, own)
        else:
            self._hand(steps[5])

    def _begin_here(self) -> None:
        """A program that does not say where it begins begins where the arm is."""
        name, comment, self.name, self.comment = self.name, self.comment, HOME, ""
        self.holds = self.stance.switch_closed
        self.arm_moved = True
        self._arrive()
        self.name, self.comment = name, comment

    def _go(self, steps: Sequence[int], delay: int | None, even_if_there: bool = False) -> None:
        self.registers = [at + step for at, step in zip(self.registers, steps, strict=True)]
        self.arm_moved = even_if_there or any(steps)
        self.delay = delay
        self.relative = False

    def _close(self) -> None:
        if self.holds:
            return
        if not self.points and not self.arm_moved and self.relative:
            self._begin_here()
        self.holds, self.squeeze, self.hand_moved = True, 0, True
        self.relative = False

    def _hand(self, steps: int) -> None:
        if not self.points and not self.arm_moved and self.relative:
            self._begin_here()
        self.relative = False
        if not steps:
            return
        self.hand_moved = True
        if self.holds and steps <= self.squeeze:
            self.squeeze -= steps
        elif self.holds:
            self.holds, self.squeeze = False, 0
            _held_by(self.points, self.registers[5] - steps)
        else:
            self.registers[5] += steps

    def _read(self, statement: _Statement, text: str) -> None:
        names = text.split(",")
        if len(names) > 6 or not all(re.fullmatch(r"[A-Z][A-Z0-9]*", name) for name in names):
            raise statement.refused("@READ is followed by up to six variables")
        for joint, name in enumerate(names):
            self.variables[name] = _Sum(0, ((joint, 1),))

    def _arrive(self) -> None:
        """A point is complete."""
        if not (self.arm_moved or self.hand_moved):
            return
        a, b, c, d, e, f = self.registers
        lesson = Lesson()
        lesson.replace(self.points)
        stance = self.stance.at((a, b, c, d, e, f))
        self.points.append(
            Position(
                self.name or lesson.free_name(),
                stance.registers,
                stance.pose,
                self.holds,
                self.squeeze,
                Position.taken(self.stance).zero,
                self.comment,
                self.delay,
            )
        )
        self.name = self.comment = ""
        self.delay = None
        self.arm_moved = self.hand_moved = False

    def _steps(self, statement: _Statement, joint: int, value: _Sum) -> int:
        """How far a joint goes: a number, or a number less the register of that joint."""
        if not value.registers:
            return value.number
        if value.registers != ((joint, -1),):
            raise statement.refused(f"the steps of J{joint + 1} hang on the registers")
        return value.number - self.registers[joint]

    def _value(self, statement: _Statement, text: str) -> _Sum:
        """An expression of numbers and variables with plus, minus and times."""
        if not re.fullmatch(r"[-+]?[A-Z0-9]+(?:[-+*][A-Z0-9]+)*", text):
            raise statement.refused(f"{text[:24]} is no whole number")
        total = _Sum(0)
        for sign, term in re.findall(r"([-+]?)([A-Z0-9]+(?:\*[A-Z0-9]+)*)", text):
            total = total.plus(self._product(statement, term), -1 if sign == "-" else 1)
        return total

    def _product(self, statement: _Statement, term: str) -> _Sum:
        factors = [self._factor(statement, word) for word in term.split("*")]
        if len(factors) == 1:
            return factors[0]
        if any(factor.registers for factor in factors):
            raise statement.refused(f"{term[:24]} multiplies a register")
        return _Sum(math.prod(factor.number for factor in factors))

    def _factor(self, statement: _Statement, word: str) -> _Sum:
        if word.isdecimal():
            return _Sum(int(word))
        if word not in self.variables:
            raise statement.refused(f"{word[:24]} is given no number before")
        return self.variables[word]
