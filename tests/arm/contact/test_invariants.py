"""What holds of every scene: nothing in the table or in another, no energy from nothing, rest."""

from __future__ import annotations

import math
import random

from hypothesis import example, given, settings
from hypothesis import strategies as st

from tests.arm.contact.hand import SlidingHand
from trs80arm.arm.contact.bodies import Body, Fixed, Shape
from trs80arm.arm.contact.clock import T_STATES_PER_SECOND, TICK, TICK_STATES
from trs80arm.arm.contact.driven import GRAVITY
from trs80arm.arm.contact.manifold import between
from trs80arm.arm.contact.patch import FASTEST_RECOVERY
from trs80arm.arm.contact.rotations import apply_back, matrix, oriented
from trs80arm.arm.contact.scene import Scene
from trs80arm.arm.contact.solids import Solid, box, cylinder, prism

SKIN = 0.01
"""Depth to which things may be found in each other, inches."""
MOVING_SKIN = 0.05
"""Depth at which what tumbles fast may be found on a tick, inches; it goes 0.3 in one tick."""


def overlap(one: Body | Fixed, other: Body | Fixed) -> float:
    """How deep two things are in each other, inches."""
    deep = 0.0
    for a in one.placed:
        for b in other.placed:
            met = between(a, b, 0.0) if a.near(b, 0.0) else None
            if met is not None:
                deep = max(deep, -min(gap for _, gap in met.points))
    return deep


def assert_possible(scene: Scene, skin: float = SKIN) -> None:
    """Everything is on the table, in nothing else, and somewhere."""
    bodies = list(scene.bodies.values())
    for i, body in enumerate(bodies):
        assert all(math.isfinite(value) and abs(value) < 100 for value in body.place)
        assert min(solid.low[2] for solid in body.placed) > -skin
        for other in [*bodies[:i], *scene.fixed.values()]:
            assert overlap(body, other) < skin, (body.name, other.name)


def energy(scene: Scene) -> float:
    """Of height and of motion, ounce inches."""
    total = 0.0
    for body in scene.bodies.values():
        v, w = body.velocity, apply_back(matrix(body.turn), body.spin)
        i = body.shape.inertia
        turning = sum(w[r] * i[3 * r + c] * w[c] for r in range(3) for c in range(3))
        moving = body.shape.mass * sum(x * x for x in v) + turning
        total += body.shape.mass * body.place[2] + moving / 2 / GRAVITY
    return total


def random_solid(chance: random.Random) -> Solid:
    kind = chance.randrange(4)
    if kind == 0:
        return cylinder(chance.uniform(0.2, 0.8), chance.uniform(0.2, 1.5))
    if kind == 1:
        return prism([(-0.6, -0.4), (0.7, -0.3), (0.1, 0.6)], chance.uniform(0.3, 1.2))
    return box((chance.uniform(0.2, 1.5), chance.uniform(0.2, 1.5), chance.uniform(0.2, 1.5)))


def random_scene(chance: random.Random, count: int, arm: bool = False) -> Scene:
    """Bodies in the air over a table with a shelf, none in another."""
    scene = Scene(chance.choice([0.2, 0.5, 1.0]), SlidingHand() if arm else None)
    shelf = box((2.0, 2.0, 1.0)).moved((7.0, 0.0, 0.5), oriented(chance.uniform(0, 90)))
    scene.fixed["shelf"] = Fixed("shelf", (shelf,), 0.5)
    for k in range(count):
        place = (chance.uniform(6, 9), chance.uniform(-1, 1), 2.4 + 2.7 * k)
        turn = oriented(*(chance.choice([0.0, chance.uniform(-90, 90)]) for _ in range(3)))
        shape = Shape.of([random_solid(chance)], chance.choice([0.5, 2.0, 10.0]))
        scene.add(Body(str(k), shape, chance.choice([0.3, 0.5, 1.0]), place, turn))
    return scene


@settings(max_examples=6, deadline=None)
@given(st.integers(0, 10**9))
@example(730573909)
@example(847283415)
@example(44)
def test_whatever_falls_comes_to_rest_on_something_and_wins_no_energy(seed: int) -> None:
    chance = random.Random(seed)
    scene = random_scene(chance, chance.randrange(1, 6))
    start = before = energy(scene)
    # What has got into another for a moment is lifted out of it, at an inch a second at most, and
    # with it all that lies on it.
    weights = sorted(body.shape.mass for body in scene.bodies.values())
    stacked = sum(number * weight for number, weight in enumerate(weights, 1))
    lift = 1.1 * stacked * FASTEST_RECOVERY / T_STATES_PER_SECOND
    for _ in range(round(6 / TICK)):
        since = scene.time
        scene.tick()
        now = energy(scene)
        assert now <= before + lift * (scene.time - since)
        before = now
        assert_possible(scene, MOVING_SKIN)
        if scene.quiet:
            break
    assert scene.quiet
    assert before < start
    assert_possible(scene)
    placed = [(body.place, body.turn) for body in scene.bodies.values()]
    scene.advance(scene.time + 1000 * TICK_STATES)
    assert [(body.place, body.turn) for body in scene.bodies.values()] == placed


@settings(max_examples=6, deadline=None)
@given(st.integers(0, 10**9))
@example(57)
@example(25)
def test_what_falls_past_a_slanted_bar_is_never_in_it(seed: int) -> None:
    chance = random.Random(seed)
    scene = Scene(0.5)
    turn = oriented(chance.uniform(0, 90), chance.uniform(10, 70), chance.uniform(0, 45))
    bar = box((7.0, 0.5, 0.7)).moved((7.0, 0.0, 3.0), turn)
    scene.stand(Fixed("bar", (bar,), 0.5))
    for k in range(2):
        place = (chance.uniform(5, 9), chance.uniform(-1, 1), 8.0 + 4 * k)
        turn = oriented(*(chance.choice([0.0, chance.uniform(-90, 90)]) for _ in range(3)))
        shape = Shape.of([random_solid(chance)], chance.choice([0.5, 2.0, 10.0]))
        scene.add(Body(str(k), shape, 0.5, place, turn))
    for _ in range(80):
        scene.tick()
        assert_possible(scene, MOVING_SKIN)


@settings(max_examples=3, deadline=None)
@given(st.integers(0, 10**9))
def test_a_hand_that_rummages_leaves_everything_where_it_can_be(seed: int) -> None:
    chance = random.Random(seed)
    scene = random_scene(chance, 3, arm=True)
    scene.put_arm((8.0, 0.0, 12.0, 0.0, 0.0, 1.0))
    clock = 400 * TICK_STATES
    scene.advance(clock)
    at = list(scene.joints)
    for _ in range(5):
        to = [
            chance.uniform(6, 9), chance.uniform(-2, 2), chance.uniform(0.1, 2.5),
            chance.uniform(-1, 1), 0.0, chance.uniform(0.2, 2),
        ]  # fmt: skip
        for k in range(1, 101):
            scene.command([a + (b - a) * k / 100 for a, b in zip(at, to, strict=True)])
            clock += TICK_STATES
            scene.advance(clock)
            assert_possible(scene, MOVING_SKIN)
        at = to
        assert all(math.isfinite(value) for value in (*scene.joints, *scene.torques))


@settings(max_examples=3, deadline=None)
@given(st.integers(0, 10**9), st.integers(2, 400))
def test_time_may_pass_in_pieces_of_any_length(seed: int, pieces: int) -> None:
    until = 200 * TICK_STATES
    ends = []
    for count in (1, pieces):
        scene = random_scene(random.Random(seed), 3)
        for k in range(1, count + 1):
            scene.advance(until * k // count)
        ends.append([(b.place, b.turn, b.velocity, b.spin) for b in scene.bodies.values()])
    assert ends[0] == ends[1]
