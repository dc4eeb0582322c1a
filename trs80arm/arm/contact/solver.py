"""Forces of contact for one tick: no overlap, Coulomb friction, springs of the arm's cables.

The velocities at the end of a tick are those at which every point of contact either opens or
presses, and friction holds, or pulls against the motion with its coefficient times the pressure:
the implicit time-stepping problem of Stewart and Trinkle. As in Anitescu (2006) and in Castro and
others (2023, "lagged") it is made convex: friction is bounded by the pressure that the last
pass found, so that what slides does not float as it would in the plain relaxation, and a few passes
agree with themselves. Contact gives a very little (`GIVE`) and holding friction creeps a very
little (`CREEP`), which makes the function smooth; Newton's method finds its least value in a few
steps however high the stack and however heavy what lies on it. The arm is one more body: six
coordinates, each as inert as its spring is stiff.

Only +, -, *, / and square roots of IEEE doubles, sums in a fixed order, no linear-algebra library:
the same to the last bit on every machine.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from trs80arm.arm.contact.manifold import tangents
from trs80arm.arm.contact.rotations import Matrix
from trs80arm.arm.shapes import Vector, cross, minus, plus

GIVE = 1e-4
"""Softness of a contact as a fraction of the bodies' own readiness to move."""
CREEP = 1e-3
"""Speed at which friction that holds lets slide, inches a second, at about its limit."""
RECOVERY = 0.2
"""Part of an overlap that is taken back in a tick."""
FASTEST_RECOVERY = 1.0
"""Inches a second at which overlap is taken back at most."""
SOLVED = 1e-3
"""Change of velocity below which Newton's method has arrived, inches a second."""
MOST_STEPS = 40
BOLD_STEPS = 3
"""Of them those that go all the way at first, to find at once all that touches."""
PASSES = 4
"""Times that friction's bounds are brought in line with the pressure, at most."""
AGREED = 0.05
"""Part of the greatest pressure by which bounds and pressures may differ."""
SETTLED = 1e-2
"""Inches a second below which what presses neither parts nor comes closer."""
DRIFT = 2e-4
"""Inches by which it may do so while it goes on as before."""
SHIFT = 0.1
"""Inches by which it may shift on something that has an end."""
ARM_SPAN = 4.0
"""Inches across the area in which a link touches what stands fast, at most."""
TILT = 0.015
"""Inches by which one end of it may come closer than the other."""

_SLOWEST = 1e-9
_SIX = np.arange(6)

Six = tuple[float, float, float, float, float, float]
Key = tuple[str, str, int]
Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]


@dataclass(slots=True)
class Mobile:
    """What the solver knows of something that moves.

    Attributes:
        speed: six velocities, in the end those found: of a body, velocity and spin; of the arm, the
            rates of its coordinates.
        place: of a body's centre of mass; unused for the arm.
        mass: of a body.
        inertia: of a body, in the world's frame.
        inertias: of each of the arm's coordinates; None for a body.
        before: velocities from which to begin looking; those of `speed` unless given.
    """

    speed: list[float]
    place: Vector
    mass: float = 0.0
    inertia: Matrix | None = None
    inertias: Six | None = None
    before: tuple[float, ...] | None = None


@dataclass(frozen=True, slots=True)
class Side:
    """One side of a contact: what is touched there, and how it moves.

    Attributes:
        mobile: what moves, or None for what stands fast.
        screws: of the arm's link.
    """

    mobile: Mobile | None
    screws: tuple[tuple[Vector, Vector], ...] | None = None

    @property
    def spin(self) -> Vector:
        """Radians a second."""
        if self.mobile is None:
            return (0.0, 0.0, 0.0)
        if self.screws is None:
            return self.mobile.speed[3], self.mobile.speed[4], self.mobile.speed[5]
        return total(self.screws, self.mobile.speed)[0]


def total(screws: Sequence[tuple[Vector, Vector]], rates: Sequence[float]) -> tuple[Vector, Vector]:
    """Spin of a link, and velocity at the world's origin."""
    spin = velocity = (0.0, 0.0, 0.0)
    for (turning, going), rate in zip(screws, rates, strict=True):
        spin, velocity = plus(spin, turning, rate), plus(velocity, going, rate)
    return spin, velocity


@dataclass(slots=True)
class Contact:
    """One point of contact.

    Attributes:
        key: the two things' names, and which of their solids; for finding it again.
        point: where, in the world.
        gap: inches, negative for an overlap.
        normal: from the first side into the second.
        first: side that the normal leaves.
        second: side that it enters; it moves.
        friction: coefficient.
        surface: velocity of the first side if it stands fast but its surface moves.
        pressure: impulse along the normal: as it was a tick before, then as found.
        impulse: on the second side, in the world; found.
    """

    key: Key
    point: Vector
    gap: float
    normal: Vector
    first: Side
    second: Side
    friction: float
    surface: Vector = (0.0, 0.0, 0.0)
    pressure: float = 0.0
    impulse: Vector = (0.0, 0.0, 0.0)


class Problem:
    """Contacts that belong together, as arrays.

    Args:
        contacts: at least one.
        seconds: length of the tick.
    """

    def __init__(self, contacts: list[Contact], seconds: float) -> None:
        self.contacts = contacts
        mobiles: list[Mobile] = []
        index: dict[int, int] = {}
        for contact in contacts:
            for side in (contact.first, contact.second):
                if side.mobile is not None and id(side.mobile) not in index:
                    index[id(side.mobile)] = len(mobiles)
                    mobiles.append(side.mobile)
        self.mobiles = mobiles
        self.size = 6 * len(mobiles)
        self.mass = _masses(mobiles)
        self.wanted = np.array([mobile.speed for mobile in mobiles]).reshape(-1)
        self.first = np.array([m.before or m.speed for m in mobiles]).reshape(-1)
        self._rows(index)
        self.relative = self.pressure = np.zeros(0)
        self.gaps = gaps = np.array([contact.gap for contact in contacts])
        self.least = np.where(
            gaps > 0,
            -gaps / seconds,
            np.minimum(-gaps * (RECOVERY / seconds), FASTEST_RECOVERY),
        )
        self.friction = np.array([contact.friction for contact in contacts])

    def _rows(self, index: dict[int, int]) -> None:
        """How each contact's relative velocity follows from the coordinates."""
        contacts, count, size = self.contacts, len(self.contacts), self.size
        nobody = len(self.mobiles)
        ways_of: list[tuple[float, ...]] = []
        sides: tuple[list[int], list[int]] = ([], [])
        linked: list[tuple[int, int, Side]] = []
        normal: Vector | None = None
        way: tuple[float, ...] = ()
        for i, contact in enumerate(contacts):
            if contact.normal is not normal:
                normal = contact.normal
                u, v = tangents(normal)
                way = (*normal, *u, *v)
            ways_of.append(way)
            for which, side in ((0, contact.first), (1, contact.second)):
                if side.mobile is None:
                    sides[which].append(nobody)
                    continue
                sides[which].append(index[id(side.mobile)])
                if side.screws is not None:
                    linked.append((i, which, side))
        ways = np.array(ways_of).reshape(count, 3, 3)
        points = np.array([contact.point for contact in contacts])
        places = np.array([*(mobile.place for mobile in self.mobiles), (0.0, 0.0, 0.0)])
        easy = np.array([*(1 / m.mass if m.mass else 0.0 for m in self.mobiles), 0.0])
        rows = np.empty((count, 3, 12))
        columns = np.empty((count, 12), dtype=np.int64)
        ease = np.zeros(count)
        for which, sign in ((0, -1.0), (1, 1.0)):
            at = np.array(sides[which])
            r = points - places[at]
            w = ways * np.where(at == nobody, 0.0, sign)[:, None, None]
            x, y, z = r[:, None, 0], r[:, None, 1], r[:, None, 2]
            a, b, c = w[:, :, 0], w[:, :, 1], w[:, :, 2]
            start = 6 * which
            rows[:, :, start : start + 3] = w
            rows[:, :, start + 3] = y * c - z * b
            rows[:, :, start + 4] = z * a - x * c
            rows[:, :, start + 5] = x * b - y * a
            columns[:, start : start + 6] = np.minimum((6 * at)[:, None] + _SIX, size)
            ease += easy[at]
        for i, which, side in linked:
            assert side.screws is not None
            assert side.mobile is not None
            assert side.mobile.inertias is not None
            here = _link_row(side.screws, contacts[i].point, ways[i]) * (1.0 if which else -1.0)
            rows[i, :, 6 * which : 6 * which + 6] = here
            ease[i] += sum(
                j * j / m for j, m in zip(here[0].tolist(), side.mobile.inertias, strict=True)
            )
        self.ways, self.rows, self.columns = ways, rows, columns
        self.stiffness = 1 / (GIVE * np.maximum(ease, 1e-9))
        surface = np.array([contact.surface for contact in contacts])
        self.surface = np.add.reduce(ways * surface[:, None, :], axis=2)
        self.places = (columns[:, :, None] * (size + 1) + columns[:, None, :]).reshape(-1)

    def solve(self) -> int:
        """Find the velocities and the impulses; steps of Newton's method taken."""
        bound = np.array([contact.pressure for contact in self.contacts])
        speed = self.first
        steps = 0
        for _ in range(PASSES):
            speed, taken = self._least(speed, self.friction * bound)
            steps += taken
            pressure = self._pressure(self._relative(speed)[:, 0])
            if float(np.abs(pressure - bound).max()) <= AGREED * float(pressure.max()):
                break
            bound = pressure
        relative = self._relative(speed)
        pull = self._pull(relative, self.friction * bound)
        pressure = self._pressure(relative[:, 0])
        self.relative, self.pressure = relative, pressure
        impulses = np.column_stack((pressure, pull))
        vectors = np.add.reduce(self.ways * impulses[:, :, None], axis=1).tolist()
        for contact, normal, vector in zip(self.contacts, pressure.tolist(), vectors, strict=True):
            contact.pressure = normal
            contact.impulse = (vector[0], vector[1], vector[2])
        for mobile, found in zip(self.mobiles, speed.reshape(-1, 6).tolist(), strict=True):
            mobile.speed[:] = found
        return steps

    @property
    def settled(self) -> bool:
        """Whether what presses has settled, of the little that contacts give."""
        opening = self.relative[:, 0][self.pressure > 0]
        return opening.size == 0 or float(np.abs(opening).max()) < SETTLED

    def lasting(self, speeds: dict[int, Six], spans: dict[int, float], endless: set[str]) -> float:
        """Seconds for which these contacts stay as they are while everything goes on.

        Args:
            speeds: with which it does, by the `id` of each mobile.
            spans: inches across the bodies among them, likewise.
            endless: names of things that are the same wherever they are touched.
        """
        for mobile in self.mobiles:
            mobile.speed[:] = speeds[id(mobile)]
        relative = self._relative(np.array([mobile.speed for mobile in self.mobiles]).reshape(-1))
        opening, u, v = relative[:, 0], relative[:, 1], relative[:, 2]
        gone = np.where((self.pressure > 0) | (opening < 0), np.abs(opening), 0.0)
        room = np.where(self.pressure > 0, DRIFT, np.maximum(self.gaps, 0.0) + DRIFT)
        lasting = float((room / np.maximum(gone, _SLOWEST)).min())
        ends = np.array([contact.key[0] not in endless for contact in self.contacts])
        if ends.any():
            shift = np.sqrt(u * u + v * v)[ends]
            lasting = min(lasting, SHIFT / max(float(shift.max()), _SLOWEST))
        tilting = 0.0
        for contact in self.contacts:
            a, b, c = cross(minus(contact.second.spin, contact.first.spin), contact.normal)
            span = min(
                spans.get(id(contact.first.mobile), math.inf),
                spans.get(id(contact.second.mobile), ARM_SPAN),
            )
            tilting = max(tilting, span * span * (a * a + b * b + c * c))
        return min(lasting, TILT / max(math.sqrt(tilting), _SLOWEST))

    def _relative(self, speed: Floats) -> Floats:
        """Velocities of the second sides against the first, along normals and tangents."""
        along = np.append(speed, 0.0)[self.columns]
        relative: Floats = np.add.reduce(self.rows * along[:, None, :], axis=2)
        relative -= self.surface
        return relative

    def _pressure(self, opening: Floats) -> Floats:
        return self.stiffness * np.maximum(self.least - opening, 0.0)

    def _pull(self, relative: Floats, bound: Floats) -> Floats:
        """Impulses of friction along both tangents."""
        u, v = relative[:, 1], relative[:, 2]
        scale = -bound / np.sqrt(u * u + v * v + CREEP * CREEP)
        return np.column_stack((scale * u, scale * v))

    def _least(self, speed: Floats, bound: Floats) -> tuple[Floats, int]:
        """Newton's method: velocities at which impulses and momentum balance."""
        for step in range(MOST_STEPS):
            relative = self._relative(speed)
            slope = self._slope(speed, relative, bound)
            bold = step < BOLD_STEPS
            change = eliminate(self._curvature(relative, bound, bold), -slope)
            if float(np.abs(change).max()) < SOLVED:
                return speed + change, step + 1
            speed = speed + (1.0 if bold else self._far(speed, change, relative, bound)) * change
        return speed, MOST_STEPS

    def _slope(self, speed: Floats, relative: Floats, bound: Floats) -> Floats:
        """How the function to be made least grows with each velocity."""
        impulses = np.column_stack((self._pressure(relative[:, 0]), self._pull(relative, bound)))
        pushed = np.add.reduce(self.rows * impulses[:, :, None], axis=1)
        total: Floats = np.zeros(self.size + 1)
        total += np.bincount(self.columns.reshape(-1), pushed.reshape(-1), self.size + 1)
        lost = (speed - self.wanted).reshape(-1, 1, 6)
        inert: Floats = np.add.reduce(self.mass * lost, axis=2).reshape(-1)
        inert -= total[: self.size]
        return inert

    def _curvature(self, relative: Floats, bound: Floats, most: bool) -> Floats:
        """How that growth itself grows: a symmetric matrix.

        Args:
            relative: velocities.
            bound: of friction.
            most: of friction, how it grows square to the motion: along it that is less.
        """
        u, v = relative[:, 1], relative[:, 2]
        square = u * u + v * v + CREEP * CREEP
        stiff = bound / np.sqrt(square)
        local = np.zeros((len(bound), 3, 3))
        local[:, 0, 0] = np.where(relative[:, 0] < self.least, self.stiffness, 0.0)
        if most:
            local[:, 1, 1] = local[:, 2, 2] = stiff
        else:
            local[:, 1, 1] = stiff * (1 - u * u / square)
            local[:, 2, 2] = stiff * (1 - v * v / square)
            local[:, 1, 2] = local[:, 2, 1] = -stiff * u * v / square
        half = np.add.reduce(local[:, :, :, None] * self.rows[:, None, :, :], axis=2)
        whole = np.add.reduce(self.rows[:, :, :, None] * half[:, :, None, :], axis=1)
        size = self.size
        flat: Floats = np.zeros((size + 1) * (size + 1))
        flat += np.bincount(self.places, whole.reshape(-1), len(flat))
        matrix = flat.reshape(size + 1, size + 1)[:size, :size].copy()
        for i in range(len(self.mobiles)):
            matrix[6 * i : 6 * i + 6, 6 * i : 6 * i + 6] += self.mass[i]
        return matrix

    def _far(self, speed: Floats, change: Floats, relative: Floats, bound: Floats) -> float:
        """How far along a step the function still falls: a root of its slope there."""
        by = np.add.reduce(self.rows * np.append(change, 0.0)[self.columns][:, None, :], axis=2)
        inert = np.add.reduce(self.mass * change.reshape(-1, 1, 6), axis=2).reshape(-1)
        constant = float((inert * (speed - self.wanted)).sum())
        growing = float((inert * change).sum())

        def slope(far: float) -> float:
            there = relative + far * by
            impulse = self._pressure(there[:, 0]) * by[:, 0]
            pull = self._pull(there, bound) * by[:, 1:]
            return constant + far * growing - float(impulse.sum()) - float(pull.sum())

        start, end = slope(0.0), slope(1.0)
        if end <= 0.1 * abs(start):
            return 1.0
        low, high, at_low, at_high = 0.0, 1.0, start, end
        far = 1.0
        for _ in range(12):
            far = low - at_low * (high - low) / (at_high - at_low)
            far = min(max(far, low + 0.05 * (high - low)), high - 0.05 * (high - low))
            here = slope(far)
            if abs(here) <= 0.1 * abs(start):
                break
            if here < 0:
                low, at_low = far, here
            else:
                high, at_high = far, here
        return far


def _masses(mobiles: list[Mobile]) -> Floats:
    """Mass and inertia of each mobile as a 6 x 6 matrix."""
    out = np.zeros((len(mobiles), 6, 6))
    for i, mobile in enumerate(mobiles):
        if mobile.inertias is not None:
            for k, inertia in enumerate(mobile.inertias):
                out[i, k, k] = inertia
        else:
            assert mobile.inertia is not None
            out[i, 0, 0] = out[i, 1, 1] = out[i, 2, 2] = mobile.mass
            out[i, 3:, 3:] = np.array(mobile.inertia).reshape(3, 3)
    return out


def _link_row(screws: tuple[tuple[Vector, Vector], ...], point: Vector, ways: Floats) -> Floats:
    """How fast a point of a link moves along three ways with each of its coordinates."""
    x, y, z = point
    speeds = np.array(
        [
            (
                velocity[0] + spin[1] * z - spin[2] * y,
                velocity[1] + spin[2] * x - spin[0] * z,
                velocity[2] + spin[0] * y - spin[1] * x,
            )
            for spin, velocity in screws
        ]
    )
    row: Floats = np.add.reduce(ways[:, None, :] * speeds[None, :, :], axis=2)
    return row


def eliminate(matrix: Floats, right: Floats) -> Floats:
    """Solve a symmetric positive definite system by Gauss's elimination, six rows at a time.

    Only what lies within the envelope of the matrix is looked at: of a row of bodies each is
    coupled to the next alone.

    Args:
        matrix: square, of blocks of six; it is used up.
        right: the right-hand side.
    """
    size = len(right)
    count = size // 6
    coupled = (matrix.reshape(count, 6, count, 6) != 0.0).any(axis=(1, 3))
    last = np.where(coupled, np.arange(count)[:, None], 0).max(axis=0)
    ends = (6 * (np.maximum.accumulate(last) + 1)).tolist()
    out = right.copy()
    gains: list[Floats] = []
    for k, end in zip(range(0, size, 6), ends, strict=True):
        after = k + 6
        # Solve the block for its own six unknowns: what they are without the others, and by them.
        panel = np.empty((6, end - k + 1))
        panel[:, :-1] = matrix[k:after, k:end]
        panel[:, -1] = out[k:after]
        for j in range(6):
            row = panel[j]
            row /= row.item(j)
            factor = panel[:, j].copy()
            factor[j] = 0.0
            panel -= factor[:, None] * row
        gain = panel[:, 6:]
        gains.append(gain)
        if end > after:
            beside = matrix[k:after, after:end]
            change = np.add.reduce(beside[:, :, None] * gain[:, None, :], axis=0)
            matrix[after:end, after:end] -= change[:, :-1]
            out[after:end] -= change[:, -1]
    for k, end, gain in zip(range(size - 6, -1, -6), reversed(ends), reversed(gains), strict=True):
        by_others = np.ascontiguousarray((gain[:, :-1] * out[k + 6 : end]).T)
        out[k : k + 6] = gain[:, -1] - np.add.reduce(by_others, axis=0)
    return out
