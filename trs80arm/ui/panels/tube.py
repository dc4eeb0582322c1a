"""The TRS-80's tube: 64 x 16 cells, drawn row by row from the video memory.

The machine's screen is told which rows changed; only these are drawn again.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

from rich.segment import Segment
from rich.style import Style
from textual.filter import LineFilter
from textual.geometry import Size
from textual.strip import Strip
from textual.widget import Widget

from trs80arm.drawing.glyphs import GLYPHS
from trs80arm.machine.video import COLUMNS, ROWS
from trs80arm.options import GlyphSet
from trs80arm.ui.terminal.changes import Change
from trs80arm.ui.terminal.filters import in_true_colours, needed
from trs80arm.ui.terminal.layers import Layer

_GRAPHICS = 128
"""The first code of the graphics characters."""
_BLANK = b" "


class Picture(Protocol):
    """The video memory as the tube needs it."""

    wide: bool

    def take_dirty(self) -> list[int]:
        """The rows that changed since the last call."""

    def row(self, number: int) -> bytes:
        """The 64 codes of a row."""


class Tube(Widget):
    """The screen of the TRS-80.

    Attributes:
        first_row: the first row that is shown, where there is no room for all.
        first_column: the first column that is.
        graphics: whether there are graphics on the tube.
        wrote_elsewhere: whether something new was written above the rows that are shown, as PRINT@
            and SET do, and not scrolled there.
    """

    HELP = """
    # The tube

    The TRS-80's screen: 16 lines of 64 characters, or 32 wide ones, with blocks of 2x3 for
    graphics. Every plain key goes to the TRS-80 while no dialog is open.
    """
    ALLOW_SELECT = False
    DEFAULT_CSS = """
    Tube { width: 64; height: 16; color: $tube; background: $tube-background; }
    """

    def __init__(self, *, id: str | None = None) -> None:
        super().__init__(id=id)
        self._rows = [b" " * COLUMNS] * ROWS
        self._wide = False
        self._glyphs = GlyphSet.SEXTANT
        self._strips: dict[tuple[bytes, bool], Strip] = {}
        self._known_style: Style | None = None
        self._cursor: int | None = None
        self._cursor_hidden = False
        self.graphics = False
        self.first_row = 0
        self.first_column = 0
        self.wrote_elsewhere = False

    @property
    def glyph_set(self) -> GlyphSet:
        """The set that graphics are drawn with."""
        return self._glyphs

    @glyph_set.setter
    def glyph_set(self, chosen: GlyphSet) -> None:
        self._glyphs = chosen
        self._strips.clear()
        self.refresh()

    @property
    def text(self) -> str:
        """What the tube shows, as sixteen lines."""
        return "\n".join(self._text(row).rstrip() for row in range(ROWS))

    def show(self, picture: Picture, cursor: int | None, *, cursor_hidden: bool = False) -> None:
        """Draw what changed.

        Args:
            picture: the video memory.
            cursor: the cell, 0 to 1023, where the ROM's cursor stands; None when it is off.
            cursor_hidden: whether a blinking cursor is in its dark half.
        """
        dirty = set(picture.take_dirty())
        switched = picture.wide is not self._wide
        self._wide = picture.wide
        elsewhere = cursor != self._cursor
        if elsewhere or cursor_hidden is not self._cursor_hidden:
            dirty |= {at // COLUMNS for at in (cursor, self._cursor) if at is not None}
            self._cursor, self._cursor_hidden = cursor, cursor_hidden
        before = list(self._rows)
        changed = [row for row in sorted(dirty) if self._take(row, picture.row(row))]
        if changed:
            self.graphics = any(max(row) >= _GRAPHICS for row in self._rows)
        moved = (elsewhere or bool(changed)) and self._look_at(cursor)
        self.wrote_elsewhere = any(
            row < self.first_row and self._rows[row].strip()
            for row in (range(ROWS) if switched else changed)
        ) and not _scrolled(before, self._rows)
        if moved or switched:
            self.refresh()
        elif changed:
            self._write(before, changed)

    def _write(self, before: list[bytes], changed: list[int]) -> None:
        """Write what differs in some rows from before, at once if can be, or have it written."""
        if not self.is_attached:
            return  # In a window that is too small it is on no screen; later all of it is drawn.
        style = self._style
        width, height = self.size
        changes = []
        for row in changed:
            y = row - self.first_row
            if 0 <= y < height:
                first, last = _differing(before[row], self._rows[row], wide=self._wide)
                left = max(first, self.first_column)
                text = self._text(row)[left : min(last, self.first_column + width)]
                if text:
                    changes.append(Change(left - self.first_column, y, [(text, style)]))
        screen = self.screen
        direct = not self.get_line_filters()
        if changes and not (direct and isinstance(screen, Layer) and screen.change(self, changes)):
            self.refresh(*(each.region for each in changes))

    def get_line_filters(self) -> Sequence[LineFilter]:
        """The program's filters, but for those that would change nothing on the tube."""
        return needed(super().get_line_filters(), true_colours=in_true_colours(self._style))

    @property
    def _style(self) -> Style:
        """The one style of all that is shown; to find it takes a while."""
        if self._known_style is None:
            self._known_style = self.rich_style
        return self._known_style

    def on_resize(self) -> None:
        """Show what is to be seen where there is more room, or less."""
        if self._look_at(self._cursor):
            self.refresh()

    def _look_at(self, cursor: int | None) -> bool:
        """Where it has not the room for all, show its last lines, and the columns of the cursor.

        Returns:
            Whether it shows other cells than before.
        """
        width, height = self.size
        written = [row for row in range(ROWS) if self._rows[row].strip(_BLANK)]
        last = max([*written, 0 if cursor is None else cursor // COLUMNS])
        row = min(max(0, last - height + 1), max(0, ROWS - height))
        column = 0
        if cursor is not None and 0 < width < COLUMNS:
            column = max(0, min(COLUMNS - width, cursor % COLUMNS - width + 1))
        before = self.first_row, self.first_column
        self.first_row, self.first_column = row, column
        return before != (row, column)

    def _take(self, row: int, codes: bytes) -> bool:
        """Have a row show these codes, but for a cursor in its dark half; whether it differs."""
        cursor = self._cursor
        if self._cursor_hidden and cursor is not None and cursor // COLUMNS == row:
            column = cursor % COLUMNS
            codes = codes[:column] + b" " + codes[column + 1 :]
        before, self._rows[row] = self._rows[row], codes
        return codes != before

    def _text(self, row: int) -> str:
        return GLYPHS[self._glyphs].row(self._rows[row], wide=self._wide)

    def notify_style_update(self) -> None:
        """Forget the old colours, and the strips drawn in them."""
        self._strips.clear()
        self._known_style = None
        super().notify_style_update()

    def get_content_width(self, container: Size, viewport: Size) -> int:
        """The 64 columns."""
        return COLUMNS

    def get_content_height(self, container: Size, viewport: Size, width: int) -> int:
        """The 16 rows."""
        return ROWS

    def render_line(self, y: int) -> Strip:
        """One row in one style."""
        y += self.first_row
        if not 0 <= y < ROWS:
            return Strip.blank(self.size.width, self._style)
        key = (self._rows[y], self._wide)
        strip = self._strips.get(key)
        if strip is None:
            if len(self._strips) > 256:
                self._strips.clear()
            strip = Strip([Segment(self._text(y), self._style)], COLUMNS)
            self._strips[key] = strip
        strip = strip.crop(self.first_column) if self.first_column else strip
        return strip.adjust_cell_length(self.size.width, self._style)


def _differing(before: bytes, now: bytes, *, wide: bool) -> tuple[int, int]:
    """The columns from the first code in which two rows differ to the last, by way of the cells."""
    places = [place for place in range(COLUMNS) if before[place] != now[place]]
    # A wide character takes the place of the next one too.
    return (places[0] & ~1, (places[-1] | 1) + 1) if wide else (places[0], places[-1] + 1)


def _scrolled(before: list[bytes], now: list[bytes]) -> bool:
    """Whether what is seen is what was seen, some lines further up; the last one may have grown."""
    return any(now[: ROWS - 1 - by] == before[by:-1] for by in range(1, ROWS - 1))
