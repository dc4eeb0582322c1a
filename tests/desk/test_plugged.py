"""A real arm at a sitting: asked about before anything moves, stopped by BREAK, told of once."""

from __future__ import annotations

import io
import threading
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.desk.sitting import NOTHING, Person
from tests.own_places import own_places
from tests.serial.far_side import FarSide
from trs80arm import RigSettings
from trs80arm.arm import ArmSettings
from trs80arm.desk import recording
from trs80arm.desk.plugged import MOVE, STOPPED, Plugged
from trs80arm.desk.session import Session
from trs80arm.plain import PlainMode
from trs80arm.rig import Key
from trs80arm.serial.courier import Courier
from trs80arm.serial.limits import Plugging, PlugSettings

__all__ = ["own_places"]


class Sitting:
    """A session with a wire, and somebody who answers."""

    def __init__(self, *answers: object, allowed: bool = False) -> None:
        self.session = Session(RigSettings(arm=ArmSettings(model="teachmover")))
        self.far = FarSide()
        self.person = Person()
        self.person.answers.extend(answers)
        courier = Courier(self.session.rig, self.far, PlugSettings())
        plugging = Plugging("/dev/ttyUSB0", allowed=allowed)
        person = self.person
        self.plugged = Plugged(self.session, courier, plugging, person, person.say)
        self.plugged.begin()

    def pass_time(self, seconds: float, until: Callable[[], bool] = lambda: False) -> None:
        """Let the session have its time, and the arm follow."""
        for _ in range(round(seconds / 0.02)):
            self.plugged.go_on()
            self.session.run_for(0.02)
            self.plugged.deliver()
            if until():
                break


def test_no_time_passes_and_nothing_moves_before_the_answer() -> None:
    sitting = Sitting(NOTHING)
    sitting.session.rig.type("@STEP 50,100\r")
    before = sitting.session.time
    sitting.pass_time(2)
    assert sitting.session.time == before
    assert sitting.far.words == ["@READ"]
    question = sitting.person.asked[0]
    assert "/dev/ttyUSB0" in question.text
    assert question.answers[0].value != MOVE, "Enter alone moves nothing"


def test_after_a_yes_the_arm_follows() -> None:
    sitting = Sitting(MOVE)
    sitting.session.rig.type("@STEP 50,100\r")
    sitting.pass_time(8)
    assert sitting.far.registers[0] == 100
    assert sitting.person.errors == []


def test_a_yes_on_the_command_line_is_not_asked_for_again() -> None:
    sitting = Sitting(allowed=True)
    assert sitting.person.asked == []
    sitting.session.rig.type("@STEP 50,100\r")
    sitting.pass_time(8)
    assert sitting.far.registers[0] == 100


def test_after_a_no_the_model_moves_alone() -> None:
    sitting = Sitting("no")
    sitting.session.rig.type("@STEP 50,100\r")
    sitting.pass_time(8)
    assert sitting.session.rig.registers[0] == 100
    assert sitting.far.words == ["@READ"]
    assert sitting.far.closed
    assert sitting.person.told[-1] == "The wire is unplugged: the model moves alone."


def test_a_question_that_is_left_is_a_no() -> None:
    sitting = Sitting(NOTHING)
    sitting.pass_time(0.1)
    sitting.person.standing = None
    sitting.pass_time(0.1)
    assert sitting.far.closed
    assert not sitting.plugged.busy


def test_break_holds_the_wire_at_the_end_of_a_line() -> None:
    sitting = Sitting(MOVE)
    rig, far = sitting.session.rig, sitting.far
    rig.type("@STEP 50,-1500\r")
    sitting.pass_time(20, until=lambda: bool(far.steps))
    sitting.session.run_for(0.6)
    sitting.session.run_for(0.6)
    rig.press(Key.BREAK)
    rig.run_for(0.01)
    sent = len(far.heard)
    sitting.pass_time(1)
    rig.release(Key.BREAK)
    sitting.pass_time(1)
    assert len(far.heard) == sent
    assert sitting.person.told.count(STOPPED) == 1


def test_break_is_seen_while_the_machine_waits_for_the_arm() -> None:
    sitting = Sitting(MOVE)
    session, far = sitting.session, sitting.far
    slow = threading.Event()

    def slowly(line: str) -> None:
        if line.startswith("@STEP"):
            slow.wait(10)

    far.answer = slowly
    session.rig.type("@STEP 50,-1500\r")
    for _ in range(400):
        sitting.plugged.go_on()
        session.run_for(0.05)
    standing = session.time
    session.run_for(1)
    assert session.time == standing, "the machine is as far ahead as it may be"
    session.rig.hold([Key.BREAK], 0.2)
    sitting.plugged.go_on()
    session.run_for(1)
    assert session.time > standing
    slow.set()
    sitting.pass_time(3)
    assert len(far.steps) == 1
    assert session.waiting.name == "COMMAND"


def test_a_fault_stops_the_program_and_is_told_once() -> None:
    sitting = Sitting(MOVE)
    rig, far = sitting.session.rig, sitting.far
    far.answer = lambda line: ["2"] if line.startswith("@STEP") else None
    rig.load_text("10 @STEP 80,100\n20 @STEP 80,-100\n30 GOTO 10\n")
    rig.type("RUN\r")
    sitting.pass_time(12)
    assert len(far.steps) == 1
    assert len(sitting.person.errors) == 1
    assert "stop key" in sitting.person.errors[0]
    assert rig.waiting.name == "COMMAND"
    assert far.closed


@pytest.mark.parametrize(("answer", "moved"), [("2", 100), ("1", 0), (".help", 0)])
def test_in_lines_the_next_line_is_the_answer(answer: str, moved: int) -> None:
    session = Session(RigSettings(arm=ArmSettings(model="teachmover")))
    far, out = FarSide(), io.StringIO()
    plain = PlainMode(
        session,
        out,
        echo=False,
        speed=None,
        courier=Courier(session.rig, far, PlugSettings()),
        plugging=Plugging("/dev/ttyUSB0"),
    )
    assert plain.talk(iter([f"{answer}\n", "@STEP 50,100\n", ".quit\n"])) == 0
    assert far.registers[0] == moved
    assert session.rig.registers[0] == 100
    assert far.closed


def test_another_machine_is_not_followed(tmp_path: Path) -> None:
    sitting = Sitting(MOVE)
    session, far = sitting.session, sitting.far
    session.save_recording(tmp_path / "session.jsonl")
    session.play(recording.load(tmp_path / "session.jsonl"))
    sitting.pass_time(0.1)
    assert len(sitting.person.errors) == 1
    assert sitting.person.errors[0].startswith("The machine is another one")
    assert far.closed
