"""Panels that draw with more than plain characters, and what they draw where all is plain."""

from __future__ import annotations

from textual.reactive import var

from trs80arm.drawing.rows import Ink, Span
from trs80arm.ui.panels.panel import Panel

_LAMPS = ("●", "○")
_ASCII_LAMPS = ("*", ".")


class GlyphPanel(Panel):
    """A panel whose glyphs have plain characters to stand for them."""

    ascii = var(False, init=False)
    """Whether all is drawn with plain characters."""

    def watch_ascii(self) -> None:
        """Draw anew."""
        self.redraw()


class LampPanel(GlyphPanel):
    """A panel with lamps: circles that are lit or not, or `*` and `.`."""

    def lamp(self, lit: bool, gap: str = "") -> Span:
        """A lamp, and what comes after it."""
        on, off = _ASCII_LAMPS if self.ascii else _LAMPS
        return ((on if lit else off) + gap, Ink.LAMP_ON if lit else Ink.LAMP_OFF)
