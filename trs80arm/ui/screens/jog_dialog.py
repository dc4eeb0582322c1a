"""A dialog from which the arm is jogged: by keys that are held, and by the mouse on buttons."""

from __future__ import annotations

from typing import ClassVar, Protocol

from textual import events
from textual.widgets import Static

from trs80arm.drawing.readings import Readings
from trs80arm.options import ArmStyle
from trs80arm.ui.keys.jog_keyboard import JogKeyboard
from trs80arm.ui.panels.arm_view import ArmView
from trs80arm.ui.panels.keys_by_mouse import KeyHeld, KeyLatched, KeysLetGo
from trs80arm.ui.screens.dialog import Answer, Dialog

FRAMES_PER_SECOND = 15
WIDE = 110
"""Columns from which on the arm is seen from above, too."""


class Jogging(Protocol):
    """What such a dialog is given to work with."""

    @property
    def keyboard(self) -> JogKeyboard:
        """Its keys."""

    @property
    def style(self) -> ArmStyle:
        """How the arm is drawn."""

    def look(self) -> Readings:
        """Read the rig."""


class JogDialog(Dialog[Answer]):
    """The arm from the side and from above, as large as the window, and keys that jog it.

    Subclasses lay it out and say what `show_rest` shows beside the arm.
    """

    DEFAULT_CSS: ClassVar[str] = """
    JogDialog > .dialog {
        width: 100%; height: 100%; max-width: 100%; max-height: 100%; padding: 0;
    }
    JogDialog .views { height: 1fr; }
    JogDialog SideView { width: 5fr; height: 100%; }
    JogDialog TopView { width: 4fr; height: 100%; }
    JogDialog.narrow TopView { display: none; }
    """

    def __init__(self, jogging: Jogging) -> None:
        super().__init__()
        self._jogging = jogging
        self._said: dict[str, str] = {}

    def on_mount(self) -> None:
        """Look at the arm, again and again."""
        self._jogging.keyboard.take_up()
        for view in self.query(ArmView):
            view.picture.style = self._jogging.style
        self.set_interval(1 / FRAMES_PER_SECOND, self.show)
        self.call_after_refresh(self.show)

    def on_resize(self, event: events.Resize) -> None:
        """More in a larger window."""
        self.set_class(event.size.width < WIDE, "narrow")

    def on_screen_suspend(self) -> None:
        """Another dialog opened: all hands off."""
        self.hands_off()

    def hands_off(self) -> None:
        """Let every key go."""
        self._jogging.keyboard.keyboard.let_go()

    def show(self) -> None:
        """Show how it stands."""
        if not self.is_current:
            return
        readings = self._jogging.look()
        for view in self.query(ArmView):
            view.show(readings)
        self.show_rest(readings)

    def show_rest(self, readings: Readings) -> None:
        """Show what stands beside the arm."""
        raise NotImplementedError

    def say(self, where: str, text: str, *, layout: bool = False) -> None:
        """Have a text stand somewhere; one that stands there already costs nothing."""
        if self._said.get(where) != text:
            self._said[where] = text
            self.query_one(where, Static).update(text, layout=layout)

    # -- keys and buttons -------------------------------------------------------------------------

    def on_key(self, event: events.Key) -> None:
        """A key that jogs, of a terminal that does not tell when it is let go."""
        if self._jogging.keyboard.jogs(event.key, event.character):
            event.stop()
            event.prevent_default()
            self._jogging.keyboard.keyboard.typed(event.key, event.character)

    def went_down(self, base: str, name: str, text: str | None) -> None:
        """A key went down, and the terminal will tell when it goes up."""
        if self._jogging.keyboard.jogs(name, text):
            self._jogging.keyboard.keyboard.went_down(base, name, text)

    def went_up(self, base: str) -> None:
        """It went up."""
        self._jogging.keyboard.keyboard.went_up(base)

    def on_key_held(self, message: KeyHeld) -> None:
        """The mouse holds a button."""
        message.stop()
        self._jogging.keyboard.keyboard.point(message.key)

    def on_keys_let_go(self, message: KeysLetGo) -> None:
        """The mouse lets go."""
        message.stop()
        self._jogging.keyboard.keyboard.unpoint()

    def on_key_latched(self, message: KeyLatched) -> None:
        """The mouse latches a button."""
        message.stop()
        self._jogging.keyboard.keyboard.latch(message.key)
