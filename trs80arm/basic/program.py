"""The program in memory: crunched lines from 42E9H, each with a link, a number, text and a zero.

Everything that is known of the program is read from the machine's memory, so PEEK, POKE, the
compiler and LIST see the same bytes. The dialogue stores and deletes lines here; the compiler asks
for addresses.
"""

from __future__ import annotations

import bisect
from collections.abc import Iterable
from typing import NamedTuple

from trs80arm.basic import addresses
from trs80arm.basic.addresses import set_word, word
from trs80arm.basic.characters import COLON, QUOTE
from trs80arm.basic.host import Memory

_RAM_START = 0x4000
LAST_ADDRESS = 0xFFFF
_LAST = 0xFFF0
"""No program reaches so far up; the search through a broken one stops here."""
_REMEMBERED = 100
"""Changes that are known; whoever knows an older text knows none of it any more."""
LINE_HEAD = 4
"""A line's link and number."""


class Change(NamedTuple):
    """A change of the text.

    Attributes:
        first: below this address it is what it was.
        behind: from this address on it is that too, but for the links.
        by: so many bytes further up; where it is 0 no line has come, gone or moved, unless all
            from `first` on is another text.
    """

    first: int
    behind: int = LAST_ADDRESS + 1
    by: int = 0


EVERYTHING = Change(0)
"""Another text."""


class Program:
    """The lines in memory.

    Attributes:
        version: grows with every change of the text; whoever compiled it compares.
    """

    def __init__(self, memory: Memory) -> None:
        self._memory = memory
        self.version = 0
        self._changes: list[Change] = []
        """The last one last."""
        self._index: tuple[list[int], list[int]] | None = None
        self._lines: tuple[tuple[int, bytes], ...] | None = None

    def __getstate__(self) -> dict[str, object]:
        return {**self.__dict__, "_index": None, "_lines": None, "_changes": []}

    @property
    def start(self) -> int:
        """Where the first line's link is (the pointer at 40A4H, if it points into RAM)."""
        ram = self._memory.ram
        # Asked for by every assignment of a string, so without a call.
        start = ram[addresses.PROGRAM_START] | ram[addresses.PROGRAM_START + 1] << 8
        return start if _RAM_START < start < self._memory.top - 2 else addresses.PROGRAM

    @property
    def end(self) -> int:
        """The first address behind the two zeros that end the program (the pointer at 40F9H).

        A pointer that was POKEd to where no program can end counts as one that ends at once.
        """
        ram = self._memory.ram
        end = word(ram, addresses.PROGRAM_END)
        first = self.start + 2
        return end if first <= end < self._memory.top else min(first, self._memory.top)

    @end.setter
    def end(self, address: int) -> None:
        set_word(self._memory.ram, addresses.PROGRAM_END, address)

    def changed(self, change: Change = EVERYTHING) -> None:
        """The text was changed, by POKE or by a tape, or in here."""
        self.version += 1
        self._changes.append(change)
        del self._changes[:-_REMEMBERED]
        self._index = self._lines = None

    def poked(self, address: int, before: int) -> None:
        """A byte of the text was POKEd, which was another one before."""
        index = self._walk()
        line = self.line_at(address)
        zero = not (before and self._memory.ram[address])
        if line is None or address < line + LINE_HEAD or zero:
            self.changed()
            return
        self.changed(Change(address, address + 1))
        # The lines are where they were.
        self._index = index

    def changes_since(self, version: int) -> list[Change]:
        """What has become of the text of an earlier version, change by change."""
        count = self.version - version
        return self._changes[-count:] if 0 < count <= len(self._changes) else [EVERYTHING]

    def _walk(self) -> tuple[list[int], list[int]]:
        """Addresses of the lines' links and their numbers, in the order of the links."""
        if self._index is None:
            ram = self._memory.ram
            places: list[int] = []
            numbers: list[int] = []
            address = self.start
            while _RAM_START <= address < self._memory.top - 4:
                link = word(ram, address)
                if not link:
                    break
                places.append(address)
                numbers.append(word(ram, address + 2))
                if link <= address:
                    break
                address = link
            self._index = places, numbers
        return self._index

    def __len__(self) -> int:
        return len(self._walk()[0])

    def numbers(self) -> list[int]:
        """The line numbers in the order of the lines."""
        return list(self._walk()[1])

    def find(self, number: int) -> int | None:
        """The address of the link of a line, None if there is no such line.

        The ROM walks the links and stops at the first number that is not smaller.
        """
        places, numbers = self._walk()
        place = self.place(number)
        if place < len(numbers) and numbers[place] == number:
            return places[place]
        return None

    def place(self, number: int) -> int:
        """How many lines the ROM passes before it stops at a number: the first not smaller."""
        numbers = self._walk()[1]
        return bisect.bisect_left(numbers, number)

    def address_from(self, number: int) -> int | None:
        """The address of the link of the first line not before `number`, if there is one."""
        places, _ = self._walk()
        place = self.place(number)
        return places[place] if place < len(places) else None

    def place_for(self, number: int) -> int:
        """Where a line of that number stands or would: `address_from`, or the final two zeros."""
        return self.address_from(number) or self.end - 2

    def line_at(self, address: int) -> int | None:
        """The link's address of the line that holds `address` in its text or its final zero."""
        places = self._walk()[0]
        place = bisect.bisect_right(places, address) - 1
        return places[place] if place >= 0 and address < self.end else None

    def number_at(self, line: int) -> int:
        """The number of the line whose link is at `line`."""
        return word(self._memory.ram, line + 2)

    def text_at(self, line: int) -> bytes:
        """The crunched text of the line whose link is at `line`."""
        return self.text_from(line + LINE_HEAD)

    def text_from(self, address: int) -> bytes:
        """The text from an address up to the next zero, or to the end of RAM."""
        return bytes(self._memory.ram[address : self._text_end(address)])

    def _text_end(self, address: int) -> int:
        """Where the next zero is from an address on, or the end of RAM where there is none."""
        end = self._memory.ram.find(0, address, self._memory.top)
        return end if end >= 0 else max(address, self._memory.top)

    def statement_end(self, address: int) -> int:
        """The colon, or the zero, that ends the statement at an address, quotes respected."""
        ram = self._memory.ram
        quoted = False
        address &= 0xFFFF
        while ram[address] and (quoted or ram[address] != COLON) and address < _LAST:
            quoted ^= ram[address] == QUOTE
            address += 1
        return address

    def text(self, number: int) -> bytes | None:
        """The crunched text of a line, None if there is none of that number."""
        line = self.find(number)
        return None if line is None else self.text_at(line)

    def lines(self) -> tuple[tuple[int, bytes], ...]:
        """Every line's number and crunched text, in order; the same object until one changes."""
        if self._lines is None:
            places = self._walk()[0]
            self._lines = tuple((self.number_at(line), self.text_at(line)) for line in places)
        return self._lines

    def clear(self) -> None:
        """No lines: two zeros where the first link would be (NEW)."""
        ram = self._memory.ram
        start = self.start
        ram[start - 1] = ram[start] = ram[start + 1] = 0
        self.end = start + 2
        self.changed()

    def delete(self, number: int) -> bool:
        """Take a line out; whether there was one."""
        return self.delete_range(number, number)

    def delete_range(self, first: int, last: int) -> bool:
        """Take the lines from `first` to `last` out; whether there were any."""
        places, numbers = self._walk()
        low = bisect.bisect_left(numbers, first)
        high = bisect.bisect_right(numbers, last)
        if low >= high:
            return False
        start = places[low]
        stop = places[high] if high < len(places) else self.end - 2
        self._replace(start, stop, b"")
        return True

    def store(self, number: int, text: bytes) -> None:
        """Put a line in its place, instead of one with the same number.

        Args:
            number: 0 to 65529.
            text: crunched, not empty, without its final zero.
        """
        self.delete(number)
        at = self.place_for(number)
        line = b"\x01\x01" + number.to_bytes(2, "little") + text.replace(b"\0", b"") + b"\0"
        self._replace(at, at, line)

    def load(self, lines: Iterable[tuple[int, bytes]]) -> None:
        """Replace the whole program by lines in ascending order of their numbers."""
        self.clear()
        ram = self._memory.ram
        address = self.start
        for number, text in lines:
            line = text.replace(b"\0", b"") + b"\0"
            stop = address + LINE_HEAD + len(line)
            ram[address:stop] = stop.to_bytes(2, "little") + number.to_bytes(2, "little") + line
            address = stop
        ram[address : address + 2] = b"\0\0"
        self.end = address + 2
        self.changed()

    def _replace(self, start: int, stop: int, new: bytes) -> None:
        """Put `new` where `start <= address < stop` was, and mend the links, as 1AF8H does."""
        end = self.end
        rest = bytes(self._memory.ram[stop:end])
        self._memory.write(start, new + rest)
        by = len(new) - (stop - start)
        self.end = end + by
        self.mend(Change(start, stop, by))

    def mend(self, change: Change = EVERYTHING) -> None:
        """Set every link to the next line, found by its final zero, when the text was changed."""
        ram, top = self._memory.ram, self._memory.top
        places: list[int] = []
        numbers: list[int] = []
        address = self.start
        end = self.end
        while address < end - 2 and (ram[address] or ram[address + 1]):
            places.append(address)
            numbers.append(ram[address + 2] | ram[address + 3] << 8)
            zero = ram.find(0, address + LINE_HEAD, top)
            following = (zero if zero >= 0 else max(address + LINE_HEAD, top)) + 1
            ram[address] = following & 0xFF
            ram[address + 1] = following >> 8 & 0xFF
            address = following
        self.changed(change)
        if self.start >= _RAM_START and address < top - 4 and not word(ram, address):
            # Who follows the links comes by the same lines.
            self._index = places, numbers
