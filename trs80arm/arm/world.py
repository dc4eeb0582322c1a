"""Where arm and bench meet: what blocks a step, what it pushes, what the hand takes hold of.

`MiniMover` asks this whether a rotor can turn by one half-step; the answer may be that
something is in the way, and it may cost a part its place. Positions come as rotor counts.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from trs80arm.arm.bench import Bench
from trs80arm.arm.body import Body, Hold
from trs80arm.arm.events import EventKind, Reason
from trs80arm.arm.fixtures import Feeder, Part
from trs80arm.arm.geometry import CableDrive
from trs80arm.arm.grip import Grip
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.shapes import SKIN, Box, depth, interval, minus, overlap, plus

HAND = 5
FINGER_TURNS = 8
"""Pushes of one displacement each after which a part that still is not clear blocks the arm."""
GRAZE = 0.005
"""A carried part may graze others by this much, inches."""
FEED_CLEARANCE = 2.5
"""A feeder gives its next part when the fingertip is this far from its middle, inches."""


class World:
    """Body of the arm, hold of the hand, and the bench.

    Attributes:
        body: the arm as it stands.
        grip: the hand's hold.
        met: name of what blocked the arm last, or None.
        ceiling: height of the highest thing that the hand does not carry, inches.
        vacant: feeders at whose place nothing stands.
        pushes: how often something has been pushed aside.
    """

    def __init__(self, bench: Bench, settings: ArmSettings, drive: CableDrive) -> None:
        self.bench = bench
        self.settings = settings
        self.drive = drive
        self.model = drive.model
        self.grip = Grip(self.model, drive.home_cable)
        self.body = Body(self.model, drive.home, self.grip.opening, settings.finger_length)
        self.met: str | None = None
        self._things: list[tuple[str, Box, Part | None]] = []
        self.ceiling = 0.0
        self.vacant: list[Feeder] = []
        self.pushes = 0
        self._burdened = False

    def start(self) -> None:
        """Begin: everything on the bench comes to rest, feeders give their first parts."""
        self.bench.remember()
        self.bench.settle()
        for feeder in self.bench.waiting_feeders():
            if not self._touches(feeder.place):
                self.bench.feed(feeder)
        self.bench.news.clear()
        self._changed()

    def refill(self) -> None:
        """Begin again with the parts; the hand is left empty."""
        self.grip.forget()
        self.bench.refill()
        self.start()
        self.body = self.body.opened(self.grip.opening)

    # What a half-step meets

    def try_move(self, latch: int, step: int, rotors: Sequence[int]) -> Reason | None:
        """Take up a new position.

        Args:
            latch: the motor that moves.
            step: its direction.
            rotors: all positions after the step.

        Returns:
            What blocks it, or None if the arm has moved there.
        """
        grip = self.grip
        cable = self.drive.cable(rotors)
        if latch == HAND and step < 0 and grip.excess(cable):
            return Reason.LOAD
        body = self._body(rotors, grip.opening_at(cable))
        hold, slid = grip.hold, grip.slid
        before = self._carried(self.body)
        if not self._clear(body, before):
            grip.hold, grip.slid = hold, slid
            return Reason.CONTACT
        held = self._carried(body)
        closing = cable < grip.cable
        self.body, grip.cable = body, cable
        if held is not None and grip.part is not None:
            self.bench.parts[grip.part].box = held
            if self._burdened:
                self.bench.settle()
                self._changed()
        if grip.part is not None or grip.fixed is not None:
            self._hold_on(rotors, latch)
        elif closing:
            self._close_on(rotors)
        self._feed()
        return None

    def turn_table(self, step: int) -> bool:
        """Turn the turntable by a half-step; whether it could."""
        if self.bench.turntable is None:
            return True
        touch = self.settings.touch
        turned = self.bench.turn_table(
            self.bench.turntable.rotor + step, lambda box: not self._touches(box, touch)
        )
        if not turned:
            self.met = "what stands on it"
        self._changed()
        return turned

    def regrip(self, rotors: Sequence[int]) -> None:
        """The cable has slipped: bring the hold in line with it."""
        self.grip.cable = self.drive.cable(rotors)
        self.body = self._body(rotors, self.grip.opening)
        if self.grip.contact:
            self._hold_on(rotors, HAND)

    def place(self, before: Sequence[int], rotors: list[int]) -> str | None:
        """Put the arm somewhere else by hand.

        Args:
            before: positions as they are.
            rotors: positions to take up; the hand's is changed to where it could get.

        Returns:
            Name of what is there already, or None if the arm now is.
        """
        wanted = self.drive.cable(rotors)
        if wanted > self.grip.cable:
            self._walk_hand(list(before), wanted)
        rotors[HAND] += self.grip.cable - self.drive.cable(rotors)
        body = self._body(rotors, self.grip.opening)
        name = self._occupied(body)
        if name is not None:
            return name
        if self.grip.hold is None:
            self.grip.forget()
        self.body = self._body(rotors, self.grip.opening)
        held = self._carried(self.body)
        if held is not None and self.grip.part is not None:
            self.bench.parts[self.grip.part].box = held
        self._changed()
        self._walk_hand(rotors, wanted)
        self._feed()
        return None

    def sensed(self) -> int:
        """Bits 1 to 3 of the input nibble: 1 idle, 0 where a sensor answers."""
        bits = 0b1110
        if self.bench.sensors:
            boxes = [part.box for part in self.bench.parts.values()]
            segments = list(self.body.segments[1:])
            for sensor in self.bench.sensors:
                if bits >> sensor.bit & 1 and sensor.answers(boxes, segments):
                    bits &= ~(1 << sensor.bit)
        return bits

    # Contact

    def _body(self, rotors: Sequence[int], opening: float) -> Body:
        return Body(self.model, self.drive.angles(rotors), opening, self.settings.finger_length)

    def _carried(self, body: Body) -> Box | None:
        """The carried part when the arm is there."""
        return None if self.grip.hold is None else self.grip.hold.box(body.points)

    def _changed(self) -> None:
        """Parts have moved: look at the bench anew."""
        bench = self.bench
        self._things = [(o.name, o.box, None) for o in bench.obstacles]
        self._things += [(part.name, part.box, part) for part in bench.standing()]
        self.ceiling = max((box.top for _, box, _ in self._things), default=0.0)
        self._burdened = bench.held is not None and bench.bears(bench.held)
        self.vacant = [
            feeder
            for feeder in bench.feeders
            if not feeder.empty
            and not any(overlap(feeder.place, box) for _, box, _ in self._things)
        ]

    def _clear(self, body: Body, before: Box | None) -> bool:
        """Whether the arm can stand there, pushing aside what gives way.

        Args:
            body: the arm there.
            before: the carried part where it is now.
        """
        touch = self.settings.touch
        if body.lowest_tip < -touch and body.lowest_tip < self.body.lowest_tip:
            self.met = "the table"
            return False
        wrist = body.points.wrist[2]
        if wrist < 0 and wrist < self.body.points.wrist[2]:
            self.met = "the table"
            return False
        low = min(wrist, body.lowest_tip, body.points.elbow[2])
        held = self._carried(body)
        if held is not None:
            low = min(low, held.bottom)
            if held.bottom < 0 and not self._slide(body, -held.bottom, "the table"):
                return False
        if low > self.ceiling + touch:
            return True
        near = [thing for thing in self._near(body, held) if thing[1].top >= low - touch]
        if before is not None and not self._let_down(body, before, near):
            return False
        pushed = self.pushes
        for name, box, part in near:
            if not self._past(body, name, box, part):
                return False
            if before is not None and not self._carried_past(body, before, name, box, part):
                return False
        # What was pushed may have pushed something else into the carried part's way.
        held = self._carried(body)
        if held is None or before is None or self.pushes == pushed:
            return True
        return all(_as_clear(held, before, box) for _, box, _ in self._near(body, held))

    def _let_down(self, body: Body, before: Box, near: list[tuple[str, Box, Part | None]]) -> bool:
        """The carried part comes down on things and gives way; whether it can."""
        for name, box, _ in near:
            held = self._carried(body)
            if held is None or before.bottom < box.top - 2 * GRAZE:
                continue
            if not _as_clear(held, before, box) and not self._slide(
                body, box.top - held.bottom, name
            ):
                return False
        return True

    def _near(self, body: Body, held: Box | None) -> list[tuple[str, Box, Part | None]]:
        """Things that the arm could touch."""
        wrist, tip = body.points.wrist, body.points.fingertip
        x, y, z = (wrist[0] + tip[0]) / 2, (wrist[1] + tip[1]) / 2, (wrist[2] + tip[2]) / 2
        half = self.model.hand_length / 2
        reach = half + body.opening / 2
        if held is not None:
            reach = max(reach, half + math.dist(tip, held.center) + held.radius)
        links = min(wrist[2], body.points.elbow[2])
        near = []
        for thing in self._things:
            box = thing[1]
            cx, cy, cz = box.center
            limit = reach + box.radius
            if (cx - x) ** 2 + (cy - y) ** 2 + (cz - z) ** 2 < limit * limit or box.top > links:
                near.append(thing)
        return near

    def _past(self, body: Body, name: str, box: Box, part: Part | None) -> bool:
        """Whether links and fingers clear a thing, having pushed it aside if need be."""
        touch = self.settings.touch
        for index, (start, end) in enumerate(body.segments):
            if start[2] > box.top and end[2] > box.top:
                continue
            inside = interval(box, start, end, touch)
            if inside is None:
                continue
            old = self.body.segments[index]
            if interval(box, old[0], old[1], touch) is not None:
                continue
            if part is None or not self._push(body, index, inside, part):
                self.met = name
                return False
        return True

    def _push(self, body: Body, index: int, inside: tuple[float, float], part: Part) -> bool:
        """Push a part aside with a link or finger; whether it is clear then."""
        start, end = body.segments[index]
        old = self.body.segments[index]
        if min(old[0][2], old[1][2]) > part.box.top - self.settings.touch - SKIN:
            return False  # it comes down on the part
        t = (inside[0] + inside[1]) / 2
        here = plus(start, minus(end, start), t)
        there = plus(old[0], minus(old[1], old[0]), t)
        by = minus(here, there)
        if abs(by[2]) > math.hypot(by[0], by[1]):
            return False
        gave = False
        for _ in range(FINGER_TURNS):
            if not self.bench.push(part, by, here[2]):
                break
            gave = True
            if part.name not in self.bench.parts:
                break
            if interval(part.box, start, end, self.settings.touch) is None:
                break
        if gave:
            self.pushes += 1
            self.bench.news.append((EventKind.PUSHED, f"{part.name} pushed aside"))
            self._changed()
        return (
            part.name not in self.bench.parts
            or interval(part.box, start, end, self.settings.touch) is None
        )

    def _carried_past(
        self, body: Body, before: Box, name: str, box: Box, part: Part | None
    ) -> bool:
        """Whether the carried part clears a thing, having pushed it aside if need be."""
        if part is not None:
            if part.name not in self.bench.parts:
                return True
            box = part.box
        held = self._carried(body)
        if held is None or _as_clear(held, before, box):
            return True
        by = minus(held.center, before.center)
        if part is not None and abs(by[2]) <= math.hypot(by[0], by[1]):
            height = max(held.bottom, box.bottom)
            for _ in range(FINGER_TURNS):
                if not self.bench.push(part, by, height):
                    break
                self.pushes += 1
                self._changed()
                if part.name not in self.bench.parts or not overlap(held, part.box, GRAZE):
                    self.bench.news.append((EventKind.PUSHED, f"{part.name} pushed aside"))
                    return True
        self.met = name
        return False

    def _slide(self, body: Body, depth: float, name: str) -> bool:
        """Let the carried part give way upwards in the fingers; whether it can."""
        grip = self.grip
        held = self._carried(body)
        if held is None or grip.slid + depth > self.settings.grip_slide:
            self.met = name
            return False
        grip.slid += depth
        grip.hold = Hold.of(held.moved((0.0, 0.0, depth)), body.points)
        return True

    def occupied(self) -> str | None:
        """Name of what is where the arm stands."""
        self._changed()
        return self._occupied(self.body)

    def _occupied(self, body: Body) -> str | None:
        """Name of what is where the arm would be."""
        touch = self.settings.touch
        if body.lowest_tip < -touch or body.points.wrist[2] < 0:
            return "the table"
        held = self._carried(body)
        if held is not None and held.bottom < -GRAZE:
            return "the table"
        for name, box, part in self._things:
            if part is not None and part.name == self.grip.part:
                continue
            if any(interval(box, a, b, touch) is not None for a, b in body.segments):
                return name
            if held is not None and overlap(held, box, GRAZE):
                return name
        return None

    def boxes(self) -> list[Box]:
        """Everything that the arm could touch."""
        return [thing[1] for thing in self._things]

    def arrive(self, rotors: Sequence[int]) -> None:
        """Be somewhere that free motion has led to."""
        grip = self.grip
        grip.cable = self.drive.cable(rotors)
        self.body = self._body(rotors, grip.opening)
        held = self._carried(self.body)
        if held is not None and grip.part is not None:
            self.bench.parts[grip.part].box = held

    def _touches(self, box: Box, skin: float = 0.0) -> bool:
        """Whether a link or finger is in a box, deeper than a skin."""
        return any(interval(box, a, b, skin) is not None for a, b in self.body.segments)

    # The hand

    def _walk_hand(self, rotors: list[int], wanted: int) -> None:
        """Pay out or pull in hand cable by hand, as far as it goes."""
        while self.grip.cable != wanted:
            step = 1 if wanted > self.grip.cable else -1
            rotors[HAND] += step
            if self.try_move(HAND, step, rotors) is not None:
                rotors[HAND] -= step
                return

    def _between(self, body: Body, box: Box) -> tuple[float, float] | None:
        """How far a thing reaches to the right (negative) and left of the hand's middle.

        Returns:
            Inches along the way the hand closes, or None if nothing of it is between the pads.
        """
        tip, u, e = body.points.fingertip, body.points.pointing, body.points.across
        half = 2.0
        best: tuple[float, float] | None = None
        for k in range(4):
            middle = plus(tip, u, -self.settings.pad_length * (k + 0.1) / 3.2)
            if middle[2] - half * abs(e[2]) > box.top:
                continue
            found = interval(box, plus(middle, e, -half), plus(middle, e, half), 1e-4)
            if found is None:
                continue
            low, high = (2 * half * t - half for t in found)
            if low < body.opening / 2 and high > -body.opening / 2:
                best = (low, high) if best is None else (min(low, best[0]), max(high, best[1]))
        return best

    def _close_on(self, rotors: Sequence[int]) -> None:
        """Closing fingers meet a part: one pushes it to the middle, both press on it."""
        grip = self.grip
        if grip.cable < 0:
            return  # they have met each other
        for name, box, part in self._near(self.body, None):
            span = self._between(self.body, box)
            if span is None:
                continue
            half = grip.opening / 2 + SKIN
            low, high = span
            over = 2 * self.settings.touch
            if high > half + over or low < -half - over:
                continue  # a fingertip stands on it
            if part is not None:
                if high > half and low > -half:
                    self._centre(part, grip.opening / 2 - high)
                elif low < -half and high < half:
                    self._centre(part, -grip.opening / 2 - low)
                if part.name not in self.bench.parts:
                    continue
                span = self._between(self.body, part.box)
            if span is not None and (span[0] < -half or span[1] > half):
                grip.contact = grip.cable + 1
                if part is None:
                    grip.fixed = box
                else:
                    grip.part = name
                self.body = self._body(rotors, grip.opening)
                self.bench.news.append((EventKind.CONTACT, f"fingers on {name}"))
                self._hold_on(rotors, HAND)
                return

    def _centre(self, part: Part, by: float) -> None:
        """One finger pushes a part along the way the hand closes."""
        e, tip = self.body.points.across, self.body.points.fingertip
        if abs(e[2]) > 0.7:
            return
        self.bench.push(part, (by * e[0], by * e[1], 0.0), min(tip[2], part.box.center[2]))
        self._changed()

    def _hold_on(self, rotors: Sequence[int], latch: int) -> None:
        """See whether what is between the fingers is held, let go, or lost."""
        grip, bench = self.grip, self.bench
        part = bench.parts.get(grip.part) if grip.part is not None else None
        carries = grip.carries(self.settings.pad_friction)
        may_be_gone = latch != HAND
        if part is not None and grip.hold is not None and carries < part.weight:
            grip.hold, grip.weight = None, 0.0
            bench.release(part)
            self._changed()
            part = bench.parts.get(part.name)
            may_be_gone = True
        elif part is not None and grip.hold is None and grip.squeeze and carries >= part.weight:
            part.held = True
            grip.hold, grip.weight = Hold.of(part.box, self.body.points), part.weight
            grip.slid = 0.0
            bench.news.append((EventKind.TAKEN, f"{part.name} in the hand"))
            bench.settle()
            self._changed()
        if grip.hold is None:
            box = part.box if part is not None else grip.fixed
            gone = box is None or (may_be_gone and self._between(self.body, box) is None)
            if gone or grip.cable >= grip.contact:
                grip.forget()
        self.body = self._body(rotors, grip.opening)

    def _feed(self) -> None:
        """Feeders whose place is free, and clear of the hand, give their next part."""
        if not self.vacant:
            return
        for feeder in list(self.vacant):
            x, y, _ = self.body.points.fingertip
            place = feeder.place
            far = FEED_CLEARANCE + place.radius
            if (x - feeder.x) ** 2 + (y - feeder.y) ** 2 < far * far:
                continue
            if not self.bench.room_for(place) or self._touches(place):
                continue
            self.bench.feed(feeder)
            self._changed()


def _as_clear(held: Box, before: Box, box: Box) -> bool:
    """Whether a carried part is clear of a thing, or no deeper in it than it was before."""
    deep = depth(held, box, GRAZE)
    return deep <= GRAZE or deep <= depth(before, box, GRAZE)
