"""Stand-ins around the driver: an analyser, a keyboard of bare switches, a hand that closes."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field

from trs80arm.machine.card import Card, Observer, Peripheral
from trs80arm.machine.clock import Clock
from trs80arm.machine.driver import Driver, DriverSettings
from trs80arm.machine.keyboard import Matrix
from trs80arm.machine.keys import Key
from trs80arm.progress import Progress
from trs80arm.pulses import Burst, Series

Write = tuple[int, int, int]


@dataclass
class Analyser:
    """Everything written to the latches, as (time, latch, nibble)."""

    each_step: bool = False
    writes: list[Write] = field(default_factory=list)
    bursts: list[int] = field(default_factory=list)

    def wrote(self, times: Series, latches: Series, nibbles: Series) -> None:
        rows = zip(times, latches, nibbles, strict=True)
        self.writes += [(int(time), int(latch), int(nibble)) for time, latch, nibble in rows]
        self.bursts.append(len(times))


@dataclass
class ClosingHand:
    """A hand whose switch closes after so many writes to latch 5."""

    steps: int

    def follow(self, burst: Burst, stop: tuple[int, int] | None = None) -> int:
        writes = burst.columns()
        times, latches = writes.times, writes.latches
        for done, latch in enumerate(latches, start=1):
            self.steps -= latch == 5
            time = int(times[done - 1])
            ends = done == len(times) or times[done] != time
            if stop and ends and self.inputs(time) & stop[0] == stop[1]:
                return done
        return len(times)

    def inputs(self, time: int) -> int:
        return 0b1110 if self.steps <= 0 else 0b1111


class Machine:
    """A driver on a card, with somebody at the keys."""

    def __init__(
        self, plug: Peripheral | None = None, settings: DriverSettings | None = None
    ) -> None:
        self.clock = Clock()
        self.matrix = Matrix()
        self.card = Card(self.clock, plug=plug)
        self.driver = Driver(self.clock, self.card, self.matrix, settings)
        self.analyser = Analyser()
        self.watch_latches(self.analyser)

    def watch_latches(self, observer: Observer) -> Callable[[], None]:
        self.card.observers.append(observer)
        return lambda: self.card.observers.remove(observer)

    def run(self, until: int | None = None) -> Progress:
        """Let the driver work to a T-state, or to the end of its motion."""
        progress = Progress.BUSY
        while progress is Progress.BUSY and (until is None or self.clock.now < until):
            self.clock.limit = self.clock.now + 10_000_000 if until is None else until
            progress = self.driver.advance()
        return progress

    def press(self, keys: Iterable[Key | str]) -> None:
        for key in keys:
            self.matrix.press(Key(key))

    def release(self, keys: Iterable[Key | str]) -> None:
        for key in keys:
            self.matrix.release(Key(key))

    def step(self, delay: int, *steps: int) -> list[Write]:
        """Do one `@STEP` to its end; the writes that it made."""
        before = len(self.analyser.writes)
        self.driver.step(delay, [*steps, *[0] * (6 - len(steps))])
        self.run()
        return self.analyser.writes[before:]


def ticks(writes: Iterable[Write], latch: int, start: int, period: int) -> list[int]:
    """The ticks, counted in whole periods, at which a latch was written."""
    return [(time - start + period // 2) // period for time, which, _ in writes if which == latch]
