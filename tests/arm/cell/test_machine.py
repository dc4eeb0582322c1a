"""The machine with a handshake: start, busy and done, driven from BASIC by OUT and INP alone."""

from __future__ import annotations

import pytest

from tests.arm.cell.cells import arm_at, at_the_cell, run, started
from tests.arm.refusals import refusal
from tests.arm.writes import Recorder
from tests.slices import elsewhere
from trs80arm.arm.cell.machine import Machine
from trs80arm.arm.contact.clock import T_STATES_PER_SECOND
from trs80arm.arm.minimover import MiniMover, Pose
from trs80arm.arm.stepping import PulseGenerator

PRESS = """
[[machine]]
name = "press"
at = [9.0, 4.0]
size = [1.5, 1.5, 2.0]
seconds = 0.75
press = 0.5
start = 2
busy = 1
done = 2
error = 3
"""
BLOCK = """
[[part]]
name = "block"
at = [9.0, 4.0]
size = [0.5, 0.5, 1.0]
weight = 3.0
"""
WORK = round(0.75 * T_STATES_PER_SECOND)

HANDSHAKE = """10 LPRINT INP(152)AND14
20 OUT 158,4:LPRINT INP(152)AND14
30 I=I+1:IF INP(152)AND4 THEN 30
40 LPRINT INP(152)AND14;I
50 OUT 158,0:LPRINT INP(152)AND14
"""
IDLE, BUSY, DONE, ERROR = 14, 12, 10, 6


def press_of(arm: MiniMover) -> Machine:
    (press,) = arm.bench.cell.devices
    assert isinstance(press, Machine)
    return press


def answers(arm: MiniMover, time: int) -> int:
    return arm.inputs(time) & 14


def test_basic_does_the_four_phases_of_the_handshake() -> None:
    rig = at_the_cell(PRESS + BLOCK)
    printed = run(rig, HANDSHAKE).split()
    polls = int(printed[3])
    assert printed == ["14", "12", "10", str(polls), "14"]
    assert 40 < polls < 150
    assert [event.text for event in rig.arm.events] == [
        "press works on block",
        "press has pressed block",
    ]
    started, done = (event.time for event in rig.arm.events)
    assert done - started == WORK


def test_it_is_busy_and_done_at_the_very_t_state() -> None:
    arm = arm_at(PRESS + BLOCK)
    start = 1_000_003
    assert answers(arm, start - 1) == IDLE
    arm.apply([start], [6], [4])
    assert answers(arm, start) == BUSY
    assert answers(arm, start + WORK - 1) == BUSY
    assert answers(arm, start + WORK) == DONE
    assert answers(arm, start + 5 * WORK) == DONE, "until start falls"
    arm.apply([start + 6 * WORK], [6], [0])
    assert answers(arm, start + 6 * WORK) == IDLE


def test_the_handshake_is_the_same_whole_and_sliced_with_snapshots_between() -> None:
    ends = []
    for step in (None, 977, 40_001):
        rig = started(at_the_cell(PRESS + BLOCK), HANDSHAKE)
        end = 3 * T_STATES_PER_SECOND
        if step is not None:
            rig.run_to(round(1.4 * T_STATES_PER_SECOND))
            for k in range(40):
                rig.run_to(rig.clock.now + step)
                if k % 13 == 0:
                    rig = elsewhere(rig)
        rig.run_to(end)
        part = rig.arm.bench.parts["block"]
        ends.append((rig.printer.text, rig.arm.events, part.place, part.top, rig.snapshot()))
    assert ends[0] == ends[1] == ends[2]
    assert len(ends[0][1]) == 2


def test_a_motion_that_goes_on_meanwhile_meets_the_machine_as_write_by_write() -> None:
    ends = []
    recorder = Recorder()
    PulseGenerator(recorder).step((650, -200, 0, 0, 0, 0), 4800)  # type: ignore[arg-type]
    writes = [(0, 6, 4), *recorder.writes]
    assert writes[-1][0] > WORK
    for cut in (len(writes), 7, 1):
        arm = arm_at(PRESS + BLOCK)
        for k in range(0, len(writes), cut):
            times, latches, nibbles = zip(*writes[k : k + cut], strict=True)
            arm.apply(times, latches, nibbles)
        ends.append((arm.rotors, arm.events, arm.bench.parts["block"].top))
    assert ends[0] == ends[1] == ends[2]
    assert ends[0][2] == pytest.approx(0.5, abs=1e-6)


def test_a_press_lowers_what_is_higher_and_keeps_its_weight_and_foot() -> None:
    arm = arm_at(PRESS + BLOCK)
    arm.apply([0], [6], [4])
    part = arm.bench.parts["block"]
    arm.advance(WORK - 1)
    assert part.top == pytest.approx(1.0, abs=0.001)
    arm.advance(WORK)
    assert part.top == pytest.approx(0.5, abs=1e-6)
    assert (part.weight, part.bottom) == (3.0, pytest.approx(0, abs=1e-6))
    assert part.box.half == pytest.approx((0.25, 0.25, 0.25))
    arm.apply([2 * WORK, 3 * WORK], [6, 6], [0, 4])
    arm.advance(5 * WORK)
    assert part.top == pytest.approx(0.5, abs=1e-6)
    assert arm.events[-1].text == "press has done with block"
    arm.refill()
    assert arm.bench.parts["block"].top == pytest.approx(1.0, abs=0.001)


@pytest.mark.parametrize(
    ("there", "why"),
    [
        ("", "no part is at rest in its nest, or not one alone"),
        (BLOCK + BLOCK.replace("block", "lid").replace("weight", "bottom = 1\nweight"),
         "no part is at rest in its nest, or not one alone"),
        (BLOCK.replace("[9.0, 4.0]", "[9.6, 4.0]"), "no part is at rest in its nest, or not one "
         "alone"),
        (BLOCK + BLOCK.replace("block", "post").replace("[9.0, 4.0]", "[9.95, 4.0]"),
         "post is in the way"),
    ],
)  # fmt: skip
def test_without_one_part_in_its_nest_and_a_free_hood_it_answers_error(
    there: str, why: str
) -> None:
    rig = at_the_cell(PRESS + there)
    printed = run(rig, "10 OUT 158,4:LPRINT INP(152)AND14\n20 OUT 158,0:LPRINT INP(152)AND14\n")
    assert printed == f" {ERROR} \n {IDLE} \n"
    assert [event.text for event in rig.arm.events] == [f"press cannot start: {why}"]


def test_the_hand_in_the_nest_keeps_it_from_starting_and_is_kept_out_while_it_works() -> None:
    arm = arm_at(PRESS + BLOCK)
    arm.move_to(Pose(9.0, 4.0, 0.5, -90.0, 0.0, 1.0))
    arm.apply([0], [6], [4])
    assert answers(arm, 1) == ERROR
    arm.apply([10], [6], [0])
    arm.move_to(Pose(9.0, 4.0, 2.4, -90.0, 0.0, 0.0))
    arm.apply([20], [6], [4])
    assert answers(arm, 21) == BUSY
    generator = PulseGenerator(arm)
    generator.time = 100
    generator.align()
    # Down onto the hood, which opens, and on to the part.
    generator.step((0, 250, 0, 0, 0, 0), 4800)
    texts = [event.text for event in arm.events]
    assert any("shoulder blocked by press hood" in text for text in texts)
    generator.wait(1.0)
    assert answers(arm, generator.time) == DONE


def test_start_taken_back_stops_it_and_the_part_is_as_it_was() -> None:
    arm = arm_at(PRESS + BLOCK)
    arm.apply([0, WORK // 2], [6, 6], [4, 0])
    assert answers(arm, WORK // 2) == IDLE
    assert answers(arm, 2 * WORK) == IDLE
    assert arm.bench.parts["block"].top == pytest.approx(1.0, abs=0.001)
    assert arm.events[-1].text == "press stopped, block as it was"
    assert not press_of(arm).obstacles


def test_parts_put_back_while_it_works_end_its_work() -> None:
    arm = arm_at(PRESS + BLOCK)
    arm.apply([0], [6], [4])
    arm.refill()
    assert answers(arm, 2 * WORK) == IDLE
    assert arm.bench.parts["block"].top == pytest.approx(1.0, abs=0.001)
    assert not any("hood" in name for name in arm.bench.scene.fixed)


@pytest.mark.parametrize(
    ("old", "new", "line"),
    [
        ("start = 2", "", "start: expected a whole number from 0 to 3"),
        ("seconds = 0.75", "seconds = 0", "seconds: expected a number from 0.001 to 3600"),
        ("press = 0.5", "press = 3", "press: expected a number from 0.05 to 2"),
        ("done = 2", "", "done: expected a whole number from 1 to 3"),
        ("done = 2", "done = 0", "done: expected a whole number from 1 to 3"),
        ("done = 2", "done = 1", "done.bit: expected an input bit that no other sensor uses"),
        ("done = 2", "done = { bit = 2, bank = 1 }",
         "done.bank: expected a [selector] in the file, whose bits choose a bank"),
        ("done = 2", "done = { bit = 2, lamp = 1 }",
         "done.lamp: expected nothing by that name; the keys here are name, bit, bank"),
        ("at = [9.0, 4.0]", "at = [1, 1]", "at: expected a free place; it overlaps base"),
        ("size = [1.5, 1.5, 2.0]", "size = [1.5, 2.0]",
         "size: expected 3 numbers from 0.1 to 60"),
        ("error = 3", "lamp = 3", "lamp: expected nothing by that name; the keys here are name, "
         "at, turn, size, height, seconds, press, start, busy, done, error"),
    ],
)  # fmt: skip
def test_a_wrong_machine_is_one_line(old: str, new: str, line: str) -> None:
    assert refusal(PRESS.replace(old, new)) == f"b.toml: machine[1].{line}"
