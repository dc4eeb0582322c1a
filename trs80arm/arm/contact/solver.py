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

from trs80arm.arm.contact.blocks import (
    add_linked,
    add_own,
    add_shifted,
    add_up,
    mass_block,
    missing_momentum,
)
from trs80arm.arm.contact.contacts import Contact, Mobile
from trs80arm.arm.contact.elimination import Eliminated, order
from trs80arm.arm.contact.patch import AS_BEFORE, CAUGHT, HELD, NOTHING, Patch, Pressures, holds
from trs80arm.arm.contact.sixes import STILL, Six, greatest, negative, plus, product, six

SOLVED = 1e-3
"""Change of velocity below which Newton's method has arrived, if each contact does as it did."""
SURE = 1e-6
"""Change of velocity below which it has arrived in any case."""
MOST_STEPS = 40
BOLD_STEPS = 10
"""Of them those that go all the way at first, to find at once all that touches and what holds."""
HOLDING_STEPS = 3
"""Of those the first, in which what holds goes on holding until it is known what presses."""
SHALLOW = 0.1
"""Part of the slope at a step's beginning at which, along the step, the least value is reached."""
MOST_TRIALS = 12
"""Looks along a step at most."""
EDGE = 0.01
"""Part of what is left of a step that is not looked at, at either end."""
PASSES = 6
"""Times that friction's bounds are brought in line with the pressure, at most."""
AGREED = 0.05
"""Part of the greatest pressure by which bounds and pressures may differ."""
SETTLED = 1e-2
"""Inches a second below which what presses neither parts nor comes closer."""
ARM_SPAN = 4.0
"""Inches across the area in which a link touches what stands fast, at most."""


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
        self._patches: list[Patch] = []
        for contact in contacts:
            first, second = contact.first.mobile, contact.second.mobile
            one = None if first is None else index[id(first)]
            self._patches.append(Patch(contact, one, index[id(second)], seconds))
        self._holds = holds(self._patches)
        self._others = [k for k, patch in enumerate(self._patches) if patch.columns_one is None]
        self._wanted = [six(mobile.speed) for mobile in mobiles]
        self._order: list[int] | None = None
        self._rank: dict[int, int] = {}
        self._masses = [mass_block(mobile) for mobile in mobiles]

    def solve(self) -> int:
        """Find the velocities and the impulses; steps of Newton's method taken."""
        patches = self._patches
        speeds: list[Six] = [six(mobile.speed) for mobile in self.mobiles]
        steps = 0
        pressures = [c.pressures if any(c.pressures) else None for c in self.contacts]
        for patch, known in zip(patches, pressures, strict=True):
            if known is None:
                patch.expected = patch.pressures(patch.relative(speeds))
        # Otherwise nothing is in the way of anything.
        if any(pressures) or any(patch.expected for patch in patches):
            speeds = [six(mobile.before or mobile.speed) for mobile in self.mobiles]
            for _ in range(PASSES):
                speeds, taken = self._least(speeds, pressures)
                steps += taken
                before, pressures = pressures, self._pressures(speeds)
                if self._in_line(speeds, before, pressures):
                    break
        for contact, pressing in zip(self.contacts, pressures, strict=True):
            contact.press(pressing or [0.0] * len(contact.points))
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
        slope = self._slope(speeds, bounds, AS_BEFORE)
        for step in range(MOST_STEPS):
            bold = step < BOLD_STEPS
            regimes = [patch.regimes for patch in self._patches]
            system = self._system()
            change = system.solve(negative(slope))
            there = plus(speeds, change)
            guess = HELD if step < HOLDING_STEPS else CAUGHT if bold else NOTHING
            slope_there = self._slope(there, bounds, guess)
            alike = regimes == [patch.regimes for patch in self._patches]
            if alike and any(patch.overheld for patch in self._patches):
                # What presses is known: now, what it holds.
                slope_there = self._slope(there, bounds, CAUGHT)
                alike = regimes == [patch.regimes for patch in self._patches]
            if alike:
                # All contacts do as before: but for how what slides turns, this is the solution.
                rest = system.solve(negative(slope_there))
                if greatest(rest) < SOLVED:
                    return plus(there, rest), step + 1
            elif greatest(change) < SURE:
                return there, step + 1
            if bold:
                found = [patch.found for patch in self._patches]
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
            patch.agrees(speeds, old, now, off)
            for patch, old, now in zip(self._patches, bounding, found, strict=True)
        )

    def _slope(
        self, speeds: list[Six], bounds: list[Pressures], guess: int = NOTHING
    ) -> list[list[float]]:
        """How the function to be made least grows with each velocity."""
        out = [
            missing_momentum(mass, speed, wanted)
            for mass, speed, wanted in zip(self._masses, speeds, self._wanted, strict=True)
        ]
        for k in self._others:
            patch = self._patches[k]
            push = patch.push(patch.relative(speeds), bounds[k], guess)
            if push is STILL:
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
                for at, (a, b, c, d, e, f) in patch.columns_two:
                    two[at] -= a * fx + b * fy + c * fz + d * mx + e * my + f * mz
            if patch.one is None:
                continue
            assert patch.lever is not None
            one = out[patch.one]
            x, y, z = patch.lever
            one[0] += fx
            one[1] += fy
            one[2] += fz
            one[3] += mx + y * fz - z * fy
            one[4] += my + z * fx - x * fz
            one[5] += mz + x * fy - y * fx
        for hold in self._holds:
            one, two = out[hold.arm], out[hold.body]
            whole = STILL
            for (k, own), relative in zip(hold.patches, hold.relatives(speeds), strict=True):
                push = self._patches[k].push(relative, bounds[k], guess)
                if push is STILL:
                    continue
                fx, fy, fz, mx, my, mz = push
                a, b, c, d, e, f = whole
                whole = (a + fx, b + fy, c + fz, d + mx, e + my, f + mz)
                for at, (a, b, c, d, e, f) in own:
                    one[at] += a * fx + b * fy + c * fz + d * mx + e * my + f * mz
            if whole is STILL:
                continue
            fx, fy, fz, mx, my, mz = whole
            two[0] -= fx
            two[1] -= fy
            two[2] -= fz
            two[3] -= mx
            two[4] -= my
            two[5] -= mz
            for at, (a, b, c, d, e, f) in hold.alike:
                one[at] += a * fx + b * fy + c * fz + d * mx + e * my + f * mz
        return out

    def _system(self) -> Eliminated:
        """How that growth itself grows, where it was last asked for."""
        blocks = [list(mass) for mass in self._masses]
        beside: dict[tuple[int, int], list[Six]] = {}
        if self._order is None:
            pairs = {(p.one, p.two) for p in self._patches if p.one is not None}
            self._order = order(len(blocks), pairs)
            self._rank = {body: k for k, body in enumerate(self._order)}
        for k in self._others:
            patch = self._patches[k]
            stiffness = patch.stiffness()
            if stiffness is None:
                continue
            if patch.columns_two is not None:
                add_linked(blocks[patch.two], patch.columns_two, stiffness)
                continue
            add_up(blocks[patch.two], stiffness)
            if patch.one is not None:
                assert patch.lever is not None
                between = add_shifted(blocks[patch.one], patch.lever, stiffness)
                self._couple(beside, patch.two, patch.one, between)
        for hold in self._holds:
            own, whole = blocks[hold.arm], [0.0] * 21
            found = []
            for k, columns in hold.patches:
                stiffness = self._patches[k].stiffness()
                if stiffness is not None:
                    add_up(whole, stiffness)
                    found.append((columns, stiffness))
            if found:
                add_up(blocks[hold.body], whole)
                between = add_linked(own, hold.alike, whole)
                for columns, stiffness in found:
                    add_own(own, between, columns, hold.alike, stiffness)
                self._couple(beside, hold.body, hold.arm, between)
        return Eliminated(blocks, beside, self._order)

    def _couple(
        self, beside: dict[tuple[int, int], list[Six]], one: int, other: int, between: list[Six]
    ) -> None:
        """Add what couples two bodies: rows of the first's unknowns, columns of the other's."""
        pair = (one, other)
        if self._rank[other] < self._rank[one]:
            pair = (other, one)
            between = list(zip(*between, strict=True))
        known = beside.get(pair)
        beside[pair] = between if known is None else plus(known, between)

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
        start, end = product(slope, change), product(slope_there, change)
        small = SHALLOW * abs(start)
        low, high, at_low, at_high = 0.0, 1.0, start, end
        if end <= small:
            return there, slope_there
        lower = higher = False
        for _ in range(MOST_TRIALS):
            far = low - at_low * (high - low) / (at_high - at_low)
            edge = EDGE * (high - low)
            far = min(max(far, low + edge), high - edge)
            there = plus(speeds, change, far)
            slope_there = self._slope(there, bounds)
            here = product(slope_there, change)
            if abs(here) <= small:
                break
            # An end that stays where it is twice counts half: the Illinois way.
            if here < 0:
                low, at_low = far, here
                at_high *= 0.5 if lower else 1.0
            else:
                high, at_high = far, here
                at_low *= 0.5 if higher else 1.0
            lower, higher = here < 0, here >= 0
        return there, slope_there


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
