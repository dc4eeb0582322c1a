"""Reads the lines that were recorded from the ROM (see recorded/README.md)."""

from __future__ import annotations

from pathlib import Path

from trs80arm.basic.numbers import convert, double, literal
from trs80arm.basic.numbers.convert import Number
from trs80arm.basic.numbers.double import Double


def recorded(name: str) -> list[str]:
    """The lines of one file, without the case ids at their ends."""
    text = (Path(__file__).parent / "recorded" / f"{name}.txt").read_text(encoding="ascii")
    return [line.split("   ")[0] if name != "using" else line for line in text.splitlines()]


def number(text: str) -> Number:
    """The number that a typed literal or a quotient of two gives on the machine."""
    if "/" in text:
        dividend, divisor = text.split("/")
        return convert.div(number(dividend), number(divisor))
    return literal.scan(text.encode()).value


def read_double(text: str) -> Double:
    """The number that READ puts into a double precision variable."""
    return convert.to_double(literal.scan(text.encode(), 0, double.ZERO).value)
