"""What is on the desk: a program that may be unsaved, a machine that comes back to READY."""

from __future__ import annotations

from pathlib import Path

import pytest

from trs80arm.arm.events import EventKind
from trs80arm.basic.activity import Waiting
from trs80arm.desk.session import Session
from trs80arm.rig import RigSettings


def typed(session: Session, *lines: str) -> None:
    for line in lines:
        session.rig.type(line + "\r")
    session.rig.run_until_waiting(30)


def test_a_program_is_unsaved_until_it_is_saved_and_again_when_changed(tmp_path: Path) -> None:
    session = Session()
    assert not session.unsaved
    typed(session, "10 PRINT 1")
    assert session.unsaved
    session.save(tmp_path / "a.bas")
    assert not session.unsaved
    typed(session, "20 PRINT 2")
    assert session.unsaved
    typed(session, "20")
    assert not session.unsaved
    typed(session, "NEW")
    assert not session.unsaved


def test_a_save_that_fails_leaves_the_program_unsaved(tmp_path: Path) -> None:
    session = Session()
    typed(session, "10 PRINT 1")
    with pytest.raises(OSError, match="No such file"):
        session.save(tmp_path / "nowhere" / "a.bas")
    assert session.unsaved
    assert session.path is None


@pytest.mark.parametrize(
    ("lines", "state"),
    [
        (("10 GOTO 10", "RUN"), Waiting.NOTHING),
        (("10 INPUT A", "RUN"), Waiting.INPUT),
        (("@SET",), Waiting.SET),
        (("AUTO",), Waiting.AUTO),
        (("10 PRINT", "EDIT 10"), Waiting.EDIT),
        (("@STEP 200,2000",), Waiting.NOTHING),
    ],
)
def test_from_wherever_it_is_the_machine_comes_to_its_prompt(
    lines: tuple[str, ...], state: Waiting
) -> None:
    session = Session()
    for line in lines:
        session.rig.type(line + "\r")
    session.rig.run_for(6)
    assert session.rig.waiting is state
    before = session.rig.video.row(0)
    session.ready()
    assert session.rig.waiting is Waiting.COMMAND
    assert session.rig.video.row(0) == before


def test_a_motion_that_is_interrupted_keeps_its_registers() -> None:
    session = Session()
    session.rig.type("@STEP 100,1000\r")
    session.rig.run_for(3)
    session.load_bytes(b"10 REM\n")
    assert session.rig.registers[0] > 100
    assert session.rig.joints == session.rig.registers


def test_switching_off_and_on_forgets_the_program_and_keeps_the_arm() -> None:
    session = Session(RigSettings(ram_kib=32))
    typed(session, "10 REM", "@STEP 50,300")
    pose = session.rig.pose
    session.reset()
    assert session.program == ()
    assert session.rig.pose == pose
    assert session.rig.settings.ram_kib == 32


def test_a_motor_step_at_the_prompt_gives_up_after_a_second() -> None:
    session = Session()
    before = session.time
    assert not session.step_motor()
    assert session.time == pytest.approx(before + 1, abs=0.1)


def test_a_motor_step_of_a_motion_is_one_tick() -> None:
    session = Session()
    session.rig.type("@STEP 1000,20\r")
    session.rig.run_until(lambda rig: rig.registers[0] > 0)
    session.step_motor()
    for _ in range(3):
        before = session.rig.registers[0], session.time
        assert session.step_motor()
        assert session.rig.registers[0] == before[0] + 1
        assert session.time == pytest.approx(before[1] + 0.0312, abs=1e-5)


def test_a_motor_step_that_a_program_makes_with_out_is_found() -> None:
    session = Session()
    session.rig.load_text("10 OUT 152,8\n20 FOR I=1 TO 50:NEXT\n30 OUT 152,12\n40 GOTO 40\n")
    session.rig.type("RUN\r")
    patterns = []
    while session.step_motor():
        patterns.append(session.rig.state.coils[0])
    assert patterns == [8, 12]


def test_a_motor_step_that_is_still_being_typed_is_found() -> None:
    session = Session()
    session.rig.type("@STEP 0,9\r")
    session.run_for(0.7)
    assert session.step_motor()
    assert session.rig.registers[0] == 1


def slipped(session: Session) -> Session:
    """The elbow is driven into its stop."""
    typed(session, "@STEP 50,0,0,-3000")
    session.rig.run_for(20)
    return session


def test_a_slip_is_told_once_with_its_reason() -> None:
    session = slipped(Session())
    slip = session.new_slip()
    assert slip is not None
    assert slip.reason is not None
    assert session.new_slip() is None
    assert session.slip is not None


def test_an_arm_that_lost_nothing_has_nothing_to_tell() -> None:
    session = Session()
    typed(session, "@STEP 50,100")
    session.rig.run_for(5)
    assert session.new_slip() is None
    assert session.slip is None


def test_going_home_puts_arm_parts_and_registers_back_and_keeps_the_program() -> None:
    session = Session()
    before = session.rig.pose
    typed(session, "10 @STEP 50,0,0,-3000", "20 GOTO 10")
    session.rig.type("RUN\r")
    session.rig.run_for(10)
    assert session.new_slip() is not None
    session.go_home()
    assert session.rig.waiting is Waiting.COMMAND
    assert session.rig.pose == before
    assert session.rig.registers == session.rig.joints == (0,) * 6
    assert session.rig.state.slipped == (0,) * 6
    assert [number for number, _ in session.program] == [10, 20]
    assert session.new_slip() is None


def test_going_home_sets_up_the_bench_that_was_set_up(tmp_path: Path) -> None:
    file = tmp_path / "bench.toml"
    file.write_text("[arm]\nat = [6.0, 0.0, 2.0]\npitch = -90.0\n")
    session = Session(bench=file)
    file.unlink()
    slipped(session)
    session.go_home()
    assert session.rig.pose.x == pytest.approx(6.0, abs=0.02)
    assert session.rig.pose.z == pytest.approx(2.0, abs=0.02)


def test_a_second_slip_is_told_after_the_first_was_made_good() -> None:
    session = slipped(Session())
    assert session.new_slip() is not None
    session.go_home()
    assert session.new_slip() is None
    slipped(session)
    assert session.new_slip() is not None


def test_of_slips_that_follow_each_other_the_first_is_told() -> None:
    session = slipped(Session())
    first = session.slip
    typed(session, "@STEP 50,0,1000")
    session.rig.run_for(20)
    assert sum(event.kind is EventKind.SLIP for event in session.rig.events) > 1
    assert first is not None
    assert session.slip is not None
    assert session.slip.number == first.number
