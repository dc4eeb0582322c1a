"""Making a case that fails as small as it can be, by leaving things out of its JSON."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any


def smallest(case: Any, fails: Callable[[Any], bool], tries: int = 2000) -> Any:
    """The smallest case that was found to fail in the same way.

    Args:
        case: one that fails.
        fails: whether a case fails in that way.
        tries: the most cases that are looked at.
    """
    found = True
    while found and tries > 0:
        found = False
        for smaller in _smaller(case):
            tries -= 1
            if tries <= 0:
                break
            if fails(smaller):
                case, found = smaller, True
                break
    return case


def _smaller(value: Any) -> Iterator[Any]:
    """Values with something left out, the largest pieces first."""
    if isinstance(value, str | list):
        size = len(value)
        piece = size // 2
        while piece:
            for start in range(0, size, piece):
                yield value[:start] + value[start + piece :]
            piece //= 2
    if isinstance(value, list):
        for place, item in enumerate(value):
            for smaller in _smaller(item):
                yield [*value[:place], smaller, *value[place + 1 :]]
    elif isinstance(value, dict):
        for key, item in value.items():
            for smaller in _smaller(item):
                yield value | {key: smaller}
