"""Assembles the ARMBASIC driver: its tapes in programs/ and the listing in docs/armbasic-z80.md.

    python docs/make_armbasic_z80.py

The source is trs80arm/machine/z80/armbasic.asm; the assembler is pyz80, of the extra `test`. What
stands above the mark in the page is written by hand; below it every line comes from here.
"""

from __future__ import annotations

import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from pathlib import Path

from trs80arm.machine.cassette import SystemRecording, encode_system
from trs80arm.works.rom_driver import ORIGINS

ROOT = Path(__file__).parents[1]
SOURCE = ROOT / "trs80arm" / "machine" / "z80" / "armbasic.asm"
PAGE = ROOT / "docs" / "armbasic-z80.md"
MARK = "<!-- from here on written by docs/make_armbasic_z80.py -->\n"
BLOCK = 128
"""Bytes of a block on the tape."""
_LISTED = re.compile(r"([0-9A-F]{4})? +((?:[0-9A-F]{2} )*) *\t(.*)")
"""A line of pyz80's listing: address, code, source."""
_ROW = 4
"""Bytes of code that one line of the listing shows."""


@dataclass(frozen=True)
class Assembly:
    """The driver for one place in memory."""

    origin: int
    image: bytes
    symbols: dict[str, int]
    """Addresses by label."""
    listing: str
    """As the assembler writes it."""


@cache
def assemble(origin: int) -> Assembly:
    """Assemble the source for an address."""
    with tempfile.TemporaryDirectory() as folder:
        image, labels, listing = (Path(folder) / name for name in ("image", "labels", "listing"))
        subprocess.run(
            [
                *(sys.executable, "-m", "pyz80.pyz80", "-D", f"ORIGIN={origin}"),
                *(f"--obj={image}", f"--mapfile={labels}", f"--lstfile={listing}", str(SOURCE)),
            ],
            check=True,
            capture_output=True,
        )
        lines = (line.split("=") for line in labels.read_text().split())
        symbols = {name: int(address, 16) for address, name in lines}
        return Assembly(origin, image.read_bytes(), symbols, listing.read_text())


def tape_name(kilobytes: int) -> bytes:
    """What SYSTEM calls the tape of a size."""
    return b"ARM%d" % kilobytes


def tape_file(kilobytes: int) -> Path:
    """Where the tape of a size is kept."""
    return ROOT / "programs" / f"armbasic-{kilobytes}k.cas"


def tape(kilobytes: int) -> bytes:
    """The cassette for a machine with so much RAM, for SYSTEM."""
    done = assemble(ORIGINS[kilobytes])
    blocks = tuple(
        (done.origin + at, done.image[at : at + BLOCK]) for at in range(0, len(done.image), BLOCK)
    )
    return encode_system(SystemRecording(tape_name(kilobytes), blocks, done.symbols["START"]))


def listing(kilobytes: int) -> Iterator[str]:
    """The listing for a size, line by line: address, code, source.

    Of what the assembler repeats for the six motors the first is shown.
    """
    done = assemble(ORIGINS[kilobytes])
    repeats = 0
    expanded: list[str] = []
    lines = list(_lines(done))
    begins = sorted({begin for begin, has_code, _ in lines if has_code})
    ends = dict(pairwise((*begins, done.origin + len(done.image))))
    for address, has_code, source in lines:
        if source.split()[:2] == ["NEXT", "M"]:
            repeats += 1
            if repeats % 6 == 1:
                yield f"{'':17} {source}"
        elif repeats % 6 == 0:
            here = (
                list(_rows(done, address, ends[address], source))
                if has_code
                else [f"{'':17} {source}".rstrip()]
            )
            if source.startswith(" " * 16):
                # The assembler lists what a macro stands for in front of the macro's own line.
                expanded += here
            else:
                yield from (*here, *expanded)
                expanded = []


def _lines(done: Assembly) -> Iterator[tuple[int, bool, str]]:
    """What the assembler lists: the address of a line, whether it has code, its source."""
    for line in done.listing.splitlines():
        match = _LISTED.fullmatch(line)
        if match:
            yield int(match[1] or "0", 16), bool(match[2]), match[3].expandtabs(8)


def _rows(done: Assembly, address: int, ends: int, source: str) -> Iterator[str]:
    """The listing of a line with code, up to an address: more than one row if it is long."""
    for at in range(address, ends, _ROW):
        code = done.image[at - done.origin : min(at + _ROW, ends) - done.origin].hex(" ").upper()
        yield f"{at:04X} {code:12} {source if at == address else ''}".rstrip()


def page() -> str:
    """The page as it should be."""
    by_hand = PAGE.read_text(encoding="utf-8").partition(MARK)[0]
    return f"{by_hand}{MARK}\n```\n" + "\n".join(listing(16)) + "\n```\n"


if __name__ == "__main__":
    for size in ORIGINS:
        tape_file(size).write_bytes(tape(size))
    PAGE.write_text(page(), encoding="utf-8")
