"""Events tell a story: one for one happening, however long."""

from __future__ import annotations

import math

import pytest

from tests.statements import done
from trs80arm import Rig
from trs80arm.arm import Bench, EventKind, JointAngles, MiniMover, Pose, Reason, benchfile
from trs80arm.arm.contact.clock import T_STATES_PER_SECOND
from trs80arm.arm.event_log import MANY, EventLog
from trs80arm.arm.events import Happening
from trs80arm.arm.stepping import PulseGenerator, delay_period


def test_a_joint_at_its_stop_is_one_event_with_its_end() -> None:
    generator = PulseGenerator(MiniMover(bench=Bench("empty")))
    generator.arm.move_joints(JointAngles(0.0, 1.0, 0.9, 0.0, 0.0))
    generator.align()
    generator.turn(2, 400, delay_period(100))
    (event,) = generator.arm.events
    assert (event.kind, event.reason) == (EventKind.SLIP, Reason.STOP)
    assert abs(event.steps - generator.arm.state().slipped[2]) < 8
    assert event.count == -event.steps // 8
    assert event.time < event.until <= generator.time
    assert event.text == f"elbow slipped {-event.steps} steps: at its stop"


def test_pressing_on_something_says_how_hard() -> None:
    generator = PulseGenerator(MiniMover(bench=Bench("empty")))
    generator.arm.move_to(Pose(8.0, 0.0, 0.5, -90.0, 0.0))
    generator.align()
    generator.turn(1, 250, delay_period(200))
    kinds = [event.kind for event in generator.arm.events]
    assert kinds == [EventKind.CONTACT, EventKind.SLIP]
    contact = generator.arm.events[0]
    assert contact.force > 50
    assert contact.text == f"shoulder blocked by the table, at {contact.force:.0f} oz"


def test_what_the_base_pushes_is_told_with_the_force_at_the_hand() -> None:
    bench = Bench("block")
    bench.add_part("block", (1.0, 1.0, 1.0), 20.0, 8.0, 0.0)
    generator = PulseGenerator(MiniMover(bench=bench))
    generator.arm.move_to(Pose(8.0, -1.2, 0.3, -90.0, 0.0))
    generator.align()
    generator.turn(0, 400, delay_period(60))
    contact = generator.arm.events[0]
    # Half of its weight holds it back, 8 in from the axis of an arm that reaches twice as far.
    assert contact.force == pytest.approx(10, abs=1.5)
    assert contact.text == f"base blocked by block, at {contact.force:.0f} oz"


def test_what_the_wrists_press_on_is_told_with_the_force_at_the_hand() -> None:
    bench = benchfile.parse("[[obstacle]]\nname = 'anvil'\nat = [11, 0]\nsize = [4, 4, 3]")
    generator = PulseGenerator(MiniMover(bench=bench))
    generator.arm.move_to(Pose(12.0, 0.0, 3.6, -30.0, 0.0))
    generator.align()
    while not (events := generator.arm.events):
        generator.step((0, 0, 0, 20, -20), delay_period(200))
    pressing = sum(contact.pressure for contact in bench.scene.contacts)
    # Both motors bear one force, each by half a hand's length; it moves slantwise to the anvil.
    assert [event.text.split(", at ")[0] for event in events] == [
        "left wrist blocked by anvil",
        "right wrist blocked by anvil",
    ]
    for event in events:
        along = pressing * math.cos(generator.arm.world.angles.pitch)
        assert event.force == pytest.approx(along, rel=0.2)


def test_the_same_again_after_a_pause_is_another_event() -> None:
    generator = PulseGenerator(MiniMover(bench=Bench("empty")))
    generator.arm.move_joints(JointAngles(0.0, 1.0, 0.95, 0.0, 0.0))
    generator.align()
    for _ in range(2):
        generator.turn(2, 200, delay_period(100))
        generator.turn(2, -50, delay_period(100))
        generator.time += 2 * T_STATES_PER_SECOND
    losses = [event for event in generator.arm.events if event.steps < 0]
    assert len(losses) == 2


def test_a_sweep_through_a_stack_is_a_handful_of_lines() -> None:
    bench = Bench("stack")
    for place in range(4):
        bench.add_part(f"block {place + 1}", (1.0, 1.0, 1.0), 2.0, 8.0, 2.0, bottom=float(place))
    generator = PulseGenerator(MiniMover(bench=bench))
    generator.arm.move_to(Pose(8.0, 0.0, 1.5, -90.0, 0.0))
    generator.align()
    generator.turn(0, 500, delay_period(100))
    assert 1 <= len(generator.arm.events) <= 12


def story(bench: str, *statements: str) -> list[str]:
    """What is told while BASIC does some statements, and until all is at rest."""
    rig = done(Rig(bench=benchfile.parse(bench)), *statements)
    rig.run_for(2.0)
    return [event.text for event in rig.arm.events]


BLOCK = """
[arm]
at = [8, 0, 0.3]
opening = 1
[[part]]
name = "block"
at = [8, 0]
size = [1, 0.5, 0.5]
weight = 2
"""
TAKE = "@CLOSE 100", "@STEP 100,0,0,0,0,0,-30", "@STEP 150,0,-100,27"


def test_taken_and_set_down_is_told_in_two_lines() -> None:
    told = story(BLOCK, *TAKE, "@STEP 150,0,100,-27", "@STEP 60,0,0,0,0,0,100")
    assert told == ["block in the hand", "block set down"]


def test_taken_and_let_fall_is_told_in_two_lines() -> None:
    # Its base is as high when the pads can carry it no more; squeezed, it stays where it is.
    rig = done(Rig(bench=benchfile.parse(BLOCK)), *TAKE)
    rig.run_for(0.5)
    height = rig.arm.bench.parts["block"].bottom
    taken, fell = story(BLOCK, *TAKE, "@STEP 60,0,0,0,0,0,100")
    assert taken == "block in the hand"
    assert fell == f"block fell {height:.2f} in"


RIDER = """
[[part]]
name = "rider"
at = [8.1, 0]
bottom = 0.5
size = [0.5, 0.4, 0.3]
weight = 0.5
"""


@pytest.mark.parametrize("pause", [[], ["FOR I=1 TO 300:NEXT"]], ids=["at once", "after a pause"])
def test_what_rides_on_what_is_let_fall_falls_as_far(pause: list[str]) -> None:
    carry = "@STEP 150,200", *pause, "@STEP 60,0,0,0,0,0,100"
    told = story(BLOCK + RIDER, *TAKE, *pause, *carry)
    assert [" ".join(line.split()[:2]) for line in told] == ["block in", "block fell", "rider fell"]
    fallen, ridden = (float(line.split()[2]) for line in told[1:])
    assert fallen > 0.7
    assert ridden == pytest.approx(fallen, abs=0.15)


@pytest.mark.parametrize("aside", [0.05, -0.05, 0.0])
def test_what_one_finger_touches_alone_is_not_in_the_hand(aside: float) -> None:
    # Its side is flush with that of the block on which it stands.
    flush = RIDER.replace("at = [8.1, 0]", f"at = [8.1, {aside}]")
    assert story(BLOCK + flush, *TAKE) == ["block in the hand"]


def test_what_rides_on_what_is_set_down_is_not_told_of() -> None:
    told = story(
        BLOCK + RIDER, *TAKE, "@STEP 150,200", "@STEP 150,0,100,-27", "@STEP 60,0,0,0,0,0,100"
    )
    assert told == ["block in the hand", "block set down"]


def test_what_the_closed_hand_loses_has_slipped_out_and_was_not_set_down() -> None:
    corner = BLOCK.replace("0, 0.3]", "0, 0.495]").replace("at = [8, 0]\n", "at = [8.795, 0]\n")
    taken, lost = story(corner, *TAKE)
    assert taken == "block in the hand"
    assert lost.startswith("block slipped out of the hand and fell 0.2")


def test_a_hand_that_is_squeezed_too_tight_is_not_blocked_by_what_the_arm_touches() -> None:
    # The forearm presses on the table, and @STEP pulls the hand's cable along with it.
    told = story("", "@STEP 60,0,0,700")
    assert [line.split(" at ")[0].split(" slipped")[0] for line in told] == [
        "elbow blocked by the table,",
        "elbow",
        "hand",
    ]
    assert told[1].endswith(": blocked")
    assert told[2].endswith(": too much load")


def test_dominoes_are_a_line_each() -> None:
    bench = "[arm]\nat = [8, -2, 1.2]\n" + "".join(
        f"[[part]]\nname = 'domino {k}'\nat = [8, {0.9 * k - 0.5}]\n"
        "size = [0.8, 0.25, 1.6]\nweight = 1\n"
        for k in range(4)
    )
    assert story(bench, "@STEP 100,150") == [f"domino {k} fell over" for k in range(4)]


def test_an_elbow_that_cannot_lift_its_load_is_a_handful_of_lines() -> None:
    lead = """
    [arm]
    at = [12, 0, 0.5]
    opening = 1
    [[part]]
    name = "lead"
    at = [12, 0]
    size = [0.5, 0.5, 1]
    weight = 30
    """
    told = story(lead, "@CLOSE 60", "@STEP 100,0,0,0,0,0,-140", "@STEP 100,0,0,300")
    assert told[0] == "lead in the hand"
    assert any(line.startswith("elbow slipped") and "too much load" in line for line in told)
    assert len(told) <= 4


def test_a_long_list_of_news_does_not_make_what_goes_on_another_event() -> None:
    log = EventLog(most=4 * MANY)
    pressing = Happening(EventKind.CONTACT, "elbow", "wall")
    first = log.tell(0, pressing, motor=2)
    for k in range(1, 2 * MANY):
        news = Happening(EventKind.PLACED, f"part {k} set down")
        number = log.tell(k * T_STATES_PER_SECOND, news)
        again = log.tell(k * T_STATES_PER_SECOND + 1, news)
        assert again == number == first + k
    # What is over is not gone through again with each of them.
    assert len(log._happening) <= MANY + 1
    assert log.tell(2 * MANY * T_STATES_PER_SECOND, pressing, motor=2, goes_on=True) == first
