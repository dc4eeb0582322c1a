"""Table 1 measured: each of its rows as an experiment on the running arm.

Nothing here reads the model's limits. Joints are driven until they slip, speeds raised until
steps are lost, parts made heavier until they cannot be lifted; what comes out is set beside what
the article lists. The tests and `trs80arm figure table1` read the rows.
"""

from __future__ import annotations

import math
import pickle
from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum

from trs80arm.arm.bench import Bench
from trs80arm.arm.contact.clock import T_STATES_PER_SECOND
from trs80arm.arm.events import EventKind
from trs80arm.arm.geometry import JointAngles, forward
from trs80arm.arm.minimover import MiniMover
from trs80arm.arm.model import Motor, Pose
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.stepping import PulseGenerator

SLOW = T_STATES_PER_SECOND // 120
"""T-states per step at 120 steps a second, at which every motor keeps up."""
_NEAR = 0.02
"""How far from what the article lists a figure is looked for first, as a fraction of it."""
PICK_UP = Pose(8.0, 0.0, 0.5, -90.0, 0.0, 1.0)


class Verdict(Enum):
    """What becomes of a figure of Table 1."""

    KEPT = "yes"
    CONTRADICTED = "the article contradicts it"
    MISSED = "no"


@dataclass(frozen=True, slots=True)
class Row:
    """One figure of Table 1.

    Attributes:
        name: of the figure.
        unit: of both numbers.
        article: what Table 1 lists.
        measured: what the arm did.
        margin: how far beyond the listed figure the arm may go, as a fraction of it.
        at_most: whether the article lists the greatest that it may be.
        contradiction: another figure of the article that this one cannot be had with, and which of
            them the arm follows; empty where there is none.
    """

    name: str
    unit: str
    article: float
    measured: float
    margin: float = 0.0
    contradiction: str = ""
    at_most: bool = False

    @property
    def listed(self) -> str:
        """The article's number, as it lists it."""
        return f"up to {self.article:g}" if self.at_most else f"{self.article:g}"

    @property
    def verdict(self) -> Verdict:
        """Whether the arm does what the article lists, and not much more."""
        hair = 0.3 if self.unit == "deg" else 0.001  # an angle is found to one half-step
        low = 0.0 if self.at_most else abs(self.article) * 0.985 - hair
        high = abs(self.article) * (1 + self.margin) + hair
        same_way = self.article * self.measured >= 0
        if (same_way or self.article == 0) and low <= abs(self.measured) <= high:
            return Verdict.KEPT
        return Verdict.CONTRADICTED if self.contradiction else Verdict.MISSED


def table1() -> list[Row]:
    """Measure every row of Table 1; takes some seconds."""
    return [*_general(), *_ranges(), *_speeds()]


# Apparatus


PROMPT = ArmSettings(pull_out_lag=1)
"""Rotors that may not trail at all: speeds are measured with them, as the half ring that a rotor
may be behind would let it run faster over a short way."""


def _bare(settings: ArmSettings | None = None) -> PulseGenerator:
    """An arm above an empty table."""
    return PulseGenerator(MiniMover(settings, Bench("empty")))


def _gripping(weight: float, settings: ArmSettings | None = None) -> PulseGenerator:
    """An arm that has gripped a half-inch part as hard as it can; motors off."""
    bench = Bench("one part")
    bench.add_part("load", (0.5, 0.5, 1.0), weight, PICK_UP.x, PICK_UP.y)
    generator = PulseGenerator(MiniMover(settings, bench))
    generator.arm.move_to(PICK_UP)
    generator.close(SLOW)
    generator.turn(Motor.HAND, -145, SLOW)
    generator.off()
    return generator


def _copies(generator: PulseGenerator) -> Callable[[], PulseGenerator]:
    """What makes arms that stand as this one does now, for those who try many times."""
    state = pickle.dumps(generator, pickle.HIGHEST_PROTOCOL)

    def copy() -> PulseGenerator:
        made: PulseGenerator = pickle.loads(state)
        return made

    return copy


def _set(generator: PulseGenerator, *degrees: float) -> None:
    """Put the joints by hand: base, shoulder, elbow, pitch, roll."""
    generator.arm.move_joints(JointAngles(*(math.radians(value) for value in degrees)))
    generator.align()


def _lost(generator: PulseGenerator) -> bool:
    """Whether any motor has lost steps."""
    return any(event.kind is EventKind.SLIP for event in generator.arm.events)


def _most(
    holds: Callable[[float], bool], low: float, high: float, about: float | None = None
) -> float:
    """The largest number for which something holds, to a thousandth.

    Args:
        holds: whether it does; for all lower numbers it does too.
        low: a number for which it is known to hold.
        high: a number for which it is known not to.
        about: where the number may be; that it is there is tried first, as it saves tries.
    """
    least, most = low, high
    if about is not None:
        for guess in (about * (1 - _NEAR), about * (1 + _NEAR)):
            if holds(guess):
                least = max(least, guess)
            else:
                most = min(most, guess)
                break
    while high - low > low / 1000:
        middle = (low + high) / 2
        if middle <= least or (middle < most and holds(middle)):
            low = middle
        else:
            high = middle
    return low


# Experiments


def _general() -> list[Row]:
    """The upper part of Table 1."""
    moved = _resolution()
    weight = (
        "Table 4 carries 8 oz at speeds that ask for links that weigh something. At half "
        "extension they too have half the lever, which leaves more for the load than twice 8 oz. "
        "The arm follows Table 4."
    )
    steps = (
        "Table 4's steps per radian (937.8 for the base, 203.7 for a wrist gear) make coarser "
        "half-steps of it at this distance (17.5 and 3.5 in). The arm follows Table 4."
    )

    def resolution(name: str, motor: Motor, contradiction: str = "") -> Row:
        return Row(
            f"resolution, {name}", "in", 0.013, moved[motor], 0.0, contradiction, at_most=True
        )

    return [
        resolution("base at full reach", Motor.BASE, steps),
        resolution("shoulder", Motor.SHOULDER),
        resolution("elbow", Motor.ELBOW),
        resolution("wrist pitch", Motor.LEFT_WRIST, steps),
        resolution("hand", Motor.HAND),
        Row("load at full extension", "oz", 8.0, _capacity(0.0, 8.0), 0.1),
        Row("load at half extension", "oz", 16.0, _capacity(60.0, 16.0), 0.1, weight),
        Row("gripping force", "lb", 3.0, _gripping_force()),
        Row("reach", "in", 17.5, _reach()),
        Row("static load force", "lb", 4.0, _static_force(), 0.01),
    ]


def _resolution() -> list[float]:
    """Movement, for one half-step, of the end of the link that each motor turns, inches.

    The base turns the whole arm, stretched out; the wrist's two gears together the fingertip; the
    hand moves the fingers against each other.
    """
    generator = _bare()
    _set(generator, 0, 0, -1, -1, 0)
    found = []
    for motor in range(5):
        before = forward(generator.arm.model, generator.arm.state().angles)
        generator.turn(motor, -8, SLOW)
        after = forward(generator.arm.model, generator.arm.state().angles)
        if motor == Motor.SHOULDER:
            moved = math.dist(before.elbow, after.elbow)
        elif motor == Motor.ELBOW:
            moved = math.dist(before.wrist, after.wrist)
        elif motor == Motor.BASE:
            moved = math.dist(before.fingertip, after.fingertip)
        else:
            # One gear alone turns the hand half as far as both together.
            moved = 2 * math.dist(before.fingertip, after.fingertip)
        found.append(moved / 8)
    generator.turn(Motor.HAND, 16, SLOW)
    before_opening = generator.arm.state().pose.opening
    generator.turn(Motor.HAND, 8, SLOW)
    found.append((generator.arm.state().pose.opening - before_opening) / 8)
    return found


def _capacity(bend: float, listed: float) -> float:
    """Most ounces that shoulder and elbow lift at the full-load speeds of Table 1.

    Args:
        bend: degrees of the links to the horizontal; 0 stretches the arm out, 60 halves it.
        listed: what Table 1 lists.
    """
    drives = _bare().arm.model.drives
    rates = {m: drives[m].full_load_rate for m in (Motor.SHOULDER, Motor.ELBOW)}

    def lifts(weight: float) -> bool:
        gripping = _copies(_gripping(weight))
        for motor, rate in rates.items():
            generator = gripping()
            if motor == Motor.SHOULDER:
                _set(generator, 0, bend, -bend - 1, -bend, 0)
            else:
                _set(generator, 0, bend + 5, -bend - 10, -bend, 0)
            count = -100 if motor == Motor.SHOULDER else 100
            generator.turn(motor, count, round(T_STATES_PER_SECOND / rate))
            if _lost(generator):
                return False
        return True

    return _most(lifts, 1.0, 60.0, listed)


def _gripping_force() -> float:
    """Pounds on a part when the hand motor gives up."""
    bench = Bench("one part")
    bench.add_part("load", (0.5, 0.5, 1.0), 2.0, PICK_UP.x, PICK_UP.y)
    generator = PulseGenerator(MiniMover(bench=bench))
    generator.arm.move_to(PICK_UP)
    generator.align()
    most = 0.0
    while not _lost(generator):
        generator.turn(Motor.HAND, -1, SLOW)
        most = max(most, generator.arm.state().force)
    return most


def _stretched() -> PulseGenerator:
    """The arm stretched out level."""
    generator = _bare()
    _set(generator, 0, 30, -10, 0, 0)
    generator.go(JointAngles(0.0, 0.0, 0.0, 0.0, 0.0), SLOW)
    return generator


def _reach() -> float:
    """From the shoulder's axis to the fingertip of the stretched arm, inches."""
    generator = _stretched()
    pose = generator.arm.state().pose
    return math.hypot(pose.x, pose.z - generator.arm.model.shoulder_height)


def _static_force() -> float:
    """Pounds that can be hung on the hand of the stretched arm before it loses steps."""
    stretched = _copies(_stretched())

    def holds(force: float) -> bool:
        generator = stretched()
        generator.arm.pull((0.0, 0.0, -16 * force))
        return not _lost(generator)

    return _most(holds, 0.5, 20.0, 4.0)


def _stop(degrees: tuple[float, ...], counts: tuple[int, ...]) -> JointAngles:
    """Drive motors until one slips, from joint angles in degrees; the farthest they got."""
    generator = _bare()
    _set(generator, *degrees)
    # A rotor at a stop falls back when its field has gone half a ring too far.
    start = generator.arm.rotors
    farthest, best = generator.arm.state().angles, 0
    while not _lost(generator):
        generator.step(counts, SLOW)
        turned = zip(generator.arm.rotors, start, counts, strict=False)
        way = sum((now - then) * count for now, then, count in turned)
        if way > best:
            farthest, best = generator.arm.state().angles, way
    return farthest


def _ranges() -> list[Row]:
    """How far each joint goes, degrees and inches."""
    up = (0.0, 90.0, 20.0, 20.0, 0.0)
    level = (0.0, 60.0, 0.0, 0.0, 0.0)
    down = (0.0, 60.0, -30.0, -90.0, 0.0)
    rows = []

    def row(name: str, article: float, radians: float) -> None:
        rows.append(Row(f"{name} range", "deg", article, math.degrees(radians)))

    row("base", 90, _stop(up, (1,)).base)
    row("base", -90, _stop(up, (-1,)).base)
    row("shoulder", 144, _stop(up, (0, -1)).shoulder)
    row("shoulder", -35, _stop((0, -20, -35.2, 50, 0), (0, 1)).shoulder)
    bent = _stop(up, (0, 0, -1))
    row("elbow", -149, bent.elbow - bent.shoulder)
    straight = _stop(up, (0, 0, 1))
    row("elbow", 0, straight.elbow - straight.shoulder)
    row("wrist roll", 180, _stop(down, (0, 0, 0, -1, -1)).roll)
    row("wrist roll", -180, _stop(down, (0, 0, 0, 1, 1)).roll)
    row("wrist pitch", 90, _stop(level, (0, 0, 0, -1, 1)).pitch)
    row("wrist pitch", -90, _stop(level, (0, 0, 0, 1, -1)).pitch)
    generator = _bare()
    _set(generator, *up)
    widest = 0.0
    while not _lost(generator):
        generator.turn(Motor.HAND, 1, SLOW)
        widest = max(widest, generator.arm.state().pose.opening)
    rows.append(Row("hand range", "in", 3.0, widest))
    return rows


def _fastest(ready: PulseGenerator, counts: tuple[int, ...], listed: float) -> float:
    """Half-steps per second above which motors lose steps; `listed` are those of Table 1."""
    begins = _copies(ready)

    def keeps_up(rate: float) -> bool:
        generator = begins()
        generator.step(counts, round(T_STATES_PER_SECOND / rate))
        return not _lost(generator) and all(motor.settled for motor in generator.arm.motors)

    return _most(keeps_up, 20.0, 2000.0, listed)


def _speeds() -> list[Row]:
    """Speeds at full load and at no load, radians, inches and pounds per second."""
    # Shoulder and elbow are taken through the level, where they have most to lift.
    bent = {Motor.SHOULDER: (0, -15, -20, -8, 0), Motor.ELBOW: (0, 40, -20, -8, 0)}

    def free(motor: Motor) -> PulseGenerator:
        generator = _bare(PROMPT)
        _set(generator, *bent.get(motor, (0, 0, -1, -8, 0)))
        return generator

    # Gripping takes its time: it is done once.
    eight_ounces = _copies(_gripping(8.0, PROMPT))

    def loaded(motor: Motor) -> PulseGenerator:
        generator = eight_ounces()
        _set(generator, *bent.get(motor, (0, 0, -1, -8, 0)))
        return generator

    def squeezing() -> PulseGenerator:
        generator = _gripping(2.0, PROMPT)
        generator.align()
        generator.turn(Motor.HAND, 145, SLOW)
        return generator

    model = _bare().arm.model
    base, _, elbow, wrist, _, hand = (drive.steps for drive in model.drives)
    rows = []
    listed = (
        (Motor.BASE, "base", (600,), base, 0.37, 0.42),
        (Motor.SHOULDER, "shoulder", (0, -400), base, 0.15, 0.36),
        (Motor.ELBOW, "elbow", (0, 0, 350), elbow, 0.23, 0.82),
        (Motor.LEFT_WRIST, "wrist roll", (0, 0, 0, -60, -60), wrist, 1.31, 2.02),
        (Motor.LEFT_WRIST, "wrist pitch", (0, 0, 0, -60, 60), wrist, 1.31, 2.02),
    )
    for motor, name, counts, steps, full, none in listed:
        measured = _fastest(loaded(motor), counts, full * steps) / steps
        rows.append(Row(f"{name} speed, full load", "rad/s", full, measured, 0.05))
        measured = _fastest(free(motor), counts, none * steps) / steps
        rows.append(Row(f"{name} speed, no load", "rad/s", none, measured, 0.05))
    opening = _fastest(free(Motor.HAND), (0, 0, 0, 0, 0, 900), 0.8 * hand) / hand
    rows.append(Row("hand speed, no load", "in/s", 0.80, opening, 0.05))
    pound = model.hand.pound_steps
    squeeze = _fastest(squeezing(), (0, 0, 0, 0, 0, -149), 3.0 * pound) / pound
    rows.append(Row("hand force, up to full grip", "lb/s", 3.0, squeeze, 0.06))
    return rows
