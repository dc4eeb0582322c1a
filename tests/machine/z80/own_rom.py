"""A ROM of our own for tests: it says HI, then shows each key that is typed.

It has what the machine looks at at the addresses where a Level II ROM has it: the display at 0033H,
the scan of the keyboard at 002BH, and the loop that waits for a key at 0049H.
"""

from __future__ import annotations

from trs80arm.machine.z80.rom import SIZE, Rom

_PIECES = {
    0x0000: "F3 31 00 42 21 00 3C 22 20 40 C3 00 01",  # DI; SP; cursor at 3C00H; JP 0100H
    0x002B: "C3 00 02",  # JP scan
    0x0033: "C3 00 03",  # JP show
    0x0049: "CD 2B 00 B7 C0 18 F9",  # CALL scan; OR A; RET NZ; round again
    0x0066: "C3 00 01",  # the reset button
    # HI, then for ever: wait for a key, show it, OUT (98H),A
    0x0100: "3E 48 CD 33 00 3E 49 CD 33 00 CD 49 00 CD 33 00 D3 98 18 F6",
    # Row 0 of the matrix (@ to G): a key that is newly down, A its code, else 0.
    0x0200: (
        "3A 01 38 21 36 40 47 AE A0 70 C8"  # what was not down the last time
        " 0E 40 CB 3F 28 03 0C 18 F9 79 C9"  # which bit: its code
    ),
    0x0300: "E5 2A 20 40 77 23 22 20 40 E1 C9",
}


def own_rom() -> Rom:
    """The ROM."""
    content = bytearray(SIZE)
    for address, piece in _PIECES.items():
        code = bytes.fromhex(piece)
        content[address : address + len(code)] = code
    return Rom.of(bytes(content))
