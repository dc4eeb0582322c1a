"""Saved states: the whole machine by name."""

from __future__ import annotations

from pathlib import Path

import pytest

from trs80arm.desk import recording
from trs80arm.desk.session import Session
from trs80arm.desk.states import BEFORE, QUICK, StateError, States


@pytest.fixture
def states(tmp_path: Path) -> States:
    return States(tmp_path / "states")


def running(listing: str = "10 A=A+1\n20 @STEP 9,30\n30 GOTO 10\n") -> Session:
    session = Session()
    session.rig.load_text(listing)
    session.rig.type("RUN\r")
    session.run_for(1)
    return session


def test_a_state_is_the_machine_to_the_last_bit(states: States) -> None:
    session = running()
    before = session.rig.snapshot()
    states.save("one", session)
    session.run_for(1)
    states.load("one", session)
    assert session.rig.snapshot() == before


def test_a_state_is_loaded_at_another_desk(states: States) -> None:
    session = running()
    states.save("one", session)
    other = Session()
    states.load("one", other)
    assert other.rig.snapshot() == session.rig.snapshot()


def test_the_list_says_when_and_where(states: States) -> None:
    states.save("idle", Session())
    states.save(QUICK, running())
    lines = {state.name: state.line for state in states.all()}
    assert lines["idle"] == ""
    assert lines[QUICK].split(":")[0] in ("10", "20", "30")
    assert all(state.saved > 1_000_000_000 for state in states.all())


def test_a_state_is_removed(states: States) -> None:
    states.save("one", Session())
    states.delete("one")
    assert not states.all()
    with pytest.raises(StateError, match="no state 'one'"):
        states.delete("one")


@pytest.mark.parametrize("name", ["", "../x", "a/b", "nul", ".hidden", "x" * 50, "a\nb", "x."])
def test_what_could_be_another_file_is_no_name(states: States, name: str) -> None:
    with pytest.raises(StateError, match="a name has"):
        states.save(name, Session())


@pytest.mark.parametrize(
    "spoil",
    [
        lambda data: b"",
        lambda data: data[:-5],
        lambda data: b"{}" + data,
        lambda data: data.replace(b"trs80arm state 1", b"trs80arm state 9"),
        lambda data: data.replace(b'"recording": ', b'"recording": 9'),
        lambda data: data.replace(b'"do": "type"', b'"do": "shoo"'),
        lambda data: b"\xff\xfe" + data,
    ],
)
def test_a_bad_file_is_one_clear_line_and_changes_nothing(
    states: States, tmp_path: Path, spoil: object
) -> None:
    session = running()
    states.save("one", session)
    path = tmp_path / "states" / "one.state"
    assert callable(spoil)
    path.write_bytes(spoil(path.read_bytes()))
    before = session.rig.snapshot()
    with pytest.raises(StateError) as told:
        states.load("one", session)
    assert str(told.value).startswith("one.state: ")
    assert "\n" not in str(told.value)
    assert session.rig.snapshot() == before


def test_a_session_that_goes_on_from_a_state_can_be_recorded(states: States) -> None:
    states.save("one", running())
    session = Session()
    states.load("one", session)
    session.rig.hold(["BREAK"], 0.1)
    session.run_for(1)
    played = recording.parse("\n".join(session.recorded).encode())
    rig = played.rig()
    rig.replay(played.inputs)
    for each in (rig, session.rig):
        each.run_to(session.rig.clock.now + 1000)
    assert rig.snapshot() == session.rig.snapshot()


def test_a_state_of_a_machine_that_went_back_is_saved_as_it_is(states: States) -> None:
    session = running()
    session.timeline.back()
    there = session.rig.snapshot()
    states.save("one", session)
    session.run_for(1)
    states.load("one", session)
    assert session.rig.snapshot() == there
    assert not session.timeline.behind


def test_the_machine_that_goes_is_kept(states: States) -> None:
    session = running("10 A=A+1:GOTO 10\n")
    states.save("one", Session())
    gone = session.rig.snapshot()
    states.load("one", session)
    states.load(BEFORE, session)
    assert session.rig.snapshot() == gone
