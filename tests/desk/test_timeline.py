"""The way back and forward again: files are written once, recordings stay true."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import pytest

from tests.own_places import PROGRAMS
from trs80arm.arm.settings import ArmSettings
from trs80arm.desk import recording, timeline
from trs80arm.desk.debugger import Debugger
from trs80arm.desk.session import Session
from trs80arm.rig import Key, RigSettings, Waiting


def session_with(listing: str, settings: RigSettings | None = None, **options: Path) -> Session:
    """A session whose program runs up to where it waits or for some seconds."""
    session = Session(settings, **options)
    session.rig.load_text(listing)
    session.rig.type("RUN\r")
    return session


def run(session: Session, seconds: float) -> None:
    for _ in range(round(seconds * 2)):
        session.run_for(0.5)
        session.timeline.mark()


def test_paper_is_not_printed_twice(tmp_path: Path) -> None:
    paper = tmp_path / "paper.txt"
    listing = '10 FOR I=1 TO 5\n20 LPRINT "LINE";I\n30 NEXT\n40 GOTO 40\n'
    session = session_with(listing, RigSettings(printer_file=paper))
    debugger = Debugger(session)
    debugger.set(20, "I=2")
    run(session, 3)
    debugger.go()
    debugger.clear()
    run(session, 2)
    printed = paper.read_text()
    assert printed.count("LINE") == 5
    debugger.set(20, "I=2")
    assert debugger.back_to_stop()
    assert session.rig.printer.text.count("LINE") == 1
    debugger.go()
    debugger.clear()
    run(session, 4)
    assert paper.read_text() == printed
    assert session.rig.printer.text.count("LINE") == 5


def test_a_tape_is_what_it_was_and_is_not_recorded_twice(tmp_path: Path) -> None:
    listing = "10 FOR I=1 TO 2\n20 PRINT#-1,I\n30 NEXT\n40 GOTO 40\n"
    session = session_with(listing, RigSettings(tape_folder=tmp_path))
    debugger = Debugger(session)
    run(session, 12)
    tape = tmp_path / "data.cas"
    recorded = tape.read_bytes()
    debugger.set(20, "I=2")
    assert debugger.back_to_stop()
    once = session.rig.tape.length
    assert 0 < once < len(recorded)
    assert session.rig.tape._shelf.load("data") == recorded[:once]
    debugger.go()
    debugger.clear()
    run(session, 12)
    assert tape.read_bytes() == recorded
    assert session.rig.tape._shelf.load("data") == recorded


def test_a_recording_forgets_what_was_undone(tmp_path: Path) -> None:
    target = tmp_path / "session.jsonl"
    session = session_with("10 INPUT A\n20 B=A\n30 GOTO 30\n", record=target)
    debugger = Debugger(session)
    run(session, 1)
    session.rig.type("21\r")
    run(session, 1)
    debugger.set(20)
    assert debugger.back_to_stop()
    assert debugger.back()
    assert '"21' not in target.read_text()
    debugger.go()
    debugger.clear()
    session.rig.type("7\r")
    run(session, 1)
    session.close()
    played = recording.load(target)
    rig = played.rig()
    rig.replay(played.inputs)
    for each in (rig, session.rig):
        each.run_to(session.rig.clock.now + 1000)
    assert rig.snapshot() == session.rig.snapshot()


def test_a_key_that_the_future_would_let_go_is_let_go() -> None:
    session = session_with("10 A=1\n20 A=A+1:GOTO 20\n")
    run(session, 0.5)
    session.rig.press(Key.A)
    run(session, 0.5)
    session.rig.release(Key.A)
    assert session.timeline.back(lambda rig, address: Key.A in rig.held)
    session.rig.change("B=1")
    session.rig.run_for(0.1)
    assert Key.A not in session.rig.held


def test_marks_are_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(timeline, "MOST", 12)
    session = session_with("10 GOTO 10\n")
    for _ in range(3 * timeline.MOST):
        session.run_for(0.3)
        session.timeline.mark()
    marks = session.timeline._marks
    assert len(marks) <= timeline.MOST
    gaps = [later.time - earlier.time for earlier, later in pairwise(marks)]
    assert gaps[-1] < gaps[1]
    assert session.timeline.back()


@pytest.mark.parametrize(
    ("model", "bench", "greeting"),
    [("minimover5", None, True), ("minimover5", "sort.toml", False), ("teachmover", None, False)],
)
def test_the_beginning_is_had_again_as_it_was(
    tmp_path: Path, model: str, bench: str | None, greeting: bool
) -> None:
    settings = RigSettings(
        tape_folder=tmp_path, printer_file=tmp_path / "paper.txt", arm=ArmSettings(model=model)
    )
    session = Session(settings, PROGRAMS / bench if bench else None, greeting=greeting)
    began = session.rig.snapshot()
    session.rig.load_text('10 LPRINT "A"\n20 PRINT#-1,5\n30 @STEP 50,40\n40 GOTO 40\n')
    session.rig.type("RUN\r")
    run(session, 12)
    kept = sorted(tmp_path.iterdir())
    past = session.timeline._past(0)
    assert past.done == 0
    assert past.rig.snapshot() == began
    assert sorted(tmp_path.iterdir()) == kept


def test_back_at_the_prompt_leads_to_the_last_statement() -> None:
    session = session_with("10 A=1\n20 END\n")
    session.rig.run_until_waiting()
    assert session.waiting is Waiting.COMMAND
    assert Debugger(session).back()
    assert session.rig.basic.next_line == 20


def test_who_listens_hears_nothing_of_the_way_back() -> None:
    session = session_with('10 PRINT "X";\n20 GOTO 10\n')
    run(session, 0.5)
    heard: list[int] = []
    session.rig.listen(lambda code, echo: heard.append(code))
    assert session.timeline.back()
    assert not heard
    run(session, 0.5)
    assert heard
