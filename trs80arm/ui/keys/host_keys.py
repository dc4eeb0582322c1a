"""From the keys of today's keyboard to those of the TRS-80, by meaning.

Letters, figures and signs are the keys that type them on the TRS-80; keys that it lacks stand for
the ones that did their work: Escape is BREAK, Backspace the left arrow, Home CLEAR.
"""

from __future__ import annotations

from trs80arm.machine.keys import Key, keys_for

NAMED: dict[str, tuple[Key, ...]] = {
    "enter": (Key.ENTER,),
    "shift+enter": (Key.ENTER,),
    "ctrl+j": (Key.ENTER,),
    "space": (Key.SPACE,),
    "shift+space": (Key.SPACE,),
    "backspace": (Key.LEFT,),
    "ctrl+h": (Key.LEFT,),
    "delete": (Key.LEFT,),
    "left": (Key.LEFT,),
    "right": (Key.RIGHT,),
    "tab": (Key.RIGHT,),
    "up": (Key.UP,),
    "down": (Key.DOWN,),
    "escape": (Key.BREAK,),
    "home": (Key.CLEAR,),
    "ctrl+l": (Key.CLEAR,),
    "shift+backspace": (Key.SHIFT, Key.LEFT),
    "shift+left": (Key.SHIFT, Key.LEFT),
    "shift+right": (Key.SHIFT, Key.RIGHT),
    "shift+tab": (Key.SHIFT, Key.RIGHT),
    "shift+up": (Key.SHIFT, Key.UP),
    "shift+down": (Key.SHIFT, Key.DOWN),
    "pause": (Key.SHIFT, Key.AT),
    "ctrl+@": (Key.SHIFT, Key.AT),
}
"""Keys that type no sign, by Textual's name. SHIFT and @ together hold a program or a listing."""

TABLE: tuple[tuple[str, str], ...] = (
    ("Enter", "ENTER"),
    ("Escape", "BREAK: stops the program"),
    ("Backspace, Left", "left arrow: rubs out a character"),
    ("Shift+Backspace", "SHIFT and left arrow: rubs out the line"),
    ("Tab, Right", "right arrow: to the next stop of 8"),
    ("Home, Ctrl+L", "CLEAR: clears the screen"),
    ("Up, ^, [", "up arrow: the sign of exponents"),
    ("Shift+Up", "ends an insertion in EDIT"),
    ("Down", "down arrow: a line feed"),
    ("Pause, `", "SHIFT and @: holds a program or a listing"),
    ("Shift+Right", "32 wide characters a line; CLEAR goes back"),
)
"""The same for the help page: the key, what it is on the TRS-80."""


def trs80_keys(name: str, text: str | None) -> tuple[Key, ...] | None:
    """The keys of the TRS-80 that a key stands for, SHIFT first; None if it stands for none.

    Args:
        name: Textual's name of the key, with its modifiers.
        text: the character it types, if any.
    """
    if name in NAMED:
        return NAMED[name]
    if text is None and len(name) == 1:
        # A figure of the keypad, which some terminals name but do not spell.
        text = name
    modifiers = name.split("+")[:-1]
    if text is None or not text.isprintable() or {"ctrl", "alt", "super", "meta"} & set(modifiers):
        return None
    return keys_for(text)
