"""A recorded session plays again to the last bit."""

from __future__ import annotations

from pathlib import Path

import pytest

from trs80arm.desk.recording import RecordingError, load
from trs80arm.desk.session import Session
from trs80arm.machine.card import CardSettings
from trs80arm.machine.keys import Key
from trs80arm.rig import RigSettings


def work(session: Session) -> None:
    rig = session.rig
    session.load_bytes(b"10 @SET\n20 PRINT 1/3\n")
    rig.type("RUN\r")
    rig.run_for(2)
    rig.press(Key.N1)
    rig.run_for(0.31)
    rig.hold([Key.W], 0.2)
    rig.run_for(0.4)
    rig.release(Key.N1)
    rig.hold([Key.N0], 0.1)
    rig.run_for(1)
    rig.refill()
    rig.run_for(0.1)


def test_a_recording_gives_the_same_machine_again(tmp_path: Path) -> None:
    session = Session(RigSettings(ram_kib=32, card=CardSettings(base=0x40)))
    work(session)
    session.save_recording(tmp_path / "s.jsonl")
    played = load(tmp_path / "s.jsonl")
    rig = played.rig()
    assert rig.settings == session.rig.settings
    rig.replay(played.inputs)
    rig.run_to(played.end)
    assert rig.registers == session.rig.registers
    assert rig.screen() == session.rig.screen()
    assert rig.joints == session.rig.joints


def test_a_recording_plays_on_the_desk_while_time_passes(tmp_path: Path) -> None:
    session = Session()
    work(session)
    registers = session.rig.registers
    session.save_recording(tmp_path / "s.jsonl")
    other = Session()
    other.play(load(tmp_path / "s.jsonl"))
    for _ in range(1000):
        if not other.playing:
            break
        other.run_for(0.037)
    assert not other.playing
    assert other.rig.registers == registers


def test_a_recording_kept_as_it_happens_is_the_same(tmp_path: Path) -> None:
    session = Session(record=tmp_path / "kept.jsonl")
    work(session)
    session.save_recording(tmp_path / "saved.jsonl")
    session.close()
    assert (tmp_path / "kept.jsonl").read_text() == (tmp_path / "saved.jsonl").read_text()


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("", "line 1: no head"),
        ("10 PRINT 1\n", "line 1: no head"),
        ('{"format": "trs80arm session 9"}\n', "line 1: no head"),
        ("HEAD\nnonsense\n", "line 2:"),
        ('HEAD\n{"t": 5, "do": "snapshot", "with": []}\n', "line 2: nothing is called 'snapshot'"),
        ('HEAD\n{"t": 5, "do": "press", "with": [{"evil": 1}]}\n', "line 2: nothing is called"),
        ('HEAD\n{"t": 9, "do": "end", "with": []}\n{"t": 5, "do": "end", "with": []}\n', "line 3"),
    ],
)
def test_what_is_no_recording_is_told_with_file_and_line(
    tmp_path: Path, text: str, told: str
) -> None:
    path = tmp_path / "s.jsonl"
    head = '{"format": "trs80arm session 1", "machine": {}, "bench": null}'
    path.write_text(text.replace("HEAD", head))
    with pytest.raises(RecordingError) as caught:
        load(path)
    assert str(caught.value).startswith(str(path))
    assert told in str(caught.value)
