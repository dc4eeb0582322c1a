"""A recorded session plays again to the last bit."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from trs80arm.desk.recording import RecordingError, load, parse
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
    rig.pull(0.0, 0.0, -70.0)
    rig.let_go()
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


HEAD = '{"format": "trs80arm session 1", "machine": {}, "bench": null}'
DEEP = "[" * 100_000


def head(**more: object) -> str:
    return json.dumps({"format": "trs80arm session 1", "machine": {}, "bench": None} | more)


def action(do: str, *values: object, t: object = 5) -> str:
    return HEAD + "\n" + json.dumps({"t": t, "do": do, "with": list(values)})


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("", "line 1: no JSON object"),
        ("10 PRINT 1\n", "line 1: no JSON object"),
        ('{"format": "trs80arm session 9"}\n', "line 1: format: expected the words"),
        (DEEP, "line 1: no JSON object"),
        (head(evil=1), "line 1: evil: expected nothing by that name"),
        (head(machine=[]), "line 1: machine: expected a table"),
        (head(machine={"ram_kib": 5}), "line 1: machine: ram_kib must be 4, 16, 32 or 48"),
        (head(machine={"ram": 16}), "line 1: machine: ram: expected nothing by that name"),
        (head(machine={"memory_size": "9" * 400}), "line 1: machine: memory_size must be"),
        (head(machine={"printer_file": "~/.profile"}), "a recording names no files"),
        (head(machine={"tape_folder": "/"}), "a recording names no files"),
        (head(machine={"card": {"base": 300}}), "line 1: machine: card: "),
        (head(machine={"arm": {"speed_margin": 1e400}}), "expected a number"),
        (head(bench=[5]), "line 1: bench: expected a text"),
        (head(bench="part = 5"), "part: expected tables"),
        (head(greeting="yes"), "line 1: greeting: expected true or false"),
        (HEAD + "\nnonsense\n", "line 2: no JSON object"),
        (HEAD + "\n" + DEEP, "line 2: no JSON object"),
        (HEAD + '\n{"t": ' + "9" * 5000 + ', "do": "end", "with": []}', "line 2: no JSON object"),
        (HEAD + '\n{"t": 1e400, "do": "end", "with": []}', "line 2: t: expected a whole number"),
        (action("end", t=-1), "line 2: t: expected a whole number from 0"),
        (action("end", t=1 << 63), "line 2: t: expected a whole number from 0"),
        (action("end", t=True), "line 2: t: expected a whole number from 0"),
        (action("snapshot"), "line 2: do: expected one of press, release"),
        (action("end", 1), "line 2: with: expected a list of 0"),
        (action("press", {"evil": 1}), "line 2: press: expected one of @, A, B"),
        (action("press", "F1"), "line 2: press: expected one of @, A, B"),
        (action("press"), "line 2: with: expected a list of 1"),
        (action("hold", ["A"], 1e308), "line 2: hold: expected a number from 0 to 86400"),
        (action("hold", ["A"], -1), "line 2: hold: expected a number from 0 to 86400"),
        (action("hold", "A", 1), "line 2: hold: expected a list"),
        (action("type", 5, 6), "line 2: with: expected a list of 1"),
        (action("type", None), "line 2: type: expected a text"),
        (action("insert_cassette", "../A", {"hex": ""}), "expected the plain name of a cassette"),
        (action("insert_cassette", "A", "b2"), 'insert_cassette: expected {"hex": ...}'),
        (action("insert_cassette", "A"), "line 2: with: expected a list of 2"),
        (action("rewind_cassette", 1), "line 2: with: expected a list of 0"),
        (action("move_joint", "knee", 5), "line 2: move_joint: expected one of base"),
        (action("move_joint", [], 5), "line 2: move_joint: expected one of base"),
        (action("move_joint", "base", "far"), "line 2: move_joint: expected a number"),
        (action("move_to", {"pose": [1, 2, 3]}), "line 2: move_to: expected a list of 6"),
        (action("move_to", {"pose": [1, 2, 3, 4, 5, "x"]}), "line 2: move_to: expected a number"),
        (action("load_lines", [[99999, {"hex": "b2"}]]), "expected a whole number from 0 to 65529"),
        (action("load_lines", [[10, {"hex": "b"}]]), "line 2: "),
        (action("load_lines", [[10, {"hex": "b200b2"}]]), "line 2: load_lines: expected a line"),
        (action("load_lines", [[10, "b2"]]), 'line 2: load_lines: expected {"hex": ...}'),
        (action("load_lines", 7), "line 2: load_lines: expected a list of lines"),
        (action("set_bench", {"bench": "arm = 5"}), "arm: expected a table"),
        (action("end", t=9) + '\n{"t": 5, "do": "end", "with": []}', "line 3: t: expected a time"),
        (HEAD + '\n{"t": 5, "do": "reset"}', "line 2: with: expected a list"),
        (HEAD + '\n{"t": 5, "do": "reset", "with": [], "to": 1}', "line 2: to: expected nothing"),
    ],
)
def test_what_is_no_recording_is_told_with_file_and_line(
    tmp_path: Path, text: str, told: str
) -> None:
    path = tmp_path / "s.jsonl"
    path.write_text(text)
    with pytest.raises(RecordingError) as caught:
        load(path)
    assert str(caught.value).startswith(str(path))
    assert told in str(caught.value)
    assert "\n" not in str(caught.value)


@settings(max_examples=300, deadline=None)
@given(st.binary(max_size=200) | st.binary(max_size=200).map(lambda data: HEAD.encode() + data))
def test_any_bytes_are_a_recording_or_one_error(data: bytes) -> None:
    try:
        said = repr(parse(data))
    except RecordingError as error:
        said = str(error)
    assert "\n" not in said


def test_a_recording_reaches_no_file(tmp_path: Path) -> None:
    """Made on a machine with a folder of tapes and paper in a file, played on one with its own."""
    made = RigSettings(tape_folder=tmp_path / "tapes", printer_file=tmp_path / "paper.txt")
    session = Session(made)
    session.load_bytes(b'10 LPRINT "HELLO":CSAVE "A"\n')
    session.rig.type("RUN\r")
    session.rig.run_until_waiting()
    session.save_recording(tmp_path / "s.jsonl")
    assert "tapes" not in (tmp_path / "s.jsonl").read_text()
    for path in (tmp_path / "paper.txt", *(tmp_path / "tapes").iterdir()):
        path.unlink()
    other = Session(made)
    other.play(load(tmp_path / "s.jsonl"))
    while other.playing:
        other.run_for(1)
    assert other.rig.printer.text == "HELLO\n"
    assert other.rig.tape.cassettes == ["A"]
    assert not (tmp_path / "paper.txt").exists()
    assert list((tmp_path / "tapes").iterdir()) == []


def test_what_cannot_be_done_again_ends_the_recording_with_one_line() -> None:
    session = Session()
    again = parse(action("move_joint", "base", 900.0, t=5_000_000).encode())
    session.play(again)
    while session.playing:
        session.run_for(0.5)
    [fault] = session.new_faults()
    assert fault.startswith("recording: it ends here, for move_joint at 2.818 s: ")
    assert session.new_faults() == []
    session.rig.type("PRINT 7\r")
    session.rig.run_until_waiting()
    assert " 7" in session.rig.screen()


def test_a_recording_kept_on_a_disk_that_fills_ends_and_the_machine_goes_on() -> None:
    session = Session(record=Path("/dev/null"))
    journal = session._journal
    assert journal._file is not None
    journal._file.close()
    journal._path = Path("/dev/full")
    journal._file = open("/dev/full", "w", encoding="utf-8")  # noqa: SIM115
    session.rig.type("PRINT 7\r")
    session.rig.run_until_waiting()
    assert " 7" in session.rig.screen()
    [fault] = session.new_faults()
    assert fault == "recording: /dev/full: No space left on device; recording to it has ended"
    session.close()


def test_a_recording_that_cannot_be_begun_is_refused() -> None:
    with pytest.raises(OSError, match="No space") as refused:
        Session(record=Path("/dev/full"))
    assert refused.value.filename == "/dev/full"
