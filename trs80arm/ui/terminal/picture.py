"""What stands on the screen, line by line: one of Textual's private calls."""

from __future__ import annotations

from typing import Any

from textual.app import App
from textual.strip import Strip


def on_screen(app: App[Any]) -> list[Strip]:
    """The lines of the topmost screen as a terminal would get them."""
    ground = app.screen.background_colors[1]
    lines = app.screen._compositor.render_strips()
    for line_filter in app.get_line_filters():
        lines = [line.apply_filter(line_filter, ground) for line in lines]
    return lines
