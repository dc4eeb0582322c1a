"""When a loop is made native, and when it is run: it changes nothing but speed.

Now and then, in virtual time, the engine comes by and says where the program is. Where it has been
often enough the loop around that place is compiled, and from then on run each time the program is
found in it. A loop that is left too soon to be worth going in and out is left alone.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from typing import TYPE_CHECKING

from trs80arm.basic.room import FEW
from trs80arm.basic.state import State

if TYPE_CHECKING:
    import wasmtime

    from trs80arm.basic.native.exchange import NativeLoop
    from trs80arm.basic.native.loops import Writer

LONG, SHORT = 32_000_000, 500_000
"""T-states after which a program is looked at, a millisecond or so; while it has just been in a
native loop."""
WARM, HOT = 4_000_000_000, 150_000_000
"""T-states before a program is looked at first, in which the library could be loaded; and at one
place before the loop around it is compiled, four times as many before that is tried again."""
WAY, ELEMENT, BALANCE, STRETCH = 1_500_000, 800, 300_000_000, 10**12
"""What going in and out costs, and an element of an array, as T-states of blocks that take as long;
T-states won or lost that are remembered of a loop; and of a run, some second."""


class Hot:
    """The native loops of one machine.

    Args:
        write: writes statements as Python.
        types: gives the table of the types of names, by which what is compiled is kept.
        state: the machine's.

    Attributes:
        taken: T-states that were spent in native loops.
    """

    def __init__(self, write: Writer, types: Callable[[], bytes], state: State) -> None:
        self.taken = 0
        self._write = write
        self._types = types
        self._state = state
        self._engine: wasmtime.Engine | None = None
        self._off = False
        self._portion = LONG
        self._next = state.clock.now + WARM
        self._heat: Counter[int] = Counter()
        self._tries: Counter[int] = Counter()
        self._kept: list[NativeLoop] = []
        self._active: dict[int, NativeLoop | None] = {}

    def begin(self, end: int) -> int:
        """Until when blocks, which must end at a T-state, may be run first."""
        now = self._state.clock.now
        return end if self._off or end - now < 4 * WAY else min(end, max(now, self._next))

    def reach(self, address: int, end: int) -> tuple[int, int]:
        """The program has come to a statement: where it goes on, and until when by blocks."""
        clock = self._state.clock
        loop = self._loop(address) if clock.now < end else None
        self._portion = SHORT if loop else min(2 * self._portion, LONG)
        if loop is not None:
            address = self._run(loop, address, end)
        self._next = clock.now + max(self._portion, 1)
        return address, end if self._off else min(end, self._next)

    def _run(self, loop: NativeLoop, address: int, end: int) -> int:
        state = self._state
        clock, frames = state.clock, state.control.frames
        budget = min(end - clock.now, STRETCH) - loop.costliest
        cost = WAY + ELEMENT * loop.elements
        if budget <= 4 * cost or len(frames) > FEW or not state.room.plenty:
            return address
        address, time = loop.run(address, budget, frames)
        clock.now += time
        self.taken += time
        loop.balance = min(loop.balance + time - cost, BALANCE)
        if loop.balance < -BALANCE:
            self._kept.remove(loop)
            self._active |= dict.fromkeys(loop.ways)
        return address

    def _loop(self, address: int) -> NativeLoop | None:
        """The native loop around an address, if there is one or it is time for one."""
        if address not in self._active:
            types = self._types()
            found = next((each for each in self._kept if each.holds(address, types)), None)
            if found is None:
                heat = self._heat[address] = self._heat[address] + self._portion
                if heat < HOT << 2 * self._tries[address]:
                    return None
                self._heat[address] = 0
                self._tries[address] += 1
                found = self._made(address, types)
            self._active[address] = found
        return self._active[address]

    def _made(self, address: int, types: bytes) -> NativeLoop | None:
        try:
            import wasmtime
        except ImportError:
            self._off = True  # Without the extra there are no native loops.
            return None
        from trs80arm.basic.native.exchange import NativeLoop
        from trs80arm.basic.native.loops import loop_around

        state, self._engine = self._state, self._engine or wasmtime.Engine()
        ways = {}
        if address >= state.program.start - 1:
            ways = loop_around(address, self._write, state.control.frames, state.variables)
        try:
            if ways:
                self._kept.append(NativeLoop(ways, types, self._engine, state.variables))
        except wasmtime.WasmtimeError:
            return None  # It is too large, or there is no memory for it.
        return self._kept[-1] if ways else None

    def look_around(self) -> None:
        """The types of names, or which variables there are, may be others."""
        self._active.clear()

    def forget_from(self, address: int) -> None:
        """From an address on the text is another one."""
        self._kept = [loop for loop in self._kept if loop.reach < address]
        self._active.clear()
        self._tries.clear()
