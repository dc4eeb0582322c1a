"""What recurs is not computed again, and it makes no difference what is still known of it."""

from __future__ import annotations

import pickle

import pytest

from tests.arm.contact.hand import SlidingHand
from tests.arm.writes import CELL
from trs80arm.arm import MiniMover, benchfile
from trs80arm.arm.contact.bodies import Body, Shape
from trs80arm.arm.contact.clock import TICK_STATES
from trs80arm.arm.contact.recurrence import Recurrence, brief, question
from trs80arm.arm.contact.rotations import oriented
from trs80arm.arm.contact.scene import Scene
from trs80arm.arm.contact.solids import box
from trs80arm.arm.stepping import PulseGenerator, delay_period

USUAL, SLOW = delay_period(50), delay_period(100)
ROUND = (
    ((0, 132, -36), USUAL),
    ((0, 0, 0, 0, 0, -270), USUAL),
    ((0, 0, 0, 0, 0, -30), SLOW),
    ((0, -132, 36), SLOW),
    ((651, -8, -13, -461, -462), USUAL),
    ((0, 135, -37), USUAL),
    ((0, 0, 0, 0, 0, 300), USUAL),
    ((0, -135, 37), USUAL),
    ((-651, 8, 13, 461, 462), USUAL),
)
"""Approach, grip, lift, swing, press down, let go, back; the hand as it was in the end."""
TAKES = 1600 * TICK_STATES
"""T-states from the beginning of a round to that of the next: a little more than it takes."""


HEAP = (
    ((1.0, 1.0, 1.0), (5.1, 0.1, 0.5), 0.0),
    ((0.8, 0.8, 0.5), (5.1, 0.2, 1.25), 10.0),
    ((0.5, 0.5, 1.5), (6.0, 0.4, 0.75), -20.0),
    ((1.0, 1.0, 1.0), (4.0, 6.0, 0.5), 0.0),
)
"""Sizes of what lies there, where, and how it is turned: a rider, a block behind, one far off."""
BESIDE = (4.0, 0.0, 0.3, 0.0, 0.0, 0.1)


class Work:
    """An arm that picks and places in a cell, round by round."""

    def __init__(self) -> None:
        self.generator = PulseGenerator(MiniMover(bench=benchfile.parse(CELL)))
        self.generator.step((0, 0, 0, 0, 0, 578), USUAL)
        self.generator.step((0, -207, 290), USUAL)
        self.begun = self.generator.time

    @property
    def scene(self) -> Scene:
        """What is in contact there, seen."""
        self.generator.arm.world.show()
        return self.generator.arm.bench.scene

    def round(self, *, forgetful: bool = False, late: int = 0) -> None:
        """Go round once, and begin the next as many whole ticks later.

        Args:
            forgetful: whether all is written down and read again before each motion.
            late: T-states by which the next begins later than that.
        """
        for counts, period in ROUND:
            if forgetful:
                self.generator.arm = pickle.loads(pickle.dumps(self.generator.arm))
            self.generator.step(counts, period)
        self.begun += TAKES + late
        assert self.generator.time < self.begun
        self.generator.time = self.begun


@pytest.mark.parametrize("late", [0, 1701])
def test_a_program_that_goes_round_is_solved_once_whenever_it_begins_anew(late: int) -> None:
    work = Work()
    for _ in range(3):
        work.round(late=late)
    steps, solved = work.scene.steps, work.scene.solved
    work.round(late=late)
    assert (work.scene.solved, work.scene.steps) == (solved, steps)
    assert work.generator.arm.bench.trays[0].taken == 4


@pytest.mark.parametrize("late", [0, 1, 1701, 5000])
def test_it_makes_no_difference_what_is_still_known(late: int) -> None:
    knows, forgets = Work(), Work()
    for _ in range(3 if not late else 5):
        knows.round(late=late)
        forgets.round(forgetful=True, late=late)
        arm, other = knows.generator.arm, forgets.generator.arm
        assert (arm.grip, arm.borne(), arm.peaks) == (other.grip, other.borne(), other.peaks)
        assert [motor.pulses for motor in arm.motors] == [motor.pulses for motor in other.motors]
        assert knows.scene.driven.joints == forgets.scene.driven.joints
        assert knows.scene.torques == forgets.scene.torques
        assert knows.scene.bodies == forgets.scene.bodies
    assert knows.generator.arm.events == forgets.generator.arm.events


def push(scene: Scene, names: str, *, forgetful: bool = False) -> Scene:
    """Lay a heap and push a hand through it.

    Args:
        scene: with a hand.
        names: of what lies there.
        forgetful: whether all is written down and read again before each tick.

    Returns:
        The scene, or what has been read.
    """
    scene.clear()
    scene.put_arm(BESIDE)
    scene.look_closely()
    for name, (size, place, turned) in zip(names, HEAP, strict=True):
        scene.add(Body(name, Shape.of([box(size)], 2.0), 0.5, place, oriented(turned)))
    begun = scene.time
    for k in range(60):
        if forgetful:
            scene = pickle.loads(pickle.dumps(scene))
        scene.command((BESIDE[0] + 0.015 * k, *BESIDE[1:]))
        scene.advance(begun + (k + 1) * TICK_STATES)
    return scene


def test_a_heap_is_pushed_as_if_for_the_first_time_whatever_its_parts_are_called() -> None:
    knows, forgets = Scene(arm=SlidingHand()), Scene(arm=SlidingHand())
    solved = []
    for names in ("abcd", "abcd", "efgh", "badc", "fehg"):
        before = knows.solved
        push(knows, names)
        forgets = push(forgets, names, forgetful=True)
        assert knows.bodies == forgets.bodies
        assert list(knows.bodies) == list(names)
        assert knows.driven.joints == forgets.driven.joints
        assert knows.driven.torques == forgets.driven.torques
        for finger in SlidingHand.names[:2]:
            assert list(knows.pressed(finger)) == list(forgets.pressed(finger))
        solved.append(knows.solved - before)
    # What goes on as before for a while is looked at anew, for that hangs on what is far off too.
    again = solved[2]
    assert solved[0] > 4 * again
    # Names do matter in that they give an order.
    assert solved[3] > 4 * again
    assert solved[4] == again


def test_what_is_pressed_into_another_shape_is_not_what_it_was() -> None:
    cube = Shape.of([box((1.0, 1.0, 1.0))], 2.0)
    one, other = (Body(name, cube, 0.5, (0.0, 0.0, 0.5)) for name in "ab")
    assert one.form == other.form
    one.shape = Shape.of([box((1.0, 1.0, 0.5))], 2.0)
    assert one.form != other.form
    other.shape = Shape.of([box((1.0, 1.0, 0.5))], 2.0)
    assert one.form == other.form


def test_a_question_is_the_same_to_the_last_bit_only() -> None:
    place = (0.1 + 0.2, [1.0, None])
    assert question(place, 2) == question((0.1 + 0.2, [1.0, None]), 2)
    assert question(0.0) != question(-0.0)
    assert question(0.1 + 0.2) != question(0.3)
    assert question(1) != question(1.0)
    assert question((1.0, 2.0), 3.0) != question(1.0, (2.0, 3.0))


def test_a_question_told_in_brief_is_told_apart_to_the_last_bit_as_well() -> None:
    assert brief((0.1 + 0.2, [1.0])) == brief((0.1 + 0.2, [1.0]))
    assert len({brief(0.0), brief(-0.0), brief(0.3), brief(0.1 + 0.2), brief(0), brief((0,))}) == 6


def test_what_has_been_known_longest_is_forgotten() -> None:
    known: Recurrence[str] = Recurrence(2)
    for name in ("one", "two", "three"):
        known.keep(question(name), name)
    assert known.get(question("one")) is None
    assert known.get(question("two")) == "two"
    assert known.get(question("three")) == "three"
