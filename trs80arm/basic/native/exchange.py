"""A compiled loop: variables, arrays and open loops go in, what has become of them comes out."""

from __future__ import annotations

import ctypes
from array import array
from struct import Struct
from typing import Final

import wasmtime

from trs80arm.basic.control import ForFrame, Frame, GosubFrame
from trs80arm.basic.kinds import Kind
from trs80arm.basic.native import module
from trs80arm.basic.native.lowering import Lowering
from trs80arm.basic.native.module import FRAME_BYTES, FRAMES, identity_of
from trs80arm.basic.variables import Variables

_HEAD: Final = Struct("<q2i")
_FRAME: Final = Struct("<3i4x2d")
_KEPT: Final = -1
"""The line of a frame that was open before."""


class NativeLoop:
    """One loop, compiled.

    Args:
        ways: its statements by their addresses.
        types: the table of the types of names that it was made with.
        engine: what compiles it.
        variables: the program's.

    Attributes:
        ways: the same.
        elements: of arrays that go in or out each time it is run.
        reach: the last address of the program that it depends on.
        costliest: T-states that one of its statements takes at most.
        balance: T-states won so far beyond what runs have cost, within bounds.
    """

    def __init__(
        self,
        ways: dict[int, Lowering],
        types: bytes,
        engine: wasmtime.Engine,
        variables: Variables,
    ) -> None:
        self.ways = ways
        self.balance = 0
        self.reach = max(way.reach for way in ways.values())
        self.costliest = max(way.cost for way in ways.values())
        self._types = types
        self._variables = variables
        stored = {name for way in ways.values() for name in way.stored}
        scalars = sorted({name for way in ways.values() for name in way.scalars})
        text = module.text(ways, {name: name in stored for name in scalars})
        store = self._store = wasmtime.Store(engine)
        exports = wasmtime.Instance(store, wasmtime.Module(engine, text), []).exports(store)
        run, memory = exports["run"], exports["memory"]
        assert isinstance(run, wasmtime.Func)
        assert isinstance(memory, wasmtime.Memory)
        self._run = run
        start = ctypes.addressof(memory.data_ptr(store).contents)
        bytes_ = memoryview((ctypes.c_ubyte * module.MEMORY).from_address(start)).cast("B")
        self._memory, self._floats = bytes_, bytes_.cast("d")
        self._loops = {identity_of(scalar): scalar for scalar in variables.scalars.values()}
        self._scalars = [
            (variables.scalar(module.key_of(name)), place, name in stored)
            for place, name in enumerate(scalars, module.SCALARS // 8)
        ]
        self._arrays = [
            (module.key_of(name), base // 8, name in stored)
            for name, base in {each for way in ways.values() for each in way.arrays.items()}
        ]
        self.elements = sum(
            (1 + stored) * len(variables.arrays[key].data) for key, _, stored in self._arrays
        )

    def holds(self, address: int, types: bytes) -> bool:
        """Whether a statement is in it, and everything as it was when it was made."""
        there = address in self.ways and types == self._types
        return there and all(way.assumptions.hold(self._variables) for way in self.ways.values())

    def run(self, address: int, budget: int, frames: list[Frame]) -> tuple[int, int]:
        """Go round from a statement on: where the program goes on, and T-states taken.

        Args:
            address: of the statement.
            budget: T-states after which none is begun.
            frames: what is open, changed; there must be room for `room.FEW` in all.
        """
        memory, floats = self._memory, self._floats
        stack = FRAMES + FRAME_BYTES * len(frames)
        _HEAD.pack_into(memory, 0, budget, address, stack)
        for place, frame in zip(range(FRAMES, stack, FRAME_BYTES), frames, strict=True):
            bounds = (frame.limit, frame.step) if isinstance(frame, ForFrame) else (0.0, 0.0)
            target = frame.body if isinstance(frame, ForFrame) else frame.back
            _FRAME.pack_into(memory, place, identity_of(frame.scalar), target, _KEPT, *bounds)
        for scalar, place, _ in self._scalars:
            floats[place] = scalar.value
        arrays = [self._variables.arrays[key] for key, _, _ in self._arrays]
        for owner, (_, place, _) in zip(arrays, self._arrays, strict=True):
            floats[place : place + len(owner.data)] = memoryview(array("d", owner.data))
        self._run(self._store)
        for scalar, place, stored in self._scalars:
            if stored:
                scalar.cell.cell_contents = _as_held(scalar.kind, floats[place])
        for owner, (_, place, stored) in zip(arrays, self._arrays, strict=True):
            if stored:
                values = floats[place : place + len(owner.data)].tolist()
                owner.data[:] = map(int, values) if owner.kind == Kind.INTEGER else values
        time, address, stack = _HEAD.unpack_from(self._memory)
        places = range(FRAMES, stack, FRAME_BYTES)
        del frames[len(places) :]
        for number, place in enumerate(places):
            variable, target, line, *rest = _FRAME.unpack_from(memory, place)
            if line != _KEPT and variable:
                scalar = self._loops[variable]
                limit, step = (_as_held(scalar.kind, bound) for bound in rest)
                frames[number:] = [ForFrame(scalar, limit, step, target, line)]
            elif line != _KEPT:
                frames[number:] = [GosubFrame(target, line)]
        return address, time


def _as_held(kind: Kind, value: float) -> float:
    return int(value) if kind == Kind.INTEGER else value
