"""How much the terminal costs, and how quick it is, through a real pty.

- the time from the start to the first whole frame, least of several starts, of modules that an
  earlier start has compiled, as those of an installed program are;
- the share of one core and the bytes a second: at READY, in a pause, with a dialog open, while
  Table 4's demonstration runs, and while it runs behind a dialog, while the arm swings to and fro
  without a pause, and the same with the arm in space in each style, at some sizes of the window;
- the time from the bytes of a key to its switch in the matrix, and to its letter on the screen, at
  speed 20, for at speed 1 the ROM alone takes 51.6 ms from the one to the other;
- how far the virtual clock strays from the wall's.

    python -m benchmarks.terminal [--seconds 10] [--sizes 80x24 120x40 200x60]
"""

from __future__ import annotations

import argparse
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

from trs80arm.options import ArmStyle

ROOT = Path(__file__).parents[1]
STARTS = 5
KEYS = 40
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

    def told(self, what: str) -> list[list[float]]:
        """What was reported of one kind."""
        lines = self.report.read_text().splitlines()
        return [entry[1:] for entry in map(json.loads, lines) if entry[0] == what]

    def measure(self, what: str, seconds: float) -> None:
        """Print the share of one core, and the bytes a second, over some seconds."""
        before, bytes_before = self.told("clock")[-1], self.bytes
        time.sleep(seconds)
        after = self.told("clock")[-1]
        passed = after[0] - before[0]
        share = (after[2] - before[2]) / passed
        written = (self.bytes - bytes_before) / passed / 1000
        print(f"  {what:24} {share:6.1%} of one core {written:8.1f} kB/s")


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


def measure_start(size: tuple[int, int]) -> None:
    """From the start of Python to the last words of the greeting on the screen."""
    times = []
    for _ in range(STARTS):
        with sitting(size, watched=False) as program:
            times.append(program.wait_for(b"F10 LEAVES.") - program.began)
    print(f"  first frame: {min(times):.2f} s (most {max(times):.2f} s)")


def measure_costs(size: tuple[int, int], seconds: float) -> None:
    """What it costs while nothing happens, and while everything does."""
    with sitting(size) as idle:
        time.sleep(4)
        idle.measure("at READY", seconds)
        for key, what in ((HELP, "help open"), (DIALOG, "a list open")):
            idle.send(key)
            time.sleep(2)
            idle.measure(what, seconds)
            idle.send(ESCAPE)
            time.sleep(1)
        idle.send(PAUSE)
        time.sleep(2)
        idle.measure("paused", seconds)
    with sitting(size, "demo") as demo:
        time.sleep(25)
        before = demo.told("clock")[-1]
        demo.measure("the demonstration", seconds)
        demo.send(DIALOG)
        time.sleep(2)
        demo.measure("behind a list", seconds)
        after = demo.told("clock")[-1]
        drift = (after[1] - before[1]) / (after[0] - before[0]) - 1
        print(f"  clock against the wall: {drift:+.2%}")


def measure_moving(size: tuple[int, int], seconds: float) -> None:
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
                swings.measure(f"in space, {style}" if style else "the arm swings", seconds)


def measure_latency(size: tuple[int, int]) -> None:
    """From the bytes of a key to its switch, and to the letter at the prompt."""
    to_matrix, to_screen = [], []
    # A cursor that blinks is not always to be seen behind its letter.
    with sitting(size, "--cursor", "steady", "--speed", "20") as program:
        program.wait_for(b"F10 LEAVES.")
        time.sleep(4)
        for number in range(KEYS):
            letter = chr(ord("A") + number % 26)
            with program.heard:
                program.output = b""
            sent = program.send(letter.lower())
            to_screen.append(program.wait_for(letter.encode() + b"_") - sent)
            pressed = [moment for moment, key in program.told("press") if key == letter]
            to_matrix.append(pressed[-1] - sent)
            time.sleep(0.25)
    for what, waits in (("the matrix", to_matrix), ("the screen", to_screen)):
        ordered = sorted(1000 * wait for wait in waits)
        middle, late = ordered[len(ordered) // 2], ordered[int(len(ordered) * 0.95)]
        print(f"  key to {what}: median {middle:.1f} ms, 95 % {late:.1f} ms")


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=10.0)
    parser.add_argument("--sizes", nargs="+", default=["80x24", "120x40", "200x60"])
    chosen = parser.parse_args()
    with tempfile.TemporaryDirectory() as compiled:
        os.environ["PYTHONPYCACHEPREFIX"] = compiled
        os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
        for name in chosen.sizes:
            width, height = map(int, name.split("x"))
            print(f"{name}:")
            measure_start((width, height))
            measure_latency((width, height))
            measure_costs((width, height), chosen.seconds)
            measure_moving((width, height), chosen.seconds)


if __name__ == "__main__":
    main()
