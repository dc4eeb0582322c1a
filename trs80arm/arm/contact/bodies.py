"""What can touch: loose bodies, things that stand fast, and the links of an arm.

Values and positions only; `scene` moves them. Inches, ounces, seconds, radians.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, fields
from typing import Any, NamedTuple, Protocol

from trs80arm.arm.contact.manifold import Placed
from trs80arm.arm.contact.recurrence import brief
from trs80arm.arm.contact.rotations import (
    IDENTITY,
    STRAIGHT,
    Matrix,
    Quaternion,
    apply,
    inverted,
    matrix,
    spun,
    times,
    transposed,
)
from trs80arm.arm.contact.solids import Solid, moments
from trs80arm.arm.shapes import Vector, dot, plus

NOWHERE: Vector = (0.0, 0.0, 0.0)
UPPER = 0.7
"""Cosine to the vertical up to which a side is an upper one."""


@dataclass(frozen=True, slots=True)
class Shape:
    """The form and mass of a loose body, around its centre of mass.

    Attributes:
        solids: convex, rigidly joined, in the body's frame.
        mass: ounces.
        inertia: about the centre of mass, in the body's frame.
        ease: inverse of the inertia.
        radius: of the sphere around it, inches.
        offset: from the centre of mass to the origin in which it was described, inches.
        low: least x, y, z in the body's frame.
        high: greatest x, y, z in the body's frame.
    """

    solids: tuple[Solid, ...]
    mass: float
    inertia: Matrix
    ease: Matrix
    radius: float
    offset: Vector
    low: Vector
    high: Vector

    @classmethod
    def of(cls, solids: Sequence[Solid], mass: float) -> Shape:
        """A body of even density.

        Args:
            solids: that make it up and do not overlap, in any one frame.
            mass: ounces.
        """
        whole = moments(solids)
        density = mass / whole.volume
        a, b, c, d, e, f, g, h, i = (value * density for value in whole.inertia)
        x, y, z = whole.middle
        around = tuple(solid.moved((-x, -y, -z)) for solid in solids)
        reach = max(u * u + v * v + w * w for solid in around for u, v, w in solid.vertices)
        inertia = (a, b, c, d, e, f, g, h, i)
        us, vs, ws = zip(*(v for solid in around for v in solid.vertices), strict=True)
        return cls(
            around,
            mass,
            inertia,
            inverted(inertia),
            math.sqrt(reach),
            (-x, -y, -z),
            (min(us), min(vs), min(ws)),
            (max(us), max(vs), max(ws)),
        )

    def at(self, place: Vector, turn: Quaternion) -> list[Placed]:
        """Its solids where a body of this form stands."""
        m = matrix(turn)
        return [Placed(solid, place, m) for solid in self.solids]


class Watcher(Protocol):
    """Who wants to know where bodies are that need no looking at."""

    def file(self, body: Body) -> None:
        """A body has woken, fallen asleep, been taken up, let go, or put elsewhere in its sleep."""

    def lean(self, body: Body, before: Sequence[str]) -> None:
        """A body touches other things in its sleep than before, which are named."""


@dataclass(slots=True)
class Body:
    """Something loose.

    Attributes:
        name: unique in its scene.
        shape: its form.
        friction: coefficient of its surface.
        place: of its centre of mass.
        turn: of its frame against the world's.
        velocity: of the centre of mass, inches a second.
        spin: radians a second about the world's axes.
        still: ticks for which it has hardly moved.
    """

    name: str
    shape: Shape
    friction: float
    place: Vector
    turn: Quaternion = STRAIGHT
    velocity: Vector = NOWHERE
    spin: Vector = NOWHERE
    still: int = 0
    _touching: tuple[str, ...] = ()
    _asleep: bool = False
    _carried: tuple[Vector, Matrix] | None = None
    _solids: list[Placed] | None = field(default=None, repr=False, compare=False)
    _form: tuple[Shape, bytes] | None = field(default=None, init=False, repr=False, compare=False)
    _watcher: Watcher | None = field(default=None, init=False, repr=False, compare=False)

    def __getstate__(self) -> dict[str, Any]:
        # Where its corners are follows from its place; who watches it, the scene knows.
        gone = {"_solids": None, "_form": None, "_watcher": None}
        return {each.name: getattr(self, each.name) for each in fields(self)} | gone

    def __setstate__(self, state: dict[str, Any]) -> None:
        for name, value in state.items():
            setattr(self, name, value)

    @property
    def asleep(self) -> bool:
        """Whether it is at rest and needs no looking at."""
        return self._asleep

    @asleep.setter
    def asleep(self, asleep: bool) -> None:
        self._asleep = asleep
        self._tell()

    @property
    def carried(self) -> tuple[Vector, Matrix] | None:
        """Its place and turn in the hand's frame while it rests in the hand, or None."""
        return self._carried

    @carried.setter
    def carried(self, carried: tuple[Vector, Matrix] | None) -> None:
        self._carried = carried
        self._tell()

    @property
    def touching(self) -> tuple[str, ...]:
        """Names of the things that it touched when it fell asleep."""
        return self._touching

    @touching.setter
    def touching(self, touching: tuple[str, ...]) -> None:
        before, self._touching = self._touching, touching
        if self._watcher is not None and touching != before:
            self._watcher.lean(self, before)

    @property
    def form(self) -> bytes:
        """Its shape: of two with the same it is the same to the last bit."""
        shape = self.shape
        # A press gives it another.
        if self._form is None or self._form[0] is not shape:
            solids = [solid.form for solid in shape.solids]
            form = brief(solids, shape.mass, shape.inertia, shape.ease, shape.radius)
            self._form = shape, form
        return self._form[1]

    def watch(self, watcher: Watcher | None) -> None:
        """Tell somebody from now on when it wakes, falls asleep, or is put elsewhere asleep."""
        self._watcher = watcher
        self._tell()

    def _tell(self) -> None:
        if self._watcher is not None:
            self._watcher.file(self)

    @property
    def placed(self) -> list[Placed]:
        """Its solids where they stand."""
        if self._solids is None:
            self._solids = self.shape.at(self.place, self.turn)
        return self._solids

    @property
    def origin(self) -> Vector:
        """Where the origin of its description is."""
        x, y, z = apply(matrix(self.turn), self.shape.offset)
        return self.place[0] + x, self.place[1] + y, self.place[2] + z

    def put(self, place: Vector, turn: Quaternion, placed: list[Placed] | None = None) -> None:
        """Be somewhere else.

        Args:
            place: of the centre of mass.
            turn: of the frame.
            placed: the solids of a body of this form there, if they are known.
        """
        self.place, self.turn, self._solids = place, turn, placed
        if self._asleep and self._carried is None:
            self._tell()

    def led(self, speed: Sequence[float], seconds: float) -> tuple[Vector, Quaternion, Vector]:
        """Where it is after a while at a velocity and a spin: place, turn, and the spin by then."""
        vx, vy, vz, wx, wy, wz = speed
        turn, spin = self.turn, (wx, wy, wz)
        if wx or wy or wz:
            turn, spin = spun(turn, spin, self.shape.inertia, self.shape.ease, seconds)
        return plus(self.place, (vx, vy, vz), seconds), turn, spin

    def inertia(self) -> Matrix:
        """About the centre of mass, in the world's frame."""
        m = matrix(self.turn)
        return times(times(m, self.shape.inertia), transposed(m))


@dataclass(slots=True)
class Fixed:
    """Something that stands fast; what lies on it may be carried, as on a belt.

    Attributes:
        name: unique in its scene.
        solids: in the world's frame.
        friction: coefficient of its surface.
        carries: level velocity of its upper side, inches a second.
        passes: names of links of the arm that never meet it, being joined to it.
    """

    name: str
    solids: tuple[Solid, ...]
    friction: float
    carries: Vector = NOWHERE
    passes: tuple[str, ...] = ()
    _solids: list[Placed] | None = field(default=None, repr=False, compare=False)
    _form: bytes | None = field(default=None, init=False, repr=False, compare=False)

    def __getstate__(self) -> dict[str, Any]:
        gone = {"_solids": None, "_form": None}
        return {each.name: getattr(self, each.name) for each in fields(self)} | gone

    def __setstate__(self, state: dict[str, Any]) -> None:
        for name, value in state.items():
            setattr(self, name, value)

    @property
    def form(self) -> bytes:
        """All that it is, but for what its upper side carries, to the last bit."""
        if self._form is None:
            solids = [solid.form for solid in self.solids]
            self._form = brief(self.name, solids, self.friction, self.passes)
        return self._form

    def surface(self, normal: Vector) -> Vector:
        """Velocity of its surface where that faces along a normal, inches a second."""
        if normal[2] < UPPER:
            return NOWHERE
        return plus(self.carries, normal, -dot(self.carries, normal))

    @property
    def placed(self) -> list[Placed]:
        """Its solids where they stand."""
        if self._solids is None:
            self._solids = [Placed(solid, NOWHERE, IDENTITY) for solid in self.solids]
        return self._solids


Screw = tuple[Vector, Vector]
"""Turning (radians) and velocity at the world's origin (inches), for a unit of one coordinate."""


class Link(NamedTuple):
    """One link of an arm where it stands.

    Attributes:
        place: of its frame's origin.
        turn: of its frame.
        screws: how it moves with each of the six coordinates.
    """

    place: Vector
    turn: Matrix
    screws: tuple[Screw, ...]


class Linkage(Protocol):
    """An arm as contact sees it: links that six coordinates move, each on a spring.

    The coordinates are the motors': a motor commands one and the cable gives a little.
    """

    @property
    def names(self) -> Sequence[str]:
        """Of the links."""

    @property
    def solids(self) -> Sequence[Solid]:
        """Of the links, each in its own frame."""

    @property
    def frictions(self) -> Sequence[float]:
        """Coefficients of the links' surfaces."""

    @property
    def stiffness(self) -> Sequence[float]:
        """Of the six coordinates: ounces (or ounce inches) per inch (or radian)."""

    @property
    def hand(self) -> int:
        """Index of the link in whose frame things are carried."""

    def links(self, joints: Sequence[float]) -> list[Link]:
        """Where the links are.

        Args:
            joints: the six coordinates, radians; the last, the opening, inches.
        """
