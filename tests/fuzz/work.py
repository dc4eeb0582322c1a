"""Playing cases one after the other, and keeping what was found."""

from __future__ import annotations

import contextlib
import hashlib
import json
import signal
import traceback
from collections.abc import Callable, Iterator
from pathlib import Path
from random import Random
from typing import Any

from tests.fuzz.smaller import smallest
from tests.fuzz.targets import Target

FOUND = Path(__file__).parent / "found"
LONGEST = 20
"""Seconds of the wall after which a case counts as one that hangs."""


class HangError(Exception):
    """A case that does not end."""


def case_of(target: Target, seed: int, number: int) -> Any:
    """The case of a number: the same for the same seed, on every computer."""
    return target.make(Random(f"{seed} {target.name} {number}"))


def fault_of(target: Target, case: Any) -> str | None:
    """How a case fails: the exception and where it came from; None if all is well."""
    try:
        with _in_time():
            target.play(case)
    except Exception as error:
        places = [
            f"{Path(frame.filename).name}:{frame.name}"
            for frame in traceback.extract_tb(error.__traceback__)
            if "trs80arm" in frame.filename or "textual" in frame.filename
        ]
        what = str(error) if isinstance(error, AssertionError) else ""
        return " ".join([type(error).__name__, *places[-1:], what]).strip()
    return None


@contextlib.contextmanager
def _in_time() -> Iterator[None]:
    def ring(*_: object) -> None:
        raise HangError(f"more than {LONGEST} seconds")

    before = signal.signal(signal.SIGALRM, ring)
    signal.setitimer(signal.ITIMER_REAL, LONGEST)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def keep(target: Target, case: Any, fault: str, tell: Callable[[str], None] = print) -> Path:
    """Make a case small and write it where the tests play it again."""
    small = smallest(case, lambda other: fault_of(target, other) == fault)
    text = json.dumps({"target": target.name, "fault": fault, "case": small}, indent=1) + "\n"
    path = FOUND / f"{target.name}-{hashlib.sha256(fault.encode()).hexdigest()[:8]}.json"
    path.write_text(text, encoding="utf-8")
    tell(f"{target.name}: {fault}\n  kept as {path.name}")
    return path
