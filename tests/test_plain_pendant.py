"""The teach pendant in lines: a task is taught without a screen, and runs on any machine."""

from __future__ import annotations

import io
from pathlib import Path

import pytest

from tests.own_places import own_places
from tests.ui.test_pendant_screen import assert_runs_without_a_pendant, block
from trs80arm.desk.session import Session
from trs80arm.plain.mode import PlainMode

__all__ = ["own_places"]

TASK = (
    *(".width 1.5", ".jog z 2", ".jog x 3", ".teach above", ".jog z -1.5", ".grip", ".teach hold"),
    *(".jog z 1.5", ".teach", ".jog y 4", ".teach", ".jog z -1.5", ".width 1.5", ".teach let go"),
    *(".jog z 1.5", ".teach"),
)


def talk(*lines: str, session: Session | None = None) -> str:
    """What is printed when these lines are typed."""
    out = io.StringIO()
    plain = PlainMode(session or Session(), out, echo=False, speed=None)
    assert plain.talk(iter(f"{line}\n" for line in lines)) == 0
    return out.getvalue()


def test_a_task_is_taught_played_written_and_read_back(tmp_path: Path) -> None:
    session = Session()
    steps, data = tmp_path / "steps.bas", tmp_path / "data.bas"
    said = talk(
        *TASK,
        ".parts back",
        ".through",
        f".write {steps} steps",
        f".write {data} data",
        ".backward",
        ".forward",
        ".to 6",
        f".read {data}",
        session=session,
    )
    assert session.time < 180
    assert ">@STEP 50,0,-39,8\n" in said
    assert ">@CLOSE\n" in said
    assert "Position 2, HOLD, is taught, the hand holds." in said
    assert block(session.rig) == (8.0, 4.0, 0.5)
    assert "2 HOLD: X 8.00, Y 0.00, Z 0.50" in said
    for listing in (steps, data):
        assert_runs_without_a_pendant(listing.read_text())


def test_every_way_has_a_name() -> None:
    session = Session()
    talk(".jog z 2", ".jog along -0.5", ".jog pitch 10", ".jog left wrist 40", session=session)
    pose = session.rig.pose
    assert pose.z == pytest.approx(2.5, abs=0.2)
    assert pose.pitch == pytest.approx(-80 - 40 / 203.7 / 2 * 57.3, abs=0.5)


@pytest.mark.parametrize(
    ("line", "told"),
    [
        (".jog up 1", "Which way, and how far?"),
        (".jog z", "Which way, and how far?"),
        (".jog z -1", "No farther: the fingertip would be"),
        (".width wide", "How wide, in inches?"),
        (".width 4", "The hand opens 0 to 3 inches."),
        (".to A", "To which position?"),
        (".forward", "There is no point yet."),
        (".through", "There is no point yet."),
        (".delay fast", "D is a number from 0 to 32767."),
        (".read memory", "There is no @STEP in the listing."),
        (".read nowhere.bas", "nowhere.bas: No such file"),
    ],
)
def test_what_cannot_be_done_is_said(line: str, told: str) -> None:
    assert told in talk(line)


def test_points_have_words_and_a_speed(tmp_path: Path) -> None:
    said = talk(
        ".delay 80", ".jog z 1", ".teach", ".comment 1 over it", ".holds 1", ".lesson", "LIST 110"
    )
    assert ">@STEP 80,0,-39,8" in said
    assert "; OVER IT" in said
    assert "hand holds" in said
    assert "110 REM TO A FROM WHEREVER THE ARM IS: OVER IT" in said


def test_a_program_that_runs_is_not_disturbed() -> None:
    session = Session()
    session.rig.load_text("10 INPUT A\n")
    said = talk("RUN", ".jog z 1", session=session)
    assert "A program waits for INPUT: stop it first." in said
