"""Where the ROM keeps BASIC's variables in low RAM: the addresses that more than one module needs.

Two bytes are a word, low byte first. Most of these are plain RAM; those that the interpreter keeps
as Python values are answered for by `system_area` (the period's memory maps).
"""

from __future__ import annotations

from typing import Final

BREAK_VECTOR: Final = 0x400C
"""Holds C9H; any other code there disables BREAK (POKE 16396,23)."""
BREAK_ON: Final = 0xC9
USR_VECTOR: Final = 0x408E
KEY_LATCH: Final = 0x4099
"""The last key that the statement loop saw, for INKEY$."""
ERROR_CODE: Final = 0x409A
PRINTER_COLUMN: Final = 0x409B
OUTPUT_DEVICE: Final = 0x409C
"""Where PRINT goes: 0 the screen, 1 the printer."""
PROGRAM_START: Final = 0x40A4
"""A word: the link of the first line."""
LINE_POINTER: Final = 0x40A7
"""A word: where a line is kept while it is typed (41E8H)."""
PROGRAM_END: Final = 0x40F9
"""A word: the first address behind the program, where the variables begin."""
TYPE_TABLE: Final = 0x4101
"""Twenty-six bytes, the type of names without a suffix by their first letter (DEFINT and so on)."""
LETTERS: Final = 26
TRACE_FLAG: Final = 0x411B
INPUT_BUFFER: Final = 0x41E5
"""The byte in front of the line buffer; a direct line is executed here."""
PROGRAM: Final = 0x42E9
"""Where the text of the first line's link stands on a machine without disk."""


def word(ram: bytearray, address: int) -> int:
    """The word at an address."""
    return ram[address] | ram[address + 1] << 8


def set_word(ram: bytearray, address: int, value: int) -> None:
    """Store a word."""
    ram[address] = value & 0xFF
    ram[address + 1] = value >> 8
