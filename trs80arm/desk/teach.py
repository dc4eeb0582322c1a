"""The positions taught in a session: a list that can be named, edited and put in another order.

The article's Table 3 keeps its four positions in the variables A1 to D5. This keeps any number of
them, with the registers as the machine counted them and the pose as it truly was, and
`taught_programs.py` makes a program for the real machine of them.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Protocol

from trs80arm.arm.geometry import JointAngles
from trs80arm.arm.model import ArmModel
from trs80arm.rig import Counts, Pose

REGISTER_SPAN = 1 << 16
SAME_ZERO = 0.004
"""Radians by which the zeros of two positions may differ: less than a motor's loss of one ring."""
MOST_NAME = 24
"""Characters of a name; a listing's REM holds it."""
MOST_COMMENT = 60
"""Characters of a comment, which stands behind the name."""
MOST_DELAY = 32767
"""The largest D of a `@STEP`."""


class Standing(Protocol):
    """How arm and registers stand at the moment of teaching."""

    @property
    def model(self) -> ArmModel:
        """What make of arm it is."""

    @property
    def registers(self) -> Sequence[int]:
        """J1 to J6, half-steps."""

    @property
    def angles(self) -> JointAngles:
        """The joints' true angles, radians."""

    @property
    def pose(self) -> Pose:
        """Where the fingertip truly is."""

    @property
    def force(self) -> float:
        """Of the grip, pounds."""

    @property
    def switch_closed(self) -> bool:
        """Whether the grip switch is closed."""


@dataclass(frozen=True)
class Position:
    """One position of the arm, as taught.

    Attributes:
        name: capital letters, as it will stand in the listing.
        registers: J1 to J6, half-steps from where they were last zero.
        pose: of the fingertip, as it truly was.
        grips: whether the hand holds something here; it then closes by `@CLOSE` on arrival.
        squeeze: half-steps by which it closes on beyond the grip switch.
        zero: base, upper arm, forearm and wrist gears, radians, where the registers were zero,
            going by the registers; empty for a position that was not taught.
        comment: a word on it, capital letters as the name.
        delay: the D of the `@STEP` that leads to it; None for that of the program.
    """

    name: str
    registers: Counts
    pose: Pose
    grips: bool = False
    squeeze: int = 0
    zero: tuple[float, ...] = ()
    comment: str = ""
    delay: int | None = None

    @classmethod
    def taken(cls, standing: Standing, name: str = "") -> Position:
        """The position in which the arm is now."""
        hand = standing.model.hand
        beyond = max(0.0, standing.force - hand.switch_force)
        grips = standing.switch_closed
        return cls(
            name,
            _six(standing.registers),
            standing.pose,
            grips,
            round(beyond * hand.pound_steps) if grips else 0,
            _zero(standing),
        )

    def same_zero(self, zero: Sequence[float]) -> bool:
        """Whether its registers count from there; one that was not taught counts from anywhere."""
        return not self.zero or all(
            abs(here - there) <= SAME_ZERO for here, there in zip(self.zero, zero, strict=True)
        )


def steps_between(start: Counts, end: Counts) -> Counts:
    """The commanded steps from one reading of the registers to another.

    Registers are 16 bits wide and wrap around.
    """
    half = REGISTER_SPAN // 2
    a, b, c, d, e, f = (
        (stop - begin + half) % REGISTER_SPAN - half for begin, stop in zip(start, end, strict=True)
    )
    return a, b, c, d, e, f


class Lesson:
    """The positions taught, in the order in which the arm shall visit them."""

    def __init__(self) -> None:
        self._positions: list[Position] = []
        self._written: list[Position] = []

    def __len__(self) -> int:
        return len(self._positions)

    @property
    def positions(self) -> Sequence[Position]:
        """What was taught, in order."""
        return tuple(self._positions)

    @property
    def unwritten(self) -> bool:
        """Whether there are positions of which no program was written."""
        return bool(self._positions) and self._positions != self._written

    def written(self) -> None:
        """Say that a program of the positions was written, or put into the machine."""
        self._written = list(self._positions)

    def add(self, standing: Standing, name: str = "", place: int | None = None) -> Position:
        """Teach the position in which the arm is now.

        Args:
            standing: how arm and registers stand.
            name: what it is called; the next free letter if empty.
            place: where in the list; at its end if None.
        """
        position = Position.taken(standing, listing_name(name) or self.free_name())
        self.insert(position, place)
        return position

    def insert(self, position: Position, place: int | None = None) -> None:
        """Put a position into the list, at its end if no place is said."""
        self._positions.insert(len(self) if place is None else place, position)

    def put(self, place: int, position: Position) -> None:
        """Have another position in the place of one."""
        self._positions[place] = position

    def replace(self, positions: Sequence[Position]) -> None:
        """Have these positions and no others."""
        self._positions = list(positions)

    def rename(self, place: int, name: str) -> None:
        """Call a position something else; an empty name changes nothing."""
        cleaned = listing_name(name)
        if cleaned:
            self._positions[place] = replace(self._positions[place], name=cleaned)

    def teach_again(self, place: int, standing: Standing) -> None:
        """Have an older position be where the arm is now; its name and the words on it stay."""
        older = self._positions[place]
        self._positions[place] = replace(
            Position.taken(standing, older.name), comment=older.comment, delay=older.delay
        )

    def comment(self, place: int, text: str) -> None:
        """Have another word on a position, or none."""
        self._positions[place] = replace(self._positions[place], comment=listing_comment(text))

    def set_delay(self, place: int, delay: int | None) -> None:
        """Have a D of its own for the `@STEP` to a position; None for the program's.

        Raises:
            ValueError: it is no D.
        """
        if delay is not None and not 0 <= delay <= MOST_DELAY:
            raise ValueError(f"D is a number from 0 to {MOST_DELAY}")
        self._positions[place] = replace(self._positions[place], delay=delay)

    def set_registers(self, place: int, registers: Sequence[int]) -> None:
        """Change the register values of a position.

        The pose stays what it was when the position was taught.

        Raises:
            ValueError: they are not six numbers of 16 bits.
        """
        half = REGISTER_SPAN // 2
        if len(registers) != 6 or not all(-half <= value < half for value in registers):
            raise ValueError("six numbers from -32768 to 32767 are needed")
        self._positions[place] = replace(self._positions[place], registers=_six(registers))

    def set_grip(self, place: int, grips: bool, squeeze: int = 0) -> None:
        """Say whether the hand closes at a position, and how many steps beyond the switch."""
        self._positions[place] = replace(
            self._positions[place], grips=grips, squeeze=max(0, squeeze) if grips else 0
        )

    def move(self, place: int, by: int) -> int:
        """Move a position earlier (negative) or later in the list.

        Returns:
            Where it is now.
        """
        target = min(max(place + by, 0), len(self._positions) - 1)
        self._positions.insert(target, self._positions.pop(place))
        return target

    def remove(self, place: int) -> None:
        """Take a position off the list."""
        del self._positions[place]

    def clear(self) -> None:
        """Forget all positions."""
        self._positions.clear()

    def strays(self) -> list[str]:
        """The names of positions whose registers count from elsewhere than the first one's.

        Their differences lead nowhere: there was a `@RESET` in between, or a motor had slipped, or
        the arm was moved by hand.
        """
        taught = [position for position in self._positions if position.zero]
        return [p.name for p in taught if not p.same_zero(taught[0].zero)]

    def free_name(self) -> str:
        """The first letter that no position has for a name."""
        names = {position.name for position in self._positions}
        count = 0
        while (name := _letters(count)) in names:
            count += 1
        return name


def _zero(standing: Standing) -> tuple[float, ...]:
    turned = standing.model.turned(standing.registers)
    return tuple(now - by for now, by in zip(standing.angles.driven, turned, strict=True))


def listing_name(text: str) -> str:
    """A name as a listing of the machine can hold it: capitals, figures and plain signs."""
    return _in_listing(text, MOST_NAME)


def listing_comment(text: str) -> str:
    """A comment as a listing can hold it: as a name, but longer."""
    return _in_listing(text, MOST_COMMENT)


def _in_listing(text: str, most: int) -> str:
    return re.sub(r"[^ -!#-9;-Z]", "", text.upper()).strip()[:most]


def _letters(count: int) -> str:
    """A to Z, then A1 to Z1, A2 and so on."""
    turn, letter = divmod(count, 26)
    return chr(ord("A") + letter) + (str(turn) if turn else "")


def _six(values: Sequence[int]) -> Counts:
    a, b, c, d, e, f = values
    return a, b, c, d, e, f
