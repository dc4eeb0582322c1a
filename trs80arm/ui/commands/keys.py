"""The commands of the keyboard: latch mode, and what the terminal tells about keys."""

from __future__ import annotations

from trs80arm.desk.asking import Say
from trs80arm.options import KeyMode
from trs80arm.ui.asking import Screens
from trs80arm.ui.keys.keyboard import Keyboard


class KeyCommands:
    """Says how presses become held keys.

    Args:
        keyboard: the operator's hands.
        chosen: the mode that the settings want.
        say: a way to say something.
        screens: shows the key test.
    """

    def __init__(self, keyboard: Keyboard, chosen: KeyMode, say: Say, screens: Screens) -> None:
        self._keyboard = keyboard
        self._chosen = chosen
        self._say = say
        self._screens = screens

    def latch(self) -> None:
        """Latch mode on, or back to what the terminal can do."""
        keyboard = self._keyboard
        keyboard.let_go()
        latch = keyboard.mode is not KeyMode.LATCH
        usual = self._chosen if self._chosen is not KeyMode.LATCH else KeyMode.AUTO
        keyboard.mode = KeyMode.LATCH if latch else usual
        self._say(
            "Latch: in @SET a press turns a key on, the next one off; Space lets all go."
            if latch
            else f"Keys: {keyboard.in_use.value}."
        )

    def test(self) -> None:
        """What the terminal tells."""
        from trs80arm.ui.screens.key_test import KeyTest

        keyboard = self._keyboard
        self._screens.open(KeyTest(keyboard.in_use, reports=keyboard.reports_releases))
