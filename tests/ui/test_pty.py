"""The real program in a pty that plays a terminal; the terminal is left as it was found."""

from __future__ import annotations

import fcntl
import json
import os
import pty
import re
import select
import signal
import subprocess
import sys
import termios
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TypeAlias

import pytest

from tests import warm_start
from trs80arm.desk import recording
from trs80arm.files import load_program

PATIENCE = 40.0
"""Seconds of the wall after which something that should come has not come."""
OFTEN = 0.005
"""Seconds between two looks at what is looked at in no time."""
PROGRAM = "from trs80arm.cli import main; main()"
FAULTY = """
from trs80arm.ui.app import Trs80Arm as Desk
def fault(self, now=None):
    raise RuntimeError("forced")
real = Desk.draw
count = [0]
def draw(self, now=None):
    count[0] += 1
    if count[0] > 10:
        raise RuntimeError("forced")
    real(self, now)
Desk.draw = draw
from trs80arm.cli import main; main()
"""
IN_MANUAL_MODE = "0 ends"
"""What the status line says in `@SET`, in many words or in few."""
MODES = re.compile(rb"\x1b\[\?([\d;]+)([hl])")
STACK = re.compile(rb"\x1b\[([<>])(\d*)u")
COLOURS = re.compile(r"\x1b\[[\d;]*m")
PLACE = re.compile(r"\x1b\[(\d+);(\d+)H")
CODES = re.compile(
    r"\x1b\[(?P<row>\d+);(?P<column>\d+)H|\x1b\[[?<>=]?[\d;]*[A-Za-z]|(?P<sign>[^\x00-\x1f])"
)


Process: TypeAlias = "warm_start.Started | subprocess.Popen[bytes]"
Start: TypeAlias = Callable[[str, list[str], int, Path, dict[str, str]], Process]


def start_afresh(
    script: str, arguments: list[str], slave: int, folder: Path, environment: dict[str, str]
) -> subprocess.Popen[bytes]:
    """Start Python as a shell does, with all that it has to import."""
    return subprocess.Popen(
        [sys.executable, "-c", script, *arguments],
        stdin=slave,
        stdout=slave,
        stderr=slave,
        env=environment,
        cwd=folder,
        start_new_session=True,
    )


class Terminal:
    """A terminal with a program in it.

    Args:
        reports: whether it knows the Kitty keyboard protocol and reports releases.
        arguments: of the program.
        script: what Python runs.
        folder: for the program's files.
        start: starts it.
    """

    def __init__(
        self,
        folder: Path,
        arguments: list[str],
        *,
        reports: bool,
        script: str = PROGRAM,
        start: Start = warm_start.start,
    ) -> None:
        self.reports = reports
        self.output = b""
        self._answered = 0
        self.master, slave = pty.openpty()
        termios.tcsetwinsize(slave, (24, 80))
        self.before = termios.tcgetattr(slave)
        environment = os.environ | {
            "TERM": "xterm-256color",
            "LANG": "C.UTF-8",
            # What a shell may have left there of another window: the terminal has 80 and 24.
            "COLUMNS": "60",
            "LINES": "10",
            "TRS80ARM_STATE": str(folder / "state"),
            "TRS80ARM_CONFIG": str(folder / "settings.toml"),
        }
        self.slave = slave
        self.process = start(script, arguments, slave, folder, environment)

    def read(self, seconds: float) -> None:
        """Take what the program writes for so long, and answer what a terminal answers."""
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0 and self._read_more(left):
            pass

    def _read_more(self, seconds: float = 0.05) -> bool:
        """Take what it writes next, if that comes so soon; False when the terminal is gone."""
        ready, _, _ = select.select([self.master], [], [], seconds)
        if ready:
            try:
                self.output += os.read(self.master, 65536)
            except OSError:
                return False
            self._answer()
        return True

    def _answer(self) -> None:
        asked = self.output.count(b"\x1b[?u")
        if self.reports:
            for _ in range(asked - self._answered):
                os.write(self.master, b"\x1b[?31u\x1b[?62;22c")
        self._answered = asked

    def wait_for(self, text: str, since: int | None = None) -> None:
        """Wait until something is shown, from now on or since so many bytes of output."""
        start = len(self.output) if since is None else since
        end = time.monotonic() + PATIENCE
        while text.encode() not in self.output[start:]:
            assert time.monotonic() < end, (text, self.output[-2000:])
            assert self.process.poll() is None, self.output[-3000:]
            self._read_more()

    @property
    def screen(self) -> str:
        """What is seen: only what changes is written, be it a letter."""
        cells = [[" "] * 80 for _ in range(24)]
        row = column = 0
        for code in CODES.finditer(self.output.decode(errors="ignore")):
            if code["row"]:
                row, column = int(code["row"]) - 1, int(code["column"]) - 1
            elif code["sign"] and row < 24 and column < 80:
                cells[row][column] = code["sign"]
                column += 1
        return "\n".join(map("".join, cells))

    def send(self, data: str, seconds: float = 0.0) -> None:
        """Press keys, and let a little time pass."""
        os.write(self.master, data.encode())
        self.read(seconds)

    def type(self, text: str, shown: str | None = None) -> None:
        """Type text as this terminal spells it, and wait until something is seen for it."""
        for character in text:
            self.send(self._down(character))
            self.read(0.02)
            self.send(self._up(character))
        if shown is not None:
            self.until(lambda: shown in self.screen)

    def _down(self, character: str) -> str:
        if not self.reports:
            return character
        code = ord(character)
        return f"\x1b[{code}u" if character == "\r" else f"\x1b[{code};1:1;{code}u"

    def _up(self, character: str) -> str:
        return f"\x1b[{ord(character)};1:3u" if self.reports else ""

    def hold(self, characters: str, so: Callable[[], bool], seconds: float) -> None:
        """Hold keys together, for so long since something is so."""
        for character in characters:
            self.send(self._down(character))
        self.until(so)
        self.read(seconds)
        for character in characters:
            self.send(self._up(character))

    def click(self, word: str, since: int) -> None:
        """Click on a word that was drawn since so many bytes of output."""
        self.wait_for(word, since)
        drawn = COLOURS.sub("", self.output[since:].decode(errors="replace"))
        before = drawn[: drawn.rindex(word)]
        # Every row that is drawn begins with its place.
        *_, at = PLACE.finditer(before)
        row, column = int(at[1]), int(at[2]) + len(before) - at.end()
        self.send(f"\x1b[<0;{column};{row}M", 0.1)
        self.send(f"\x1b[<0;{column};{row}m")

    def until(self, so: Callable[[], bool], every: float = 0.05) -> None:
        """Wait until something is so: it is looked whenever something is written, and so often."""
        end = time.monotonic() + PATIENCE
        while not so():
            assert time.monotonic() < end, self.output[-2000:]
            self._read_more(every)

    def read_until_it_stands(self) -> None:
        """Take all that the program writes until it is suspended."""
        state = Path(f"/proc/{self.process.pid}/stat")
        if state.is_file():
            # Behind the name, which is in brackets.
            self.until(lambda: state.read_text().rpartition(") ")[2].startswith("T"), OFTEN)
        else:
            self.read(0.4)
        self._read_rest()

    def _read_rest(self) -> None:
        """Take what was written and not read."""
        while select.select([self.master], [], [], 0)[0]:
            self.read(0.01)

    def leave(self) -> int:
        """Wait until the program has ended; its exit code."""
        self.until(lambda: self.process.poll() is not None, OFTEN)
        # What it wrote before it ended is there by now.
        self._read_rest()
        code = self.process.poll()
        assert code is not None
        return code

    def is_as_it_was(self) -> bool:
        """Whether nothing of the program is left in the terminal."""
        modes: dict[bytes, bytes] = {}
        for numbers, state in MODES.findall(self.output):
            modes[numbers] = state
        on_at_first = {b"25", b"7"}
        left_on = [mode for mode, state in modes.items() if state == b"h"]
        left_off = [mode for mode, state in modes.items() if state == b"l" and mode in on_at_first]
        depth = sum(1 if sign == b">" else -1 for sign, _ in STACK.findall(self.output))
        attributes = termios.tcgetattr(self.slave)
        assert set(left_on) <= on_at_first, left_on
        assert not left_off, left_off
        assert depth == 0
        return attributes == self.before


@contextmanager
def terminal(
    folder: Path,
    *arguments: str,
    reports: bool = False,
    script: str = PROGRAM,
    start: Start = warm_start.start,
) -> Iterator[Terminal]:
    """A terminal that is cleared away at the end."""
    one = Terminal(folder, list(arguments), reports=reports, script=script, start=start)
    try:
        one.wait_for("READY")
        yield one
    finally:
        if one.process.poll() is None:
            os.killpg(one.process.pid, signal.SIGKILL)
            one.process.wait()
        os.close(one.master)
        os.close(one.slave)


def replayed_registers(path: Path) -> tuple[int, ...]:
    """Where a recorded session brings the registers."""
    session = recording.load(path)
    rig = session.rig()
    rig.replay(session.inputs)
    rig.run_to(session.end)
    return rig.registers


def done_with(path: Path, key: str) -> list[str]:
    """What a recording, which is still being written, says was done with a key."""
    whole = [line for line in path.read_text().splitlines(keepends=True)[1:] if line[-1] == "\n"]
    entries = [json.loads(line) for line in whole]
    return [entry["do"] for entry in entries if entry.get("with") == [key]]


@pytest.mark.parametrize(("reports", "keys"), [(True, "auto"), (False, "latch")])
def test_two_joints_are_jogged_at_once_and_the_terminal_is_left_alone(
    tmp_path: Path, reports: bool, keys: str
) -> None:
    """With release reports the keys are held; without, they are latched."""
    record = tmp_path / "session.jsonl"
    arguments = ("--record", str(record), "--keys", keys)
    with terminal(tmp_path, *arguments, reports=reports) as one:
        one.type("@SET\r", shown=IN_MANUAL_MODE)
        one.hold("1w", lambda: all(done_with(record, key) for key in "1W"), 0.3)
        if not reports:
            one.type(" ")
        one.until(lambda: len(done_with(record, "W")) == 2)
        one.type("0", shown="at READY")
        one.until(lambda: done_with(record, "0") == ["press", "release"])
        one.send("\x1b[21~")
        assert one.leave() == 0
        assert one.is_as_it_was()
    held: set[str] = set()
    most: set[str] = set()
    for done in recording.load(record).inputs:
        if done.action == "press":
            held.add(done.arguments[0])
        elif done.action == "release":
            held.discard(done.arguments[0])
        most = max(most, held, key=len).copy()
    assert most == {"1", "W"}
    assert not held
    base, shoulder = replayed_registers(record)[:2]
    assert base > 0
    assert shoulder < 0


def test_a_terminal_without_releases_jogs_by_taps(tmp_path: Path) -> None:
    record = tmp_path / "session.jsonl"
    with terminal(tmp_path, "--record", str(record)) as one:
        one.type("@SET\r", shown=IN_MANUAL_MODE)
        one.type("1")
        # Nobody tells that the key was let go: the program does it by itself.
        one.until(lambda: done_with(record, "1") == ["press", "release"])
        one.type("0", shown="at READY")
        one.send("\x11")
        assert one.leave() == 0
        assert one.is_as_it_was()
    assert done_with(record, "1") == ["press", "release"]
    assert replayed_registers(record)[0] > 0


@pytest.mark.parametrize("reports", [True, False])
def test_ctrl_c_twice_leaves_the_terminal_as_it_was(tmp_path: Path, reports: bool) -> None:
    with terminal(tmp_path, reports=reports, start=start_afresh) as one:
        one.send("\x1b[99;5u\x1b[99;5:3u" if reports else "\x03")
        one.wait_for("Leave trs80arm?")
        one.send("\x1b[99;5u\x1b[99;5:3u" if reports else "\x03")
        assert one.leave() == 0
        assert one.is_as_it_was()


@pytest.mark.parametrize("reports", [True, False])
def test_buttons_of_a_dialog_are_clicked_with_the_mouse(tmp_path: Path, reports: bool) -> None:
    with terminal(tmp_path, reports=reports) as one:
        for button in (" Back ", " Leave "):
            since = len(one.output)
            one.send("\x1b[99;5u\x1b[99;5:3u" if reports else "\x03")
            # The last of what is drawn of them.
            one.wait_for(" Back ", since)
            after = len(one.output)
            one.click(button, since)
            if button == " Back ":
                # What the dialog had covered.
                one.wait_for("ESCAPE IS BREAK", after)
        assert one.leave() == 0
        assert one.is_as_it_was()


def test_a_fault_leaves_the_terminal_as_it_was_and_keeps_the_program(tmp_path: Path) -> None:
    program = tmp_path / "mine.bas"
    program.write_text("10 PRINT 1\n")
    with terminal(tmp_path, str(program), reports=True, script=FAULTY) as one:
        assert one.leave() == 3
        assert one.is_as_it_was()
        assert b"RuntimeError" in one.output
        assert b"a fault of the program itself" in one.output
        assert b"Traceback" not in one.output
        assert (tmp_path / "state" / "fault-1.snapshot").is_file()
        assert "forced" in (tmp_path / "state" / "fault-1.txt").read_text()


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP, signal.SIGINT])
def test_told_to_end_it_keeps_the_program_and_leaves_the_terminal_as_it_was(
    tmp_path: Path, number: signal.Signals
) -> None:
    with terminal(tmp_path, "--speed", "5") as one:
        one.type("10 END\r?6*7\r", shown=" 42")
        os.kill(one.process.pid, number)
        assert one.leave() == 128 + number
        assert one.is_as_it_was()
        (kept,) = (tmp_path / "state").glob("recovered-*.bas")
        assert load_program(kept) == [(10, b"\x80")]
        assert str(kept) in re.sub(r"\s", "", one.output.decode())


def test_when_the_terminal_is_closed_it_keeps_the_program_and_ends(tmp_path: Path) -> None:
    one = Terminal(tmp_path, ["--speed", "5"], reports=False)
    one.wait_for("at READY")
    one.type("10 END\r?6*7\r", shown=" 42")
    os.close(one.slave)
    os.close(one.master)
    try:
        # A shell tells its children so, when its terminal goes.
        os.kill(one.process.pid, signal.SIGHUP)
        assert one.process.wait(PATIENCE) == 128 + signal.SIGHUP
    finally:
        one.process.kill()
    (kept,) = (tmp_path / "state").glob("recovered-*.bas")
    assert load_program(kept) == [(10, b"\x80")]


def test_when_the_terminal_goes_and_nobody_tells_it_ends_too(tmp_path: Path) -> None:
    one = Terminal(tmp_path, ["--speed", "5", "--keys", "repeat"], reports=False)
    try:
        one.wait_for("at READY")
        one.type("10 PRINT RND(0);:GOTO 10\rRUN\r", shown="running")
        # It writes more than anybody reads, as on a line that is dead, and waits.
        waiting = [0]
        while len(waiting) < 5 or waiting[-1] > waiting[-5]:
            time.sleep(0.1)
            waiting.append(unread(one.master))
        os.close(one.slave)
        os.close(one.master)
        assert one.process.wait(PATIENCE) == 128 + signal.SIGHUP
    finally:
        one.process.kill()
    assert list((tmp_path / "state").glob("recovered-*.bas"))


def unread(terminal: int) -> int:
    """Bytes that were written to a terminal and have not been read."""
    return int.from_bytes(fcntl.ioctl(terminal, termios.FIONREAD, bytes(4)), sys.byteorder)


def test_suspended_and_back_the_terminal_is_the_shells_in_between(tmp_path: Path) -> None:
    with terminal(tmp_path, reports=True) as one:
        one.send("\x1b[122;5u\x1b[122;5:3u")
        one.until(lambda: termios.tcgetattr(one.slave) == one.before, OFTEN)
        # What is written to a terminal that is given back already.
        one.read_until_it_stands()
        assert one.is_as_it_was()
        os.kill(one.process.pid, signal.SIGCONT)
        # All of the tube, not only what has changed since.
        one.wait_for("MEMORY SIZE?")
        one.send("\x1b[21~")
        assert one.leave() == 0
        assert one.is_as_it_was()


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["nowhere.bas"], "nowhere.bas: No such file or directory"),
        (["bad.bas"], "bad.bas"),
        (["--bench", "nowhere.toml"], "nowhere.toml"),
        (["--replay", "bad.bas"], "bad.bas: "),
        (["--record", "/nowhere/x"], "/nowhere/x: No such file or directory"),
        (["--theme", "puce"], "there is no theme 'puce'"),
        (["--speed", "3"], "expected one of 0.05, 0.1, 0.25, 0.5, 1, 2, 5, 20"),
    ],
)
def test_what_cannot_be_used_is_one_line_and_code_2(
    tmp_path: Path, arguments: list[str], told: str
) -> None:
    (tmp_path / "bad.bas").write_bytes(b"\x00\x01garbage")
    one = Terminal(tmp_path, arguments, reports=False)
    assert one.leave() == 2
    assert told in one.output.decode()
    assert one.output.decode().strip().count("\n") == 0
    assert one.is_as_it_was()


def test_without_a_terminal_it_says_what_to_do(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM],
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        cwd=tmp_path,
        check=False,
    )
    assert done.returncode == 2
    assert "--plain" in done.stderr
    assert done.stderr.count("\n") == 1
