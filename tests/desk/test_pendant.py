"""The pendant drives the arm by what it types, whatever the machine is doing."""

from __future__ import annotations

import pytest

from trs80arm.arm.settings import ArmSettings
from trs80arm.desk.jogging import Coordinates
from trs80arm.desk.pendant import Pendant
from trs80arm.desk.session import Session
from trs80arm.desk.teach import Lesson
from trs80arm.rig import Input, Rig, RigSettings, Waiting

X, Y, Z, PITCH, ROLL, HAND = range(6)
FRAME = 1 / 60


def finish(pendant: Pendant, session: Session, seconds: float = 300.0) -> None:
    """Let it do all that is to be done."""
    end = session.time + seconds
    while pendant.busy and session.time < end:
        pendant.go_on()
        session.run_for(FRAME)


class Bench:
    """A session with a pendant."""

    def __init__(self, settings: RigSettings | None = None) -> None:
        self.session = Session(settings)
        self.pendant = Pendant(self.session, Lesson())

    def finish(self) -> None:
        finish(self.pendant, self.session)

    def by(self, axis: int, amount: float) -> None:
        self.pendant.move_by(axis, amount)
        self.finish()

    def press(self, axis: int, way: int, seconds: float = 0.0) -> None:
        self.pendant.press(axis, way)
        if seconds:
            self.pendant.hold(axis, way)
        end = self.session.time + seconds
        while self.session.time < end:
            self.pendant.go_on()
            self.session.run_for(FRAME)
        self.pendant.release(axis, way)
        self.finish()

    def taught(self) -> list[str]:
        """Pick the part up at (8, 0) and put it down at (8, 4)."""
        pendant = self.pendant
        pendant.open_to(1.2)
        self.finish()
        for axis, amount in ((Z, 2), (X, 3), (Z, -1.5)):
            self.by(axis, amount)
            pendant.teach()
        pendant.close()
        self.finish()
        pendant.teach()
        for axis, amount in ((Z, 1.5), (Y, 4), (Z, -1.47)):
            self.by(axis, amount)
            pendant.teach()
        pendant.open_to(1.2)
        self.finish()
        pendant.teach()
        self.by(Z, 1.5)
        pendant.teach()
        return [position.name for position in pendant.lesson.positions]

    @property
    def block(self) -> tuple[float, ...]:
        return tuple(round(value, 1) for value in self.session.rig.arm.bench.parts["block"].place)


@pytest.fixture
def bench() -> Bench:
    return Bench()


def test_a_press_is_one_step_typed_at_the_prompt(bench: Bench) -> None:
    bench.press(Z, 1)
    rig = bench.session.rig
    assert list(bench.pendant.sent) == ["@STEP 50,0,-39,8", "@STEP 50,0,-39,9"]
    assert ">@STEP 50,0,-39,9" in rig.screen()
    assert rig.registers == rig.joints == (0, -78, 17, 0, 0, 0)
    assert rig.pose.z == pytest.approx(0.5, abs=0.02)


def test_a_key_that_is_held_goes_on_until_it_is_let_go(bench: Bench) -> None:
    bench.press(Z, 1, seconds=9.0)
    held = len(bench.pendant.sent)
    assert held >= 6
    assert held % 2 == 0
    bench.session.run_for(2.0)
    assert len(bench.pendant.sent) == held


def test_variables_of_a_program_are_left_alone(bench: Bench) -> None:
    rig = bench.session.rig
    rig.type('A=42:B$="KEPT"\r')
    rig.run_until_waiting()
    bench.press(Z, 1)
    rig.type("PRINT A;B$\r")
    rig.run_until_waiting()
    assert " 42 KEPT" in rig.screen()


def test_a_line_half_typed_is_left_and_not_sent(bench: Bench) -> None:
    rig = bench.session.rig
    rig.type("10 PRINT")
    rig.run_until(lambda rig: not rig.typing)
    bench.press(Z, 1)
    assert ">10 PRINT" in rig.screen()
    assert rig.registers[1] == -78
    assert not bench.session.program


def test_a_program_that_runs_is_not_typed_into_but_stopped_on_demand(bench: Bench) -> None:
    rig = bench.session.rig
    rig.load_text("10 GOTO 10\n")
    rig.type("RUN\r")
    bench.session.run_for(2.0)
    bench.press(Z, 1)
    assert bench.pendant.message == "A program runs: stop it first."
    assert not bench.pendant.sent
    bench.pendant.stop()
    assert bench.pendant.message == "Stopped."
    bench.session.run_for(1.0)
    assert rig.waiting is Waiting.COMMAND
    bench.press(Z, 1)
    assert rig.registers[1] == -78


def test_input_and_edit_are_left_for_the_prompt_when_stopped(bench: Bench) -> None:
    rig = bench.session.rig
    rig.load_text("10 INPUT A\n")
    rig.type("RUN\r")
    rig.run_until_waiting()
    bench.press(X, 1)
    assert "waits for INPUT" in bench.pendant.message
    bench.pendant.stop()
    assert rig.waiting is Waiting.COMMAND


def test_in_the_machines_manual_mode_its_own_keys_are_held(bench: Bench) -> None:
    session, pendant = bench.session, bench.pendant
    session.rig.type("@SET\r")
    session.rig.run_until_waiting()
    bench.press(X, 1, seconds=0.5)
    assert "choose joint coordinates" in pendant.message
    pendant.coordinates = Coordinates.JOINT
    bench.press(0, 1, seconds=0.5)
    assert session.rig.registers[0] > 100
    assert session.rig.registers[1:] == (0, 0, 0, 0, 0)
    pendant.end_set()
    session.run_for(1.0)
    assert session.rig.waiting is Waiting.COMMAND


def test_the_grip_closes_to_the_step_and_opens_to_a_width(bench: Bench) -> None:
    bench.pendant.open_to(1.5)
    bench.finish()
    assert bench.session.rig.pose.opening == pytest.approx(1.5, abs=0.002)
    bench.by(Z, 0.5)
    bench.by(X, 3)
    bench.pendant.close()
    bench.finish()
    rig = bench.session.rig
    assert rig.state.held == "block"
    assert rig.state.force == pytest.approx(7 / 52, abs=0.02)
    bench.pendant.open_to(0.8)
    bench.finish()
    assert rig.state.held is None
    assert rig.pose.opening == pytest.approx(0.8, abs=0.002)
    bench.pendant.open_to(3.5)
    assert bench.pendant.message == "The hand opens 0 to 3 inches."


def test_a_hand_that_is_jogged_shut_stops_at_the_part(bench: Bench) -> None:
    bench.pendant.open_to(1.5)
    bench.finish()
    bench.by(Z, 0.5)
    bench.by(X, 3)
    bench.by(HAND, -1.4)
    assert bench.pendant.message == "The grip switch has closed."
    assert bench.session.rig.state.force < 0.7


def test_a_hand_that_is_held_shut_squeezes_no_more_until_its_key_is_let_go(bench: Bench) -> None:
    bench.pendant.open_to(0.7)
    bench.finish()
    bench.by(Z, 0.5)
    bench.by(X, 3)
    pendant, rig = bench.pendant, bench.session.rig
    pendant.press(HAND, -1)
    for _ in range(900):
        pendant.hold(HAND, -1)
        pendant.go_on()
        bench.session.run_for(FRAME)
    assert pendant.message == "The grip switch has closed."
    force = rig.state.force
    assert force < 0.7
    pendant.release(HAND, -1)
    bench.press(HAND, -1)
    assert rig.state.force == pytest.approx(force + 0.5, abs=0.01)


def test_points_are_gone_through_forwards_and_back_with_the_part(bench: Bench) -> None:
    assert bench.taught() == ["A", "B", "C", "D", "E", "F", "G", "H", "I"]
    rig, pendant = bench.session.rig, bench.pendant
    assert bench.block == (8.0, 4.0, 0.5)
    for _ in range(8):
        pendant.step(-1)
        bench.finish()
    assert pendant.place == 0
    assert bench.block == (8.0, 0.0, 0.5)
    pendant.step(-1)
    assert pendant.message == "That is the first point."
    for _ in range(8):
        pendant.step(1)
        bench.finish()
    assert pendant.place == 8
    assert bench.block == (8.0, 4.0, 0.5)
    assert rig.registers == rig.joints


def test_a_run_goes_once_and_leaves_the_mark_at_the_end(bench: Bench) -> None:
    bench.taught()
    bench.session.rig.refill()
    bench.pendant.run()
    bench.finish()
    assert bench.block == (8.0, 4.0, 0.5)
    assert bench.pendant.place == 8
    assert list(bench.pendant.sent)[-2:] == ["@STEP 50,0,0,0,0,0,440", "@STEP 50,0,-186,53"]


def test_a_run_is_stopped_at_the_end_of_its_step(bench: Bench) -> None:
    bench.taught()
    bench.session.rig.refill()
    bench.pendant.run()
    bench.pendant.go_on()
    bench.session.run_for(0.1)
    bench.pendant.stop()
    assert bench.pendant.message == "Stopped."
    sent = len(bench.pendant.sent)
    bench.finish()
    bench.session.run_for(3.0)
    assert len(bench.pendant.sent) == sent
    rig = bench.session.rig
    assert rig.registers == bench.pendant.lesson.positions[0].registers


def test_what_is_out_of_reach_is_said_before_anything_moves(bench: Bench) -> None:
    bench.by(Z, 2)
    pendant = bench.pendant
    pendant.teach()
    pendant.teach()
    pendant.lesson.set_registers(1, (0, -2000, 0, 0, 0, 0))
    sent = len(pendant.sent)
    pendant.run()
    assert pendant.message.startswith("B is out of reach: beyond the stop: ")
    assert pendant.message.endswith("Nothing moves.")
    pendant.go_to(1)
    bench.finish()
    assert len(pendant.sent) == sent


def test_points_of_another_zero_are_not_gone_to(bench: Bench) -> None:
    bench.by(Z, 2)
    bench.pendant.teach()
    bench.session.rig.type("@RESET\r")
    bench.session.rig.run_until_waiting()
    bench.pendant.go_to(0)
    assert "count from elsewhere" in bench.pendant.message
    assert not bench.pendant.busy


def test_points_are_put_in_touched_up_and_taken_out(bench: Bench) -> None:
    pendant = bench.pendant
    for height in (1, 1, 1):
        bench.by(Z, height)
        pendant.teach()
    pendant.mark(0)
    pendant.teach("between")
    assert [p.name for p in pendant.lesson.positions] == ["A", "BETWEEN", "B", "C"]
    bench.by(X, 1)
    pendant.teach_again()
    assert pendant.lesson.positions[1].pose.x == pytest.approx(6, abs=0.02)
    pendant.shift(1)
    assert pendant.place == 2
    pendant.remove()
    assert [p.name for p in pendant.lesson.positions] == ["A", "B", "C"]
    assert pendant.place == 2


def test_a_slip_ends_what_was_to_come_and_is_told_once(bench: Bench) -> None:
    pendant = bench.pendant
    bench.by(Z, 3)
    pendant.manner = type(pendant.manner)(speed=0)
    pendant.coordinates = Coordinates.JOINT
    bench.by(0, 900)
    assert "registers are wrong" in pendant.message
    pendant.manner = type(pendant.manner)(speed=50)
    before = bench.session.rig.pose
    pendant.coordinates = Coordinates.WORLD
    bench.by(Z, 1)
    assert pendant.message == ""
    assert bench.session.rig.pose.z - before.z == pytest.approx(1, abs=0.02)


def test_what_was_done_is_done_again_from_a_recording(bench: Bench) -> None:
    done: list[Input] = []
    bench.session.rig.record(done.append)
    bench.press(Z, 1, seconds=3.0)
    bench.pendant.close()
    bench.finish()
    again = Rig()
    again.replay(done)
    again.run_to(bench.session.rig.clock.now)
    assert again.registers == bench.session.rig.registers
    assert again.screen() == bench.session.rig.screen()


def test_the_teachmover_is_driven_as_well_and_its_hand_stays_as_wide() -> None:
    bench = Bench(RigSettings(arm=ArmSettings(model="teachmover")))
    bench.pendant.open_to(1.0)
    bench.finish()
    for axis, amount in ((Z, 2.0), (X, 2.5), (Y, -1.5)):
        bench.by(axis, amount)
    pose = bench.session.rig.pose
    assert (pose.x, pose.y, pose.z) == (
        pytest.approx(7.5, abs=0.03),
        pytest.approx(-1.5, abs=0.03),
        pytest.approx(2.0, abs=0.03),
    )
    assert pose.opening == pytest.approx(1.0, abs=0.01)
    bench.pendant.teach()
    bench.by(Z, 1.0)
    bench.pendant.go_to(0)
    bench.finish()
    assert bench.session.rig.registers == bench.pendant.lesson.positions[0].registers


def test_a_machine_without_armbasic_says_so_itself() -> None:
    bench = Bench(RigSettings(armbasic=False))
    bench.press(Z, 1)
    assert "?SN ERROR" in bench.session.rig.screen()
    assert bench.session.rig.registers == (0, 0, 0, 0, 0, 0)
