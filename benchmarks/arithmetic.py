"""How much the machine's arithmetic costs beside Python's own, as ratios within one run.

A ratio compares the time of an operation of the
machine with that of a call that adds two Python floats, measured in turns, so that the host hardly
matters.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from statistics import median
from timeit import timeit
from typing import Any

from benchmarks.rows import Row
from trs80arm.basic.numbers import convert, decimal, double, functions, integer, single

ROUNDS = 7
CALLS = 10_000
"""At half a second for each figure."""


def bare(a: float, b: float) -> float:
    """The yardstick: one call and one addition of Python floats."""
    return a + b


def ratio(operation: Callable[..., Any], *operands: object, calls: int = CALLS) -> float:
    """The median over some rounds of the operation's time over the yardstick's."""

    def once(function: Callable[..., Any], values: tuple[object, ...]) -> float:
        names = {f"v{i}": value for i, value in enumerate(values)}
        return timeit(f"f({','.join(names)})", globals={"f": function, **names}, number=calls)

    return median(once(operation, operands) / once(bare, (1.5, 2.5)) for _ in range(ROUNDS))


def rows(seconds: float) -> Iterator[Row]:
    """One for each operation."""
    calls = max(10, int(CALLS * 2 * seconds))
    tenth, third = single.round_away(0.1), single.round_away(1.0 / 3.0)
    x, y = double.div(double.from_int(1), double.from_int(3)), double.from_int(7)
    operations: list[tuple[str, Callable[..., Any], tuple[object, ...]]] = [
        ("single add, exact", single.add, (100.0, 1.0)),
        ("single add, rounded", single.add, (tenth, third)),
        ("single sub, rounded", single.sub, (third, tenth)),
        ("single add, far apart, unlike signs", single.add, (100.0, -tenth)),
        ("single mul", single.mul, (tenth, third)),
        ("single div", single.div, (tenth, third)),
        ("integer add", integer.add, (100, 1)),
        ("add, types unknown", convert.add, (tenth, third)),
        ("double add", double.add, (x, y)),
        ("double mul", double.mul, (x, y)),
        ("double div", double.div, (x, y)),
        ("SIN", functions.sin, (tenth,)),
        ("SQR", functions.sqr, (tenth,)),
        ("text of a whole single", decimal.number_text, (100.0,)),
        ("text of a single", decimal.number_text, (third,)),
        ("text of a double", decimal.number_text, (x,)),
    ]
    for name, operation, operands in operations:
        yield Row(name, {"x a call that adds": ratio(operation, *operands, calls=calls)})
