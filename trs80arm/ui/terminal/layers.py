"""Screens one over the other, of which only what changed is drawn.

Textual draws the whole window again whenever anything changes behind a dialog. Here the lower
screen says which lines changed, and the dialog keeps the other lines as it dimmed them; and of each
screen only the panels and lines that changed are asked for. The private hooks that it leans on are
pinned by `tests/ui/test_layers.py` and `tests/ui/test_terminal_hooks.py`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from contextlib import contextmanager
from itertools import takewhile
from typing import Any

from rich.segment import Segment
from rich.style import Style
from textual._compositor import ChopsUpdate, Compositor
from textual.color import Color
from textual.events import ScreenResume
from textual.geometry import Offset, Region
from textual.screen import Screen
from textual.strip import Strip
from textual.widget import Widget

from trs80arm.ui.terminal.changes import CellsUpdate, Change

MOST_STYLES = 4096
"""Dimmed styles that are kept; a theme has some dozens."""


class FrugalCompositor(Compositor):
    """Puts together what changed, of the widgets and lines that changed.

    Textual asks for all lines of all widgets in the rectangle around everything that changed: where
    two panels at opposite corners change, these are all.
    """

    def __init__(self) -> None:
        super().__init__()
        self._changed: tuple[Region, ...] = ()

    def render_partial_update(self) -> ChopsUpdate | None:
        """What is to be written."""
        self._changed = tuple(self._dirty_regions)
        try:
            return super().render_partial_update()
        finally:
            self._changed = ()

    def _get_renders(
        self, crop: Region | None = None
    ) -> Iterable[tuple[Region, Region, list[Strip]]]:
        """Of each widget where it is, the part of it that is asked for, and the lines of that.

        Lines that are all behind other widgets are not asked for: nothing of them is seen.
        """
        window = self.size.region
        asked = [part.intersection(window) for part in self._changed or (crop or window,)]
        bare = [0] * window.height
        for part in asked:
            for y in part.line_range:
                bare[y] |= _cells(part)
        for widget, (region, clip) in self.visible_widgets.items():
            seen = region.intersection(clip).intersection(window)
            lines = [part.line_span for part in asked if part.overlaps(seen)]
            if not lines:
                continue
            top = max(seen.y, min(first for first, _ in lines))
            bottom = min(seen.bottom, max(last for _, last in lines))
            cells = _cells(seen)
            while top < bottom and not bare[top] & cells:
                top += 1
            while top < bottom and not bare[bottom - 1] & cells:
                bottom -= 1
            if top < bottom:
                for y in range(top, bottom):
                    bare[y] &= ~cells
                part = Region(seen.x, top, seen.width, bottom - top)
                yield region, part, widget.render_lines(part.translate(-region.offset))


def _cells(region: Region) -> int:
    """The columns of a region, a bit each."""
    return ((1 << region.width) - 1) << region.x


class Layer(Screen[Any]):
    """A screen that draws only what changed, and tells the one above it which parts these are."""

    def __init__(self, *arguments: Any, **more: Any) -> None:
        super().__init__(*arguments, **more)
        self._compositor = FrugalCompositor()
        self._changes: list[Change] | None = None
        self._places: dict[Widget, Offset | None] = {}
        self._laid_out: object = None
        self._updating = False
        self._to_be_drawn = False

    def _on_screen_resume(self, event: ScreenResume) -> None:
        """Shown for the first time, all of it has just got its styles: they are not found again.

        Textual's own handler comes after this one.
        """
        if not self.stack_updates:
            event.refresh_styles = False

    @contextmanager
    def frame(self) -> Iterator[None]:
        """What changes meanwhile is written at once, and all of it together."""
        at_once = self.app.screen is self and not self._layout_required and not self.app.is_inline
        self._changes = [] if at_once else None
        try:
            yield
        finally:
            changes, self._changes = self._changes, None
            if changes:
                update: Any = CellsUpdate(changes)
                self.app._display(self, update)

    def change(self, widget: Widget, changes: Sequence[Change]) -> bool:
        """Write cells of a widget, by their places in its content, if that can be done at once.

        Returns:
            Whether it is; if not, the widget has to ask Textual for it.
        """
        place = None if self._changes is None or self._layout_required else self._place(widget)
        if self._changes is None or place is None:
            return False
        left, top = place
        self._changes += [Change(x + left, y + top, runs) for x, y, runs in changes]
        # Where Textual itself draws these lines again, it is not to take them from its cache.
        first, last = changes[0].y, changes[-1].y
        lines = Region(0, first, 1, last - first + 1).translate(widget.content_offset)
        widget._styles_cache.set_dirty(lines)
        return True

    def _place(self, widget: Widget) -> Offset | None:
        """Where a widget's content begins; None if not all of it is seen."""
        seen = self._compositor.visible_widgets
        if seen is not self._laid_out:
            self._laid_out = seen
            self._places = {}
        if widget not in self._places:
            self._places[widget] = _unobstructed(widget, seen)
        return self._places[widget]

    def _on_timer_update(self) -> None:
        """Lay out what has to be, and then draw, once."""
        self._updating, self._to_be_drawn = True, False
        try:
            super()._on_timer_update()
        finally:
            self._updating = False
        if self._to_be_drawn:
            self._draw()

    def _compositor_refresh(self) -> None:
        """Have what is dirty drawn when all is laid out.

        Textual draws whenever it lays something out, and what opens is laid out two or three times
        before its parts know their sizes.
        """
        if self._updating:
            self._to_be_drawn = True
        elif self.app.screen is self and self._compositor._dirty_regions and not self.app.is_inline:
            self._dirty_widgets.add(self)
            self.check_idle()
        else:
            self._draw()

    def _draw(self) -> None:
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


def _unobstructed(widget: Widget, seen: Mapping[Widget, tuple[Region, Region]]) -> Offset | None:
    """Where a widget's content begins, of widgets that are seen, the foremost first.

    None if any of it is cut off, or behind another one.
    """
    if widget not in seen:
        return None
    region, clip = seen[widget]
    content = region.shrink(widget.gutter)
    before = takewhile(lambda other: other is not widget, seen)
    hidden = any(seen[other][0].intersection(seen[other][1]).overlaps(content) for other in before)
    return None if hidden or not clip.contains_region(content) else content.offset


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

    def render_lines(self, crop: Region) -> list[Strip]:
        """Lines of what is behind, dimmed by this screen's own ground."""
        missing = set(crop.line_range) - self._dimmed.keys()
        if missing:
            self._dim_lines(missing)
        return super().render_lines(crop)

    def render_line(self, y: int) -> Strip:
        """One of them."""
        return self._dimmed.get(y) or Strip.blank(self.size.width, self.rich_style)

    def _dim_lines(self, missing: Set[int]) -> None:
        stack = self.app.screen_stack
        below = stack[stack.index(self) - 1]._compositor if self in stack[1:] else None
        if below is None:
            return
        top, bottom = min(missing), max(missing) + 1
        crop = Region(0, top, below.size.width, bottom - top)
        for y, chops in enumerate(below._render_chops(crop, missing.__contains__)):
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
