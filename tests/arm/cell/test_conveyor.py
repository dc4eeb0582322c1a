"""The conveyor: started and stopped by OUT, it carries by friction whatever lies on it."""

from __future__ import annotations

import pytest

from tests.arm.cell.cells import arm_at, at_the_cell, run, started
from tests.arm.refusals import refusal
from tests.slices import sliced
from trs80arm.arm import BenchError, benchfile
from trs80arm.arm.cell.conveyor import Conveyor
from trs80arm.arm.contact.clock import T_STATES_PER_SECOND
from trs80arm.arm.minimover import MiniMover, Pose
from trs80arm.arm.stepping import PulseGenerator

BELT = """
[[conveyor]]
name = "belt"
at = [7.0, -6.0]
length = 10.0
width = 2.0
height = 1.0
speed = 2.0
ramp = 0.25
run = 0
reverse = 1
"""
BLOCK = """
[[part]]
name = "block"
at = [4.0, -6.0]
bottom = 1.0
size = [0.5, 0.5, 0.5]
"""
RIDER = BLOCK.replace("block", "rider").replace("1.0", "1.5")
STOP = """
[[obstacle]]
name = "stop"
at = [11.0, -6.0]
bottom = 1.0
size = [0.5, 2.0, 1.0]
"""
CELL = "[arm]\nat = [6.0, 0.0, 5.0]\n" + BELT.replace("[7.0, -6.0]", "[8.0, 0.0]").replace(
    "1.0\n", "0.5\n"
)
"""A belt under the hand."""


def place(arm: MiniMover, name: str) -> tuple[float, float, float]:
    return arm.bench.parts[name].place


def belt_of(arm: MiniMover) -> Conveyor:
    (belt,) = arm.bench.cell.devices
    assert isinstance(belt, Conveyor)
    return belt


def run_belt(arm: MiniMover, nibble: int, start: float, seconds: float) -> None:
    """Write the latch at a time, and let time pass."""
    arm.apply([round(start * T_STATES_PER_SECOND)], [6], [nibble])
    arm.advance(round((start + seconds) * T_STATES_PER_SECOND))


def test_a_part_and_its_rider_go_as_far_as_the_belt_and_stop_with_it() -> None:
    arm = arm_at(BELT + BLOCK + RIDER)
    run_belt(arm, 1, 1.0, 2.0)
    run_belt(arm, 0, 3.0, 1.0)
    # Two seconds at 2 in/s, the ramp up lost and the ramp down won.
    assert belt_of(arm).gone(4 * T_STATES_PER_SECOND) == pytest.approx(4.0, abs=0.001)
    for name, bottom in (("block", 1.25), ("rider", 1.75)):
        assert place(arm, name) == pytest.approx((8.0, -6.0, bottom), abs=0.03)
        assert arm.bench.parts[name].asleep
    assert [event.text for event in arm.events[:2]] == ["belt started", "belt stopped"]
    assert {event.text.split(" ", 1)[1][:10] for event in arm.events[2:]} == {"carried 4."}


def test_the_other_bit_turns_the_belt_round() -> None:
    arm = arm_at(BELT + BLOCK.replace("4.0", "7.0"))
    run_belt(arm, 3, 0.0, 1.0)
    assert place(arm, "block")[0] == pytest.approx(7.0 - 1.75, abs=0.03)
    run_belt(arm, 1, 1.0, 1.0)
    assert [event.text for event in arm.events] == ["belt started", "belt turned round"]
    assert belt_of(arm).velocity(2 * T_STATES_PER_SECOND) == 2.0


def test_what_an_end_stop_holds_slips_on_the_belt_and_costs_nothing() -> None:
    arm = arm_at(BELT + BLOCK + STOP)
    run_belt(arm, 1, 0.0, 6.0)
    assert place(arm, "block") == pytest.approx((10.5, -6.0, 1.25), abs=0.005)
    solved = arm.bench.scene.solved
    arm.advance(20 * T_STATES_PER_SECOND)
    assert arm.bench.scene.solved == solved
    assert place(arm, "block") == pytest.approx((10.5, -6.0, 1.25), abs=0.005)


def test_what_moves_steadily_with_the_belt_costs_little() -> None:
    arm = arm_at(BELT + BLOCK + RIDER)
    run_belt(arm, 1, 0.0, 0.5)
    solved = arm.bench.scene.solved
    arm.advance(3 * T_STATES_PER_SECOND)
    assert place(arm, "block")[0] > 9.5
    assert arm.bench.scene.solved - solved < 15, "of 540 ticks"


def test_a_part_goes_off_the_end_and_falls_on_the_table() -> None:
    arm = arm_at(BELT + BLOCK)
    run_belt(arm, 1, 0.0, 6.0)
    x, _, z = place(arm, "block")
    assert x > 12.2
    assert z == pytest.approx(0.25, abs=0.01)
    assert arm.bench.parts["block"].asleep


def test_a_smooth_part_on_a_belt_that_starts_hard_is_left_behind() -> None:
    rough, smooth = (
        arm_at(BELT.replace("ramp = 0.25", "ramp = 0.01") + BLOCK + f"friction = {friction}")
        for friction in (0.5, 0.01)
    )
    for arm in (rough, smooth):
        run_belt(arm, 1, 0.0, 0.1)
    assert place(rough, "block")[0] > place(smooth, "block")[0] + 0.02
    # In the end both go at the belt's speed.
    for arm in (rough, smooth):
        run_belt(arm, 1, 0.1, 1.9)
        before = place(arm, "block")[0]
        arm.advance(round(2.5 * T_STATES_PER_SECOND))
        assert place(arm, "block")[0] - before == pytest.approx(1.0, abs=0.01)


def test_the_hand_picks_a_part_from_the_running_belt() -> None:
    part = BLOCK.replace("4.0, -6.0", "7.0, 0.0").replace("1.0", "0.5")
    generator = PulseGenerator(arm_at(CELL.replace("speed = 2.0", "speed = 0.5") + part))
    arm = generator.arm
    arm.move_to(Pose(8.0, 0.0, 0.7, -90.0, 0.0, 0.7))
    generator.align()
    run_belt(arm, 1, 0.1, 1.8)
    generator.time = round(1.9 * T_STATES_PER_SECOND)
    generator.close(4800, 40)
    held = arm.state().held
    generator.step((0, -250, 0, 0, 0, 0), 7200)
    assert (held, arm.state().held) == ("block", "block")
    assert arm.bench.parts["block"].bottom > 1.0
    generator.wait(1.0)
    assert belt_of(arm).goal == 0.5


def test_the_photocell_is_seen_by_inp_and_stops_the_belt_from_basic() -> None:
    rig = at_the_cell(BELT + "[conveyor.photocell]\nbit = 2\nalong = 2.0\n" + BLOCK)
    printed = run(
        rig,
        """10 LPRINT INP(152)AND4
20 OUT 158,1
30 IF INP(152)AND4 THEN 30
40 OUT 158,0
50 LPRINT INP(152)AND4
""",
    )
    assert printed == " 4 \n 0 \n"
    rig.run_for(1)
    # The beam is at x = 9: the block's front is there, and the belt runs out.
    assert place(rig.arm, "block")[0] == pytest.approx(9.0, abs=0.15)
    assert "belt photocell" in [answer.name for answer in rig.arm.answers(rig.clock.now)]


def test_a_belt_is_the_same_whole_and_sliced_with_snapshots_between() -> None:
    program = "10 OUT 158,1:FOR I=1 TO 700:NEXT:OUT 158,3:FOR I=1 TO 300:NEXT:OUT 158,0\n"
    ends = []
    for in_slices in (False, True):
        rig = started(at_the_cell(BELT + BLOCK + RIDER + STOP), program)
        if in_slices:
            rig = sliced(rig, (0.05 + 0.011 * k for k in range(25)), range(0, 25, 6))
        rig.run_to(9 * T_STATES_PER_SECOND)
        parts = [(part.place, part.turn, part.velocity) for part in rig.arm.bench.parts.values()]
        ends.append((parts, rig.arm.events, rig.snapshot()))
    assert ends[0] == ends[1]
    assert len(ends[0][1]) > 3


def test_parts_put_back_stand_on_the_belt_that_runs_on() -> None:
    arm = arm_at(BELT + BLOCK + STOP)
    run_belt(arm, 1, 0.0, 2.0)
    arm.refill()
    assert place(arm, "block")[0] == pytest.approx(4.0, abs=0.001)
    arm.advance(3 * T_STATES_PER_SECOND)
    assert place(arm, "block")[0] == pytest.approx(6.0, abs=0.1)


@pytest.mark.parametrize(
    ("old", "new", "line"),
    [
        ("run = 0", "", "run: expected a whole number from 0 to 3"),
        ("reverse = 1", "reverse = 0", "reverse: expected a free bit; bit 0 of the auxiliary "
         "latch is already named by run"),
        ("speed = 2.0", "speed = 0", "speed: expected a number from 0.05 to 20"),
        ("ramp = 0.25", "ramp = -1", "ramp: expected a number from 0.01 to 10"),
        ("length = 10.0", "length = 0.2", "length: expected a number from 1 to 60"),
        ("width = 2.0", "", "width: expected a number from 0.25 to 60"),
        ("height = 1.0", "height = 40", "height: expected a number from 0.1 to 10"),
        ("at = [7.0, -6.0]", "at = [0, 0]", "at: expected a free place; it overlaps base"),
        ("ramp = 0.25", "belt = 1", "belt: expected nothing by that name; the keys here are name, "
         "at, length, width, height, turn, speed, ramp, friction, run, reverse, photocell"),
        ("reverse = 1", "photocell = 3", "photocell: expected a table, written [photocell]"),
        ("reverse = 1", "photocell = { bit = 4 }", "photocell.bit: expected a whole number from 1 "
         "to 3"),
        ("reverse = 1", "photocell = { bit = 1, along = 6 }", "photocell.along: expected a number "
         "from -5 to 5"),
    ],
)  # fmt: skip
def test_a_wrong_belt_is_one_line(old: str, new: str, line: str) -> None:
    assert refusal(BELT.replace(old, new)) == f"b.toml: conveyor[1].{line}"


def test_parts_stand_on_the_belt_and_not_in_it() -> None:
    with pytest.raises(BenchError, match="a free place; it overlaps belt"):
        benchfile.parse(BELT + BLOCK.replace("bottom = 1.0", "bottom = 0.5"), "b.toml")
