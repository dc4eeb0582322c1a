"""A Z-80 with nothing on its bus but the driver, the card and a keyboard: no ROM, no BASIC."""

from __future__ import annotations

from bisect import insort
from collections.abc import Callable, Iterable

import pytest

from tests.machine.armbasic_z80.assembled import driver
from tests.machine.bench_top import Analyser, Write
from trs80arm.machine.card import Card, Peripheral
from trs80arm.machine.clock import Clock
from trs80arm.machine.keyboard import Matrix
from trs80arm.machine.keys import Key

z80 = pytest.importorskip("z80", reason="the extra z80 is not installed")

FRAME = 100_000
"""T-states after which the package begins to count anew."""
HALT = 0x4300
"""Where a routine returns to."""
STACK = 0x42FE
CARRY = 1


class Board:
    """The driver in memory, its own program and data beside it.

    Attributes:
        analyser: what was written to the latches.
        looked: when the keyboard was looked at first; None before.
        stopped: the address that a call ended at.
    """

    def __init__(self, plug: Peripheral | None = None) -> None:
        self.clock = Clock()
        self.matrix = Matrix()
        self.card = Card(self.clock, plug=plug)
        self.analyser = Analyser()
        self.card.observers.append(self.analyser)
        self.looked: int | None = None
        self.stopped = 0
        self._keys: list[tuple[int, int, bool, str]] = []
        self._frames = self._last = 0
        self.answers: dict[int, Callable[[], None]] = {}
        self.chip = chip = z80.Z80Machine()
        chip.mark_addrs(0x3800, 0x400, chip.READ_MARK)
        chip.set_read_callback(self._look)
        chip.set_input_callback(lambda port: self.card.read(port & 0xFF))
        chip.set_output_callback(self._out)
        chip.set_breakpoint(HALT)
        self.load(driver().origin, driver().image)

    # -- memory -------------------------------------------------------------------------------

    def load(self, address: int, content: bytes) -> None:
        self.chip.memory[address : address + len(content)] = content

    def byte(self, name: str) -> int:
        return int(self.chip.memory[driver().symbols[name]])

    def put_byte(self, name: str, value: int, place: int = 0) -> None:
        self.chip.memory[driver().symbols[name] + place] = value & 0xFF

    def words(self, address: int, count: int) -> list[int]:
        content = bytes(self.chip.memory[address : address + 2 * count])
        pairs = (content[at : at + 2] for at in range(0, 2 * count, 2))
        return [int.from_bytes(pair, "little", signed=True) for pair in pairs]

    def put_words(self, address: int, words: Iterable[int]) -> None:
        content = b"".join((word & 0xFFFF).to_bytes(2, "little") for word in words)
        self.load(address, content)

    # -- running ------------------------------------------------------------------------------

    def at_ticks(self, pressed: Iterable[tuple[int, bool, str]], period: float) -> None:
        """Press and release keys half a tick before a tick, as (tick, down, key)."""
        for order, (tick, down, key) in enumerate(pressed):
            insort(self._keys, (int((tick - 0.5) * period), order, down, key))

    def call(self, name: str, limit: int = 200_000_000, **registers: int) -> bool:
        """Call a routine of the driver; whether it came back, and not another stop or the limit."""
        return self.call_at(driver().symbols[name], limit, **registers)

    def call_at(self, address: int, limit: int = 200_000_000, **registers: int) -> bool:
        chip = self.chip
        for register, value in registers.items():
            setattr(chip, register, value & (0xFF if len(register) == 1 else 0xFFFF))
        chip.sp = STACK
        self.put_words(STACK, [HALT])
        chip.pc = address
        ends = self._now() + limit
        while self._now() < ends:
            chip.ticks_to_stop = 50_000
            chip.run()
            self._now()
            if chip.pc == HALT:
                return True
            if chip.pc in self.answers:
                self.answers[chip.pc]()
        return False

    def answer(self, address: int, routine: Callable[[], None]) -> None:
        """Have Python do what the ROM would do at an address; it returns to the caller itself."""
        self.answers[address] = routine
        self.chip.set_breakpoint(address)

    def go_back(self) -> None:
        """RET."""
        chip = self.chip
        (chip.pc,) = (word & 0xFFFF for word in self.words(chip.sp, 1))
        chip.sp += 2

    @property
    def carry(self) -> bool:
        return bool(self.chip.f & CARRY)

    def move(self, delay: int, *counts: int) -> list[Write]:
        """Call MOVE; the writes that it made."""
        before = len(self.analyser.writes)
        self.put_words(0x5000, [delay, *counts, *[0] * (6 - len(counts))])
        assert self.call("MOVE", hl=0x5000)
        return self.analyser.writes[before:]

    @property
    def registers(self) -> tuple[int, ...]:
        """What READ tells."""
        assert self.call("READ", hl=0x5100)
        return tuple(self.words(0x5100, 6))

    def _now(self) -> int:
        passed = self.chip.frame_tick
        if passed < self._last:
            self._frames += FRAME
        self._last = passed
        self.clock.now = self._frames + passed
        return self.clock.now

    def _look(self, address: int) -> int:
        now = self._now()
        if self.looked is None:
            self.looked = now
        while self._keys and self._keys[0][0] <= now - self.looked:
            _, _, down, key = self._keys.pop(0)
            (self.matrix.press if down else self.matrix.release)(Key(key))
        return self.matrix.peek(address)

    def _out(self, port: int, value: int) -> None:
        self._now()
        self.card.write(port & 0xFF, value)


def patterns(writes: Iterable[Write]) -> list[tuple[int, int]]:
    """Writes without their times."""
    return [(latch, nibble) for _, latch, nibble in writes]


def lateness(mine: list[Write], reference: list[Write], start: int) -> list[float]:
    """How much later than in a reference that begins at T-state `start` each write comes.

    The driver writes the latches of a tick one behind the other; the middle of that is its tick.
    """
    first, latch, _ = mine[0]
    tick = first - BETWEEN * latch + BETWEEN * 5 / 2
    begin = reference[0][0] - start
    return [
        (time - tick) - (other - start - begin)
        for (time, _, _), (other, _, _) in zip(mine, reference, strict=True)
    ]


BETWEEN = 15
"""T-states from one latch of a tick to the next."""
