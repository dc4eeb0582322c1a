"""How fast parts in contact are followed, in ticks of 4.6 ms.

The median of several rounds: microseconds of the processor, rounds of an empty Python loop, virtual
seconds per second.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from functools import partial
from statistics import median

from benchmarks.rows import Row, empty_loop
from tests.arm.contact.hand import SlidingHand
from trs80arm.arm.contact.bodies import Body, Shape
from trs80arm.arm.contact.clock import TICK, TICK_STATES
from trs80arm.arm.contact.rotations import oriented
from trs80arm.arm.contact.scene import Scene
from trs80arm.arm.contact.solids import box
from trs80arm.arm.stepping import delay_period

ROUNDS = 5
D50 = delay_period(50)
CUBE = Shape.of([box((1.0, 1.0, 1.0))], 2.0)
START = (4.0, 0.0, 0.3, 0.0, 0.0, 0.1)


def in_a_row(count: int) -> Scene:
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


def timed(
    name: str, make: Callable[[], Scene], act: Callable[[Scene, int], None], ticks: int
) -> Row:
    """What some ticks take, in a fresh scene each round."""
    times = []
    for _ in range(ROUNDS):
        scene = make()
        begin = time.process_time()
        act(scene, ticks)
        times.append(time.process_time() - begin)
    middle = median(times)
    return Row(
        name,
        {
            "us a tick": 1e6 * middle / ticks,
            "loops a tick": middle / ticks / empty_loop(),
            "x real time": ticks * TICK / middle,
            "best": ticks * TICK / min(times),
        },
    )


def rows(seconds: float) -> Iterator[Row]:
    """Each scene; `seconds` would change what is done, so that it says nothing here."""
    del seconds
    for count in (1, 3, 10):
        yield timed(f"{count} in a row, pushed on and on", partial(in_a_row, count), push, 2400)
    yield timed("10 in a crowd, pushed apart", partial(crowd, 10), push, 400)
    yield timed("10 fall, each on the table", partial(fall, 10, 4.0), settle, 200)
    yield timed("10 fall on each other", partial(fall, 10, 1.0), settle, 200)
    for count in (2, 200, 2000):
        yield timed(f"{count} at rest, the hand above", partial(field, count), work_aside, 400)
