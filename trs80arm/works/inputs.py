"""What an operator does at a rig, as recorded and done again."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, Protocol

from trs80arm.arm.bench import BenchError
from trs80arm.arm.by_hand import InTheWay, MotorsOn
from trs80arm.machine.clock import T_STATES_PER_SECOND


class ReplayError(Exception):
    """What was recorded cannot be done on this machine; one line that says when and why."""


@dataclass(frozen=True)
class Input:
    """One thing that the operator did: enough to do it again at the same virtual time."""

    time: int
    """T-states since power-on."""
    action: str
    """The name of the method of `Rig`."""
    arguments: tuple[Any, ...]


class Operated(Protocol):
    """A rig: what lets its time pass, beside the methods that inputs name."""

    def run_to(self, target: int) -> bool:
        """Run until the clock shows at least `target` T-states."""


def replay(rig: Operated, inputs: Iterable[Input]) -> None:
    """Do again what was recorded, each thing at its own virtual time.

    Raises:
        ReplayError: something recorded cannot be done; what comes before it is.
    """
    for done in inputs:
        rig.run_to(done.time)
        try:
            getattr(rig, done.action)(*done.arguments)
        except (MotorsOn, InTheWay, BenchError, ValueError) as error:
            when = done.time / T_STATES_PER_SECOND
            raise ReplayError(f"{done.action} at {when:.3f} s: {error}") from None
