"""How fast the arm is against the arm of 1980: `python -P benchmarks/arm.py`.

Prints, for some ways of driving it, microseconds per latch write and virtual seconds per second.
Each figure is the best of several rounds, with the spread behind it.
"""

from __future__ import annotations

import time
from collections.abc import Callable

from trs80arm.arm import Bench, MiniMover
from trs80arm.arm.motors import PHASES, T_STATES_PER_SECOND
from trs80arm.arm.stepping import PulseGenerator, delay_period

ROUNDS = 7
D50 = delay_period(50)

CELL = """
[[feeder]]
at = [8, 0]
size = [0.5, 0.5, 1.0]
[[tray]]
at = [6, 5]
size = [2, 2]
"""


class Recorder(PulseGenerator):
    """A pulse generator that keeps its writes instead of sending them."""

    def __init__(self) -> None:
        super().__init__(MiniMover(bench=Bench("empty")))
        self.writes: list[tuple[int, int, int]] = []
        self.arm.apply = self._keep  # type: ignore[method-assign, assignment]

    def _keep(self, times: list[int], latches: list[int], nibbles: list[int], stop: object) -> int:
        self.writes += zip(times, latches, nibbles, strict=True)
        return len(times)


def burst(*moves: tuple[int, ...]) -> list[tuple[int, int, int]]:
    """Latch writes of some @STEPs at D = 50."""
    recorder = Recorder()
    for counts in moves:
        recorder.step(counts, D50)
    return recorder.writes


def measure(name: str, bench: str, writes: list[tuple[int, int, int]], piece: int) -> None:
    """Time a sequence of writes, cut into pieces, on a fresh arm each round."""
    pieces = [tuple(zip(*writes[i : i + piece], strict=True)) for i in range(0, len(writes), piece)]
    times = []
    for _ in range(ROUNDS):
        arm = MiniMover(bench=Bench.from_toml(bench))
        begin = time.perf_counter()
        for times_, latches, nibbles in pieces:
            arm.apply(times_, latches, nibbles)
        times.append(time.perf_counter() - begin)
    report(name, times, len(writes), (writes[-1][0] - writes[0][0]) / T_STATES_PER_SECOND)


def report(name: str, times: list[float], writes: int, virtual: float) -> None:
    """One line of the result."""
    best = min(times)
    spread = (sorted(times)[len(times) // 2] - best) / best
    print(
        f"{name:44} {writes:6} writes {best * 1e3:9.2f} ms {best / writes * 1e6:7.2f} us/write"
        f" {virtual / best:9.0f} x real time  (+{spread:.0%})"
    )


def cycle(counts: int) -> Callable[[], tuple[int, float]]:
    """Table 4's cycle, several times."""

    def run() -> tuple[int, float]:
        generator = PulseGenerator(MiniMover(bench=Bench.from_toml(CELL)))
        generator.step((0, 0, 0, 0, 0, 370), D50)
        generator.step((0, -207, 290), D50)
        for _ in range(counts):
            generator.step((0, 132, -36), D50)
            generator.close(D50, 30)
            generator.step((0, -132, 36), delay_period(100))
            generator.step((651, -8, -13, -461, -462), D50)
            generator.step((0, 135, -37), D50)
            generator.step((0, 0, 0, 0, 0, 300), D50)
            generator.step((0, -135, 37), D50)
            generator.step((-651, 8, 13, 461, 462), D50)
        return generator.arm.bench.trays[0].taken, generator.time / T_STATES_PER_SECOND

    return run


def main() -> None:
    """Print the table."""
    swing = burst((0, -207, 290), (651, -8, -13, -461, -462, 300))
    free = burst((0, -207, 290), *[(300, -8, -13, -100, -100), (-300, 8, 13, 100, 100)] * 5)
    measure("651 ticks, six axes, one burst", "", swing, len(swing))
    measure("free motion, one burst", "", free, len(free))
    measure("free motion, bursts of 20 writes", "", free, 20)
    measure("free motion, single writes", "", free, 1)
    base = [(D50 * i, 0, PHASES[i % 8]) for i in range(1000)]
    measure("single writes to one motor", "", base, 1)
    crowded = CELL + "".join(f"[[part]]\nat = [11, {k}]\nsize = [0.5, 0.5, 3]\n" for k in range(8))
    measure("single writes, ten parts on the bench", crowded, free, 1)
    times = []
    for _ in range(3):
        begin = time.perf_counter()
        taken, virtual = cycle(5)()
        times.append(time.perf_counter() - begin)
    report(f"Table 4, {taken} cycles of pick and place", times, taken * 4600, virtual)


if __name__ == "__main__":
    main()
