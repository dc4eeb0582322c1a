"""How a run ended and where everything is, as one plain object: `trs80arm run --json`.

Numbers, words, lists and tables only, for programs to read. Inches, degrees, pounds of grip, ounces
of weight, ounce-inches of torque, half-steps, seconds.
"""

from __future__ import annotations

from dataclasses import asdict
from math import degrees
from typing import Any

from trs80arm.arm.events import EventKind
from trs80arm.arm.loads import MotorLoad
from trs80arm.arm.model import ArmModel
from trs80arm.basic.activity import Waiting
from trs80arm.basic.outcome import Outcome
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.rig import Rig

DIGITS = 6
"""Decimals of what is no whole number."""
LIMIT = "limit"
"""How a run ended whose time was over."""


def ended(outcome: Outcome | None, waiting: Waiting) -> dict[str, Any]:
    """How a run ended.

    Args:
        outcome: of the program, if it has ended.
        waiting: what the machine waits for.

    Returns:
        `how`: `end`, `stop`, `break` or `error`; `input` or `set` where nobody answered; `limit`
        where its time was over. `line` where, `error` the error's two letters, or None.
    """
    if outcome is None:
        how = LIMIT if waiting is Waiting.NOTHING else waiting.name.lower().replace("_", " ")
        return {"how": how, "line": None, "error": None}
    return {
        "how": outcome.ending.value,
        "line": outcome.line,
        "error": outcome.code.letters if outcome.code else None,
    }


def report(rig: Rig) -> dict[str, Any]:
    """Where everything is, and what motors and grip bear.

    Returns:
        `arm`, `bench`, `screen`, `registers`, `joints`, `angles`, `pose`, `grip`, `motors`,
        `slipped`, `slips`, `events`, `parts`, `devices`, `sensors`, `score` (None where the bench
        has no goals), `time` (virtual seconds since power-on).
    """
    state, loads, arm = rig.state, rig.loads, rig.arm
    pose, angles, grip = state.pose, state.angles, loads.grip
    turns = ("base", "shoulder", "elbow", "pitch", "roll")
    told: dict[str, Any] = _plain(
        {
            "arm": arm.model.name,
            "bench": arm.bench.name,
            "screen": rig.screen(),
            "registers": list(rig.registers),
            "joints": list(rig.joints),
            "angles": {name: degrees(getattr(angles, name)) for name in turns},
            "pose": asdict(pose),
            "grip": {
                "force": grip.force,
                "needed": grip.needed,
                "used": grip.used if grip.force else None,
                "weight": grip.weight,
                "switch": state.switch_closed,
                "held": state.held,
            },
            "motors": [_motor(load) for load in loads.motors],
            "slipped": list(state.slipped),
            "slips": [
                {
                    "motor": _name(arm.model, event.motor or 0),
                    "time": event.time / T_STATES_PER_SECOND,
                    "steps": event.steps,
                    "reason": event.reason.value if event.reason else None,
                    "count": event.count,
                    "text": event.text,
                }
                for event in arm.events
                if event.kind is EventKind.SLIP
            ],
            "events": arm.event_count,
            "parts": [
                {
                    "name": name,
                    "at": list(part.box.center),
                    "weight": part.weight,
                    "held": part.held,
                }
                for name, part in arm.bench.parts.items()
            ],
            "devices": [{"name": name, "does": does} for name, does in rig.devices.items()],
            "sensors": [
                {"name": name, "bit": each.bit, "bank": each.bank, "answers": each.given}
                for name, each in rig.sensors.items()
            ],
            "score": rig.score().plain() if arm.bench.goals else None,
            "time": rig.time,
        }
    )
    return told


def _name(model: ArmModel, latch: int) -> str:
    """What people call the motor of a latch; that of the auxiliary one turns a turntable."""
    return (*model.motor_names, "turntable")[latch]


def _motor(load: MotorLoad) -> dict[str, Any]:
    """What one motor bears, and what it has."""
    return {
        "name": load.name,
        "torque": load.torque,
        "rotor_torque": load.rotor_torque,
        "cable": load.cable,
        "rate": load.rate,
        "has": load.has,
        "used": load.used,
        "margin": load.margin,
        "peak": load.peak / 100,
        "current": load.energised,
    }


def _plain(value: Any) -> Any:
    """The same with its numbers rounded, and no minus before a nought."""
    if isinstance(value, float):
        return round(value, DIGITS) + 0.0
    if isinstance(value, dict):
        return {name: _plain(item) for name, item in value.items()}
    if isinstance(value, list):
        return [_plain(item) for item in value]
    return value
