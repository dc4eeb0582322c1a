"""The arm's serial line at a sitting."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.desk.sitting import Person
from tests.serial.lab import SETTINGS
from trs80arm.desk.opening import open_session
from trs80arm.desk.recording import Recording, load
from trs80arm.desk.served import NO_LINE, Served, open_line
from trs80arm.desk.session import Session
from trs80arm.options import TerminalOptions
from trs80arm.rig import Key, RigSettings


class Client:
    """A port, and who is at its other end.

    Attributes:
        heard: what the arm answered.
        sending: what is still to be taken.
        there: whether somebody is at the other end.
    """

    name = "/dev/pts/80"

    def __init__(self) -> None:
        self.heard = b""
        self.sending = b""
        self.there = self.connected = True
        self.closed = False

    def left(self) -> bool:
        gone = self.connected and not self.there
        self.connected = self.there
        return gone

    def receive(self, most: int) -> bytes:
        taken, self.sending = self.sending[:most], self.sending[most:]
        return taken

    def send(self, data: bytes) -> int:
        self.heard += data
        return len(data)

    def wait(self, seconds: float, others=(), *, sending: bool = False) -> None: ...

    def close(self) -> None:
        self.closed = True


class Sitting:
    def __init__(self) -> None:
        self.session = Session(SETTINGS)
        self.client = Client()
        self.person = Person()
        self.served = Served(self.session, self.client, self.person, self.person.say)

    def send(self, line: bytes, seconds: float = 0.5) -> bytes:
        self.client.heard = b""
        self.client.sending += line
        self.pass_time(seconds)
        return self.client.heard

    def pass_time(self, seconds: float) -> None:
        for _ in range(round(seconds * 30)):
            self.session.run_for(1 / 30)
            self.served.go_on()


def test_a_client_moves_the_arm_and_the_status_tells_of_it() -> None:
    sitting = Sitting()
    served = sitting.served
    served.begin()
    assert "/dev/pts/80" in sitting.person.told[0]
    assert served.text == "/dev/pts/80 nobody yet"
    assert sitting.send(b"@STEP 240,100\r", 0.1) == b""
    assert served.moves
    assert sitting.session.busy
    assert served.text == "/dev/pts/80 > @STEP 240,100"
    assert sitting.send(b"", 0.5) == b"1\r"
    assert not sitting.session.busy
    assert served.text == "/dev/pts/80 < 1"
    sitting.send(b"@" + b"x" * 200 + b"\r", 0.1)
    assert len(served.text) < 60


@pytest.mark.parametrize("way", ["key", "break", "held break"])
def test_its_operator_stops_the_arm(way: str) -> None:
    sitting = Sitting()
    sitting.send(b"@STEP 200,900\r", 0.5)
    rig = sitting.session.rig
    if way == "key":
        sitting.served.stop()
    elif way == "break":
        rig.hold([Key.BREAK], 0.01)
    else:
        rig.press(Key.BREAK)
    assert sitting.send(b"", 0.2) == b"2\r"
    assert 0 < rig.registers[0] < 900
    assert "stopped" in sitting.person.told[-1]
    assert sitting.send(b"@STEP 240,1\r") == b"1\r"


def test_who_hangs_up_stops_the_arm() -> None:
    sitting = Sitting()
    sitting.send(b"@STEP 200,900\r", 0.5)
    sitting.client.there = False
    sitting.pass_time(0.2)
    assert not sitting.served.moves
    assert 0 < sitting.session.rig.registers[0] < 900
    assert sitting.served.text.endswith("(hung up)")


def test_manual_mode_is_not_work_of_its_own() -> None:
    sitting = Sitting()
    sitting.send(b"@SET\r", 0.2)
    assert sitting.served.moves
    assert not sitting.session.busy


def test_the_lines_can_be_looked_at() -> None:
    sitting = Sitting()
    sitting.served.show_lines()
    assert sitting.person.told[-1] == "Nothing has come over /dev/pts/80 yet."
    sitting.send(b"@RESET\r\x1b[2J\r")
    sitting.person.answers.append(None)
    sitting.served.show_lines()
    texts = [choice.label.split(None, 1)[1] for choice in sitting.person.asked[0].choices]
    assert texts == ["< 0", "< 1", "> \\x1b[2J", "> @RESET"]


def test_what_is_done_again_is_not_answered_again() -> None:
    sitting = Sitting()
    sitting.send(b"@STEP 240,100\r@READ\r", 1.0)
    before = sitting.client.heard
    session = sitting.session
    end = session.rig.clock.now
    session.timeline.go_to(end - 1_500_000)
    assert session.rig.registers[0] < 100
    sitting.pass_time(0.3)
    assert session.rig.clock.now <= end
    sitting.pass_time(1.0)
    assert sitting.client.heard == before
    assert session.rig.registers[0] == 100
    assert sitting.send(b"@RESET\r") == b"1\r"


def test_a_recording_has_what_came_over_the_line_and_the_stop_key(tmp_path: Path) -> None:
    sitting = Sitting()
    sitting.send(b"@STEP 230,100\r@NONSENSE\x00\xff\r", 0.7)
    sitting.send(b"@STEP 200,900\r", 0.3)
    sitting.served.stop()
    sitting.client.there = False
    sitting.pass_time(0.5)
    path = tmp_path / "serial.jsonl"
    sitting.session.save_recording(path)
    recording = load(path)
    assert {done.action for done in recording.inputs} == {"receive", "press_pendant", "hang_up"}
    again = Session()
    again.play(recording)
    while again.playing:
        again.run_for(0.5)
    assert again.rig.registers == sitting.session.rig.registers
    assert again.rig.registers[0] > 100


def test_another_machine_is_answered_for() -> None:
    sitting = Sitting()
    other = Recording(SETTINGS, None, False, (), 0)
    sitting.session.play(other)
    sitting.pass_time(0.2)
    assert sitting.send(b"@RESET\r") == b"1\r"
    sitting.send(b"@STEP 200,900\r", 0.3)
    sitting.session.rig.hold([Key.BREAK], 0.01)
    assert sitting.send(b"", 0.2) == b"2\r"


def test_a_state_of_a_machine_whose_arm_has_no_computer_answers_nobody() -> None:
    sitting = Sitting()
    sitting.session.rig.restore(Session(RigSettings()).rig.snapshot())
    assert sitting.send(b"@READ\r") == b""
    sitting.served.stop()
    assert sitting.person.told[-1] == NO_LINE
    sitting.session.rig.restore(Session(SETTINGS).rig.snapshot())
    # What was sent meanwhile has waited in the line.
    assert sitting.send(b"@RESET\r", 1.0).count(b"\r") == 3


def test_without_a_line_there_is_nothing_to_stop_or_to_show() -> None:
    session, person = Session(RigSettings()), Person()
    served = Served(session, open_line(TerminalOptions()), person, person.say)
    served.begin()
    served.go_on()
    assert (served.text, served.moves, person.told) == ("", False, [])
    served.stop()
    served.show_lines()
    assert person.told == [NO_LINE] * 2
    served.close()


def test_the_line_that_was_asked_for_is_opened_and_closed() -> None:
    options = TerminalOptions(rig=SETTINGS, serial_tcp=0)
    session, person = open_session(options), Person()
    assert not session.greeted
    port = open_line(options)
    assert port is not None
    assert port.name.startswith("127.0.0.1:")
    served = Served(session, port, person, person.say)
    served.go_on()
    served.close()
    assert served.text == ""
