"""The key test: what the terminal tells of each key, for bug reports and for the curious."""

from __future__ import annotations

from textual import events
from textual.app import ComposeResult
from textual.containers import Vertical
from textual.widgets import RichLog, Static

from trs80arm.options import KeyMode
from trs80arm.ui.keys.host_keys import trs80_keys
from trs80arm.ui.screens.dialog import Dialog


class KeyTest(Dialog[None]):
    """Shows every key event; Escape twice leaves.

    Args:
        in_use: how keys work at present.
        reports: whether the terminal reports releases.
    """

    BINDINGS = []  # noqa: RUF012
    DEFAULT_CSS = """
    KeyTest > .dialog { height: 20; }
    KeyTest RichLog { height: 1fr; background: $surface; }
    """

    def __init__(self, in_use: KeyMode, *, reports: bool) -> None:
        super().__init__()
        self._in_use = in_use
        self._reports = reports
        self._down: set[str] = set()
        self._escaped = False

    def compose(self) -> ComposeResult:
        """What is down, and a log."""
        tells = "tells" if self._reports else "does not tell"
        with Vertical(classes="dialog") as box:
            box.border_title = "Key test"
            box.border_subtitle = "Escape twice goes back"
            yield Static(
                f"This terminal {tells} when a key is let go. KEYS: {self._in_use.value}",
                classes="hint",
            )
            yield Static("Down: none", id="down", markup=False)
            yield RichLog(markup=False, wrap=False)

    def went_down(self, base: str, name: str, text: str | None) -> None:
        """A press with a release to come."""
        self._down.add(base)
        self._tell(f"down  {base:10} {name:18} text {text!r}")

    def went_up(self, base: str) -> None:
        """A release."""
        self._down.discard(base)
        self._tell(f"up    {base}")

    def on_key(self, event: events.Key) -> None:
        """An ordinary key event."""
        event.stop()
        event.prevent_default()
        if event.key == "escape" and self._escaped:
            self.dismiss(None)
            return
        self._escaped = event.key == "escape"
        keys = trs80_keys(event.key, event.character)
        meaning = "+".join(keys) if keys else "no key of the TRS-80"
        self._tell(f"key   {event.key:18} text {event.character!r:8} {meaning}")

    def _tell(self, line: str) -> None:
        self.query_one(RichLog).write(line)
        down = " ".join(sorted(self._down)) or "none"
        self.query_one("#down", Static).update(f"Down: {down}")
