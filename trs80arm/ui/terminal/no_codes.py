"""Nothing that is drawn is a control code, wherever it came from.

Names of files, keys of a bench file and lines of a program are shown in many places. Textual writes
what it is given, so the last filter before the terminal drops what a terminal would obey.
"""

from __future__ import annotations

from rich.segment import Segment
from textual.color import Color
from textual.filter import LineFilter


class NoControlCodes(LineFilter):
    """Drops what is not printable; it has no width, so that everything keeps its place."""

    def apply(self, segments: list[Segment], background: Color) -> list[Segment]:
        """The segments of a line as they may be written."""
        return [
            segment
            if segment.control or segment.text.isprintable()
            else Segment(printable(segment.text), segment.style)
            for segment in segments
        ]


def printable(text: str) -> str:
    """Text without what a terminal would obey."""
    return text if text.isprintable() else "".join(sign for sign in text if sign.isprintable())
