from __future__ import annotations

import os
import pickle
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trs80arm.machine import cassette
from trs80arm.machine.tape import BadCassetteName, Tape

BEHIND_SYNC = len(cassette.LEADER) + 1


def record(tape: Tape, content: bytes) -> None:
    tape.start_writing()
    for value in content:
        tape.write(value)
    tape.stop()


def program(name: str, text: bytes = b"\x81") -> bytes:
    return cassette.encode_program(ord(name), [(10, text)])


def play(tape: Tape) -> bytes | None:
    """The recording that comes next, without its leader; None at the end of all tape."""
    tape.start_reading()
    if not tape.find_sync():
        tape.stop()
        return None
    heard = bytearray()
    while (value := tape.read()) is not None:
        heard.append(value)
    tape.stop()
    return bytes(heard)


def names_heard(tape: Tape) -> str:
    """The names of the programs that one play of the recorder meets, in order."""
    tape.start_reading()
    names = ""
    while tape.find_sync():
        header = [tape.read() for _ in range(4)]
        if header[:3] == [0xD3] * 3:
            names += chr(header[3] or 0)
    tape.stop()
    return names


@pytest.fixture(params=["memory", "folder"])
def tape(request: pytest.FixtureRequest, tmp_path: Path) -> Tape:
    return Tape(tmp_path if request.param == "folder" else None)


def test_what_was_saved_is_loaded_next(tape: Tape) -> None:
    record(tape, program("A"))
    assert play(tape) == program("A")[BEHIND_SYNC:]


def test_csave_makes_a_cassette_of_the_programs_name(tmp_path: Path) -> None:
    record(Tape(tmp_path), program("A"))
    assert (tmp_path / "A.cas").read_bytes() == program("A")


def test_csave_of_the_same_name_replaces_it_and_keeps_the_old_one(tmp_path: Path) -> None:
    tape = Tape(tmp_path)
    record(tape, program("A", b"\x81"))
    record(tape, program("A", b"\x82"))
    assert (tmp_path / "A.cas").read_bytes() == program("A", b"\x82")
    assert (tmp_path / "A.cas~").read_bytes() == program("A", b"\x81")


def test_cload_hears_all_programs_of_the_folder(tmp_path: Path) -> None:
    for name in "BAC":
        record(Tape(tmp_path), program(name))
    assert names_heard(Tape(tmp_path)) == "ABC"


def test_each_cassette_is_heard_on_from_where_it_stands_and_once_more(tape: Tape) -> None:
    for name in "ABC":
        record(tape, program(name))
    assert names_heard(tape) == "CABC"


def test_no_tape_at_all_is_silent(tape: Tape) -> None:
    tape.start_reading()
    assert not tape.find_sync()
    assert tape.read() is None


def test_data_records_come_back_in_the_order_they_were_written(tape: Tape) -> None:
    for text in (b"1\r", b"2\r", b"3\r"):
        record(tape, cassette.encode_data(text))
    heard = []
    for _ in range(3):
        tape.start_reading()
        assert tape.find_sync()
        heard.append(tape.read())
        assert tape.read() == 13
        tape.stop()
    assert bytes(value or 0 for value in heard) == b"123"


def test_data_is_recorded_behind_older_data(tmp_path: Path) -> None:
    record(Tape(tmp_path), cassette.encode_data(b"OLD\r"))
    tape = Tape(tmp_path)
    record(tape, cassette.encode_data(b"NEW\r"))
    assert play(tape) == b"NEW\r"
    old, new = cassette.parse((tmp_path / "data.cas").read_bytes())
    assert old == cassette.DataRecording(b"OLD\r")
    assert new == cassette.DataRecording(b"NEW\r")


def test_a_cassette_put_in_by_hand_takes_everything(tape: Tape) -> None:
    tape.insert("mine")
    record(tape, program("A"))
    record(tape, program("A"))
    record(tape, cassette.encode_data(b"5\r"))
    assert tape.cassettes == ["mine"]
    tape.rewind()
    assert names_heard(tape) == "AA"


def test_a_cassette_put_in_by_hand_is_the_only_one_heard(tape: Tape) -> None:
    record(tape, program("A"))
    tape.insert("new.cas")
    assert tape.cassette == "new"
    assert play(tape) is None
    tape.eject()
    assert names_heard(tape) == "A"


def test_a_tape_at_its_end_begins_again(tape: Tape) -> None:
    tape.insert("mine")
    record(tape, program("A"))
    assert play(tape) == play(tape)


def test_the_position_moves_as_the_tape_plays(tape: Tape) -> None:
    tape.insert("mine")
    record(tape, program("A"))
    assert tape.position == tape.length == len(program("A"))
    tape.rewind()
    tape.start_reading()
    tape.find_sync()
    assert tape.position == BEHIND_SYNC


@pytest.mark.parametrize(
    "name",
    [
        "",
        "../out",
        "a/b",
        "a\\b",
        ".hidden",
        "/etc/passwd",
        "..",
        "con",
        "NUL.x",
        "a\0",
        "A~",
        "C:x",
    ],
)
def test_no_name_leads_out_of_the_folder(tmp_path: Path, name: str) -> None:
    with pytest.raises(BadCassetteName):
        Tape(tmp_path).insert(name)


@given(st.integers(0, 255))
def test_any_name_byte_gives_a_cassette(code: int) -> None:
    tape = Tape()
    record(tape, cassette.encode_program(code, [(1, b"A")]))
    assert len(tape.cassettes) == 1
    tape.insert(tape.cassettes[0])


def test_a_link_out_of_the_folder_is_not_followed(tmp_path: Path) -> None:
    folder, outside = tmp_path / "tapes", tmp_path / "A.cas"
    folder.mkdir()
    outside.write_bytes(program("A"))
    (folder / "A.cas").symlink_to(outside)
    tape = Tape(folder)
    assert tape.cassettes == []
    record(tape, program("A", b"\x82"))
    assert outside.read_bytes() == program("A")
    assert tape.fault is not None


def test_a_recording_that_cannot_be_written_is_kept_in_the_recorder(tmp_path: Path) -> None:
    blocked = tmp_path / "tapes"
    blocked.write_text("no folder")
    tape = Tape(blocked)
    record(tape, program("A"))
    assert tape.fault is not None
    assert play(tape) == program("A")[BEHIND_SYNC:]


def test_a_folder_is_made_with_the_first_recording(tmp_path: Path) -> None:
    tape = Tape(tmp_path / "tapes")
    assert not (tmp_path / "tapes").exists()
    record(tape, program("A"))
    assert os.listdir(tmp_path / "tapes") == ["A.cas"]


def test_starting_without_recording_leaves_the_tape_alone(tape: Tape) -> None:
    record(tape, b"")
    assert tape.cassettes == []


def test_a_pickled_recorder_goes_on_recording(tape: Tape) -> None:
    tape.start_writing()
    for value in program("A")[:100]:
        tape.write(value)
    copy = pickle.loads(pickle.dumps(tape))
    for value in program("A")[100:]:
        copy.write(value)
    copy.stop()
    assert play(copy) == program("A")[BEHIND_SYNC:]


@pytest.mark.parametrize("file", ["Game (1979).cas", "GAME.CAS"])
def test_cassettes_from_elsewhere_may_have_other_names(tmp_path: Path, file: str) -> None:
    (tmp_path / file).write_bytes(program("G"))
    tape = Tape(tmp_path)
    assert names_heard(tape) == "G"
    tape.insert(file)
    record(tape, program("H"))
    assert os.listdir(tmp_path) == [file]
    assert (tmp_path / file).read_bytes() == program("G") + program("H")
