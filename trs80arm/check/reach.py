"""Where the joints can be after steps, and what no joint can do wherever the arm has begun.

Each pair of stops bounds a sum of joint angles: the elbow's is its angle to the upper arm, the
pitch's that to the forearm. Of each such sum there is a range in which it can be. A motion shifts
it; where nothing of it is left between the stops, the motion drives the arm against one of them,
wherever it began.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from trs80arm.arm.geometry import JointAngles, forward, inverse
from trs80arm.arm.model import ArmModel, Pose

_HAIR: Final = 0.015
"""Radians forgiven: what programs round off by counting whole half-steps."""
_TABLE: Final = 0.25
"""Inches that a fingertip may be below the table before it is told."""
_ARM: Final = 5
"""The motors that turn joints; the hand's is the sixth."""


@dataclass(frozen=True)
class _Stops:
    """What two stops bound.

    Attributes:
        name: what people call it.
        counts: of the angles of base, upper arm, forearm, left and right gear in it.
        low, high: the stops, radians.
    """

    name: str
    counts: tuple[float, float, float, float, float]
    low: float
    high: float

    def sum(self, angles: Sequence[float]) -> float:
        """It, of some angles, radians."""
        return sum(count * angle for count, angle in zip(self.counts, angles, strict=True))


def _stops(model: ArmModel) -> tuple[_Stops, ...]:
    limits = model.limits
    return (
        _Stops("base", (1, 0, 0, 0, 0), -limits.base, limits.base),
        _Stops("shoulder", (0, 1, 0, 0, 0), *limits.shoulder),
        _Stops("elbow", (0, -1, 1, 0, 0), *limits.elbow),
        _Stops("pitch of the hand", (0, 0, -1, 0.5, 0.5), -limits.pitch, limits.pitch),
        _Stops("left wrist gear", (0, 0, 0, 1, 0), -limits.gear, limits.gear),
        _Stops("right wrist gear", (0, 0, 0, 0, 1), -limits.gear, limits.gear),
    )


class Reach:
    """What is known of the joints on one way through a program.

    Args:
        model: of the arm.
        start: where it is switched on; None where that is not known.
    """

    def __init__(self, model: ArmModel, start: Pose | None = None) -> None:
        self._model = model
        self._stops = _stops(model)
        self._ranges = [(each.low, each.high) for each in self._stops]
        self._angles: tuple[float, ...] | None = None
        if start is not None:
            at = inverse(model, start.x, start.y, start.z, start.pitch, start.roll)
            self._angles = at.driven
            self._ranges = [(each.sum(at.driven),) * 2 for each in self._stops]

    def copy(self) -> Reach:
        """The same, to go on another way."""
        other = Reach.__new__(Reach)
        other._model, other._stops = self._model, self._stops
        other._ranges, other._angles = list(self._ranges), self._angles
        return other

    def forget(self, motors: Sequence[int] = range(_ARM)) -> None:
        """Some motors, all unless said, may have turned whatever way."""
        turned = [self._model.drives[motor].turns for motor in motors if motor < _ARM]
        if not turned:
            return
        self._angles = None
        for place, each in enumerate(self._stops):
            if any(each.counts[motor] for motor in turned):
                self._ranges[place] = each.low, each.high

    def move(self, steps: Sequence[int | None]) -> str:
        """Go on by a motion.

        Args:
            steps: of the six motors; None where that is not known.

        Returns:
            What it meets, whatever the arm's place before was; empty if there may be nothing.
        """
        self.forget([motor for motor, count in enumerate(steps) if count is None])
        counts = [count or 0 for count in steps]
        turned = self._model.turned(counts)
        met = ""
        for place, each in enumerate(self._stops):
            by = each.sum(turned)
            if not by:
                continue
            low, high = (edge + by for edge in self._ranges[place])
            if high < each.low - _HAIR:
                met = met or _beyond(each, high, each.low, high - low)
            elif low > each.high + _HAIR:
                met = met or _beyond(each, low, each.high, high - low)
            else:
                self._ranges[place] = max(low, each.low - _HAIR), min(high, each.high + _HAIR)
        if self._angles is not None:
            self._angles = tuple(at + by for at, by in zip(self._angles, turned, strict=True))
            if not met and any(turned):
                met = self._below_table()
        if met:
            self.forget()
        return met

    def _below_table(self) -> str:
        assert self._angles is not None
        height = forward(self._model, JointAngles.of_gears(*self._angles)).fingertip[2]
        if height >= -_TABLE:
            return ""
        return f"the fingertips would be {-height:.1f} in below the table"


def _beyond(stops: _Stops, at: float, stop: float, spread: float) -> str:
    beyond = " or beyond" if spread > _HAIR else ""
    return (
        f"the {stops.name} would be at {math.degrees(at):.0f} degrees{beyond}, "
        f"its stop is at {math.degrees(stop):.0f}"
    )
