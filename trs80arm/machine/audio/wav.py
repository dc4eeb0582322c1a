"""WAV files: samples read and written, of every kind that recorders and editors leave.

The standard library's `wave` reads no floating point, and before Python 3.12 none of the files that
say `extensible`. A sound is kept as it lies in the file and taken out stretch by stretch, as
numbers from -1 to 1: half an hour of stereo is too much to be held in memory twice.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from trs80arm.machine.cassette import FileFormatError

Samples = NDArray[np.float32]
"""Sound pressure over time, -1 to 1."""

RATES = range(4_000, 400_001)
"""Samples a second that are believed."""
MOST_CHANNELS = 32
_HEADS = (b"RIFF", b"RF64")
_PCM, _FLOAT, _EXTENSIBLE = 1, 3, 0xFFFE
_OTHERS = {2: "ADPCM", 6: "A-law", 7: "mu-law", 17: "ADPCM", 80: "MPEG", 85: "MP3"}


@dataclass(frozen=True)
class Form:
    """How samples are stored.

    Attributes:
        rate: samples a second of each channel.
        channels: 1 is mono, 2 is stereo.
        width: bytes of one sample: 1 to 4, floats 4 or 8.
        floats: whether samples are floating-point numbers.
    """

    rate: int = 44_100
    channels: int = 1
    width: int = 2
    floats: bool = False

    @property
    def frame(self) -> int:
        """Bytes of one moment: a sample of each channel."""
        return self.width * self.channels


@dataclass(frozen=True)
class Sound:
    """The sound in a file.

    Attributes:
        form: how its samples are stored.
        data: the samples as bytes.
        start: where in the file they begin.
    """

    form: Form
    data: memoryview
    start: int

    @property
    def length(self) -> int:
        """How many samples each channel has."""
        return len(self.data) // self.form.frame

    @property
    def seconds(self) -> float:
        """How long it plays."""
        return self.length / self.form.rate

    def channel(self, number: int, start: int, stop: int) -> Samples:
        """The samples of one channel from `start` to before `stop`."""
        form = self.form
        raw = np.frombuffer(self.data[start * form.frame : stop * form.frame], np.uint8)
        raw = raw.reshape(-1, form.channels, form.width)[:, number]
        if form.floats:
            floats = np.ascontiguousarray(raw).view(f"<f{form.width}")[:, 0]
            # What an editor left that is no number is silence.
            clean = np.nan_to_num(floats, nan=0.0, posinf=1.0, neginf=-1.0)
            limited: Samples = np.clip(clean, -1e6, 1e6).astype(np.float32)
            return limited
        if form.width == 1:
            return (raw[:, 0].astype(np.float32) - np.float32(128)) / np.float32(128)
        if form.width == 3:
            wide = np.zeros((len(raw), 4), np.uint8)
            wide[:, 1:] = raw
            whole = wide.view("<i4")[:, 0]
        else:
            whole = np.ascontiguousarray(raw).view(f"<i{form.width}")[:, 0]
        full = 2.0 ** (8 * whole.itemsize - 1)
        return (whole / np.float32(full)).astype(np.float32, copy=False)


def is_wav(data: bytes) -> bool:
    """Whether it begins as a WAV file does."""
    return data[:4] in _HEADS and data[8:12] == b"WAVE"


def read(data: bytes) -> Sound:
    """Read a WAV file.

    A length that a recorder never filled in, because it was switched off first, is taken to be the
    rest of the file.

    Raises:
        FileFormatError: it is none, or is compressed or otherwise stored in a way not known here.
    """
    if not is_wav(data):
        raise FileFormatError("no WAV file: it does not begin with RIFF and WAVE")
    form: Form | None = None
    for name, start, stop in _chunks(data):
        if name == b"fmt ":
            form = _form(data[start:stop], start)
        elif name == b"data":
            if form is None:
                raise FileFormatError("a WAV file that does not say how its samples are stored")
            whole = (stop - start) // form.frame * form.frame
            return Sound(form, memoryview(data)[start : start + whole], start)
    raise FileFormatError("a WAV file without sound in it", len(data))


def _chunks(data: bytes) -> Iterator[tuple[bytes, int, int]]:
    """The chunks of a file: name, and where its content begins and ends."""
    offset = 12
    while offset + 8 <= len(data):
        name, size = struct.unpack_from("<4sI", data, offset)
        start = offset + 8
        if name == b"data" and (size >= 0xFFFFFFF0 or size == 0):
            size = len(data) - start
        stop = min(start + size, len(data))
        yield name, start, stop
        offset = stop + (size & 1)


def _form(head: bytes, offset: int) -> Form:
    if len(head) < 16:
        raise FileFormatError("the head of the WAV file breaks off", offset)
    code, channels, rate, _, frame, bits = struct.unpack_from("<HHIIHH", head)
    if code == _EXTENSIBLE and len(head) >= 26:
        code = struct.unpack_from("<H", head, 24)[0]
    if code not in (_PCM, _FLOAT):
        named = _OTHERS.get(code, f"kind {code}")
        raise FileFormatError(f"a compressed WAV file ({named}): save it as PCM first", offset)
    if not 1 <= channels <= MOST_CHANNELS:
        raise FileFormatError(f"a WAV file with {channels} channels", offset + 2)
    if rate not in RATES:
        raise FileFormatError(f"a WAV file with {rate} samples a second", offset + 4)
    width = frame // channels
    widths = (4, 8) if code == _FLOAT else (1, 2, 3, 4)
    if width not in widths or frame % channels or (bits + 7) // 8 > width:
        raise FileFormatError(f"a WAV file with samples of {bits} bits", offset + 14)
    return Form(rate, channels, width, code == _FLOAT)


def write(samples: Samples, form: Form) -> bytes:
    """A WAV file with one sound in all its channels."""
    return _file(_stored(samples, form), form)


def append(data: bytes, samples: Samples) -> bytes:
    """A WAV file with more sound behind its own, stored as that is.

    Raises:
        FileFormatError: the file cannot be read.
    """
    sound = read(data)
    return _file(bytes(sound.data) + _stored(samples, sound.form), sound.form)


def _stored(samples: Samples, form: Form) -> bytes:
    """Samples as bytes, the same in all channels."""
    if form.floats:
        one = samples.astype(f"<f{form.width}").view(np.uint8).reshape(-1, form.width)
    elif form.width == 1:
        one = np.round(samples * 127 + 128).astype(np.uint8).reshape(-1, 1)
    else:
        full = 2.0 ** (8 * form.width - 1) - 1
        whole = np.round(samples.astype(np.float64) * full).astype("<i4")
        one = whole.view(np.uint8).reshape(-1, 4)[:, : form.width]
    return np.repeat(one[:, None, :], form.channels, axis=1).tobytes()


def _file(stored: bytes, form: Form) -> bytes:
    code = _FLOAT if form.floats else _PCM
    speed = form.rate * form.frame
    head = struct.pack("<HHIIHH", code, form.channels, form.rate, speed, form.frame, form.width * 8)
    padding = b"\0" * (len(stored) & 1)
    body = b"WAVEfmt " + struct.pack("<I", len(head)) + head
    body += b"data" + struct.pack("<I", len(stored)) + stored + padding
    return b"RIFF" + struct.pack("<I", len(body)) + body
