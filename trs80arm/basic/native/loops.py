"""Which statements belong to a loop: those from which control comes to a place again."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Final

from trs80arm.basic.compiler.emitter import MARGIN, Emitter, TooDeep
from trs80arm.basic.compiler.scope import Assumptions
from trs80arm.basic.control import ForFrame, Frame
from trs80arm.basic.native.lowering import Lowering, Unlowerable
from trs80arm.basic.variables import Key, Variables

_MOST: Final = 200
"""Statements that are looked at for one loop."""
Writer = Callable[[int, list[Key]], tuple[Emitter, Assumptions]]
"""Writes the statement behind a separator as Python (`CompiledCode.alone`)."""
_Targets = set[tuple[Key | None, int]]
"""Where loops of a variable go round to, and what RETURN (None) goes back to."""


def loop_around(
    start: int, write: Writer, frames: Sequence[Frame], variables: Variables
) -> dict[int, Lowering]:
    """The statements of the loop around one, in order; none if control does not come there again.

    Args:
        start: the statement's separator.
        write: who writes statements.
        frames: what is open now.
        variables: the program's.
    """
    ways: dict[int, Lowering] = {}
    targets: _Targets = {
        ((frame.scalar.name, frame.scalar.kind), frame.body)
        if isinstance(frame, ForFrame)
        else (None, frame.back)
        for frame in frames[1:]
    }
    names = [(f.scalar.name, f.scalar.kind) for f in frames if isinstance(f, ForFrame)]
    todo, seen = [(start, names)], set[int]()
    while todo and len(seen) < _MOST:
        address, names = todo.pop(0)
        if address in seen:
            continue
        seen.add(address)
        names = list(names)
        try:
            out, assumptions = write(address, names)
            way = Lowering(out, assumptions, variables)
            way.lower(address, out.source())
        except (Unlowerable, TooDeep, SyntaxError, RecursionError, MemoryError):
            continue
        if way.cost < MARGIN:
            ways[address] = way
            targets |= way.opens
            after = _after(way, targets).union(target for _, target in way.opens)
            todo += [(each, names) for each in sorted(after)]
    inside = _inside(start, {address: _after(way, targets) for address, way in ways.items()})
    return {address: ways[address] for address in sorted(inside)} if start in inside else {}


def _after(way: Lowering, targets: _Targets) -> set[int]:
    """Where control may come from a statement."""
    found = {target for key, target in targets if key in way.goes_to}
    return found.union(each for each in way.goes_to if isinstance(each, int))


def _inside(start: int, after: dict[int, set[int]]) -> set[int]:
    """The statements from which control comes to `start`."""
    inside, new = set[int](), {start}
    while new:
        new = {address for address, ways in after.items() if ways & new} - inside
        inside |= new
    return inside
