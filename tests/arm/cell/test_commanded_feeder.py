"""A feeder that gives on command, driven from BASIC by OUT and INP alone."""

from __future__ import annotations

import pytest

from tests.arm.cell.cells import arm_at, at_the_cell, run, started
from tests.arm.refusals import refusal
from tests.slices import sliced
from trs80arm.arm.contact.clock import T_STATES_PER_SECOND
from trs80arm.arm.minimover import Pose

FEEDER = """
[[feeder]]
name = "blanks"
at = [8.0, -3.0]
size = [0.5, 0.5, 1.0]
count = 2
give = 1
there = 2
"""
BELT = """
[[conveyor]]
name = "belt"
at = [8.0, -3.0]
length = 8.0
width = 2.0
height = 0.5
speed = 2.0
run = 0
"""
ON_THE_BELT = FEEDER.replace("[8.0, -3.0]", "[5.0, -3.0]\nbottom = 0.5")


def test_it_gives_on_a_rising_edge_and_answers_that_a_part_is_there() -> None:
    rig = at_the_cell(FEEDER)
    printed = run(
        rig,
        """10 LPRINT INP(152)AND4
20 OUT 158,2:LPRINT INP(152)AND4
30 OUT 158,0:LPRINT INP(152)AND4
40 OUT 158,2:OUT 158,3
""",
    )
    assert printed == " 4 \n 0 \n 0 \n"
    assert list(rig.arm.bench.parts) == ["blanks 1"]
    assert [event.text for event in rig.arm.events] == [
        "blanks gives blanks 1",
        "blanks cannot give: blanks 1 is at its place",
    ]


def test_it_ignores_the_command_while_the_hand_is_at_its_place() -> None:
    arm = arm_at(FEEDER)
    arm.move_to(Pose(8.0, -3.0, 0.5, -90.0, 0.0))
    arm.apply([0], [6], [2])
    assert not arm.bench.parts
    arm.move_to(Pose(8.0, 0.0, 3.0, -90.0, 0.0))
    arm.advance(T_STATES_PER_SECOND)
    assert not arm.bench.parts, "the command is not remembered"
    arm.apply([2 * T_STATES_PER_SECOND, 2 * T_STATES_PER_SECOND + 5], [6, 6], [0, 2])
    assert list(arm.bench.parts) == ["blanks 1"]


def test_parts_given_onto_a_running_belt_go_along_until_it_is_empty() -> None:
    rig = at_the_cell(BELT + ON_THE_BELT)
    printed = run(
        rig,
        """10 OUT 158,1
20 FOR I=1 TO 3:OUT 158,3:OUT 158,1
30 IF (INP(152)AND4)=0 THEN 30
40 NEXT:OUT 158,0:LPRINT"OUT"
""",
    )
    assert printed == "OUT\n"
    rig.run_for(1)
    first, second = rig.arm.bench.parts.values()
    assert first.place[0] > second.place[0] + 0.5
    assert {round(part.bottom, 2) for part in (first, second)} == {0.5}
    assert "blanks is empty" in [event.text for event in rig.arm.events]


def test_feeding_is_the_same_whole_and_sliced_with_snapshots_between() -> None:
    program = "10 OUT 158,1\n20 OUT 158,3:OUT 158,1:FOR I=1 TO 200:NEXT:GOTO 20\n"
    ends = []
    for in_slices in (False, True):
        rig = started(at_the_cell(BELT + ON_THE_BELT), program)
        if in_slices:
            rig = sliced(rig, (0.1 + 0.017 * k for k in range(12)), range(3, 12, 4))
        rig.run_to(5 * T_STATES_PER_SECOND)
        parts = [(part.name, part.place) for part in rig.arm.bench.parts.values()]
        ends.append((parts, rig.arm.events, rig.snapshot()))
    assert ends[0] == ends[1]
    assert len(ends[0][0]) == 2


def test_parts_put_back_fill_it_again_and_it_waits_for_its_command() -> None:
    arm = arm_at(FEEDER)
    arm.apply([0, 5], [6, 6], [2, 0])
    arm.refill()
    assert not arm.bench.parts
    arm.apply([10], [6], [2])
    assert list(arm.bench.parts) == ["blanks 1"]


@pytest.mark.parametrize(
    ("old", "new", "line"),
    [
        ("give = 1", "give = 7", "give: expected a whole number from 0 to 3"),
        ("give = 1", "", "there: expected nothing by that name; the keys here are name, at, "
         "bottom, turn, shape, size, weight, friction, count, give"),
        ("there = 2", "there = 'yes'", "there: expected a whole number from 1 to 3"),
        ("bottom = 0.5", "bottom = -1", "bottom: expected a number from 0 to 60"),
        ("bottom = 0.5", "bottom = 0.4", "at: expected a free place; it overlaps belt"),
    ],
)  # fmt: skip
def test_a_wrong_command_is_one_line(old: str, new: str, line: str) -> None:
    assert refusal(BELT + ON_THE_BELT.replace(old, new)) == f"b.toml: feeder[1].{line}"
