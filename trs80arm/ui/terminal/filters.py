"""Which of Textual's filters a line that was made here still needs."""

from __future__ import annotations

from collections.abc import Sequence

from rich.style import Style
from textual.filter import ANSIToTruecolor, LineFilter

from trs80arm.ui.terminal.no_codes import NoControlCodes


def needed(filters: Sequence[LineFilter], *, true_colours: bool) -> Sequence[LineFilter]:
    """The filters that may change a line of printable characters.

    Args:
        filters: the program's.
        true_colours: whether no colour of the line is one of the terminal's own.
    """
    idle = (NoControlCodes, ANSIToTruecolor) if true_colours else NoControlCodes
    return [one for one in filters if not isinstance(one, idle)]


def in_true_colours(style: Style) -> bool:
    """Whether neither colour of a style is one of the terminal's own, which nobody knows."""
    return all(
        colour is not None and colour.triplet is not None for colour in (style.color, style.bgcolor)
    )
