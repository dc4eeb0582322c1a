"""`python -m benchmarks [PART ...]`: measure, and tell what was found."""

from __future__ import annotations

import json
from importlib import import_module
from pathlib import Path

import click
from rich.console import Console

from benchmarks.report import PARTS, plain, show, written
from benchmarks.rows import Row


@click.command()
@click.argument("parts", nargs=-1, type=click.Choice(list(PARTS)))
@click.option(
    "--seconds",
    type=click.FloatRange(min=0, min_open=True),
    default=0.5,
    show_default=True,
    help="Of the processor, for each figure at least.",
)
@click.option("--json", "output", type=click.Path(path_type=Path), help="Write all figures there.")
@click.option(
    "--write",
    "page",
    type=click.Path(path_type=Path, exists=True),
    help="Put the tables between their marks in a page, as docs/performance.md.",
)
def main(parts: tuple[str, ...], seconds: float, output: Path | None, page: Path | None) -> None:
    """Measure PARTS, or all of them, and print their tables."""
    console = Console()
    results: dict[str, list[Row]] = {}
    for part in parts or PARTS:
        with console.status(f"{part} ..."):
            results[part] = list(import_module(f"benchmarks.{part}").rows(seconds))
        show(console, part, results[part])
    if output is not None:
        output.write_text(json.dumps(plain(results), indent=1) + "\n")
    if page is not None:
        page.write_text(written(page.read_text(), results))


if __name__ == "__main__":
    main()
