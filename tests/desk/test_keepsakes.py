"""Cassettes and paper that are in memory only are asked about, saved, and kept for a bad end."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.desk.sitting import NOTHING, Sitting
from trs80arm.desk.leaving import KEEPSAKES_UNSAVED, PROGRAM_UNSAVED
from trs80arm.desk.session import Session
from trs80arm.files import load_program
from trs80arm.rig import RigSettings


def record(desk: Sitting, name: str = "A") -> None:
    desk.type(f'CSAVE "{name}"')


@pytest.fixture
def with_program(sitting: Sitting) -> Sitting:
    """A sitting with a program that is saved."""
    sitting.type("10 REM MINE")
    sitting.session.save(sitting.folder / "mine.bas")
    return sitting


def test_a_machine_that_wrote_nothing_leaves_at_once(with_program: Sitting) -> None:
    with_program.leaving.leave()
    assert with_program.ended == ["left"]


def test_a_cassette_in_memory_is_asked_about(with_program: Sitting) -> None:
    record(with_program)
    with_program.answer("stay")
    with_program.leaving.leave()
    assert with_program.person.asked == [KEEPSAKES_UNSAVED]
    assert with_program.ended == []


def test_paper_in_memory_is_asked_about(sitting: Sitting) -> None:
    sitting.type('LPRINT "DEAR DIARY"')
    sitting.answer("keep", sitting.folder / "tapes")
    sitting.leaving.leave()
    assert sitting.ended == ["left"]
    assert (sitting.folder / "tapes" / "paper.txt").read_text() == "DEAR DIARY\n"


def test_a_saved_cassette_has_the_program(with_program: Sitting) -> None:
    record(with_program)
    with_program.answer("keep", with_program.folder / "tapes")
    with_program.leaving.leave()
    assert with_program.ended == ["left"]
    [(number, _)] = load_program(with_program.folder / "tapes" / "A.cas")
    assert number == 10


def test_who_gives_the_program_up_is_asked_about_the_cassette_still(sitting: Sitting) -> None:
    sitting.type("10 REM MINE")
    record(sitting)
    sitting.answer("go", "go")
    sitting.leaving.leave()
    assert sitting.person.asked == [PROGRAM_UNSAVED, KEEPSAKES_UNSAVED]
    assert sitting.ended == ["left"]


def test_what_was_saved_is_asked_about_again_when_it_has_changed(with_program: Sitting) -> None:
    record(with_program)
    with_program.answer(with_program.folder / "tapes")
    with_program.files.save_keepsakes()
    assert not with_program.session.keepsakes.unsaved
    record(with_program, "B")
    assert with_program.session.keepsakes.unsaved


def test_no_file_is_replaced_by_a_cassette(with_program: Sitting) -> None:
    (with_program.folder / "A.cas").write_bytes(b"older")
    record(with_program)
    with_program.answer(with_program.folder)
    with_program.files.save_keepsakes()
    assert (with_program.folder / "A.cas").read_bytes() == b"older"
    assert (with_program.folder / "A-2.cas").is_file()


def test_a_folder_that_cannot_be_made_is_told_and_nothing_is_lost(with_program: Sitting) -> None:
    record(with_program)
    with_program.answer("keep", with_program.folder / "mine.bas" / "tapes")
    with_program.leaving.leave()
    assert with_program.ended == []
    assert len(with_program.person.errors) == 1


def test_cassettes_in_a_folder_are_not_asked_about(tmp_path: Path) -> None:
    folder = tmp_path / "tapes"
    paper = tmp_path / "paper.txt"
    desk = Sitting(tmp_path, Session(RigSettings(tape_folder=folder, printer_file=paper)))
    desk.type("10 REM MINE")
    record(desk)
    desk.type('LPRINT "DEAR DIARY"')
    assert not desk.session.keepsakes.unsaved


def test_what_the_folder_did_not_take_is_asked_about(tmp_path: Path) -> None:
    folder = tmp_path / "tapes"
    folder.write_text("a file where a folder should be")
    desk = Sitting(tmp_path, Session(RigSettings(tape_folder=folder)))
    desk.type("10 REM MINE")
    record(desk)
    assert desk.session.keepsakes.unsaved


def test_leaving_while_asked_keeps_copies(with_program: Sitting) -> None:
    record(with_program)
    with_program.answer(NOTHING)
    with_program.leaving.leave()
    with_program.leaving.leave()
    assert with_program.ended == ["left"]
    [(_, where)] = with_program.recovery.kept()
    assert [path.name for path in where.iterdir()] == ["A.cas"]


def test_copies_go_with_what_is_saved(with_program: Sitting) -> None:
    record(with_program)
    with_program.recovery.keep()
    assert len(list(with_program.recovery.kept())) == 1
    with_program.answer(with_program.folder / "tapes")
    with_program.files.save_keepsakes()
    assert list(with_program.recovery.kept()) == []


def test_a_recording_puts_no_cassette_away_without_a_question(with_program: Sitting) -> None:
    desk = with_program
    desk.session.save_recording(desk.folder / "session.jsonl")
    record(desk)
    desk.answer(desk.folder / "session.jsonl", "stay")
    desk.files.play()
    assert "cassette A" in desk.person.asked[-1].text
    assert not desk.session.playing


@pytest.mark.parametrize(
    ("typed", "words"),
    [
        (['CSAVE "A"'], "cassette A"),
        (['CSAVE "A"', 'CSAVE "B"'], "cassettes A and B"),
        (['LPRINT "X"'], "the printer's paper"),
        (['CSAVE "A"', 'LPRINT "X"'], "cassette A and the printer's paper"),
    ],
)
def test_what_is_in_memory_is_said_in_words(
    typed: list[str], words: str, with_program: Sitting
) -> None:
    for line in typed:
        with_program.type(line)
    assert str(with_program.session.keepsakes) == words
