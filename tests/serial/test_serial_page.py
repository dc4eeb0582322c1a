"""The page on the serial line tells what is so, and its client works."""

from __future__ import annotations

import re
import sys
import threading
from pathlib import Path

import pytest

from tests.serial.lab import SETTINGS, Line
from trs80arm import Rig
from trs80arm.serial import protocol
from trs80arm.serial.controller import WAITING
from trs80arm.serial.endpoints import open_port
from trs80arm.serial.lines import LONGEST
from trs80arm.serial.memory import STEPS
from trs80arm.serial.serving import Server
from trs80arm.serial.speeds import delay_of

PAGE = (Path(__file__).parents[2] / "docs/serial.md").read_text(encoding="utf-8")
CODE = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)


@pytest.mark.parametrize(
    "tcp", [pytest.param(None, marks=pytest.mark.skipif(sys.platform == "win32", reason="pty")), 0]
)
def test_the_client_of_the_page_works(tcp: int | None, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("serial")
    port = open_port(tcp)
    rig = Rig(SETTINGS)
    server = Server(rig, port, None)
    end = threading.Event()

    def serve() -> None:
        while not end.is_set():
            server.turn()
            port.wait(min(server.rest, 0.02), sending=server.attendant.unsent)

    thread = threading.Thread(target=serve)
    thread.start()
    name = port.name if tcp is None else f"socket://{port.name}"
    names = {"PORT": name}
    try:
        exec(CODE[0], names)
    finally:
        names["arm"].close()
        end.set()
        thread.join(30)
        port.close()
    printed = capsys.readouterr().out
    status, numbers = re.findall(r"'([^']*)'", printed)
    *counts, inputs = map(int, numbers.split(","))
    assert status == "1"
    assert counts[:5] == [0] * 5
    assert counts[5] < 0
    assert inputs == 254
    assert rig.state.force > 1


def test_the_rig_of_the_page_answers(capsys: pytest.CaptureFixture[str]) -> None:
    exec(CODE[1], {})
    assert capsys.readouterr().out == "b'1\\r'\nb'1\\r100,0,0,0,0,0,255\\r'\n"


def test_every_command_is_on_the_page_with_its_source() -> None:
    rows = re.findall(r"^\| `@(\w+)[^|]*\|.*\|.*\| (.*) \|$", PAGE, re.MULTILINE)
    assert {word[:3] for word, _ in rows} == {
        "STE", "CLO", "SET", "RES", "REA", "QDU", "QWR", "RUN", "ARM", "DEL",
    }  # fmt: skip
    assert all("known" in source or "chosen" in source for _, source in rows)


def test_every_source_is_told() -> None:
    named = set(re.findall(r"\[([A-Z0-9#]{2,4})\]", PAGE.split("## Sources")[0]))
    told = set(re.findall(r"^\| \[([A-Z0-9#]+)\]", PAGE, re.MULTILINE))
    assert named - {"SP"} == told


def test_figures_of_the_page_are_those_of_the_arm() -> None:
    assert f"more than {LONGEST} characters" in PAGE
    assert f"| {WAITING} lines wait" in PAGE
    assert f"1 to {STEPS} |" in PAGE
    assert f"0 to {protocol.FASTEST}" in PAGE
    rows = re.findall(r"^\| (?:SP|half-steps a second) \|(.*)", PAGE, re.MULTILINE)
    speeds, rates = (re.findall(r"\d+", row) for row in rows)
    for speed, rate in zip(speeds, rates, strict=True):
        assert 1000 / (1.2 + 0.03 * delay_of(int(speed))) == pytest.approx(int(rate), abs=0.51)


@pytest.mark.parametrize(
    ("sent", "answered"),
    [
        (b"READ\r", b"0\r"),
        (b"@STOP \r", b"0\r"),
        (b"@STEP 246,1\r", b"0\r"),
        (b"@STEP 240,0,0,0,0,0,0,885465860\r", b"1\r"),
        (b"@DELAY 1001\r", b"0\r"),
        (b"@QWRITE 54,1,0,0,0,0,0,0\r", b"0\r"),
    ],
)
def test_what_is_done_and_what_is_not(sent: bytes, answered: bytes) -> None:
    assert Line().send(sent) == answered
