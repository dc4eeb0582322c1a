"""Textual's palette of commands over the desk, of which only what changes is drawn."""

from __future__ import annotations

from textual.command import CommandPalette

from trs80arm.ui.terminal.layers import SeenThrough


class PaletteScreen(CommandPalette, SeenThrough):
    """The palette."""
