"""Lines to commands and back: what known clients send, and what nobody should."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trs80arm.serial.protocol import (
    FASTEST,
    USUAL_SPEED,
    Arm,
    ByHand,
    Close,
    Command,
    Delay,
    Dump,
    Read,
    Reset,
    Run,
    Step,
    Write,
    can_delimit,
    dump,
    line,
    parse,
    reading,
)

ROW = (1, 3841, 2, 3, 4, 5, 6, 65535)

SENT: list[tuple[bytes, Command]] = [
    # TeachMover-Python: blanks after commas, a line feed before the CR
    (b"@STEP 220, 1, -2, 3, -4, 5, -6", Step(220, (1, -2, 3, -4, 5, -6))),
    (b"@STEP 0, 0, 0, 0, 0, 0, 0, 5", Step(0, (0, 0, 0, 0, 0, 0), 5)),
    (b"@QWRITE 1,3841,2,3,4,5,6,65535\n", Write(ROW)),
    (b"@CLOSE", Close(USUAL_SPEED)),
    (b"@QDUMP", Dump()),
    # Robotics-Lab1, ELE418: three letters, an OUT that was never set, a speed without a blank
    (b"@STE 235,1,2,3,4,5,6,885465860", Step(235, (1, 2, 3, 4, 5, 6), 885465860)),
    (b"@STE 235,1,2,3,4,5,6,-858993460", Step(235, (1, 2, 3, 4, 5, 6), -858993460)),
    (b"@CLO 221", Close(221)),
    (b"@CLO ", Close(USUAL_SPEED)),
    (b"@SET235,", ByHand(235)),
    (b"@RESET ", Reset()),
    # TeachVal III: decimals, a comma before the arguments
    (b"@STEP 240,884.0,1255.77,-37.12,0,0,0,0", Step(240, (884, 1255, -37, 0, 0, 0), 0)),
    (b"@RESET, 0", Reset()),
    (b"@RESET, ", Reset()),
    (b"@READ, ", Read()),
    (b"@CLOSE, 0", Close(USUAL_SPEED)),
    # microbot-teachmover: a comma at the end, blanks before commas
    (b"@READ ", Read()),
    (b"@STEP 232,100,0,0,0,0,0,0,", Step(232, (100, 0, 0, 0, 0, 0), 0)),
    (b"@STEP 232,1, 2 ,3, 4,5, 6,", Step(232, (1, 2, 3, 4, 5, 6))),
    (b"@ARM # ", Arm("#")),
    # the line feed of a client that ends lines with CR and LF
    (b"\n@READ", Read()),
    # numbers that C and MATLAB print
    (b"@STEP 240,+5,-0,.5,-.5,6.,-0.0", Step(240, (5, 0, 0, 0, 6, 0))),
    (b"@step 1", Step(1, (0, 0, 0, 0, 0, 0))),
    (b"@STEP ,5", Step(USUAL_SPEED, (5, 0, 0, 0, 0, 0))),
    (b"@STEP 9,,5", Step(9, (0, 5, 0, 0, 0, 0))),
    (b"@DELAY 20", Delay(20)),
    (b"@RUN", Run()),
    (b"\xff\x00~ noise on the line @READ", Read()),
]


@pytest.mark.parametrize(("sent", "meant"), SENT, ids=lambda each: repr(each)[:40])
def test_what_known_clients_send(sent: bytes, meant: Command) -> None:
    assert parse(sent) == meant


@pytest.mark.parametrize(
    "sent",
    [
        b"",
        b"\n",
        b"@",
        b"READ",
        b"@STOP ",
        b"@RE",
        b"@ READ,x",
        b"@STEP",
        b"@STEP 246,1",
        b"@STEP -1,1",
        b"@STEP 240,32768",
        b"@STEP 240,1,2,3,4,5,6,7,8",
        b"@STEP 240,1 2",
        b"@STEP 240,1e3",
        b"@STEP 240,NaN",
        b"@STEP 240,--1",
        b"@STEP 240,.",
        b"@STEP 240,1@READ",
        "@STEP 240,\N{SUPERSCRIPT TWO}".encode("latin-1"),
        b"@CLOSE 300",
        b"@QWRITE 1,2,3",
        b"@QWRITE 1,2,3,4,5,6,7,65536",
        b"@QWRITE 1,2,3,4,,6,7,8",
        b"@ARM",
        b"@ARM xy",
        b"@DELAY -1",
        b"@DELAY 1001",
    ],
)
def test_what_is_no_command(sent: bytes) -> None:
    assert parse(sent) is None


def test_another_delimiter() -> None:
    assert parse(b"#READ", "#") == Read()
    assert parse(b"@READ", "#") is None


@given(st.binary(max_size=300), st.characters(min_codepoint=33, max_codepoint=126))
def test_any_bytes_are_a_command_or_none(sent: bytes, delimiter: str) -> None:
    command = parse(sent, delimiter)
    if command is not None:
        assert parse(line(command, delimiter)[:-1], delimiter) == command


speeds = st.integers(0, FASTEST)
counts = st.integers(-32768, 32767)
commands: st.SearchStrategy[Command] = st.one_of(
    st.builds(Step, speeds, st.tuples(*[counts] * 6), st.none() | st.integers()),
    st.builds(Close, speeds),
    st.builds(ByHand, speeds),
    st.sampled_from([Reset(), Read(), Dump(), Run()]),
    st.builds(Write, st.tuples(*[st.integers(0, 65535)] * 8)),
    st.builds(Delay, st.integers(0, 1000)),
    st.builds(Arm, st.characters(min_codepoint=33, max_codepoint=126).filter(can_delimit)),
)


@given(commands, st.sampled_from("@#A!~-1"))
def test_a_command_as_a_line_is_that_command(command: Command, delimiter: str) -> None:
    sent = line(command, delimiter)
    assert sent.endswith(b"\r")
    assert parse(sent[:-1], delimiter) == command


def test_answers() -> None:
    assert reading((1, -2, 3, 4, 5, 6), 7, 0xFE) == b"1\r1,-2,3,4,5,6,2046\r"
    assert dump([]) == b"1\r"
    assert dump([ROW, ROW]) == b"1\r" + 2 * b"1,3841,2,3,4,5,6,65535\r"
