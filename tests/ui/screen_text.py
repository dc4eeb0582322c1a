"""Screens as text: what a terminal of a given size shows, row by row, and in which colours."""

from __future__ import annotations

from typing import Any

from rich.segment import Segment
from rich.style import Style
from textual.app import App
from textual.geometry import Region


def _rows(app: App[Any]) -> list[list[Segment]]:
    """The rows of the screen. The one place that asks Textual's compositor."""
    return [list(strip) for strip in app.screen._compositor.render_strips()]


def screen_text(app: App[Any]) -> str:
    """What the screen shows, without colours; trailing blanks removed."""
    rows = ("".join(segment.text for segment in row).rstrip() for row in _rows(app))
    return "\n".join(rows) + "\n"


def screen_colours(app: App[Any]) -> str:
    """The colours of each row's runs: `foreground/background` and how many cells of each."""
    lines = []
    for row in _rows(app):
        runs: list[list[Any]] = []
        for segment in row:
            name = _style_name(segment)
            if runs and runs[-1][0] == name:
                runs[-1][1] += len(segment.text)
            elif segment.text:
                runs.append([name, len(segment.text)])
        lines.append(" ".join(f"{name}*{count}" for name, count in runs))
    return "\n".join(lines) + "\n"


def styles_at(app: App[Any], region: Region) -> list[Style]:
    """The styles of the cells of a region."""
    found = []
    for row in _rows(app)[region.y : region.bottom]:
        cells = [segment.style or Style() for segment in row for _ in segment.text]
        found += cells[region.x : region.right]
    return found


def _style_name(segment: Segment) -> str:
    style = segment.style
    if style is None:
        return "-"
    front = style.color.get_truecolor().hex if style.color else "-"
    back = style.bgcolor.get_truecolor().hex if style.bgcolor else "-"
    flags = "".join(
        letter for letter, on in (("b", style.bold), ("r", style.reverse), ("d", style.dim)) if on
    )
    return f"{front}/{back}{flags}"
