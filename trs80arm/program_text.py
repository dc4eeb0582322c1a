"""Programs as text: listings that people type, print and keep in version control.

Listings come from magazines, word processors and machines with other line ends; what is written
here reads back to the same bytes, or is not written at all.
"""

from __future__ import annotations

import codecs
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from trs80arm.basic import cruncher, tokens
from trs80arm.basic.errors import BasicError
from trs80arm.machine.cassette import FileFormatError, ProgramLine

_DOS_END = "\x1a"
_QUOTE = 0x22
_TYPOGRAPHY = str.maketrans({"↑": "[", "“": '"', "”": '"', "‘": "'", "’": "'", "−": "-"})
"""Signs that word processors and web pages put in the place of the machine's."""


class _BadLine(Exception):  # noqa: N818
    """A line of text that is no program line, and why."""


@dataclass(frozen=True)
class _Source:
    """The text of a file and where its characters were."""

    text: str
    encoding: str
    skipped: int
    """Bytes before the text: a byte order mark."""

    def offset(self, position: int) -> int:
        """Where in the file the character at a position is."""
        return self.skipped + len(self.text[:position].encode(self.encoding))


@dataclass(frozen=True)
class WrittenLine:
    """A line of a listing that is not blank.

    Attributes:
        place: which line of the file it is, from 1.
        offset: where in the file it begins, in bytes.
        text: as it is written.
        number: its line number.
        crunched: its text as the machine holds it.
        fault: why it is no program line; empty if it is one.
    """

    place: int
    offset: int
    text: str
    number: int = 0
    crunched: bytes = b""
    fault: str = ""


def written_lines(data: bytes) -> Iterator[WrittenLine]:
    """The lines of a listing as they stand in the file, blank ones left out."""
    source = _decode(data)
    for place, (position, text) in enumerate(_split(source.text), start=1):
        if not text.strip():
            continue
        offset = source.offset(position)
        try:
            number, crunched = _parse_line(text)
        except _BadLine as bad:
            yield WrittenLine(place, offset, text, fault=str(bad))
            continue
        yield WrittenLine(place, offset, text, number, crunched)


def parse(data: bytes, *, keep_good: bool = False) -> list[ProgramLine]:
    """The program of a listing, its lines in order.

    Any line ends; small letters; blank lines are skipped; a byte order mark and what comes behind
    a DOS end of file are dropped. As if typed, of two lines with one number the later counts, and
    a number alone deletes its line. UTF-8, or else one byte a character, as the machine sends it.

    Args:
        data: the content of the file.
        keep_good: leave out what is no program line instead of raising.

    Raises:
        FileFormatError: a line without a number, or one that the machine has no characters for.
    """
    lines: dict[int, bytes] = {}
    for line in written_lines(data):
        if line.fault:
            if keep_good:
                continue
            raise FileFormatError(f"line {line.place} {line.fault}", line.offset)
        if line.crunched:
            lines[line.number] = line.crunched
        else:
            lines.pop(line.number, None)
    return sorted(lines.items())


def encode(lines: Iterable[ProgramLine]) -> bytes:
    """A listing that reads back as the same program.

    Words are spelled out as LIST does; graphics codes in strings and remarks stand for themselves.
    Lines end in LF; where a line has an LF in it (the down arrow), all end in CR.

    Raises:
        FileFormatError: a line holds what cannot be typed, so that it would be lost.
    """
    lines = list(lines)
    line_end = "\r" if any(b"\n" in crunched for _, crunched in lines) else "\n"
    text = "".join(f"{number} {spell(crunched)}{line_end}" for number, crunched in lines)
    data = text.encode("latin-1")
    if _decode(data).text != text:
        data = text.encode("utf-8")
    if parse(data, keep_good=True) != lines:
        for number, crunched in lines:
            line = f"{number} {spell(crunched)}\r".encode()
            if parse(line, keep_good=True) != [(number, crunched)]:
                raise FileFormatError(
                    f"line {number} cannot be written as text; save it as .bas or .cas"
                )
        raise FileFormatError("the program cannot be written as text; save it as .bas or .cas")
    return data


def spell(crunched: bytes) -> str:
    """The text of a stored line, words spelled out, strings and remarks as they are.

    LIST would take a graphics code in a string for a word; here it must not be lost.
    """
    spelled = bytearray()
    position = 0
    while position < len(crunched):
        end = _words_end(crunched, position)
        spelled += cruncher.spell(crunched[position:end])
        position = end
        if position == len(crunched):
            break
        if crunched[position] == _QUOTE:
            close = crunched.find(_QUOTE, position + 1)
            end = len(crunched) if close < 0 else close + 1
        else:
            end = len(crunched)
        spelled += crunched[position:end]
        position = end
    return spelled.decode("latin-1")


def _words_end(crunched: bytes, position: int) -> int:
    """Where, from `position` on, a string begins or the text of a remark."""
    while position < len(crunched):
        code = crunched[position]
        if code == _QUOTE:
            return position
        position += 1
        if code == tokens.REM:
            # An apostrophe is stored as colon, REM and its own token.
            apostrophe = crunched[position : position + 1] == bytes((tokens.APOSTROPHE,))
            return position + 1 if apostrophe else position
    return position


def _decode(data: bytes) -> _Source:
    skipped = len(codecs.BOM_UTF8) if data.startswith(codecs.BOM_UTF8) else 0
    encoding = "utf-8"
    try:
        text = data[skipped:].decode(encoding)
    except UnicodeDecodeError:
        encoding = "latin-1"
        text = data[skipped:].decode(encoding)
    return _Source(text.partition(_DOS_END)[0], encoding, skipped)


def _split(text: str) -> Iterator[tuple[int, str]]:
    """The lines of a text, each with the position where it begins.

    A text that ends in a bare CR comes from a machine whose lines end so; an LF is a character of
    the line there (the down arrow). In any other, CR, LF and both in a row are line ends.
    """
    classic = text.endswith("\r")
    start = position = 0
    while position < len(text):
        character = text[position]
        position += 1
        if character == "\r" or (character == "\n" and not classic):
            yield start, text[start : position - 1]
            if character == "\r" and text[position : position + 1] == "\n":
                position += 1
            start = position
    if start < len(text):
        yield start, text[start:]


def _parse_line(text: str) -> ProgramLine:
    if "\0" in text:
        raise _BadLine("has a zero in it, which ends a line in memory")
    try:
        typed = text.translate(_TYPOGRAPHY).encode("latin-1")
    except UnicodeEncodeError as error:
        sign = error.object[error.start]
        raise _BadLine(f"has a sign that the machine lacks, {sign!r}") from None
    try:
        number, line = cruncher.split_line(typed)
    except BasicError:
        raise _BadLine(f"has a number above {cruncher.LAST_LINE}") from None
    if number is None:
        raise _BadLine("has no line number")
    return number, cruncher.crunch(line).text
