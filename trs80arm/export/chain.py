"""An arm as a chain of links and joints, as robotics formats have it, computed from its model.

The arm's cables drive the angles of forearm and hand to the horizontal; a chain has each joint
relative to the link before it, and the cables are sums over joints (`motors`). Frames are those
of `ArmModel.solids`: x along the link, y to its left, z up; at zero the arm is stretched forward.
Inches, ounces, radians.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from trs80arm.arm.contact.solids import Solid, box, moments
from trs80arm.arm.geometry import JointAngles
from trs80arm.arm.model import ArmModel, Link, LinkSolid, Motor
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.shapes import Vector

WHOLE_WEIGHT = 96.0
"""Ounces that the arm weighs: Table 1's 6 lb. What the links leave of it is the body's."""
WRIST_SHARE = 0.1
"""How much of the hand's weight its two wrist gears are taken to have, on the wrist's axis."""
JOINTS = ("base", "shoulder", "elbow", "pitch", "roll", "left_finger", "right_finger")
"""Of the chain, from the base on; the fingers slide, each by half of the opening."""

Six = tuple[float, float, float, float, float, float]


@dataclass(frozen=True)
class Joint:
    """What a link moves by.

    Attributes:
        name: one of `JOINTS`.
        axis: in the link's frame.
        slides: whether it slides along the axis instead of turning about it.
        low, high: how far it goes, radians or inches.
        effort: ounce-inches or ounces that its motor lifts while it runs.
        rate: radians or inches a second at most.
    """

    name: str
    axis: Vector
    slides: bool
    low: float
    high: float
    effort: float
    rate: float


@dataclass(frozen=True)
class ChainLink:
    """A moving link.

    Attributes:
        name: of it.
        parent: index of the link before it; None for the table's frame.
        at: its frame's origin in that link's frame.
        joint: that it moves by.
        mass: ounces.
        middle: its centre of mass, in its frame.
        inertia: about that, along the frame's axes: ounce square inches.
        solids: that it takes up, in its frame, with their names.
    """

    name: str
    parent: int | None
    at: Vector
    joint: Joint
    mass: float
    middle: Vector
    inertia: Vector
    solids: tuple[tuple[str, Solid], ...]


def chain(model: ArmModel, settings: ArmSettings) -> tuple[ChainLink, ...]:
    """The arm's moving links, each after its parent, in the order of `JOINTS`.

    Args:
        model: of the arm.
        settings: the size of its body.
    """
    limits, weights, full = model.limits, model.weights, model.full_load
    pieces = {each: [s for s in model.solids if s.link is each] for each in Link}
    rates = {drive.turns: drive.no_load_rate / drive.steps for drive in model.drives}
    up, lift, turn = (0.0, -1.0, 0.0), full * model.link, full * model.hand_length
    wrist = rates[Motor.LEFT_WRIST]

    def revolute(
        name: str, axis: Vector, ends: tuple[float, float], effort: float, rate: float
    ) -> Joint:
        return Joint(name, axis, False, *ends, effort, rate)

    def finger(name: str, side: float) -> Joint:
        ends = 0.0, model.hand.range / 2
        force = 16 * model.hand.full_grip
        return Joint(name, (0.0, side, 0.0), True, *ends, force, rates[Motor.HAND] / 2)

    # The hand's weight is that of hand, gears and fingers: by volume, with the middle where it is.
    hand, fingers = pieces[Link.HAND], pieces[Link.LEFT_FINGER]
    gears = WRIST_SHARE * weights.hand
    room = _volume(hand) + 2 * _volume(fingers)
    one = (weights.hand - gears) * _volume(fingers) / room
    palm = weights.hand - gears - 2 * one
    out = model.hand_length + _middle(fingers)[0]
    palm_at = (weights.hand * weights.hand_at - 2 * one * out) / palm
    body = WHOLE_WEIGHT - weights.upper_arm - weights.forearm - weights.hand
    side, tall = 2 * settings.body_radius, settings.body_top - settings.base_height
    low = settings.base_height + tall / 2 - model.shoulder_height
    thick = 2 * pieces[Link.FOREARM][0].half[2]

    return (
        ChainLink(
            "turret",
            None,
            (0.0, 0.0, model.shoulder_height),
            revolute("base", (0.0, 0.0, 1.0), (-limits.base, limits.base), lift, rates[Motor.BASE]),
            body,
            (0.0, 0.0, low),
            _of_box(body, (side, side, tall)),
            (),
        ),
        ChainLink(
            "upper_arm",
            0,
            (0.0, 0.0, 0.0),
            revolute("shoulder", up, limits.shoulder, lift, rates[Motor.SHOULDER]),
            weights.upper_arm,
            (weights.upper_arm_at, 0.0, 0.0),
            _of_solids(weights.upper_arm, pieces[Link.UPPER_ARM]),
            _solids(pieces[Link.UPPER_ARM]),
        ),
        ChainLink(
            "forearm",
            1,
            (model.link, 0.0, 0.0),
            revolute("elbow", up, limits.elbow, lift, rates[Motor.ELBOW]),
            weights.forearm,
            (weights.forearm_at, 0.0, 0.0),
            _of_solids(weights.forearm, pieces[Link.FOREARM]),
            _solids(pieces[Link.FOREARM]),
        ),
        ChainLink(
            "wrist",
            2,
            (model.link, 0.0, 0.0),
            revolute("pitch", up, (-limits.pitch, limits.pitch), turn, wrist),
            gears,
            (0.0, 0.0, 0.0),
            _of_box(gears, (thick, thick, thick)),
            (),
        ),
        ChainLink(
            "hand",
            3,
            (0.0, 0.0, 0.0),
            revolute("roll", (1.0, 0.0, 0.0), (-limits.gear, limits.gear), turn, wrist),
            palm,
            (palm_at, 0.0, 0.0),
            _of_solids(palm, hand),
            _solids(hand),
        ),
        *(
            ChainLink(
                name,
                4,
                (model.hand_length, 0.0, 0.0),
                finger(name, way),
                one,
                _middle(pieces[link]),
                _of_solids(one, pieces[link]),
                _solids(pieces[link]),
            )
            for name, link, way in (
                ("left_finger", Link.LEFT_FINGER, 1.0),
                ("right_finger", Link.RIGHT_FINGER, -1.0),
            )
        ),
    )


def joint_values(angles: JointAngles, opening: float) -> tuple[float, ...]:
    """Where the joints of the chain are, in the order of `JOINTS`.

    Args:
        angles: of the arm.
        opening: of the hand, inches.
    """
    elbow, pitch = angles.elbow - angles.shoulder, angles.pitch - angles.elbow
    half = opening / 2
    return angles.base, angles.shoulder, elbow, pitch, angles.roll, half, half


_DRIVEN: Mapping[Motor, Sequence[tuple[str, float]]] = {
    Motor.BASE: (("base", 1.0),),
    Motor.SHOULDER: (("shoulder", 1.0),),
    Motor.ELBOW: (("shoulder", 1.0), ("elbow", 1.0)),
    Motor.LEFT_WRIST: (("shoulder", 1.0), ("elbow", 1.0), ("pitch", 1.0), ("roll", 1.0)),
    Motor.RIGHT_WRIST: (("shoulder", 1.0), ("elbow", 1.0), ("pitch", 1.0), ("roll", -1.0)),
    Motor.HAND: (("left_finger", 1.0), ("right_finger", 1.0)),
}
"""What each motor turns as a sum over joints."""


def motors(model: ArmModel) -> tuple[Mapping[str, float], ...]:
    """The cables: half-steps of each motor for a unit of each joint, by latch.

    Counts are from the chain's zero: arm stretched forward, hand just closed.
    """
    found = []
    for latch, drive in enumerate(model.drives):
        sums = {name: factor * drive.sign * drive.steps for name, factor in _DRIVEN[drive.turns]}
        if latch == model.latch(Motor.HAND):
            elbow = model.drives[model.latch(Motor.ELBOW)]
            paid = -model.elbow_pays_out * elbow.sign * elbow.steps
            sums = {name: factor * paid for name, factor in _DRIVEN[Motor.ELBOW]} | sums
        found.append(sums)
    return tuple(found)


def counts(model: ArmModel, values: Sequence[float]) -> Six:
    """Where the motors stand, half-steps from the chain's zero.

    Args:
        model: of the arm.
        values: of the joints, in the order of `JOINTS`.
    """
    at = dict(zip(JOINTS, values, strict=True))
    a, b, c, d, e, f = (
        sum(factor * at[name] for name, factor in sums.items()) for sums in motors(model)
    )
    return a, b, c, d, e, f


def stiffnesses(model: ArmModel) -> tuple[float, ...]:
    """Of the cables by latch: ounce-inches per square half-step."""
    return tuple(model.stiffness[drive.turns] / drive.steps**2 for drive in model.drives)


def _solids(pieces: Sequence[LinkSolid]) -> tuple[tuple[str, Solid], ...]:
    return tuple((piece.name, _solid(piece)) for piece in pieces)


def _solid(piece: LinkSolid) -> Solid:
    x, y, z = piece.half
    return box((2 * x, 2 * y, 2 * z)).moved(piece.center)


def _volume(pieces: Sequence[LinkSolid]) -> float:
    return moments([_solid(piece) for piece in pieces]).volume


def _middle(pieces: Sequence[LinkSolid]) -> Vector:
    return moments([_solid(piece) for piece in pieces]).middle


def _of_solids(mass: float, pieces: Sequence[LinkSolid]) -> Vector:
    """Moments of inertia of a link of even density about its middle, wherever its weight is."""
    whole = moments([_solid(piece) for piece in pieces])
    density = mass / whole.volume
    return whole.inertia[0] * density, whole.inertia[4] * density, whole.inertia[8] * density


def _of_box(mass: float, size: Vector) -> Vector:
    x, y, z = (length * length for length in size)
    return mass * (y + z) / 12, mass * (x + z) / 12, mass * (x + y) / 12
