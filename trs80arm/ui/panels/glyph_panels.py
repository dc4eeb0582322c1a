"""Panels that draw with more than plain characters, and what they draw where all is plain."""

from __future__ import annotations

from trs80arm.drawing.rows import Ink, Span
from trs80arm.ui.panels.panel import Panel

_LAMPS = ("●", "○")
_ASCII_LAMPS = ("*", ".")


class GlyphPanel(Panel):
    """A panel whose glyphs have plain characters to stand for them."""

    def __init__(self, *, id: str | None = None, classes: str | None = None) -> None:
        super().__init__(id=id, classes=classes)
        self._ascii = False

    @property
    def ascii(self) -> bool:
        """Whether all is drawn with plain characters."""
        return self._ascii

    @ascii.setter
    def ascii(self, value: bool) -> None:
        self._ascii = value
        self.redraw()


class LampPanel(GlyphPanel):
    """A panel with lamps: circles that are lit or not, or `*` and `.`."""

    def lamp(self, lit: bool, gap: str = "") -> Span:
        """A lamp, and what comes after it."""
        on, off = _ASCII_LAMPS if self.ascii else _LAMPS
        return ((on if lit else off) + gap, Ink.LAMP_ON if lit else Ink.LAMP_OFF)
