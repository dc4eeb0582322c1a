"""How fast the arm is against the arm of 1980.

For some ways of driving it: nanoseconds per latch write, how many rounds of an empty Python loop
fit into the time of a write, which says more than that where the computer is slow or busy, and
virtual seconds per second, the median of several rounds and the best.
"""

from __future__ import annotations

import gc
import time
from collections.abc import Callable, Iterator, Sized
from pathlib import Path
from statistics import median

import numpy as np

from benchmarks.rows import Row, empty_loop
from tests.arm.writes import CELL, Recorder, Writes
from tests.rig.test_teach import teach
from trs80arm import Rig
from trs80arm.arm import Bench, MiniMover, benchfile
from trs80arm.arm.contact.clock import T_STATES_PER_SECOND
from trs80arm.arm.motors import PHASES
from trs80arm.arm.stepping import PulseGenerator, delay_period
from trs80arm.machine.card import Observer
from trs80arm.operator import Operator, parse_holds

PROGRAMS = Path(__file__).parents[1] / "programs"
ROUNDS = 5
D50 = delay_period(50)


def burst(*moves: tuple[int, ...], after: Writes | None = None) -> Writes:
    """Latch writes of some @STEPs at D = 50, following others."""
    recorder = Recorder()
    generator = PulseGenerator(recorder)  # type: ignore[arg-type]
    if after:
        generator.time = after[-1][0]
        for _, latch, nibble in after:
            generator._rows[latch] = PHASES.index(nibble)
    for counts in moves:
        generator.step(counts, D50)
    return recorder.writes


def measure(name: str, bench: str, writes: Writes, piece: int, lead: int = 0) -> Row:
    """Time a sequence of writes, cut into pieces, on a fresh arm each round.

    Args:
        name: what the line is called.
        bench: TOML.
        writes: all of them.
        piece: writes in a burst.
        lead: writes done before the clock starts.
    """
    timed = writes[lead:]
    pieces = [
        tuple(np.array(column) for column in zip(*timed[i : i + piece], strict=True))
        if piece > 1
        else tuple([value] for value in timed[i])
        for i in range(0, len(timed), piece)
    ]
    times = []
    for _ in range(ROUNDS):
        arm = MiniMover(bench=benchfile.parse(bench))
        if lead:
            arm.apply(*zip(*writes[:lead], strict=True))
        begin = time.process_time()
        for times_, latches, nibbles in pieces:
            arm.apply(times_, latches, nibbles)
        times.append(time.process_time() - begin)
    return report(name, times, len(timed), (timed[-1][0] - timed[0][0]) / T_STATES_PER_SECOND)


def report(name: str, times: list[float], writes: int, virtual: float) -> Row:
    """What some rounds took."""
    middle = median(times)
    return Row(
        name,
        {
            "ns a write": 1e9 * middle / writes,
            "loops a write": middle / writes / empty_loop(),
            "x real time": virtual / middle,
            "best": virtual / min(times),
        },
    )


def cycle(counts: int, aside: int = 0) -> Callable[[], tuple[int, float]]:
    """Table 4's cycle, several times.

    Args:
        counts: how often.
        aside: half-steps of the base by which each cycle sets its part down beside the last one's:
            what recurs in one cycle after the other is not computed again.
    """

    def run() -> tuple[int, float]:
        generator = PulseGenerator(MiniMover(bench=benchfile.parse(CELL)))
        generator.step((0, 0, 0, 0, 0, 370), D50)
        generator.step((0, -207, 290), D50)
        for number in range(counts):
            swing = 651 + aside * number
            generator.step((0, 132, -36), D50)
            generator.close(D50, 30)
            generator.step((0, -132, 36), delay_period(100))
            generator.step((swing, -8, -13, -461, -462), D50)
            generator.step((0, 135, -37), D50)
            generator.step((0, 0, 0, 0, 0, 300), D50)
            generator.step((0, -135, 37), D50)
            generator.step((-swing, 8, 13, 461, 462), D50)
        return generator.arm.bench.trays[0].taken, generator.time / T_STATES_PER_SECOND

    return run


def picked_and_placed(name: str, run: Callable[[], tuple[int, float]]) -> Row:
    """Time cycles of Table 4 on a fresh arm each round."""
    times = []
    for _ in range(ROUNDS):
        begin = time.process_time()
        taken, virtual = run()
        times.append(time.process_time() - begin)
    return report(name, times, taken * 4600, virtual)


def on_the_rig(program: str, seconds: float) -> float:
    """Processor seconds that a program with its bench takes on a whole rig, after its start."""
    rig = Rig(bench=benchfile.load(PROGRAMS / f"{program}.toml"))
    rig.load(PROGRAMS / f"{program}.bas")
    rig.type("RUN\r")
    Operator(rig, sets=[parse_holds("6:1.0 0")]).run(20)
    begin = time.process_time()
    rig.run_for(seconds)
    return time.process_time() - begin


def taught(cycles: int) -> tuple[float, float]:
    """Processor seconds, and virtual ones, of cycles of Table 3 on a whole rig, once taught."""
    rig = Rig(bench=benchfile.load(PROGRAMS / "table3.toml"))
    teach(rig, "table3.bas", "")
    rig.type("G\r")
    tray, start = rig.arm.bench.trays[0], rig.time
    begin = time.process_time()
    while tray.taken < cycles:
        rig.run_for(60)
    return time.process_time() - begin, rig.time - start


FREE = """10 @STEP 50,0,-207,290
20 @STEP 50,1400,-8,-13,-400,-400,300
30 @STEP 50,-1400,8,13,400,400,-300
40 GOTO 20
"""


class Counter:
    """An analyser on the latches that counts their writes.

    Args:
        each_step: whether the arm has to be seen after every instant.
    """

    def __init__(self, *, each_step: bool) -> None:
        self.each_step = each_step
        self.writes = 0

    def wrote(self, times: Sized, latches: Sized, nibbles: Sized) -> None:
        """These writes have been done."""
        self.writes += len(times)


def stepped(seconds: float, observer: Observer | None = None) -> float:
    """Processor seconds of free `@STEP`s from BASIC to the arm.

    Args:
        seconds: virtual ones.
        observer: who sees the latches.
    """
    rig = Rig(bench=Bench("empty"))
    rig.type(FREE.replace("\n", "\r") + "RUN\r")
    rig.run_for(30)
    if observer is not None:
        rig.watch_latches(observer)
    begin = time.process_time()
    rig.run_for(seconds)
    return time.process_time() - begin


def free_steps() -> Iterator[Row]:
    """Time free `@STEP`s: seen by nobody, seen write by write, and with the arm looked at each."""
    counter = Counter(each_step=False)
    stepped(600, counter)
    writes = counter.writes
    times = [stepped(600) for _ in range(ROUNDS)]
    yield report("free @STEPs, BASIC to arm", times, writes, 600)
    times = [stepped(600, Counter(each_step=False)) for _ in range(ROUNDS)]
    yield report("the same, each write seen", times, writes, 600)
    times = [stepped(60, Counter(each_step=True)) for _ in range(ROUNDS)]
    yield report("the same, the arm looked at after each", times, writes // 10, 60)


def lengths() -> Iterator[Row]:
    """Time motions of five motors there and back, by how many half-steps the longest makes."""
    for longest in (30, 100, 300, 1000):
        counts = (longest, -longest // 30, longest // 30, -longest // 4, longest // 4)
        motions, times = 3000 // longest + 20, []
        for _ in range(ROUNDS):
            generator = PulseGenerator(MiniMover(bench=Bench("empty")))
            generator.step((0, -207, 290), D50)
            begin, start = time.process_time(), generator.time
            for _ in range(motions):
                generator.step(counts, D50)
                generator.step([-count for count in counts], D50)
            times.append(time.process_time() - begin)
            virtual = (generator.time - start) / T_STATES_PER_SECOND
        writes = 2 * motions * (sum(map(abs, counts)) + abs(counts[2]))
        measured = report(f"motions of {longest} half-steps, five motors", times, writes, virtual)
        each = {"us a motion, best": 1e6 * min(times) / motions / 2}
        yield Row(measured.name, {**measured.measures, **each})


def rows(seconds: float) -> Iterator[Row]:
    """Each way of driving; `seconds` would change what is done, so that it says nothing here."""
    del seconds
    # As in a run without a screen: what is loaded by now stays, and is not searched for garbage.
    gc.collect()
    gc.freeze()
    up = burst((0, -207, 290))
    free = up + burst(*[(300, -8, -13, -100, -100), (-300, 8, 13, 100, 100)] * 5, after=up)
    long = up + burst(*[(1400, -8, -13, -100, -100), (-1400, 8, 13, 100, 100)] * 3, after=up)
    yield measure("free motion, one burst", "", free, len(free), len(up))
    yield measure("long free motion, one burst", "", long, len(long), len(up))
    yield measure("free motion, bursts of 20 writes", "", free, 20, len(up))
    yield measure("free motion, single writes", "", free, 1)
    base = [(D50 * i, 0, PHASES[i % 8]) for i in range(1000)]
    yield measure("single writes to one motor", "", base, 1)
    crowded = CELL + "".join(f"[[part]]\nat = [11, {k}]\nsize = [0.5, 0.5, 3]\n" for k in range(8))
    yield measure("single writes, ten parts on the bench", crowded, free, 1)
    yield picked_and_placed("Table 4, the first cycle", cycle(1))
    yield picked_and_placed("Table 4, 5 cycles of pick and place", cycle(5))
    yield picked_and_placed("Table 4, 100 cycles", cycle(100))
    yield picked_and_placed("Table 4, 30 cycles, no two alike", cycle(30, aside=3))
    for name, seconds in (("the first minute", 60), ("ten minutes", 600)):
        times = [on_the_rig("table4", seconds) for _ in range(ROUNDS)]
        yield report(f"Table 4 with BASIC, card and bench, {name}", times, seconds * 650, seconds)
    runs = [taught(200) for _ in range(ROUNDS)]
    lasted = runs[0][1]
    yield report("Table 3, 200 cycles as taught", [run[0] for run in runs], 200 * 4600, lasted)
    yield from free_steps()
    yield from lengths()
