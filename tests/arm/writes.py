"""Latch writes of motions: recorded, and those of a cycle in a cell."""

from __future__ import annotations

import numpy as np

from trs80arm.arm.models import MINIMOVER5
from trs80arm.arm.stepping import PulseGenerator, delay_period
from trs80arm.pulses import Burst

Writes = list[tuple[int, int, int]]


class Recorder:
    """Takes the place of an arm's cable and keeps what comes down it."""

    def __init__(self) -> None:
        self.writes: Writes = []
        self.rotors = (0,) * 6
        self.model = MINIMOVER5

    def follow(self, burst: Burst, stop: object) -> int:
        each = burst.columns().arrays()
        columns = (
            np.asarray(column).tolist() for column in (each.times, each.latches, each.nibbles)
        )
        self.writes += zip(*columns, strict=True)
        return len(burst)


CELL = """
[[feeder]]
at = [8, 0]
size = [0.5, 0.5, 1.0]
[[tray]]
at = [6, 5]
size = [2, 2]
"""


def picks_and_places(cycles: int) -> Writes:
    """Table 4's cycle: approach, grip, squeeze, lift, swing, press down, let go, back."""
    recorder = Recorder()
    generator = PulseGenerator(recorder)  # type: ignore[arg-type]
    usual, slow = delay_period(50), delay_period(100)
    generator.step((0, 0, 0, 0, 0, 370), usual)
    generator.step((0, -207, 290), usual)
    for cycle in range(cycles):
        generator.step((0, 132, -36), usual)
        generator.step((0, 0, 0, 0, 0, -268 if cycle else -62), usual)
        generator.step((0, 0, 0, 0, 0, -30), slow)
        generator.step((0, -132, 36), slow)
        generator.step((651, -8, -13, -461, -462), usual)
        generator.step((0, 135, -37), usual)
        generator.step((0, 0, 0, 0, 0, 300), usual)
        generator.step((0, -135, 37), usual)
        generator.step((-651, 8, 13, 461, 462), usual)
    return recorder.writes
