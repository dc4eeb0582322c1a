"""A bench for one run of a sweep: keys of its parts changed, and each placed with an error.

The errors are drawn here from a seed; the bench is given places. An error belongs to a run's number
and to a part: run 7 has the same in every cell of the grid, so that cells differ by what is varied
and not by luck.
"""

from __future__ import annotations

import copy
import random
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from trs80arm.arm import benchfile
from trs80arm.arm.bench import Bench, BenchError
from trs80arm.sweep.axes import SweepError
from trs80arm.toml_files import tables_of

MOST_DRAWS = 100
"""Draws for one run, if parts would stand in something as they were drawn first."""
STANDARD: dict[str, Any] = {
    "name": "table",
    "part": [{"name": "block", "at": [8.0, 0.0], "size": [0.5, 0.5, 1.0], "weight": 0.4}],
}
"""What stands there when no bench is named, as `Bench.standard` has it."""
_ADDED = {"dx": 0, "dy": 1}

Changes = dict[tuple[str, str], float]
"""By part, empty for all, and key: `weight` and `friction` as they are to be, `dx`, `dy` (inches)
and `dturn` (degrees) to be added."""


def read_bench(path: Path | None) -> tuple[str, dict[str, Any]]:
    """A bench file's name for errors, and what it says.

    Raises:
        BenchError: it cannot be read or is no bench.
    """
    if path is None:
        return "the bench", STANDARD
    text = benchfile.read(path)
    benchfile.parse(text, str(path))
    return str(path), tables_of(text)


def changed(data: dict[str, Any], changes: Changes) -> dict[str, Any]:
    """The bench with its parts' and feeders' keys changed.

    Raises:
        SweepError: it has no part of that name, or none at all.
    """
    data = copy.deepcopy(data)
    for (name, key), value in changes.items():
        meant = [item for item in _placed(data) if name in ("", item["name"])]
        if not meant:
            there = ", ".join(item["name"] for item in _placed(data)) or "none"
            raise SweepError(f"--vary {name or key}: no such part on the bench; there are {there}")
        for item in meant:
            if key in _ADDED:
                item["at"][_ADDED[key]] += value
            elif key == "dturn":
                item["turn"] = item.get("turn", 0.0) + value
            else:
                item[key] = value
    return data


def placed(source: str, data: dict[str, Any], noise: float, seed: int, run: int) -> Bench:
    """The bench with each part and feeder off its place along x and y.

    Args:
        source: the bench file, for errors.
        data: what it says.
        noise: standard deviation of the error along x and along y, inches.
        seed: of the sweep.
        run: number of the run.

    Raises:
        BenchError: the bench cannot be; or not in any of `MOST_DRAWS` draws.
    """
    if not noise:
        return benchfile.build(data, source)
    for draw in range(MOST_DRAWS):
        tried = copy.deepcopy(data)
        for item in _placed(tried):
            chance = random.Random(f"{seed} {run} {draw} {item['name']}")
            item["at"] = [value + noise * chance.gauss(0.0, 1.0) for value in item["at"]]
        try:
            return benchfile.build(tried, source)
        except BenchError as error:
            last = error
    raise BenchError(f"{last} (with an error of {noise:g} in, {MOST_DRAWS} times drawn)")


def _placed(data: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """What stands in a place that an operator gave it, each by the name that it has."""
    for kind in ("part", "feeder"):
        for number, item in enumerate(data.get(kind, ()), 1):
            item.setdefault("name", f"{kind} {number}")
            yield item
