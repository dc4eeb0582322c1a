"""Program files and cassettes made into others, and what is on them told.

From one cassette to another, of bytes or of sound, goes all that is on it; into a file that holds
one program goes the first of them, or the one that is named.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from trs80arm import files
from trs80arm.files import FileFormatError, Kind
from trs80arm.machine import cassette, tape_files
from trs80arm.machine.cassette import DataRecording, ProgramRecording, Recording, SystemRecording
from trs80arm.machine.tape_files import Entry, TapeFile
from trs80arm.saving import write_whole


@dataclass(frozen=True)
class Converted:
    """What was written.

    Attributes:
        words: how much, as `12 lines` or `3 recordings`.
        remarks: what of the source is in doubt or was left out, one line each.
    """

    words: str
    remarks: tuple[str, ...]


def convert(
    source: Path, target: Path, *, keep_good: bool = False, name: str | None = None
) -> Converted:
    """Write what is in one file to another, in the kind of its suffix.

    Args:
        source: a program or a cassette.
        target: `.cas`, `.500` and `.wav` are cassettes, `.bas` is crunched, any other is text.
        keep_good: take what is good of a damaged source.
        name: of the program on a cassette that is meant, one letter; None: all of the cassette, or
            its first program.

    Raises:
        FileFormatError: the source is damaged or no program, or cannot be written as text; the
            message begins with the file's name.
        OSError: a file cannot be read or written.
    """
    data = files.read_program(source)
    try:
        tape = tape_files.read(data) if data and files.kind_of(data) is Kind.CASSETTE else None
        if tape is None:
            if name is not None:
                raise FileFormatError("no cassette, on which programs have names")
            lines = files.parse_program(data, keep_good=keep_good)
            files.write_program(target, lines, files.kind_for_suffix(target))
            return Converted(_lines(len(lines)), ())
        if name is None and files.kind_for_suffix(target) is Kind.CASSETTE:
            return _copy(tape, target, keep_good=keep_good)
        return _one_program(tape, target, name, keep_good=keep_good)
    except FileFormatError as error:
        named = FileFormatError(f"{source}: {error}")
        named.offset = error.offset
        raise named from None


def listing(source: Path) -> Iterator[str]:
    """What is in a file, a line each: its recordings, and what is to be said of them.

    Raises:
        FileFormatError: it is no program and no cassette; the message begins with its name.
        OSError: it cannot be read.
    """
    data = files.read_program(source)
    try:
        kind = files.kind_of(data) if data else Kind.TEXT
        if kind is not Kind.CASSETTE:
            yield f"{kind.value}, {_program_words(files.parse_program(data, keep_good=True))}"
            return
        tape = tape_files.read(data)
    except FileFormatError as error:
        raise FileFormatError(f"{source}: {error}") from None
    if not tape.entries:
        raise FileFormatError(f"{source}: no recording: no sync byte A5H")
    width = max(len(entry.place) for entry in tape.entries)
    for entry in tape.entries:
        yield f"{entry.place:<{width}}  {_told(entry)}"
        for remark in entry.remarks:
            yield f"{'':<{width}}    {remark}"


def _told(entry: Entry) -> str:
    match entry.recording:
        case ProgramRecording(lines=lines):
            return f"{entry.label}, {_program_words(list(lines))}"
        case SystemRecording(blocks=blocks, entry=start):
            size = sum(len(block) for _, block in blocks)
            lowest = min((address for address, _ in blocks), default=0)
            return f"{entry.label}, {size} bytes from {lowest:04X}H, starts at {start:04X}H"
        case DataRecording(content=content):
            return f"{entry.label}, {len(content)} characters"
        case _:
            return entry.label


def _program_words(lines: list[files.ProgramLine]) -> str:
    if not lines:
        return "no lines"
    return f"{_lines(len(lines))}, {lines[0][0]} to {lines[-1][0]}"


def _lines(count: int) -> str:
    return f"{count} line{'' if count == 1 else 's'}"


def _copy(tape: TapeFile, target: Path, *, keep_good: bool) -> Converted:
    """All of a cassette; of damaged recordings what is good of them."""
    if not tape.entries:
        raise FileFormatError("no recording: no sync byte A5H")
    content = bytearray()
    count = 0
    for entry in tape.entries:
        if entry.fault is not None and not keep_good:
            raise _damaged(entry)
        if entry.recording is not None:
            content += _encoded(entry.recording)
            count += 1
    write_whole(target, tape_files.write(bytes(content), target.suffix))
    return Converted(f"{count} recording{'' if count == 1 else 's'}", tape.remarks)


def _encoded(recording: Recording) -> bytes:
    match recording:
        case ProgramRecording(name=name, lines=lines):
            return cassette.encode_program(name, lines)
        case SystemRecording():
            return cassette.encode_system(recording)
        case DataRecording(content=content):
            return cassette.encode_data(content)


def _one_program(tape: TapeFile, target: Path, name: str | None, *, keep_good: bool) -> Converted:
    programs = [entry for entry in tape.entries if isinstance(entry.recording, ProgramRecording)]
    wanted = [entry for entry in programs if name is None or entry.label == f"program {name}"]
    if not wanted:
        held = ", ".join(entry.label for entry in tape.entries) or "nothing"
        what = "BASIC program" if name is None else f"program {name}"
        faults = [entry for entry in tape.entries if entry.fault is not None]
        if name is None and faults:
            raise _damaged(faults[0])
        raise FileFormatError(f"no {what} on the cassette, only {held}")
    entry = wanted[0]
    if entry.fault is not None and not keep_good:
        raise _damaged(entry)
    assert isinstance(entry.recording, ProgramRecording)
    lines = list(entry.recording.lines)
    letter = chr(entry.recording.name)
    kind = files.kind_for_suffix(target)
    content = files.encode_program(lines, kind, letter)
    if kind is Kind.CASSETTE:
        content = tape_files.write(content, target.suffix)
    write_whole(target, content)
    remarks = [f"{entry.label}: {remark}" for remark in entry.remarks]
    if name is None and len(programs) > 1:
        others = ", ".join(each.label for each in programs[1:])
        remarks.append(f"{entry.label} is the first, without {others} (--name takes one)")
    return Converted(_lines(len(lines)), tuple(remarks))


def _damaged(entry: Entry) -> FileFormatError:
    """What is wrong with a recording, and what there is of it all the same."""
    good = ""
    if isinstance(entry.recording, ProgramRecording) and entry.recording.lines:
        count = len(entry.recording.lines)
        verb, them = ("is", "it") if count == 1 else ("are", "them")
        good = f"; {_lines(count)} {verb} good (--keep-good takes {them})"
    return FileFormatError(f"{entry.label}: {'; '.join(entry.remarks)}{good}")
