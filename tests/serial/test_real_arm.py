"""From a program through the wire to the parts on the other arm's bench, end to end.

The other arm is a TeachMover with its own computer and its own bench, behind a pseudo-terminal. It
does everything at once, as its time is virtual.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from hypothesis import example, given, settings
from hypothesis import strategies as st

from tests.serial.lab import HIGH, SETTINGS
from trs80arm import Rig, RigSettings
from trs80arm.arm import ArmSettings, EventKind, benchfile
from trs80arm.cli.commands import cli
from trs80arm.operator import Operator, parse_holds
from trs80arm.rig import Waiting
from trs80arm.serial.courier import Courier
from trs80arm.serial.limits import PlugSettings
from trs80arm.serial.port import Port
from trs80arm.serial.wire import WireError

tty = pytest.importorskip("tty", reason="there are no pseudo-terminals")
PROGRAMS = Path(__file__).parents[2] / "programs"
TABLE4 = PROGRAMS / "table4-teachmover.bas"
BENCH = PROGRAMS / "table4.toml"


@pytest.fixture(autouse=True)
def no_settings(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Keep the settings of whoever runs the tests out of them."""
    empty = tmp_path / "settings.toml"
    empty.write_text("")
    monkeypatch.setenv("TRS80ARM_CONFIG", str(empty))


class FarArm:
    """A TeachMover behind a pseudo-terminal.

    Attributes:
        rig: the arm, its computer and its bench.
        path: of the pseudo-terminal.
        lines: how many came.
        hangs_up_at: the line at which the wire is cut; None for none.
        noise: what is answered instead, if anything.
        asked: whether anything has come.
        moved: whether a motion has been asked for.
    """

    def __init__(self, bench: Path = BENCH) -> None:
        self.rig = Rig(SETTINGS, benchfile.load(bench))
        self._master, self._slave = os.openpty()
        tty.setraw(self._slave)
        self.path = os.ttyname(self._slave)
        self.lines = 0
        self.hangs_up_at: int | None = None
        self.noise: bytes | None = None
        self.asked = threading.Event()
        self.moved = threading.Event()
        self.rig.watch_answers(lambda answer: os.write(self._master, answer))
        self._thread = threading.Thread(target=self._serve, daemon=True)
        self._thread.start()

    def _serve(self) -> None:
        with suppress(OSError):
            while data := os.read(self._master, 4096):
                self.lines += data.count(b"\r")
                self.asked.set()
                if b"@STEP" in data:
                    self.moved.set()
                if self.hangs_up_at is not None and self.lines >= self.hangs_up_at:
                    os.close(self._slave)
                    os.close(self._master)
                    return
                if self.noise is not None:
                    os.write(self._master, self.noise)
                    continue
                self.rig.receive(data)
                self.rig.run_until(lambda rig: not rig.controller.busy, 600)

    def end(self) -> None:
        for each in (self._slave, self._master):
            with suppress(OSError):
                os.close(each)
        self._thread.join(0.2)


@contextmanager
def far_arm(bench: Path = BENCH) -> Iterator[FarArm]:
    far = FarArm(bench)
    try:
        yield far
    finally:
        far.end()


def run(far: FarArm, *arguments: object, program: Path = TABLE4, yes: bool = True) -> Result:
    plug = ["--plug", f"serial:{far.path}", *(["--yes"] if yes else [])]
    given = [program, "--bench", BENCH, "--set", "0", *plug, *arguments]
    return CliRunner().invoke(cli, ["run", *map(str, given)])


def placed(rig: Rig) -> list[float]:
    """Where the one part is, inches, and its turn."""
    (part,) = rig.parts.values()
    return [*part.place, *part.turn]


def test_table_4_through_the_wire_puts_the_part_where_table_4_puts_it(tmp_path: Path) -> None:
    bench = tmp_path / "one.toml"
    bench.write_text(
        "[arm]\nat = [5, 0, 0]\npitch = -90\nopening = 0\n"
        '[[part]]\nname = "part"\nat = [8, 0]\nsize = [0.5, 0.5, 1]\nweight = 0.4\n'
    )
    here = Rig(RigSettings(arm=ArmSettings(model="teachmover")), benchfile.load(bench))
    here.load(TABLE4)
    here.type("RUN\r")
    Operator(here, sets=[parse_holds("0")]).run(22)
    with far_arm(bench) as far:
        done = run(far, "--seconds", 22, "--registers", "--bench", bench)
        assert (done.exit_code, done.stderr) == (0, "")
        assert here.parts["part"].place[1] == pytest.approx(5, abs=0.1), "it is there by then"
        assert placed(far.rig) == pytest.approx(placed(here), abs=0.01)
        registers = done.stdout.split("\n")[-2]
        assert " ".join(map(str, far.rig.controller.driver.registers)) == registers


def test_table_4_goes_on_for_ever_over_the_wire() -> None:
    with far_arm() as far:
        done = run(far, "--seconds", 60)
        assert (done.exit_code, done.stderr) == (0, "")
        delivered = [event for event in far.rig.events if event.kind is EventKind.DELIVERED]
        assert len(delivered) >= 6
        assert far.rig.state.slipped == (0,) * 6


def test_nothing_moves_without_a_yes() -> None:
    with far_arm() as far:
        done = run(far, yes=False)
        assert done.exit_code == 2
        assert done.stderr == f"trs80arm: nothing moves at {far.path} without --yes\n"
        assert far.lines == 0


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (("--plug-speed", 200), "The elbow would make 370 half-steps a second"),
        (("--plug-speed", 0), "speed must be 1 to 10000"),
        (("--plug-range", 200), "half-steps from where it stood, and may go 200"),
        (("--arm", "minimover5"), "the model beside it a MiniMover 5"),
        (("--junit", "x.xml"), "--plug is for one program"),
    ],
)
def test_what_may_not_be_is_one_sentence(arguments: tuple[object, ...], told: str) -> None:
    with far_arm() as far:
        done = run(far, "--seconds", 60, *arguments)
        assert done.exit_code == 2
        assert told in done.stderr
        assert done.stderr.count("\n") == 1
        assert far.rig.controller.driver.registers[0] == 0


def test_a_wire_that_is_cut_in_mid_motion_stops_the_program() -> None:
    with far_arm() as far:
        far.hangs_up_at = 5
        done = run(far, "--seconds", 60)
        assert done.exit_code == 2
        assert "RUN THE PROGRAM" not in done.stdout
        assert done.stderr.startswith("trs80arm: ")
        assert done.stderr.count("\n") == 1
        assert "wire" in done.stderr


@pytest.mark.parametrize(
    ("noise", "told"),
    [
        (b"\xff\x00\x80" * 300, "noise without end"),
        (b"\x07hello\r", "is no answer: "),
        (b"0\r", "refused @READ: it answered 0"),
        (b"2\r", "stop key"),
        (b"1\r1,2,3\r", "is no answer: '1,2,3'"),
    ],
)
def test_noise_is_one_sentence(noise: bytes, told: str) -> None:
    with far_arm() as far:
        far.noise = noise
        done = run(far)
        assert (done.exit_code, done.stdout) == (2, "")
        assert told in done.stderr
        assert done.stderr.count("\n") == 1
        assert done.stderr.isprintable() or done.stderr[:-1].isprintable()


def test_an_arm_that_says_nothing_is_not_waited_for_long() -> None:
    with far_arm() as far:
        far.noise = b""
        port = Port(far.path)
        with pytest.raises(WireError, match=r"did not answer @READ within 0\.1 s"):
            port.send(b"@READ\r", 2, 0.1)
        port.close()


def test_a_wire_that_is_gone_between_two_lines_is_dead() -> None:
    with far_arm() as far:
        port = Port(far.path)
        assert port.send(b"@READ\r", 2, 2.0)[0] == "1"
        far.end()
        with pytest.raises(WireError, match="The wire to the arm is dead"):
            port.send(b"@READ\r", 2, 2.0)
        port.close()
        with pytest.raises(WireError, match="The wire to the arm is dead"):
            port.send(b"@READ\r", 2, 2.0)


def test_a_port_that_is_not_there_is_told(tmp_path: Path) -> None:
    path = tmp_path / "ttyUSB0"
    done = CliRunner().invoke(cli, ["run", str(TABLE4), "--plug", f"serial:{path}", "--yes"])
    assert done.exit_code == 2
    assert done.stderr == f"trs80arm: {path}: No such file or directory\n"


def test_the_plug_is_a_serial_port_and_yes_is_for_it() -> None:
    for arguments, told in (
        (["--plug", "usb"], "--plug usb: expected serial: and a port"),
        (["--yes"], "--yes is for --plug"),
    ):
        done = CliRunner().invoke(cli, ["run", str(TABLE4), *arguments])
        assert done.exit_code == 2
        assert told in done.stderr


@pytest.fixture
def served() -> Iterator[str]:
    """The path of the arm that `trs80arm serial` serves, as fast as it can."""
    asked = ["serial", "--speed", "max", "--bench", str(BENCH)]
    with subprocess.Popen(
        [sys.executable, "-m", "trs80arm", *asked],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    ) as server:
        assert server.stdout is not None
        yield server.stdout.readline().strip()
        server.terminate()


def test_table_4_goes_through_the_wire_to_trs80arm_serial(served: str) -> None:
    assert served.startswith("/dev/")
    plug = ["--plug", f"serial:{served}", "--yes"]
    asked = [str(TABLE4), "--bench", str(BENCH), "--set", "0", "--seconds", "25", "--registers"]
    done = CliRunner().invoke(cli, ["run", *asked, *plug])
    assert (done.exit_code, done.stderr) == (0, "")
    port = Port(served)
    there = port.send(b"@READ\r", 2, 5.0)[1].split(",")[:6]
    port.close()
    assert " ".join(there) == done.stdout.split("\n")[-2]


def test_a_port_that_is_let_go_while_it_waits_stops_waiting() -> None:
    with far_arm() as far:
        far.noise = b""
        port, told = Port(far.path), []

        def ask() -> None:
            try:
                port.send(b"@CLOSE 200\r", 1, 60.0)
            except WireError as error:
                told.append(str(error))

        waiting = threading.Thread(target=ask)
        waiting.start()
        assert far.asked.wait(5)
        port.close()
        waiting.join(5)
        assert not waiting.is_alive()
        assert len(told) == 1


@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="Ctrl+C is another thing there")
def test_ctrl_c_ends_a_run_at_the_end_of_a_line() -> None:
    with far_arm() as far:
        plug = ["--plug", f"serial:{far.path}", "--yes"]
        asked = [str(TABLE4), "--bench", str(BENCH), "--set", "0", "--seconds", "100000"]
        with subprocess.Popen(
            [sys.executable, "-m", "trs80arm", "run", *asked, *plug],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
            # Who runs the tests in the background has Ctrl+C ignored, and so would a child.
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
        ) as running:
            try:
                assert far.moved.wait(30)
                running.send_signal(signal.SIGINT)
                _, told = running.communicate(timeout=20)
            finally:
                running.kill()
        assert (running.returncode, told) == (130, "")


class Direct:
    """A wire that is no wire: straight to the computer of another arm, in virtual time."""

    def __init__(self, rig: Rig) -> None:
        self._rig = rig
        self._heard = bytearray()
        rig.watch_answers(self._heard.extend)

    def send(self, line: bytes, answers: int, seconds: float) -> list[str]:
        self._heard.clear()
        begun = self._rig.time
        self._rig.receive(line)
        assert self._rig.run_until(lambda rig: not rig.controller.busy, 60)
        assert self._rig.time - begun < seconds, "the real arm would be given up"
        return self._heard.decode("ascii").split("\r")[:-1]

    def close(self) -> None:
        """There is nothing to let go of."""


moves = st.lists(
    st.tuples(st.integers(45, 200), *[st.integers(-90, 90)] * 6), min_size=1, max_size=4
)


@settings(max_examples=15, deadline=None)
@given(moves=moves)
@example(moves=[(45, 0, -14, 70, 0, 0, 0), (45, 0, -69, -4, 0, 0, 0), (45, 0, 25, 67, 0, 0, 0)])
@example(moves=[(45, 0, -83, 66, 0, 0, 0), (45, 0, 25, 67, 0, 0, 0), (45, 0, 0, 1, 0, 0, 0)])
def test_two_arms_on_a_wire_stand_alike(moves: list[tuple[int, ...]]) -> None:
    here = Rig(RigSettings(arm=ArmSettings(model="teachmover")), benchfile.parse(HIGH, "bench"))
    there = Rig(SETTINGS, benchfile.parse(HIGH, "bench"))
    courier = Courier(here, Direct(there), PlugSettings())
    for move in moves:
        here.type(f"@STEP {','.join(map(str, move))}\r")
        while here.typing or here.waiting is not Waiting.COMMAND:
            here.run_for(0.05)
            courier.deliver()
    courier.finish()
    courier.close()
    if not courier.fault:
        assert (there.joints, there.registers) == (here.joints, here.registers)
    else:
        assert "slipped" in courier.fault
    # At a stop a rotor is held back by half a ring, and has lost none yet.
    assert max(map(abs, there.state.slipped)) <= 4, "it did not befall the arm"
