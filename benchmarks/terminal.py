"""How much the terminal costs, and how quick it is, through a real pty.

- the share of one core and the bytes a second: at READY, in a pause, with a dialog open, while
  Table 4's demonstration runs, and while it runs behind a dialog, while the arm swings to and fro
  without a pause, and the same with the arm in space in each style, at some sizes of the window;
- the time from the bytes of a key to its switch in the matrix, and to its letter on the screen, at
  speed 20, for at speed 1 the ROM alone takes 51.6 ms from the one to the other;
- how far the virtual clock strays from the wall's.
"""

from __future__ import annotations

import json
import os
import pty
import select
import subprocess
import sys
import tempfile
import termios
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from statistics import median, quantiles
from typing import Any

from benchmarks.compiled import compiled_modules
from benchmarks.rows import Row
from trs80arm.options import ArmStyle

ROOT = Path(__file__).parents[1]
SIZES = ((80, 24), (120, 40), (200, 60))
LASTING = 20
"""Seconds on the wall of each figure, a second asked for."""
KEYS = 80
"""Keys pressed, a second asked for."""
PAUSE, DIALOG, HELP, ESCAPE = "\x1b[17~", "\x1b[19~", "\x1bOP", "\x1b"
SWINGS = """10 @STEP 50,-200,-200,0,0,0,0
20 @STEP 50,400,-60,60,40,40,0
30 @STEP 50,-400,60,-60,-40,-40,0
40 GOTO 20
"""
"""A program that raises the arm and moves five joints to and fro, and never pauses."""
IN_SPACE = "\x1bOS"
"""The key that brings the arm in space to the place of its other views, where they share one."""
PROGRAM = """
import json, sys, threading, time
report = open(sys.argv.pop(1), "a", buffering=1)
from trs80arm.machine.keyboard import Matrix
real_press = Matrix.press
def press(self, key):
    real_press(self, key)
    report.write(json.dumps(["press", time.monotonic(), str(key)]) + "\\n")
Matrix.press = press
from trs80arm.ui.app import Trs80Arm
real_ready = Trs80Arm.on_ready
def on_ready(self):
    def tell():
        while True:
            entry = ["clock", time.monotonic(), self.session.time, time.process_time()]
            report.write(json.dumps(entry) + "\\n")
            time.sleep(0.5)
    threading.Thread(target=tell, daemon=True).start()
    real_ready(self)
Trs80Arm.on_ready = on_ready
from trs80arm.cli import main
main()
"""


class Sitting:
    """The program in a pty whose output is read.

    Args:
        folder: for its files.
        size: columns and rows.
        arguments: of the program.
        watched: whether the program reports on itself, which costs it a little.
    """

    def __init__(
        self, folder: Path, size: tuple[int, int], *arguments: str, watched: bool = True
    ) -> None:
        self.report = folder / f"report-{time.monotonic_ns()}.jsonl"
        self.report.touch()
        self.master, slave = pty.openpty()
        termios.tcsetwinsize(slave, (size[1], size[0]))
        environment = os.environ | {
            "TERM": "xterm-256color",
            "COLORTERM": "truecolor",
            "LANG": "C.UTF-8",
            "TRS80ARM_STATE": str(folder / "state"),
            "TRS80ARM_CONFIG": str(folder / "settings.toml"),
        }
        how = ["-c", PROGRAM, str(self.report)] if watched else ["-m", "trs80arm"]
        self.began = time.monotonic()
        self.process = subprocess.Popen(
            [sys.executable, *how, *arguments],
            stdin=slave,
            stdout=slave,
            stderr=slave,
            env=environment,
            cwd=ROOT,
        )
        os.close(slave)
        self.bytes = 0
        self.output = b""
        self.heard = threading.Condition()
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self) -> None:
        while self.process.poll() is None:
            if select.select([self.master], [], [], 0.1)[0]:
                try:
                    data = os.read(self.master, 65536)
                except OSError:
                    return
                with self.heard:
                    self.bytes += len(data)
                    self.output = (self.output + data)[-200_000:]
                    self.heard.notify_all()

    def wait_for(self, text: bytes, seconds: float = 30.0) -> float:
        """Wait until something is written; when it was."""
        with self.heard:
            if not self.heard.wait_for(lambda: text in self.output, seconds):
                raise TimeoutError(text)
        return time.monotonic()

    def send(self, data: str) -> float:
        """Press; when it was done."""
        now = time.monotonic()
        os.write(self.master, data.encode())
        return now

    def told(self, what: str) -> list[list[Any]]:
        """What was reported of one kind."""
        lines = self.report.read_text().splitlines()
        return [entry[1:] for entry in map(json.loads, lines) if entry[0] == what]

    def measure(self, what: str, seconds: float) -> Row:
        """The share of one core, and the bytes a second, over some seconds."""
        before, bytes_before = self.told("clock")[-1], self.bytes
        time.sleep(seconds)
        while (after := self.told("clock")[-1]) == before:
            time.sleep(0.1)
        passed = after[0] - before[0]
        share = (after[2] - before[2]) / passed
        written = (self.bytes - bytes_before) / passed / 1000
        return Row(what, {"% of a core": 100 * share, "kB/s": written})


@contextmanager
def sitting(size: tuple[int, int], *arguments: str, watched: bool = True) -> Iterator[Sitting]:
    """A sitting that is ended afterwards."""
    with tempfile.TemporaryDirectory() as name:
        opened = Sitting(Path(name), size, *arguments, watched=watched)
        try:
            yield opened
        finally:
            opened.process.terminate()
            opened.process.wait(timeout=20)


def first_frame(size: tuple[int, int]) -> float:
    """Seconds from the start of Python to the last words of the greeting on the screen."""
    with sitting(size, watched=False) as program:
        return program.wait_for(b"F10 LEAVES.") - program.began


def costs(size: tuple[int, int], seconds: float) -> Iterator[Row]:
    """What it costs while nothing happens, and while everything does."""
    with sitting(size) as idle:
        time.sleep(4)
        yield idle.measure("at READY", seconds)
        for key, what in ((HELP, "help open"), (DIALOG, "a list open")):
            idle.send(key)
            time.sleep(2)
            yield idle.measure(what, seconds)
            idle.send(ESCAPE)
            time.sleep(1)
        idle.send(PAUSE)
        time.sleep(2)
        yield idle.measure("paused", seconds)
    with sitting(size, "demo") as demo:
        time.sleep(25)
        before = demo.told("clock")[-1]
        yield demo.measure("the demonstration", seconds)
        demo.send(DIALOG)
        time.sleep(2)
        yield demo.measure("behind a list", seconds)
        after = demo.told("clock")[-1]
        drift = (after[1] - before[1]) / (after[0] - before[0]) - 1
        yield Row("clock against the wall", {"% off": 100 * drift})


def moving(size: tuple[int, int], seconds: float) -> Iterator[Row]:
    """What an arm costs that never stands still."""
    with tempfile.TemporaryDirectory() as name:
        path = Path(name) / "swings.bas"
        path.write_text(SWINGS)
        for style in ("", *(style for style in ArmStyle if style is not ArmStyle.PIXELS)):
            chosen = ("--arm-style", style) if style else ()
            with sitting(size, str(path), "--run", *chosen) as swings:
                time.sleep(5)
                if style:
                    swings.send(IN_SPACE)
                    time.sleep(1)
                yield swings.measure(f"in space, {style}" if style else "the arm swings", seconds)


def latency(size: tuple[int, int], keys: int) -> Iterator[Row]:
    """From the bytes of a key to its switch, and to the letter at the prompt."""
    to_matrix, to_screen = [], []
    # A cursor that blinks is not always to be seen behind its letter.
    with sitting(size, "--cursor", "steady", "--speed", "20") as program:
        program.wait_for(b"F10 LEAVES.")
        time.sleep(4)
        for number in range(keys):
            letter = chr(ord("A") + number % 26)
            with program.heard:
                program.output = b""
            sent = program.send(letter.lower())
            to_screen.append(program.wait_for(letter.encode() + b"_") - sent)
            pressed = [moment for moment, key in program.told("press") if key == letter]
            to_matrix.append(pressed[-1] - sent)
            time.sleep(0.25)
    for what, waits in (("the matrix", to_matrix), ("the screen", to_screen)):
        late = quantiles(waits, n=20)[-1]
        yield Row(f"key to {what}", {"ms, median": 1000 * median(waits), "ms, 95 %": 1000 * late})


def rows(seconds: float) -> Iterator[Row]:
    """Each figure at each size."""
    lasting = LASTING * seconds
    with compiled_modules():
        for size in SIZES:
            name = "{}x{}".format(*size)
            measured = (
                latency(size, max(2, int(KEYS * seconds))),
                costs(size, lasting),
                moving(size, lasting),
            )
            for part in measured:
                for row in part:
                    yield Row(f"{name}: {row.name}", row.measures)
