"""What shall be where at the end, and how well it was done: goals of a bench and their score.

A score is computed from where the parts truly are, at any moment, and changes nothing. Inches and
degrees; places are those of the middle of a part's description, as in a bench file.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase
from typing import Any

from trs80arm.arm.contact.rotations import about, apply, matrix
from trs80arm.arm.contact.table import TABLE
from trs80arm.arm.fixtures import Part, Tray
from trs80arm.arm.linkage import fixed_name

Place = tuple[float, ...]
"""x and y, or x, y and the height of the middle, inches."""

UPRIGHT, FALLEN = "upright", "fallen"
LEANING = 45.0
"""Degrees of a part's own vertical to the vertical beyond which it has fallen."""
THE_TABLE = "table"
"""What a goal calls the table on which something stands."""
ROUND = 24
"""A part that looks the same after so small a part of a turn has no turn."""
_TURNS = (ROUND, 12, 8, 6, 5, 4, 3, 2)
_SAME = 1e-6
"""Inches by which corners may differ for a part to look the same."""


@dataclass(frozen=True)
class Mark:
    """How well one thing was done.

    Attributes:
        goal: what was asked for, in words.
        part: name of the part that it was judged by; empty if there was none.
        met: whether it was done.
        error: inches from where it belongs; None where no place was asked for, or nothing came.
        turned: degrees from how it was to be turned; None where that was not asked for.
        found: what else is to be said, in words; empty if nothing is.
    """

    goal: str
    part: str
    met: bool
    error: float | None = None
    turned: float | None = None
    found: str = ""

    @property
    def told(self) -> list[str]:
        """What is to be said beside goal and figures: which part it was, and what was found."""
        part = self.part if self.part and self.part not in self.goal else ""
        return [word for word in (part, self.found) if word]

    def plain(self) -> dict[str, Any]:
        """The same as JSON holds it."""
        return {
            "goal": self.goal,
            "part": self.part,
            "met": self.met,
            "error": self.error,
            "turned": self.turned,
            "found": self.found,
        }


@dataclass(frozen=True)
class Score:
    """How well all goals of a bench were done.

    Attributes:
        marks: one for each place and each part, in the order of the bench file.
    """

    marks: tuple[Mark, ...]

    @property
    def met(self) -> int:
        """How many were done."""
        return sum(mark.met for mark in self.marks)

    @property
    def total(self) -> int:
        """How many there are."""
        return len(self.marks)

    @property
    def perfect(self) -> bool:
        """Whether all were done."""
        return self.met == self.total

    @property
    def errors(self) -> list[float]:
        """Inches from where they belong, of all parts that belong somewhere and are there."""
        return [mark.error for mark in self.marks if mark.error is not None]

    @property
    def headline(self) -> str:
        """All of it in one line."""
        if not self.marks:
            return "This bench has no goals."
        line = f"{self.met} of {self.total} goal{'' if self.total == 1 else 's'} met"
        errors = self.errors
        if errors:
            mean = sum(errors) / len(errors)
            line += f"; error {mean:.3f} in on average, {max(errors):.3f} in at most"
        return line

    @property
    def rows(self) -> list[str]:
        """A line for each mark, in columns."""
        if not self.marks:
            return []
        columns = [
            [("met" if mark.met else "NOT") for mark in self.marks],
            [mark.goal for mark in self.marks],
            ["" if mark.error is None else f"{mark.error:6.3f} in" for mark in self.marks],
            ["" if mark.turned is None else f"{mark.turned:5.1f} deg" for mark in self.marks],
            [", ".join(mark.told) for mark in self.marks],
        ]
        wide = [max(map(len, column)) for column in columns]
        return [
            "  ".join(
                word.ljust(width) for word, width in zip(row, wide, strict=True) if width
            ).rstrip()
            for row in zip(*columns, strict=True)
        ]

    def text(self) -> str:
        """A table to be read: a line for each mark and the headline below it."""
        return "\n".join([*self.rows, self.headline])

    def plain(self) -> dict[str, Any]:
        """The same as JSON holds it."""
        errors = self.errors
        return {
            "met": self.met,
            "total": self.total,
            "mean_error": sum(errors) / len(errors) if errors else None,
            "largest_error": max(errors, default=None),
            "marks": [mark.plain() for mark in self.marks],
        }


@dataclass(frozen=True)
class PartGoal:
    """That parts are somewhere, or somehow, at the end.

    With places, each of them wants a part, and has the one that is nearest; without, all the parts
    that are meant have to be as the goal says. What the hand holds is not where it belongs yet.

    Attributes:
        part: name of the parts that are meant, or a pattern as `block *`.
        places: where they belong.
        tolerance: inches by which they may be off.
        area: x, y, width along x and depth along y of where their middles belong, or None.
        turn: degrees about the vertical, counter-clockwise from above, or None.
        turn_tolerance: degrees by which they may be off.
        posture: `UPRIGHT`, `FALLEN`, or empty.
        on: what they stand on: a part, an obstacle or `THE_TABLE`; empty if that does not matter.
    """

    part: str
    places: tuple[Place, ...] = ()
    tolerance: float = 0.1
    area: tuple[float, float, float, float] | None = None
    turn: float | None = None
    turn_tolerance: float = 5.0
    posture: str = ""
    on: str = ""

    def marks(self, parts: Mapping[str, Part], trays: Sequence[Tray]) -> Iterator[Mark]:
        """How well it was done, for each place or part."""
        meant = {name: part for name, part in parts.items() if fnmatchcase(name, self.part)}
        if self.places:
            chosen = _assigned(self.places, meant)
            for place, name in zip(self.places, chosen, strict=True):
                error = None if name is None else _away(meant[name], place)
                yield self._mark(name, parts, place, error)
        elif not meant:
            yield self._mark(None, parts)
        else:
            for name, part in meant.items():
                error = None if self.area is None else _outside(part, self.area)
                yield self._mark(name, parts, None, error)

    def _mark(
        self,
        name: str | None,
        parts: Mapping[str, Part],
        place: Place | None = None,
        error: float | None = None,
    ) -> Mark:
        goal = self._words(name or self.part, place)
        if name is None:
            return Mark(goal, "", False, found="there is none")
        part = parts[name]
        turned = None if self.turn is None else _turned(part, self.turn)
        found = []
        if part.held:
            found.append("in the hand")
        if self.posture and (self.posture == FALLEN) != _fallen(part):
            found.append(f"is {UPRIGHT if self.posture == FALLEN else FALLEN}")
        if self.on and not _stands_on(part, self.on, parts):
            found.append("not on it")
        met = (
            not found
            and (error is None or error <= (self.tolerance if self.area is None else 0.0))
            and (turned is None or turned <= self.turn_tolerance)
        )
        return Mark(goal, name, met, error, turned, ", ".join(found))

    def _words(self, name: str, place: Place | None) -> str:
        """What is asked for of one part."""
        words = [self.part if place is not None else name]
        if place is not None:
            words.append(f"at ({', '.join(f'{value:g}' for value in place)})")
        if self.area is not None:
            x, y, width, depth = self.area
            words.append(f"in {width:g} x {depth:g} at ({x:g}, {y:g})")
        if self.turn is not None:
            words.append(f"turned {self.turn:g}")
        words += [self.posture] * bool(self.posture)
        words += [f"on {self.on}"] * bool(self.on)
        return " ".join(words)


@dataclass(frozen=True)
class TrayGoal:
    """That a tray has taken so many parts.

    Attributes:
        tray: its name.
        count: how many, at least.
    """

    tray: str
    count: int

    def marks(self, parts: Mapping[str, Part], trays: Sequence[Tray]) -> Iterator[Mark]:
        """How well it was done."""
        taken = sum(tray.taken for tray in trays if tray.name == self.tray)
        yield Mark(
            f"{self.count} in {self.tray}", "", taken >= self.count, found=f"it took {taken}"
        )


Goal = PartGoal | TrayGoal


def score(goals: Sequence[Goal], parts: Mapping[str, Part], trays: Sequence[Tray]) -> Score:
    """How well some goals were done.

    Args:
        goals: of a bench.
        parts: by name, where they are now.
        trays: with what they took.
    """
    return Score(tuple(mark for goal in goals for mark in goal.marks(parts, trays)))


def _assigned(places: Sequence[Place], parts: Mapping[str, Part]) -> list[str | None]:
    """The part that each place has: the nearest pairs first, each part in one place."""
    pairs = sorted(
        (_away(part, place), number, name)
        for number, place in enumerate(places)
        for name, part in parts.items()
    )
    chosen: dict[int, str] = {}
    for _, number, name in pairs:
        if number not in chosen and name not in chosen.values():
            chosen[number] = name
    return [chosen.get(number) for number in range(len(places))]


def _away(part: Part, place: Place) -> float:
    """Inches from the middle of a part to a place, as seen from above if it has no height."""
    return math.dist(part.origin[: len(place)], place)


def _outside(part: Part, area: tuple[float, float, float, float]) -> float:
    """Inches from the middle of a part to an area; 0 within."""
    x, y, width, depth = area
    across = max(0.0, abs(part.origin[0] - x) - width / 2)
    return math.hypot(across, max(0.0, abs(part.origin[1] - y) - depth / 2))


def _fallen(part: Part) -> bool:
    """Whether a part's own vertical is far from the vertical."""
    return part.upwards[2] < math.cos(math.radians(LEANING))


def _turned(part: Part, turn: float) -> float:
    """Degrees by which a part is turned otherwise, as far as one can see it."""
    m = matrix(part.turn)
    off = math.degrees(math.atan2(m[3], m[0])) - turn
    alike = 360.0 / _symmetry(part)
    return 0.0 if alike <= 360.0 / ROUND else abs((off + alike / 2) % alike - alike / 2)


def _symmetry(part: Part) -> int:
    """How many times a part looks the same in a whole turn about its own vertical."""
    x, y, z = part.shape.offset
    corners = [(u - x, v - y, w - z) for solid in part.shape.solids for u, v, w in solid.vertices]
    for times in _TURNS:
        turn = matrix(about((0.0, 0.0, 1.0), 360.0 / times))
        moved = [apply(turn, corner) for corner in corners]
        if all(any(math.dist(at, corner) < _SAME for corner in corners) for at in moved):
            return times
    return 1


def _stands_on(part: Part, name: str, parts: Mapping[str, Part]) -> bool:
    """Whether a part that is at rest touches something, and is above it."""
    if name == THE_TABLE:
        return TABLE in part.touching
    other = parts.get(name)
    if other is None:
        return fixed_name(name) in part.touching
    met = name in part.touching or part.name in other.touching
    return met and part.origin[2] > other.origin[2]
