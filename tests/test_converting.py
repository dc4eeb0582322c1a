"""Programs and cassettes become others, and tell what is on them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from hypothesis import given
from hypothesis import strategies as st

from tests.machine.tape_sounds import Damage, programs, sound_file
from trs80arm import converting, files
from trs80arm.cli.commands import cli
from trs80arm.files import FileFormatError
from trs80arm.machine import cassette, tape_files
from trs80arm.machine.cassette import SystemRecording

ONE = cassette.encode_program(ord("A"), [(10, b"\xb2 1"), (20, b"\xb2 2")])
OTHER = cassette.encode_program(ord("B"), [(30, b"\xb2 3")])
CODE = cassette.encode_system(SystemRecording(b"GAME  ", ((0x5000, bytes(9)),), 0x5003))
DATA = cassette.encode_data(b"1,ABC\r")
TAPE = ONE + CODE + OTHER + DATA


@pytest.fixture
def tape(tmp_path: Path) -> Path:
    path = tmp_path / "tape.cas"
    path.write_bytes(TAPE)
    return path


@pytest.mark.parametrize("suffix", [".wav", ".500", ".cas"])
def test_from_cassette_to_cassette_goes_all(tape: Path, suffix: str) -> None:
    target = tape.with_name("copy" + suffix)
    assert converting.convert(tape, target).words == "4 recordings"
    back = tape.with_name("back.cas")
    converting.convert(target, back)
    assert back.read_bytes() == TAPE


def test_a_program_becomes_sound_and_text_again(tmp_path: Path) -> None:
    source = tmp_path / "p.txt"
    source.write_text("10 PRINT 5\n20 GOTO 10\n")
    converting.convert(source, tmp_path / "p.wav")
    assert converting.convert(tmp_path / "p.wav", tmp_path / "q.txt").words == "2 lines"
    assert (tmp_path / "q.txt").read_text() == source.read_text()


def test_the_first_program_is_taken_or_the_one_that_is_named(tape: Path) -> None:
    target = tape.with_name("p.txt")
    done = converting.convert(tape, target)
    assert target.read_text() == "10 PRINT 1\n20 PRINT 2\n"
    assert done.remarks == ("program A is the first, without program B (--name takes one)",)
    converting.convert(tape, target, name="B")
    assert target.read_text() == "30 PRINT 3\n"
    with pytest.raises(FileFormatError, match="no program C on the cassette, only program A"):
        converting.convert(tape, target, name="C")


def test_a_listing_tells_every_recording_and_where_it_is(tape: Path) -> None:
    assert list(converting.listing(tape)) == [
        "byte 255   program A, 2 lines, 10 to 20",
        f"byte {len(ONE) + 255}   machine code GAME, 9 bytes from 5000H, starts at 5003H",
        f"byte {len(ONE + CODE) + 255}   program B, 1 line, 30 to 30",
        f"byte {len(ONE + CODE + OTHER) + 255}  data, 6 characters",
    ]


def test_a_listing_of_a_sound_has_its_times(tmp_path: Path) -> None:
    path = tmp_path / "tape.wav"
    path.write_bytes(sound_file(ONE + OTHER))
    first, second = converting.listing(path)
    assert first == "0:04.62  program A, 2 lines, 10 to 20"
    assert second.endswith("program B, 1 line, 30 to 30")


def test_a_damaged_recording_says_what_is_good_of_it(tmp_path: Path) -> None:
    path, target = tmp_path / "tape.wav", tmp_path / "p.txt"
    whole = sound_file(ONE)
    path.write_bytes(whole[: 44 + 2 * int(22_050 * 4.92)])
    with pytest.raises(FileFormatError) as failed:
        converting.convert(path, target)
    said = str(failed.value)
    assert said.startswith(f"{path}: program A: ")
    assert "the sound is lost at 0:04.9" in said
    assert "1 line is good (--keep-good takes it)" in said
    assert not target.exists()
    converting.convert(path, target, keep_good=True)
    assert target.read_text() == "10 PRINT 1\n"


def shifted(data: bytes, places: int) -> bytes:
    """The same bits, later by so many places: whoever read them began in the middle of a byte."""
    bits = np.concatenate(
        [np.zeros(places, np.uint8), np.unpackbits(np.frombuffer(data, np.uint8))]
    )
    return np.packbits(bits).tobytes()


@given(programs, st.integers(1, 7), st.integers(8, 255))
def test_bytes_that_begin_in_the_middle_of_others_are_found(
    content: bytes, places: int, leader: int
) -> None:
    data = shifted(content[255 - leader :], places)
    assert files.parse_program(data) == files.parse_program(content)


@pytest.mark.parametrize("content", [ONE, CODE, ONE + OTHER])
@pytest.mark.parametrize("begin", [0, 200, 255, 256])
def test_a_cassette_needs_no_leader_and_no_sync_byte(content: bytes, begin: int) -> None:
    assert tape_files.read(content[begin:]).content.lstrip(b"\0") == content.lstrip(b"\0")


def test_a_cassette_of_a_model_iii_is_told_by_name() -> None:
    with pytest.raises(FileFormatError, match="1500 baud, as a Model III"):
        tape_files.read(b"\x55" * 256 + b"\x7f\xd3\xd3\xd3A")


def test_the_command_lists_converts_and_complains(tape: Path) -> None:
    runner = CliRunner()
    listed = runner.invoke(cli, ["convert", "--list", str(tape)])
    assert listed.exit_code == 0
    assert "program B, 1 line" in listed.stdout
    done = runner.invoke(cli, ["convert", str(tape), str(tape.with_name("t.wav"))])
    assert done.stdout == f"{tape.with_name('t.wav')}: 4 recordings\n"
    assert runner.invoke(cli, ["convert", "--list", str(tape), "x.cas"]).exit_code == 2
    noise = tape.with_name("noise.wav")
    noise.write_bytes(sound_file(bytes(2) + ONE[-9:], Damage(noise=0.4)))
    failed = runner.invoke(cli, ["convert", str(noise), "x.cas"])
    assert failed.exit_code == 2
    assert failed.stderr.count("\n") == 1
    assert "noise.wav: " in failed.stderr


def test_a_program_is_not_saved_over_a_recording(tmp_path: Path) -> None:
    path = tmp_path / "old.wav"
    path.write_bytes(sound_file(ONE))
    before = path.read_bytes()
    lines = files.load_program(path)
    with pytest.raises(FileFormatError, match="is a recording of sound; save under another name"):
        files.save_program(path, lines)
    assert path.read_bytes() == before
    files.save_program(tmp_path / "new.wav", lines)
    assert files.load_program(tmp_path / "new.wav") == lines
