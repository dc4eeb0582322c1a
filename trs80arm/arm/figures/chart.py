"""Charts, tables and diagrams that can be drawn with characters, or into a file.

The figures of the article are made of these; nothing here knows the arm. A chart holds its data,
so tests and other programs can read what a figure shows.
"""

from __future__ import annotations

import io
import math
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from enum import Enum
from pathlib import Path
from textwrap import wrap
from typing import Any, BinaryIO

from trs80arm.arm.figures.diagram import Diagram
from trs80arm.arm.figures.sheet import Pen, Sheet
from trs80arm.saving import whole_file

SUFFIXES = (".svg", ".png", ".pdf")


class FigureError(Exception):
    """A figure that cannot be made or saved; one line says why."""


_THIN, _WIDER = 1.6, 1.4
"""Points of a measured curve, and how much wider each one is that others are drawn over."""


class Style(Enum):
    """How a series is drawn.

    MEASURED is values at some abscissae, joined to guide the eye. Of several such the later are
    thinner, so that all are seen where they coincide.
    """

    LINE = "line"
    MEASURED = "measured"
    DOTS = "dots"
    STEPS = "steps"


@dataclass(frozen=True)
class Series:
    """One curve, or a cloud of dots.

    Attributes:
        label: for the legend.
        xs: abscissae.
        ys: ordinates, as many.
        style: how to draw it.
        mark: character for the drawing in text.
    """

    label: str
    xs: tuple[float, ...]
    ys: tuple[float, ...]
    style: Style = Style.LINE
    mark: str = "*"


@dataclass(frozen=True)
class Chart:
    """One diagram.

    Attributes:
        title: of the diagram.
        x_label: what the abscissa is, with its unit.
        y_label: what the ordinate is, with its unit.
        series: curves, later ones over earlier ones.
        notes: words at places, as (x, y, text).
        to_scale: whether both axes are lengths and one inch is to be as long on both.
        rows: lines of characters for a chart in text that is not to scale.
    """

    title: str
    x_label: str
    y_label: str
    series: tuple[Series, ...]
    notes: tuple[tuple[float, float, str], ...] = ()
    to_scale: bool = False
    rows: int = 20


@dataclass(frozen=True)
class Table:
    """Rows under a heading.

    Attributes:
        heading: names of the columns.
        rows: as many cells each.
        notes: below it, numbered from 1.
    """

    heading: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    notes: tuple[str, ...] = ()


_IN_THE_DARK = (
    b"<style>@media(prefers-color-scheme:dark){svg{filter:invert(0.92) hue-rotate(180deg)}}</style>"
)
"""What an SVG of matplotlib's is given so that it is dark where its reader's page is."""
_EDGE, _GUTTER, _LINE, _LETTER, _NARROWEST = 24.0, 22.0, 22.0, 7.0, 420.0
"""Units of a table that is drawn: around it, between columns, a line, a letter, the narrowest."""


@dataclass(frozen=True)
class Figure:
    """A figure of the article, computed.

    Attributes:
        name: as in "figure 6" or "table1".
        title: one line.
        parts: charts, tables and diagrams from top to bottom.
    """

    name: str
    title: str
    parts: tuple[Chart | Table | Diagram, ...] = field(default=())

    def text(self, width: int = 78) -> str:
        """The figure in plain characters.

        Args:
            width: columns to fill at most. A diagram is as wide as it is, up to 79 columns.
        """
        pieces = [self.title, ""]
        for part in self.parts:
            if isinstance(part, Diagram):
                pieces += part.lines
            elif isinstance(part, Table):
                pieces.append(_table_text(part, width))
            else:
                pieces.append(_chart_text(part, width))
            pieces.append("")
        return "\n".join(line.rstrip() for line in "\n".join(pieces).rstrip().split("\n")) + "\n"

    def save(self, path: str | Path) -> None:
        """Draw the figure into an SVG, PNG or PDF file.

        A diagram as SVG needs no other program, and is dark where the reader's page is.

        Raises:
            FigureError: if matplotlib is needed and not installed, the suffix is none of these,
                or the file cannot be written.
        """
        path = Path(path)
        kind = path.suffix[1:].lower()
        if path.suffix.lower() not in SUFFIXES:
            known = ", ".join(SUFFIXES)
            raise FigureError(f"{path}: a figure is saved as one of {known}")
        if kind == "svg" and len(self.parts) == 1 and not isinstance(self.parts[0], Chart):
            with _written(path) as file:
                file.write(_sheet(self.parts[0]).svg(self.title).encode("utf-8"))
        else:
            self._plot(path, kind)

    def _plot(self, path: Path, kind: str) -> None:
        """Draw the figure into a file by matplotlib."""
        try:
            import matplotlib
        except ImportError:
            raise FigureError(
                "saving figures needs matplotlib: pip install 'trs80arm[plot]'"
            ) from None
        matplotlib.use("Agg")
        from matplotlib.figure import Figure as Canvas

        heights = [_height(part) for part in self.parts]
        canvas = Canvas(figsize=(8.0, sum(heights) + 0.8), layout="constrained")
        canvas.suptitle(self.title)
        axes = canvas.subplots(len(self.parts), 1, squeeze=False, height_ratios=heights)
        for part, (axis,) in zip(self.parts, axes, strict=True):
            if isinstance(part, Chart):
                _plot(axis, part)
            else:
                _sheet(part).plot(axis)
        # The same figure gives the same file.
        metadata = {"Date": None} if kind == "svg" else None
        drawn = io.BytesIO()
        with matplotlib.rc_context({"svg.hashsalt": self.name, "svg.fonttype": "none"}):
            canvas.savefig(drawn, format=kind, metadata=metadata)
        with _written(path) as file:
            file.write(drawn.getvalue().replace(b"<defs>", _IN_THE_DARK + b"<defs>", 1))


@contextmanager
def _written(path: Path) -> Iterator[BinaryIO]:
    """A file to be written whole or not at all; what is in the way is a `FigureError`."""
    try:
        with whole_file(path) as file:
            yield file
    except OSError as error:
        raise FigureError(f"{path}: cannot be written: {error.strerror}") from None


def _height(part: Chart | Table | Diagram) -> float:
    """Inches that a part takes from top to bottom."""
    if isinstance(part, Chart):
        return 4.5
    sheet = _sheet(part)
    return 8.0 * sheet.height / sheet.width


def _sheet(part: Table | Diagram) -> Sheet:
    """A diagram's sheet, or a table set on one."""
    if isinstance(part, Diagram):
        return part.sheet
    rows = [part.heading, *part.rows]
    longest = [max(len(row[place]) for row in rows) for place in range(len(part.heading))]
    starts = [_EDGE]
    for length in longest:
        starts.append(starts[-1] + length * _LETTER + _GUTTER)
    width = max(starts[-1] - _GUTTER + _EDGE, _NARROWEST)
    notes = _notes(part, int((width - 2 * _EDGE) / _LETTER))
    under = _LINE * (len(notes) + 1) if notes else 0.0
    sheet = Sheet(width, 2 * _EDGE + _LINE * len(rows) + under)
    y = sheet.height - _EDGE - _LINE / 2
    for number, row in enumerate(rows):
        for x, cell in zip(starts, row, strict=False):
            sheet.words((x, y - number * _LINE), cell, bold=number == 0)
    below = y - _LINE / 2
    sheet.line((_EDGE, below), (width - _EDGE, below), width=1.2)
    for number, note in enumerate(notes):
        place = _EDGE, _EDGE + _LINE * (len(notes) - number - 0.5)
        sheet.words(place, note, pen=Pen.SOFT, size=12.0)
    return sheet


def _plot(axis: Any, chart: Chart) -> None:
    """One chart by matplotlib."""
    for below, series in zip(reversed(range(len(chart.series))), chart.series, strict=True):
        if series.style is Style.DOTS:
            axis.plot(series.xs, series.ys, ".", markersize=3, label=series.label)
        elif series.style is Style.MEASURED:
            width = _THIN + _WIDER * below
            axis.plot(
                *(series.xs, series.ys, "o-"),
                linewidth=width,
                markersize=2.5 * width,
                label=series.label,
            )
        elif series.style is Style.STEPS:
            axis.step(series.xs, series.ys, where="post", label=series.label)
        else:
            axis.plot(series.xs, series.ys, "-", label=series.label)
    for x, y, text in chart.notes:
        axis.annotate(text, (x, y), textcoords="offset points", xytext=(5, 5))
    axis.set_title(chart.title)
    axis.set_xlabel(chart.x_label)
    axis.set_ylabel(chart.y_label)
    axis.grid(visible=True, alpha=0.3)
    if chart.to_scale:
        axis.set_aspect("equal")
    if any(series.label for series in chart.series):
        axis.legend(fontsize="small")


def _notes(table: Table, width: int) -> list[str]:
    """The notes of a table, numbered, in lines of a width."""
    return [
        line
        for number, note in enumerate(table.notes, 1)
        for line in wrap(f"{number}. {note}", width, subsequent_indent="   ")
    ]


def _table_text(table: Table, width: int) -> str:
    """A table with its columns aligned, its notes below."""
    rows = [table.heading, *table.rows]
    widths = [max(len(row[i]) for row in rows) for i in range(len(table.heading))]
    lines = [
        "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True))
        for row in rows
    ]
    notes = ["", *_notes(table, width)] if table.notes else []
    rule = "  ".join("-" * column for column in widths)
    return "\n".join([lines[0], rule, *lines[1:], *notes])


def _chart_text(chart: Chart, width: int) -> str:
    """A chart in characters, its axes with their ends written on them."""
    xs = [x for series in chart.series for x in series.xs]
    ys = [y for series in chart.series for y in series.ys]
    if not xs:
        return chart.title
    left, right = _ends(min(xs), max(xs))
    low, high = _ends(min(ys), max(ys))
    gutter = max(len(f"{low:g}"), len(f"{high:g}"))
    columns = max(20, width - gutter - 2)
    rows = chart.rows
    if chart.to_scale:
        # A character is about twice as high as it is wide.
        rows = round(columns * (high - low) / (right - left) / 2)
        if rows > 32:
            columns, rows = max(20, round(columns * 32 / rows)), 32
        rows = max(rows, 5)
    grid = [[" "] * columns for _ in range(rows)]

    def put(x: float, y: float, mark: str) -> None:
        column = round((x - left) / (right - left) * (columns - 1))
        row = rows - 1 - round((y - low) / (high - low) * (rows - 1))
        for k, letter in enumerate(mark):
            if 0 <= row < rows and 0 <= column + k < columns:
                grid[row][column + k] = letter

    for series in chart.series:
        points = list(zip(series.xs, series.ys, strict=True))
        for i, (x, y) in enumerate(points):
            put(x, y, series.mark)
            if series.style is Style.DOTS or i + 1 == len(points):
                continue
            x1, y1 = points[i + 1]
            across = abs(x1 - x) / (right - left) * columns
            up = abs(y1 - y) / (high - low) * rows
            for k in range(1, math.ceil(max(across, up)) + 1):
                t = k / (math.ceil(max(across, up)) + 1)
                put(
                    x + t * (x1 - x),
                    y if series.style is Style.STEPS else y + t * (y1 - y),
                    series.mark,
                )
    for x, y, text in chart.notes:
        put(x, y, text)
    lines = [chart.title, f"{chart.y_label}"]
    for i, cells in enumerate(grid):
        value = f"{high:g}" if i == 0 else f"{low:g}" if i == rows - 1 else ""
        lines.append(f"{value:>{gutter}} |" + "".join(cells))
    lines.append(" " * gutter + " +" + "-" * columns)
    ends = f"{left:g}", f"{right:g}"
    middle = chart.x_label.center(columns - len(ends[0]) - len(ends[1]))
    lines.append(" " * (gutter + 2) + ends[0] + middle + ends[1])
    legend = "   ".join(f"{s.mark} {s.label}" for s in chart.series if s.label)
    if legend:
        lines.append(" " * (gutter + 2) + legend)
    return "\n".join(lines)


def _ends(low: float, high: float) -> tuple[float, float]:
    """Round numbers around a range."""
    if high - low < 1e-9:
        return low - 0.5, high + 0.5
    unit = 10.0 ** math.floor(math.log10((high - low) / 5))
    return round(math.floor(low / unit + 1e-9) * unit, 9), round(
        math.ceil(high / unit - 1e-9) * unit, 9
    )
