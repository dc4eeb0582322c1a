"""What the teaching helper writes is loaded into the machine and moves the parts."""

from __future__ import annotations

from pathlib import Path

import pytest

from trs80arm.arm import benchfile
from trs80arm.arm.events import EventKind
from trs80arm.arm.models import MINIMOVER5
from trs80arm.basic.activity import Waiting
from trs80arm.desk.taught_programs import Manner, in_data, in_steps
from trs80arm.desk.teach import Lesson
from trs80arm.drawing.readings import Readings
from trs80arm.rig import Rig

BENCH = Path(__file__).parents[2] / "programs" / "table4.toml"
TEACH = "teach this position"
SESSION = (
    *("@STEP 50,0,-207,290,0,0,340", TEACH, "@STEP 50,0,132,-36", TEACH),
    *("@CLOSE", "@STEP 100,0,0,0,0,0,-30", TEACH, "@STEP 100,0,-132,36", TEACH),
    *("@STEP 50,651,-8,-13,-461,-462", TEACH, "@STEP 50,0,135,-37", TEACH),
    *("@STEP 50,0,0,0,0,0,342", TEACH, "@STEP 50,0,-135,37", TEACH),
)


def taught() -> tuple[Rig, Lesson]:
    """An arm led once through the article's task, and what it was taught on the way."""
    rig, lesson = Rig(bench=benchfile.load(BENCH)), Lesson()
    for line in SESSION:
        if line is TEACH:
            lesson.add(Readings.of(rig))
        else:
            rig.type(line + "\r")
            rig.run_until_waiting()
    return rig, lesson


def parts_taken(rig: Rig) -> int:
    return sum(tray.taken for tray in rig.arm.bench.trays)


def slips(rig: Rig) -> list[str]:
    return [event.text for event in rig.arm.events if event.kind is EventKind.SLIP]


@pytest.fixture(scope="module")
def lesson() -> Lesson:
    return taught()[1]


def test_the_steps_carry_on_where_the_teaching_ended() -> None:
    rig, lesson = taught()
    before = parts_taken(rig)
    rig.load_text(in_steps(lesson.positions, Manner(speed=60, repeats=True)))
    rig.type("RUN\r")
    assert rig.run_until(lambda rig: parts_taken(rig) == before + 2, seconds=40)
    assert slips(rig) == []
    assert rig.registers == rig.joints


def test_the_data_lines_begin_where_the_arm_stands_when_it_is_switched_on(lesson: Lesson) -> None:
    rig = Rig(bench=benchfile.load(BENCH))
    rig.load_text(in_data(lesson.positions, Manner(speed=60, repeats=True), MINIMOVER5))
    rig.type("RUN\r")
    assert rig.run_until(lambda rig: rig.waiting is Waiting.SET)
    assert " X =  5 INCHES" in rig.screen()
    rig.run_for(0.1)
    rig.hold(["0"], 0.2)
    assert rig.run_until(lambda rig: parts_taken(rig) == 2, seconds=60)
    assert slips(rig) == []


def test_a_program_that_goes_once_ends(lesson: Lesson) -> None:
    rig = Rig(bench=benchfile.load(BENCH))
    rig.load_text(in_steps(lesson.positions, Manner()))
    rig.type("RUN\r")
    rig.run_until_waiting(60)
    assert rig.waiting is Waiting.COMMAND
    assert parts_taken(rig) == 1
    assert rig.registers[:5] == lesson.positions[-1].registers[:5]
