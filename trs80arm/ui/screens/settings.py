"""The settings as they are, with their keys: what to write into which file to have it otherwise."""

from __future__ import annotations

from pathlib import Path

from textual.app import ComposeResult
from textual.containers import VerticalScroll
from textual.widgets import Static

from trs80arm.ui.screens.dialog import Dialog


class SettingsScreen(Dialog[None]):
    """Shows what is set.

    Args:
        path: the settings file, None when none is used.
        tables: the values by table and key.
    """

    DEFAULT_CSS = """
    SettingsScreen > .dialog { height: 90%; }
    """

    def __init__(self, path: Path | None, tables: dict[str, dict[str, str]]) -> None:
        super().__init__()
        self._path = path
        self._tables = tables

    def compose(self) -> ComposeResult:
        """The file, and the tables as they would stand in it."""
        lines = [f"File: {self._path or 'none'}", ""]
        for name, table in self._tables.items():
            lines.append(f"[{name}]")
            lines += [f"{key} = {value}" for key, value in table.items()]
            lines.append("")
        with VerticalScroll(classes="dialog") as box:
            box.border_title = "Settings"
            box.border_subtitle = "Arrows scroll, Escape goes back"
            yield Static("\n".join(lines), markup=False)
