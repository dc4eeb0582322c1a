"""The hand: Figures 5 and 6, the grip switch, friction and what is carried."""

from __future__ import annotations

import pytest

from trs80arm.arm import Bench, EventKind, MiniMover, Pose, Reason, benchfile
from trs80arm.arm.models import MINIMOVER5
from trs80arm.arm.stepping import SWITCH_CLOSED, PulseGenerator, delay_period

EASY = delay_period(200)
D50 = delay_period(50)
OVER_PART = Pose(8.0, 0.0, 0.5, -90.0, 0.0, 1.25)


def hand_on(
    size: tuple[float, float, float] = (0.75, 0.75, 1.0),
    weight: float = 2.0,
    at: tuple[float, float] = (8.0, 0.0),
    turn: float = 0.0,
) -> PulseGenerator:
    """The open hand around a part."""
    bench = Bench("one part")
    bench.add_part("block", size, weight, *at, turn=turn)
    arm = MiniMover(bench=bench)
    arm.move_to(OVER_PART)
    generator = PulseGenerator(arm)
    generator.align()
    return generator


def kinds(arm: MiniMover) -> list[EventKind]:
    return [event.kind for event in arm.events]


def test_the_empty_hand_closes_an_inch_in_618_steps() -> None:
    arm = MiniMover(bench=Bench("empty"))
    arm.move_joint("hand", 2.0)
    generator = PulseGenerator(arm)
    generator.align()
    generator.turn(5, -618, D50)
    assert arm.state().pose.opening == pytest.approx(1.0, abs=1e-9)
    assert arm.state().force == 0


def test_force_grows_by_a_pound_in_52_steps() -> None:
    # "This additional cable take-up is converted into gripping force at the rate of one pound
    # for every 52 steps."
    generator = hand_on()
    generator.close(D50)
    before = generator.arm.state()
    generator.turn(5, -52, EASY)
    after = generator.arm.state()
    assert after.force - before.force == pytest.approx(1.0)
    assert after.pose.opening == before.pose.opening


def test_the_switch_closes_at_about_2_ounces() -> None:
    # "which may stop the drive motor as soon as it closes, in which case the grasping force is
    # limited to about 2 ounces"
    generator = hand_on()
    generator.close(D50)
    state = generator.arm.state()
    assert state.switch_closed
    assert 2.0 <= state.force * 16 < 2.4
    generator.turn(5, 1, EASY)
    assert not generator.arm.state().switch_closed


@pytest.mark.parametrize("width", [0.25, 0.75, 1.0])
def test_closing_on_a_part_measures_it(width: float) -> None:
    generator = hand_on((width, width, 1.0))
    opening = generator.arm.state().pose.opening
    steps = generator.close(D50)
    assert (opening - (steps - 7) / 618) == pytest.approx(width, abs=0.004)
    assert generator.arm.state().pose.opening == pytest.approx(width, abs=0.004)


@pytest.mark.parametrize(
    ("widths", "apart", "period"),
    [
        ((0.34, 0.32), 0.08, 50),
        ((0.42, 0.46), 0.03, 50),
        ((0.28, 0.47), 0.0, 50),
        ((0.41, 0.31, 0.33), 0.06, 60),
        ((0.3, 0.3, 0.3), 0.01, 100),
    ],
)
def test_closing_on_parts_side_by_side_measures_all_of_them(
    widths: tuple[float, ...], apart: float, period: int
) -> None:
    bench = Bench("side by side")
    whole = sum(widths) + apart * (len(widths) - 1)
    y = -whole / 2
    for width in widths:
        bench.add_part(f"{width} at {y:.2f}", (0.5, width, 0.8), 1.0, 8.0, y + width / 2)
        y += width + apart
    arm = MiniMover(bench=bench)
    arm.move_to(Pose(8.0, 0.0, 0.2, -90.0, 0.0, whole + 0.4))
    generator = PulseGenerator(arm)
    generator.align()
    generator.close(delay_period(period))
    # The half-step on which the switch closes is that of one part as wide.
    assert arm.world.grip.cable + 7 == round(618 * sum(widths))
    generator.turn(5, -30, D50)
    generator.step((0, -132, 36), delay_period(100))
    assert all(part.held and part.bottom > 0.9 for part in bench.parts.values())
    assert arm.world.grip.weight == len(widths)


def test_the_empty_hand_closes_on_itself_and_gives_up_at_3_pounds() -> None:
    arm = MiniMover(bench=Bench("empty"))
    arm.move_joint("hand", 3.0)
    generator = PulseGenerator(arm)
    generator.align()
    assert generator.close(D50) == 1854 + 7
    most = 0.0
    for _ in range(160):
        generator.turn(5, -1, EASY)
        most = max(most, arm.state().force)
    assert most == pytest.approx(3.0)
    losses = [event for event in arm.events if event.kind is EventKind.SLIP]
    assert {event.reason for event in losses} == {Reason.LOAD}
    assert {event.motor for event in losses} == {5}


def test_opening_first_unwinds_the_squeeze() -> None:
    generator = hand_on()
    generator.close(D50, 30)
    width = generator.arm.state().pose.opening
    generator.turn(5, 36, D50)
    assert generator.arm.state().pose.opening == width
    generator.turn(5, 62, D50)
    assert generator.arm.state().pose.opening == pytest.approx(width + 0.1, abs=0.003)


def test_a_gripped_part_is_carried_and_set_down() -> None:
    generator = hand_on()
    arm = generator.arm
    generator.close(D50, 30)
    assert arm.state().held == "block"
    generator.step((0, -132, 36), delay_period(100))
    block = arm.bench.parts["block"]
    assert block.bottom == pytest.approx(1.0, abs=0.02)
    generator.step((100, 0, 0), D50)
    generator.step((0, 132, -36), D50)
    generator.turn(5, 200, D50)
    generator.wait(0.5)
    assert arm.state().held is None
    assert block.bottom == pytest.approx(0, abs=1e-5)
    assert block.place[1] == pytest.approx(8 * 100 / 937.8, abs=0.03)
    assert kinds(arm)[-1] is EventKind.PLACED
    assert arm.state().slipped == (0,) * 6


def test_a_part_let_go_in_the_air_falls() -> None:
    generator = hand_on()
    arm = generator.arm
    generator.close(D50, 30)
    generator.step((0, -264, 72), delay_period(100))
    generator.turn(5, 200, D50)
    generator.wait(1.0)
    assert arm.bench.parts["block"].bottom == pytest.approx(0, abs=1e-5)
    assert EventKind.DROPPED in kinds(arm)


def test_a_part_gripped_too_lightly_is_not_lifted() -> None:
    # 2.15 oz of force on each of two pads, friction 0.75: it carries 3.2 oz.
    generator = hand_on(weight=8.0)
    arm = generator.arm
    generator.close(D50)
    assert arm.state().held is None
    generator.step((0, -132, 36), delay_period(100))
    assert arm.bench.parts["block"].bottom == pytest.approx(0, abs=1e-5)
    assert arm.state().slipped == (0,) * 6


def test_a_squeeze_lifts_what_the_switch_force_does_not() -> None:
    generator = hand_on(weight=8.0)
    generator.close(D50, 30)
    assert generator.arm.state().held == "block"


def test_a_part_slips_out_as_the_grip_slackens() -> None:
    generator = hand_on(weight=8.0)
    arm = generator.arm
    generator.close(D50, 30)
    generator.step((0, -132, 36), delay_period(150))
    assert arm.state().held == "block"
    generator.turn(5, 22, EASY)
    generator.wait(1.0)
    assert arm.state().held is None
    assert arm.bench.parts["block"].bottom == pytest.approx(0, abs=1e-5)


def test_elbow_motion_without_compensation_drops_the_part() -> None:
    generator = hand_on(weight=2.0)
    arm = generator.arm
    generator.close(D50)
    generator.step((0, -60, 0), EASY)
    assert arm.state().held == "block"
    generator.step((0, 0, 20), EASY, compensate=0)
    assert arm.state().held is None


def test_a_part_off_centre_is_pushed_to_the_middle() -> None:
    generator = hand_on(at=(8.0, 0.2))
    generator.close(D50, 30)
    assert generator.arm.state().held == "block"
    assert generator.arm.bench.parts["block"].box.center[1] == pytest.approx(0, abs=0.01)


def test_the_switch_closes_on_something_fixed_too() -> None:
    bench = benchfile.parse("[[obstacle]]\nat = [8, 0]\nsize = [1, 0.75, 1]")
    arm = MiniMover(bench=bench)
    arm.move_to(OVER_PART)
    generator = PulseGenerator(arm)
    generator.align()
    generator.close(D50, 20)
    assert arm.state().switch_closed
    assert arm.state().held is None
    assert arm.state().pose.opening == pytest.approx(0.75, abs=0.004)
    generator.turn(5, 100, D50)
    generator.step((0, -60, 0), EASY)
    assert arm.state().slipped == (0,) * 6


def test_the_hand_closes_past_a_part_that_is_not_between_its_fingers() -> None:
    generator = hand_on(at=(8.0, 2.5))
    generator.close(D50)
    assert generator.arm.state().pose.opening == 0
    assert generator.arm.state().held is None


def test_a_burst_ends_right_after_the_write_that_closes_the_switch() -> None:
    generator = hand_on()
    arm = generator.arm
    before = arm.rotors[5]
    steps = generator.step((0, 0, 0, 0, 0, -2000), D50, SWITCH_CLOSED)
    assert arm.inputs(generator.time) & 1 == 0
    assert arm.rotors[5] == before - steps
    assert arm.state().force * MINIMOVER5.hand.pound_steps == pytest.approx(7)


def test_the_hand_stops_at_3_inches() -> None:
    arm = MiniMover(bench=Bench("empty"))
    arm.move_joint("hand", 2.9)
    generator = PulseGenerator(arm)
    generator.align()
    generator.turn(5, 200, EASY)
    assert arm.state().pose.opening <= 3.0
    assert arm.state().slipped[5] < 0
