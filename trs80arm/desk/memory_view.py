"""Memory as people look at it: rows of eight bytes in hex and as characters; addresses as typed."""

from __future__ import annotations

from collections.abc import Callable

ROW = 8
"""Bytes in a row."""
TOP = 0x10000


def row_text(peek: Callable[[int], int], address: int) -> str:
    """Eight bytes from an address on, as PEEK would see them.

    Args:
        peek: gives the byte at an address.
        address: of the first byte; behind 65535 comes 0.
    """
    codes = [peek((address + place) % TOP) for place in range(ROW)]
    hexadecimal = " ".join(f"{code:02X}" for code in codes)
    characters = "".join(chr(code) if 32 <= code < 127 else "." for code in codes)
    return f"{address % TOP:04X}  {hexadecimal}  {characters}"


def parse_address(text: str) -> int:
    """An address: `15360`, `-16384` as BASIC has it, or in hex `3C00H`, `&H3C00`, `0x3C00`.

    Raises:
        ValueError: it is none; one line that says so.
    """
    word = text.strip().upper()
    try:
        if word.startswith(("&H", "0X")):
            address = int(word[2:], 16)
        elif word.endswith("H"):
            address = int(word[:-1], 16)
        else:
            address = int(word)
    except ValueError:
        raise ValueError(f"{text.strip()} is no address; as 15360 or 3C00H") from None
    if not -0x8000 <= address < TOP:
        raise ValueError("addresses go from 0 to 65535")
    return address % TOP


def poke_statement(text: str) -> str:
    """The POKE for `ADDRESS,VALUE`, both as typed.

    Raises:
        ValueError: it is no such pair; one line that says so.
    """
    address, _, value = text.partition(",")
    if not value.strip():
        raise ValueError("type an address and a value, as 3C00H,65")
    place, byte = parse_address(address), parse_address(value)
    return f"POKE {place - TOP if place >= 0x8000 else place},{byte}"
