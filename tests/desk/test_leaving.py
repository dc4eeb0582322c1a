"""Leaving asks for what is unsaved; recovery copies come and go with it."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from tests.desk.sitting import NOTHING, Sitting
from trs80arm.desk.leaving import LESSON_UNWRITTEN, PROGRAM_UNSAVED
from trs80arm.desk.recovery import Recovery
from trs80arm.desk.session import Session
from trs80arm.desk.teach import Lesson
from trs80arm.drawing.readings import Readings
from trs80arm.files import load_program


def teach(desk: Sitting) -> None:
    desk.lesson.add(Readings.of(desk.session.rig))


def test_nothing_unsaved_leaves_at_once(sitting: Sitting) -> None:
    sitting.leaving.leave()
    assert sitting.ended == ["left"]
    assert sitting.person.asked == []


def test_an_unsaved_program_is_asked_about(sitting: Sitting) -> None:
    sitting.type("10 REM MINE")
    sitting.answer("stay")
    sitting.leaving.leave()
    assert sitting.person.asked == [PROGRAM_UNSAVED]
    assert sitting.ended == []


def test_saving_leaves_afterwards(sitting: Sitting) -> None:
    sitting.type("10 REM MINE")
    sitting.answer("save", sitting.folder / "mine.bas")
    sitting.leaving.leave()
    assert sitting.ended == ["left"]
    assert (sitting.folder / "mine.bas").read_text() == "10 REM MINE\n"


def test_a_save_that_fails_does_not_leave(sitting: Sitting) -> None:
    sitting.type("10 REM MINE")
    sitting.answer("save", sitting.folder / "nowhere" / "mine.bas")
    sitting.leaving.leave()
    assert sitting.ended == []
    assert len(sitting.person.errors) == 1


def test_giving_the_program_up_leaves_no_copy(sitting: Sitting) -> None:
    sitting.type("10 REM MINE")
    sitting.recovery.keep()
    sitting.answer("go")
    sitting.leaving.leave()
    assert sitting.ended == ["left"]
    assert list(sitting.recovery.kept()) == []


def test_positions_without_a_program_of_them_are_asked_about(sitting: Sitting) -> None:
    teach(sitting)
    sitting.answer("teach")
    sitting.leaving.leave()
    assert sitting.person.asked == [LESSON_UNWRITTEN]
    assert sitting.ended == ["taught"]


def test_asked_to_leave_while_asking_it_leaves_and_keeps_copies(sitting: Sitting) -> None:
    sitting.type("10 REM MINE")
    teach(sitting)
    sitting.answer(NOTHING)
    sitting.leaving.leave()
    assert sitting.ended == []
    sitting.leaving.leave()
    assert sitting.ended == ["left"]
    assert [path for _, path in sitting.recovery.kept()] == [
        sitting.recovery.program_copy,
        sitting.recovery.lesson_copy,
    ]
    assert load_program(sitting.recovery.program_copy) == list(sitting.session.program)
    assert "@READ K1" in sitting.recovery.lesson_copy.read_text()


def test_where_no_copy_can_be_kept_asking_twice_does_not_leave(tmp_path: Path) -> None:
    (tmp_path / "state").write_text("a file where a folder should be")
    desk = Sitting(tmp_path)
    desk.type("10 REM MINE")
    desk.answer(NOTHING)
    desk.leaving.leave()
    desk.leaving.leave()
    desk.leaving.leave()
    assert desk.ended == []
    assert [error.partition(":")[0] for error in desk.person.errors] == [
        f"No recovery copy in {tmp_path / 'state'}"
    ] * 2


def test_a_copy_that_cannot_be_kept_is_told_once(tmp_path: Path) -> None:
    (tmp_path / "state").write_text("a file where a folder should be")
    desk = Sitting(tmp_path)
    desk.type("10 REM MINE")
    assert [desk.recovery.keep() for _ in range(3)] == [False, False, False]
    assert len(desk.person.errors) == 1


def test_copies_come_and_go_with_what_is_unsaved(sitting: Sitting) -> None:
    assert sitting.recovery.keep()
    assert list(sitting.recovery.kept()) == []
    sitting.type("10 REM MINE")
    teach(sitting)
    sitting.recovery.keep()
    assert len(list(sitting.recovery.kept())) == 2
    sitting.session.save(sitting.folder / "mine.bas")
    sitting.lesson.written()
    sitting.recovery.keep()
    assert list(sitting.recovery.kept()) == []


@pytest.mark.parametrize(
    "name", ["recovered-20200101-000000-9", "recovered-20200101-000000-9-taught"]
)
def test_only_copies_of_other_sittings_are_left_over(sitting: Sitting, name: str) -> None:
    sitting.type("10 REM MINE")
    teach(sitting)
    sitting.recovery.keep()
    other = sitting.state / f"{name}.bas"
    other.write_text("10 REM LOST\n")
    assert sitting.recovery.left_over() == [other]


def test_copies_of_a_sitting_that_goes_on_are_nobody_elses(sitting: Sitting) -> None:
    sitting.type("10 REM MINE")
    teach(sitting)
    sitting.recovery.keep()
    kept = {sitting.recovery.program_copy, sitting.recovery.lesson_copy}
    other = Recovery(Session(), Lesson(), sitting.state, "20260101-120000-12", sitting.person.say)
    assert other.left_over() == []
    for path in kept:
        other.discard(path)
        assert path.is_file()
    # Its number begins like this sitting's, which ends now without a word.
    sitting.recovery.let_go()
    assert set(other.left_over()) == kept
    for path in kept:
        other.discard(path)
    assert list(sitting.state.iterdir()) == []


KILLED = """
import sys, time
from pathlib import Path
from trs80arm.desk.recovery import Recovery
from trs80arm.desk.session import Session
from trs80arm.desk.teach import Lesson
session = Session()
session.rig.load_text("10 REM KEPT")
recovery = Recovery(session, Lesson(), Path(sys.argv[1]), "20260101-000000-5", print)
print(recovery.keep(), flush=True)
time.sleep(600)
"""


def test_a_killed_sitting_leaves_its_copy_to_the_next(sitting: Sitting) -> None:
    with subprocess.Popen(
        [sys.executable, "-c", KILLED, str(sitting.state)], stdout=subprocess.PIPE
    ) as running:
        assert running.stdout is not None
        assert running.stdout.readline() == b"True\n"
        assert sitting.recovery.left_over() == []
        running.kill()
    (left,) = sitting.recovery.left_over()
    assert left.name == "recovered-20260101-000000-5.bas"
