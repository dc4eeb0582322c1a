"""What a sweep found: a CSV file, a table to be read, and a chart of success."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence

from trs80arm.arm.figures import Chart, Figure, Series, Style, Table
from trs80arm.sweep.axes import Axis, SweepError
from trs80arm.sweep.constants import number_text
from trs80arm.sweep.running import Result

COLUMNS = (
    *("run", "seed", "success", "ended", "goals_met", "goals", "off", "slips", "lost_half_steps"),
    *("peak_used", "seconds"),
)
"""Columns of the CSV behind the things varied; `off` in inches, `peak_used` per cent."""
_MARKS = "*o+x#%@&"


def csv_text(axes: Sequence[Axis], results: Sequence[Result], seed: int) -> str:
    """All runs, one line each, in order, with what errors in placing were drawn from."""
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    rows.writerow([*(axis.name for axis in axes), *COLUMNS])
    for each in results:
        rows.writerow(
            [
                *map(number_text, each.values),
                *(each.run, seed, int(each.success), each.ended, each.met, each.goals),
                "" if each.off is None else f"{each.off:.4f}",
                *(each.slips, each.lost, each.peak, f"{each.seconds:.6f}"),
            ]
        )
    return text.getvalue()


def share(results: Sequence[Result]) -> float:
    """How many of some runs succeeded, per cent."""
    return 100 * sum(each.success for each in results) / len(results)


def table(axes: Sequence[Axis], results: Sequence[Result], title: str) -> Figure:
    """Success by cell: two axes as rows and columns, any other number of them as a list."""
    cells = _cells(results)
    if len(axes) == 2:
        first, second = axes
        heading = (f"{first.name} \\ {second.name}", *map(number_text, second.values))
        rows = tuple(
            (number_text(x), *(f"{share(cells[x, y]):.0f} %" for y in second.values))
            for x in first.values
        )
    else:
        heading = (*(axis.name for axis in axes), "success", "runs", "slipped")
        rows = tuple(
            (
                *map(number_text, cell),
                f"{share(done):.0f} %",
                str(len(done)),
                str(sum(each.slips > 0 for each in done)),
            )
            for cell, done in cells.items()
        )
    return Figure("sweep", title, (Table(heading, rows),))


def chart(axes: Sequence[Axis], results: Sequence[Result], title: str) -> Figure:
    """Success against the first axis, a curve for each value of the second.

    Raises:
        SweepError: there are more than two axes, or none.
    """
    if not 1 <= len(axes) <= 2:
        raise SweepError("--plot shows one or two things varied")
    cells = _cells(results)
    x, *others = axes
    series = []
    for number, value in enumerate(others[0].values if others else (None,)):
        ys = [share(cells[(at,) if value is None else (at, value)]) for at in x.values]
        label = "success" if value is None else f"{others[0].name} = {number_text(value)}"
        mark = _MARKS[number % len(_MARKS)]
        series.append(Series(label, x.values, tuple(ys), Style.MEASURED, mark))
    return Figure("sweep", title, (Chart("", x.name, "runs that succeed, %", tuple(series)),))


def _cells(results: Sequence[Result]) -> dict[tuple[float, ...], list[Result]]:
    """The runs of each cell, cells in their order."""
    cells: dict[tuple[float, ...], list[Result]] = {}
    for each in results:
        cells.setdefault(each.values, []).append(each)
    return cells
