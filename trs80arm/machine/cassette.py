"""What is on a cassette, byte by byte: the format of `.cas` files.

A recording is a leader of zeros, the sync byte A5H and then a program, a SYSTEM file of machine
code, or data. CSAVE and PRINT#-1 write them, the recorder plays them, and program files are read
from and written to them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

LEADER = bytes(255)
"""As many zeros as the ROM writes before the sync byte; playing takes any number."""
SYNC = 0xA5
PROGRAM_MARK = b"\xd3\xd3\xd3"
"""Behind the sync byte of a BASIC program; the next byte is its one-letter name."""
SYSTEM_MARK = 0x55
SYSTEM_NAME_LENGTH = 6
_BLOCK_MARK = 0x3C
_ENTRY_MARK = 0x78
_DATA_END = 0x0D
PROGRAM_START = 0x42E9
"""Where BASIC keeps its text: 17129 (Level II facts, Crunching)."""
MAX_LINE_NUMBER = 65529
NO_END = " no end"
"""How the message ends of what goes on where the file stops."""

ProgramLine = tuple[int, bytes]
"""A line's number and its crunched text, without link and closing zero."""


class FileFormatError(ValueError):
    """A program file or cassette that is damaged or no such thing: one clear line.

    Attributes:
        message: what is wrong, without the place.
        offset: where in the file, in bytes from its start; None if it is no place.
    """

    def __init__(self, message: str, offset: int | None = None) -> None:
        super().__init__(message if offset is None else f"{message} at byte {offset}")
        self.message = message
        self.offset = offset


@dataclass(frozen=True)
class ProgramRecording:
    """A BASIC program as CSAVE leaves it."""

    name: int
    """The code of its one-letter name."""
    lines: tuple[ProgramLine, ...]


@dataclass(frozen=True)
class SystemRecording:
    """Machine code for the SYSTEM command."""

    name: bytes
    """Six characters, blanks behind."""
    blocks: tuple[tuple[int, bytes], ...]
    """Where each block is loaded, and its bytes, 1 to 256 of them."""
    entry: int


@dataclass(frozen=True)
class DataRecording:
    """What one PRINT#-1 leaves: text up to and including its CR."""

    content: bytes


Recording = ProgramRecording | SystemRecording | DataRecording


@dataclass(frozen=True)
class Lines:
    """Program lines read from bytes, and how far they went."""

    lines: tuple[ProgramLine, ...]
    stop: int
    """The offset behind the last byte that belongs to them."""
    fault: FileFormatError | None
    """What ended them early; None when they are whole."""


def parse_lines(data: bytes, start: int) -> Lines:
    """Read lines as they lie in memory: link, number, text, zero; a link of zero ends them.

    Links are not believed, for they depend on where the program lay; a zero link is one whose high
    byte is zero, as in the ROM. Whatever comes behind a fault is left unread.
    """
    lines: list[ProgramLine] = []
    offset = start

    def ended(message: str, where: int) -> Lines:
        return Lines(tuple(lines), offset, FileFormatError(message, where))

    while True:
        if offset + 2 > len(data):
            return ended("the program breaks off", len(data))
        if data[offset + 1] == 0:
            return Lines(tuple(lines), offset + 2, None)
        if offset + 4 > len(data):
            return ended("the program breaks off in a line number", len(data))
        number = data[offset + 2] | data[offset + 3] << 8
        end = data.find(0, offset + 4)
        if end < 0:
            return ended(f"line {number} has{NO_END}", offset)
        if number > MAX_LINE_NUMBER:
            return ended(f"{number} is no line number", offset + 2)
        if lines and number <= lines[-1][0]:
            return ended(f"line {number} comes behind line {lines[-1][0]}", offset + 2)
        lines.append((number, data[offset + 4 : end]))
        offset = end + 1


def encode_lines(lines: Iterable[ProgramLine], start: int = PROGRAM_START) -> bytes:
    """Lines as they lie in memory from the address `start`, with links, closed by a zero link."""
    content = bytearray()
    for number, text in lines:
        link = start + len(content) + 4 + len(text) + 1 & 0xFFFF
        # A link with a zero high byte would end the program.
        content += (link if link >= 0x100 else 0x100).to_bytes(2, "little")
        content += number.to_bytes(2, "little") + text + b"\0"
    return bytes(content) + b"\0\0"


def encode_program(name: int, lines: Iterable[ProgramLine]) -> bytes:
    """A recording of a program, leader and all, as CSAVE makes it."""
    return LEADER + bytes((SYNC,)) + PROGRAM_MARK + bytes((name,)) + encode_lines(lines)


def encode_data(content: bytes) -> bytes:
    """A recording of data, leader and all, as PRINT#-1 makes it."""
    return LEADER + bytes((SYNC,)) + content


def encode_system(recording: SystemRecording) -> bytes:
    """A recording of machine code, leader and all."""
    content = bytearray(LEADER + bytes((SYNC, SYSTEM_MARK)))
    content += recording.name.ljust(SYSTEM_NAME_LENGTH)[:SYSTEM_NAME_LENGTH]
    for address, block in recording.blocks:
        where = address.to_bytes(2, "little")
        content += bytes((_BLOCK_MARK, len(block) & 0xFF)) + where + block
        content.append(sum(where + block) & 0xFF)
    content.append(_ENTRY_MARK)
    return bytes(content) + recording.entry.to_bytes(2, "little")


def program_name(recorded: bytes) -> int | None:
    """The code of a program's name, of bytes that begin with its leader; None if it is none."""
    start = _behind_sync(recorded, 0)
    if start is None or recorded[start : start + 3] != PROGRAM_MARK or len(recorded) < start + 4:
        return None
    return recorded[start + 3]


def parse(data: bytes, *, keep_good: bool = False) -> list[Recording]:
    """Take a cassette apart into its recordings.

    Args:
        data: the bytes of a `.cas` file.
        keep_good: return what is good, of a damaged recording its part before the damage, instead
            of raising.

    Raises:
        FileFormatError: there is no recording, or one is damaged.
    """
    recordings: list[Recording] = []
    for recording, fault in walk(data):
        if fault is not None and not keep_good:
            raise fault
        if recording is not None:
            recordings.append(recording)
    if not recordings and not keep_good:
        raise FileFormatError("no recording: no sync byte A5H", len(data))
    return recordings


def walk(data: bytes) -> Iterator[tuple[Recording | None, FileFormatError | None]]:
    """The recordings of a cassette one by one, each with what is wrong with it.

    Of a damaged one there is the part before the damage, or None if nothing of it is good.
    """
    for stretch in stretches(data):
        yield stretch.recording, stretch.fault


@dataclass(frozen=True)
class Stretch:
    """A stretch of tape with a recording on it.

    Attributes:
        start: the offset of its first byte behind the sync byte.
        stop: the offset behind its last one.
        recording: what it is; of a damaged one the part before the damage, or None.
        fault: what is wrong with it.
    """

    start: int
    stop: int
    recording: Recording | None
    fault: FileFormatError | None


def stretches(data: bytes) -> Iterator[Stretch]:
    """Where on a cassette its recordings are, one by one."""
    offset = 0
    while (start := _behind_sync(data, offset)) is not None:
        recording, offset, fault = _parse_one(data, start)
        yield Stretch(start, offset, recording, fault)


def _behind_sync(data: bytes, offset: int) -> int | None:
    found = data.find(SYNC, offset)
    return None if found < 0 else found + 1


def _parse_one(data: bytes, start: int) -> tuple[Recording | None, int, FileFormatError | None]:
    """The recording behind a sync byte, where it ends, and what is wrong with it."""
    if data[start : start + 3] == PROGRAM_MARK:
        if start + 4 > len(data):
            return None, len(data), FileFormatError("the program breaks off", len(data))
        found = parse_lines(data, start + 4)
        recording = ProgramRecording(data[start + 3], found.lines)
        return (recording if found.lines or not found.fault else None), found.stop, found.fault
    if data[start : start + 1] == bytes((SYSTEM_MARK,)):
        return _parse_system(data, start + 1)
    end = data.find(_DATA_END, start)
    if end < 0:
        return None, len(data), FileFormatError(f"the data have{NO_END}", start)
    return DataRecording(data[start : end + 1]), end + 1, None


def _parse_system(data: bytes, start: int) -> tuple[Recording | None, int, FileFormatError | None]:
    name = data[start : start + SYSTEM_NAME_LENGTH]
    offset = start + SYSTEM_NAME_LENGTH
    blocks: list[tuple[int, bytes]] = []

    def broken(message: str) -> tuple[Recording | None, int, FileFormatError | None]:
        return None, min(offset, len(data)), FileFormatError(message, min(offset, len(data)))

    while offset < len(data) and data[offset] == _BLOCK_MARK:
        head = data[offset + 1 : offset + 4]
        size = (head[0] or 256) if len(head) == 3 else len(data)
        body = data[offset + 4 : offset + 4 + size]
        if len(body) < size or offset + 4 + size >= len(data):
            return broken("a block of machine code breaks off")
        if sum(head[1:] + body) & 0xFF != data[offset + 4 + size]:
            return broken("a block of machine code has a wrong checksum")
        blocks.append((head[1] | head[2] << 8, body))
        offset += 4 + size + 1
    if data[offset : offset + 1] != bytes((_ENTRY_MARK,)) or offset + 3 > len(data):
        return broken("machine code without an entry address")
    entry = data[offset + 1] | data[offset + 2] << 8
    return SystemRecording(name, tuple(blocks), entry), offset + 3, None
