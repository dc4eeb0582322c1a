"""How fast contact is against real time: `python -P benchmarks/contact.py`.

Prints, for some scenes, virtual seconds per second of the processor, and milliseconds a tick.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent))

from tests.arm.contact.hand import SlidingHand
from trs80arm.arm.contact.bodies import Body, Shape
from trs80arm.arm.contact.scene import TICK, TICK_STATES, Scene
from trs80arm.arm.contact.solids import box

ROUNDS = 5
CUBE = Shape.of([box((1.0, 1.0, 1.0))], 2.0)


def row(count: int) -> Scene:
    """Cubes in a row, touching, and a hand beside the first."""
    scene = Scene(arm=SlidingHand())
    scene.put_arm((4.0, 0.0, 0.3, 0.0, 0.0, 0.1))
    for k in range(count):
        scene.add(Body(str(k), CUBE, 0.5, (5.0 + k, 0.0, 0.5)))
    scene.advance(200 * TICK_STATES)
    return scene


def push(scene: Scene, ticks: int) -> None:
    """Push them all for a while, at 1.4 inches a second."""
    start = scene.time
    for k in range(1, ticks + 1):
        scene.command((4.0 + 0.0066 * k, 0.0, 0.3, 0.0, 0.0, 0.1))
        scene.advance(start + k * TICK_STATES)


def work_aside(scene: Scene, ticks: int) -> None:
    """Open and close the hand above what rests."""
    scene.put_arm((4.0, 0.0, 6.0, 0.0, 0.0, 0.1))
    start = scene.time
    for k in range(1, ticks + 1):
        scene.command((4.0, 0.0, 6.0, 0.0, 0.0, 0.1 + 0.005 * (k % 100)))
        scene.advance(start + k * TICK_STATES)


def report(name: str, make: Callable[[], Scene], act: Callable[[Scene, int], None]) -> None:
    """One line of the result: the median of some rounds."""
    ticks, times = 300, []
    for _ in range(ROUNDS):
        scene = make()
        begin = time.process_time()
        act(scene, ticks)
        times.append(time.process_time() - begin)
    median = sorted(times)[ROUNDS // 2]
    print(
        f"{name:40} {ticks * TICK / median:8.1f} x real time {median / ticks * 1e3:8.2f} ms a tick"
    )


def main() -> None:
    """Print all of it."""
    for count in (1, 3, 10):
        report(f"{count} in a row, pushed all the time", lambda count=count: row(count), push)
    for count in (2, 200):
        report(f"{count} at rest, the hand above them", lambda count=count: row(count), work_aside)


if __name__ == "__main__":
    main()
