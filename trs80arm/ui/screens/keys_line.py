"""The line at the foot of a dialog that names the keys of what has the keyboard."""

from __future__ import annotations

from typing import NamedTuple

from textual import events
from textual.content import Content
from textual.reactive import reactive
from textual.screen import Screen
from textual.widget import Widget


class _Named(NamedTuple):
    """A key in the line: its name on the terminal, how it is shown, what it does."""

    key: str
    shown: str
    does: str
    is_enabled: bool

    @property
    def width(self) -> int:
        """Columns, with the one behind it."""
        return Content(f"{self.shown} {self.does} ").cell_length


class KeysLine(Widget):
    """The keys that are bound, each with what it does; a click is the key.

    It looks as Textual's footer does when it is compact, and is one widget where that is one for
    each key, made anew whenever something else comes to have the keyboard: opening a dialog would
    take half as long again.
    """

    ALLOW_SELECT = False
    DEFAULT_CSS = """
    KeysLine {
        dock: bottom; height: 1; text-wrap: nowrap;
        color: $footer-foreground; background: $footer-background;
    }
    """

    pointed: reactive[int | None] = reactive(None)
    """Which key the mouse is on."""

    def __init__(self) -> None:
        super().__init__()
        self._named: list[_Named] = []

    def on_mount(self) -> None:
        """Follow what has the keyboard."""
        self.screen.bindings_updated_signal.subscribe(self, self._bindings_changed)

    def _bindings_changed(self, screen: Screen[object]) -> None:
        if screen is not self.screen or not screen.app.app_focus:
            return
        named: dict[str, _Named] = {}
        for _, binding, enabled, _ in screen.active_bindings.values():
            if binding.show:
                # Of several keys that do the same the first is named.
                shown = self.app.get_key_display(binding)
                one = _Named(binding.key, shown, binding.description, enabled)
                named.setdefault(binding.action, one)
        self._named = list(named.values())
        self.refresh()

    def render(self) -> Content:
        """The line."""
        return Content.assemble(*map(self._drawn, range(len(self._named))))

    def _drawn(self, place: int) -> Content:
        one = self._named[place]
        dim = "" if one.is_enabled else " dim"
        key, does = "$footer-key-background", "$footer-description-background"
        if place == self.pointed:
            key = does = "$block-hover-background"
        styles = (
            f"bold $footer-key-foreground on {key}{dim}",
            f"$footer-description-foreground on {does}{dim}",
        )
        return Content.assemble((one.shown, styles[0]), (f" {one.does}", styles[1]), " ")

    def _at(self, column: int) -> int | None:
        """Which key is in a column."""
        for place, one in enumerate(self._named):
            if column < one.width - 1:
                return place if column >= 0 else None
            column -= one.width
        return None

    def on_mouse_move(self, event: events.MouseMove) -> None:
        """Show which key the mouse is on."""
        self.pointed = self._at(event.x)

    def on_leave(self) -> None:
        """The mouse is elsewhere."""
        self.pointed = None

    def on_mouse_down(self, event: events.MouseDown) -> None:
        """A click is the key."""
        place = self._at(event.x)
        if place is None:
            return
        if self._named[place].is_enabled:
            self.app.simulate_key(self._named[place].key)
        else:
            self.app.bell()
