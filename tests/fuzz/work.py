"""Playing cases one after the other, and keeping what was found."""

from __future__ import annotations

import contextlib
import hashlib
import json
import resource
import signal
import traceback
from collections.abc import Callable, Iterator
from pathlib import Path
from random import Random
from types import FrameType

from tests.fuzz.checks import BrokenError
from tests.fuzz.smaller import smallest
from tests.fuzz.target import Case, Target

FOUND = Path(__file__).parent / "found"
LONGEST = 20.0
"""Seconds of the processor after which a case counts as one that hangs."""
LONGEST_WAIT = 600.0
"""Seconds of the wall after which a case counts as one that waits for ever."""
LARGEST = 256 << 10
"""KiB by which one case may raise the most memory that the process has had."""


class HangError(Exception):
    """A case that does not end."""


def case_of(target: Target, seed: int, number: int) -> Case:
    """The case of a number: the same for the same seed, on every computer."""
    return target.make(Random(f"{seed} {target.name} {number}"))


def fault_of(target: Target, case: Case) -> str | None:
    """How a case fails: the exception and where it came from; None if all is well."""
    try:
        with _in_time(), _in_bounds():
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
    for number in (signal.SIGPROF, signal.SIGALRM):
        if signal.getsignal(number) is not _ring:
            signal.signal(number, _ring)
    signal.setitimer(signal.ITIMER_PROF, LONGEST)
    signal.setitimer(signal.ITIMER_REAL, LONGEST_WAIT)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.setitimer(signal.ITIMER_REAL, 0)


def _ring(signal_number: int, frame: FrameType | None) -> None:
    raise HangError("too long")


@contextlib.contextmanager
def _in_bounds() -> Iterator[None]:
    """No case takes memory without bound."""
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    yield
    more = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
    if more > LARGEST:
        raise BrokenError(f"one case takes more than {LARGEST >> 10} MiB")


def keep(target: Target, case: Case, fault: str, tell: Callable[[str], None] = print) -> Path:
    """Make a case small and write it where the tests play it again."""
    small = smallest(case, lambda other: fault_of(target, other) == fault)
    text = json.dumps({"target": target.name, "fault": fault, "case": small}, indent=1) + "\n"
    path = FOUND / f"{target.name}-{hashlib.sha256(fault.encode()).hexdigest()[:8]}.json"
    path.write_text(text, encoding="utf-8")
    tell(f"{target.name}: {fault}\n  kept as {path.name}")
    return path
