"""Cells that changed, written as they are: no more of them, and no more codes than it takes.

Textual renders whole lines of a widget with their frame, cuts them where widgets meet, and writes
ink and ground before each run of characters and a reset behind it. Here a line's part that changed
goes to the terminal straight from the panel that knows it, and a colour is written where another
one begins.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple, TypeAlias

from rich.color import ColorSystem
from rich.console import Console
from rich.style import Style
from textual._compositor import CompositorUpdate
from textual.geometry import Region

Run: TypeAlias = tuple[str, Style]
"""Characters, each a cell wide, in one style."""


class Change(NamedTuple):
    """Some cells of one line.

    Attributes:
        x: the first one's column.
        y: their line.
        runs: what they show from now on.
    """

    x: int
    y: int
    runs: Sequence[Run]

    @property
    def region(self) -> Region:
        """The cells."""
        return Region(self.x, self.y, sum(len(text) for text, _ in self.runs), 1)


class Codes(NamedTuple):
    """A style as a terminal is told of it.

    Attributes:
        ink: the codes of its colour.
        ground: those of what is behind it.
        rest: bold and the like.
        seen_on_blanks: whether a blank shows more of it than the ground.
    """

    ink: str
    ground: str
    rest: str
    seen_on_blanks: bool


_PLAIN = Codes("39", "49", "", seen_on_blanks=False)


class CellsUpdate(CompositorUpdate):
    """Writes changes.

    Args:
        changes: of cells, by their places on the screen.
    """

    def __init__(self, changes: Sequence[Change]) -> None:
        self.changes = changes

    def render_segments(self, console: Console) -> str:
        """The changes as a terminal is told of them; it is left without any colours."""
        system = console._color_system or ColorSystem.TRUECOLOR
        written: list[str] = []
        now = _PLAIN
        for x, y, runs in self.changes:
            written.append(f"\x1b[{y + 1};{x + 1}H")
            for text, style in runs:
                to = _codes(style, system)
                if to is not now:
                    change, now = _between(now, to, blank=not text.strip(" "))
                    written.append(change)
                written.append(text)
        written.append("\x1b[0m")
        return "".join(written)


def _between(now: Codes, to: Codes, *, blank: bool) -> tuple[str, Codes]:
    """The codes from one style to another, as far as it is seen; and the style that then holds."""
    if blank and not now.seen_on_blanks and not to.seen_on_blanks:
        to = Codes(now.ink, to.ground, now.rest, seen_on_blanks=False)
    if to.rest != now.rest:
        every = (code for code in ("0", to.rest, to.ink, to.ground) if code)
        return f"\x1b[{';'.join(every)}m", to
    changed = [new for old, new in ((now.ink, to.ink), (now.ground, to.ground)) if new != old]
    return (f"\x1b[{';'.join(changed)}m" if changed else ""), to


@lru_cache(4096)
def _codes(style: Style, system: ColorSystem) -> Codes:
    ink, ground = (
        ";".join(colour.downgrade(system).get_ansi_codes(foreground=foreground))
        if colour
        else default
        for colour, foreground, default in (
            (style.color, True, _PLAIN.ink),
            (style.bgcolor, False, _PLAIN.ground),
        )
    )
    rest = style.without_color._make_ansi_codes(system)
    drawn = (style.reverse, style.underline, style.underline2, style.overline, style.strike)
    return Codes(ink, ground, rest, seen_on_blanks=any(drawn))
