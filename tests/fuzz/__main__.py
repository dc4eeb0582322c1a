"""`python -m tests.fuzz`: noise until the time is over, and how many cases each door has had."""

from __future__ import annotations

import argparse
import itertools
import resource
import sys
import time
from collections import Counter

from tests.fuzz.targets import TARGETS
from tests.fuzz.work import case_of, fault_of, keep

MEMORY = 4 << 30
"""Bytes that the process may have; more is a fault."""
ROUND = 2.0
"""Seconds for one door before it is the next one's turn."""


def main(arguments: list[str] | None = None) -> int:
    """Work; 1 if something was found."""
    parser = argparse.ArgumentParser("python -m tests.fuzz", description=__doc__)
    parser.add_argument("--minutes", type=float, default=1.0)
    parser.add_argument("--target", action="append", choices=sorted(TARGETS), help="all, if none")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args(arguments)
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    names = options.target or list(TARGETS)
    end = time.monotonic() + 60 * options.minutes
    played: Counter[str] = Counter()
    faults: set[str] = set()
    for name in itertools.cycle(names):
        turn = time.monotonic() + ROUND
        while time.monotonic() < min(turn, end):
            case = case_of(TARGETS[name], options.seed, played[name])
            played[name] += 1
            fault = fault_of(TARGETS[name], case)
            if fault is not None and f"{name} {fault}" not in faults:
                faults.add(f"{name} {fault}")
                keep(TARGETS[name], case, fault)
        if time.monotonic() >= end:
            break
    for name in names:
        print(f"{name}: {played[name]} cases")
    print(f"{played.total()} cases, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
