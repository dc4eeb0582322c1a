"""A contact as numbers: what presses there, what friction does, and how stiff it is against motion.

Each of its points is apart or pressing, and beside that its friction holds or slides; while none of
them changes, impulses are linear in velocities.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from itertools import repeat
from typing import NamedTuple

from trs80arm.arm.contact.clock import TICK
from trs80arm.arm.contact.contacts import Contact
from trs80arm.arm.contact.sixes import STILL, Six
from trs80arm.arm.shapes import Vector, cross, minus

GIVE = 1e-4
"""Softness of a contact in a tick, as a fraction of the bodies' own readiness to move."""
CREEP = 1e-3
"""Speed at which friction that holds lets slide at its limit, inches a second."""
RECOVERY = 0.2
"""Part of an overlap that is taken back in a tick."""
FASTEST_RECOVERY = 1.0
"""Inches a second at which overlap is taken back at most."""
DRIFT = 2e-4
"""Inches by which what presses may part or come closer while it goes on as before."""
SHIFT = 0.1
"""Inches by which it may shift on something that has an end."""
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
NOTHING, AS_BEFORE, CAUGHT, HELD = 0, 1, 2, 3
"""What may be guessed of contacts, for a step of Newton's method to begin with: that those press
that pressed before or are expected to, and that those hold that hardly slid; that those hold now
that slid, and would now slide the other way; that beside them those go on holding that held."""
_LEVEL = (0.0, 0.0, 0.0, 0.0)

Columns = list[tuple[int, Six]]
"""Of an arm's coordinates: which, and how it moves a link for a unit."""
Slope = tuple[float, float, float, float]
"""Of friction at a point: how it grows with the speed there, and the way in which that slides."""
Pressures = list[float] | None
"""At each point of a contact; None where nothing presses at all."""


class Patch:
    """A contact between two of the things that move, or with what stands fast.

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
        "_stiff",
        "columns_one",
        "columns_two",
        "contact",
        "expected",
        "found",
        "lever",
        "normal",
        "one",
        "overheld",
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
        self.overheld = False
        self.found: Pressures = None
        self._stiff: tuple[list[int], list[Slope], list[float]] | None = None
        self._nothing = [_APART] * len(contact.points)
        self.regimes = self._nothing
        self.slopes = [_LEVEL] * len(contact.points)

    @property
    def points(self) -> list[tuple[float, ...]]:
        """Numbers of each point.

        Its place and its moment about the normal, from the reference point; the speed at which it
        opens at least, its stiffness.
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
        moved: list[tuple[Columns, Six]] = []
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
        for (px, py, pz), gap in contact.points:
            rx, ry, rz = px - x, py - y, pz - z
            ax, ay, az = ry * nz - rz * ny, rz * nx - rx * nz, rx * ny - ry * nx
            own = ease
            for columns, inertias in moved:
                for at, (a, b, c, d, e, f) in columns:
                    along = nx * a + ny * b + nz * c + ax * d + ay * e + az * f
                    own += along * along / inertias[at]
            stiff = 1 / (give * max(own, _EASIEST))
            out.append((rx, ry, rz, ax, ay, az, _least(gap, self._seconds), stiff))
        return out

    def leaves_alone(self, relative: Six) -> bool:
        """Whether the two certainly do not press on each other, moving like that."""
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
            if self.contact.surface is not None:
                u, v, w = self.contact.surface
                return a - u, b - v, c - w, d, e, f
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
        return [along + ax * wx + ay * wy + az * wz for _, _, _, ax, ay, az, _, _ in self.points]

    def pressures(self, relative: Six) -> Pressures:
        """Impulse along the normal at each point."""
        if self.leaves_alone(relative):
            return None
        out = [
            stiff * (least - opening) if opening < least else 0.0
            for (_, _, _, _, _, _, least, stiff), opening in zip(
                self.points, self.openings(relative), strict=True
            )
        ]
        return out if any(out) else None

    def sliding(self, relative: Six) -> list[float]:
        """Speed at which each contact slides, inches a second."""
        nx, ny, nz = self.normal
        vx, vy, vz, wx, wy, wz = relative
        out = []
        for (rx, ry, rz, _, _, _, _, _), opening in zip(
            self.points, self.openings(relative), strict=True
        ):
            tx = vx + wy * rz - wz * ry - opening * nx
            ty = vy + wz * rx - wx * rz - opening * ny
            tz = vz + wx * ry - wy * rx - opening * nz
            out.append(math.sqrt(tx * tx + ty * ty + tz * tz))
        return out

    def agrees(
        self, speeds: Sequence[Six], bounding: Pressures, pressures: Pressures, off: float
    ) -> bool:
        """Whether friction is in line with the pressures found.

        Args:
            speeds: of all that moves.
            bounding: pressures with which friction was bounded.
            pressures: found.
            off: by how much they may differ, where friction does not hold with less than it might.
        """
        if bounding is None and pressures is None:
            return True
        nothing = [0.0] * len(self._nothing)
        bounding, pressures = bounding or nothing, pressures or nothing
        apart = [abs(a - b) > off for a, b in zip(bounding, pressures, strict=True)]
        if True not in apart:
            return True
        slid = self.sliding(self.relative(speeds))
        return all(
            speed <= CREEP and old * speed <= now * CREEP
            for wrong, speed, old, now in zip(apart, slid, bounding, pressures, strict=True)
            if wrong
        )

    def push(self, relative: Six, bounds: Pressures, guess: int) -> Six:
        """Impulse and its moment about the reference point, on the second thing.

        Notes down for `stiffness` what each contact does, in `found` what presses, and in
        `overheld` whether anything was held that would slide but for the guess.

        Args:
            relative: of the second thing against the first.
            bounds: of friction at each point.
            guess: what is taken for granted, of `NOTHING` and so on.
        """
        self.overheld = False
        beginning = guess == AS_BEFORE
        presses: Iterable[float] = _NEVER
        if beginning:
            presses = bounds or self.expected or _NEVER
        if bounds is None and presses is _NEVER and self.leaves_alone(relative):
            self.regimes, self.found = self._nothing, None
            return STILL
        nx, ny, nz = self.normal
        vx, vy, vz, wx, wy, wz = relative
        along = nx * vx + ny * vy + nz * vz
        fx = fy = fz = mx = my = mz = 0.0
        regimes_before, slopes_before = self.regimes, self.slopes
        remembers, holds_on = guess >= CAUGHT, guess == HELD
        self.regimes = regimes = []
        self.slopes = slopes = []
        found: list[float] = []
        slow = _SLOW if beginning else _CREEPING
        for (rx, ry, rz, ax, ay, az, least, stiff), bound, known in zip(
            self._points or self.points, bounds or _NEVER, presses, strict=False
        ):
            opening = along + ax * wx + ay * wy + az * wz
            if opening < least or known:
                regime, pressure = _PRESSING, stiff * (least - opening)
            elif bound:
                regime, pressure = _APART, 0.0
            else:
                regimes.append(_APART)
                slopes.append(_LEVEL)
                found.append(0.0)
                continue
            found.append(pressure)
            x, y, z = pressure * nx, pressure * ny, pressure * nz
            if bound:
                tx = vx + wy * rz - wz * ry - opening * nx
                ty = vy + wz * rx - wx * rz - opening * ny
                tz = vz + wx * ry - wy * rx - opening * nz
                square = tx * tx + ty * ty + tz * tz
                slides = square > slow
                if slides and remembers:
                    was = regimes_before[len(regimes)]
                    if was & _SLIDING:
                        _, ux, uy, uz = slopes_before[len(regimes)]
                        slides = tx * ux + ty * uy + tz * uz >= 0
                    elif was & _HOLDING and holds_on:
                        self.overheld, slides = True, False
                if slides:
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
        self.found = found if any(found) else None
        return fx, fy, fz, mx, my, mz

    def stiffness(self) -> list[float] | None:
        """How that impulse falls with the relative velocities; None if nothing touches.

        Returns:
            The triangle of a symmetric matrix, as in `elimination`.
        """
        if not any(self.regimes):
            return None
        if self._stiff is not None:
            regimes, slopes, known = self._stiff
            if regimes == self.regimes and slopes == self.slopes:
                return known
        nx, ny, nz = self.normal
        # Of what acts along the normal: the sum, and its first and second moments.
        n = n_x = n_y = n_z = n_xx = n_xy = n_yy = n_xz = n_yz = n_zz = 0.0
        # Of what acts alike all ways.
        s = s_x = s_y = s_z = s_xx = s_xy = s_yy = s_xz = s_yz = s_zz = 0.0
        slid: list[tuple[float, float, float, float, float, float, float]] = []
        for point, regime, slope in zip(self.points, self.regimes, self.slopes, strict=True):
            if not regime:
                continue
            rx, ry, rz, ax, ay, az, _, stiff = point
            if not regime & _PRESSING:
                stiff = 0.0
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
        self._stiff = self.regimes, self.slopes, out
        return out


class Hold(NamedTuple):
    """All patches by which the arm touches one body.

    Most of its coordinates move all of its links there alike: a hand's fingers differ in one.

    Attributes:
        arm: index of the arm's mobile.
        body: index of the body's.
        alike: columns of the coordinates that move all of these links alike.
        patches: index of each, and the columns of its link's other coordinates.
    """

    arm: int
    body: int
    alike: Columns
    patches: list[tuple[int, Columns]]

    def relatives(self, speeds: Sequence[Six]) -> list[Six]:
        """For each patch, velocity and spin of the body against its link."""
        rates = speeds[self.arm]
        a, b, c, d, e, f = speeds[self.body]
        u, v, w, x, y, z = _moved(self.alike, rates)
        a, b, c, d, e, f = a - u, b - v, c - w, d - x, e - y, f - z
        out = []
        for _, own in self.patches:
            u, v, w, x, y, z = _moved(own, rates)
            out.append((a - u, b - v, c - w, d - x, e - y, f - z))
        return out


def holds(patches: Sequence[Patch]) -> list[Hold]:
    """What of some patches are the arm's with a body, by body."""
    found: dict[tuple[int, int], list[tuple[int, Columns]]] = {}
    for k, patch in enumerate(patches):
        if patch.one is not None and patch.columns_one is not None:
            found.setdefault((patch.one, patch.two), []).append((k, patch.columns_one))
    out = []
    for (arm, body), members in found.items():
        columns = [theirs for _, theirs in members]
        alike = [each for each in columns[0] if all(each in other for other in columns[1:])]
        own = [(k, [each for each in theirs if each not in alike]) for k, theirs in members]
        out.append(Hold(arm, body, alike, own))
    return out


def _least(gap: float, seconds: float) -> float:
    """Speed at which a contact opens at least, or may close at most, inches a second."""
    if gap > 0:
        return -gap / seconds
    return min(-gap * (RECOVERY / TICK), FASTEST_RECOVERY)


def _columns(screws: Sequence[tuple[Vector, Vector]], origin: Vector) -> Columns:
    """Velocity of a link at a point and its spin for a unit of each coordinate that moves it."""
    x, y, z = origin
    out: Columns = []
    for k, ((p, q, r), (u, v, w)) in enumerate(screws):
        column = (u + q * z - r * y, v + r * x - p * z, w + p * y - q * x, p, q, r)
        if any(column):
            out.append((k, column))
    return out


def _moved(columns: Columns, rates: Sequence[float]) -> Six:
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
