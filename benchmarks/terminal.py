"""How much the terminal costs, and how quick it is.

Three figures, each through a real pty: the share of one core that the running Table 4
demonstration takes at 120 x 40 and 30 frames a second; the time from a key's bytes in the pty to
its switch in the matrix, at speed 1 and flat out; how far the virtual clock strays from the wall's
over a minute.

    python benchmarks/terminal.py [--seconds 60]
"""

from __future__ import annotations

import argparse
import json
import os
import pty
import select
import subprocess
import sys
import termios
import threading
import time
from pathlib import Path

ROOT = Path(__file__).parents[1]
PROGRAM = """
import json, os, sys, time, threading
from trs80arm.ui.app import Trs80Arm as Desk
from trs80arm.ui.keys.keyboard import Keyboard
report = open(sys.argv.pop(1), "a", buffering=1)
real_draw, real_tick = Desk.draw, Desk.tick
def tick(self):
    real_tick(self)
    now = time.monotonic()
    if now >= getattr(self, "_told", 0):
        self._told = now + 1
        report.write(json.dumps(["clock", now, self.session.time, time.process_time()]) + "\\n")
Desk.tick = tick
def draw(self, now=None):
    self._frames = getattr(self, "_frames", 0) + 1
    began = time.perf_counter()
    real_draw(self, now)
    self._cost = getattr(self, "_cost", 0) + time.perf_counter() - began
    if self._frames % 100 == 0:
        report.write(json.dumps(["frames", time.monotonic(), self._frames, self._cost]) + "\\n")
Desk.draw = draw
from trs80arm.rig import Rig
from trs80arm.machine.keyboard import Matrix
real_press = Matrix.press
def press(self, key):
    real_press(self, key)
    report.write(json.dumps(["press", time.monotonic(), str(key)]) + "\\n")
Matrix.press = press
from trs80arm.cli import main
main()
"""


class Sitting:
    """The program in a pty whose output is read and thrown away."""

    def __init__(self, folder: Path, *arguments: str) -> None:
        self.report = folder / f"report-{time.monotonic_ns()}.jsonl"
        self.report.touch()
        self.master, slave = pty.openpty()
        termios.tcsetwinsize(slave, (40, 120))
        environment = os.environ | {
            "TERM": "xterm-256color",
            "COLORTERM": "truecolor",
            "LANG": "C.UTF-8",
            "TRS80ARM_STATE": str(folder / "state"),
            "TRS80ARM_CONFIG": str(folder / "settings.toml"),
        }
        self.process = subprocess.Popen(
            [sys.executable, "-c", PROGRAM, str(self.report), *arguments],
            stdin=slave,
            stdout=slave,
            stderr=slave,
            env=environment,
            cwd=ROOT,
        )
        os.close(slave)
        self.bytes = 0
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self) -> None:
        while self.process.poll() is None:
            if select.select([self.master], [], [], 0.1)[0]:
                try:
                    self.bytes += len(os.read(self.master, 65536))
                except OSError:
                    return

    def send(self, data: str) -> float:
        """Press; when it was done."""
        now = time.monotonic()
        os.write(self.master, data.encode())
        return now

    def told(self, what: str) -> list[list[float]]:
        """What was reported of one kind."""
        lines = self.report.read_text().splitlines()
        return [entry[1:] for entry in map(json.loads, lines) if entry[0] == what]

    def leave(self) -> None:
        """End the program."""
        self.send("\x11")
        time.sleep(0.3)
        self.send("\x03")
        self.process.wait(timeout=20)


def measure_demo(folder: Path, seconds: float) -> None:
    """CPU share, frames, and the clock over the running demonstration."""
    sitting = Sitting(folder, "demo")
    time.sleep(25)
    before = (sitting.told("clock")[-1], sitting.told("frames")[-1], sitting.bytes)
    time.sleep(seconds)
    after = (sitting.told("clock")[-1], sitting.told("frames")[-1], sitting.bytes)
    sitting.leave()
    sitting_time = after[0][0] - before[0][0]
    share = (after[0][2] - before[0][2]) / sitting_time
    drift = (after[0][1] - before[0][1]) / sitting_time - 1
    frames = (after[1][1] - before[1][1]) / (after[1][0] - before[1][0])
    cost = (after[1][2] - before[1][2]) / (after[1][1] - before[1][1])
    print(f"demo at 120x40: {share:.1%} of one core, {frames:.1f} frames/s,", end=" ")
    print(
        f"{cost * 1000:.2f} ms to draw one, {(after[2] - before[2]) / sitting_time / 1000:.1f} kB/s"
    )
    print(f"clock against the wall over {sitting_time:.0f} s: {drift:+.2%}")


def measure_latency(folder: Path, speed: str, program: Path, keys: int = 60) -> None:
    """From the bytes of a key to its switch."""
    sitting = Sitting(folder, str(program), "--run", "--speed", speed)
    time.sleep(6)
    sent = []
    for _ in range(keys):
        sent.append(sitting.send("a"))
        time.sleep(0.23)
    time.sleep(0.5)
    pressed = [moment for moment, key in sitting.told("press") if key == "A"]
    sitting.leave()
    waits = sorted(1000 * (down - up) for up, down in zip(sent, pressed, strict=False))
    print(
        f"key to matrix at speed {speed}, {len(waits)} of {keys} keys: median "
        f"{waits[len(waits) // 2]:.1f} ms, 95 % {waits[int(len(waits) * 0.95)]:.1f} ms, "
        f"most {waits[-1]:.1f} ms"
    )


def main() -> None:
    """Measure and print."""
    import tempfile

    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=60.0)
    chosen = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        loop = folder / "loop.bas"
        loop.write_text("10 A$=INKEY$\n20 X=X+1\n30 GOTO 10\n")
        measure_latency(folder, "1", loop)
        measure_latency(folder, "max", loop)
        measure_demo(folder, chosen.seconds)


if __name__ == "__main__":
    main()
