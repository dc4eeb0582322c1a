"""Going on as before: what is not solved again goes where it would have gone."""

from __future__ import annotations

import pickle
from collections.abc import Callable

import pytest

from tests.arm.contact.hand import SlidingHand
from trs80arm.arm.contact import prospect
from trs80arm.arm.contact.bodies import Body, Fixed, Shape
from trs80arm.arm.contact.clock import TICK_STATES
from trs80arm.arm.contact.manifold import between
from trs80arm.arm.contact.scene import Scene
from trs80arm.arm.contact.solids import box

CUBE = Shape.of([box((1.0, 1.0, 1.0))], 2.0)
STEP = 0.0066
"""Inches that the hand goes in a tick: 1.4 inches a second."""


def row(count: int) -> Scene:
    """Cubes in a row and a hand beside the first."""
    scene = Scene(arm=SlidingHand())
    scene.put_arm((4.2, 0.0, 0.3, 0.0, 0.0, 0.1))
    for k in range(count):
        scene.add(Body(str(k), CUBE, 0.5, (5.0 + k, 0.0, 0.5)))
    scene.advance(40 * TICK_STATES)
    return scene


def push(scene: Scene, way: Callable[[int], float], start: int, end: int, pieces: int = 1) -> None:
    """Have the hand go along x, commanded in every tick; time passes in pieces besides."""
    for k in range(start, end):
        for piece in range(1, pieces + 1):
            scene.advance((40 + k) * TICK_STATES + TICK_STATES * piece // pieces)
        scene.command((4.2 + way(k), 0.0, 0.3, 0.0, 0.0, 0.1))


def state(scene: Scene) -> object:
    bodies = [(b.place, b.turn, b.velocity, b.spin, b.asleep) for b in scene.bodies.values()]
    return bodies, scene.joints, scene.torques, scene.time


def straight(k: int) -> float:
    return STEP * k


def test_a_row_that_is_pushed_on_and_on_is_seldom_solved_and_goes_as_far(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    found = []
    for most in (prospect.MOST_STEPS, 0):
        monkeypatch.setattr(prospect, "MOST_STEPS", most)
        scene = row(3)
        before = scene.solved
        push(scene, straight, 0, 400)
        places = [body.place for body in scene.bodies.values()]
        found.append((places, scene.torques, scene.solved - before))
    coasting, solving = found
    for one, other in zip(coasting[0], solving[0], strict=True):
        assert one == pytest.approx(other, abs=0.005)
    assert coasting[1] == pytest.approx(solving[1], abs=0.2)
    assert coasting[2] < solving[2] / 3


@pytest.mark.parametrize(("period", "step"), [(7200, 0.0107), (12000, 0.0107), (4000, 0.0107)])
def test_a_motor_goes_in_half_steps_and_what_it_pushes_evenly(period: int, step: float) -> None:
    scene = row(3)
    solved, start = scene.solved, scene.time
    for k in range(300 * TICK_STATES // period):
        scene.advance(start + k * period)
        scene.command((4.2 + k * step, 0.0, 0.3, 0.0, 0.0, 0.1))
    ahead = [body.place[0] - scene.joints[0] for body in scene.bodies.values()]
    assert ahead == pytest.approx([0.8, 1.8, 2.8], abs=0.005)
    # Three parts of two ounces at a friction of a half.
    assert scene.torques[0] == pytest.approx(-3, rel=0.25)
    assert scene.solved - solved < 60


def test_what_is_pushed_stops_with_the_hand_and_lags_when_it_turns_back() -> None:
    scene = row(2)
    push(scene, lambda k: STEP * min(k, 203), 0, 400)
    assert scene.quiet
    ahead = [body.place[0] - scene.joints[0] for body in scene.bodies.values()]
    assert ahead == pytest.approx([0.8, 1.8], abs=0.005)
    scene = row(2)
    push(scene, lambda k: STEP * min(k, 406 - k), 0, 400)
    assert scene.quiet
    assert scene.joints[0] == pytest.approx(4.2, abs=0.06)
    assert [b.place[0] for b in scene.bodies.values()] == pytest.approx([6.34, 7.34], abs=0.02)


def test_what_lies_in_the_way_is_met_where_it_lies() -> None:
    scene = row(1)
    scene.fixed["wall"] = Fixed("wall", (box((0.5, 4.0, 2.0)).moved((7.25, 0.0, 1.0)),), 0.5)
    light = scene.add(Body("light", CUBE, 0.5, (5.0, 1.2, 0.5)))
    push(scene, straight, 0, 260)
    cube = scene.bodies["0"]
    assert cube.place[0] == pytest.approx(6.5, abs=0.005)
    assert scene.torques[0] < -100
    assert light.place == pytest.approx((5.0, 1.2, 0.5), abs=0.001)


LANE = (1.06, -1.04)
"""Where the middles of cubes stand to the left and right of a cube that goes by."""


def test_what_stands_beside_the_way_is_passed_by_asleep_and_seldom_looked_at() -> None:
    scene = row(3)
    for k in range(8):
        scene.add(Body(f"beside {k}", CUBE, 0.5, (6.5 + 1.05 * (k // 2), LANE[k % 2], 0.5)))
    scene.advance(100 * TICK_STATES)
    beside = [body for body in scene.bodies.values() if body.name.startswith("beside")]
    places, before = [body.place for body in beside], scene.solved
    awake = []
    for k in range(60, 460, 5):
        push(scene, lambda k: straight(k - 60), k, k + 5)
        awake += [body.name for body in beside if not body.asleep]
    assert scene.bodies["2"].place[0] > 9.0
    assert not awake
    assert [body.place for body in beside] == places
    assert scene.solved - before < 25


@pytest.mark.parametrize("ahead", [-0.3, 0.1, 0.5, 0.9, 1.3])
def test_a_nose_is_met_though_the_cheek_is_passed_by(ahead: float) -> None:
    cheek, nose = box((3.0, 1.0, 1.0)), box((0.4, 0.4, 1.0)).moved((ahead, -0.65, 0.0))
    scene = row(1)
    face = scene.add(Body("face", Shape.of([cheek, nose], 2.0), 0.5, (7.5, 1.03, 0.5)))
    scene.advance(100 * TICK_STATES)
    there, cube, deepest = face.place, scene.bodies["0"], 0.0
    for k in range(60, 700, 4):
        push(scene, lambda k: straight(k - 60), k, k + 4)
        for solid in face.placed:
            found = between(cube.placed[0], solid, 0.0)
            if found is not None:
                deepest = min(deepest, *(gap for _, gap in found.points))
        if cube.placed[0].high[0] < face.placed[1].low[0] - 0.03:
            assert face.place == there
    assert face.place != there
    assert deepest > -0.01


def test_time_in_pieces_and_a_copy_in_the_middle_change_nothing() -> None:
    whole = row(2)
    push(whole, straight, 0, 300)
    sliced = row(2)
    push(sliced, straight, 0, 300, pieces=3)
    assert state(sliced) == state(whole)
    for at in (150, 163, 182):
        first = row(2)
        push(first, straight, 0, at)
        assert first._coast is not None
        copy = pickle.loads(pickle.dumps(first))
        assert state(copy) == state(first)
        push(copy, straight, at, 300)
        assert state(copy) == state(whole)
