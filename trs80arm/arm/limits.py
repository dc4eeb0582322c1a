"""How far: the stops of the joints.

`MiniMover` asks before each half-step whether a joint is at its stop.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from trs80arm.arm.geometry import CableDrive, pitch_and_roll
from trs80arm.arm.model import BASE, ELBOW, HAND, LEFT_WRIST, SHOULDER, ArmModel

_HAIR = 1e-9


def beyond_stop(
    motor: int, step: int, drive: CableDrive, rotors: Sequence[int], slack: int = 0
) -> str | None:
    """Whether a motor has turned a joint past its stop.

    Only stops that the motor moves towards count: a joint may always come back. The limits of
    the forearm are relative to the upper arm, so the shoulder meets them too (article, joint 3).

    Args:
        motor: that moves, 0 to 5.
        step: its direction, 1 or -1.
        drive: the cables.
        rotors: positions after the move.
        slack: half-steps that are forgiven.

    Returns:
        The stop's description, or None.
    """
    model = drive.model
    if model.drives[motor].turns is HAND:
        over = drive.cable(rotors) > model.hand.range * model.hand_steps + slack
        opens = step * model.drives[motor].sign > 0
        return f"hand 0 to {model.hand.range:g} in" if opens and over else None
    return _joint_beyond(motor, step, model, drive.driven(rotors), slack)


def _joint_beyond(
    motor: int, step: int, model: ArmModel, driven: Sequence[float], slack: int
) -> str | None:
    """`beyond_stop` of a motor that is not the hand's, for who has what the motors turn.

    Args:
        motor: as for `beyond_stop`.
        step: as for `beyond_stop`.
        model: of the arm.
        driven: what the motors turn, as `CableDrive` has it.
        slack: as for `beyond_stop`.
    """
    limits, turned = model.limits, model.drives[motor]
    turns, up = turned.turns, step * turned.sign
    base, shoulder, elbow, left, right = driven
    hair = _HAIR + slack / 200.0
    if turns is BASE:
        return f"base +-{_degrees(limits.base)}" if base * up > limits.base + hair else None
    if turns is SHOULDER:
        low, high = limits.shoulder
        if up > 0 and shoulder > high + hair:
            return f"shoulder {_degrees(high):+}"
        if up < 0 and shoulder < low - hair:
            return f"shoulder {_degrees(low):+}"
    pitch, roll = pitch_and_roll(left, right)
    if turns in (SHOULDER, ELBOW):
        low, high = limits.elbow
        bend = elbow - shoulder
        # Raising the upper arm bends the elbow as lowering the forearm does.
        opening = up if turns is ELBOW else -up
        if opening > 0 and bend > high + hair:
            return f"elbow {_degrees(high)}"
        if opening < 0 and bend < low - hair:
            return f"elbow {_degrees(low)}"
        if turns is SHOULDER:
            return None
        if (pitch - elbow) * up < -limits.pitch - hair:
            return f"pitch +-{_degrees(limits.pitch)}"
        return None
    gear = pitch + roll if turns is LEFT_WRIST else pitch - roll
    if gear * up > limits.gear + hair:
        return f"wrist gear +-{_degrees(limits.gear)}"
    if (pitch - elbow) * up > limits.pitch + hair:
        return f"pitch +-{_degrees(limits.pitch)}"
    return None


def _degrees(radians: float) -> int:
    """Whole degrees, as stops are called."""
    return round(math.degrees(radians))


def steps_to_stops(drive: CableDrive, rotors: Sequence[int]) -> int:
    """Half-steps that the motors can make, whichever and whichever way, before any stop."""
    model, limits = drive.model, drive.model.limits
    base, shoulder, elbow, left, right = drive.driven(rotors)
    bend, pitch = elbow - shoulder, pitch_and_roll(left, right)[0] - elbow
    room = min(
        limits.base - abs(base),
        shoulder - limits.shoulder[0],
        limits.shoulder[1] - shoulder,
        bend - limits.elbow[0],
        limits.elbow[1] - bend,
        limits.pitch - abs(pitch),
        limits.gear - abs(left),
        limits.gear - abs(right),
    )
    cable = model.hand.range * model.hand_steps - drive.cable(rotors)
    fewest = min(room * model.finest_steps, cable)
    return max(0, int(fewest) - 1)


def beyond_any_stop(drive: CableDrive, rotors: Sequence[int]) -> str | None:
    """Description of a stop that the arm is more than a half-step beyond, or None."""
    driven = drive.driven(rotors)
    for motor in range(5):
        for step in (-1, 1):
            stop = _joint_beyond(motor, step, drive.model, driven, slack=1)
            if stop is not None:
                return stop
    return None
