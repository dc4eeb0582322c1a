"""Programs that make sound by OUT 255 are heard, in the machine's own time."""

from __future__ import annotations

import struct
import sys
import types
from itertools import pairwise

import pytest

from tests.desk.sitting import Sitting
from trs80arm.desk.sound import LOUDNESS, MOST_AHEAD, RATE, BellRinger, LineSound, Samples
from trs80arm.options import Sound

BUZZ = "FOR I=1 TO 20:OUT 255,1:OUT 255,2:NEXT:OUT 255,0"


def test_the_bell_rings_once_where_a_sound_begins() -> None:
    rung: list[int] = []
    bell = BellRinger(lambda: rung.append(1))
    bell.play([(1.0, 1), (1.1, 2), (1.2, 1)], 1.3)
    bell.play([(1.4, 0)], 1.5)
    assert len(rung) == 1
    bell.play([(3.0, 1)], 3.1)
    assert len(rung) == 2


def levels(samples: Samples, count: int) -> list[int]:
    return list(struct.unpack(f"<{count}h", samples.take(count)))


def test_samples_have_the_lines_level_at_each_time() -> None:
    samples = Samples()
    samples.play([(1.0, 1), (1.0 + 10 / RATE, 2)], 1.0 + 15 / RATE)
    assert levels(samples, 18) == [LOUDNESS] * 10 + [-LOUDNESS] * 5 + [0] * 3
    samples.play([], 1.0 + 20 / RATE)
    assert levels(samples, 5) == [-LOUDNESS] * 5


def test_silence_makes_no_samples() -> None:
    samples = Samples()
    samples.play([], 5.0)
    samples.play([(5.0, 1)], 5.0)
    samples.play([], 9.0)
    samples.play([], 9.1)
    samples.play([(60.0, 1)], 60.0 + 2 / RATE)
    assert levels(samples, 3) == [LOUDNESS, LOUDNESS, 0]


def test_what_comes_faster_than_it_is_heard_is_left_out() -> None:
    samples = Samples()
    samples.play([(0.0, 1), (10.0 - 5 / RATE, 2)], 10.0)
    heard = [LOUDNESS] * (MOST_AHEAD - 5) + [-LOUDNESS] * 5
    assert levels(samples, MOST_AHEAD + 1) == [*heard, 0]


def test_a_program_is_heard_at_its_own_pitch(sitting: Sitting) -> None:
    heard: list[tuple[int, int]] = []
    stop = sitting.session.rig.watch_line(lambda time, level: heard.append((time, level)))
    sitting.type(BUZZ)
    stop()
    assert [level for _, level in heard] == [1, 2] * 20 + [0]
    periods = {later - earlier for (earlier, _), (later, _) in pairwise(heard[:40:2])}
    assert len(periods) == 1, "each turn of the loop takes the same time"


def test_a_session_is_heard_by_the_bell_until_it_is_turned_off(sitting: Sitting) -> None:
    rung: list[int] = []
    sound = LineSound(sitting.session, lambda: rung.append(1), sitting.person.say, Sound.BELL)
    sitting.type(BUZZ)
    sound.go_on()
    assert len(rung) == 1
    sitting.session.reset()
    sitting.type(BUZZ)
    sound.go_on()
    assert len(rung) == 2
    sound.use(Sound.OFF)
    sitting.type(BUZZ)
    sound.go_on()
    assert len(rung) == 2


def wait_for(sound: LineSound, sitting: Sitting) -> None:
    """The loudspeaker is opened beside the program."""
    for _ in range(10_000):
        sound.go_on()
        if sitting.person.errors:
            return
        sitting.session.run_for(0.001)


def test_without_the_library_the_bell_rings_and_it_is_told(
    sitting: Sitting, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "sounddevice", None)
    sound = LineSound(sitting.session, lambda: None, sitting.person.say, Sound.SAMPLES)
    wait_for(sound, sitting)
    assert "extra `sound`" in sitting.person.errors[0]
    assert sound.sound is Sound.BELL


def test_a_computer_without_a_loudspeaker_is_told(
    sitting: Sitting, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(**_: object) -> None:
        raise OSError("no device")

    library = types.SimpleNamespace(RawOutputStream=refuse)
    monkeypatch.setitem(sys.modules, "sounddevice", library)
    sound = LineSound(sitting.session, lambda: None, sitting.person.say, Sound.SAMPLES)
    wait_for(sound, sitting)
    assert sitting.person.errors == ["No sound: no device. The bell rings instead."]


def test_who_sits_at_a_browser_does_not_make_this_computer_sound(
    sitting: Sitting, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened: list[object] = []
    library = types.SimpleNamespace(RawOutputStream=lambda **options: opened.append(options))
    monkeypatch.setitem(sys.modules, "sounddevice", library)
    sound = LineSound(sitting.session, lambda: None, sitting.person.say, Sound.SAMPLES, far=True)
    sound.go_on()
    assert "at the other computer" in sitting.person.errors[0]
    assert sound.sound is Sound.BELL
    assert not opened
