"""Recordings are heard in sound, whatever was done to it; of what is lost it is said where."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from tests.machine.tape_sounds import (
    Damage,
    Samples,
    damages,
    forms,
    programs,
    sound_file,
    with_short_leader,
)
from trs80arm.machine import cassette
from trs80arm.machine.audio import wav, waveform
from trs80arm.machine.audio.listening import Hearing, listen
from trs80arm.machine.cassette import FileFormatError, SystemRecording

LINES = tuple((number, b'\xb2 "LINE %d"' % number) for number in range(10, 130, 10))
PROGRAM = cassette.encode_program(ord("A"), LINES)
BLANKS = cassette.encode_program(ord("A"), ((0, b" " * 7), (1, b" ")))
RATE = 22_050


def heard(data: bytes) -> list[bytes]:
    return [each.data for each in listen(data).heard]


def behind_sync(content: bytes) -> bytes:
    return content[content.index(cassette.SYNC) + 1 :]


def of(samples: Samples) -> bytes:
    return wav.write(samples.astype(np.float32), wav.Form(RATE))


def clean(content: bytes = PROGRAM) -> Samples:
    return waveform.cassette_sound(content, RATE)


@settings(max_examples=30)
@given(programs, damages, forms)
@example(PROGRAM, Damage(wow=0.02, wow_rate=3, hum=0.4, noise=0.008, fade=0.15), wav.Form(8_000))
@example(PROGRAM, Damage(upside_down=True, dull=True, hum=0.4), wav.Form(11_025, 2, 1))
# The ROM's pause behind the sync byte in a dip that ends soon.
@example(BLANKS, Damage(fade=0.5, dips=((0.4766, 0.0156, 0.25),)), wav.Form(8_000, 1, 1))
def test_a_program_is_heard_through_bad_recorders(
    content: bytes, damage: Damage, form: wav.Form
) -> None:
    hearing = listen(sound_file(with_short_leader(content), damage, form))
    assert [each.data for each in hearing.heard] == [behind_sync(content)]
    assert hearing.heard[0].fault is None


@settings(max_examples=15)
@given(programs, st.floats(0.12, 0.5), st.booleans())
def test_a_clipped_recording_is_heard(content: bytes, clip: float, inverted: bool) -> None:
    damage = Damage(clip=clip, upside_down=inverted)
    assert heard(sound_file(with_short_leader(content), damage)) == [behind_sync(content)]


def test_a_dip_of_the_volume_to_a_tenth_is_heard_through() -> None:
    damage = Damage(dips=((0.4, 0.05, 0.1), (0.6, 0.3, 0.1), (0.8, 0.015, 0.1)))
    assert heard(sound_file(PROGRAM, damage)) == [behind_sync(PROGRAM)]


@pytest.mark.parametrize("silent", [0, 1])
def test_the_channel_with_the_recording_is_found(silent: int) -> None:
    channels = np.zeros((2, len(clean())), np.float32)
    channels[1 - silent] = clean()
    channels[silent] = 0.9 * np.sin(np.arange(len(clean())) * 0.01)
    both = (channels.T * 32767).astype("<i2")
    data = bytearray(wav.write(clean(), wav.Form(RATE, 2)))
    data[44:] = both.tobytes()
    assert heard(bytes(data)) == [behind_sync(PROGRAM)]


def test_channels_against_each_other_do_not_cancel() -> None:
    both = (np.stack([clean(), -clean()], axis=1) * 32767).astype("<i2")
    data = bytearray(wav.write(clean(), wav.Form(RATE, 2)))
    data[44:] = both.tobytes()
    assert heard(bytes(data)) == [behind_sync(PROGRAM)]


def test_several_recordings_are_heard_in_order() -> None:
    system = SystemRecording(b"GAME  ", ((0x5000, bytes(range(200))),), 0x5000)
    parts = [PROGRAM, cassette.encode_system(system), cassette.encode_data(b"1,ABC\r")]
    hearing = listen(of(clean(b"".join(parts))))
    assert [each.data for each in hearing.heard] == [behind_sync(part) for part in parts]
    assert hearing.content == b"".join(parts)
    starts = [each.start for each in hearing.heard]
    assert starts == sorted(starts)
    assert starts[0] == pytest.approx(0.5 + waveform.duration(bytes(255)) / 1_774_080, abs=0.01)


def test_a_recording_right_behind_another_begins_where_its_leader_says() -> None:
    second = cassette.encode_program(ord("B"), LINES[:2])
    one, other = clean(), clean(second)
    # No blank tape between them, and the bytes of the second begin in the middle of a bit.
    joined = np.concatenate([one[: -RATE // 2], other[RATE // 2 + 17 :]])
    assert heard(of(joined)) == [behind_sync(PROGRAM), behind_sync(second)]


def test_a_pause_before_a_clock_is_waited_for() -> None:
    times = waveform.pulse_times(PROGRAM)
    rng = np.random.default_rng(2)
    late = np.cumsum(np.where(rng.random(len(times)) < 0.01, 1900, 0))
    # Clocks only: a data pulse stays with its clock.
    apart = np.diff(times, prepend=times[0])
    late_clocks = np.where(apart < 2000, np.roll(late, 1), late)
    moments = (times + np.maximum.accumulate(late_clocks) + 900_000) / 1_774_080
    samples = np.zeros(int((moments[-1] + 0.5) * RATE), np.float32)
    for moment in moments:
        place = int(moment * RATE)
        samples[place : place + 6] += np.array([0.3, 0.5, 0.3, -0.3, -0.5, -0.3], np.float32)
    assert heard(of(samples)) == [behind_sync(PROGRAM)]


def only(hearing: Hearing) -> tuple[str, ...]:
    assert len(hearing.heard) == 1
    return hearing.heard[0].remarks


def test_a_recording_that_breaks_off_says_when_and_keeps_what_was_heard() -> None:
    whole = clean()
    hearing = listen(of(whole[: 6 * RATE]))
    assert "the sound is lost at 0:06.0" in only(hearing)[0]
    recording = hearing.heard[0].recording
    assert isinstance(recording, cassette.ProgramRecording)
    assert 0 < len(recording.lines) < len(LINES)
    assert recording.lines == LINES[: len(recording.lines)]


def test_a_drop_out_says_where_and_how_much() -> None:
    samples = clean()
    samples[6 * RATE : 6 * RATE + RATE // 50] = 0
    remarks = only(listen(of(samples)))
    assert any(
        "bits were not heard, the first at 0:05.99" in remark or "first at 0:06.0" in remark
        for remark in remarks
    )


def test_a_data_pulse_half_as_strong_is_in_doubt() -> None:
    samples = clean()
    clocks = waveform.pulse_times(PROGRAM)
    apart = np.diff(clocks)
    data = clocks[1:][apart == waveform.CLOCK_TO_DATA][50]
    place = int((data + waveform.SILENCE) / 1_774_080 * RATE)
    samples[place - 4 : place + 9] *= 0.5
    hearing = listen(of(samples))
    assert hearing.heard[0].doubtful
    assert "1 bit was in doubt, the first at 0:0" in only(hearing)[-1]


def why(samples: Samples, rate: int = RATE) -> str:
    with pytest.raises(FileFormatError) as failed:
        listen(wav.write(samples.astype(np.float32), wav.Form(rate)))
    return str(failed.value)


def test_other_speeds_are_told_by_name() -> None:
    # The same samples played at half and at twice their speed.
    assert "250 baud, as Level I" in why(clean(), RATE // 2)
    assert "1000 baud" in why(clean(), RATE * 2)


def high_speed(content: bytes) -> Samples:
    """A Model III's sound: one wave a bit, a zero's twice as long as a one's."""
    bits = [0, 1] * 1024 + [0] + [1] * 7
    for byte in content:
        bits += [0] + [byte >> place & 1 for place in range(7, -1, -1)]
    halves = [round((187e-6 if bit else 378e-6) * 44_100) for bit in bits]
    waves = [np.repeat([0.3, -0.3], half) for half in halves]
    return np.concatenate([np.zeros(30_000), *waves])


def test_1500_baud_is_told_by_name() -> None:
    assert "1500 baud, as a Model III does" in why(high_speed(PROGRAM), 44_100)


@pytest.mark.parametrize(
    ("samples", "words"),
    [
        (np.zeros(0), "nothing but silence in 0.0 seconds"),
        (np.zeros(100_000), "nothing but silence in 4.5 seconds"),
        (np.sin(np.arange(100_000) * 0.3), "no recording of a TRS-80 in 4.5 seconds"),
        (np.random.default_rng(3).normal(0, 0.2, 100_000), "no recording of a TRS-80"),
        (waveform.sound(bytes(60), RATE), "a leader but no sync byte A5H behind it"),
    ],
    ids=["empty", "silent", "tone", "noise", "leader"],
)
def test_what_is_no_recording_is_told(samples: Samples, words: str) -> None:
    assert words in why(np.clip(samples, -1, 1))


@settings(max_examples=30)
@given(st.data())
def test_any_damage_leaves_recordings_in_order_or_is_told(data: st.DataObject) -> None:
    samples = clean(with_short_leader(PROGRAM))
    for _ in range(data.draw(st.integers(1, 6))):
        start = data.draw(st.integers(0, len(samples) - 1))
        length = data.draw(st.integers(1, RATE))
        seed = data.draw(st.integers(0, 99))
        loud = data.draw(st.sampled_from([0.0, 0.05, 0.5]))
        stop = min(start + length, len(samples))
        samples[start:stop] = np.random.default_rng(seed).normal(0, loud, stop - start)
    try:
        hearing = listen(of(np.clip(samples, -1, 1)))
    except FileFormatError:
        return
    last = 0.0
    for each in hearing.heard:
        assert last <= each.start < each.stop <= hearing.seconds + 0.01
        assert len(each.times) == len(each.data)
        assert bool(each.remarks) is not each.is_good
        last = each.stop
