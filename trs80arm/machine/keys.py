"""The keys of the TRS-80 and their places in the keyboard matrix.

The matrix is the one of Level II facts, section Typing. Front ends and scripts name keys; only the
matrix knows rows and bits.
"""

from __future__ import annotations

from enum import StrEnum
from functools import lru_cache

KEYBOARD_START = 0x3800
KEYBOARD_STOP = 0x3C00
"""The addresses of the matrix: row r is read at the first of them + 2^r."""


class Key(StrEnum):
    """A key, in matrix order; its value is its name, a character or a word like `ENTER`."""

    AT = "@"
    A = "A"
    B = "B"
    C = "C"
    D = "D"
    E = "E"
    F = "F"
    G = "G"
    H = "H"
    I = "I"  # noqa: E741
    J = "J"
    K = "K"
    L = "L"
    M = "M"
    N = "N"
    O = "O"  # noqa: E741
    P = "P"
    Q = "Q"
    R = "R"
    S = "S"
    T = "T"
    U = "U"
    V = "V"
    W = "W"
    X = "X"
    Y = "Y"
    Z = "Z"
    N0 = "0"
    N1 = "1"
    N2 = "2"
    N3 = "3"
    N4 = "4"
    N5 = "5"
    N6 = "6"
    N7 = "7"
    N8 = "8"
    N9 = "9"
    COLON = ":"
    SEMICOLON = ";"
    COMMA = ","
    MINUS = "-"
    POINT = "."
    SLASH = "/"
    ENTER = "ENTER"
    CLEAR = "CLEAR"
    BREAK = "BREAK"
    UP = "UP"
    DOWN = "DOWN"
    LEFT = "LEFT"
    RIGHT = "RIGHT"
    SPACE = "SPACE"
    SHIFT = "SHIFT"


MATRIX: dict[Key, tuple[int, int]] = {
    key: (7, 0) if key is Key.SHIFT else divmod(place if place < 27 else place + 5, 8)
    for place, key in enumerate(Key)
}
"""Row 0 to 7 and bit 0 to 7 of every key. Row 3 holds only X, Y and Z, row 7 only SHIFT."""


_SHIFTED = dict(zip("!\"#$%&'()*=+<>?", "123456789:-;,./", strict=True))
_NAMED = {
    "\r": Key.ENTER,
    "\n": Key.ENTER,
    " ": Key.SPACE,
    "[": Key.UP,
    "^": Key.UP,
    "\x01": Key.BREAK,
    "\x08": Key.LEFT,
    "\x09": Key.RIGHT,
    "\x1f": Key.CLEAR,
}
_NAMED_SHIFTED = {
    "\x18": Key.LEFT,
    "\x19": Key.RIGHT,
    "\x1a": Key.DOWN,
    "\x1b": Key.UP,
    "`": Key.AT,
}


@lru_cache(512)
def keys_for(character: str) -> tuple[Key, ...] | None:
    """The keys that type one character by its meaning on the TRS-80, SHIFT first.

    Letters type capitals without SHIFT, as on the machine; small letters of the host are the same
    keys, so that a listing in lower case comes in as a person would type it. None where no key has
    the character.
    """
    if character in _NAMED:
        return (_NAMED[character],)
    if character in _NAMED_SHIFTED:
        return (Key.SHIFT, _NAMED_SHIFTED[character])
    if character in _SHIFTED:
        return (Key.SHIFT, Key(_SHIFTED[character]))
    upper = character.upper()
    if len(upper) == 1 and upper in Key._value2member_map_:
        return (Key(upper),)
    return None


# fmt: off
ROWS_OF_KEYS: tuple[tuple[Key, ...], ...] = (
    (Key.N1, Key.N2, Key.N3, Key.N4, Key.N5, Key.N6, Key.N7, Key.N8, Key.N9, Key.N0, Key.COLON,
     Key.MINUS, Key.BREAK),
    (Key.UP, Key.Q, Key.W, Key.E, Key.R, Key.T, Key.Y, Key.U, Key.I, Key.O, Key.P, Key.AT,
     Key.LEFT, Key.RIGHT),
    (Key.DOWN, Key.A, Key.S, Key.D, Key.F, Key.G, Key.H, Key.J, Key.K, Key.L, Key.SEMICOLON,
     Key.ENTER, Key.CLEAR),
    (Key.SHIFT, Key.Z, Key.X, Key.C, Key.V, Key.B, Key.N, Key.M, Key.COMMA, Key.POINT, Key.SLASH,
     Key.SHIFT),
    (Key.SPACE,),
)
"""The keys as they lie on a Model I, row by row."""
# fmt: on
ARROWS = {Key.UP: "↑", Key.DOWN: "↓", Key.LEFT: "←", Key.RIGHT: "→"}
"""What stands on the keys with arrows."""
PLAIN_ARROWS = {Key.UP: "^", Key.DOWN: "v", Key.LEFT: "<-", Key.RIGHT: "->"}
"""The same in plain characters."""
INDENTS = (2, 0, 1, 0, 12)
"""By how much each row begins to the right of the leftmost, quarters of a key."""
