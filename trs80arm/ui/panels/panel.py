"""The widget under every panel and view beside the tube: rows of text, drawn line by line.

A panel is fed `Readings` by `show`, at whatever rate the program likes. It makes its rows anew,
compares them with those on the screen and asks for the lines that differ, no more. It keeps no rig
and no clock.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from rich.cells import cell_len
from rich.color import Color
from rich.color_triplet import ColorTriplet
from rich.segment import Segment
from rich.style import Style
from textual.events import Resize
from textual.filter import LineFilter
from textual.geometry import Region
from textual.strip import Strip

from trs80arm.drawing.pixels import Colours
from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import DARKEST, LEVELS, LIGHT, Ink, Paint, Row, changed_part, fitted
from trs80arm.ui.terminal.changes import Change
from trs80arm.ui.terminal.components import LateComponents
from trs80arm.ui.terminal.filters import in_true_colours, needed
from trs80arm.ui.terminal.layers import Layer
from trs80arm.ui.terminal.no_codes import printable

_BLANK: Row = ()


def _component(ink: Ink) -> str:
    return f"panel--{ink.value}"


class Panel(LateComponents, can_focus=False):
    """A widget of text rows in inks; subclasses say in `draw` what the rows are."""

    DEFAULT_CSS = """
    Panel {
        & > .panel--faint { color: $text-muted; }
        & > .panel--label { color: $text-muted; }
        & > .panel--strong { color: $text; text-style: bold; }
        & > .panel--arm { color: $text-primary; text-style: bold; }
        & > .panel--hand { color: $text-accent; text-style: bold; }
        & > .panel--part { color: $text-warning; }
        & > .panel--furniture { color: $text-secondary; }
        & > .panel--ghost { color: $text-error; }
        & > .panel--trail { color: $text-success; }
        & > .panel--warning { color: $text-warning; text-style: bold; }
        & > .panel--alarm { color: $text-error; text-style: bold; }
        & > .panel--lamp-on { color: $text-warning; text-style: bold; }
        & > .panel--lamp-off { color: $text-muted; }
        & > .panel--metal { color: $foreground; }
        & > .panel--table { color: $foreground; }
        & > .panel--shadow { color: $foreground; }
        & > .panel--obstacle { color: $obstacle; }
        & > .panel--part-2 { color: $part-2; }
        & > .panel--part-3 { color: $part-3; }
        & > .panel--part-4 { color: $part-4; }
        & > .panel--part-5 { color: $part-5; }
        & > .panel--part-6 { color: $part-6; }
        &:ansi > .panel--obstacle { color: ansi_yellow; }
        &:ansi > .panel--part-2 { color: ansi_bright_red; }
        &:ansi > .panel--part-3 { color: ansi_bright_cyan; }
        &:ansi > .panel--part-4 { color: ansi_bright_magenta; }
        &:ansi > .panel--part-5 { color: ansi_magenta; }
        &:ansi > .panel--part-6 { color: ansi_cyan; }
        &:ansi:dark > .panel--table { color: ansi_bright_black; }
        &:ansi:dark > .panel--shadow { color: ansi_black; }
        &:ansi:light > .panel--table { color: ansi_white; }
        &:ansi:light > .panel--shadow { color: ansi_bright_black; }
        &:ansi:dark > .panel--arm { color: ansi_bright_cyan; }
        &:ansi:dark > .panel--ghost { color: ansi_bright_red; }
        &:ansi:dark > .panel--alarm { color: ansi_bright_red; }
        &:ansi:light > .panel--arm { color: ansi_blue; }
        &:ansi:light > .panel--part { color: ansi_red; }
        &:ansi:light > .panel--warning { color: ansi_red; }
        &:ansi:light > .panel--lamp-on { color: ansi_red; }
    }
    """
    HELP = ""
    """What the panel shows, in Markdown, for the help screen."""

    def __init__(self, *, id: str | None = None, classes: str | None = None) -> None:
        super().__init__(id=id, classes=classes)
        self._readings: Readings | None = None
        self._as_drawn: list[Row] = []
        self._rows: list[Row] = []
        self._strips: dict[Row, Strip] = {}
        self._known_styles: dict[Ink | Paint, Style] = {}
        self._true_colours: bool | None = None

    def show(self, readings: Readings) -> None:
        """Show these readings."""
        self._readings = readings
        self.redraw()

    def draw(self, readings: Readings, width: int, height: int) -> list[Row]:
        """The rows for a panel of `width` x `height` cells; missing ones are blank."""
        raise TypeError(f"{type(self).__name__} does not say how it is drawn")

    def redraw(self) -> None:
        """Draw the last readings again and refresh the rows that differ from the screen's."""
        width, height = self.size
        if self._readings is None or not width or not height:
            return
        drawn = self.draw(self._readings, width, height)[:height]
        drawn += [_BLANK] * (height - len(drawn))
        before, self._as_drawn = self._as_drawn, drawn
        rows = self._rows
        if len(rows) != height:
            self._rows = [fitted(row, width) for row in drawn]
            self._true_colours = None
            self.refresh()
            return
        changed: dict[int, Row] = {}
        for y, row in enumerate(drawn):
            if row is not before[y] and (row := fitted(row, width)) != rows[y]:
                changed[y], rows[y] = rows[y], row
        if changed:
            self._write(changed)

    def _write(self, changed: Mapping[int, Row]) -> None:
        """Write what changed of some lines, at once if that can be, or else have it written.

        Args:
            changed: what the lines showed before.
        """
        changes, narrow = [], True
        for y, before in changed.items():
            column, spans = changed_part(before, self._rows[y])
            runs = [(printable(text), self._style(ink)) for text, ink in spans]
            narrow &= all(text.isascii() or cell_len(text) == len(text) for text, _ in runs)
            changes.append(Change(column, y, runs))
        screen, width = self.screen, self.size.width
        direct = narrow and not self.get_line_filters()
        if not (direct and isinstance(screen, Layer) and screen.change(self, changes)):
            cells = (each.region if narrow else Region(0, each.y, width, 1) for each in changes)
            self.refresh(*cells)

    def on_resize(self, event: Resize) -> None:
        """Draw anew for the new size."""
        self._rows = []
        self._strips.clear()
        self.redraw()

    def notify_style_update(self) -> None:
        """The theme changed: the colours of all strips are void."""
        self._strips.clear()
        self._known_styles.clear()
        self._true_colours = None
        super().notify_style_update()

    def render_line(self, y: int) -> Strip:
        """One line of the panel."""
        width = self.size.width
        if y >= len(self._rows):
            return Strip.blank(width, self.rich_style)
        row = self._rows[y]
        strip = self._strips.get(row)
        if strip is None:
            if len(self._strips) > 4 * len(self._rows):
                self._strips.clear()
            strip = Strip([Segment(printable(text), self._style(ink)) for text, ink in row], width)
            self._strips[row] = strip
        return strip

    def get_line_filters(self) -> Sequence[LineFilter]:
        """The program's filters, but for those that would change nothing in lines made here."""
        if self._true_colours is None:
            # Of the inks that are on the panel only: to find one takes a while.
            inks = {ink for row in self._rows for _, ink in row}
            styles = [self.rich_style, *map(self._style, inks)]
            self._true_colours = all(map(in_true_colours, styles))
        return needed(super().get_line_filters(), true_colours=self._true_colours)

    @property
    def colours(self) -> Colours | None:
        """The theme's colours; None where they are the terminal's own, which nobody knows."""
        ground = self.rich_style.bgcolor
        inks = {ink: self._style(ink).color for ink in Ink}
        known = {ink: colour.triplet for ink, colour in inks.items() if colour and colour.triplet}
        if ground is None or ground.triplet is None or len(known) < len(inks):
            return None
        return Colours(ground.triplet, known)

    def _style(self, ink: Ink | Paint) -> Style:
        style = self._known_styles.get(ink)
        if style is None:
            style = self._shaded(ink) if isinstance(ink, Paint) else self._plain(ink)
            self._known_styles[ink] = style
            self._true_colours = None
        return style

    def _plain(self, ink: Ink) -> Style:
        plain = ink is Ink.PLAIN
        return self.rich_style if plain else self.get_component_rich_style(_component(ink))

    def _shaded(self, paint: Paint) -> Style:
        """An ink in light or shade, mixed with the ground; where it cannot be mixed, as it is."""
        ground = self.rich_style.bgcolor
        ink = self._plain(paint.ink).color
        if ground is None or ground.triplet is None or ink is None or ink.triplet is None:
            return self._plain(paint.ink)
        level, under_level = paint.level, paint.under_level
        if sum(ground.triplet) > LIGHT:
            level = LEVELS // 3 if paint.ink is Ink.SHADOW else level
            under_level = LEVELS // 3 if paint.under is Ink.SHADOW else under_level
        style = Style(color=_mixed(ground.triplet, ink.triplet, level), bgcolor=ground)
        under = self._plain(paint.under).color if paint.under else None
        if under is not None and under.triplet is not None:
            style += Style(bgcolor=_mixed(ground.triplet, under.triplet, under_level))
        return style


def _mixed(ground: ColorTriplet, ink: ColorTriplet, level: int) -> Color:
    """A colour so bright: from near the ground's to the ink's own."""
    share = DARKEST + (1 - DARKEST) * level / (LEVELS - 1)
    return Color.from_triplet(
        ColorTriplet(*(round(a + (b - a) * share) for a, b in zip(ground, ink, strict=True)))
    )
