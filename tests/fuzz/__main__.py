"""`python -m tests.fuzz`: noise until the time is over, and how many cases each door has had."""

from __future__ import annotations

import argparse
import itertools
import json
import resource
import sys
import time
from collections import Counter
from pathlib import Path

from tests.fuzz.targets import TARGETS
from tests.fuzz.work import case_of, fault_of, keep

MEMORY = 4 << 30
"""Bytes that the process may have; more is a fault."""
GROWTH = 512 << 20
"""Bytes by which the process may grow after every door has had its first turn."""
ROUND = 2.0
"""Seconds for one door before it is the next one's turn."""


def main(arguments: list[str] | None = None) -> int:
    """Work; 1 if something was found."""
    parser = argparse.ArgumentParser("python -m tests.fuzz", description=__doc__)
    parser.add_argument("--minutes", type=float, default=1.0)
    parser.add_argument("--target", action="append", choices=sorted(TARGETS), help="all, if none")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--tally", type=Path, help="a file of counts, to be added to and shown")
    options = parser.parse_args(arguments)
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    names = options.target or list(TARGETS)
    end = time.monotonic() + 60 * options.minutes
    played: Counter[str] = Counter(_read(options.tally))
    faults: set[str] = set()
    memory = None
    for name in itertools.cycle(names):
        turn = time.monotonic() + ROUND
        while time.monotonic() < min(turn, end):
            case = case_of(TARGETS[name], options.seed, played[name])
            played[name] += 1
            fault = fault_of(TARGETS[name], case)
            if fault is not None and f"{name} {fault}" not in faults:
                faults.add(f"{name} {fault}")
                keep(TARGETS[name], case, fault)
        if name == names[-1]:
            _write(options.tally, played)
            memory = memory or _memory()
            if _memory() - memory > GROWTH:
                faults.add(f"memory grew from {memory} to {_memory()} bytes")
                break
        if time.monotonic() >= end:
            break
    _write(options.tally, played)
    for name in sorted(played):
        print(f"| `{name}` | {played[name]:,} |")
    print(f"{played.total():,} cases, {len(faults)} faults", *sorted(faults), sep="\n")
    return 1 if faults else 0


def _memory() -> int:
    """Bytes that the process has at this moment."""
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * resource.getpagesize()


def _read(tally: Path | None) -> dict[str, int]:
    """What was counted before; the numbers of cases go on from there."""
    if tally is None or not tally.exists():
        return {}
    counts: dict[str, int] = json.loads(tally.read_text(encoding="utf-8"))
    return counts


def _write(tally: Path | None, played: Counter[str]) -> None:
    if tally is not None:
        tally.write_text(json.dumps(dict(sorted(played.items())), indent=1) + "\n", "utf-8")


if __name__ == "__main__":
    sys.exit(main())
