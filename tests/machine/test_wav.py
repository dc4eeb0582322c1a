"""WAV files of every kind come in as the same sound; others are refused in one line."""

from __future__ import annotations

import struct

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.machine.tape_sounds import forms
from trs80arm.machine.audio import wav
from trs80arm.machine.cassette import FileFormatError

SOUND = np.sin(np.arange(500) / 7).astype(np.float32) * np.float32(0.8)


@given(forms)
def test_a_sound_comes_back_from_every_kind_of_file(form: wav.Form) -> None:
    sound = wav.read(wav.write(SOUND, form))
    assert sound.form == form
    assert sound.length == len(SOUND)
    for channel in range(form.channels):
        back = sound.channel(channel, 0, sound.length)
        assert np.abs(back - SOUND).max() < (0.01 if form.width == 1 else 1e-4)


@given(forms)
def test_sound_is_recorded_behind_what_is_there(form: wav.Form) -> None:
    before = wav.write(SOUND, form)
    after = wav.append(before, SOUND[:100])
    whole = wav.read(after)
    assert whole.length == len(SOUND) + 100
    assert bytes(whole.data).startswith(bytes(wav.read(before).data))


def extensible(data: bytes) -> bytes:
    """The same file as editors write more than 16 bits."""
    form = struct.pack("<H", 0xFFFE) + data[22:36]
    head = form + struct.pack("<HHI", 22, 16, 0) + b"\1\0" + bytes(14)
    body = b"WAVE" + b"LIST" + struct.pack("<I", 3) + b"abc\0"
    body += b"fmt " + struct.pack("<I", len(head)) + head + data[36:]
    return b"RIFF" + struct.pack("<I", len(body)) + body


def test_an_extensible_file_with_other_chunks_is_read() -> None:
    data = wav.write(SOUND, wav.Form())
    assert bytes(wav.read(extensible(data)).data) == bytes(wav.read(data).data)


@pytest.mark.parametrize("length", [0, 0xFFFFFFFF, 1 << 30])
def test_a_length_that_was_never_filled_in_is_the_rest_of_the_file(length: int) -> None:
    data = bytearray(wav.write(SOUND, wav.Form()))
    struct.pack_into("<I", data, 40, length)
    assert wav.read(bytes(data)).length == len(SOUND)


def changed(offset: int, form: str, value: int) -> bytes:
    data = bytearray(wav.write(SOUND, wav.Form()))
    struct.pack_into(form, data, offset, value)
    return bytes(data)


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"RIFF", "no WAV file"),
        (changed(20, "<H", 85), "a compressed WAV file (MP3)"),
        (changed(20, "<H", 77), "a compressed WAV file (kind 77)"),
        (changed(22, "<H", 0), "with 0 channels"),
        (changed(24, "<I", 5), "with 5 samples a second"),
        (changed(32, "<H", 7), "with samples of 16 bits"),
        (changed(36, "<I", 0), "without sound in it"),
        (wav.write(SOUND, wav.Form())[:30], "breaks off"),
    ],
)
def test_what_cannot_be_read_is_told(data: bytes, words: str) -> None:
    with pytest.raises(FileFormatError) as failed:
        wav.read(data)
    assert words in str(failed.value)


@given(st.binary(max_size=80), st.integers(0, 60), forms)
def test_any_bytes_are_a_sound_or_refused(noise: bytes, place: int, form: wav.Form) -> None:
    data = bytearray(wav.write(SOUND[:20], form))
    data[place : place + len(noise)] = noise
    try:
        sound = wav.read(bytes(data))
    except FileFormatError:
        return
    for channel in range(sound.form.channels):
        assert np.isfinite(sound.channel(channel, 0, sound.length)).all()
