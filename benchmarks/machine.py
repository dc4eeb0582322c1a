"""A machine with a listing in memory, and its RUN timed."""

from __future__ import annotations

import time
from collections.abc import Iterable

from trs80arm.basic import cruncher
from trs80arm.basic.interpreter import Interpreter
from trs80arm.rig import Rig, RigSettings

FOREVER = 10**15
"""T-states that no run reaches."""


class Counter:
    """Counts statements as the machine's statement loop does."""

    def __init__(self) -> None:
        self.statements = 0

    def statement(self, line: int, address: int) -> None:
        """One more."""
        self.statements += 1


def loaded(listing: Iterable[str], blocks: bool = True, native: bool = False) -> Interpreter:
    """A 48K machine with the lines of a listing in memory.

    Args:
        listing: lines with their numbers.
        blocks: whether straight runs of statements are compiled as one.
        native: whether hot loops of numbers are made native code.
    """
    rig = Rig(RigSettings(ram_kib=48, blocks=blocks, native=native))
    rig.run_until_waiting(10.0)
    lines = []
    for line in listing:
        number, text = cruncher.split_line(line.encode("ascii"))
        if number is not None:
            lines.append((number, cruncher.crunch(text).text))
    basic = rig.basic
    assert isinstance(basic, Interpreter)
    basic.load_lines(lines)
    return basic


def run(basic: Interpreter) -> float:
    """RUN once; processor seconds."""
    basic.execute_direct(cruncher.crunch(b"RUN").text)
    basic.state.clock.limit = basic.state.clock.now + FOREVER
    start = time.process_time()
    basic.advance(until_waiting=True)
    return time.process_time() - start


def count(basic: Interpreter) -> int:
    """RUN once; how many statements that is."""
    counter = Counter()
    basic.listeners.append(counter)
    run(basic)
    basic.listeners.clear()
    return counter.statements
