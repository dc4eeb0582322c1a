"""The programs that come along: each does on its bench what its line in the list says.

The end of each run is a golden file: the tube, the registers beside where the joints truly are, the
parts to a hundredth of an inch, the goals. `TRS80ARM_UPDATE_GOLDEN=1` writes them.
"""

from __future__ import annotations

import math
import random
from pathlib import Path

import pytest

from tests.goldens import check_golden
from tests.own_places import PROGRAMS
from tests.slices import elsewhere
from tests.statements import done
from trs80arm import Rig
from trs80arm.arm import EventKind, benchfile
from trs80arm.basic.activity import Waiting
from trs80arm.files import load_program
from trs80arm.operator import Operator, parse_holds

ANSWERS: dict[str, tuple[str, ...]] = {
    "draughts": ("",),
    "table3": ("50", "G"),
    "table3-as-printed": ("50", "G"),
}
"""What is typed at each INPUT."""
SETS = {
    "tower": ("0",),
    "table4": ("0",),
    "table4-as-printed": ("0",),
    "table3": ("0", "W:0.5 0", "1:1 0", "2:0.5 0"),
    "table3-as-printed": ("0", "W:0.5 0", "1:1 0", "2:0.5 0"),
}
"""What is done in each @SET."""
ENDLESS = {
    "table2-demo": 60.0,
    "table3": 60.0,
    "table3-as-printed": 60.0,
    "table4": 60.0,
    "table4-as-printed": 8.0,
}
"""Tasks that go on for ever, and after how many virtual seconds they are looked at."""
SLIPPING = {"homing"}
"""Programs that lose steps on purpose, and find them again."""
SENSING = ("guarded", "homing")
"""Programs that go by what sensors say."""
THERE_AND_BACK = {"tower"}
"""Programs at whose end all is where it was."""
BENCHES = sorted(path.stem for path in PROGRAMS.glob("*.toml"))
WITH_GOALS = [name for name in BENCHES if "[[goal]]" in (PROGRAMS / f"{name}.toml").read_text()]
LONGEST = 600.0
"""Virtual seconds that a program may take."""
ARM_SOLUTION = range(5000, 6011)
"""The lines of Table 4's subroutine."""


def end_of(name: str) -> Rig:
    """A rig when a program has ended on its bench."""
    rig = Rig(bench=benchfile.load(PROGRAMS / f"{name}.toml"))
    rig.load(PROGRAMS / f"{name}.bas")
    rig.type("RUN\r")
    sets = [parse_holds(holds) for holds in SETS.get(name, ())]
    waiting = Operator(rig, ANSWERS.get(name, ()), sets).run(ENDLESS.get(name, LONGEST))
    assert waiting is (Waiting.NOTHING if name in ENDLESS else Waiting.COMMAND)
    return rig


def told(rig: Rig) -> str:
    """The end of a run as text."""
    joints = [
        f"{name:<12} {register:>6} {true:>6}"
        for name, register, true in zip(rig.joint_names, rig.registers, rig.joints, strict=True)
    ]
    bench = rig.arm.bench
    parts = [
        f"{name:<12} " + " ".join(f"{round(value, 2) + 0.0:6.2f}" for value in part.origin)
        for name, part in bench.parts.items()
    ]
    trays = [f"{tray.name}: {tray.taken} taken" for tray in bench.trays]
    # How far off each part is follows from its place, and is held to it below.
    marks = [f"{'met' if mark.met else 'NOT'}  {mark.goal}" for mark in rig.score().marks]
    return "\n".join([*rig.screen(), "", *joints, "", *parts, *trays, *marks, ""])


@pytest.mark.parametrize("name", BENCHES)
def test_its_end_is_the_recorded_one_and_its_goals_are_met(name: str) -> None:
    rig = end_of(name)
    check_golden(f"program-{name}", told(rig))
    if rig.arm.bench.goals:
        assert rig.outcome is not None
        assert rig.outcome.ending.value == "end"
        assert rig.score().perfect
        assert rig.state.slipped == (0,) * 6 or name in SLIPPING
        assert not [event for event in rig.arm.events if event.kind is EventKind.DROPPED]
        assert_the_score_agrees_with_the_parts(rig)


def assert_the_score_agrees_with_the_parts(rig: Rig) -> None:
    """The errors told are distances from where the corners of the parts are."""
    places = [place for goal in rig.arm.bench.goals for place in getattr(goal, "places", ())]
    marks = [mark for mark in rig.score().marks if mark.error is not None]
    assert len(marks) == len(places)
    for mark, place in zip(marks, places, strict=True):
        placed = rig.arm.bench.parts[mark.part].placed
        corners = [corner for solid in placed for corner in solid.vertices]
        middle = [(min(values) + max(values)) / 2 for values in zip(*corners, strict=True)]
        assert mark.error == pytest.approx(math.dist(middle[: len(place)], place), abs=1e-6)


@pytest.mark.parametrize("name", SENSING)
def test_what_sensors_say_does_not_hang_on_how_time_is_sliced(name: str) -> None:
    chance = random.Random(name)
    rig = Rig(bench=benchfile.load(PROGRAMS / f"{name}.toml"))
    rig.load(PROGRAMS / f"{name}.bas")
    rig.type("RUN\r")
    rig.run_for(1.0)
    while rig.outcome is None:
        rig.run_for(chance.choice([0.0001, 0.01, 1.0, 3.0]))
        if chance.random() < 0.02:
            rig = elsewhere(rig)
    rig.run_until_waiting()
    check_golden(f"program-{name}", told(rig))


def test_programs_that_run_by_turns_in_one_process_come_to_what_each_does_alone() -> None:
    # So nothing is shared by rigs, and in which order or beside what a test runs is all the same.
    chance, rigs = random.Random("turns"), {}
    for name in ("pegs", "tending", "half-steps"):
        rigs[name] = Rig(bench=benchfile.load(PROGRAMS / f"{name}.toml"))
        rigs[name].load(PROGRAMS / f"{name}.bas")
        rigs[name].type("RUN\r")
        rigs[name].run_for(1.0)
    while working := [rig for rig in rigs.values() if rig.outcome is None]:
        chance.choice(working).run_for(chance.choice([0.01, 0.3, 2.0]))
    for name, rig in rigs.items():
        rig.run_until_waiting()
        check_golden(f"program-{name}", told(rig))


@pytest.mark.parametrize("name", sorted({*WITH_GOALS} - THERE_AND_BACK))
def test_before_it_has_run_its_goals_are_not_all_met(name: str) -> None:
    # Or the score would say nothing of the program.
    assert not Rig(bench=benchfile.load(PROGRAMS / f"{name}.toml")).score().perfect


@pytest.mark.parametrize("path", sorted(PROGRAMS.glob("*.bas")), ids=lambda path: path.stem)
def test_the_arm_solution_is_the_article_s_line_for_line(path: Path) -> None:
    article = dict(load_program(PROGRAMS / "table4.bas"))
    lines = dict(load_program(path))
    if 5180 in lines:
        shared = [number for number in ARM_SOLUTION if number in article]
        assert [lines.get(number) for number in shared] == [article[n] for n in shared]


def test_draughts_takes_typed_moves_and_refuses_those_that_cannot_be() -> None:
    rig = Rig(bench=benchfile.load(PROGRAMS / "draughts.toml"))
    rig.load(PROGRAMS / "draughts.bas")
    done(rig, '310 DATA ""')
    printed = bytearray()
    rig.listen(lambda code, is_echo: None if is_echo else printed.append(code))
    rig.type("RUN\r")
    moves = ("Z9-A1", "A1", "D4-E5", "A1-B9", "A1XC3", "A1-E3", "G5-H6", "B4XD6", "")
    assert Operator(rig, moves).run(LONGEST) is Waiting.COMMAND
    said = [line.strip() for line in printed.decode("latin-1").split("\r")]
    assert [line for line in said if line.startswith("NO")] == [
        "NOBODY IS ON Z9",
        "NOT FREE:",
        "NOBODY IS ON D4",
        "NOT FREE: B9",
        "NOBODY TO TAKE",
        "NOT FREE: E3",
    ]
    parts = rig.arm.bench.parts
    assert parts["white 3"].origin[:2] == pytest.approx((10, -3.5), abs=0.03)
    assert parts["white 1"].origin[:2] == pytest.approx((10, 0.5), abs=0.03)
    assert parts["black 1"].origin[:2] == pytest.approx((6.2, 5.4), abs=0.03)
