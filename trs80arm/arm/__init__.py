"""The MiniMover 5: stepper motors, cables, joints, hand, and the bench it works on."""

from __future__ import annotations

from trs80arm.arm.bench import Bench, BenchError
from trs80arm.arm.by_hand import InTheWay, MotorsOn
from trs80arm.arm.events import ArmEvent, EventKind, Reason
from trs80arm.arm.geometry import JointAngles, OutOfReach
from trs80arm.arm.minimover import MiniMover
from trs80arm.arm.model import ArmModel, Motor, Pose
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.state import ArmState

__all__ = [
    "ArmEvent",
    "ArmModel",
    "ArmSettings",
    "ArmState",
    "Bench",
    "BenchError",
    "EventKind",
    "InTheWay",
    "JointAngles",
    "MiniMover",
    "Motor",
    "MotorsOn",
    "OutOfReach",
    "Pose",
    "Reason",
]
