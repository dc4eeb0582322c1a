"""Cases as they stand in their files, and loading a folder of them."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any


@dataclass(frozen=True)
class TimedKey:
    """Keys held down together from a time on, in seconds after the last key of the entry."""

    at: float
    keys: tuple[str, ...]
    hold: float


@dataclass(frozen=True)
class Entry:
    """What is typed when the machine waits, ENTER as code 13 included."""

    typed: str
    keys: tuple[TimedKey, ...] = ()


@dataclass(frozen=True)
class Dump:
    """A stretch of memory to be looked at in the end."""

    name: str
    address: int
    length: int


@dataclass(frozen=True)
class Case:
    """One session and what the ROM did in it."""

    id: str
    group: str
    ram: int
    memory_size: str
    max_seconds: float
    program: tuple[str, ...]
    script: tuple[Entry, ...]
    dumps: tuple[Dump, ...]
    expected: dict[str, Any]


def entry(item: Any) -> Entry:
    """An entry of a script: a line, `raw` keys, or a line with timed keys."""
    if isinstance(item, str):
        return Entry(item + "\r")
    typed = item["raw"] if "raw" in item else item.get("line", "") + "\r"
    keys = []
    for key in item.get("keys", ()):
        names = key["key"]
        held = (names,) if isinstance(names, str) else tuple(names)
        keys.append(TimedKey(key["at"], held, key.get("hold", 0.1)))
    return Entry(typed, tuple(keys))


def parse(item: dict[str, Any]) -> Case:
    """A case from its JSON object."""
    return Case(
        id=item["id"],
        group=item["group"],
        ram=item.get("ram", 16),
        memory_size=item.get("memsize", ""),
        max_seconds=item.get("max_seconds", 60),
        program=tuple(item.get("program", ())),
        script=tuple(entry(one) for one in item.get("script", ())),
        dumps=tuple(Dump(*dump) for dump in item.get("dump", ())),
        expected=item["expected"],
    )


def load(folder: Path) -> Iterator[Case]:
    """Every case of the folder's `.json` files, file by file.

    Raises:
        OSError: the folder or a file cannot be read.
        ValueError: a file is no list of cases.
    """
    if not folder.is_dir():
        raise NotADirectoryError(f"{folder} is no folder")
    for path in sorted(folder.glob("*.json")):
        try:
            yield from (parse(item) for item in json.loads(path.read_text(encoding="utf-8")))
        except (KeyError, TypeError, json.JSONDecodeError) as error:
            raise ValueError(f"{path} holds no cases: {error!r}") from error
