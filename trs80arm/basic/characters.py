"""The characters that have a meaning in a line of BASIC, as codes."""

from __future__ import annotations

from typing import Final

END: Final = 0
"""Ends a line."""
BLANK: Final = 0x20
EXCLAMATION: Final = 0x21
QUOTE: Final = 0x22
NUMBER_SIGN: Final = 0x23
DOLLAR: Final = 0x24
PERCENT: Final = 0x25
AMPERSAND: Final = 0x26
OPEN: Final = 0x28
CLOSE: Final = 0x29
PLUS: Final = 0x2B
COMMA: Final = 0x2C
MINUS: Final = 0x2D
POINT: Final = 0x2E
ZERO: Final = 0x30
NINE: Final = 0x39
COLON: Final = 0x3A
SEMICOLON: Final = 0x3B
QUESTION: Final = 0x3F
AT: Final = 0x40
FIRST_LETTER: Final = 0x41
LAST_LETTER: Final = 0x5A
CLOSE_BRACKET: Final = 0x5D
"""Taken for a `)` behind subscripts."""

BLANKS: Final = b" \t\n"
"""What the ROM passes on its way to the next character (RST 10H)."""

CAPITAL: Final = 0x5F
"""The bits that a small letter shares with its capital."""

OF_NAMES: Final = frozenset((*range(ZERO, NINE + 1), *range(FIRST_LETTER, LAST_LETTER + 1)))
"""Digits and capital letters, which go on a variable's name."""


def is_digit(code: int) -> bool:
    """Whether a character is a decimal digit."""
    return ZERO <= code <= NINE


def is_letter(code: int) -> bool:
    """Whether a character is a capital letter."""
    return FIRST_LETTER <= code <= LAST_LETTER


def is_small_letter(code: int) -> bool:
    """Whether a character is a small letter."""
    return 0x61 <= code <= 0x7A


LONGEST_STRING: Final = 255
"""Characters of a string: its descriptor has one byte for the length."""
