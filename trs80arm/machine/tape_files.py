"""Files that hold a cassette: `.cas` and `.500` byte by byte, `.wav` as it sounds.

Who made them left the leader away, or began in the middle of a byte, or held a microphone to an old
recorder. Here they become what the recorder plays: leader, sync byte and bytes, recording by
recording.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from trs80arm.machine import cassette
from trs80arm.machine.cassette import (
    FileFormatError,
    ProgramRecording,
    Recording,
    SystemRecording,
)

CAS, RAW, SOUND = ".cas", ".500", ".wav"
SUFFIXES: Final = (CAS, RAW, SOUND)
LONGEST: Final = 16 * 1024 * 1024
"""Bytes of a cassette that is played: a hundred times both sides of a C-60."""
LONGEST_SOUND: Final = 1 << 30
"""Bytes of a recording that is listened to: an hour and a half in stereo."""
_SYNC: Final = bytes((cassette.SYNC,))
_HEAD: Final = cassette.LEADER + _SYNC
_HIGH_SPEED: Final = b"\x55" * 16
"""A leader at 1500 baud; its sync byte is 7FH."""
_WAV_HEADS: Final = (b"RIFF", b"RF64")


@dataclass(frozen=True)
class Entry:
    """A recording in a file.

    Attributes:
        place: where it begins: `0:04.62` in a sound, `byte 256` in bytes.
        recording: what it is; of a damaged one the part before the damage, or None.
        remarks: what is to be said of it, each in a few words; nothing if all is well.
        fault: what of it is missing or wrong; None if it is whole, if perhaps with doubts.
    """

    place: str
    recording: Recording | None
    remarks: tuple[str, ...] = ()
    fault: FileFormatError | None = None

    @property
    def label(self) -> str:
        """What it is, in words."""
        return label(self.recording)


@dataclass(frozen=True)
class TapeFile:
    """What is in a file.

    Attributes:
        content: what the recorder plays.
        entries: its recordings, in order.
        seconds: how long the sound is; None if it is none.
    """

    content: bytes
    entries: tuple[Entry, ...]
    seconds: float | None = None

    @property
    def remarks(self) -> tuple[str, ...]:
        """What is to be said of its recordings, one line each."""
        return tuple(
            f"{entry.label}: {'; '.join(entry.remarks)}" for entry in self.entries if entry.remarks
        )


def label(recording: Recording | None) -> str:
    """What a recording is: `program A`, `machine code NAME`, `data` or `noise`."""
    match recording:
        case ProgramRecording(name=name):
            return f"program {sign(name)}"
        case SystemRecording(name=name):
            return f"machine code {name.decode('latin-1').strip()}"
        case None:
            return "noise"
        case _:
            return "data"


def sign(code: int) -> str:
    """A program's name as people write it; a code that is no sign in hex."""
    return chr(code) if 32 < code < 127 else f"{code:02X}H"


def is_sound(data: bytes) -> bool:
    """Whether the beginning of a file is that of sound."""
    return data[:4] in _WAV_HEADS and data[8:12] == b"WAVE"


def is_tape(head: bytes) -> bool:
    """Whether the beginning of a file is that of a cassette without its usual leader."""
    if head.startswith(_HIGH_SPEED) or _with_leader(head) is not head:
        return True
    # A leader whose bytes begin elsewhere: zeros, and then the sync byte cut in two.
    cut = {bytes((cassette.SYNC >> shift,)) for shift in range(1, 8)}
    return head.startswith(bytes(8)) and head.lstrip(b"\0")[:1] in cut


def read(data: bytes) -> TapeFile:
    """Read a file of a cassette, whatever its kind.

    Raises:
        FileFormatError: it is no such file, or one of another machine.
    """
    if is_sound(data):
        return _heard(data)
    if data.startswith(_HIGH_SPEED) and b"\x7f" in data[:4096]:
        raise FileFormatError(
            "a cassette at 1500 baud, as a Model III makes them; Level II reads 500"
        )
    content = tidy(data)
    return TapeFile(content, tuple(_entries(content)))


def tidy(data: bytes) -> bytes:
    """The content of a `.cas` or `.500` file as the recorder plays it."""
    content = _with_leader(data)
    if content is data and not _is_machine_readable(data):
        content = _found_in_bits(data)
    return content


def write(content: bytes, suffix: str, before: bytes = b"") -> bytes:
    """The file of a cassette.

    Args:
        content: what is on it.
        suffix: of the file's name, which says its kind.
        before: the file as it was. What a sound holds already is not made anew: what is on the
            cassette now and was not then is recorded behind it.

    Raises:
        FileFormatError: `before` is a sound that cannot be read.
    """
    if suffix.lower() != SOUND:
        return content
    from trs80arm.machine.audio import wav, waveform

    if is_sound(before):
        form = wav.read(before).form
        try:
            played = read(before).content
        except FileFormatError:
            played = b""
        if content.startswith(played):
            more = content[len(played) :]
            return wav.append(before, waveform.cassette_sound(more, form.rate))
    form = wav.Form()
    return wav.write(waveform.cassette_sound(content, form.rate), form)


def sound_length(head: bytes, size: int) -> float:
    """How long a sound is, in seconds, by the beginning of its file and the file's size.

    Raises:
        FileFormatError: it is no sound.
    """
    from trs80arm.machine.audio import wav

    sound = wav.read(head)
    return (size - sound.start) / sound.form.frame / sound.form.rate


def _heard(data: bytes) -> TapeFile:
    from trs80arm.machine.audio.listening import clock_time, listen

    hearing = listen(data)
    entries = tuple(
        Entry(
            clock_time(each.start),
            each.recording or _begun(each.data),
            each.remarks,
            FileFormatError("; ".join(each.remarks)) if each.is_damaged else None,
        )
        for each in hearing.heard
    )
    return TapeFile(hearing.content, entries, hearing.seconds)


def _begun(data: bytes) -> Recording | None:
    """A program of which there is no more than its name."""
    if data.startswith(cassette.PROGRAM_MARK) and len(data) > len(cassette.PROGRAM_MARK):
        return ProgramRecording(data[len(cassette.PROGRAM_MARK)], ())
    return None


def _entries(content: bytes) -> Iterator[Entry]:
    for stretch in cassette.stretches(content):
        remarks = () if stretch.fault is None else (str(stretch.fault),)
        yield Entry(f"byte {stretch.start - 1}", stretch.recording, remarks, stretch.fault)


def _with_leader(data: bytes) -> bytes:
    """The same, behind a leader if it begins with the first byte of a program or machine code."""
    if data.startswith(cassette.PROGRAM_MARK):
        return _HEAD + data
    name_end = 1 + cassette.SYSTEM_NAME_LENGTH
    if data[:1] == bytes((cassette.SYSTEM_MARK,)) and data[name_end : name_end + 1] in (b"<", b"x"):
        return _HEAD + data
    return data


def _is_machine_readable(data: bytes) -> bool:
    """Whether there is a program or machine code in it whose bytes begin where the file's do."""
    return any(
        isinstance(recording, ProgramRecording | SystemRecording)
        for recording, _ in cassette.walk(data)
    )


def _found_in_bits(data: bytes) -> bytes:
    """The recordings of a file whose bytes begin in the middle of its own; itself if none is."""
    import numpy as np

    from trs80arm.machine.audio import bits

    stream = np.unpackbits(np.frombuffer(data, np.uint8)).tobytes()
    found = [each for each in bits.recordings(stream) if each.recording is not None]
    whole = [
        each for each in found if isinstance(each.recording, ProgramRecording | SystemRecording)
    ]
    if not whole:
        return data
    return b"".join(_HEAD + each.data for each in found)
