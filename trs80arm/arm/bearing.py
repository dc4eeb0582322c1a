"""What bears on an arm's motors: weight, what is in the hand, what pushes, presses and pulls."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from trs80arm.arm.forces import Burden, cosine, torques
from trs80arm.arm.geometry import forward
from trs80arm.arm.loads import GripLoad, Loads, motor_load
from trs80arm.arm.model import BASE, ELBOW, HAND, SHOULDER, Link, Motor

if TYPE_CHECKING:
    from trs80arm.arm.minimover import MiniMover


def period_at(arm: MiniMover, latch: int, turn: int, rotors: Sequence[int]) -> int:
    """T-states that a motor needs for a half-step where nothing but weight bears on the arm.

    Args:
        arm: the arm.
        latch: of the motor.
        turn: which way it turns.
        rotors: where all stand.
    """
    turns, burdens = arm.motor_kinds[latch], arm.world.burdens()
    if turns is HAND:
        squeeze = max(0, arm.grip.contact - arm.drive.cable(rotors))
        against = 16 * (squeeze / arm.model.hand.pound_steps) if turn < 0 else 0.0
    elif turns is BASE and not burdens:
        against = 0.0
    else:
        weight = weighing(arm, turns, burdens, rotors)
        lifts = turns is BASE or turn * arm.model.drives[latch].sign > 0
        against = max(0.0, weight if lifts else -weight)
    return arm.strength.curves[turns].period(against, arm.settings.speed_margin)


def resistance(arm: MiniMover, latch: int, turn: int, rotors: Sequence[int]) -> tuple[float, float]:
    """Torque that a motor turns against, at least 0, and how much of it is not own weight."""
    if turn == 0:
        return 0.0, 0.0
    turns, world = arm.motor_kinds[latch], arm.world
    own = weighing(arm, turns, (), rotors)
    up = turn * arm.model.drives[latch].sign > 0
    if world.untouched and arm.pulled is None:
        against = own if up else -own
        return against if against > 0.0 else 0.0, 0.0
    burdens, pushed = world.burdens(), pushing(arm, turns)
    weight = weighing(arm, turns, burdens, rotors) if burdens else own
    if turns is BASE:
        against = weight - pushed if turn > 0 else weight + pushed
        return max(0.0, against), against
    against, alone = (weight - pushed, own) if up else (pushed - weight, -own)
    return max(0.0, against), against - alone


def weighing(
    arm: MiniMover, turns: Motor, burdens: Sequence[Burden], rotors: Sequence[int]
) -> float:
    """Torque with which weight pulls a motor's angle down (the base: drags it)."""
    if turns is HAND or (turns is BASE and not burdens):
        return 0.0
    if turns is SHOULDER or turns is ELBOW:
        lifted: float = arm.drive.lifted(turns, rotors)
        return arm.strength.level(turns, burdens) * cosine(lifted)
    driven = arm.drive.driven(rotors)
    return float(arm.strength.weight(turns, driven, burdens, cosine))


def pushing(arm: MiniMover, turns: Motor) -> float:
    """Torque of contacts and of the operator's hand; positive pushes the angle up."""
    if arm.pulled is None:
        return arm.world.torque(turns)
    return pushes(arm)[turns]


def pushes(arm: MiniMover) -> tuple[float, ...]:
    """The same for all six motors, by `Motor`."""
    pushed = arm.world.torques
    if arm.pulled is None:
        return pushed
    angles = arm.world.angles
    tip = forward(arm.model, angles).fingertip
    pulled = torques(arm.model, angles, Link.HAND, tip, arm.pulled)
    return tuple([one + other for one, other in zip(pushed, pulled, strict=True)])


def borne(arm: MiniMover) -> tuple[float, ...]:
    """What the motors bear now, by latch: ounce-inches at the joint, ounces at the fingers.

    Positive pulls a joint's angle down, or the fingers together. Weight, what is in the hand,
    what pushes and presses.
    """
    return tuple(_borne(arm, turns) for turns in arm.motor_kinds)


def _borne(arm: MiniMover, turns: Motor) -> float:
    """What one motor bears."""
    if turns is HAND:
        return -16 * arm.world.grip.force
    burdens = arm.world.burdens()
    return weighing(arm, turns, burdens, arm.rotors) - pushing(arm, turns)


def loads(arm: MiniMover, time: int) -> Loads:
    """What motors and hand bear at a T-state, not before the last write, and what they have."""
    motors = []
    for latch, drive in enumerate(arm.model.drives):
        motor, turns = arm.motors[latch], drive.turns
        rate, torque = motor.rate(time), _borne(arm, turns)
        if rate:
            against = resistance(arm, latch, motor.way, arm.rotors)[0]
        else:
            # What is carried drags on a base that turns, and does nothing to one that stands.
            torque = -pushing(arm, turns) if turns is BASE else torque
            against = abs(torque)
        motors.append(
            motor_load(
                motor,
                drive,
                arm.strength.curves[turns],
                torque=torque + 0.0,
                against=against,
                rate=rate,
                margin=arm.settings.speed_margin,
                peak=arm.peaks[latch],
            )
        )
    weight, friction = arm.world.hold
    return Loads(tuple(motors), GripLoad(arm.grip.force, weight, friction))
