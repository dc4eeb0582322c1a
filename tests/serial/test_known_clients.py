"""What clients that labs have send, byte for byte, and whether they can read what is answered.

None of them is here; each is made again from its published source: the bytes that it writes, and
what it does with the bytes that it reads. `docs/serial.md` names them.
"""

from __future__ import annotations

from collections.abc import Iterable

import pytest

from tests.serial.lab import Line
from trs80arm.serial.memory import Move

HERE = b"1\r0,0,0,0,0,0,255\r"


def test_teachmover_python() -> None:
    """It takes all that came for numbers, blanks and CRs for commas."""
    line = Line()

    def ask(command: str) -> list[int]:
        answer = line.send(command.encode() + b"\r").decode()
        return [int(part) for part in answer.replace(" ", ",").replace("\r", ",").split(",")[:-1]]

    assert ask("@RESET") == [1]
    assert ask("@STEP 220, 100, -50, 20, 5, -5, 20") == [1]
    assert ask("@STEP 220, 0, 0, 0, 0, 0, 0, 9") == [1]
    assert line.rig.card.latches[6] == 9
    status, *position, inputs = ask("@READ")
    assert (status, position, inputs % 256) == (1, [100, -50, 20, 5, -5, 20], 255)
    assert ask("@CLOSE") == [1]
    assert ask("@STEP 220, 0, 0, 0, 0, 0, -32") == [1]
    assert line.rig.state.force == pytest.approx(1.1, abs=0.2), "about a pound more, it says"
    assert ask("@STEP 220, 0, 0, 0, 0, 0, 500") == [1]
    status, *position, inputs = ask("@READ")
    back = ", ".join(str(-count) for count in position)
    assert ask(f"@STEP 220, {back}") == [1]
    assert ask("@READ")[1:7] == [0] * 6
    line.rig.press_pendant("POINT")
    line.rig.press_pendant("STOP")
    assert ask("@READ")[7] // 256 == 7


def test_teachmover_python_keeps_a_program_in_a_file_and_writes_it_back() -> None:
    line, other = Line(), Line()
    for number, base in ((1, 60), (2, -300), (3, 0)):
        row = ",".join(map(str, Move(230, (base, -20, 0, 0, 0, 0)).row(number)))
        line.send(f"@QWRITE {row}\r".encode())
    dumped = line.send(b"@QDUMP\r").decode().replace("\r", ",").split(",")[1:-1]
    assert len(dumped) == 3 * 8
    lines = [",".join(dumped[place : place + 8]) + "\n" for place in (0, 8, 16)]
    # A line of a file has its line feed, and the CR comes behind it.
    answers = [other.send(f"@QWRITE {text}".encode() + b"\r") for text in lines]
    assert answers == [b"1\r"] * 3
    assert other.send(b"@QDUMP\r") == line.send(b"@QDUMP\r")
    assert other.send(b"@RUN\r") == b"1\r"
    assert other.rig.registers == other.rig.joints == (0, -20, 0, 0, 0, 0)


def test_robotics_lab_of_ele418() -> None:
    """It reads two characters, the first being the status; of `@READ` up to the second CR."""
    line = Line()

    def status(sent: bytes) -> int:
        answer = line.send(sent)
        assert len(answer) == 2
        return int(answer[:1])

    assert status(b"@RESET \r") == 1
    assert status(b"@STE 235,-500,0,0,0,0,0,0\r") == 1
    assert status(b"@STE 200,10,20,-30,4,5,60,885465860\r") == 1
    assert status(b"@STE 200,1,1,1,1,1,1,-858993460\r") == 1
    numbers = line.send(b"@READ\r").split(b"\r")[1].split(b",")
    assert list(map(int, numbers)) == [-489, 21, -29, 5, 6, 61, 255]
    assert status(b"@CLO 221\r") == 1
    assert status(b"@STE 221,0,0,0,0,0,-30,-858993460\r") == 1
    assert status(b"@CLO \r") == 1


def test_robotics_lab_waits_in_set_for_the_pendant() -> None:
    line = Line()
    line.rig.receive(b"@SET235,\r")
    line.rig.run_for(5)
    assert line.answers == b""
    line.rig.press_pendant("SHOULDER_PLUS")
    line.rig.run_for(0.5)
    line.rig.release_pendant("SHOULDER_PLUS")
    line.rig.press_pendant("TRAIN")
    line.wait()
    assert line.answers == b"1\r"
    assert line.rig.registers[1] < -100


def test_teachval_iii() -> None:
    """It counts CRs, one for a motion and two for `@READ`, and takes out the first `1`."""
    line = Line()
    assert line.send(b"@RESET, 0\r").count(b"\r") == 1
    assert line.send(b"@STEP 240,157,229,-56,0,0,-56,0\r").count(b"\r") == 1
    assert line.send(b"@STEP 240,84.0,55.77,-37.12,-0.0,0.0,-37.0,0\r").count(b"\r") == 1
    characters = [bytes([code]) for code in line.send(b"@READ, \r")]
    assert characters.count(b"\r") == 2
    characters.remove(b"1")
    characters.remove(b"\r")
    counts = [int(number) for number in b"".join(characters).split(b",")[:6]]
    assert counts == [157 + 84, 229 + 55, -56 - 37, 0, 0, -56 - 37]
    back = ",".join(str(-count) for count in counts)
    assert line.send(f"@STEP 240,{back},0\r".encode()).count(b"\r") == 1
    assert line.rig.registers == (0, 0, 0, 0, 0, 0)
    assert line.send(b"@CLOSE, 0\r").count(b"\r") == 1
    assert line.send(b"@STEP 240,0,0,0,0,0,400,0\r").count(b"\r") == 1
    assert line.send(b"@RESET, \r").count(b"\r") == 1


def test_microbot_teachmover_in_c_sharp() -> None:
    """It keeps what ends in CR and has more than ten characters, and sends the differences."""
    line = Line()
    assert line.send(b"@ARM @ \r") == b"1\r"
    for sent in (
        b"@STEP 232,100,0,0,0,0,0,0,\r",
        b"@STEP 232,0,-100,0,0,0,0,0,\r",
        b"@STEP 232,0, 0 ,-50, 10,20, -60,\r",
    ):
        assert line.send(sent) == b"1\r"
    first = line.send(b"@READ \r")
    assert first.endswith(b"\r")
    assert len(first) > 10
    assert line.send(b"@CLOSE \r") == b"1\r"
    second = line.send(b"@READ \r")

    def numbers(kept: bytes) -> Iterable[int]:
        return map(int, kept[1:].replace(b"\r", b"").split(b","))

    # The input byte is among what is subtracted, and goes where OUT is.
    changes = [one - other for one, other in zip(numbers(first), numbers(second), strict=True)]
    assert len(changes) == 7
    program = "@STEP 232" + "".join(f",{change}" for change in changes) + "\r"
    assert line.send(program.encode()) == b"1\r"
    assert line.send(b"@READ \r").split(b",")[:6] == first.split(b",")[:6]
    assert line.send(b"@STOP \r") == b"0\r"
    assert line.send(b"@RESET \r") == b"1\r"


def test_leap_motion_teachmover() -> None:
    """It reads a line, up to the end of its patience, and strips it."""
    line = Line()
    assert line.send(b"@STEP 240, 200, -150, 40, -210, -90, 70\r").strip() == b"1"
    assert line.send(b"@READ\r").decode().strip().split("\r")[-1].startswith("200,-150,40,")
    assert line.send(b"@STEP 240, -200, 150, -40, 210.0, 90.0, -70\r").strip() == b"1"
    assert line.send(b"@READ\r") == HERE


def test_teachmover_virtual_command() -> None:
    """It reads lines that end in CR, and looks for an arm by a second line after `@READ`."""
    line = Line()
    looked = line.send(b"@READ\r").split(b"\r")
    assert looked[0] == b"1"
    assert looked[1]
    assert line.send(b"@STEP 240,-0,120,0,-30,30,-0\r") == b"1\r"
    assert line.send(b"@READ\r").split(b"\r")[1].split(b",")[:6] == b"0,120,0,-30,30,0".split(b",")
    # Two places, in the way of its convertToQWRITE.
    assert line.send(b"@QWRITE 1,3841,30724,2560,0,0,0,0\r") == b"1\r"
    assert line.send(b"@QWRITE 2,3841,65535,0,0,65535,0,0\r") == b"1\r"
    assert line.send(b"@RUN\r") == b"1\r"
    assert line.rig.registers == (-1, -1, 0, 0, 0, 0)
    assert Move.of((1, 3841, 30724, 2560, 0, 0, 0, 0)).position == (4, 120, 0, 10, 0, 0)


def test_a_client_that_polls_all_the_time_is_answered_in_turn() -> None:
    line = Line()
    line.rig.receive(b"@STEP 220,200\r")
    for _ in range(20):
        line.rig.receive(b"@READ\r")
        line.rig.run_for(0.02)
    assert line.answers == b""
    line.wait()
    assert line.answers == b"1\r" + 20 * b"1\r200,0,0,0,0,0,255\r"
