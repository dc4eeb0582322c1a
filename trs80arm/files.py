"""Program files: text, crunched and cassette, told apart by what is in them.

A cassette may be bytes or sound.

The terminal's file commands, `trs80arm run` and `trs80arm convert` load and save through here. A
program is a list of lines, each a number and its crunched text without the zero behind it, as the
machine holds it.
"""

from __future__ import annotations

import codecs
from collections.abc import Iterable
from enum import Enum
from pathlib import Path

from trs80arm import program_text
from trs80arm.machine import cassette, tape_files
from trs80arm.machine.cassette import MAX_LINE_NUMBER, FileFormatError, ProgramLine
from trs80arm.paths import open_to_read
from trs80arm.saving import write_whole

__all__ = [
    "MAX_LINE_NUMBER",
    "FileFormatError",
    "Kind",
    "MachineCodeError",
    "ProgramLine",
    "encode_program",
    "holds_sound",
    "kind_for_suffix",
    "kind_of",
    "load_program",
    "parse_program",
    "read_program",
    "save_program",
    "write_program",
]

LARGEST = 16 * 1024 * 1024
"""Bytes of a program file that is read; a machine has 48K."""
CRUNCHED_MARK = 0xFF
"""The first byte of a crunched program file."""
_CASSETTE_HEAD = bytes((cassette.SYNC,)) + cassette.PROGRAM_MARK
_HEAD_WITHIN = 4096
"""How far into a file a cassette's first program may begin, behind a leader that is not clean."""
_WIDE = ((codecs.BOM_UTF16_LE, 3), (codecs.BOM_UTF16_BE, 2))
"""How text in UTF-16 begins, one way with the mark of a crunched program, and where the first of
those bytes is that are zeros in any listing. No crunched program has zeros so close."""


class MachineCodeError(FileFormatError):
    """A cassette without a BASIC program that has machine code for SYSTEM.

    Attributes:
        name: what SYSTEM calls it.
        cassette: what is on the cassette.
    """

    def __init__(self, message: str, name: str, cassette: bytes) -> None:
        super().__init__(message)
        self.name = name
        self.cassette = cassette


class Kind(Enum):
    """The kinds of program file."""

    TEXT = "text"
    CRUNCHED = "crunched"
    CASSETTE = "cassette"


def kind_of(data: bytes) -> Kind:
    """The kind of a file by its content.

    Raises:
        FileFormatError: it is none of them.
    """
    if tape_files.is_sound(data):
        return Kind.CASSETTE
    if any(data.startswith(mark) and not any(data[high:20:2]) for mark, high in _WIDE):
        raise FileFormatError("text in UTF-16; a program is plain text: save it as UTF-8")
    if data[:1] == bytes((CRUNCHED_MARK,)):
        return Kind.CRUNCHED
    if data.lstrip(b"\0")[:1] == _CASSETTE_HEAD[:1] or _is_cassette(data):
        return Kind.CASSETTE
    zero = data.find(0)
    if zero >= 0:
        raise FileFormatError("neither text nor a crunched program nor a cassette: a zero", zero)
    return Kind.TEXT


def _is_cassette(data: bytes) -> bool:
    head = data[:_HEAD_WITHIN]
    return _CASSETTE_HEAD in head or tape_files.is_tape(head)


def parse_program(data: bytes, *, keep_good: bool = False) -> list[ProgramLine]:
    """The program in a file's content.

    Args:
        data: the content.
        keep_good: take what is good of a damaged file instead of raising; of a text all lines
            that are program lines, of the others what comes before the damage.

    Raises:
        MachineCodeError: it is a cassette of machine code.
        FileFormatError: the content is damaged, or no program.
    """
    if not data:
        return []
    try:
        kind = kind_of(data)
    except FileFormatError:
        # A text with a few zeros in it; without a single good line it never was a text.
        good = program_text.parse(data, keep_good=True) if keep_good else []
        if not good:
            raise
        return good
    match kind:
        case Kind.CRUNCHED:
            found = cassette.parse_lines(data, 1)
            lines, fault = list(found.lines), found.fault
        case Kind.CASSETTE:
            lines, fault = _first_program(data)
        case Kind.TEXT:
            return program_text.parse(data, keep_good=keep_good)
    if fault is not None and not keep_good:
        raise fault
    return lines


def read_program(path: Path) -> bytes:
    """The content of a program file.

    Raises:
        FileFormatError: it is too long for a program; the message begins with its path.
        OSError: it cannot be read.
    """
    try:
        with open_to_read(path) as file:
            data = file.read(_HEAD_WITHIN)
            largest = tape_files.LONGEST_SOUND if tape_files.is_sound(data) else LARGEST
            data += file.read(largest + 1 - len(data))
    except OSError as error:
        # What fails while it is read has no name of its own.
        error.filename = error.filename or str(path)
        raise
    if len(data) > largest:
        raise FileFormatError(f"{path}: longer than {largest >> 20} MB, which no program is")
    return data


def load_program(path: Path, *, keep_good: bool = False) -> list[ProgramLine]:
    """The program in a file.

    Raises:
        MachineCodeError: it is a cassette of machine code; the message begins with its path.
        FileFormatError: the file is damaged or no program; likewise.
        OSError: it cannot be read.
    """
    data = read_program(path)
    try:
        return parse_program(data, keep_good=keep_good)
    except MachineCodeError as error:
        raise MachineCodeError(f"{path}: {error}", error.name, error.cassette) from None
    except FileFormatError as error:
        named = FileFormatError(f"{path}: {error}")
        named.offset = error.offset
        raise named from None


def encode_program(lines: Iterable[ProgramLine], kind: Kind, name: str = "A") -> bytes:
    """The content of a file with a program.

    Args:
        lines: the program.
        kind: the kind of file.
        name: the first letter or digit of it is the program's name on a cassette.

    Raises:
        FileFormatError: a line cannot be written as text.
    """
    lines = list(lines)
    match kind:
        case Kind.CRUNCHED:
            return bytes((CRUNCHED_MARK,)) + cassette.encode_lines(lines)
        case Kind.CASSETTE:
            return cassette.encode_program(_cassette_name(name), lines)
        case Kind.TEXT:
            return program_text.encode(lines)


def save_program(path: Path, lines: Iterable[ProgramLine], kind: Kind | None = None) -> None:
    """Save a program, whole or not at all.

    Args:
        path: the file.
        lines: the program.
        kind: the kind of file; None for that of the suffix: `.cas`, `.500` and `.wav` a cassette,
            `.bas` crunched unless there is a file already and it is text, anything else text.

    Raises:
        FileFormatError: a line cannot be written as text, or there is a recording of sound.
        OSError: the file cannot be written; an older one is untouched.
    """
    if holds_sound(path):
        # Somebody's old tape, perhaps the only copy.
        raise FileFormatError(f"{path} is a recording of sound; save under another name")
    write_program(path, lines, kind)


def write_program(path: Path, lines: Iterable[ProgramLine], kind: Kind | None = None) -> None:
    """The same, over a recording of sound too."""
    kind = kind or _kind_for(path)
    content = encode_program(lines, kind, path.stem)
    if kind is Kind.CASSETTE:
        content = tape_files.write(content, path.suffix)
    write_whole(path, content)


def holds_sound(path: Path) -> bool:
    """Whether there is a file of that name, and it is a sound."""
    try:
        with open_to_read(path) as file:
            return tape_files.is_sound(file.read(12))
    except OSError:
        return False


_SUFFIXES = {".bas": Kind.CRUNCHED} | dict.fromkeys(tape_files.SUFFIXES, Kind.CASSETTE)


def kind_for_suffix(path: Path) -> Kind:
    """The kind of file that a suffix stands for; what has none of its own is text."""
    return _SUFFIXES.get(path.suffix.lower(), Kind.TEXT)


def _kind_for(path: Path) -> Kind:
    kind = kind_for_suffix(path)
    if kind is Kind.CRUNCHED:
        try:
            with open_to_read(path) as file:
                first = file.read(1)
        except OSError:
            return kind
        # Programs of today are kept as text under .bas, too: what was text stays text.
        if first and first[0] != CRUNCHED_MARK:
            return Kind.TEXT
    return kind


def _cassette_name(name: str) -> int:
    letters = [letter for letter in name.upper() if letter.isascii() and letter.isalnum()]
    return ord(letters[0]) if letters else ord("A")


def _first_program(data: bytes) -> tuple[list[ProgramLine], FileFormatError | None]:
    """The first BASIC program of a cassette; what comes behind it does not matter."""
    other = "nothing that is whole"
    first_fault = None
    system_name = None
    file = tape_files.read(data)
    for entry in file.entries:
        fault = entry.fault
        first_fault = first_fault or fault
        match entry.recording:
            case cassette.ProgramRecording(lines=lines):
                return list(lines), fault
            case cassette.SystemRecording(name=name):
                found = name.decode("latin-1").rstrip()
                other = f"machine code, {found!r}"
                system_name = found if system_name is None and fault is None else system_name
            case cassette.DataRecording():
                other = "data"
    why = f"no BASIC program on the cassette, only {other}"
    if system_name is not None:
        return [], MachineCodeError(why, system_name, file.content)
    return [], first_fault or FileFormatError(why)
