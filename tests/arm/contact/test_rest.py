"""Rest and time: what stands costs nothing, falls take their time, slicing changes nothing."""

from __future__ import annotations

import math
import pickle

import pytest

from tests.arm.contact.hand import PER_INCH, SlidingHand
from trs80arm.arm.contact.bodies import Body, Fixed, Shape
from trs80arm.arm.contact.clock import T_STATES_PER_SECOND, TICK, TICK_STATES
from trs80arm.arm.contact.driven import GRAVITY
from trs80arm.arm.contact.rotations import oriented
from trs80arm.arm.contact.scene import Scene
from trs80arm.arm.contact.solids import box

DAY = 24 * 3600 * T_STATES_PER_SECOND


def block(name: str, z: float, size: tuple[float, float, float] = (1.0, 1.0, 1.0)) -> Body:
    return Body(name, Shape.of([box(size)], 2.0), 0.5, (8.0, 0.0, z))


def state(scene: Scene) -> object:
    bodies = [
        (b.name, b.place, b.turn, b.velocity, b.spin, b.asleep) for b in scene.bodies.values()
    ]
    return bodies, scene.joints, scene.torques, scene.time


def test_a_stack_of_ten_stands_for_a_day_without_moving_and_without_work() -> None:
    scene = Scene()
    for k in range(10):
        scene.add(block(str(k), 0.5 + k))
    scene.advance(T_STATES_PER_SECOND)
    before, solved = state(scene)[0], scene.solved  # type: ignore[index]
    assert scene.quiet
    scene.advance(DAY)
    assert state(scene)[0] == before  # type: ignore[index]
    assert scene.solved == solved
    assert scene.time == DAY // TICK_STATES * TICK_STATES


@pytest.mark.parametrize("ratio", [1, 30, 600])
def test_however_heavy_what_lies_on_something_light_both_come_to_rest(ratio: int) -> None:
    # A contact gives so much under a weight in however long steps it is looked at.
    scene = Scene()
    light = Body("light", Shape.of([box((1.5, 0.4, 0.3))], 0.1), 0.5, (8.0, 0.0, 0.15))
    heavy = Body("heavy", Shape.of([box((2.5, 2.0, 0.2))], 0.1 * ratio), 0.5, (8.0, 0.1, 0.41))
    scene.add(light)
    scene.add(heavy)
    scene.advance(T_STATES_PER_SECOND)
    assert scene.quiet
    assert heavy.place[2] == pytest.approx(0.4, abs=0.01)
    assert heavy.turn[0] == pytest.approx(1, abs=1e-3)


def test_a_fall_of_three_inches_takes_an_eighth_of_a_second() -> None:
    scene = Scene()
    cube = scene.add(block("cube", 3.5))
    ticks = 0
    while cube.place[2] > 0.51:
        scene.tick()
        ticks += 1
    assert ticks * TICK == pytest.approx(math.sqrt(2 * 3 / GRAVITY), abs=1.1 * TICK)


def test_what_sleeps_wakes_when_something_falls_on_it() -> None:
    scene = Scene()
    cube = scene.add(block("cube", 0.5))
    scene.advance(T_STATES_PER_SECOND)
    assert cube.asleep
    scene.add(Body("ball", Shape.of([box((0.5, 0.5, 0.5))], 9.0), 0.5, (8.45, 0.0, 2.0)))
    woken = False
    for _ in range(60):
        scene.tick()
        woken = woken or not cube.asleep
    assert woken


def test_what_stood_on_something_falls_when_that_is_taken_away() -> None:
    scene = Scene()
    for k in range(3):
        scene.add(block(str(k), 0.5 + k))
    scene.advance(T_STATES_PER_SECOND)
    scene.remove("0")
    scene.advance(2 * T_STATES_PER_SECOND)
    assert [b.place[2] for b in scene.bodies.values()] == pytest.approx([0.5, 1.5], abs=0.01)


def test_a_belt_takes_along_what_stands_on_it_until_it_stops() -> None:
    scene = Scene()
    belt = Fixed("belt", (box((9.0, 4.0, 0.1)).moved((8.0, 0.0, 0.05)),), 0.5)
    scene.fixed["belt"] = belt
    cube = scene.add(Body("cube", Shape.of([box((1.0, 1.0, 1.0))], 2.0), 0.5, (6.0, 0.0, 0.6)))
    scene.advance(T_STATES_PER_SECOND)
    scene.carry("belt", (1.0, 0.5, 0.0))
    scene.advance(3 * T_STATES_PER_SECOND)
    scene.carry("belt", (0.0, 0.0, 0.0))
    scene.advance(5 * T_STATES_PER_SECOND)
    assert cube.place == pytest.approx((8.0, 1.0, 0.6), abs=0.02)
    assert scene.quiet


def squeezing() -> Scene:
    """A hand that closes on a part, a stack that is about to fall, a part in the air."""
    scene = Scene(arm=SlidingHand())
    scene.put_arm((8.0, 0.0, 0.5, 0.0, 0.0, 1.0))
    scene.add(Body("held", Shape.of([box((0.5, 0.5, 1.0))], 2.0), 0.5, (8.0, 0.1, 0.5)))
    for k in range(3):
        scene.add(
            Body(
                f"stack {k}",
                Shape.of([box((1.0, 1.0, 1.0))], 2.0),
                0.5,
                (4 + 0.4 * k, 3.0, 0.5 + k),
            )
        )
    turn = oriented(10, 30, 20)
    scene.add(Body("air", Shape.of([box((1.0, 0.5, 0.5))], 2.0), 0.5, (4.0, -3.0, 4.0), turn))
    return scene


def opening(time: int) -> float:
    """Where the hand is commanded to at a T-state: it closes in half-steps."""
    return max(0.45, 1.0 - time // 4800 / 618)


def drive(scene: Scene, until: int, pieces: int) -> Scene:
    """Command the hand at each of its half-steps, and let time pass in pieces besides."""
    start = scene.time
    marks = {4800 * k for k in range(until // 4800 + 1)}
    marks |= {start + (until - start) * k // pieces for k in range(1, pieces + 1)}
    for time in sorted(mark for mark in marks if mark > start):
        scene.advance(time)
        scene.command((8.0, 0.0, 0.5, 0.0, 0.0, opening(time)))
    return scene


def test_whole_and_sliced_are_the_same_to_the_last_bit() -> None:
    until = T_STATES_PER_SECOND
    whole = state(drive(squeezing(), until, 1))
    for pieces in (7, 100, 1234):
        assert state(drive(squeezing(), until, pieces)) == whole


def test_a_scene_goes_on_after_pickling_in_mid_fall_as_if_nothing_had_happened() -> None:
    scene = drive(squeezing(), 40 * TICK_STATES, 1)
    assert not scene.quiet
    copy = pickle.loads(pickle.dumps(scene))
    assert state(copy) == state(scene)
    for each in (scene, copy):
        drive(each, T_STATES_PER_SECOND, 1)
    assert state(copy) == state(scene)


def test_force_grows_by_a_pound_in_52_half_steps() -> None:
    scene = Scene(arm=SlidingHand())
    scene.put_arm((8.0, 0.0, 0.5, 0.0, 0.0, 0.6))
    scene.add(Body("part", Shape.of([box((0.5, 0.5, 1.0))], 2.0), 0.5, (8.0, 0.0, 0.5)))
    forces = []
    for number, squeeze in enumerate((26, 52, 156), 1):
        scene.command((8.0, 0.0, 0.5, 0.0, 0.0, 0.5 - squeeze / 618))
        scene.advance(number * T_STATES_PER_SECOND // 2)
        forces.append(scene.torques[5])
    assert forces == pytest.approx([8, 16, 48], rel=0.02)
    assert pytest.approx(16 / 52 * 618) == PER_INCH


def test_pressing_on_the_table_raises_force_gradually() -> None:
    scene = Scene(arm=SlidingHand())
    scene.put_arm((8.0, 0.0, 0.5, 0.0, 0.0, 0.6))
    found = []
    for number, depth in enumerate((0.0, 0.01, 0.02, 0.03), 1):
        scene.command((8.0, 0.0, -depth, 0.0, 0.0, 0.6))
        scene.advance(number * T_STATES_PER_SECOND // 10)
        found.append(scene.torques[2])
    assert found == pytest.approx([0, 20, 40, 60], rel=0.01, abs=0.2)


def test_a_hand_that_presses_stays_where_it_is() -> None:
    scene = Scene(arm=SlidingHand())
    scene.put_arm((8.0, 0.0, 0.5, 0.0, 0.0, 0.6))
    scene.command((8.0, 0.0, -0.02, 0.0, 0.0, 0.6))
    scene.advance(T_STATES_PER_SECOND // 10)
    height, force = scene.joints[2], scene.torques[2]
    for _ in range(20):
        scene.tick()
    assert height == pytest.approx(0, abs=2e-3)
    assert scene.joints[2] == pytest.approx(height, abs=1e-3)
    assert scene.torques[2] == pytest.approx(force, rel=0.05)


def test_pushing_costs_friction() -> None:
    scene = Scene(arm=SlidingHand())
    scene.put_arm((6.5, 0.0, 0.3, 0.0, 0.0, 0.1))
    scene.add(Body("anvil", Shape.of([box((2.0, 2.0, 1.0))], 80.0), 0.5, (8.0, 0.0, 0.5)))
    for k in range(1, 201):
        scene.command((6.5 + k * 0.005, 0.0, 0.3, 0.0, 0.0, 0.1))
        scene.advance(k * TICK_STATES)
    assert scene.torques[0] == pytest.approx(-40, rel=0.15)


def test_what_is_carried_goes_with_the_hand_without_work() -> None:
    scene = Scene(arm=SlidingHand())
    scene.put_arm((8.0, 0.0, 0.5, 0.0, 0.0, 0.6))
    part = scene.add(Body("part", Shape.of([box((0.5, 0.5, 1.0))], 2.0), 0.5, (8.0, 0.0, 0.5)))

    at, clock = [8.0, 0.0, 0.5, 0.0, 0.0, 0.6], [0]

    def go(x: float, z: float, turn: float, opening: float, ticks: int) -> None:
        before, after = list(at), [x, 0.0, z, turn, 0.0, opening]
        at[:] = after
        for k in range(1, ticks + 1):
            scene.command([a + (b - a) * k / ticks for a, b in zip(before, after, strict=True)])
            clock.append(clock[-1] + TICK_STATES)
            scene.advance(clock[-1])

    go(8, 0.5, 0, 0.4515, 100)
    go(8, 2, 0, 0.4515, 200)
    assert scene.carried == [part]
    solved = scene.solved
    go(5, 3, 1.0, 0.4515, 300)
    assert scene.solved == solved
    assert part.place == pytest.approx((5, 0, 3), abs=0.01)


def test_a_strained_arm_that_loses_touch_eases_off_and_does_not_jump() -> None:
    scene = Scene(arm=SlidingHand())
    scene.put_arm((6.5, 0.0, 0.3, 0.0, 0.0, 0.1))
    scene.add(Body("anvil", Shape.of([box((2.0, 2.0, 1.0))], 500.0), 0.9, (7.8, 0.0, 0.5)))
    scene.command((6.58, 0.0, 0.3, 0.0, 0.0, 0.1))
    scene.advance(T_STATES_PER_SECOND // 4)
    strain = scene.torques[0]
    assert strain < -100
    scene.remove("anvil")
    seen = []
    for _ in range(60):
        before = scene.joints[0]
        scene.tick()
        seen.append((scene.joints[0] - before, scene.torques[0]))
    assert max(way for way, _ in seen) < 0.02
    assert seen[0][1] < strain / 2
    assert seen[-1] == (0.0, 0.0)
    assert scene.joints[0] == 6.58


def test_what_is_woken_by_what_comes_upon_it_moves_at_once() -> None:
    scene = Scene()
    rolling = scene.add(block("first", 0.5))
    scene.add(block("second", 0.5)).put((9.005, 0.0, 0.5), rolling.turn)
    scene.advance(T_STATES_PER_SECOND)
    assert scene.quiet
    scene.wake("first")
    rolling.velocity = (5.0, 0.0, 0.0)
    scene.tick()
    assert scene.bodies["second"].place[0] > 9.005
    assert scene.bodies["second"].place[0] - rolling.place[0] > 0.999
