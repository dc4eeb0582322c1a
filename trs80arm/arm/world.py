"""Where arm and bench meet: what blocks a step, what it pushes, what the hand takes hold of.

`MiniMover` asks this whether a rotor can turn by one half-step; the answer may be that
something is in the way, and it may cost a part its place. Positions come as rotor counts.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from trs80arm.arm.bench import Bench
from trs80arm.arm.body import Body, Hold
from trs80arm.arm.events import EventKind
from trs80arm.arm.fixtures import Feeder, Part
from trs80arm.arm.forces import Burden, torques
from trs80arm.arm.geometry import CableDrive, JointAngles
from trs80arm.arm.grip import Grip
from trs80arm.arm.model import Link, Motor
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.shapes import SKIN, Box, Vector, depth, interval, minus, overlap, plus
from trs80arm.arm.trigonometry import sin_cos

Six = tuple[float, float, float, float, float, float]
HAND = 5
FAR = 100.0
"""More inches than there are."""
NEAR = 0.02
"""What is nearer than this counts as touching, inches."""
LOOK_EVERY = 8
"""Half-steps near something after which it is seen whether the arm has come away from it."""
PUSHED_FOR = 4
"""Half-steps for which a part goes on to resist after it was met."""
FINGER_TURNS = 8
"""Pushes of one displacement each after which a part that still is not clear blocks the arm."""
_LINKS = (Link.UPPER_ARM, Link.FOREARM, Link.HAND, Link.HAND, Link.HAND, Link.HAND)
"""What each segment of `Body` is part of."""
_HELD = 2
"""The segment that a held part goes with."""
NONE = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
GRAZE = 0.005
"""A carried part may graze others by this much, inches."""
FEED_CLEARANCE = 2.5
"""A feeder gives its next part when the fingertip is this far from its middle, inches."""


class World:
    """Body of the arm, hold of the hand, and the bench.

    Attributes:
        joints: where the joints are, in the half-steps of their motors; behind the rotors where
            something is in the way and the cables give.
        torques: what contacts do to the motors, by `Motor`, ounce-inches (ounces on the opening);
            positive where they push the angle up or the hand open.
        room: torque that the motor which is about to move still has for pushing.
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
        self._body_then = Body(self.model, drive.home, self.grip.opening, settings.finger_length)
        self._stale = False
        self._slack = 0.0
        self._look_again = 0
        self._rings = self._table = 0.0
        self._levers = self.levers()
        side = settings.base_width / 2
        front, rear = math.hypot(settings.base_front, side), math.hypot(settings.base_rear, side)
        body = math.hypot(settings.body_radius, settings.body_radius)
        # Base plate and body as the arm meets them that turns above them: from where to where
        # along it, and how high.
        self._own_rings = (
            (-rear, front, 0.0, settings.base_height),
            (-body, body, settings.base_height, settings.body_top),
        )
        self.joints = [0] * 6
        self.torques: Six = NONE
        self.room = math.inf
        self._pushing: dict[str, float] = {}
        self._moving = 0
        self._met_ago = 0
        self.met: str | None = None
        self._things: list[tuple[str, Box, Part | None]] = []
        self.ceiling = 0.0
        self.vacant: list[Feeder] = []
        self.pushes = 0
        self._burdened = False

    def __getstate__(self) -> dict[str, Any]:
        # What has been looked at ahead is found anew; how far ahead hangs on how a run is cut.
        state = {**self.__dict__, "_body_then": self.body, "_stale": False, "room": math.inf}
        state |= {"_slack": 0.0, "_rings": 0.0, "_table": 0.0, "_look_again": 0}
        if not self._pushing:
            state |= {"_moving": 0, "_met_ago": 0}
        return state

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

    def moved(self, rotors: Sequence[int], latch: int) -> None:
        """Let the joints follow the rotors as far as nothing is in the way.

        Args:
            rotors: positions of all.
            latch: of the motor that has moved.
        """
        joints = self.joints
        # A part that is pushed along is met only every few steps.
        self._met_ago += 1
        if latch != self._moving or self._met_ago > PUSHED_FOR:
            self._pushing.clear()
        self._moving = latch
        self._follow(latch, rotors[latch])
        while any(
            joint != rotor and self._follow(other, rotor)
            for other, (joint, rotor) in enumerate(zip(joints, rotors, strict=True))
        ):
            pass
        self.torques = self._torques(rotors)

    def _follow(self, latch: int, rotor: int) -> bool:
        """Let a joint go to its rotor; whether it has moved at all."""
        joints, moved = self.joints, False
        while joints[latch] != rotor:
            step = 1 if rotor > joints[latch] else -1
            joints[latch] += step
            if not self._try_move(latch, step, joints):
                joints[latch] -= step
                break
            moved = True
        return moved

    def _torques(self, rotors: Sequence[int]) -> Six:
        """What gives in the cables, what is pushed and what is squeezed, as torque."""
        joints, model = self.joints, self.model
        squeeze = 16 * self.grip.force
        if not squeeze and not self._pushing and joints == rotors:
            return NONE
        found = [0.0] * 6
        found[Motor.HAND] = squeeze
        for latch, drive in enumerate(model.drives):
            give = drive.sign * (rotors[latch] - joints[latch]) / drive.steps
            found[drive.turns] -= model.stiffness[drive.turns] * give
        found[model.drives[self._moving].turns] += sum(self._pushing.values())
        base, shoulder, elbow, left, right, hand = found
        return base, shoulder, elbow, left, right, hand

    @property
    def angles(self) -> JointAngles:
        """Angles of the joints as they stand, radians."""
        return self.drive.angles(self.joints)

    @property
    def around(self) -> float:
        """How far what is between or in the fingers, and they themselves, reach from the tip."""
        hold = self.grip.hold
        reach = self.model.hand.range / 2
        if hold is None:
            return reach
        return max(reach, math.hypot(*hold.center) + math.hypot(*hold.half))

    def levers(self) -> tuple[float, ...]:
        """Inches that a half-step of each motor moves anything of the arm nearer, at most."""
        model, around = self.model, self.around
        levers = {
            Motor.BASE: model.reach + around,
            Motor.SHOULDER: model.link,
            # Raising the forearm opens the hand as well.
            Motor.ELBOW: model.link + 0.5 * model.drives[2].steps / model.hand_steps,
            # A gear turns pitch and roll by half as much.
            Motor.LEFT_WRIST: model.hand_length / 2 + around,
            Motor.RIGHT_WRIST: model.hand_length / 2 + around,
            Motor.HAND: 0.5,
        }
        return tuple(levers[drive.turns] / drive.steps for drive in model.drives)

    def clearance(self, *, turning: bool) -> float:
        """Inches by which all that moves is clear of all that it could touch, at least.

        Args:
            turning: whether the base may turn meanwhile, as far as it likes; things are then taken
                for rings around its axis.

        Returns:
            0 where something may happen with the next half-step.
        """
        tip, least = self.body.points.fingertip, self._over_table()
        for feeder in self.vacant:
            out = math.hypot(tip[0] - feeder.x, tip[1] - feeder.y)
            if turning:
                out = math.hypot(*tip[:2]) + math.hypot(feeder.x, feeder.y)
            least = min(least, FEED_CLEARANCE + feeder.place.radius - NEAR - out)
        if least <= 0.0:
            return 0.0
        least = self._over_rings(least) if turning else self._beside_things(least)
        return max(0.0, least)

    def _spend(self, latch: int) -> float:
        """Count a half-step off the clearance; what is left, inches."""
        lever = self._levers[latch]
        self._slack -= lever
        if latch == 0:
            # The base turns nothing nearer to the table, nor out of the rings around its axis.
            return max(self._slack, self._rings)
        self._rings -= lever
        self._table -= lever
        return max(self._slack, min(self._rings, self._table))

    def _over_table(self) -> float:
        """Inches by which the arm and what it holds are clear of the table."""
        points = self.body.points
        level = math.hypot(points.pointing[0], points.pointing[1])
        tip = points.fingertip[2] - max(level * self.body.opening / 2, self._load_reach)
        return min(points.wrist[2], points.elbow[2], tip) - NEAR

    @property
    def _load_reach(self) -> float:
        """How far what is in the hand reaches from the fingertip."""
        hold = self.grip.hold
        return 0.0 if hold is None else math.hypot(*hold.center) + math.hypot(*hold.half)

    def _over_rings(self, least: float) -> float:
        """`least`, or the clearance from things wherever the base turns, if that is less."""
        points, around = self.body.points, self._load_reach
        hand = math.hypot(self.model.hand_length / 6, self.body.opening / 2) + NEAR
        quarter = self.model.link / 4 + NEAR
        spheres = [
            (_part_way(points.wrist, points.fingertip, share), hand)
            for share in (1 / 6, 0.5, 5 / 6)
        ]
        for start, end in ((points.elbow, points.wrist), (points.shoulder, points.elbow)):
            spheres += [(_part_way(start, end, share), quarter) for share in (0.25, 0.75)]
        if around:
            spheres.append((points.fingertip, around + NEAR))
        low = min(place[2] - reach for place, reach in spheres)
        s, c = sin_cos(self.drive.driven(self.joints)[0])
        for near, far, bottom, top in self._own_rings:
            if top < low - least:
                continue
            for (x, y, z), reach in spheres:
                out = x * c + y * s
                beside, above = max(near - out, out - far, 0.0), max(z - top, bottom - z, 0.0)
                least = min(least, math.sqrt(beside * beside + above * above) - reach)
        for _, box, _ in self._things[len(self._own_rings) :]:
            if least <= 0.0:
                break
            if box.top >= low - least:
                away = (box.distance_around(place) - reach for place, reach in spheres)
                least = min(least, *away)
        return least

    def _beside_things(self, least: float) -> float:
        """`least`, or the clearance of links, fingers and load as they are, if that is less."""
        tip, around = self.body.points.fingertip, self._load_reach
        give = self.settings.touch / 2
        for _, box, _ in self._things:
            for start, end in self.body.segments:
                least = min(least, box.gap(start, end) + give)
            if around:
                least = min(least, box.distance(tip) - around - NEAR)
            if least <= 0.0:
                break
        return least

    def finger_steps(self) -> int:
        """Half-steps that the hand alone can be stepped, either way, before anything happens."""
        grip, model, body = self.grip, self.model, self.body
        if grip.part is not None or grip.fixed is not None or self.vacant or grip.cable < 0:
            return 0
        room = math.inf
        if abs(body.points.across[2]) > 1e-9:
            room = body.lowest_tip - NEAR
        for _, box, _ in self._things:
            for start, end in body.segments[3:]:
                room = min(room, box.gap(start, end) - NEAR)
        most = model.hand.range * model.hand_steps - grip.cable
        return max(0, int(min(2 * room * model.hand_steps, most, grip.cable)) - 2)

    @property
    def strained(self) -> bool:
        """Whether anything gives, or is pushed."""
        return bool(self._pushing) or any(self.torques[:5])

    def burdens(self) -> tuple[Burden, ...]:
        """What rests in the hand: the part held, and what stands on it."""
        grip = self.grip
        if grip.hold is None or grip.part is None:
            return ()
        weight = grip.weight
        if self._burdened:
            weight += self.bench.weight_on(self.bench.parts[grip.part])
        return (Burden(weight, grip.hold.center),)

    def _try_move(self, latch: int, step: int, rotors: Sequence[int]) -> bool:
        """Take up a new position.

        Args:
            latch: the motor that moves.
            step: its direction.
            rotors: all positions after the step.

        Returns:
            Whether the arm has moved there.
        """
        grip = self.grip
        cable = self.drive.cable(rotors)
        # Fingers that close take hold of what they touch; otherwise a touch may give.
        spare = self.settings.touch if cable < grip.cable else 0.0
        if grip.part is None and grip.fixed is None and self._spend(latch) > spare:
            grip.cable, self._stale = cable, True
            return True
        self._slack = self._rings = self._table = 0.0
        body = self._body(rotors, grip.opening_at(cable))
        hold, slid = grip.hold, grip.slid
        before = self._carried(self.body)
        if not self._clear(body, before):
            grip.hold, grip.slid = hold, slid
            return False
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
        self._look_again -= 1
        if self._look_again < 0:
            self._slack = self.clearance(turning=False)
            self._rings = 0.0 if self.vacant else self._over_rings(FAR)
            self._table = self._over_table()
            near = max(self._slack, self._rings) < 4 * max(self._levers)
            self._look_again = LOOK_EVERY if near else 0
        return True

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
        self.joints[:] = rotors
        self._pushing.clear()
        self.torques = self._torques(rotors)
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

    @property
    def body(self) -> Body:
        """Links and fingers as they stand."""
        if self._stale:
            self.body = self._body(self.joints, self.grip.opening)
        return self._body_then

    @body.setter
    def body(self, body: Body) -> None:
        self._body_then, self._stale = body, False

    # Contact

    def _body(self, rotors: Sequence[int], opening: float) -> Body:
        return Body(self.model, self.drive.angles(rotors), opening, self.settings.finger_length)

    def _carried(self, body: Body) -> Box | None:
        """The carried part when the arm is there."""
        return None if self.grip.hold is None else self.grip.hold.box(body.points)

    def _changed(self) -> None:
        """Parts have moved: look at the bench anew."""
        bench = self.bench
        self._slack, self._rings, self._look_again = 0.0, 0.0, 0
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
        force = self._resistance(part, index, here, by)
        if abs(force) > self.room:
            return False
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
            self._met_ago = 0
            self._pushing[part.name] = force
            self.bench.news.append((EventKind.PUSHED, f"{part.name} pushed aside"))
            self._changed()
        return (
            part.name not in self.bench.parts
            or interval(part.box, start, end, self.settings.touch) is None
        )

    def _resistance(self, part: Part, index: int, place: Vector, way: Vector) -> float:
        """What a part, with all that stands on it, does to the motor that pushes it."""
        length = math.hypot(way[0], way[1])
        if length < 1e-12:
            return 0.0
        weight = part.weight + self.bench.weight_on(part)
        friction = self.settings.table_friction * weight / length
        force = (-friction * way[0], -friction * way[1], 0.0)
        angles = self.drive.angles(self.joints)
        turns = self.model.drives[self._moving].turns
        return torques(self.model, angles, _LINKS[index], place, force)[turns]

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
            force = self._resistance(part, _HELD, held.center, by)
            for _ in range(FINGER_TURNS):
                if abs(force) > self.room or not self.bench.push(part, by, height):
                    break
                self.pushes += 1
                self._met_ago = 0
                self._pushing[part.name] = force
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
        self.joints[:] = rotors
        self._slack, self._rings, self._look_again = 0.0, 0.0, 0
        grip.cable = self.drive.cable(rotors)
        self.torques = self._torques(rotors)
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
            squeezed = self.grip.excess(self.drive.cable(rotors)) and step < 0
            if squeezed or not self._try_move(HAND, step, rotors):
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


def _part_way(start: Vector, end: Vector, share: float) -> Vector:
    """A place on the way from one point to another."""
    return plus(start, minus(end, start), share)


def _as_clear(held: Box, before: Box, box: Box) -> bool:
    """Whether a carried part is clear of a thing, or no deeper in it than it was before."""
    deep = depth(held, box, GRAZE)
    return deep <= GRAZE or deep <= depth(before, box, GRAZE)
