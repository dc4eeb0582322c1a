"""Forces of contact: what a grip holds and lets slip, and in how few steps that is found."""

from __future__ import annotations

import math

import pytest

from tests.arm.contact.hand import PER_INCH, SlidingHand
from trs80arm.arm.contact import prospect
from trs80arm.arm.contact.bodies import Body, Shape
from trs80arm.arm.contact.clock import T_STATES_PER_SECOND, TICK_STATES
from trs80arm.arm.contact.rotations import oriented
from trs80arm.arm.contact.scene import Scene
from trs80arm.arm.contact.sixes import plus, six
from trs80arm.arm.contact.solids import box
from trs80arm.arm.contact.solver import Problem
from trs80arm.arm.contact.table import Plate

WEIGHT = 4.0
NEEDED = WEIGHT / (2 * math.sqrt(0.75 * 0.5))
"""Ounces with which the fingers must press for their friction to carry the cube."""


def block(name: str, place: tuple[float, float, float]) -> Body:
    """An inch of something, 2 oz."""
    return Body(name, Shape.of([box((1.0, 1.0, 1.0))], 2.0), 0.5, place)


class Hand:
    """A hand that is commanded elsewhere from tick to tick."""

    def __init__(self, *joints: float) -> None:
        self.scene = Scene(arm=SlidingHand())
        self.scene.put_arm(joints)
        self.time = 0

    def wait(self, ticks: int) -> None:
        """Let some ticks pass."""
        self.time += ticks * TICK_STATES
        self.scene.advance(self.time)

    def move(self, *joints: float) -> None:
        """Be elsewhere a tick later."""
        self.scene.command(joints)
        self.wait(1)


@pytest.mark.parametrize(("force", "carries"), [(0.98, False), (0.995, False), (1.02, True)])
def test_a_slackening_grip_holds_until_its_friction_is_less_than_the_weight(
    force: float, carries: bool
) -> None:
    hand = Hand(8.0, 0.0, 0.3, 0.0, 0.0, 1.2)
    cube = Body("cube", Shape.of([box((1.0, 1.0, 1.0))], WEIGHT), 0.5, (8.0, 0.0, 0.5))
    hand.scene.add(cube)
    hand.wait(60)
    tight, slack = (1.0 - share * NEEDED / PER_INCH for share in (1.3, force))
    for k in range(41):
        hand.move(8.0, 0.0, 0.3, 0.0, 0.0, 1.2 + (tight - 1.2) * k / 40)
    for k in range(201):
        hand.move(8.0, 0.0, 0.3 + 0.01 * k, 0.0, 0.0, tight)
    hand.wait(40)
    before = cube.place[2]
    assert before == pytest.approx(2.5, abs=0.05)
    for k in range(21):
        hand.move(8.0, 0.0, 2.3, 0.0, 0.0, tight + (slack - tight) * k / 20)
    hand.wait(400)
    assert cube.place[2] == pytest.approx(before if carries else 0.5, abs=0.03)


def test_what_goes_on_as_before_is_found_in_little_more_than_a_step(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(prospect, "MOST_STEPS", 0)
    hand = Hand(4.2, 0.0, 0.3, 0.0, 0.0, 0.1)
    scene = hand.scene
    for k in range(5):
        cube = Shape.of([box((1.0, 1.0, 1.0))], 2.0)
        scene.add(Body(str(k), cube, 0.5, (5.0 + k, 0.0, 0.5)))
    hand.wait(60)
    for k in range(400):
        if k == 200:
            scene.steps = scene.solved = 0
        hand.move(4.2 + 0.01 * k, 0.0, 0.3, 0.0, 0.0, 0.1)
    assert scene.solved >= 50
    assert scene.steps < 1.5 * scene.solved


def test_what_stands_on_a_plate_goes_round_with_it_and_not_outwards() -> None:
    scene = Scene()
    plate = Plate(0.0, 0.0, 2.0)
    scene.plates.append(plate)
    cube = scene.add(Body("cube", Shape.of([box((0.5, 0.5, 0.5))], 2.0), 0.5, (1.5, 0.0, 0.25)))
    plate.spin = 0.8
    scene.advance(round(math.tau / 0.8 * T_STATES_PER_SECOND))
    x, y, _ = cube.place
    assert math.hypot(x, y) == pytest.approx(1.5, abs=0.003)
    assert (x, y) == pytest.approx((1.5, 0.0), abs=0.05)


def test_a_step_of_newtons_method_follows_how_the_momentum_that_is_missing_grows(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    problems: list[Problem] = []

    class Noted(Problem):
        def solve(self) -> int:
            problems.append(self)
            return super().solve()

    monkeypatch.setattr("trs80arm.arm.contact.scene.Problem", Noted)
    hand = Hand(8.0, 0.0, 0.3, 0.2, 0.1, 1.3)
    for z in (0.5, 1.25):
        size = (1.0, 1.0, 2 * z) if z < 1 else (0.8, 0.6, 0.5)
        shape = Shape.of([box(size)], 2.0)
        hand.scene.add(Body(str(z), shape, 0.5, (8.0, 0.0, z), oriented(11.0)))
    for k in range(30):
        hand.move(8.0, 0.0, 0.3, 0.2, 0.1, 1.3 - 0.012 * k)
    problem = max(problems, key=lambda each: len(each.contacts))
    assert len(problem.mobiles) == 3
    assert len(problem.contacts) >= 4
    speeds = [six(mobile.speed) for mobile in problem.mobiles]
    bounds = [[each.friction * p for p in each.pressures] or None for each in problem.contacts]
    before = problem._slope(speeds, bounds)
    system = problem._system()
    for k in range(18):
        little = [[0.0] * 6 for _ in speeds]
        little[k // 6][k % 6] = 1e-8
        there = plus(speeds, [six(each) for each in little])
        grown = [
            [b - a for a, b in zip(one, other, strict=True)]
            for one, other in zip(before, problem._slope(there, bounds), strict=True)
        ]
        for found, put in zip(system.solve(grown), little, strict=True):
            assert found == pytest.approx(put, abs=1e-10)


def test_what_has_turned_with_the_hand_is_found_pressed_where_it_was(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    begun: list[dict[str, list[float]]] = []

    class Noted(Problem):
        def solve(self) -> int:
            begun.append({each.key[0]: list(each.pressures) for each in self.contacts})
            return super().solve()

    monkeypatch.setattr("trs80arm.arm.contact.scene.Problem", Noted)
    hand = Hand(8.0, 0.0, 0.3, 0.0, 0.0, 1.1)
    hand.scene.add(block("cube", (8.0, 0.0, 0.5)))
    hand.wait(60)
    for k in range(31):
        hand.move(8.0, 0.0, 0.3, 0.0, 0.0, 1.1 - 0.006 * k)
    for k in range(101):
        hand.move(8.0, 0.0, 0.3 + 0.01 * k, 0.0, 0.0, 0.92)
    for k in range(101):
        hand.move(8.0, 0.0, 1.3, 0.014 * k, 0.0, 0.92)
    assert hand.scene.carried
    begun.clear()
    for k in range(101):
        hand.move(8.0, 0.0, 1.3 - 0.01 * k, 1.4, 0.0, 0.92)
    assert all(begun[0]["left finger"])
    assert all(begun[0]["right finger"])


def test_what_spins_in_the_air_does_not_cut_the_steps_of_what_slides_on_the_table() -> None:
    scene = Scene()
    slides = scene.add(block("slides", (5.0, 0.0, 0.5)))
    scene.advance(60 * TICK_STATES)
    scene.wake("slides")
    slides.velocity = (8.0, 0.0, 0.0)
    spins = scene.add(block("spins", (0.0, 0.0, 9.0)))
    spins.spin = (0.0, 0.0, 80.0)
    before = scene.solved
    for _ in range(5):
        scene.tick()
    assert scene.solved == before + 5
    assert slides.velocity[0] < 8.0


def test_what_turns_fast_near_something_is_solved_in_short_steps_alone() -> None:
    scene = Scene()
    top = scene.add(block("top", (0.0, 0.0, 0.5)))
    scene.advance(60 * TICK_STATES)
    scene.wake("top")
    top.spin = (0.0, 0.0, 30.0)
    before = scene.solved
    scene.tick()
    assert scene.solved == before + 2
