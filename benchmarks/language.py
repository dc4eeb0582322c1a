"""How many BASIC statements a second the compiled language executes, beside its peers.

Each listing of `benchmarks/basic/`, made longer, is RUN until enough time of the processor has
gone. Beside it stand, in turns with it, the same with hot loops as native code, where the extra
`fast` is installed; the same work translated by hand into a Python function that rounds every
result to 24 bits in line and checks nothing, which is the most that CPython could give; and
whichever other BASICs are installed: how many times as fast as they the machine is.
"""

from __future__ import annotations

import subprocess
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from importlib.util import find_spec
from pathlib import Path
from statistics import geometric_mean

from benchmarks.by_hand import BY_HAND
from benchmarks.machine import count, loaded, run
from benchmarks.peers import Peer, installed
from benchmarks.rows import Row

LISTINGS = Path(__file__).parent / "basic"
STANDARD = [*(f"bm{i}" for i in range(1, 9)), "ahl", "sieve", "nestfor", "strings", "ik"]
"""The thirteen whose geometric mean is reported."""
AMOUNTS: dict[str, tuple[str, int, int]] = {
    **{f"bm{i}": ("{}", 1000, 100) for i in range(1, 8)},
    "bm8": ("{} THEN", 100, 50),
    "ahl": ("TO {}:A=N", 100, 1),
    "sieve": ("N={}", 1, 5),
    "nestfor": ("N={}", 10, 6),
    "strings": ("TO {}", 200, 20),
    "ik": ("N={}", 100, 20),
}
"""Where a listing says how much it does, how much that is, how many times that is timed here."""
LONGEST = 10_000
"""Times its work at most, for a peer."""
TURNS = 10
"""How often what is compared takes turns, for a computer may be slow for a while."""
Work = Callable[[], int]
"""Does its work once, and says how many statements that is."""
SPEED, FAST, BY_HAND_SHARE = "M statements/s", "with fast", "of hand-written"


def listing(name: str, times: float) -> list[str]:
    """A listing that does so many times its work."""
    text = (LISTINGS / f"{name}.bas").read_text(encoding="ascii")
    pattern, amount, _ = AMOUNTS[name]
    more = max(1, round(amount * times))
    return text.replace(pattern.format(amount), pattern.format(more)).splitlines()


def rates(works: Mapping[str, Work], seconds: float) -> dict[str, float]:
    """Statements a second of several works, in turns; the best of several goes of each.

    Args:
        works: what is timed, by any names.
        seconds: of the processor that each is given at least.
    """
    best = dict.fromkeys(works, 0.0)
    for _ in range(TURNS):
        for name, work in works.items():
            spent = 0.0
            while spent < seconds / TURNS:
                began = time.process_time()
                statements = work()
                if taken := time.process_time() - began:
                    spent += taken
                    best[name] = max(best[name], statements / taken)
    return best


def running(lines: list[str], *, native: bool = False) -> Work:
    """RUN of a listing on a machine, of Python or with native loops, that has run it before."""
    basic = loaded(lines, native=native)
    statements = count(basic)
    run(basic)

    def work() -> int:
        run(basic)
        return statements

    return work


def by_hand(name: str) -> Work:
    """The translation into Python; its statements are those that the machine counts."""
    statements = count(loaded(listing(name, 1)))

    def work() -> int:
        BY_HAND[name]()
        return statements

    return work


class Listing:
    """A listing of any length, and how many statements it executes.

    Args:
        name: which.
    """

    def __init__(self, name: str) -> None:
        self.name = name
        once, twice = (count(loaded(listing(name, times))) for times in (1, 2))
        self._outside, self._inside = 2 * once - twice, twice - once

    def statements(self, times: int) -> int:
        """Statements of so many times the work; each time executes as many as the other."""
        return self._outside + self._inside * times


def rate_of_peer(peer: Peer, listed: Listing, seconds: float) -> float | None:
    """Statements a second of another BASIC, counted as the machine counts those of the listing.

    The listing is made longer until its start does not count; None where the peer cannot run it.
    """
    times = 1
    try:
        start = min(peer.seconds(["10 END"]) for _ in range(3))
        while True:
            lasted = peer.seconds(listing(listed.name, times)) - start
            if lasted >= min(seconds, 1.0) or times >= LONGEST:
                return listed.statements(times) / max(lasted, 1e-3)
            times *= 2 if lasted > seconds / 4 else 10
    except subprocess.SubprocessError:
        return None


def rows(
    seconds: float, names: Sequence[str] = STANDARD, peers: Sequence[Peer] | None = None
) -> Iterator[Row]:
    """Each listing, beside whichever peers are installed, and the geometric mean of each column."""
    columns: dict[str, list[float]] = {}
    peers = installed() if peers is None else peers
    for name in names:
        longer = listing(name, AMOUNTS[name][2])
        works = {SPEED: running(longer), BY_HAND_SHARE: by_hand(name)}
        if find_spec("wasmtime"):
            works[FAST] = running(longer, native=True)
        found = rates(works, seconds)
        speed = found[SPEED]
        measures = {SPEED: speed / 1e6}
        if FAST in found:
            measures[FAST] = found[FAST] / 1e6
        measures[BY_HAND_SHARE] = speed / found[BY_HAND_SHARE]
        listed = Listing(name) if peers else None
        for peer in peers:
            theirs = rate_of_peer(peer, listed, seconds) if listed else None
            if theirs:
                measures[f"x {peer.name}"] = speed / theirs
        for column, value in measures.items():
            columns.setdefault(column, []).append(value)
        yield Row(name, measures)
    yield Row("geometric mean", {name: geometric_mean(each) for name, each in columns.items()})
