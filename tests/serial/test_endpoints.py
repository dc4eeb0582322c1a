"""The line where programs get at it: a pseudo-terminal and a TCP port, with clients of pyserial."""

from __future__ import annotations

import contextlib
import os
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from io import StringIO
from random import Random

import pytest

from tests.serial.lab import HIGH, SETTINGS
from trs80arm import Rig
from trs80arm.arm import benchfile
from trs80arm.serial import endpoints
from trs80arm.serial.attendant import READ, UNSENT, Attendant, Logged
from trs80arm.serial.endpoints import EndpointError, Port, PseudoTerminal, TcpPort, open_port
from trs80arm.serial.lines import LONGEST
from trs80arm.serial.serving import Keys, Server

serial = pytest.importorskip("serial")
posix = pytest.mark.skipif(sys.platform == "win32", reason="no pseudo-terminals")

PATIENCE = 30.0
"""Seconds of the wall after which somebody does not answer."""


class Lab:
    """An arm that is served in a thread of its own.

    Attributes:
        rig: the machine; to be looked at when nobody is at work on it.
        port: where clients are.
        log: every line that went over the wire.
    """

    def __init__(self, port: Port, speed: float | None) -> None:
        self.rig = Rig(SETTINGS, benchfile.parse(HIGH, "bench"))
        self.port = port
        self.log: list[Logged] = []
        self.server = Server(self.rig, port, speed, log=self.log.append)
        self._end = threading.Event()
        self._lock = threading.Lock()
        self._fault: BaseException | None = None
        self._thread = threading.Thread(target=self._serve, daemon=True)
        self._thread.start()

    def _serve(self) -> None:
        try:
            while not self._end.is_set():
                with self._lock:
                    self.server.turn()
                self.port.wait(min(self.server.rest, 0.02), sending=self.server.attendant.unsent)
        except BaseException as fault:
            self._fault = fault
            raise

    def do(self, what: Callable[[Rig], object]) -> object:
        """Something with the machine, between two turns."""
        with self._lock:
            return what(self.rig)

    def until(self, what: Callable[[Rig], object]) -> None:
        """Wait until something holds."""
        end = time.monotonic() + PATIENCE
        while not self.do(what):
            assert time.monotonic() < end, "it does not come to that"
            time.sleep(0.005)

    def close(self) -> None:
        self._end.set()
        self._thread.join(PATIENCE)
        self.port.close()
        assert self._fault is None


@contextlib.contextmanager
def lab(speed: float | None, tcp: int | None = None) -> Iterator[tuple[Lab, str]]:
    """An arm that is served, and what pyserial opens."""
    served = Lab(open_port(tcp), speed)
    try:
        yield served, served.port.name if tcp is None else f"socket://{served.port.name}"
    finally:
        served.close()


WAYS = [pytest.param(None, id="pty", marks=posix), pytest.param(0, id="tcp")]


def opened(url: str):
    """A client's end of the line."""
    return serial.serial_for_url(url, 9600, timeout=PATIENCE)


def ask(client, line: bytes, answers: int = 1) -> bytes:
    client.write(line)
    return b"".join(client.read_until(b"\r") for _ in range(answers))


@pytest.mark.parametrize("tcp", WAYS)
def test_a_client_teaches_reads_steps_and_grips(tcp: int | None) -> None:
    with (
        lab(None, tcp) as (served, url),
        opened(url) as line,
    ):
        assert ask(line, b"@RESET\r") == b"1\r"
        assert ask(line, b"@STEP 220, 100, -50, 0, 10, 10, 0\r") == b"1\r"
        assert ask(line, b"@READ\r", 2) == b"1\r100,-50,0,10,10,0,255\r"
        assert ask(line, b"@QWRITE 1,8961,0,0,0,0,0,0\r") == b"1\r"
        assert ask(line, b"@QDUMP\r", 2) == b"1\r1,8961,0,0,0,0,0,0\r"
        assert ask(line, b"@RUN\r") == b"1\r"
        assert ask(line, b"@CLOSE\r") == b"1\r"
        status, *counts = ask(line, b"@READ\r", 2).replace(b"\r", b",").split(b",")[:-1]
        assert (status, counts[:5], counts[6]) == (b"1", [b"0"] * 5, b"254")
        assert int(counts[5]) == pytest.approx(-740, abs=15)
        assert served.do(lambda rig: rig.pose.opening) == pytest.approx(0, abs=0.05)


@pytest.mark.parametrize("tcp", WAYS)
def test_a_command_takes_its_time_and_several_wait_in_a_row(tcp: int | None) -> None:
    with lab(1.0, tcp) as (_, url), opened(url) as line:
        begun = time.monotonic()
        assert ask(line, b"@STEP 240,100\r@STEP 240,-100\r@READ\r", 4) == (
            b"1\r1\r1\r0,0,0,0,0,0,255\r"
        )
        assert time.monotonic() - begun >= 200 * 0.0024


@pytest.mark.parametrize("tcp", WAYS)
def test_who_hangs_up_in_mid_motion_stops_the_arm(tcp: int | None) -> None:
    with lab(1.0, tcp) as (served, url):
        with opened(url) as line:
            # More than is taken at once waits behind the motion.
            line.write(b"@STEP 200,3000\r" + b"@STEP 200,0,500\r" * 300)
            served.until(lambda rig: rig.registers[0] > 10)
        served.until(lambda rig: not rig.controller.busy)
        assert 10 < served.rig.registers[0] < 3000
        assert served.rig.registers[1] == 0
        assert served.log[-1].text == "(hung up)"
        # The next one finds an arm that answers, and nothing of the one before.
        with opened(url) as line:
            assert ask(line, b"@RESET\r") == b"1\r"


@pytest.mark.parametrize("tcp", WAYS)
def test_more_lines_than_can_wait_are_all_carried_out(tcp: int | None) -> None:
    with lab(None, tcp) as (_, url), opened(url) as line:
        sending = threading.Thread(target=line.write, args=(b"@STEP 240,1\r" * 1000,))
        sending.start()
        assert b"".join(line.read_until(b"\r") for _ in range(1000)) == b"1\r" * 1000
        sending.join(PATIENCE)
        assert ask(line, b"@READ\r", 2) == b"1\r1000,0,0,0,0,0,255\r"


@pytest.mark.parametrize("tcp", WAYS)
def test_10_mb_without_an_end_are_neither_held_nor_waited_for(tcp: int | None) -> None:
    with (
        lab(None, tcp) as (served, url),
        opened(url) as line,
    ):
        for _ in range(160):
            line.write(b"\xff@\x00STEP" * 10_000)
        assert len(served.server.attendant._coming) <= READ
        assert served.do(lambda rig: len(rig.controller._stream)) <= LONGEST
        assert ask(line, b"\r") == b"0\r"
        assert ask(line, b"@RESET\r") == b"1\r"


@pytest.mark.parametrize("tcp", WAYS)
def test_every_line_of_a_storm_of_bytes_is_answered(tcp: int | None) -> None:
    storm = Random(1).randbytes(100_000)
    lines = storm.count(b"\r")
    with lab(None, tcp) as (_, url), opened(url) as line:
        sending = threading.Thread(target=line.write, args=(storm,))
        sending.start()
        answers = [line.read_until(b"\r") for _ in range(lines)]
        sending.join(PATIENCE)
        assert set(answers) <= {b"0\r", b"1\r", b"2\r"}
        # What is left of it has no end yet.
        assert ask(line, b"\r") == b"0\r"
        assert ask(line, b"@READ\r", 2).startswith(b"1\r")


def test_only_one_is_at_the_other_end_of_a_port() -> None:
    with lab(None, 0) as (served, url), opened(url) as line:
        assert ask(line, b"@RESET\r") == b"1\r"
        host, port = served.port.name.split(":")
        with socket.create_connection((host, int(port)), PATIENCE) as other:
            assert other.recv(10) == b""
        assert ask(line, b"@RESET\r") == b"1\r"


def test_a_port_that_is_in_use_is_told_in_one_line() -> None:
    port = TcpPort(0)
    with pytest.raises(
        EndpointError, match=rf"^127\.0\.0\.1:{port.number}: Address already in use$"
    ):
        TcpPort(port.number)
    port.close()


def test_a_system_without_pseudo_terminals_is_told_of(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pty", None)
    with pytest.raises(EndpointError, match="no pseudo-terminals; --tcp PORT"):
        PseudoTerminal()
    assert "\n" not in endpoints.NO_PTY


@posix
def test_a_device_that_was_opened_by_nobody_passes_bytes_as_they_are() -> None:
    port = PseudoTerminal()
    assert not port.left()
    assert not port.connected
    assert port.send(b"lost") == 4
    client = os.open(port.name, os.O_RDWR | os.O_NOCTTY)
    assert not port.left()
    assert port.connected
    every = bytes(range(256))
    os.write(client, every)
    assert port.receive(300) == every
    port.send(every)
    assert os.read(client, 300) == every
    port.send(b"for nobody else")
    os.close(client)
    assert port.left()
    assert not port.left()
    client = os.open(port.name, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
    assert not port.left()
    with pytest.raises(BlockingIOError):
        os.read(client, 1)
    os.close(client)
    port.close()


@posix
def test_who_comes_and_goes_between_two_looks_leaves_nothing_behind() -> None:
    port, rig = PseudoTerminal(), Rig(SETTINGS)
    attendant = Attendant(port, rig)
    for left in (b"@STEP 240,100\r", b"@READ\n"):
        client = os.open(port.name, os.O_WRONLY | os.O_NOCTTY)
        os.write(client, left)
        os.close(client)
        attendant.attend()
        assert attendant.lines[-1].text == "(hung up)"
        rig.run_for(1)
        assert not attendant.attend()
    assert rig.registers == (0, 0, 0, 0, 0, 0)
    client = os.open(port.name, os.O_RDWR | os.O_NOCTTY)
    os.write(client, b"@RESET\r")
    attendant.attend()
    rig.run_for(1)
    attendant.attend()
    assert os.read(client, 10) == b"1\r"
    os.close(client)
    port.close()


@posix
@pytest.mark.parametrize(
    ("owner", "name"),
    [(endpoints, "_shut"), (PseudoTerminal, "left")],
    ids=["while it is looked for them", "just behind the look"],
)
def test_who_comes_about_the_look_for_them_loses_nothing(
    monkeypatch: pytest.MonkeyPatch, owner: object, name: str
) -> None:
    port, rig = PseudoTerminal(), Rig(SETTINGS)
    attendant = Attendant(port, rig)
    look = getattr(owner, name)
    clients: list[int] = []

    def come(looking: object) -> bool:
        seen = look(looking)
        if not clients:
            clients.append(os.open(port.name, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK))
            os.write(clients[0], b"@READ\r")
        return seen

    monkeypatch.setattr(owner, name, come)
    for _ in range(3):
        attendant.attend()
        rig.run_for(1)
    assert os.read(clients[0], 100).startswith(b"1\r0,0,0,0,0,0")
    os.close(clients[0])
    port.close()


class Deaf:
    """A port whose client sends without end and reads nothing."""

    name, connected = "deaf", True

    def __init__(self) -> None:
        self.taken = 0

    def left(self) -> bool:
        return False

    def receive(self, most: int) -> bytes:
        self.taken += most
        return (b"@QDUMP\r" * most)[:most]

    def send(self, data: bytes) -> int:
        return 0

    def wait(self, seconds: float, others=(), *, sending: bool = False) -> None: ...

    def close(self) -> None: ...


def test_who_reads_no_answers_is_not_listened_to_for_ever() -> None:
    port, rig = Deaf(), Rig(SETTINGS)
    attendant = Attendant(port, rig)
    rig.receive(b"".join(b"@QWRITE %d,1,2,3,4,5,6,7\r" % step for step in range(1, 54)))
    for _ in range(2000):
        attendant.attend()
        rig.run_for(1)
    assert port.taken <= 4 * READ
    assert UNSENT <= len(attendant._going) < UNSENT + 64 * 2000
    assert rig.controller is not None
    assert not rig.controller.busy


# -- the server -----------------------------------------------------------------------------------


class Nobody(Deaf):
    """A port where nobody is."""

    connected = False

    def receive(self, most: int) -> bytes:
        return b""


def test_time_passes_with_the_wall_and_a_sleep_of_the_computer_is_not_made_up() -> None:
    now = 0.0
    rig = Rig(SETTINGS)
    server = Server(rig, Nobody(), 2.0, wall=lambda: now)
    begun = rig.time
    for now in (0.1, 0.2, 0.3, 1000.0):  # noqa: B007
        server.turn()
    assert rig.time - begun == pytest.approx(2 * (0.3 + 0.5), abs=0.01)


def test_as_fast_as_can_be_only_while_the_arm_works_and_no_hands_are_needed() -> None:
    now = 0.0
    rig = Rig(SETTINGS)
    server = Server(rig, Nobody(), None, wall=lambda: now)
    begun = rig.time
    rig.receive(b"@STEP 0,300\r")
    server.turn()
    assert rig.registers[0] == 300
    assert rig.time - begun > 6
    rig.receive(b"@SET\r")
    server.turn()
    begun, now = rig.time, 0.1
    server.turn()
    assert rig.time - begun == pytest.approx(0.1, abs=0.01)
    assert server.rest > 0


def test_keys_of_the_pendant_are_typed_and_enter_alone_is_the_stop_key(
    capsys: pytest.CaptureFixture[str],
) -> None:
    rig = Rig(SETTINGS, benchfile.parse(HIGH, "bench"))
    server = Server(rig, Nobody(), 1.0)
    answers: list[bytes] = []
    rig.watch_answers(answers.append)
    for line, pressed, answer in (
        (b"@STEP 200,900\r", "", b"2\r"),
        (b"@SET\r", "move", b"1\r"),
        (b"@SET\r", " Stop \n", b"2\r"),
    ):
        rig.receive(line)
        rig.run_for(0.1)
        server.press(pressed)
        rig.run_for(0.1)
        assert answers.pop() == answer
    rig.receive(b"@SET\r")
    rig.run_for(0.1)
    before = rig.registers
    server.press("shoulder_plus")
    assert rig.registers[1] < before[1]
    server.press("\x1b]0;X\x07")
    told = capsys.readouterr().err
    assert told.startswith("trs80arm: the pendant has no key")
    assert told[:-1].isprintable()


@posix
def test_typed_keys_are_looked_at_without_waiting() -> None:
    reader, writer = os.pipe()
    with os.fdopen(reader) as stream:
        keys = Keys(stream)
        assert keys.watched == (reader,)
        assert keys.lines() == []
        os.write(writer, b"mo")
        assert keys.lines() == []
        os.write(writer, b"ve\n\nst\xff")
        assert keys.lines() == ["move", ""]
        os.close(writer)
        assert keys.lines() == []
        assert keys.watched == ()


def test_a_stream_that_is_no_file_has_no_keys() -> None:
    keys = Keys(StringIO("move\n"))
    assert keys.watched == ()
    assert keys.lines() == []


# -- the command ----------------------------------------------------------------------------------


@posix
def test_the_command_prints_where_the_line_is_and_serves_it() -> None:
    words = [sys.executable, "-m", "trs80arm", "serial", "--speed", "max", "--log"]
    with subprocess.Popen(
        words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        assert process.stdout is not None
        path = process.stdout.readline().decode().strip()
        with serial.Serial(path, 9600, timeout=PATIENCE) as line:
            assert ask(line, b"@STEP 100, 250\r") == b"1\r"
            assert ask(line, b"@READ\r", 2) == b"1\r250,0,0,0,0,0,255\r"
        logged = [process.stdout.readline().decode().split(None, 1)[1] for _ in range(5)]
        process.terminate()
        _, errors = process.communicate(timeout=PATIENCE)
    assert [text.strip() for text in logged] == [
        "> @STEP 100, 250",
        "< 1",
        "> @READ",
        "< 1",
        "< 250,0,0,0,0,0,255",
    ]
    assert errors == b""
