"""Where a jog leads: joint, world and tool coordinates, worked out in steps of the registers.

A jog in world or tool coordinates is a straight line of the fingertip. It is cut into small pieces,
each a `@STEP` between two readings of the registers; every reading is rounded from the exact point
of the line and not from the piece before, so that what rounding takes from one piece the next one
has. The kinematics are the arm model's own, whichever arm it is.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import astuple, dataclass, replace
from enum import Enum

from trs80arm.arm.geometry import CableDrive, JointAngles, OutOfReach, forward, inverse
from trs80arm.arm.limits import beyond_any_stop
from trs80arm.arm.model import ArmModel, Pose
from trs80arm.rig import Counts, Rig

HAND = 5
"""The sixth way to jog, in all coordinates: the hand."""
LONGEST_PIECE = 0.25
"""Inches of a straight line that one `@STEP` makes: the arc of the joints leaves it by less than a
hundredth of an inch."""
LARGEST_TURN = 10.0
"""Degrees of pitch or roll that one `@STEP` turns the hand about the fingertip."""
CLOSING = 0.5
"""Pounds by which the hand closes between two looks at the grip switch."""
BELOW_TABLE = 0.02
"""Inches by which the fingertip may be below the table before that is said to be out of reach."""
HALVINGS = 4
"""How often a piece that ends out of reach is halved to come closer to the end of the reach."""


class Coordinates(Enum):
    """What the keys of the pendant move the arm along."""

    WORLD = "world"
    """The fingertip along X, Y and Z of the table; pitch and roll about the fingertip."""
    TOOL = "tool"
    """The fingertip along the hand, across it and off its back; pitch and roll as in the world."""
    JOINT = "joint"
    """Each motor by itself, as the keys of `@SET`."""

    @property
    def following(self) -> Coordinates:
        """The next one, after the last the first."""
        ways = list(Coordinates)
        return ways[(ways.index(self) + 1) % len(ways)]


@dataclass(frozen=True)
class StepSize:
    """How far one press goes: half-steps in joint coordinates, inches and degrees in the others."""

    half_steps: int
    inches: float
    degrees: float


STEP_SIZES = (
    StepSize(1, 0.02, 0.5),
    StepSize(10, 0.1, 2.0),
    StepSize(50, 0.25, 5.0),
    StepSize(100, 0.5, 10.0),
    StepSize(200, 1.0, 15.0),
)
"""From fine to coarse."""


@dataclass(frozen=True)
class Stance:
    """The arm as it stands, and its registers as they count: what a pendant goes by.

    Attributes:
        model: what make of arm it is.
        drive: its cables.
        registers: J1 to J6, half-steps.
        rotors: of its six motors, half-steps from where it was switched on.
        force: of the grip, pounds.
        switch_closed: whether the grip switch is closed.
    """

    model: ArmModel
    drive: CableDrive
    registers: Counts
    rotors: Counts
    force: float = 0.0
    switch_closed: bool = False

    @classmethod
    def of(cls, rig: Rig) -> Stance:
        """Look at a rig."""
        state, arm = rig.state, rig.arm
        return cls(
            arm.model, arm.drive, rig.registers, state.rotors, state.force, state.switch_closed
        )

    @property
    def angles(self) -> JointAngles:
        """The joints' angles, radians."""
        return self.drive.angles(self.rotors)

    @property
    def opening(self) -> float:
        """Inches between the fingers as the hand's cable has it; below 0 it only pulls tighter."""
        return float(self.drive.cable(self.rotors)) / self.model.hand_steps

    @property
    def pose(self) -> Pose:
        """Where the fingertip is; the opening is never less than none."""
        return self._pose(max(0.0, self.opening))

    def _pose(self, opening: float) -> Pose:
        angles = self.angles
        x, y, z = forward(self.model, angles).fingertip
        pitch, roll = math.degrees(angles.pitch), math.degrees(angles.roll - angles.base)
        return Pose(x, y, z, pitch, roll, opening)

    @property
    def exact(self) -> Pose:
        """The pose with the opening that the cable has, tight or not."""
        return self._pose(self.opening)

    def after(self, steps: Sequence[int]) -> Stance:
        """The stance that a `@STEP` leads to."""
        j1, j2, j3, j4, j5, j6 = steps
        hand = j6 + self.model.hand_per_elbow * j3
        return replace(
            self,
            registers=_added(self.registers, (j1, j2, j3, j4, j5, j6)),
            rotors=_added(self.rotors, (j1, j2, j3, j4, j5, hand)),
        )

    def at(self, registers: Counts) -> Stance:
        """The stance at which the registers have these counts."""
        return self.after([to - at for to, at in zip(registers, self.registers, strict=True)])

    def steps_to(self, pose: Pose) -> Counts:
        """The steps of a `@STEP` to a pose.

        Raises:
            OutOfReach: the arm cannot take it.
        """
        angles = inverse(self.model, pose.x, pose.y, pose.z, pose.pitch, pose.roll)
        cable = round(pose.opening * self.model.hand_steps)
        turns = (
            to - at for to, at in zip(self.drive.rotors(angles, cable), self.rotors, strict=True)
        )
        j1, j2, j3, j4, j5, hand = turns
        return j1, j2, j3, j4, j5, hand - self.model.hand_per_elbow * j3

    @property
    def problem(self) -> str:
        """Why the arm cannot stand so; empty if it can."""
        stop = beyond_any_stop(self.drive, self.rotors)
        if stop is not None:
            return f"beyond the stop: {stop}"
        if self.opening > self.model.hand.range + 1 / self.model.hand_steps:
            return f"the hand opens {self.model.hand.range:g} in and no more"
        height = self.pose.z
        if height < -BELOW_TABLE:
            return f"the fingertip would be {-height:.2f} in below the table"
        return ""


def _added(counts: Counts, more: Counts) -> Counts:
    a, b, c, d, e, f = (count + step for count, step in zip(counts, more, strict=True))
    return a, b, c, d, e, f


@dataclass(frozen=True)
class Plan:
    """What a jog does.

    Attributes:
        pieces: the steps of its `@STEP`s, one after the other.
        problem: why it does not go all the way; empty if it does.
        closes: whether it is to end where the grip switch closes.
    """

    pieces: tuple[Counts, ...] = ()
    problem: str = ""
    closes: bool = False


class Jogger:
    """Plans jogs one after the other.

    It remembers the exact point at which the last one was to end. A jog that begins there, with
    nothing having moved the arm in between, begins at that point and not at the rounded one, so a
    line of many presses ends where one long line would.
    """

    def __init__(self) -> None:
        self._exact: Pose | None = None
        self._reached: Stance | None = None
        self._axes: tuple[tuple[float, float, float], ...] = ()

    def let_go(self) -> None:
        """The keys are let go: the next line in tool coordinates goes as the hand then points."""
        self._axes = ()

    def plan(
        self, stance: Stance, coordinates: Coordinates, ways: Sequence[int], size: StepSize
    ) -> Plan:
        """What to do for one press, or for as long as a key is held once more.

        Args:
            stance: how the arm stands.
            coordinates: what `ways` counts along.
            ways: six of -1, 0 or 1: three lines or joints, two turns or gears, the hand.
            size: how far.
        """
        if not any(ways[:HAND]):
            return self._hand(stance, ways[HAND], coordinates, size)
        if coordinates is Coordinates.JOINT:
            counts = [way * size.half_steps for way in ways]
            return _within_reach(stance, counts)
        return self._line(stance, coordinates, ways, size)

    def _hand(self, stance: Stance, way: int, coordinates: Coordinates, size: StepSize) -> Plan:
        hand = stance.model.hand
        joint = coordinates is Coordinates.JOINT
        piece = round(CLOSING * hand.pound_steps)
        steps = size.half_steps if joint else round(size.inches * stance.model.hand_steps)
        if way > 0:
            return _within_reach(stance, (0, 0, 0, 0, 0, steps))
        if stance.switch_closed:
            room = int((hand.full_grip - stance.force) * hand.pound_steps)
            steps = min(steps, piece, room)
            if steps <= 0:
                return Plan(problem=f"the hand holds with all it has, {hand.full_grip:g} lb")
            return Plan(((0, 0, 0, 0, 0, -steps),))
        # As far as the switch closes on nothing at all.
        cable = round(stance.opening * stance.model.hand_steps) + hand.switch_steps
        steps = min(steps, cable)
        whole, rest = divmod(max(steps, 0), piece)
        parts = [piece] * whole + [rest] * (rest > 0)
        return Plan(
            tuple((0, 0, 0, 0, 0, -part) for part in parts),
            "" if parts else "the hand is closed",
            closes=True,
        )

    def _line(
        self, stance: Stance, coordinates: Coordinates, ways: Sequence[int], size: StepSize
    ) -> Plan:
        begin = stance.exact
        if self._exact is not None and stance == self._reached:
            begin = self._exact
        if not self._axes:
            self._axes = _tool_axes(stance) if coordinates is Coordinates.TOOL else _WORLD_AXES
        shift = [
            size.inches * sum(way * axis[i] for way, axis in zip(ways[:3], self._axes, strict=True))
            for i in range(3)
        ]
        change = (
            *shift,
            ways[3] * size.degrees,
            ways[4] * size.degrees,
            ways[5] * size.inches,
        )
        count = max(
            math.ceil(math.hypot(*shift) / LONGEST_PIECE - 1e-9),
            math.ceil(max(map(abs, change[3:5])) / LARGEST_TURN - 1e-9),
            1,
        )
        pieces: list[Counts] = []
        problem, done, now = "", 0.0, stance
        for number in range(1, count + 1):
            share, found, problem = _farthest(now, begin, change, done, number / count)
            if any(found):
                pieces.append(found)
            now, done = now.after(found), share
            if problem:
                break
        self._exact, self._reached = _moved(begin, change, done), now
        return Plan(tuple(pieces), problem)


_WORLD_AXES = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def _tool_axes(stance: Stance) -> tuple[tuple[float, float, float], ...]:
    """Along the hand, across it to its left, and off its back."""
    points = forward(stance.model, stance.angles)
    (a, b, c), (d, e, f) = points.pointing, points.across
    return points.pointing, points.across, (b * f - c * e, c * d - a * f, a * e - b * d)


def _moved(pose: Pose, change: Sequence[float], share: float) -> Pose:
    return Pose(*(value + share * by for value, by in zip(astuple(pose), change, strict=True)))


def _farthest(
    now: Stance, begin: Pose, change: Sequence[float], done: float, share: float
) -> tuple[float, Counts, str]:
    """How far along a line one piece can go: the share, its steps, and what is in the way."""
    problem = ""
    low, high = done, share
    for tried in _halved(low, high):
        try:
            steps = now.steps_to(_moved(begin, change, tried))
            found = now.after(steps).problem
        except OutOfReach as error:
            found = str(error)
        if not found:
            return tried, steps, problem
        problem = problem or found
    return done, (0, 0, 0, 0, 0, 0), problem


def _halved(low: float, high: float) -> Iterator[float]:
    """From the far end of a piece back to near its beginning."""
    for halving in range(HALVINGS + 1):
        yield low + (high - low) / 2**halving


def _within_reach(stance: Stance, counts: Sequence[int]) -> Plan:
    """One `@STEP`, shortened where a joint ends."""
    problem = ""
    for share in _halved(0.0, 1.0):
        steps = [round(count * share) for count in counts]
        if not any(steps):
            break
        found = stance.after(steps).problem
        if not found:
            a, b, c, d, e, f = steps
            return Plan(((a, b, c, d, e, f),), problem)
        problem = problem or found
    return Plan(problem=problem)
