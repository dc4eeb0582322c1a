"""The console of the machine: the ROM's display and keyboard drivers under one handle.

The language talks to it, and to nothing else of tube and keys; the conformance runner and the
front end's log listen to what is printed.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from trs80arm.machine.display import Display
from trs80arm.machine.keyboard import KeyboardDriver

Listener = Callable[[int, bool], None]
"""Called with each code printed and whether it is an echo of the user's own typing."""

_CURSOR_ON, _CURSOR_OFF = 14, 15


class Console:
    """Display and keyboard as the language sees them.

    Attributes:
        listeners: told every code; they are not part of a snapshot.
    """

    def __init__(self, display: Display, keyboard: KeyboardDriver) -> None:
        self.display = display
        self.keyboard = keyboard
        self.listeners: list[Listener] = []

    def put(self, code: int) -> None:
        """Print one character or control code at the cursor, and charge its time."""
        self.display.put(code)
        for listener in self.listeners:
            listener(code, False)

    def echo(self, code: int) -> None:
        """The same, for what the line editor and EDIT echo of the user's own typing."""
        self.display.echo(code)
        for listener in self.listeners:
            listener(code, True)

    def scan(self) -> int:
        """Look at the keyboard once: the code of one key newly down, or 0."""
        return self.keyboard.scan()

    @property
    def quiet(self) -> bool:
        """Whether `scan` would return 0 and change nothing until the next key event."""
        return self.keyboard.quiet

    @property
    def cursor(self) -> int:
        """The text cursor, 0 to 1023; setting it moves PRINT's column along."""
        return self.display.cursor

    @cursor.setter
    def cursor(self, position: int) -> None:
        self.display.cursor = position

    @property
    def cursor_shown(self) -> int | None:
        """The cell, 0 to 1023, where the cursor's `_` stands; None while it is off."""
        return self.display.cursor if self.display.cursor_on else None

    @property
    def column(self) -> int:
        """The cursor's column as PRINT, TAB and POS count it, 0 to 63."""
        return self.display.column

    def show_cursor(self, on: bool) -> None:
        """Switch the `_` at the cursor on or off; listeners are not told."""
        self.display.echo(_CURSOR_ON if on else _CURSOR_OFF)

    @property
    def wide(self) -> bool:
        """Whether the display is in 32-column mode."""
        return self.display.wide

    def point(self, x: int, y: int) -> bool:
        """Whether the graphics block x 0..127, y 0..47 is lit."""
        return self.display.point(x, y)

    def plot(self, x: int, y: int, lit: bool) -> None:
        """Light or clear a graphics block."""
        self.display.plot(x, y, lit)

    def __getstate__(self) -> dict[str, Any]:
        return self.__dict__ | {"listeners": []}
