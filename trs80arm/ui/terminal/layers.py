"""Screens one over the other, of which only what changed is drawn.

Textual draws the whole window again whenever anything changes behind a dialog. Here the lower
screen says which lines changed, and the dialog keeps the other lines as it dimmed them. The private
hooks that it leans on are pinned by `tests/ui/test_terminal_hooks.py`.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from rich.segment import Segment
from rich.style import Style
from textual.color import Color
from textual.geometry import Region
from textual.screen import Screen
from textual.strip import Strip

MOST_STYLES = 4096
"""Dimmed styles that are kept; a theme has some dozens."""


class Layer(Screen[Any]):
    """A screen that tells the one above it which parts of it changed."""

    def _compositor_refresh(self) -> None:
        """Draw what is dirty, or have the screen above draw it where it shows through."""
        stack = self.app.screen_stack
        above = stack[stack.index(self) + 1 :][:1] if self in stack else []
        if self.app.is_inline or not above or not isinstance(above[0], SeenThrough):
            super()._compositor_refresh()
            return
        changed = set(self._compositor._dirty_regions)
        self._compositor._dirty_regions.clear()
        self._dirty_widgets.clear()
        if changed:
            above[0].behind_changed(changed)


class SeenThrough(Layer):
    """A screen with a translucent ground: what is behind it is seen, dimmed."""

    def __init__(self, *arguments: Any, **more: Any) -> None:
        super().__init__(*arguments, **more)
        self._dimmed: dict[int, Strip] = {}
        self._dimmed_styles: dict[Style, Style] = {}

    def behind_changed(self, regions: Iterable[Region]) -> None:
        """Something changed behind this screen: draw it anew, and nothing else."""
        self._set_dirty(*regions)
        self._dirty_widgets.add(self)
        self.check_idle()

    def _set_dirty(self, *regions: Region) -> None:
        """Forget the lines that are to be drawn anew; all of them without a region."""
        if regions:
            for region in regions:
                for line in region.line_range:
                    self._dimmed.pop(line, None)
        else:
            self._dimmed.clear()
        super()._set_dirty(*regions)

    def notify_style_update(self) -> None:
        """The theme changed, and all colours with it."""
        self._dimmed.clear()
        self._dimmed_styles.clear()
        super().notify_style_update()

    def render_line(self, y: int) -> Strip:
        """A line of what is behind, dimmed by this screen's own ground."""
        if y not in self._dimmed:
            self._dim_missing_lines()
        return self._dimmed.get(y) or Strip.blank(self.size.width, self.rich_style)

    def _dim_missing_lines(self) -> None:
        stack = self.app.screen_stack
        below = stack[stack.index(self) - 1]._compositor if self in stack[1:] else None
        if below is None:
            return
        missing = set(range(self.size.height)) - self._dimmed.keys()
        for y, chops in enumerate(below._render_chops(below.size.region, missing.__contains__)):
            if y in missing:
                strip = Strip.join(chops.values())
                self._dimmed[y] = Strip(map(self._dim, strip), strip.cell_length)

    def _dim(self, segment: Segment) -> Segment:
        style = segment.style or Style.null()
        dimmed = self._dimmed_styles.get(style)
        if dimmed is None:
            if len(self._dimmed_styles) > MOST_STYLES:
                self._dimmed_styles.clear()
            dimmed = _dimmed_style(style, self.styles.background)
            self._dimmed_styles[style] = dimmed
        return Segment(segment.text, dimmed, segment.control)


def _dimmed_style(style: Style, ground: Color) -> Style:
    """A style under a translucent ground, without links, as Textual has it."""
    plain = style.clear_meta_and_links()
    if ground.a == 0:
        return plain
    return plain + Style.from_color(
        (Color.from_rich_color(style.color) + ground).rich_color if style.color else None,
        (Color.from_rich_color(style.bgcolor) + ground).rich_color if style.bgcolor else None,
    )
