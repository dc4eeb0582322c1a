"""Machines whose loops are native from the start or never, and what they are left with."""

from __future__ import annotations

import copy
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from tests.basic.machine import Machine
from trs80arm.basic.activity import Waiting
from trs80arm.basic.code import CompiledCode
from trs80arm.basic.control import ForFrame, Frame
from trs80arm.basic.native import hot

MOST = 60_000_000
"""T-states that a program is given: some never end."""
WHOLE = [MOST]


@contextmanager
def at_once() -> Iterator[None]:
    """Loops are compiled where the program first comes by, and run however short they are."""
    names = ("LONG", "SHORT", "WARM", "HOT", "WAY", "ELEMENT")
    before = {name: getattr(hot, name) for name in names}
    for name in names:
        setattr(hot, name, 0)
    try:
        yield
    finally:
        for name, value in before.items():
            setattr(hot, name, value)


def taken(machine: Machine) -> int:
    """T-states that a machine has spent in native loops."""
    engine = machine.basic.state.engine
    assert isinstance(engine, CompiledCode)
    return 0 if engine.hot is None else engine.hot.taken


def _frame(frame: Frame) -> tuple[Any, ...]:
    if isinstance(frame, ForFrame):
        name = frame.scalar.name, frame.scalar.kind
        return name, repr(frame.limit), repr(frame.step), frame.body, frame.line, frame.top
    return frame.back, frame.line


def left(machine: Machine) -> dict[str, Any]:
    """All that a program leaves behind, values with their Python types."""
    state = machine.basic.state
    return {
        "screen": bytes(machine.screen.printed),
        "time": machine.clock.now,
        "error": (state.control.error, state.control.error_line, state.control.error_address),
        "scalars": {(s.name, s.kind): repr(s.value) for s in state.variables.order},
        "arrays": {key: repr(array.data) for key, array in state.variables.arrays.items()},
        "frames": [_frame(frame) for frame in state.control.frames],
        "goes on": (state.control.resume_address, machine.basic.next_address),
    }


def finish(
    lines: Sequence[str],
    *,
    native: bool,
    slices: Sequence[int] = WHOLE,
    moves: int = 0,
    blocks: bool = True,
) -> Machine:
    """A machine that has run a program.

    Args:
        lines: of the program.
        native: whether its loops are native, from the start.
        slices: T-states that it is given at a time, over and over.
        moves: after each so many slices it goes on as a copy of itself.
        blocks: whether what is not native is blocks.
    """
    with at_once():
        machine = Machine(native=native, blocks=blocks)
        machine.load(*lines)
        machine.do("RUN", seconds=0)
        end = machine.clock.now + MOST
        for number, length in enumerate(slices * 400, 1):
            if machine.basic.waiting is Waiting.COMMAND or machine.clock.now >= end:
                break
            machine.clock.limit = min(machine.clock.now + length, end)
            machine.basic.advance(until_waiting=True)
            if moves and not number % moves:
                machine = copy.deepcopy(machine)
    return machine
