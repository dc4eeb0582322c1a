"""A run as it moves: joints, motors and parts, look by look, while an operator is at the keys."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from trs80arm.arm.contact.bodies import Shape
from trs80arm.arm.contact.rotations import Quaternion
from trs80arm.arm.shapes import Vector
from trs80arm.export.chain import counts, joint_values
from trs80arm.operator import Hold, Operator
from trs80arm.rig import Rig

LINGERS = 1.0
"""Seconds that are recorded after the program has ended, or waits in vain."""
STRIDE = 1 / 60
"""Virtual seconds that pass at most between two looks of the operator."""
_SHORTEST = 1e-6
"""Seconds that are no time: the clock's T-states are rounded to within."""


@dataclass(frozen=True)
class Look:
    """One look at a rig.

    Attributes:
        time: seconds from when RUN is typed.
        joints: of the chain, in the order of `chain.JOINTS`.
        motors: where they stand, half-steps from the chain's zero, by latch.
        registers: what was commanded.
        parts: place and turn of the parts there are, by their number in `Recording.parts`.
    """

    time: float
    joints: tuple[float, ...]
    motors: tuple[float, ...]
    registers: tuple[int, ...]
    parts: dict[int, tuple[Vector, Quaternion]]


@dataclass
class Recording:
    """A run.

    Attributes:
        looks: in order; no two at one time.
        parts: every part that there was: its name and shape.
    """

    looks: list[Look] = field(default_factory=list)
    parts: list[tuple[str, Shape]] = field(default_factory=list)


def record(
    rig: Rig,
    rate: float,
    seconds: float,
    inputs: Iterable[str] = (),
    sets: Iterable[Sequence[Hold]] = (),
) -> Recording:
    """Type RUN and record what arm and parts do, until a moment after the program's end.

    Args:
        rig: with the program in memory.
        rate: looks a virtual second.
        seconds: the most that are recorded.
        inputs: answers to INPUT.
        sets: what the operator does in each `@SET`.
    """
    operator = Operator(rig, inputs, sets)
    made = _Recorder(rig)
    made.look(0.0)
    rig.type("RUN\r")
    start, last = rig.time, seconds
    taken, now = 0, 0.0
    while now < last - _SHORTEST:
        taken += 1
        target = min(taken / rate, last)
        while (now := rig.time - start) < target - _SHORTEST:
            if not operator.attend() and last == seconds:
                last = min(seconds, now + LINGERS)
            rig.run_for(min(STRIDE, target - now))
        made.look(now)
    return made.recording


class _Recorder:
    """Looks at a rig, and knows its parts again."""

    def __init__(self, rig: Rig) -> None:
        self.recording = Recording()
        self._rig = rig
        self._numbers: dict[str, int] = {}
        state = rig.state
        at = counts(rig.arm.model, joint_values(state.angles, state.pose.opening))
        self._zero = [here - rotor for here, rotor in zip(at, state.rotors, strict=True)]

    def look(self, time: float) -> None:
        """Take a look."""
        state, looks = self._rig.state, self.recording.looks
        if looks and time <= looks[-1].time:
            return  # A statement that took longer than a look.
        motors = tuple(zero + rotor for zero, rotor in zip(self._zero, state.rotors, strict=True))
        parts = {
            self._number(part.name, part.shape): (part.place, part.turn)
            for part in self._rig.arm.bench.parts.values()
        }
        values = joint_values(state.angles, state.pose.opening)
        looks.append(Look(time, values, motors, tuple(self._rig.registers), parts))

    def _number(self, name: str, shape: Shape) -> int:
        """Of a part; one that a press has changed is another."""
        known = self.recording.parts
        number = self._numbers.get(name)
        if number is None or known[number][1] is not shape:
            number = self._numbers[name] = len(known)
            known.append((name, shape))
        return number
