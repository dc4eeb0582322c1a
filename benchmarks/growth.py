"""Whether cost grows with a program's length, with its variables, with how long it has run.

The same loop, of an assignment, a comparison and a jump, each time; only what stands around it is
more. Then what RUN and the change of a line cost, which may grow with the program, but no faster
than it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from benchmarks.machine import loaded, run
from benchmarks.rows import Row

LINES = (10, 200, 500, 2000)
VARIABLES = (2, 50, 200, 800)
ROUNDS_A_SECOND = 200_000
RUNS = 5
PER_ROUND = 3
"""Statements of a round of the loop."""
NAMES = [first + second for first in "BCDEGHJKLM" for second in " ABCDEGHJKLMNPQRSUVWXYZ0123456789"]


def with_lines(count: int, rounds: int) -> list[str]:
    """The loop behind so many lines that run once."""
    before = [f"{number} A=1" for number in range(1, count - 3)]
    return [*before, *_loop(count, rounds)]


def with_variables(count: int, rounds: int) -> list[str]:
    """The loop after so many variables have been given values."""
    names = [f"{name.strip()}{kind}" for kind in ("", "%", "#", "!") for name in NAMES]
    # A name with ! is the one without.
    chosen = [name for name in names if not name.endswith("!")][:count]
    before = [f"{number} {name}=1" for number, name in enumerate(chosen, 1)]
    return [*before, *_loop(count + 10, rounds)]


def _loop(line: int, rounds: int) -> list[str]:
    return [
        f"{line} Z=0",
        f"{line + 1} Z=Z+1",
        f"{line + 2} Y=Z*2",
        f"{line + 3} IF Z<{rounds} THEN {line + 1}",
    ]


def cost(make: Callable[[int, int], list[str]], size: int, rounds: int) -> float:
    """Seconds of the processor of one statement of the loop.

    What stands before the loop is in two programs, of which one goes round twice as often.
    """
    short, long = (loaded(make(size, each)) for each in (rounds, 2 * rounds))
    run(short)
    run(long)
    took = [(run(short), run(long)) for _ in range(RUNS)]
    return (min(pair[1] for pair in took) - min(pair[0] for pair in took)) / rounds / PER_ROUND


def until_running(lines: list[str]) -> float:
    """Seconds from RUN of a program never run before to its end, of lines that all run once."""
    return min(run(loaded(lines)) for _ in range(3))


def until_the_first(count: int) -> float:
    """Seconds from RUN of a program of so many new lines until its first statement is done."""
    lines = ["1 STOP", *(f"{number} A={number}:IF A<1 THEN 1" for number in range(2, count + 1))]
    return min(run(loaded(lines)) for _ in range(RUNS))


def after_an_edit(lines: list[str]) -> float:
    """Seconds that RUN takes when one line of a program that has run has been stored anew."""
    basic = loaded(lines)
    run(basic)
    times: list[float] = []
    for value in range(3):
        basic.store_line(len(lines) // 2, f"A={value}".encode())
        times.append(run(basic))
    return min(times)


def rows(seconds: float) -> Iterator[Row]:
    """Each length, each number of variables, each length of a run."""
    rounds = max(1000, int(ROUNDS_A_SECOND * seconds))
    for names, make, sizes in (
        ("lines of program", with_lines, LINES),
        ("variables", with_variables, VARIABLES),
    ):
        first = None
        for size in sizes:
            taken = cost(make, size, rounds)
            first = first or taken
            yield Row(f"{size} {names}", {"ns a statement": 1e9 * taken, "x first": taken / first})
    first = None
    for longer in (rounds // 10, rounds, rounds * 10):
        taken = cost(with_lines, 10, longer)
        first = first or taken
        measures = {"ns a statement": 1e9 * taken, "x first": taken / first}
        yield Row(f"after {longer * PER_ROUND} statements", measures)
    for size in LINES:
        lines = [f"{number} A={number}" for number in range(1, size + 1)]
        taken, again = until_running(lines), after_an_edit(lines)
        measures = {"ms": 1000 * taken, "us each": 1e6 * taken / size}
        measures["ms after an edit"] = 1000 * again
        yield Row(f"RUN of {size} new lines", measures)
    for size in LINES:
        yield Row(f"first of {size} new lines", {"ms": 1000 * until_the_first(size)})
    for size in VARIABLES:
        lines = with_variables(size, 1)
        basic = loaded(lines)
        run(basic)
        taken = min(run(basic) for _ in range(RUNS))
        measures = {"ms": 1000 * taken, "us each": 1e6 * taken / size}
        yield Row(f"RUN that makes {size} variables", measures)
