"""Errors that a statement raises, and the checks of values that raise them."""

from __future__ import annotations

from typing import NoReturn

from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.numbers import convert


def fail(code: int) -> NoReturn:
    """Raise a Level II error."""
    raise BasicError(Code(code))


def byte(value: int) -> int:
    """An integer that must be 0..255; FC."""
    if not 0 <= value < 256:
        raise BasicError(Code.FC)
    return value


def from_one(value: int) -> int:
    """A place in a string, from 1 on; FC."""
    if not value:
        raise BasicError(Code.FC)
    return value


def below(value: int, limit: int) -> int:
    """A coordinate that must be below a limit; FC."""
    if value >= limit:
        raise BasicError(Code.FC)
    return value


def subscript(value: object) -> int:
    """A number rounded down to 0..32767 (1E45H); OV, FC."""
    number = convert.to_integer(value)
    if number < 0:
        raise BasicError(Code.FC)
    return number


def bad(value: object, dim: int) -> int:
    """A subscript that is outside its dimension, or not an integer yet; OV, FC, BS."""
    number = subscript(value)
    if number >= dim:
        raise BasicError(Code.BS)
    return number


def always(_left: object, _right: object) -> bool:
    """The relation `<=>`."""
    return True
