"""A user's own ROM: 12 KiB read from a file, known by their checksum. None is part of this project.

The versions of the Level II ROM and their CRC-32 are those that owners have published
(trs-80.com, "ROM Checksums for TRS-80 Model I").
"""

from __future__ import annotations

import zlib
from dataclasses import dataclass
from pathlib import Path
from typing import Final

SIZE: Final = 12_288
VERSIONS: Final = {
    "d8e9dfa7": "Level II 1.0 of May 1978",
    "2de3afec": "Level II 1.1 of June 1978",
    "4be1227e": "Level II 1.1 of October 1978",
    "0d8a132e": "Level II 1.2 of March 1979",
    "a8e60d9a": "Level II 1.3 of January 1980",
}
"""The ROMs of the Model I by their CRC-32 in hex."""


class RomError(ValueError):
    """No ROM of a Model I, or not the one that is wanted; one clear line."""


@dataclass(frozen=True)
class Rom:
    """A ROM, named by its checksum; snapshots and recordings hold that and nothing else of it.

    Attributes:
        crc: the CRC-32 of its 12,288 bytes, eight hex digits.
    """

    crc: str = ""

    def __post_init__(self) -> None:
        object.__setattr__(self, "_content", b"")

    @classmethod
    def of(cls, content: bytes) -> Rom:
        """The ROM of these bytes.

        Raises:
            RomError: they are too few or too many.
        """
        if len(content) != SIZE:
            raise RomError(f"a ROM of the Model I has {SIZE} bytes, not {len(content)}")
        rom = cls(f"{zlib.crc32(content):08x}")
        object.__setattr__(rom, "_content", content)
        return rom

    @classmethod
    def read(cls, path: Path) -> Rom:
        """The ROM in a file.

        Raises:
            RomError: it holds none.
            OSError: it cannot be read.
        """
        with path.open("rb") as file:
            content = file.read(SIZE + 1)
        if len(content) > SIZE:
            raise RomError(f"{path}: a ROM of the Model I has {SIZE} bytes, and this file has more")
        try:
            return cls.of(content)
        except RomError as error:
            raise RomError(f"{path}: {error}") from None

    @property
    def content(self) -> bytes:
        """Its bytes.

        Raises:
            RomError: only its checksum is known here.
        """
        content: bytes = self.__dict__["_content"]
        if not content:
            raise RomError(f"this needs the ROM with the checksum {self.crc}, {self.name}")
        return content

    @property
    def name(self) -> str:
        """What ROM it is."""
        return VERSIONS.get(self.crc, "an unknown one")

    @property
    def told(self) -> str:
        """Name and checksum, as the program tells them when it starts."""
        return f"ROM: {self.name}, CRC-32 {self.crc.upper()}"


class RomArea:
    """The addresses of the ROM, as PEEK and debuggers see them."""

    def __init__(self, rom: Rom) -> None:
        self._rom = rom

    def peek(self, address: int) -> int:
        """The byte at an address."""
        return self._rom.content[address]

    def poke(self, address: int, value: int) -> None:
        """Stored nowhere."""
