"""What the motors do, in words, for figures: from an arm's signs and nothing else."""

from __future__ import annotations

from trs80arm.arm.model import ArmModel, Drive, Motor

_UP = {
    Motor.BASE: ("turns the arm left", "turns the arm right"),
    Motor.SHOULDER: ("raises the upper arm", "lowers the upper arm"),
    Motor.ELBOW: ("raises the forearm", "lowers the forearm"),
    Motor.LEFT_WRIST: ("raises P + R", "lowers P + R"),
    Motor.RIGHT_WRIST: ("raises P - R", "lowers P - R"),
    Motor.HAND: ("opens the hand", "closes the hand"),
}
"""What each joint does as its angle grows, and as it falls."""
PARTS = {
    Motor.BASE: "the base",
    Motor.SHOULDER: "the upper arm",
    Motor.ELBOW: "the forearm",
    Motor.LEFT_WRIST: "the left wrist gear",
    Motor.RIGHT_WRIST: "the right wrist gear",
    Motor.HAND: "the hand's links",
}
"""What each cable turns."""


def does(drive: Drive, way: int) -> str:
    """What a motor does when it counts up (1) or down (-1)."""
    up, down = _UP[drive.turns]
    return up if way * drive.sign > 0 else down


def name(drive: Drive) -> str:
    """What people call what a motor turns."""
    return drive.turns.name.lower().replace("_", " ")


def number(model: ArmModel, motor: Motor) -> str:
    """J1 to J6: what the motor that turns something is called in ARMBASIC."""
    return f"J{model.latch(motor) + 1}"
