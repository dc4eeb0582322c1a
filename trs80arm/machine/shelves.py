"""Where cassettes are kept: in memory, or as files in one folder.

A cassette's name is its file's without `.cas`; those of another kind keep their suffix in the name,
as `SIDE1.wav`. A program can reach no other file: it never names one.
"""

from __future__ import annotations

import os
import re
import stat
from collections.abc import Mapping
from pathlib import Path
from typing import Protocol

from trs80arm.machine import tape_files
from trs80arm.machine.cassette import FileFormatError
from trs80arm.saving import write_whole

SUFFIX = tape_files.CAS
_NAME = re.compile(r"""[^./\\:*?"<>|~\x00-\x1f\x7f][^/\\:*?"<>|\x00-\x1f\x7f]{0,99}(?<![ ~])""")
_RESERVED = re.compile(r"(?i)(con|prn|aux|nul|com\d|lpt\d)(\..*)?")
_HEAD = 4096
"""Bytes of a file that say what kind of sound it is."""
_MOST_KEPT = 8
"""Sounds whose content is remembered, so that nothing is listened to twice."""


def is_cassette_name(name: str) -> bool:
    """Whether a cassette can be called that, in any folder of any computer."""
    return bool(_NAME.fullmatch(name)) and not _RESERVED.fullmatch(name)


def file_name(cassette: str) -> str:
    """The name of a cassette's file."""
    return cassette if _suffix(cassette) in tape_files.SUFFIXES[1:] else cassette + SUFFIX


def _suffix(name: str) -> str:
    dot = name.rfind(".")
    return name[dot:].lower() if dot >= 0 else ""


class Shelf(Protocol):
    """Where cassettes are kept."""

    def names(self) -> list[str]:
        """The cassettes there are, in order."""

    def load(self, name: str) -> bytes:
        """What is on a cassette; nothing on a new one."""

    def store(self, name: str, content: bytes) -> None:
        """Keep what is on a cassette now, whole; OSError if that cannot be done."""

    def set_aside(self, name: str) -> None:
        """Keep a copy of a cassette that is about to be recorded over."""

    def remark(self, name: str) -> str | None:
        """What is to be said of a cassette that was loaded: what of its sound was not heard."""

    def sound_length(self, name: str) -> float | None:
        """How long the sound of a cassette is, in seconds; None if it is no sound."""

    @property
    def in_memory(self) -> dict[str, bytes]:
        """What is on the cassettes that are in no file."""


class MemoryShelf:
    """Cassettes that are gone when the program ends."""

    def __init__(self) -> None:
        self._contents: dict[str, bytes] = {}

    def names(self) -> list[str]:
        """The cassettes there are, in order."""
        return sorted(self._contents)

    def load(self, name: str) -> bytes:
        """What is on a cassette; nothing on a new one."""
        return self._contents.get(name, b"")

    def store(self, name: str, content: bytes) -> None:
        """Keep what is on a cassette now."""
        self._contents[name] = content

    def set_aside(self, name: str) -> None:
        """Keep no copy: nothing here outlives the program anyway."""

    def remark(self, name: str) -> str | None:
        """Nothing: there is no sound."""

    def sound_length(self, name: str) -> float | None:
        """No sound."""

    @property
    def in_memory(self) -> dict[str, bytes]:
        """What is on the cassettes: all of them."""
        return dict(self._contents)


class FolderShelf:
    """Cassettes that are files in a folder: `.cas`, `.500` and `.wav`."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._heard: dict[str, tuple[tuple[int, int], bytes, str | None]] = {}

    def names(self) -> list[str]:
        """The cassettes there are, in order; files outside reached by a link are not."""
        try:
            found = sorted(self._folder.iterdir())
        except OSError:
            return []
        folder = os.path.realpath(self._folder)
        names = []
        for path in found:
            if (suffix := _suffix(path.name)) not in tape_files.SUFFIXES:
                continue
            name = path.name[: -len(SUFFIX)] if suffix == SUFFIX else path.name
            if is_cassette_name(name) and _is_inside(path, folder):
                names.append(name)
        return list(dict.fromkeys(names))

    def load(self, name: str) -> bytes:
        """What is on a cassette; nothing on a new one."""
        path = self._path(name)
        if not path.exists():
            return b""
        with path.open("rb") as file:
            head = file.read(_HEAD)
            sound = tape_files.is_sound(head)
            state = _state(file.fileno())
            known = self._heard.get(name)
            if sound and known is not None and known[0] == state:
                return known[1]
            longest = tape_files.LONGEST_SOUND if sound else tape_files.LONGEST
            data = head + file.read(longest + 1 - len(head))
        if len(data) > longest:
            raise OSError(f"{path} is longer than any cassette")
        if not sound and _suffix(path.name) != tape_files.SOUND:
            return tape_files.tidy(data)
        try:
            found = tape_files.read(data)
        except FileFormatError as error:
            raise OSError(f"{path.name}: {error}") from None
        remark = f"{path.name}: {found.remarks[0]}" if found.remarks else None
        self._remember(name, state, found.content, remark)
        return found.content

    def _remember(
        self, name: str, state: tuple[int, int], content: bytes, remark: str | None
    ) -> None:
        self._heard.pop(name, None)
        self._heard[name] = (state, content, remark)
        if len(self._heard) > _MOST_KEPT:
            del self._heard[next(iter(self._heard))]

    def store(self, name: str, content: bytes) -> None:
        """Write the file whole, or leave it as it was and raise OSError."""
        self._folder.mkdir(parents=True, exist_ok=True)
        path = self._path(name)
        suffix = _suffix(path.name)
        if suffix != tape_files.SOUND:
            write_whole(path, content)
            return
        before = path.read_bytes() if path.exists() else b""
        try:
            made = tape_files.write(content, suffix, before)
        except FileFormatError as error:
            raise OSError(f"{path.name}: {error}") from None
        write_whole(path, made)
        # What was recorded just now need not be listened to.
        with path.open("rb") as file:
            self._remember(name, _state(file.fileno()), content, None)

    def set_aside(self, name: str) -> None:
        """Copy the file to the same name with a `~` behind."""
        path = self._path(name)
        if path.exists():
            write_whole(path.with_name(path.name + "~"), path.read_bytes())

    def remark(self, name: str) -> str | None:
        """What of its sound was not heard, or is in doubt."""
        known = self._heard.get(name)
        return None if known is None else known[2]

    def sound_length(self, name: str) -> float | None:
        """How long the sound of a cassette is; it is not listened to."""
        path = self._path(name)
        if _suffix(path.name) != tape_files.SOUND:
            return None
        try:
            with path.open("rb") as file:
                return tape_files.sound_length(file.read(_HEAD), os.fstat(file.fileno()).st_size)
        except FileFormatError as error:
            raise OSError(f"{path.name}: {error}") from None

    @property
    def in_memory(self) -> dict[str, bytes]:
        """None: all are files."""
        return {}

    def _path(self, name: str) -> Path:
        path = self._folder / file_name(name)
        capital = path.with_suffix(path.suffix.upper())
        if not path.exists() and capital.exists():
            path = capital
        if not _is_inside(path, os.path.realpath(self._folder)):
            raise OSError(f"{path} is no file, or a link that leads out of the tape folder")
        return path


def _state(descriptor: int) -> tuple[int, int]:
    """What changes with a file's content: when it was written last, and its size."""
    found = os.fstat(descriptor)
    return found.st_mtime_ns, found.st_size


def _is_inside(path: Path, folder: str) -> bool:
    """Whether it is a file of a real folder, or could become one; nothing that would block."""
    try:
        if not stat.S_ISREG(os.stat(path).st_mode):
            return False
    except FileNotFoundError:
        pass
    except OSError:
        return False  # A loop of links.
    return os.path.dirname(os.path.realpath(path)) == folder


class PastShelf:
    """The cassettes of a folder as they were once; what is recorded here stays in memory.

    Args:
        folder: the cassettes as they are now.
        contents: what was on those that have been recorded on since; nothing: there was none.
    """

    def __init__(self, folder: Path, contents: Mapping[str, bytes]) -> None:
        self._now = FolderShelf(folder)
        self._contents = dict(contents)

    def names(self) -> list[str]:
        """The cassettes there were, in order."""
        there = {name for name, content in self._contents.items() if content}
        return sorted(set(self._now.names()) - self._contents.keys() | there)

    def load(self, name: str) -> bytes:
        """What was on a cassette; nothing on a new one."""
        found = self._contents.get(name)
        return self._now.load(name) if found is None else found

    def store(self, name: str, content: bytes) -> None:
        """Keep what is on a cassette now; the file stays as it is."""
        self._contents[name] = content

    def set_aside(self, name: str) -> None:
        """Keep no copy: no file is recorded over."""

    def remark(self, name: str) -> str | None:
        """What of its sound was not heard, or is in doubt."""
        return None if name in self._contents else self._now.remark(name)

    def sound_length(self, name: str) -> float | None:
        """How long the sound of a cassette is, if nothing was recorded on it since."""
        return None if name in self._contents else self._now.sound_length(name)

    @property
    def in_memory(self) -> dict[str, bytes]:
        """None: all are, or will be, files."""
        return {}
