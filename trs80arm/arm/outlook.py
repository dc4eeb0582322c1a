"""What lies ahead of an arm: room somewhere, and ticks on which nothing has to be looked at.

`World` asks here before it looks at contact, for the next tick or for a whole burst. What room
there was is remembered until something may have moved.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from trs80arm.arm.ahead import Ahead
from trs80arm.arm.bench import Bench
from trs80arm.arm.contact.clock import TICK_STATES
from trs80arm.arm.contact.recurrence import Recurrence, question
from trs80arm.arm.feeding import Feeding
from trs80arm.arm.geometry import CableDrive
from trs80arm.arm.grip import Grip
from trs80arm.arm.model import HAND, LEFT_WRIST
from trs80arm.arm.surroundings import FINGER, HAIR, SPARE, Near, Room, Surroundings
from trs80arm.arm.sweep import Ranges

ABOUT = 0.05
"""Radians, and inches of the opening, about a place in which room is looked for at once."""
KNOWN = 256
"""Bursts of which it is known between what they leave the joints."""
FED = 64
"""Bursts of which it is known when a feeder may give its next part."""
SWEPT = 4
"""Motions whose room is remembered while nothing else moves."""
CLOSELY = 8
"""Ticks for which it does not pay to look at what is swept over by half of them."""
PARTS = 64
"""Of a burst, by which what is asked of a piece of it is rounded, so that it recurs."""
STRETCH = 128
"""Places on a way that are seen at once: mostly a feeder may give its next part early on it."""
HALVED = 2
"""How often a motion is halved before it is looked at place by place."""


class Standing(NamedTuple):
    """How the arm stands before what lies ahead; it is free, or gripping.

    Attributes:
        rotors: positions of all.
        loaded: whether anything rests in the hand.
        gripped: whether a part rests between the fingers, and on something else too.
        strained: whether what touches the arm, but for its load, stretches its cables.
    """

    rotors: Sequence[int]
    loaded: bool
    gripped: bool
    strained: bool


class Outlook:
    """What an arm has before it on its bench."""

    def __init__(
        self,
        bench: Bench,
        drive: CableDrive,
        grip: Grip,
        around: Surroundings,
        feeding: Feeding,
    ) -> None:
        self._bench = bench
        self._drive = drive
        self._model = drive.model
        self._grip = grip
        self._around = around
        self._feeding = feeding
        self._looked: tuple[list[float], Room] | None = None
        self._about: tuple[Ranges, list[Near]] | None = None
        self._swept: list[Ranges] = []
        self._easing: list[list[float]] = []
        self._known: Recurrence[Ranges] = Recurrence(KNOWN)
        self._fed: Recurrence[int] = Recurrence(FED)

    def __getstate__(self) -> dict[str, Any]:
        # How far things are is found anew; when it was looked at hangs on how a run is cut.
        again: dict[str, Any] = {"_looked": None, "_about": None, "_swept": [], "_easing": []}
        again |= {"_known": Recurrence(KNOWN), "_fed": Recurrence(FED)}
        return {**self.__dict__, **again}

    # Room somewhere

    def clear_at(self, joints: list[float]) -> bool:
        """Whether there is room about somewhere.

        Args:
            joints: the arm's six coordinates there.
        """
        for each in self._swept:
            if each.hold(joints):
                return True
        return (
            self._surely_clear(joints) or not self._near_about(joints) or self._look(joints).enough
        )

    def _surely_clear(self, joints: Sequence[float]) -> bool:
        """Whether there must be room about somewhere, by the room there was where it was measured.

        How far the arm goes is a bound on how much nearer anything can be; the base takes nothing
        nearer to the table.

        Args:
            joints: where.
        """
        if self._looked is None or self._about is None or not self._looked[1].enough:
            return False
        there, room = self._looked
        if not self._about[0].hold(joints):
            return False
        way, down = self._around.travel(there, joints)
        return way <= room.beside - SPARE and (
            down <= room.low - SPARE or (down == 0.0 and room.low >= -HAIR / 2)
        )

    def _look(self, joints: list[float]) -> Room:
        """What room there is somewhere, by what is about there; remembered for bounds."""
        room = self._around.measured(joints, self._near_about(joints))
        self._looked = joints, room
        return room

    def _near_about(self, joints: list[float]) -> list[Near]:
        """What the arm may come near to about some place."""
        if self._about is None or not self._about[0].hold(joints):
            about = Ranges.about(joints, ABOUT)
            self._about = about, self._near(about)
        return self._about[1]

    def _near(self, ranges: Ranges) -> list[Near]:
        """What the arm may come near to while the joints are in some ranges: nothing, or what."""
        # What was found clear before is so as long as nothing else has moved since.
        if any(ranges.within(each) for each in self._swept):
            return []
        near = self._around.near(ranges)
        if not near:
            self._swept.append(ranges)
            del self._swept[:-SWEPT]
        return near

    def forget(self) -> None:
        """Something may have moved: what was known of the room about is so no longer."""
        self._looked = self._about = None
        self._swept.clear()

    # Whole bursts

    def first_look(self, here: Standing, ahead: Ahead) -> int | None:
        """T-state of the first tick of a burst on which something has to be looked at, or None.

        Args:
            here: where the arm is.
            ahead: the burst.
        """
        ticks = range(self._bench.scene.due, ahead.ends + 1, TICK_STATES)
        if not ticks:
            return None
        if here.gripped:
            if self._grips_on(here, ahead):
                return None
            clear = self.ticks_clear(here, _on_ticks(here, ahead, ticks))
        else:
            eased = self._eases_clear(here, ahead, ticks) if here.strained else 0
            if eased is None:
                clear = self.ticks_clear(here, _on_ticks(here, ahead, ticks))
            else:
                rest = ticks[eased:]
                clear = eased + (self._goes_clear(here, ahead, rest) if rest else 0)
        return ticks[clear] if clear < len(ticks) else None

    def _eases_clear(self, here: Standing, ahead: Ahead, ticks: range) -> int | None:
        """On how many ticks the arm's cables ease off, and it has room; None if that is not sure.

        Args:
            here: where the arm is.
            ahead: the burst.
            ticks: on which what is written before is done.
        """
        driven = self._bench.scene.driven
        now, before = driven.joints, driven.reached
        self._easing, wanted = [], []
        for tick in ticks:
            rotors = list(here.rotors)
            turned = ahead.turned_before(tick)
            for turning, by in zip(ahead.turnings, turned, strict=True):
                rotors[turning.latch] += by
            commands = self.wanted_at(rotors)
            now = driven.eased(now, before, commands, loaded=here.loaded)
            self._easing.append(now)
            wanted.append(commands)
            before = commands
            if now[:5] == commands[:5] and (here.loaded or now[5] == commands[5]):
                break
        unfed = self._feeding.surely_unfed(Ranges.among(wanted))
        if not unfed or self._near(Ranges.among(self._easing)):
            return None
        return len(self._easing)

    def _goes_clear(self, here: Standing, ahead: Ahead, ticks: range) -> int:
        """On how many ticks in a row an arm that nothing strains has room, and feeds nothing.

        Args:
            here: where the arm is.
            ahead: the burst.
            ticks: up to its end, on which what is written before is done.
        """
        # Where the burst ends the arm will be on the next tick.
        ranges = self._ranges(here, ahead, ticks[0], ahead.ends + 1)
        clear = self._unfed(here, ahead, ticks, ranges)
        if clear and (near := self._near(ranges)):
            closes = self._closes_clear(here, ahead, ticks, near)
            return min(clear, closes or self._swept_clear(here, ahead, ticks[:clear], near))
        return clear

    def _closes_clear(
        self, here: Standing, ahead: Ahead, ticks: range, near: Sequence[Near]
    ) -> int:
        """On how many ticks in a row an arm has room of which the hand alone moves, at least.

        Args:
            here: where the arm is.
            ahead: the burst.
            ticks: on which what is written before is done.
            near: what it may come near to on all its way.
        """
        (turning, *others), model = ahead.turnings, self._model
        if others or turning.latch != model.latch(HAND) or not turning.way or here.loaded:
            return 0
        room = self._around.measured(self.wanted_at(here.rotors), near)
        spare = min(room.beside, room.low) - SPARE
        if spare <= 0.0:
            return 0
        steps = int(spare / FINGER * model.hand_steps)
        if steps >= turning.steps:
            return len(ticks)
        (until,) = ahead.moments(0, steps, steps + 1)
        return len(range(ticks[0], until + 1, TICK_STATES))

    def _unfed(self, here: Standing, ahead: Ahead, ticks: range, ranges: Ranges) -> int:
        """On how many ticks in a row no feeder can give its next part."""
        if self._feeding.surely_unfed(ranges):
            return len(ticks)
        if ahead.repeats is None:
            return self._feeding.places_unfed(self._wanted(_on_ticks(here, ahead, ticks)))
        asked = question(ahead.repeats, here.rotors, self._shut, self._feeding.bars)
        known = self._fed.get(asked)
        if known is None:
            known = self._fed.keep(asked, self._time_unfed(here, ahead))
        return len(ticks[: len(range(ticks[0], _begins(ahead) + known, TICK_STATES))])

    def _time_unfed(self, here: Standing, ahead: Ahead) -> int:
        """T-states from the beginning of a burst in which no feeder can give its next part."""
        begins = _begins(ahead)
        writes = [ahead.half_steps(order)[0] for order in range(len(ahead.turnings))]
        # What is written is done on the ticks after it.
        times = np.concatenate(([begins], np.unique(np.concatenate(writes)) + 1))
        for first in range(0, len(times), STRETCH):
            some = times[first : first + STRETCH]
            unfed = self._feeding.places_unfed(self._wanted(_on_ticks(here, ahead, some)))
            if unfed < len(some):
                return int(some[unfed]) - begins
        return ahead.ends + 2 - begins

    def _swept_clear(self, here: Standing, ahead: Ahead, ticks: range, near: Sequence[Near]) -> int:
        """On how many ticks in a row the arm has room, by what it sweeps over between them.

        Args:
            here: where the arm is, free.
            ahead: the burst.
            ticks: on which what is written before is done.
            near: what it may come near to on all its way.
        """
        pieces: list[tuple[int, int, Sequence[Near] | None]] = [(0, len(ticks), near)]
        while pieces:
            begin, end, near_here = pieces.pop()
            if near_here is None:
                near_here = self._near_between(here, ahead, ticks[begin], ticks[end - 1])
            if not near_here:
                continue
            if end - begin > max(CLOSELY, len(ticks) >> HALVED):
                middle = (begin + end) // 2
                pieces += [(middle, end, None), (begin, middle, None)]
                continue
            joints = self._unstrained(here, _on_ticks(here, ahead, ticks[begin:end]))
            clear = self._around.places_clear(joints, near_here)
            if clear < end - begin:
                return begin + clear
        return len(ticks)

    def _near_between(self, here: Standing, ahead: Ahead, since: int, until: int) -> Sequence[Near]:
        """What the arm may come near to from one T-state to another, nothing in its way."""
        # A little more than that recurs, whenever the burst begins.
        begins = _begins(ahead)
        lasts = ahead.ends + 1 - begins
        first, last = (since - begins) * PARTS // lasts, -((begins - until) * PARTS // lasts)
        earlier, later = begins + first * lasts // PARTS, begins - (-last * lasts // PARTS)
        if ahead.repeats is not None and not self._near(
            self._known_ranges(here, ahead, (first, last), (earlier, later))
        ):
            return ()
        return self._near(self._found_ranges(here, ahead, since, until))

    def _wanted(self, rotors: npt.NDArray[np.int64]) -> npt.NDArray[np.float64]:
        """Where motors want the arm's six coordinates, 6 x places, for positions of the rotors."""
        drive, model = self._drive, self._model
        opening = drive.cable(rotors) / model.hand_steps
        opening = np.minimum(np.maximum(opening, self._shut), model.hand.range)
        return np.array((*drive.driven(rotors), opening))

    def wanted_at(self, rotors: Sequence[int]) -> list[float]:
        """Where motors want the arm's six coordinates, for positions of the rotors."""
        drive, model = self._drive, self._model
        opening = min(max(drive.cable(rotors) / model.hand_steps, self._shut), model.hand.range)
        return [*drive.driven(rotors), opening]

    @property
    def taut(self) -> bool:
        """Whether its cable goes on past nothing: only against what is between the fingers."""
        return self._grip.contact > 0 and self._bench.scene.torques[5] > 0

    @property
    def _shut(self) -> float:
        """Inches of opening at which the hand is wanted at least."""
        return -math.inf if self.taut else 0.0

    def _unstrained(self, here: Standing, rotors: npt.NDArray[np.int64]) -> npt.NDArray[np.float64]:
        """`_wanted` with nothing in the arm's way but what rests in its hand."""
        joints = self._wanted(rotors)
        if here.loaded:
            self._hold_open(joints)
        return joints

    def _hold_open(self, joints: npt.NDArray[np.float64]) -> None:
        """Have the hand be as wide open as what rests in it keeps it."""
        joints[5] = self._bench.scene.joints[5]

    def _ranges(self, here: Standing, ahead: Ahead, since: int, until: int) -> Ranges:
        """Between what the joints are from one T-state to another, nothing in their way."""
        if ahead.repeats is None or not ahead.is_all(since, until):
            return self._found_ranges(here, ahead, since, until)
        return self._known_ranges(here, ahead, None, (since, until))

    def _known_ranges(
        self,
        here: Standing,
        ahead: Ahead,
        part: tuple[int, int] | None,
        between: tuple[int, int],
    ) -> Ranges:
        """The same for a part of a burst that recurs, remembered.

        Args:
            here: where the arm is.
            ahead: the burst.
            part: from which of its `PARTS` to which; None for all of it.
            between: T-states.
        """
        opening = here.loaded and self._bench.scene.joints[5]
        asked = question(ahead.repeats, here.rotors, opening, part)
        known = self._known.get(asked)
        if known is None:
            known = self._known.keep(asked, self._found_ranges(here, ahead, *between))
        return known

    def _found_ranges(self, here: Standing, ahead: Ahead, since: int, until: int) -> Ranges:
        model, drive, rotors = self._model, self._drive, here.rotors
        low, high = list(rotors), list(rotors)
        for turning, (least, most) in zip(ahead.turnings, ahead.between(since, until), strict=True):
            low[turning.latch] += least
            high[turning.latch] += most
        ends = zip(drive.driven(low), drive.driven(high), strict=True)
        base, shoulder, elbow, _, _ = [(a, b) if a < b else (b, a) for a, b in ends]
        *_, left, right = drive.driven(rotors)
        both = 2 * model.drives[model.latch(LEFT_WRIST)].steps
        least, most = ahead.together_between(model.gears(1), since, until)
        pitch = (left + right) / 2 + least / both, (left + right) / 2 + most / both
        least, most = ahead.together_between(model.gears(-1), since, until)
        roll = (left - right) / 2 + least / both, (left - right) / 2 + most / both
        if here.loaded:
            opening = self._bench.scene.joints[5]
            return Ranges(base, shoulder, elbow, pitch, roll, (opening, opening))
        least, most = ahead.together_between(model.pays_out, since, until)
        cable, per_inch, widest = drive.cable(rotors), model.hand_steps, model.hand.range
        shut = min(widest, max(0, cable + least) / per_inch)
        wide = min(widest, max(0, cable + most) / per_inch)
        return Ranges(base, shoulder, elbow, pitch, roll, (shut, wide))

    def ticks_clear(self, here: Standing, rotors: npt.NDArray[np.int64]) -> int:
        """How many ticks in a row need not be looked at.

        Args:
            here: where the arm is.
            rotors: positions on the ticks from the next on, 6 x ticks.
        """
        if here.gripped:
            return self._ticks_gripping(self._wanted(rotors).T.tolist())
        joints = self._wanted(rotors)
        ranges, count = Ranges.of(joints), len(rotors[0])
        # Feeders ask where the arm is wanted, whatever its cables give.
        if not self._feeding.surely_unfed(ranges):
            count = self._feeding.places_unfed(joints)
        if here.strained:
            self._ease(joints, loaded=here.loaded)
            ranges = Ranges.of(joints)
        elif here.loaded:
            self._hold_open(joints)
            ranges = Ranges.of(joints)
        near = self._near(ranges) if count else []
        return self._around.places_clear(joints[:, :count], near) if near else count

    def _grips_on(self, here: Standing, ahead: Ahead) -> bool:
        """Whether what rests in the grip goes on resting there for the whole of a burst.

        Args:
            here: where the arm is.
            ahead: the burst, of the hand's motor alone.
        """
        hand, ends = self._model.latch(HAND), []
        for by in ahead.together(self._model.pays_out):
            rotors = list(here.rotors)
            rotors[hand] += by
            ends.append(self.wanted_at(rotors))
        return self._ticks_gripping(ends) == len(ends)

    def _ticks_gripping(self, commands: Sequence[list[float]]) -> int:
        """How many ticks in a row what rests in the grip goes on resting there.

        Args:
            commands: on the ticks.
        """
        goes_on = self._bench.scene.carrying.goes_on
        if not self._grip.part:
            return 0
        for count, each in enumerate(commands):
            if not goes_on(each):
                return count
        return len(commands)

    def _ease(self, joints: npt.NDArray[np.float64], *, loaded: bool) -> None:
        """Have the arm lag behind where it is wanted while its cables ease off.

        Args:
            joints: where the motors want it on some ticks, 6 x ticks; made where it is.
            loaded: whether anything rests in the hand.
        """
        driven = self._bench.scene.driven
        now, before = driven.joints, driven.reached
        self._easing = []
        for tick, commands in enumerate(joints.T.tolist()):
            now = driven.eased(now, before, commands, loaded=loaded)
            joints[:, tick] = now
            self._easing.append(now)
            before = commands
            if now[:5] == commands[:5] and (loaded or now[5] == commands[5]):
                # All that was to ease off has.
                if loaded:
                    joints[5, tick:] = now[5]
                break

    def eased(self, ticks: int) -> list[float] | None:
        """Where the arm, its cables easing off, is after some ticks that were found clear last.

        Args:
            ticks: after the first of them.

        Returns:
            Its six coordinates; None where what was to ease off has.
        """
        return self._easing[ticks] if ticks < len(self._easing) else None


def _begins(ahead: Ahead) -> int:
    """T-state of a burst's first half-step."""
    return min([turning.first for turning in ahead.turnings])


def _on_ticks(
    here: Standing, ahead: Ahead, ticks: Sequence[int] | npt.NDArray[np.int64]
) -> npt.NDArray[np.int64]:
    """Positions of all rotors on some ticks, 6 x ticks."""
    rotors = np.empty((6, len(ticks)), dtype=np.int64)
    rotors[:] = np.array(here.rotors)[:, None]
    turned = ahead.turned(np.array(ticks))
    for turning, by in zip(ahead.turnings, turned, strict=True):
        rotors[turning.latch] += by
    return rotors
