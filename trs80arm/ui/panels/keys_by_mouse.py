"""Keys of the TRS-80 that the mouse presses: the left button holds, the right one latches."""

from __future__ import annotations

from textual import events
from textual.message import Message
from textual.widget import Widget

from trs80arm.rig import Key


class KeyHeld(Message):
    """The mouse went down on a key: to be held until `KeysLetGo`."""

    def __init__(self, key: Key) -> None:
        super().__init__()
        self.key = key


class KeysLetGo(Message):
    """The mouse button was let go."""


class KeyLatched(Message):
    """A key was clicked with the right button: to be turned on, or off if it was."""

    def __init__(self, key: Key) -> None:
        super().__init__()
        self.key = key


class KeysByMouse(Widget):
    """A widget with keys on it; subclasses say in `key_at` where."""

    def key_at(self, x: int, y: int) -> Key | None:
        """The key at a cell, None where there is none."""
        raise TypeError(f"{type(self).__name__} does not say where its keys are")

    def on_mouse_down(self, event: events.MouseDown) -> None:
        """Hold or latch the key under the mouse."""
        key = self.key_at(event.x, event.y)
        if key is None:
            return
        event.stop()
        if event.button == 1:
            self.capture_mouse()
            self.post_message(KeyHeld(key))
        else:
            self.post_message(KeyLatched(key))

    def on_mouse_up(self, event: events.MouseUp) -> None:
        """Let go, wherever the mouse is."""
        if self.app.mouse_captured is self:
            self.release_mouse()
            self.post_message(KeysLetGo())

    def on_mouse_release(self, event: events.MouseRelease) -> None:
        """The capture was taken away: the finger is off."""
        self.post_message(KeysLetGo())
