"""A TRS-80 for the language's tests: its display is a list, nothing else is in it."""

from __future__ import annotations

import re
from collections.abc import Sequence

from trs80arm.basic import cruncher
from trs80arm.basic.host import Host, Progress
from trs80arm.basic.interpreter import Interpreter
from trs80arm.machine.clock import Clock
from trs80arm.machine.memory import Memory


class Screen:
    """A console without keys that only keeps what was printed."""

    def __init__(self, clock: Clock) -> None:
        self._clock = clock
        self.printed = bytearray()
        self.cursor = 0
        self.keys: list[int] = []

    def put(self, code: int) -> None:
        self._clock.now += 883
        self.printed.append(code)
        self.cursor = 0 if code in (13, 0x1C) else (self.cursor + 1) % 1024

    echo = put

    def scan(self) -> int:
        return self.keys.pop(0) if self.keys else 0

    @property
    def quiet(self) -> bool:
        return not self.keys

    @property
    def column(self) -> int:
        return self.cursor % 64

    def show_cursor(self, on: bool) -> None:
        """No cursor."""

    def point(self, x: int, y: int) -> bool:
        return (x + y) % 2 == 0

    def plot(self, x: int, y: int, lit: bool) -> None:
        """No picture."""


class Paper:
    def __init__(self) -> None:
        self.printed = bytearray()

    def put(self, code: int) -> None:
        self.printed.append(code)


class NoPorts:
    def __init__(self) -> None:
        self.written: list[tuple[int, int]] = []

    def read(self, port: int) -> int:
        return 255

    def write(self, port: int, value: int) -> None:
        self.written.append((port, value))


class NoTape:
    def start_writing(self) -> None: ...
    def write(self, value: int) -> None: ...
    def start_reading(self) -> None: ...
    def find_sync(self) -> bool:
        return False

    def read(self) -> int | None:
        return None

    def stop(self) -> None: ...


class Arm:
    """An arm that is where it is sent at once."""

    def __init__(self) -> None:
        self.registers = [0] * 6
        self.calls: list[tuple[object, ...]] = []

    def step(self, delay: int, steps: Sequence[int]) -> None:
        self.calls.append(("step", delay, tuple(steps)))
        self.registers = [a + b for a, b in zip(self.registers, steps, strict=True)]

    def close(self, delay: int | None) -> None:
        self.calls.append(("close", delay))

    def set(self, delay: int | None) -> None:
        self.calls.append(("set", delay))

    def reset(self) -> None:
        self.calls.append(("reset",))
        self.registers = [0] * 6

    def read(self) -> tuple[int, int, int, int, int, int]:
        a, b, c, d, e, f = self.registers
        return a, b, c, d, e, f

    def advance(self) -> Progress:
        return Progress.DONE


class Machine:
    """Types lines and tells what came of them.

    Args:
        armbasic: whether the `@` statements are there.
        blocks: whether runs of statements are compiled into one function.
        native: whether hot loops may be native code.
    """

    def __init__(
        self, *, armbasic: bool = True, blocks: bool = True, ram: int = 16, native: bool = True
    ) -> None:
        self.clock = Clock()
        self.memory = Memory(ram)
        self.screen = Screen(self.clock)
        self.paper = Paper()
        self.ports = NoPorts()
        self.arm = Arm()
        host = Host(
            clock=self.clock,
            memory=self.memory,
            console=self.screen,
            printer=self.paper,
            ports=self.ports,
            tape=NoTape(),
            arm=self.arm,
        )
        self.basic = Interpreter(host, armbasic=armbasic, blocks=blocks, native=native)
        self.basic.state.stack.pop()
        self.basic.state.cold_start(self.memory.top - 1)

    def load(self, *lines: str) -> None:
        """Put program lines into memory."""
        for line in lines:
            number, text = cruncher.split_line(line.encode("latin-1"))
            assert number is not None
            self.basic.store_line(number, text)

    def do(self, line: str, seconds: float = 1000.0) -> str:
        """Execute a direct line; what it printed, READY not included."""
        start = len(self.screen.printed)
        self.clock.limit = self.clock.now + round(seconds * 1_774_080)
        self.basic.execute_direct(cruncher.crunch(line.encode("latin-1")).text)
        while self.basic.running and self.clock.now < self.clock.limit:
            self.basic.advance(until_waiting=True)
            if self.basic.waiting.value != "nothing":
                break
        text = self.screen.printed[start:].decode("latin-1").replace("\r", "\n")
        return re.sub(r"READY\n(>|\d+ )?$", "", text)

    def run(self, *lines: str) -> str:
        """Load a program and RUN it; what it printed."""
        self.basic.program.clear()
        self.load(*lines)
        return self.do("RUN")
