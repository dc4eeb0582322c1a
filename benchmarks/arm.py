"""How fast the arm is against the arm of 1980: `python -P benchmarks/arm.py`.

Prints, for some ways of driving it, nanoseconds per latch write, virtual seconds per second, and
how many rounds of an empty Python loop fit into the time of a write, which says more than either
where the computer is slow or busy; then the same of rigid parts in contact, for a tick of 4.6 ms.
Each figure is the median of several rounds, with the best behind it; times are those of the
processor.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np

from trs80arm import Rig
from trs80arm.arm import Bench, MiniMover, benchfile
from trs80arm.arm.contact.bodies import Body, Shape
from trs80arm.arm.contact.clock import T_STATES_PER_SECOND, TICK, TICK_STATES
from trs80arm.arm.contact.rotations import oriented
from trs80arm.arm.contact.scene import Scene
from trs80arm.arm.contact.solids import box
from trs80arm.arm.motors import PHASES
from trs80arm.arm.stepping import PulseGenerator, delay_period
from trs80arm.machine.card import Observer
from trs80arm.operator import Operator, parse_holds

sys.path.insert(0, str(Path(__file__).parents[1]))
from tests.arm.contact.hand import SlidingHand
from tests.arm.writes import CELL, Recorder, Writes
from tests.rig.test_teach import teach

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


def loop() -> float:
    """Seconds that a round of a plain Python loop takes now."""
    begin = time.process_time()
    for _ in range(1_000_000):
        pass
    return (time.process_time() - begin) / 1_000_000


def measure(name: str, bench: str, writes: Writes, piece: int, lead: int = 0) -> None:
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
    report(name, times, len(timed), (timed[-1][0] - timed[0][0]) / T_STATES_PER_SECOND)


def report(name: str, times: list[float], writes: int, virtual: float) -> None:
    """One line of the result."""
    middle, best = sorted(times)[len(times) // 2], min(times)
    print(
        f"{name:44} {writes:6} writes {middle / writes * 1e9:8.0f} ns/write"
        f" {middle / writes / loop():7.1f} loops {virtual / middle:9.0f} x real time"
        f"  (best {virtual / best:.0f})"
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


def picked_and_placed(name: str, run: Callable[[], tuple[int, float]]) -> None:
    """Time cycles of Table 4 on a fresh arm each round."""
    times = []
    for _ in range(ROUNDS):
        begin = time.process_time()
        taken, virtual = run()
        times.append(time.process_time() - begin)
    report(name, times, taken * 4600, virtual)


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
        rig.run_for(5)
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

    def wrote(self, times: Sequence[int], latches: Sequence[int], nibbles: Sequence[int]) -> None:
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


def free_steps() -> None:
    """Time free `@STEP`s: seen by nobody, seen write by write, and with the arm looked at each."""
    counter = Counter(each_step=False)
    stepped(600, counter)
    writes = counter.writes
    times = [stepped(600) for _ in range(ROUNDS)]
    report("free @STEPs, BASIC to arm", times, writes, 600)
    print(f"{'':44} {writes / min(times) / 1e6:.1f} million latch writes a second at best")
    times = [stepped(600, Counter(each_step=False)) for _ in range(ROUNDS)]
    report("the same, each write seen", times, writes, 600)
    times = [stepped(60, Counter(each_step=True)) for _ in range(ROUNDS)]
    report("the same, the arm looked at after each", times, writes // 10, 60)


def lengths() -> None:
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
        report(f"motions of {longest} half-steps, five motors", times, writes, virtual)
        print(f"{'':44} {min(times) / motions / 2 * 1e6:.0f} microseconds each at best")


CUBE = Shape.of([box((1.0, 1.0, 1.0))], 2.0)
START = (4.0, 0.0, 0.3, 0.0, 0.0, 0.1)


def row(count: int) -> Scene:
    """Cubes in a row, touching, and a hand beside the first."""
    scene = Scene(arm=SlidingHand())
    scene.put_arm(START)
    for k in range(count):
        scene.add(Body(str(k), CUBE, 0.5, (5.0 + k, 0.0, 0.5)))
    scene.advance(200 * TICK_STATES)
    return scene


def crowd(count: int) -> Scene:
    """Cubes side by side in rows of three, a little aslant, and a hand before them."""
    scene = Scene(arm=SlidingHand())
    scene.put_arm(START)
    for k in range(count):
        place = (5.2 + 1.05 * (k // 3), 1.1 * (k % 3 - 1), 0.5)
        scene.add(Body(str(k), CUBE, 0.5, place, oriented((k * 37) % 11 - 5.0)))
    scene.advance(200 * TICK_STATES)
    return scene


def fall(count: int, apart: float) -> Scene:
    """Cubes turned every way, about to fall on the table, so many inches apart."""
    scene = Scene()
    for k in range(count):
        place = (apart * (k // 3), apart * (k % 3 - 1), 1.5 + 0.4 * k)
        scene.add(Body(str(k), CUBE, 0.5, place, oriented(37.0 * k, 23.0 * k + 10.0, 71.0 * k)))
    return scene


def field(count: int) -> Scene:
    """Cubes at rest, far apart, and a hand over them."""
    scene = Scene(arm=SlidingHand())
    scene.put_arm((4.0, 0.0, 6.0, 0.0, 0.0, 0.1))
    for k in range(count):
        body = Body(str(k), CUBE, 0.5, (2.0 * (k % 40), 2.0 * (k // 40), 0.5))
        scene.add(body)
        body.asleep = True
    return scene


def push(scene: Scene, ticks: int) -> None:
    """Push on at 2.6 inches a second, in half-steps of a motor as far out as that."""
    start = scene.time
    for k in range(ticks * TICK_STATES // D50):
        scene.advance(start + k * D50)
        scene.command((START[0] + 0.0071 * k, *START[1:]))
    scene.advance(start + ticks * TICK_STATES)


def settle(scene: Scene, ticks: int) -> None:
    """Let what falls come to rest."""
    scene.advance(scene.time + ticks * TICK_STATES)


def work_aside(scene: Scene, ticks: int) -> None:
    """Open and close the hand above what rests."""
    start = scene.time
    for k in range(1, ticks + 1):
        scene.command((4.0, 0.0, 6.0, 0.0, 0.0, 0.1 + 0.005 * (k % 100)))
        scene.advance(start + k * TICK_STATES)


def contact(
    name: str, make: Callable[[], Scene], act: Callable[[Scene, int], None], ticks: int
) -> None:
    """Time contact for some ticks in a fresh scene each round."""
    times = []
    for _ in range(ROUNDS):
        scene = make()
        begin = time.process_time()
        act(scene, ticks)
        times.append(time.process_time() - begin)
    middle, best = sorted(times)[ROUNDS // 2], min(times)
    print(
        f"{name:44} {ticks:6} ticks  {middle / ticks * 1e6:8.0f} us/tick "
        f" {middle / ticks / loop():7.0f} loops {ticks * TICK / middle:9.1f} x real time"
        f"  (best {ticks * TICK / best:.1f})"
    )


def main() -> None:
    """Print the table."""
    up = burst((0, -207, 290))
    free = up + burst(*[(300, -8, -13, -100, -100), (-300, 8, 13, 100, 100)] * 5, after=up)
    long = up + burst(*[(1400, -8, -13, -100, -100), (-1400, 8, 13, 100, 100)] * 3, after=up)
    measure("free motion, one burst", "", free, len(free), len(up))
    measure("long free motion, one burst", "", long, len(long), len(up))
    measure("free motion, bursts of 20 writes", "", free, 20, len(up))
    measure("free motion, single writes", "", free, 1)
    base = [(D50 * i, 0, PHASES[i % 8]) for i in range(1000)]
    measure("single writes to one motor", "", base, 1)
    crowded = CELL + "".join(f"[[part]]\nat = [11, {k}]\nsize = [0.5, 0.5, 3]\n" for k in range(8))
    measure("single writes, ten parts on the bench", crowded, free, 1)
    picked_and_placed("Table 4, the first cycle", cycle(1))
    picked_and_placed("Table 4, 5 cycles of pick and place", cycle(5))
    picked_and_placed("Table 4, 100 cycles", cycle(100))
    picked_and_placed("Table 4, 30 cycles, no two alike", cycle(30, aside=3))
    times = [on_the_rig("table4", 60) for _ in range(5)]
    report("Table 4 with BASIC, driver, card and bench", times, 60 * 650, 60)
    runs = [taught(200) for _ in range(5)]
    seconds = runs[0][1]
    report("Table 3, 200 cycles as taught", [run[0] for run in runs], 200 * 4600, seconds)
    free_steps()
    lengths()
    for count in (1, 3, 10):
        contact(f"{count} in a row, pushed on and on", lambda count=count: row(count), push, 2400)
    contact("10 in a crowd, pushed apart", lambda: crowd(10), push, 400)
    contact("10 fall, each on the table", lambda: fall(10, 4.0), settle, 200)
    contact("10 fall on each other", lambda: fall(10, 1.0), settle, 200)
    for count in (2, 200, 2000):
        contact(
            f"{count} at rest, the hand above", lambda count=count: field(count), work_aside, 400
        )


if __name__ == "__main__":
    main()
