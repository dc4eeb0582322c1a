"""Going on as before: what moves slowly and steadily need not be solved again in every step.

Of a row of parts that the arm pushes along, every step's velocities are those of the step before,
as long as none of its contacts opens, closes or shifts. What moves slowly follows the arm: when
that goes half as far in a step, so does all that it pushes.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from trs80arm.arm.contact.contacts import Mobile
from trs80arm.arm.contact.distance import boxes_apart, separation
from trs80arm.arm.contact.manifold import Placed
from trs80arm.arm.contact.patch import CREEP, DRIFT
from trs80arm.arm.shapes import Vector, cross, dot, minus, plus

MOST_STEPS = 32
"""Steps done with the same velocities, at most."""
ASTRAY = 0.01
"""Inches by which a point of the arm may leave the course that it had when it was looked at."""
FASTEST = 1.5
"""How many times as far as before the arm may go in a step."""
EVEN, UNEVEN = 0.03, 0.05
"""Inches a second, and part of the speed, by which a velocity may change and be the same."""
TOGETHER = 0.01
"""Inches a second by which what moves with something may seem to move otherwise."""
BEND = 0.003
"""Inches by which what goes straight may leave an arc."""


@dataclass(frozen=True, slots=True)
class Move:
    """A body that goes on.

    Attributes:
        name: of the body.
        velocity: inches a second.
        spin: radians a second.
        driven: whether it moves as far as the arm does, or on by itself.
    """

    name: str
    velocity: Vector
    spin: Vector
    driven: bool


@dataclass(slots=True)
class Coast:
    """What goes on as before.

    Attributes:
        course: how far the arm's coordinates went in the step that goes on.
        start: commands at its end.
        levers: inches that some point of the arm moves at most for a unit of each coordinate.
        gives: how far each coordinate was behind its command.
        moves: of all that is awake.
        steps: of the same kind for which nothing changes, at most.
        gone: steps gone so far.
        way: how far the arm has gone, as a multiple of its course.
    """

    course: list[float]
    start: list[float]
    levers: list[float]
    gives: list[float]
    moves: list[Move]
    steps: float
    gone: int = 0
    way: float = 0.0

    def share(self, commands: Sequence[float]) -> float | None:
        """How much of its course the arm has gone since last asked; None: look at all again."""
        self.gone += 1
        ahead = [to - at for to, at in zip(commands, self.start, strict=True)]
        square = _weighed(self.levers, self.course, self.course)
        if square == 0:
            return 1.0 if not any(ahead) and self.gone <= self.steps else None
        before, self.way = self.way, _weighed(self.levers, ahead, self.course) / square
        share = self.way - before
        off = max(
            lever * abs(a - self.way * c)
            for lever, a, c in zip(self.levers, ahead, self.course, strict=True)
        )
        if not 0 < share <= FASTEST or off > ASTRAY or max(self.gone, self.way) > self.steps:
            return None
        return share


def _weighed(levers: Sequence[float], one: Sequence[float], other: Sequence[float]) -> float:
    """Product of two ways of the arm, in square inches."""
    total = 0.0
    for lever, a, b in zip(levers, one, other, strict=True):
        total += lever * a * lever * b
    return total


def pace(levers: Sequence[float], before: Sequence[float], now: Sequence[float]) -> float:
    """How many times as far the arm went in a step as in another."""
    square = _weighed(levers, before, before)
    return _weighed(levers, before, now) / square if square > 0 else 1.0


def even(mobile: Mobile, radius: float, pace: float) -> bool:
    """Whether a body goes on as it went, but for how fast the arm goes.

    Args:
        mobile: the body as solved, with its velocities before.
        radius: of the sphere around it.
        pace: how much faster the arm goes than before.
    """
    change = moving = 0.0
    assert mobile.before is not None
    for k, (now, before) in enumerate(zip(mobile.speed, mobile.before, strict=True)):
        size = radius if k > 2 else 1.0
        change = max(change, size * abs(now - pace * before))
        moving = max(moving, size * abs(now))
    return change <= EVEN + UNEVEN * moving


@dataclass(slots=True)
class Mover:
    """Something for as long as it goes on as it goes.

    Attributes:
        name: of a body or a link.
        solids: where they stand.
        middle: of it.
        radius: of a sphere around that.
        velocity: of its middle.
        spin: radians a second.
    """

    name: str
    solids: Sequence[Placed]
    middle: Vector = (0.0, 0.0, 0.0)
    radius: float = 0.0
    velocity: Vector = (0.0, 0.0, 0.0)
    spin: Vector = (0.0, 0.0, 0.0)

    @property
    def turning(self) -> float:
        """Speed of its outermost point about its middle, inches a second."""
        return self.radius * math.sqrt(dot(self.spin, self.spin))

    def straight(self) -> float:
        """Seconds for which it may be moved straight on."""
        bending = math.sqrt(dot(self.velocity, self.velocity) * dot(self.spin, self.spin))
        return math.sqrt(2 * BEND / bending) if bending > 0 else math.inf

    def above(self) -> float:
        """Seconds for which it is above the table."""
        falling = self.turning - self.velocity[2]
        low = min(solid.low[2] for solid in self.solids)
        return max(low, 0.0) / falling if falling > 0 else math.inf

    def move(self, driven: bool) -> Move:
        """Its motion but for what is slower than friction creeps: that is settling, not going."""
        u, v, w = (each if abs(each) > CREEP else 0.0 for each in self.velocity)
        least = CREEP / self.radius
        x, y, z = (each if abs(each) > least else 0.0 for each in self.spin)
        return Move(self.name, (u, v, w), (x, y, z), driven)


def join(links: Sequence[Mover], bodies: Sequence[Mover], touching: set[tuple[str, str]]) -> None:
    """Have what moves with a link move with it to the last bit.

    The solver's contacts are a very little soft; as that is settling to and fro it is no motion to
    go on with.

    Args:
        links: of the arm.
        bodies: that may move with them or with each other.
        touching: names of what touches.
    """
    waiting, loose = list(links), list(bodies)
    while waiting:
        one = waiting.pop(0)
        left = []
        for body in loose:
            if (one.name, body.name) in touching or (body.name, one.name) in touching:
                velocity = plus(one.velocity, cross(one.spin, minus(body.middle, one.middle)))
                off, turn = minus(velocity, body.velocity), minus(one.spin, body.spin)
                apart = math.sqrt(dot(off, off)) + body.radius * math.sqrt(dot(turn, turn))
                if apart <= TOGETHER:
                    body.velocity, body.spin = velocity, one.spin
                    waiting.append(body)
                    continue
            left.append(body)
        loose = left


def apart(
    bodies: Sequence[Mover],
    links: Sequence[Mover],
    others: Sequence[Mover],
    heedless: set[tuple[str, str]],
    most: float,
) -> float:
    """Seconds for which nothing comes upon anything new.

    Args:
        bodies: that move.
        links: of the arm, that do not meet each other.
        others: what stands.
        heedless: names of what presses on each other (how that stays the solver knows), and of
            what never touches.
        most: more than so much does not matter.
    """
    turning = {id(mover): mover.turning for mover in (*bodies, *links, *others)}
    for one, other in _pairs(bodies, links, others):
        if (one.name, other.name) in heedless or (other.name, one.name) in heedless:
            continue
        way = minus(one.velocity, other.velocity)
        turn = turning[id(one)] + turning[id(other)]
        speed = math.sqrt(dot(way, way)) + turn
        for a in one.solids:
            for b in other.solids:
                if a.near(b, speed * most) and boxes_apart(a, b) < speed * most:
                    room, across = separation(a.vertices, b.vertices, speed * most)
                    # What goes by comes no closer than the plane between them.
                    closing = turn - dot(way, across)
                    if closing * most > room + DRIFT:
                        most = (room + DRIFT) / closing
    return most


def _pairs(
    bodies: Sequence[Mover], links: Sequence[Mover], others: Sequence[Mover]
) -> Iterator[tuple[Mover, Mover]]:
    for i, body in enumerate(bodies):
        for other in (*bodies[:i], *links, *others):
            yield body, other
    for link in links:
        for other in others:
            yield link, other
