"""Cassettes put in, rewound and taken out; paper saved and torn off; all of it asked and told."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.desk.sitting import Sitting
from tests.machine.tape_sounds import sound_file
from trs80arm.desk.peripherals import Peripherals
from trs80arm.desk.recording import load
from trs80arm.desk.session import Session
from trs80arm.machine import cassette
from trs80arm.rig import RigSettings


@pytest.fixture
def at(sitting: Sitting) -> Peripherals:
    return Peripherals(sitting.session, sitting.person, sitting.person.say)


def test_a_program_goes_to_a_cassette_put_in_by_hand_and_back(
    sitting: Sitting, at: Peripherals
) -> None:
    sitting.answer("new", Path("TASK1"))
    at.tapes()
    assert sitting.person.told[-1] == "Cassette TASK1 is in, rewound: blank."
    sitting.type("10 PRINT 6*7", 'CSAVE "A"', "NEW")
    sitting.answer("rewind")
    at.tapes()
    sitting.type('CLOAD "A"')
    assert sitting.lines == [10]
    assert at.shelf() == [("TASK1", "program A")]
    sitting.answer("eject")
    at.tapes()
    assert sitting.session.rig.tape.cassette is None
    assert sitting.person.told[-2:] == [
        "Cassette TASK1 is rewound.",
        "Cassette TASK1 is out: CSAVE and CLOAD help themselves now.",
    ]


def test_the_list_marks_the_cassette_that_is_in(sitting: Sitting, at: Peripherals) -> None:
    at.insert("A")
    sitting.answer(None)
    at.tapes()
    question = sitting.person.asked[-1]
    assert question.now == "cassette A"
    assert [choice.label for choice in question.choices] == [
        *("Insert A", "Insert a new one", "Rewind", "Eject")
    ]


def test_a_name_that_is_none_is_refused(sitting: Sitting, at: Peripherals) -> None:
    at.insert("../A")
    assert "is no name for a cassette" in sitting.person.errors[-1]
    assert sitting.session.rig.tape.cassette is None


def test_without_a_cassette_there_is_nothing_to_rewind(sitting: Sitting, at: Peripherals) -> None:
    at.rewind()
    at.eject()
    assert sitting.person.told == ["There is no cassette in the recorder."] * 2


def test_cassettes_are_files_of_the_one_folder(tmp_path: Path) -> None:
    desk = Sitting(tmp_path, Session(RigSettings(tape_folder=tmp_path / "tapes")))
    at = Peripherals(desk.session, desk.person, desk.person.say)
    at.insert("MINE")
    desk.type("10 REM", 'CSAVE "M"')
    assert (tmp_path / "tapes" / "MINE.cas").is_file()
    (tmp_path / "tapes" / "odd.cas").write_bytes(b"\0" * 9)
    assert at.shelf() == [("MINE", "program M"), ("odd", "blank")]


def test_paper_is_torn_off_only_when_its_owner_gives_it_up(
    sitting: Sitting, at: Peripherals
) -> None:
    at.tear_off()
    assert "Nothing is printed" in sitting.person.told[-1]
    sitting.type('LPRINT "KEEP ME"')
    printer = sitting.session.rig.printer
    sitting.answer("stay")
    at.tear_off()
    assert printer.text == "KEEP ME\n"
    target = sitting.folder / "kept.txt"
    sitting.answer("save", target)
    at.tear_off()
    assert printer.text == ""
    assert target.read_text() == "KEEP ME\n"
    assert not sitting.session.keepsakes.unsaved


def test_paper_that_a_file_has_is_torn_off_without_a_question(tmp_path: Path) -> None:
    paper = tmp_path / "paper.txt"
    desk = Sitting(tmp_path, Session(RigSettings(printer_file=paper)))
    for code in b"HALF":
        desk.session.rig.printer.put(code)
    Peripherals(desk.session, desk.person, desk.person.say).tear_off()
    assert desk.session.rig.printer.text == ""
    assert paper.read_text() == "HALF"


def test_a_recording_has_the_cassette_that_was_put_in(tmp_path: Path) -> None:
    desk = Sitting(tmp_path, Session(RigSettings(tape_folder=tmp_path / "tapes")))
    at = Peripherals(desk.session, desk.person, desk.person.say)
    at.insert("A")
    desk.type("10 PRINT 7", 'CSAVE "A"', "NEW")
    at.eject()
    at.insert("A")
    desk.type("CLOAD", 'LPRINT "X"')
    desk.session.rig.tear_off_paper()
    desk.session.save_recording(tmp_path / "a.jsonl")
    again = Session()
    again.play(load(tmp_path / "a.jsonl"))
    while again.playing:
        again.run_for(1)
    assert again.program == desk.session.program
    assert again.rig.tape.content == desk.session.rig.tape.content
    assert again.rig.printer.text == ""


def test_a_tape_goes_by_in_a_hurry_but_not_its_silent_end(sitting: Sitting) -> None:
    session = sitting.session
    session.rig.load_text("10 REM")
    session.rig.type('CSAVE "A"\r')
    session.rig.run_until(lambda rig: rig.tape.running)
    assert session.hurried
    session.rig.run_until_waiting(30)
    assert not session.hurried
    session.rig.type('CLOAD "Z"\r')
    session.run_for(60)
    assert session.rig.tape.running
    assert not session.hurried


def test_the_shelf_tells_the_length_of_a_sound_and_what_is_on_the_one_that_is_in(
    tmp_path: Path,
) -> None:
    program = cassette.encode_program(ord("A"), [(10, b"\xb2 1")])
    for name in ("a.wav", "b.wav"):
        (tmp_path / name).write_bytes(sound_file(program))
    (tmp_path / "c.wav").write_bytes(b"no sound")
    desk = Sitting(tmp_path, Session(RigSettings(tape_folder=tmp_path)))
    at = Peripherals(desk.session, desk.person, desk.person.say)
    at.insert("b.wav")
    assert desk.person.told == ["Cassette b.wav is in, rewound: program A."]
    shelf = dict(at.shelf())
    assert shelf["a.wav"] == "sound of 0:05"
    assert shelf["b.wav"] == "program A"
    assert shelf["c.wav"].startswith("c.wav: no WAV file")
