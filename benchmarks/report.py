"""The table told: on the terminal, as JSON, and in a page between its marks."""

from __future__ import annotations

import os
import platform
import re
from collections.abc import Mapping, Sequence
from importlib import import_module

from rich.console import Console
from rich.table import Table

from benchmarks.rows import Row

PARTS = {
    "language": "BASIC",
    "arithmetic": "Operations of the machine's numbers",
    "growth": "Growth with program, variables and run",
    "arm": "The arm",
    "contact": "Contact",
    "drawing": "Pictures of the arm, 100 x 50 cells",
    "terminal": "The terminal",
    "start": "Start",
    "memory": "Memory",
    "suite": "The tests",
}
"""Module to title, in the order of the table."""
Results = Mapping[str, Sequence[Row]]


def title(part: str) -> str:
    """A part's title, with what its module says of it in a line."""
    said = (import_module(f"benchmarks.{part}").__doc__ or "").strip().splitlines()[0]
    return f"{PARTS[part]}: {said[0].lower()}{said[1:].rstrip('.')}"


def machine() -> dict[str, str | int]:
    """What kind of machine it is, without its name."""
    return {
        "python": f"{platform.python_implementation()} {platform.python_version()}",
        "system": f"{platform.system()} {platform.machine()}",
        "cores": os.cpu_count() or 1,
    }


def columns(rows: Sequence[Row]) -> list[str]:
    """The columns that some row has, in the order in which they come."""
    return list(dict.fromkeys(column for row in rows for column in row.measures))


def figure(value: float | None) -> str:
    """Three digits of a value."""
    if value is None:
        return ""
    return f"{value:.0f}" if abs(value) >= 100 else f"{value:.3g}"


def show(console: Console, part: str, rows: Sequence[Row]) -> None:
    """One part as a table on the terminal."""
    table = Table(title=title(part), title_justify="left")
    table.add_column("")
    names = columns(rows)
    for name in names:
        table.add_column(name, justify="right")
    for row in rows:
        table.add_row(row.name, *(figure(row.measures.get(name)) for name in names))
    console.print(table)


def plain(results: Results) -> dict[str, object]:
    """All of it for JSON: `machine`, and `parts` with rows of `name` and `measures`."""
    parts = {
        part: [{"name": row.name, "measures": dict(row.measures)} for row in rows]
        for part, rows in results.items()
    }
    return {"machine": machine(), "parts": parts}


def markdown(rows: Sequence[Row]) -> str:
    """One part as a table of a page."""
    names = columns(rows)
    lines = [f"| | {' | '.join(names)} |", f"| --- |{' ---: |' * len(names)}"]
    for row in rows:
        cells = [figure(row.measures.get(name)) for name in names]
        lines.append(f"| {row.name} | {' | '.join(cells)} |")
    return "\n".join(lines)


def written(page: str, results: Results) -> str:
    """A page with each part that was measured between its marks, and the machine between its own.

    Raises:
        ValueError: the page has no marks for a part.
    """
    here = machine()
    kind = f"{here['python']}, {here['system']}, {here['cores']} cores"
    for name, text in (("machine", kind), *((part, markdown(results[part])) for part in results)):
        pattern = rf"(<!-- {name} -->\n).*?(<!-- end of {name} -->)"
        page, found = re.subn(pattern, lambda m, t=text: f"{m[1]}{t}\n{m[2]}", page, flags=re.S)  # type: ignore[misc]
        if not found:
            raise ValueError(f"the page has no marks for {name}")
    return page
