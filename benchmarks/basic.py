"""How many BASIC statements a second the compiled language executes, beside hand-written Python.

    python -m benchmarks.basic [--statements] [NAME ...]

Each listing of `benchmarks/basic/`, made longer, is RUN until half a second of processor time has
gone. The last column compares it, in the same run, with the same work translated by hand into a
Python function that rounds every result to 24 bits in line and checks nothing: the most that
CPython could give.
"""

from __future__ import annotations

import argparse
import math
import sys
import time
from pathlib import Path

from benchmarks.by_hand import BY_HAND
from trs80arm.basic import cruncher
from trs80arm.basic.interpreter import Interpreter
from trs80arm.rig import Rig, RigSettings

LISTINGS = Path(__file__).parent / "basic"
STANDARD = [*(f"bm{i}" for i in range(1, 9)), "ahl", "sieve", "nestfor", "strings", "ik"]
"""The thirteen whose geometric mean is reported."""
LONGER = {
    **{f"bm{i}": ("1000", "100000") for i in range(1, 8)},
    "bm8": ("100 THEN", "5000 THEN"),
    "sieve": ("N=1", "N=5"),
    "nestfor": ("N=10", "N=60"),
    "strings": ("TO 200", "TO 4000"),
    "ik": ("N=100", "N=2000"),
}
"""How a listing is made to run so long that starting it does not count."""
ENOUGH = 0.5
FOREVER = 10**15


class Counter:
    """Counts statements as the machine's statement loop does."""

    def __init__(self) -> None:
        self.statements = 0

    def statement(self, line: int, address: int) -> None:
        """One more."""
        self.statements += 1


def load(name: str, blocks: bool) -> Interpreter:
    """A 48K machine with a listing in memory."""
    rig = Rig(RigSettings(ram_kib=48, blocks=blocks))
    rig.run_until_waiting(10.0)
    lines = []
    listing = (LISTINGS / f"{name}.bas").read_text(encoding="ascii")
    if name in LONGER:
        listing = listing.replace(*LONGER[name])
    for line in listing.splitlines():
        number, text = cruncher.split_line(line.encode("ascii"))
        if number is not None:
            lines.append((number, cruncher.crunch(text).text))
    rig.basic.load_lines(lines)
    return rig.basic


def run(basic: Interpreter) -> float:
    """RUN once; processor seconds."""
    basic.execute_direct(cruncher.crunch(b"RUN").text)
    basic.state.clock.limit = basic.state.clock.now + FOREVER
    start = time.process_time()
    basic.advance(until_waiting=True)
    return time.process_time() - start


def rate(name: str, blocks: bool) -> float:
    """Statements a second."""
    basic = load(name, blocks)
    counter = Counter()
    basic.listeners.append(counter)
    run(basic)
    basic.listeners.clear()
    run(basic)
    spent, times = 0.0, 0
    while spent < ENOUGH:
        spent += run(basic)
        times += 1
    return counter.statements * times / spent


def rate_by_hand(name: str) -> float | None:
    """Statements a second of the translation into Python, if there is one."""
    function = BY_HAND.get(name)
    if function is None:
        return None
    start = time.process_time()
    statements = 0
    while time.process_time() - start < ENOUGH:
        statements += function()
    return statements / (time.process_time() - start)


def main(arguments: list[str]) -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", help="listings (all thirteen unless given)")
    parser.add_argument("--statements", action="store_true", help="one function a statement")
    options = parser.parse_args(arguments)
    names = options.names or STANDARD
    logarithms, shares = [], []
    for name in names:
        speed = rate(name, not options.statements)
        logarithms.append(math.log(speed))
        by_hand = rate_by_hand(name)
        note = ""
        if by_hand:
            shares.append(math.log(speed / by_hand))
            note = f"{speed / by_hand:6.2f} of hand-written"
        print(f"{name:12}{speed / 1e6:8.2f} million statements/s  {note}")
    if not options.names:
        mean, share = (math.exp(sum(values) / len(values)) for values in (logarithms, shares))
        print(f"{'mean':12}{mean / 1e6:8.2f} million statements/s  {share:6.2f}, geometric")


if __name__ == "__main__":
    main(sys.argv[1:])
