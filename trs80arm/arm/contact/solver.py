"""Forces of contact for one tick: no overlap, Coulomb friction, springs of the arm's cables.

The velocities at the end of a tick are those at which every point of contact either opens or
presses, and friction holds, or pulls against the motion with its coefficient times the pressure:
the implicit time-stepping problem of Stewart and Trinkle. As in Anitescu (2006) and in Castro and
others (2023, "lagged") it is made convex: friction is bounded by the pressure that the last
pass found, so that what slides does not float as it would in the plain relaxation, and a few passes
agree with themselves. Contact gives a very little (`GIVE`), and friction that holds creeps a very
little (`CREEP`), in proportion to what it holds. So the function to be made least is a quadratic
one as long as each contact goes on pressing, holding or opening, and Newton's method is done when
they do; of what slides it finds the way in a few steps more. The arm is one more body: six
coordinates, each as inert as its spring is stiff.

Only +, -, *, / and square roots of IEEE doubles, sums in a fixed order, no linear-algebra library:
the same to the last bit on every machine.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from itertools import repeat

from trs80arm.arm.contact.clock import TICK
from trs80arm.arm.contact.elimination import Eliminated, Six, order
from trs80arm.arm.contact.rotations import Matrix
from trs80arm.arm.shapes import Vector, cross, minus, plus

GIVE = 1e-4
"""Softness of a contact in a tick, as a fraction of the bodies' own readiness to move."""
CREEP = 1e-3
"""Speed at which friction that holds lets slide at its limit, inches a second."""
RECOVERY = 0.2
"""Part of an overlap that is taken back in a tick."""
FASTEST_RECOVERY = 1.0
"""Inches a second at which overlap is taken back at most."""
SOLVED = 1e-3
"""Change of velocity below which Newton's method has arrived, if each contact does as it did."""
SURE = 1e-6
"""Change of velocity below which it has arrived in any case."""
MOST_STEPS = 40
BOLD_STEPS = 6
"""Of them those that go all the way at first, to find at once all that touches and what holds."""
SHALLOW = 0.1
"""Part of the slope at a step's beginning at which, along the step, the least value is reached."""
MOST_TRIALS = 12
"""Looks along a step at most."""
PASSES = 6
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
_EASIEST = 1e-9
_CREEPING = CREEP * CREEP
_SLOW = (20 * CREEP) ** 2
"""Square of the speed below which what slid may well hold now."""
_NEVER = repeat(0.0)
_APART, _PRESSING, _HOLDING, _SLIDING = 0, 1, 2, 4
"""What a contact does; friction holds or slides beside either of the first two."""
_NOTHING, _AS_BEFORE, _CAUGHT = 0, 1, 2
"""What may be guessed of contacts, for a step of Newton's method to begin with: that those press
that pressed before or are expected to, and that those hold that hardly slid; that those hold now
that slid, and would now slide the other way."""
_LEVEL = (0.0, 0.0, 0.0, 0.0)
_UNKNOWN = repeat((_APART, _LEVEL))
_NOWHERE: Vector = (0.0, 0.0, 0.0)
_STILL: Six = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
_DIAGONAL = (0, 2, 5, 9, 14, 20)

Key = tuple[str, str, int]
Pressures = list[float] | None
"""At each point of a contact; None where nothing presses at all."""


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
    """Where two things touch, or are about to: an area, an edge or a point, with one normal.

    Attributes:
        key: the two things' names, and which of their solids; for finding it again.
        points: of contact, in the world, and the gap at each: inches, negative for an overlap.
        normal: from the first side into the second.
        first: side that the normal leaves.
        second: side that it enters; it moves.
        friction: coefficient.
        surfaces: velocity of the first side at each point, if it stands fast but its surface moves.
        pressures: impulse along the normal at each: as it was a tick before, then as found.
        apart: inches by which the two are apart along the normal, whole solids and not points.
    """

    key: Key
    points: list[tuple[Vector, float]]
    normal: Vector
    first: Side
    second: Side
    friction: float
    surfaces: list[Vector] | None = None
    pressures: list[float] = field(default_factory=list)
    apart: float = -math.inf

    @property
    def gap(self) -> float:
        """The least of all points."""
        return min(gap for _, gap in self.points)

    @property
    def pressure(self) -> float:
        """The whole of all points."""
        total = 0.0
        for pressure in self.pressures:
            total += pressure
        return total


class _Patch:
    """A contact as numbers.

    What presses there depends on how the two sides move against each other alone: on six velocities
    at a reference point, the centre of mass of the second thing if that is a body.

    Args:
        contact: the contact.
        one: index of the first side's mobile, or None.
        two: index of the second side's.
        seconds: length of the tick.
    """

    __slots__ = (
        "_nothing",
        "_origin",
        "_points",
        "_seconds",
        "_soonest",
        "_spread",
        "columns_one",
        "columns_two",
        "contact",
        "expected",
        "lever",
        "normal",
        "one",
        "regimes",
        "slopes",
        "two",
    )

    def __init__(self, contact: Contact, one: int | None, two: int, seconds: float) -> None:
        self.contact, self.one, self.two, self._seconds = contact, one, two, seconds
        first, second = contact.first, contact.second
        self.normal = contact.normal
        assert second.mobile is not None
        self.lever: Vector | None = None
        self.columns_one = self.columns_two = None
        if second.screws is None:
            self._origin = origin = second.mobile.place
        else:
            self._origin = origin = contact.points[0][0]
            self.columns_two = _columns(second.screws, origin)
        if first.screws is not None:
            self.columns_one = _columns(first.screws, origin)
        elif first.mobile is not None:
            self.lever = minus(origin, first.mobile.place)
        self._points: list[tuple[float, ...]] | None = None
        self._soonest = _least(contact.gap, seconds)
        ox, oy, oz = origin
        self._spread = math.sqrt(
            max(
                [
                    (x - ox) * (x - ox) + (y - oy) * (y - oy) + (z - oz) * (z - oz)
                    for (x, y, z), _ in contact.points
                ]
            )
        )
        self.expected: Pressures = None
        self._nothing = [_APART] * len(contact.points)
        self.regimes = self._nothing
        self.slopes = [_LEVEL] * len(contact.points)

    @property
    def points(self) -> list[tuple[float, ...]]:
        """Numbers of each point.

        Its place and its moment about the normal, from the reference point; the speed at which it
        opens at least, its stiffness; velocity of the surface there, and that along the normal.
        """
        if self._points is None:
            self._points = self._find_points()
        return self._points

    def _find_points(self) -> list[tuple[float, ...]]:
        contact = self.contact
        nx, ny, nz = self.normal
        x, y, z = self._origin
        ease = 0.0
        # As far as a weight sinks in one tick at once it does in several.
        give = GIVE * TICK / self._seconds
        moved: list[tuple[list[tuple[int, Six]], Six]] = []
        for side, columns in (
            (contact.first, self.columns_one),
            (contact.second, self.columns_two),
        ):
            if side.mobile is None:
                continue
            if columns is None:
                ease += 1 / side.mobile.mass
            else:
                assert side.mobile.inertias is not None
                moved.append((columns, side.mobile.inertias))
        out: list[tuple[float, ...]] = []
        for k, ((px, py, pz), gap) in enumerate(contact.points):
            rx, ry, rz = px - x, py - y, pz - z
            ax, ay, az = ry * nz - rz * ny, rz * nx - rx * nz, rx * ny - ry * nx
            own = ease
            for columns, inertias in moved:
                for at, (a, b, c, d, e, f) in columns:
                    along = nx * a + ny * b + nz * c + ax * d + ay * e + az * f
                    own += along * along / inertias[at]
            sx, sy, sz = contact.surfaces[k] if contact.surfaces is not None else _NOWHERE
            out.append(
                (
                    *(rx, ry, rz, ax, ay, az),
                    _least(gap, self._seconds),
                    1 / (give * max(own, _EASIEST)),
                    *(sx, sy, sz, nx * sx + ny * sy + nz * sz),
                )
            )
        return out

    def leaves_alone(self, relative: Six) -> bool:
        """Whether the two certainly do not press on each other, moving like that."""
        if self.contact.surfaces is not None:
            return False
        nx, ny, nz = self.normal
        vx, vy, vz, wx, wy, wz = relative
        turning = math.sqrt(wx * wx + wy * wy + wz * wz) * self._spread
        return nx * vx + ny * vy + nz * vz - turning >= self._soonest

    def relative(self, speeds: Sequence[Sequence[float]]) -> Six:
        """Velocity, at the reference point, and spin of the second thing against the first."""
        if self.columns_two is None:
            a, b, c, d, e, f = speeds[self.two]
        else:
            a, b, c, d, e, f = _moved(self.columns_two, speeds[self.two])
        if self.one is None:
            return a, b, c, d, e, f
        if self.columns_one is not None:
            u, v, w, p, q, r = _moved(self.columns_one, speeds[self.one])
        else:
            assert self.lever is not None
            x, y, z = self.lever
            u, v, w, p, q, r = speeds[self.one]
            u, v, w = u + q * z - r * y, v + r * x - p * z, w + p * y - q * x
        return a - u, b - v, c - w, d - p, e - q, f - r

    def fastest(self, relative: Six) -> float:
        """A bound on the speed of each contact, inches a second."""
        vx, vy, vz, wx, wy, wz = relative
        turning = math.sqrt(wx * wx + wy * wy + wz * wz) * self._spread
        return math.sqrt(vx * vx + vy * vy + vz * vz) + turning

    def lasting(self, relative: Six, across: float, most: float, *, ends: bool) -> float:
        """Seconds for which what presses goes on pressing where it does, and nothing else begins.

        Args:
            relative: of the second thing against the first.
            across: inches across the smaller of them.
            most: more than so much does not matter.
            ends: whether the first is not the same wherever it is touched.
        """
        contact = self.contact
        for (_, gap), pressure, opening in zip(
            contact.points, contact.pressures, self.openings(relative), strict=True
        ):
            if pressure > 0:
                if abs(opening) * most > DRIFT:
                    most = DRIFT / abs(opening)
            elif -opening * most > (room := max(gap, 0.0) + DRIFT):
                most = room / -opening
        if ends and self.fastest(relative) * most > SHIFT:
            most = min(most, SHIFT / max(*self.sliding(relative), _SLOWEST))
        return min(most, TILT / max(across * self._tilting(relative), _SLOWEST))

    def passing(self, relative: Six, across: float) -> float:
        """Seconds for which there is a plane between the two, however far they slide.

        Args:
            relative: of the second thing against the first.
            across: inches across the second.
        """
        nx, ny, nz = self.normal
        vx, vy, vz = relative[:3]
        closing = across * self._tilting(relative) - nx * vx - ny * vy - nz * vz
        room = self.contact.apart + DRIFT
        return room / max(closing, _SLOWEST) if room > 0 else 0.0

    def _tilting(self, relative: Six) -> float:
        """Radians a second by which the second thing turns against the contact's plane."""
        a, b, c = cross(relative[3:], self.normal)
        return math.sqrt(a * a + b * b + c * c)

    def openings(self, relative: Six) -> list[float]:
        """Speed at which each contact opens, inches a second."""
        nx, ny, nz = self.normal
        vx, vy, vz, wx, wy, wz = relative
        along = nx * vx + ny * vy + nz * vz
        return [
            along + ax * wx + ay * wy + az * wz - surface
            for _, _, _, ax, ay, az, _, _, _, _, _, surface in self.points
        ]

    def pressures(self, relative: Six) -> Pressures:
        """Impulse along the normal at each point."""
        if self.leaves_alone(relative):
            return None
        out = [
            stiff * (least - opening) if opening < least else 0.0
            for (_, _, _, _, _, _, least, stiff, _, _, _, _), opening in zip(
                self.points, self.openings(relative), strict=True
            )
        ]
        return out if any(out) else None

    def sliding(self, relative: Six) -> list[float]:
        """Speed at which each contact slides, inches a second."""
        nx, ny, nz = self.normal
        vx, vy, vz, wx, wy, wz = relative
        out = []
        for (rx, ry, rz, _, _, _, _, _, sx, sy, sz, _), opening in zip(
            self.points, self.openings(relative), strict=True
        ):
            tx = vx + wy * rz - wz * ry - sx - opening * nx
            ty = vy + wz * rx - wx * rz - sy - opening * ny
            tz = vz + wx * ry - wy * rx - sz - opening * nz
            out.append(math.sqrt(tx * tx + ty * ty + tz * tz))
        return out

    def agrees(self, relative: Six, bounding: Pressures, pressures: Pressures, off: float) -> bool:
        """Whether friction is in line with the pressures found.

        Args:
            relative: of the second thing against the first.
            bounding: pressures with which friction was bounded.
            pressures: found.
            off: by how much they may differ, where friction does not hold with less than it might.
        """
        if bounding is None and pressures is None:
            return True
        nothing = [0.0] * len(self._nothing)
        bounding, pressures = bounding or nothing, pressures or nothing
        apart = [abs(a - b) > off for a, b in zip(bounding, pressures, strict=True)]
        if not any(apart):
            return True
        return all(
            speed <= CREEP and old * speed <= now * CREEP
            for wrong, speed, old, now in zip(
                apart, self.sliding(relative), bounding, pressures, strict=True
            )
            if wrong
        )

    def push(self, relative: Six, bounds: Pressures, guess: int) -> Six:
        """Impulse and its moment about the reference point, on the second thing.

        Notes down for `stiffness` what each contact does.

        Args:
            relative: of the second thing against the first.
            bounds: of friction at each point.
            guess: what is taken for granted, of `_NOTHING` and so on.
        """
        beginning = guess == _AS_BEFORE
        presses: Iterable[float] = _NEVER
        if beginning:
            presses = bounds or self.expected or _NEVER
        if bounds is None:
            if presses is _NEVER and self.leaves_alone(relative):
                self.regimes = self._nothing
                return _STILL
            bounds = [0.0] * len(self._nothing)
        nx, ny, nz = self.normal
        vx, vy, vz, wx, wy, wz = relative
        along = nx * vx + ny * vy + nz * vz
        fx = fy = fz = mx = my = mz = 0.0
        before = zip(self.regimes, self.slopes, strict=True) if guess == _CAUGHT else _UNKNOWN
        self.regimes = regimes = []
        self.slopes = slopes = []
        slow = _SLOW if beginning else _CREEPING
        for point, bound, known, (was, way) in zip(
            self.points, bounds, presses, before, strict=False
        ):
            rx, ry, rz, ax, ay, az, least, stiff, sx, sy, sz, surface = point
            opening = along + ax * wx + ay * wy + az * wz - surface
            if opening < least or known:
                regime, pressure = _PRESSING, stiff * (least - opening)
            elif bound:
                regime, pressure = _APART, 0.0
            else:
                regimes.append(_APART)
                slopes.append(_LEVEL)
                continue
            x, y, z = pressure * nx, pressure * ny, pressure * nz
            if bound:
                tx = vx + wy * rz - wz * ry - sx - opening * nx
                ty = vy + wz * rx - wx * rz - sy - opening * ny
                tz = vz + wx * ry - wy * rx - sz - opening * nz
                square = tx * tx + ty * ty + tz * tz
                _, ux, uy, uz = way
                if square > slow and not (was & _SLIDING and tx * ux + ty * uy + tz * uz < 0):
                    regime += _SLIDING
                    speed = math.sqrt(square)
                    tx, ty, tz = tx / speed, ty / speed, tz / speed
                    slopes.append((bound / speed, tx, ty, tz))
                    x, y, z = x - bound * tx, y - bound * ty, z - bound * tz
                else:
                    regime += _HOLDING
                    hold = bound / CREEP
                    slopes.append((hold, 0.0, 0.0, 0.0))
                    x, y, z = x - hold * tx, y - hold * ty, z - hold * tz
            else:
                slopes.append(_LEVEL)
            regimes.append(regime)
            fx += x
            fy += y
            fz += z
            mx += ry * z - rz * y
            my += rz * x - rx * z
            mz += rx * y - ry * x
        return fx, fy, fz, mx, my, mz

    def stiffness(self) -> list[float] | None:
        """How that impulse falls with the relative velocities; None if nothing touches.

        Returns:
            The triangle of a symmetric matrix, as in `elimination`.
        """
        if not any(self.regimes):
            return None
        nx, ny, nz = self.normal
        # Of what acts along the normal: the sum, and its first and second moments.
        n = n_x = n_y = n_z = n_xx = n_xy = n_yy = n_xz = n_yz = n_zz = 0.0
        # Of what acts alike all ways.
        s = s_x = s_y = s_z = s_xx = s_xy = s_yy = s_xz = s_yz = s_zz = 0.0
        slid: list[tuple[float, float, float, float, float, float, float]] = []
        for point, regime, slope in zip(self.points, self.regimes, self.slopes, strict=True):
            if not regime:
                continue
            rx, ry, rz, ax, ay, az = point[:6]
            stiff = point[7] if regime & _PRESSING else 0.0
            hold, tx, ty, tz = slope
            if hold:
                stiff -= hold
                x, y, z = hold * rx, hold * ry, hold * rz
                s += hold
                s_x += x
                s_y += y
                s_z += z
                s_xx += x * rx
                s_xy += x * ry
                s_yy += y * ry
                s_xz += x * rz
                s_yz += y * rz
                s_zz += z * rz
                if regime & _SLIDING:
                    slid.append(
                        (
                            *(hold, tx, ty, tz),
                            *(ry * tz - rz * ty, rz * tx - rx * tz, rx * ty - ry * tx),
                        )
                    )
            x, y, z = stiff * ax, stiff * ay, stiff * az
            n += stiff
            n_x += x
            n_y += y
            n_z += z
            n_xx += x * ax
            n_xy += x * ay
            n_yy += y * ay
            n_xz += x * az
            n_yz += y * az
            n_zz += z * az
        x, y, z = n * nx, n * ny, n * nz
        out = [
            *(x * nx + s, x * ny, y * ny + s, x * nz, y * nz, z * nz + s),
            *(nx * n_x, ny * n_x - s_z, nz * n_x + s_y, n_xx + s_yy + s_zz),
            *(nx * n_y + s_z, ny * n_y, nz * n_y - s_x, n_xy - s_xy, n_yy + s_xx + s_zz),
            *(nx * n_z - s_y, ny * n_z + s_x, nz * n_z),
            *(n_xz - s_xz, n_yz - s_yz, n_zz + s_xx + s_yy),
        ]
        for hold, *way in slid:
            # Along the way that it slides friction is what it is.
            k = 0
            for p, a in enumerate(way):
                a *= hold
                for b in way[: p + 1]:
                    out[k] -= a * b
                    k += 1
        return out


class Problem:
    """Contacts that belong together.

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
        self._patches: list[_Patch] = []
        for contact in contacts:
            first, second = contact.first.mobile, contact.second.mobile
            one = None if first is None else index[id(first)]
            self._patches.append(_Patch(contact, one, index[id(second)], seconds))
        self._wanted = [_six(mobile.speed) for mobile in mobiles]
        self._order: list[int] | None = None
        self._rank: dict[int, int] = {}
        self._masses = [_mass(mobile) for mobile in mobiles]

    def solve(self) -> int:
        """Find the velocities and the impulses; steps of Newton's method taken."""
        patches = self._patches
        speeds: list[Six] = [_six(mobile.speed) for mobile in self.mobiles]
        steps = 0
        pressures = [c.pressures if any(c.pressures) else None for c in self.contacts]
        for patch, known in zip(patches, pressures, strict=True):
            if known is None:
                patch.expected = patch.pressures(patch.relative(speeds))
        # Otherwise nothing is in the way of anything.
        if any(pressures) or any(patch.expected for patch in patches):
            speeds = [_six(mobile.before or mobile.speed) for mobile in self.mobiles]
            for _ in range(PASSES):
                speeds, taken = self._least(speeds, pressures)
                steps += taken
                before, pressures = pressures, self._pressures(speeds)
                if self._in_line(speeds, before, pressures):
                    break
        for contact, pressing in zip(self.contacts, pressures, strict=True):
            contact.pressures = pressing or [0.0] * len(contact.points)
        for mobile, found in zip(self.mobiles, speeds, strict=True):
            mobile.speed[:] = found
        return steps

    @property
    def settled(self) -> bool:
        """Whether what presses has settled, of the little that contacts give."""
        speeds = [mobile.speed for mobile in self.mobiles]
        return all(
            not pressure or abs(opening) < SETTLED
            for patch in self._patches
            if any(patch.contact.pressures)
            for pressure, opening in zip(
                patch.contact.pressures, patch.openings(patch.relative(speeds)), strict=True
            )
        )

    def lasting(
        self, speeds: dict[int, Six], spans: dict[int, float], endless: set[str], most: float
    ) -> float:
        """Seconds for which these contacts stay as they are while everything goes on.

        Args:
            speeds: with which it does, by the `id` of each mobile.
            spans: inches across the bodies among them, likewise.
            endless: names of things that are the same wherever they are touched.
            most: more than so much does not matter.
        """
        going = [speeds[id(mobile)] for mobile in self.mobiles]
        for patch in self._patches:
            contact, relative = patch.contact, patch.relative(going)
            one, two = contact.first.mobile, contact.second.mobile
            across = spans.get(id(two), ARM_SPAN)
            idle = not any(contact.pressures)
            passing = patch.passing(relative, across) if idle else 0.0
            if passing < most:
                across = min(spans.get(id(one), math.inf), across)
                ends = contact.key[0] not in endless
                most = max(passing, patch.lasting(relative, across, most, ends=ends))
        return most

    def _least(self, speeds: list[Six], bounding: list[Pressures]) -> tuple[list[Six], int]:
        """Newton's method: velocities at which impulses and momentum balance.

        It ends before that once pressures are as they will be, but not those that bound friction.

        Args:
            speeds: to begin with.
            bounding: pressures by which friction is bounded.

        Returns:
            Velocities, and the steps taken.
        """
        bounds: list[Pressures] = [
            None if pressing is None else [contact.friction * each for each in pressing]
            for contact, pressing in zip(self.contacts, bounding, strict=True)
        ]
        last: list[Pressures] | None = None
        slope = self._slope(speeds, bounds, _AS_BEFORE)
        for step in range(MOST_STEPS):
            bold = step < BOLD_STEPS
            regimes = [patch.regimes for patch in self._patches]
            system = self._system()
            change = system.solve(_negative(slope))
            there = _plus(speeds, change)
            slope_there = self._slope(there, bounds, _CAUGHT if bold else _NOTHING)
            if regimes == [patch.regimes for patch in self._patches]:
                # All contacts do as before: but for how what slides turns, this is the solution.
                rest = system.solve(_negative(slope_there))
                if _most(rest) < SOLVED:
                    return _plus(there, rest), step + 1
            elif _most(change) < SURE:
                return there, step + 1
            if bold:
                found = self._pressures(there)
                settled = last is not None and _alike(last, found)
                if settled and not self._in_line(there, bounding, found):
                    return there, step + 1
                last = found
            if step < BOLD_STEPS - 1:
                speeds, slope = there, slope_there
            elif bold:
                speeds, slope = there, self._slope(there, bounds)
            else:
                speeds, slope = self._far(speeds, change, slope, there, slope_there, bounds)
        return speeds, MOST_STEPS

    def _pressures(self, speeds: list[Six]) -> list[Pressures]:
        """Impulses along the normal at the points of each contact."""
        return [patch.pressures(patch.relative(speeds)) for patch in self._patches]

    def _in_line(
        self, speeds: list[Six], bounding: list[Pressures], found: list[Pressures]
    ) -> bool:
        """Whether the pressures by which friction was bounded are those found with it."""
        off = _tolerance(found)
        return all(
            patch.agrees(patch.relative(speeds), old, now, off)
            for patch, old, now in zip(self._patches, bounding, found, strict=True)
        )

    def _slope(
        self, speeds: list[Six], bounds: list[Pressures], guess: int = _NOTHING
    ) -> list[list[float]]:
        """How the function to be made least grows with each velocity."""
        out = [
            _inert(mass, speed, wanted)
            for mass, speed, wanted in zip(self._masses, speeds, self._wanted, strict=True)
        ]
        for patch, bound in zip(self._patches, bounds, strict=True):
            push = patch.push(patch.relative(speeds), bound, guess)
            if push is _STILL:
                continue
            fx, fy, fz, mx, my, mz = push
            two = out[patch.two]
            if patch.columns_two is None:
                two[0] -= fx
                two[1] -= fy
                two[2] -= fz
                two[3] -= mx
                two[4] -= my
                two[5] -= mz
            else:
                for k, (a, b, c, d, e, f) in patch.columns_two:
                    two[k] -= a * fx + b * fy + c * fz + d * mx + e * my + f * mz
            if patch.one is None:
                continue
            one = out[patch.one]
            if patch.columns_one is not None:
                for k, (a, b, c, d, e, f) in patch.columns_one:
                    one[k] += a * fx + b * fy + c * fz + d * mx + e * my + f * mz
            else:
                assert patch.lever is not None
                x, y, z = patch.lever
                one[0] += fx
                one[1] += fy
                one[2] += fz
                one[3] += mx + y * fz - z * fy
                one[4] += my + z * fx - x * fz
                one[5] += mz + x * fy - y * fx
        return out

    def _system(self) -> Eliminated:
        """How that growth itself grows, where it was last asked for."""
        blocks = [list(mass) for mass in self._masses]
        beside: dict[tuple[int, int], list[Six]] = {}
        if self._order is None:
            pairs = {(p.one, p.two) for p in self._patches if p.one is not None}
            self._order = order(len(blocks), pairs)
            self._rank = {body: k for k, body in enumerate(self._order)}
        rank = self._rank
        for patch in self._patches:
            stiffness = patch.stiffness()
            if stiffness is None:
                continue
            own = blocks[patch.two]
            if patch.columns_two is None:
                for k, value in enumerate(stiffness):
                    own[k] += value
            else:
                _add_linked(own, patch.columns_two, stiffness)
            if patch.one is None:
                continue
            if patch.columns_one is not None:
                between = _add_linked(blocks[patch.one], patch.columns_one, stiffness)
            else:
                assert patch.lever is not None
                between = _add_shifted(blocks[patch.one], patch.lever, stiffness)
            # Rows of the second body's unknowns, columns of the first one's.
            assert patch.columns_two is None
            pair = (patch.two, patch.one)
            if rank[patch.one] < rank[patch.two]:
                pair = (patch.one, patch.two)
                between = list(zip(*between, strict=True))
            known = beside.get(pair)
            if known is not None:
                between = _plus(known, between)
            beside[pair] = between
        return Eliminated(blocks, beside, self._order)

    def _far(
        self,
        speeds: list[Six],
        change: list[Six],
        slope: list[list[float]],
        there: list[Six],
        slope_there: list[list[float]],
        bounds: list[Pressures],
    ) -> tuple[list[Six], list[list[float]]]:
        """Where along a step the function is about least, and its slope there.

        Args:
            speeds: at the step's beginning.
            change: the step.
            slope: at its beginning.
            there: the speeds at its end.
            slope_there: at its end.
            bounds: of friction.
        """
        start, end = _product(slope, change), _product(slope_there, change)
        small = SHALLOW * abs(start)
        low, high, at_low, at_high = 0.0, 1.0, start, end
        if end <= small:
            return there, slope_there
        for _ in range(MOST_TRIALS):
            far = low - at_low * (high - low) / (at_high - at_low)
            edge = 0.05 * (high - low)
            far = min(max(far, low + edge), high - edge)
            there = _plus(speeds, change, far)
            slope_there = self._slope(there, bounds)
            here = _product(slope_there, change)
            if abs(here) <= small:
                break
            if here < 0:
                low, at_low = far, here
            else:
                high, at_high = far, here
        return there, slope_there


def _least(gap: float, seconds: float) -> float:
    """Speed at which a contact opens at least, or may close at most, inches a second."""
    if gap > 0:
        return -gap / seconds
    return min(-gap * (RECOVERY / TICK), FASTEST_RECOVERY)


def _columns(screws: Sequence[tuple[Vector, Vector]], origin: Vector) -> list[tuple[int, Six]]:
    """Velocity of a link at a point and its spin for a unit of each coordinate that moves it."""
    x, y, z = origin
    out: list[tuple[int, Six]] = []
    for k, ((p, q, r), (u, v, w)) in enumerate(screws):
        column = (u + q * z - r * y, v + r * x - p * z, w + p * y - q * x, p, q, r)
        if any(column):
            out.append((k, column))
    return out


def _moved(columns: list[tuple[int, Six]], rates: Sequence[float]) -> Six:
    """Velocity and spin of a link at some rates of its coordinates."""
    a = b = c = d = e = f = 0.0
    for k, (u, v, w, x, y, z) in columns:
        rate = rates[k]
        a += rate * u
        b += rate * v
        c += rate * w
        d += rate * x
        e += rate * y
        f += rate * z
    return a, b, c, d, e, f


def _mass(mobile: Mobile) -> list[float]:
    """Mass and inertia as the triangle of a 6 x 6 matrix."""
    out = [0.0] * 21
    if mobile.inertias is not None:
        for k, inertia in zip(_DIAGONAL, mobile.inertias, strict=True):
            out[k] = inertia
    else:
        assert mobile.inertia is not None
        out[0] = out[2] = out[5] = mobile.mass
        out[9], _, _, out[13], out[14], _, out[18], out[19], out[20] = mobile.inertia
    return out


def _inert(mass: list[float], speed: Six, wanted: Sequence[float]) -> list[float]:
    """Momentum that is missing: of a body, or of the arm's coordinates."""
    a, b, c, d, e, f = speed
    u, v, w, x, y, z = wanted
    d, e, f = d - x, e - y, f - z
    return [
        mass[0] * (a - u),
        mass[2] * (b - v),
        mass[5] * (c - w),
        mass[9] * d + mass[13] * e + mass[18] * f,
        mass[13] * d + mass[14] * e + mass[19] * f,
        mass[18] * d + mass[19] * e + mass[20] * f,
    ]


def _add_linked(
    block: list[float], columns: list[tuple[int, Six]], stiffness: list[float]
) -> list[Six]:
    """Add a stiffness against a link to the arm's own block.

    Returns:
        What couples the arm to the other thing: a column for each coordinate.
    """
    (a, b, c, d, e, f, g, h, i, j, k, m, n, o, p, q, r, s, t, u, v) = stiffness
    out: list[Six] = [_STILL] * 6
    for at, (x, y, z, ex, ey, ez) in columns:
        fx, fy, fz = a * x + b * y + d * z, b * x + c * y + e * z, d * x + e * y + f * z
        mx, my, mz = g * x + h * y + i * z, k * x + m * y + n * z, q * x + r * y + s * z
        if ex or ey or ez:
            fx += g * ex + k * ey + q * ez
            fy += h * ex + m * ey + r * ez
            fz += i * ex + n * ey + s * ez
            mx += j * ex + o * ey + t * ez
            my += o * ex + p * ey + u * ez
            mz += t * ex + u * ey + v * ez
        out[at] = (-fx, -fy, -fz, -mx, -my, -mz)
        start = at * (at + 1) // 2
        for other, (x, y, z, ex, ey, ez) in columns:
            if other > at:
                break
            # Cables move most links without turning them.
            product = fx * x + fy * y + fz * z
            if ex or ey or ez:
                product += mx * ex + my * ey + mz * ez
            block[start + other] += product
    return out


def _add_shifted(block: list[float], lever: Vector, stiffness: list[float]) -> list[Six]:
    """Add a stiffness to the block of a body whose centre of mass is elsewhere.

    Args:
        block: of the body.
        lever: from its centre of mass to the reference point.
        stiffness: there.

    Returns:
        What couples it to the other body: a column for each of this one's unknowns.
    """
    x, y, z = lever
    (a, b, c, d, e, f, g, h, i, j, k, m, n, o, p, q, r, s, t, u, v) = stiffness
    # A (a b d, b c e, d e f) acts on velocities, B (columns g h i, k m n, q r s) between them and
    # spins, C (j o t, o p u, t u v) on spins. A spin is a velocity there of spin x lever.
    g2, k2, q2 = g - (b * z - d * y), k - (d * x - a * z), q - (a * y - b * x)
    h2, m2, r2 = h - (c * z - e * y), m - (e * x - b * z), r - (b * y - c * x)
    i2, n2, s2 = i - (e * z - f * y), n - (f * x - d * z), s - (d * y - e * x)
    # Moments of the columns of B about the centre of mass.
    gx, gy, gz = h * z - i * y, i * x - g * z, g * y - h * x
    kx, ky, kz = m * z - n * y, n * x - k * z, k * y - m * x
    qx, qy, qz = r * z - s * y, s * x - q * z, q * y - r * x
    block[0] += a
    block[1] += b
    block[2] += c
    block[3] += d
    block[4] += e
    block[5] += f
    block[6] += g2
    block[7] += h2
    block[8] += i2
    block[9] += j - gx - (h2 * z - i2 * y)
    block[10] += k2
    block[11] += m2
    block[12] += n2
    block[13] += o - kx - (i2 * x - g2 * z)
    block[14] += p - ky - (n2 * x - k2 * z)
    block[15] += q2
    block[16] += r2
    block[17] += s2
    block[18] += t - qx - (g2 * y - h2 * x)
    block[19] += u - qy - (k2 * y - m2 * x)
    block[20] += v - qz - (q2 * y - r2 * x)
    return [
        (-a, -b, -d, -g, -k, -q),
        (-b, -c, -e, -h, -m, -r),
        (-d, -e, -f, -i, -n, -s),
        (-g2, -h2, -i2, gx - j, kx - o, qx - t),
        (-k2, -m2, -n2, gy - o, ky - p, qy - u),
        (-q2, -r2, -s2, gz - t, kz - u, qz - v),
    ]


def _tolerance(pressures: list[Pressures]) -> float:
    """By how much pressures may differ and agree."""
    return AGREED * max((max(each) for each in pressures if each), default=0.0)


def _alike(before: list[Pressures], now: list[Pressures]) -> bool:
    """Whether pressures are those of before."""
    off = _tolerance(now)
    for old, new in zip(before, now, strict=True):
        if old is None or new is None:
            if max(old or new or (0.0,)) > off:
                return False
        elif any(abs(a - b) > off for a, b in zip(old, new, strict=True)):
            return False
    return True


def _six(values: Sequence[float]) -> Six:
    a, b, c, d, e, f = values
    return a, b, c, d, e, f


def _negative(sixes: Sequence[Sequence[float]]) -> list[Six]:
    return [(-a, -b, -c, -d, -e, -f) for a, b, c, d, e, f in sixes]


def _plus(sixes: Sequence[Six], others: Sequence[Six], factor: float = 1.0) -> list[Six]:
    return [
        (
            a + factor * u,
            b + factor * v,
            c + factor * w,
            d + factor * x,
            e + factor * y,
            f + factor * z,
        )
        for (a, b, c, d, e, f), (u, v, w, x, y, z) in zip(sixes, others, strict=True)
    ]


def _product(sixes: Sequence[Sequence[float]], others: Sequence[Six]) -> float:
    total = 0.0
    for (a, b, c, d, e, f), (u, v, w, x, y, z) in zip(sixes, others, strict=True):
        total += a * u + b * v + c * w + d * x + e * y + f * z
    return total


def _most(sixes: Sequence[Six]) -> float:
    return max(max(max(six), -min(six)) for six in sixes)
