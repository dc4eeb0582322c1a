"""Forces of contact: what a grip holds and lets slip, and in how few steps that is found."""

from __future__ import annotations

import math

import pytest

from tests.arm.contact.hand import PER_INCH, SlidingHand
from trs80arm.arm.contact import prospect
from trs80arm.arm.contact.bodies import Body, Shape
from trs80arm.arm.contact.clock import T_STATES_PER_SECOND, TICK_STATES
from trs80arm.arm.contact.scene import Scene
from trs80arm.arm.contact.solids import box
from trs80arm.arm.contact.table import Plate

WEIGHT = 4.0
NEEDED = WEIGHT / (2 * math.sqrt(0.75 * 0.5))
"""Ounces with which the fingers must press for their friction to carry the cube."""


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
