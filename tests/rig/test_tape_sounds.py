"""The recorder plays and records sound: `.wav` files among its cassettes."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.machine.tape_sounds import Damage, sound_file
from trs80arm import Rig, RigSettings
from trs80arm.files import Kind, encode_program
from trs80arm.machine import cassette
from trs80arm.machine.audio import wav
from trs80arm.machine.cassette import SystemRecording
from trs80arm.machine.tape import Tape

PROGRAM = encode_program([(10, b'\xb2 "HEARD"'), (20, b"\x8d 10")], Kind.CASSETTE)


def rig_with(folder: Path) -> Rig:
    return Rig(RigSettings(tape_folder=folder))


def typed(rig: Rig, *lines: str) -> str:
    for line in lines:
        rig.type(line + "\r")
        rig.run_until_waiting(120)
    return "\n".join(rig.screen())


def test_cload_finds_a_program_in_a_sound(tmp_path: Path) -> None:
    (tmp_path / "side1.wav").write_bytes(sound_file(PROGRAM, Damage(wow=0.01, hum=0.3)))
    assert '10 PRINT "HEARD"' in typed(rig_with(tmp_path), "CLOAD", "LIST")


def test_system_loads_machine_code_from_a_sound(tmp_path: Path) -> None:
    code = SystemRecording(b"GAME  ", ((0x5000, b"\1\2\3"),), 0x1A19)
    (tmp_path / "GAME.WAV").write_bytes(sound_file(cassette.encode_system(code)))
    rig = rig_with(tmp_path)
    typed(rig, "SYSTEM", "GAME", "/")
    assert bytes(rig.memory.peek(0x5000 + place) for place in range(3)) == b"\1\2\3"


def test_csave_records_sound_on_a_cassette_of_sound_and_cload_plays_it(tmp_path: Path) -> None:
    rig = rig_with(tmp_path)
    rig.insert_cassette("mine.wav")
    typed(rig, '10 PRINT "MINE"', 'CSAVE"M"')
    sound = wav.read((tmp_path / "mine.wav").read_bytes())
    assert sound.seconds > 4
    again = rig_with(tmp_path)
    assert '10 PRINT "MINE"' in typed(again, 'CLOAD"M"', "LIST")


def test_what_is_recorded_leaves_the_sound_before_as_it_is(tmp_path: Path) -> None:
    before = sound_file(PROGRAM, Damage(hum=0.2), wav.Form(11_025, 2, 1))
    (tmp_path / "old.wav").write_bytes(before)
    tape = Tape(tmp_path)
    tape.insert("old.wav")
    tape.start_writing()
    for value in cassette.encode_data(b"5\r"):
        tape.write(value)
    tape.stop()
    after = (tmp_path / "old.wav").read_bytes()
    assert bytes(wav.read(after).data).startswith(bytes(wav.read(before).data))
    assert wav.read(after).form == wav.read(before).form
    assert Tape(tmp_path).look_at("old.wav").count(b"\xa55\r") == 1
    assert tape.fault is None


def test_a_bad_sound_is_told_and_the_machine_goes_on(tmp_path: Path) -> None:
    (tmp_path / "bad.wav").write_bytes(wav.write(np.zeros(0, np.float32), wav.Form()))
    rig = rig_with(tmp_path)
    rig.insert_cassette("bad.wav")
    assert rig.tape.fault == "bad.wav: nothing but silence in 0.0 seconds of sound"
    assert "4" in typed(rig, "PRINT 2+2")


def test_what_was_not_heard_is_told(tmp_path: Path) -> None:
    whole = sound_file(PROGRAM)
    (tmp_path / "cut.wav").write_bytes(whole[: 44 + 2 * int(22_050 * 4.85)])
    tape = Tape(tmp_path)
    tape.insert("cut.wav")
    assert tape.fault is not None
    assert tape.fault.startswith("cut.wav: program A: ")
    assert "the sound is lost at 0:04.8" in tape.fault


def test_a_sound_is_not_listened_to_twice(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from trs80arm.machine.audio import listening

    (tmp_path / "a.wav").write_bytes(sound_file(PROGRAM))
    tape = Tape(tmp_path)
    first = tape.look_at("a.wav")
    monkeypatch.setattr(listening, "listen", None)
    assert tape.look_at("a.wav") == first
    assert tape.sound_length("a.wav") == pytest.approx(5.6, abs=0.3)
