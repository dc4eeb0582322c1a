"""Who is awake, what is carried, and what lies where asleep: found without asking everybody.

The table is divided into squares, each with the sleepers that reach into it: looking for what is
near costs as much as there are squares and sleepers near, however many there are in all.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from trs80arm.arm.contact.bodies import Body
from trs80arm.arm.shapes import Vector

SQUARE = 2.0
"""Side of a square, inches."""

Square = tuple[int, int]


class Roster:
    """The loose bodies of a scene by what they do.

    Attributes:
        awake: those that are not asleep.
        carried: those that rest in the hand.
        leaning: names of those that touched a thing when they fell asleep, by its name.
    """

    def __init__(self) -> None:
        self.awake: dict[str, Body] = {}
        self.carried: dict[str, Body] = {}
        self.leaning: dict[str, set[str]] = {}
        self._numbers: dict[str, int] = {}
        self._next = 0
        self._squares: dict[Square, dict[str, Body]] = {}
        self._filed: dict[str, list[Square]] = {}

    def enter(self, body: Body) -> None:
        """From now on know where a body is."""
        self._numbers[body.name] = self._next
        self._next += 1
        body.watch(self)
        self.lean(body, ())

    def strike(self, body: Body) -> None:
        """Forget a body."""
        body.watch(None)
        self._lean_no_more(body.name, body.touching)
        self._take(body.name)
        self.awake.pop(body.name, None)
        self.carried.pop(body.name, None)
        del self._numbers[body.name]

    def file(self, body: Body) -> None:
        """Take note that a body is awake, carried or elsewhere."""
        name = body.name
        self._take(name)
        self.awake.pop(name, None)
        self.carried.pop(name, None)
        if not body.asleep:
            self.awake[name] = body
        if body.carried is not None:
            self.carried[name] = body
        elif body.asleep:
            (x, y, _), r = body.place, body.shape.radius
            self._filed[name] = squares = _squares(x - r, y - r, x + r, y + r)
            for square in squares:
                self._squares.setdefault(square, {})[name] = body

    def lean(self, body: Body, before: Sequence[str]) -> None:
        """Take note of what a body touches in its sleep, and what it touched before."""
        self._lean_no_more(body.name, before)
        for thing in body.touching:
            self.leaning.setdefault(thing, set()).add(body.name)

    def _lean_no_more(self, name: str, things: Sequence[str]) -> None:
        for thing in things:
            here = self.leaning[thing]
            here.discard(name)
            if not here:
                del self.leaning[thing]

    def _take(self, name: str) -> None:
        for square in self._filed.pop(name, ()):
            here = self._squares[square]
            del here[name]
            if not here:
                del self._squares[square]

    def near(self, low: Vector, high: Vector) -> list[Body]:
        """What sleeps, and is not carried, in or about an upright box; as it came to the scene."""
        found: dict[str, Body] = {}
        if not self._squares:
            return []
        left, right = math.floor(low[0] / SQUARE), math.floor(high[0] / SQUARE)
        front, back = math.floor(low[1] / SQUARE), math.floor(high[1] / SQUARE)
        if len(self._squares) <= (right - left + 1) * (back - front + 1):
            # There are fewer squares with anything in them than there are in the box.
            for (column, row), here in self._squares.items():
                if left <= column <= right and front <= row <= back:
                    found.update(here)
        else:
            for square in _squares(low[0], low[1], high[0], high[1]):
                found.update(self._squares.get(square, {}))
        return self.ordered(found.values())

    def ordered(self, bodies: Iterable[Body]) -> list[Body]:
        """Bodies as they came to the scene."""
        found = list(bodies)
        return found if len(found) < 2 else sorted(found, key=lambda body: self._numbers[body.name])


def _squares(left: float, front: float, right: float, back: float) -> list[Square]:
    """The squares that a rectangle reaches into."""
    columns = range(math.floor(left / SQUARE), math.floor(right / SQUARE) + 1)
    rows = range(math.floor(front / SQUARE), math.floor(back / SQUARE) + 1)
    return [(column, row) for column in columns for row in rows]
