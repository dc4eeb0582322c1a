"""What must hold of a rig, whatever was done to it."""

from __future__ import annotations

import math

from trs80arm import Rig
from trs80arm.machine.memory import ADDRESSES
from trs80arm.machine.printer import PAPER

DEEPEST = 0.01
"""Inches by which a part that rests or is pressed down may give way to the table."""


class BrokenError(AssertionError):
    """Something that must always hold does not."""


def hold(truth: bool, what: str) -> None:
    """Raise if something is not so."""
    if not truth:
        raise BrokenError(what)


def rig_is_whole(rig: Rig) -> None:
    """Memory, registers, pose and screen are what they can be, and nothing grows without end."""
    hold(len(rig.memory.ram) == ADDRESSES, f"RAM is {len(rig.memory.ram)} bytes long")
    hold(len(rig.video.cells) == 1024, "the tube has another size")
    hold(all(-32768 <= count <= 32767 for count in rig.registers), "a register has 16 bits")
    pose = rig.pose
    values = (pose.x, pose.y, pose.z, pose.pitch, pose.roll, pose.opening, rig.state.force)
    hold(all(map(math.isfinite, values)), f"the hand is at {pose}")
    screen = rig.screen()
    hold(len(screen) == 16 and all(len(line) <= 64 for line in screen), "the screen")
    hold(type(rig.clock.now) is int, "time is a count")
    hold(len(rig.printer.sent) <= 2 * PAPER, "paper in memory")
    hold(len(rig.basic.state.stack) < 50, "activities lie on activities")
    for name, part in rig.arm.bench.parts.items():
        hold(part.box.bottom > -DEEPEST, f"{name} is in the table")
