"""Files of a sitting: nothing unsaved goes without a question, and every failure is told."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.desk.sitting import Sitting
from tests.own_places import PROGRAMS
from trs80arm.desk.asking import FileQuestion, Listing, ProgramQuestion
from trs80arm.desk.files import PLAYING
from trs80arm.desk.recovery import copy_label
from trs80arm.desk.session import Session
from trs80arm.files import load_program

CLEARING: list[Callable[[Sitting], object]] = [
    lambda desk: desk.files.open(),
    lambda desk: desk.files.paste(),
    lambda desk: desk.files.play(),
]
"""What puts another program into memory, after its own question."""


def told_to(desk: Sitting, which: Callable[[Sitting], object]) -> object:
    """What is answered to the own question of one of `CLEARING`."""
    if which is CLEARING[0]:
        return desk.write("other.bas", "70 END\n")
    if which is CLEARING[1]:
        return Listing("70 END\n", at_once=True)
    other = Session()
    other.load_bytes(b"70 END\n")
    other.run_for(1)
    other.save_recording(desk.folder / "session.jsonl")
    return desk.folder / "session.jsonl"


def now_in_memory(desk: Sitting) -> list[int]:
    desk.session.run_for(2)
    return desk.lines


@pytest.mark.parametrize("clear", CLEARING)
def test_a_saved_program_goes_without_a_question(
    sitting: Sitting, clear: Callable[[Sitting], object]
) -> None:
    sitting.answer(told_to(sitting, clear))
    clear(sitting)
    assert now_in_memory(sitting) == [70]
    assert len(sitting.person.asked) == 1


@pytest.mark.parametrize("clear", CLEARING)
@pytest.mark.parametrize("answer", ["stay", None])
def test_an_unsaved_program_stays_when_its_owner_goes_back(
    sitting: Sitting, clear: Callable[[Sitting], object], answer: str | None
) -> None:
    sitting.type("10 REM MINE")
    sitting.answer(told_to(sitting, clear), answer)
    clear(sitting)
    assert now_in_memory(sitting) == [10]
    assert sitting.session.unsaved


@pytest.mark.parametrize("clear", CLEARING)
def test_an_unsaved_program_goes_when_its_owner_says_so(
    sitting: Sitting, clear: Callable[[Sitting], object]
) -> None:
    sitting.type("10 REM MINE")
    sitting.answer(told_to(sitting, clear), "go")
    clear(sitting)
    assert now_in_memory(sitting) == [70]


@pytest.mark.parametrize("clear", CLEARING)
def test_an_unsaved_program_is_saved_first_when_its_owner_wants(
    sitting: Sitting, clear: Callable[[Sitting], object]
) -> None:
    sitting.type("10 REM MINE")
    mine = sitting.folder / "mine.bas"
    sitting.answer(told_to(sitting, clear), "save", mine)
    clear(sitting)
    assert mine.read_text() == "10 REM MINE\n"
    assert now_in_memory(sitting) == [70]


@pytest.mark.parametrize("clear", CLEARING)
def test_a_save_that_fails_keeps_the_program_that_was_to_go(
    sitting: Sitting, clear: Callable[[Sitting], object]
) -> None:
    sitting.type("10 REM MINE")
    sitting.answer(told_to(sitting, clear), "save", sitting.folder / "nowhere" / "mine.bas")
    clear(sitting)
    assert now_in_memory(sitting) == [10]
    assert "No such file or directory" in sitting.person.errors[0]


def test_a_program_is_opened_with_the_bench_beside_it(sitting: Sitting) -> None:
    path = sitting.write("task.bas", "10 END\n")
    part = '[[part]]\nname = "cube"\nsize = [1, 1, 1]\nat = [8, 2]\nweight = 2\n'
    sitting.write("task.toml", part)
    sitting.files.load_file(path)
    assert sitting.person.errors == []
    assert sitting.session.path == path
    assert list(sitting.session.rig.arm.bench.parts) == ["cube"]
    assert sitting.person.told == ["task.bas and its bench are loaded: F5 or RUN runs it."]
    assert sitting.recent.all() == [path]


def test_a_bench_that_cannot_be_set_up_is_told_with_its_line(sitting: Sitting) -> None:
    path = sitting.write("task.bas", "10 END\n")
    sitting.write("task.toml", "[[part]]\nnonsense = 1\n")
    sitting.files.load_file(path)
    [error] = sitting.person.errors
    assert "task.toml" in error
    assert "\n" not in error


@pytest.mark.parametrize(
    ("content", "said"),
    [(None, "No such file or directory"), (b"\xff\x00\x01", "task.bas"), (b"no program\n", "task")],
)
def test_a_file_that_is_no_program_is_told_and_changes_nothing(
    sitting: Sitting, content: bytes | None, said: str
) -> None:
    sitting.type("10 REM MINE")
    path = sitting.folder / "task.bas"
    if content is not None:
        path.write_bytes(content)
    sitting.files.load_file(path)
    [error] = sitting.person.errors
    assert said in error
    assert sitting.lines == [10]
    assert sitting.recent.all() == []


def test_opening_offers_recovered_recent_and_own_programs(sitting: Sitting) -> None:
    recent = sitting.write("recent.bas", "10 END\n")
    sitting.recent.add(recent)
    left = sitting.state / "recovered-20200101-000000-9.bas"
    left.write_text("10 REM LOST\n")
    sitting.answer(None)
    sitting.files.open()
    [question] = sitting.person.asked
    assert isinstance(question, ProgramQuestion)
    shelves = {shelf.title: list(shelf.files) for shelf in (*question.shelves, *question.below)}
    assert shelves["Recovered"] == [left]
    assert shelves["Recent"] == [recent]
    assert "table4.bas" in [path.name for path in shelves["Coming along"]]


def test_a_recovered_program_is_unsaved_and_its_copy_becomes_the_sittings_own(
    sitting: Sitting,
) -> None:
    sitting.state.mkdir()
    left = sitting.state / "recovered-20200101-000000-9.bas"
    left.write_text("10 REM LOST\n")
    sitting.files.load_file(left)
    assert sitting.session.unsaved
    assert sitting.session.path is None
    assert not left.exists()
    assert load_program(sitting.recovery.program_copy) == list(sitting.session.program)


def test_a_recovered_copy_that_is_damaged_is_told_and_stays(sitting: Sitting) -> None:
    sitting.state.mkdir()
    left = sitting.state / "recovered-20200101-000000-9.bas"
    left.write_bytes(b"\xff\x01")
    sitting.files.load_file(left)
    [error] = sitting.person.errors
    assert left.name in error
    assert left.exists()


def test_a_recovered_copy_that_is_gone_is_told(
    sitting: Sitting, monkeypatch: pytest.MonkeyPatch
) -> None:
    left = sitting.state / "recovered-20200101-000000-9.bas"
    monkeypatch.setattr(sitting.recovery, "left_over", lambda: [left])
    sitting.files.load_file(left)
    assert sitting.person.errors == [f"{left}: No such file or directory"]


def test_a_new_program_is_proposed_a_name_and_saved_as_text(sitting: Sitting) -> None:
    sitting.type("10 PRINT 1")
    path = sitting.folder / "new.bas"
    sitting.answer(path)
    sitting.files.save()
    [question] = sitting.person.asked
    assert isinstance(question, FileQuestion)
    assert (question.proposal, question.to_write, question.own) == ("program.bas", True, None)
    assert path.read_text() == "10 PRINT 1\n"
    assert sitting.person.told == ["Saved as new.bas."]
    sitting.answer(path)
    sitting.files.save()
    assert sitting.person.asked[1].own == path


def test_a_program_that_comes_along_is_saved_elsewhere_unless_its_user_says_otherwise(
    sitting: Sitting,
) -> None:
    sitting.files.load_file(PROGRAMS / "table4.bas")
    sitting.answer(sitting.folder / "mine.bas")
    sitting.files.save()
    [question] = sitting.person.asked
    assert isinstance(question, FileQuestion)
    assert question.proposal == "table4.bas"
    assert question.own is None
    assert (sitting.folder / "mine.bas").read_bytes() == (PROGRAMS / "table4.bas").read_bytes()


def test_there_is_nothing_to_save_in_an_empty_memory(sitting: Sitting) -> None:
    sitting.files.save()
    assert sitting.person.asked == []
    assert sitting.person.told == ["There is no program in memory."]


def test_saving_removes_the_copy_that_a_crash_would_have_needed(sitting: Sitting) -> None:
    sitting.type("10 PRINT 1")
    assert sitting.recovery.keep()
    assert sitting.recovery.program_copy.is_file()
    sitting.files.save_as(sitting.folder / "mine.bas")
    assert not sitting.recovery.program_copy.exists()


def test_a_program_that_no_text_can_hold_is_told(sitting: Sitting) -> None:
    sitting.session.rig.load_lines([(10, b"A\rB")])
    assert not sitting.files.save_as(sitting.folder / "odd.txt")
    [error] = sitting.person.errors
    assert error.startswith("odd.txt: ")
    assert sitting.session.unsaved


def test_a_pasted_listing_is_typed_at_the_machines_pace(sitting: Sitting) -> None:
    sitting.answer(Listing("10 REM A\n20 REM B", at_once=False))
    sitting.files.paste()
    assert sitting.person.told == ["Typing 18 characters; Escape stops it."]
    assert sitting.lines == []
    sitting.session.rig.run_until_waiting(60)
    assert sitting.lines == [10, 20]


def test_a_paste_of_program_lines_is_entered_at_once_as_if_typed(sitting: Sitting) -> None:
    sitting.type('10 PRINT "OLD"', "20 GOTO 10", "30 REM KEPT", "40 REM GOES")
    before = sitting.session.time
    sitting.files.take_paste('10 print "new"\r\n20 end\r\n\r\n40\r\n50 rem\r\n')
    assert sitting.session.time == before
    assert sitting.lines == [10, 20, 30, 50]
    assert sitting.person.told == ["4 lines are entered at once; Ctrl+V can have them typed."]
    sitting.type("RUN")
    assert "NEW" in "".join(sitting.session.rig.screen())
    assert sitting.session.unsaved


def test_what_follows_a_pasted_listing_is_typed(sitting: Sitting) -> None:
    sitting.files.take_paste("10 PRINT 6*7\n\nRUN")
    assert sitting.lines == [10]
    sitting.session.rig.run_until_waiting(10)
    assert " 42" in sitting.session.rig.screen()


@pytest.mark.parametrize("text", ["PRINT 1\n", "10 PRINT 1", "HELLO\n10 END\n", "70000 END\n20\n"])
def test_any_other_paste_is_typed(sitting: Sitting, text: str) -> None:
    sitting.files.take_paste(text)
    assert sitting.session.rig.to_type == len(text)
    assert sitting.person.told == [f"Typing {len(text)} characters; Escape stops it."]


def test_a_paste_while_a_program_asks_is_typed(sitting: Sitting) -> None:
    sitting.type("10 INPUT A:PRINT 2*A")
    sitting.session.rig.type("RUN\r")
    sitting.session.rig.run_until_waiting(10)
    sitting.files.take_paste("21\n")
    sitting.session.rig.run_until_waiting(10)
    assert " 42" in sitting.session.rig.screen()
    assert sitting.lines == [10]


def test_a_listing_that_is_no_program_is_told(sitting: Sitting) -> None:
    assert not sitting.files.load_listing("HELLO\n")
    [error] = sitting.person.errors
    assert error.startswith("No program: ")


def test_a_recording_is_saved_and_played_again(sitting: Sitting) -> None:
    sitting.type("10 REM MINE", "PRINT 2*21")
    path = sitting.folder / "session.jsonl"
    sitting.answer(path)
    sitting.files.save_recording()
    end = sitting.session.time
    again = Sitting(sitting.folder)
    machines = []
    again.session.watch_machine(lambda: machines.append(again.session.rig))
    again.files.play_file(path)
    assert again.person.told == [PLAYING]
    assert machines == [again.session.rig]
    while again.session.playing:
        again.session.run_for(0.5)
    assert again.session.time >= end
    assert again.lines == [10]
    assert again.session.rig.screen() == sitting.session.rig.screen()


@pytest.mark.parametrize(
    ("name", "said"), [("none.jsonl", "No such file"), ("bad.jsonl", "line 1")]
)
def test_what_is_no_recording_is_told_and_the_machine_stays(
    sitting: Sitting, name: str, said: str
) -> None:
    sitting.write("bad.jsonl", "{}\n")
    rig = sitting.session.rig
    sitting.files.play_file(sitting.folder / name)
    [error] = sitting.person.errors
    assert said in error
    assert sitting.session.rig is rig


@pytest.mark.parametrize("save", ["recording", "content"])
def test_a_file_that_cannot_be_written_is_told(sitting: Sitting, save: str) -> None:
    path = sitting.folder / "nowhere" / "file"
    sitting.answer(path)
    if save == "recording":
        sitting.files.save_recording()
    else:
        sitting.files.save_content(FileQuestion("Save", "", "x", to_write=True), b"x")
    assert sitting.person.errors == [f"{path}: No such file or directory"]
    assert sitting.person.told == []


def test_a_file_that_can_be_is_written_whole(sitting: Sitting) -> None:
    path = sitting.folder / "screen.txt"
    sitting.answer(path)
    sitting.files.save_content(FileQuestion("Save", "", "x", to_write=True), b"READY\n")
    assert path.read_bytes() == b"READY\n"
    assert sitting.person.told == ["Saved as screen.txt."]


def test_recent_files_forget_what_is_gone_and_survive_nonsense(sitting: Sitting) -> None:
    paths = [sitting.write(f"{number}.bas", "10 END\n") for number in range(3)]
    for path in paths:
        sitting.recent.add(path)
    paths[1].unlink()
    assert sitting.recent.all() == [paths[2], paths[0]]
    for nonsense in ("{", '{"a": 1}', '[1, null, "/none"]'):
        (sitting.state / "recent.json").write_text(nonsense)
        assert sitting.recent.all() == []


def test_a_state_folder_that_cannot_be_written_is_no_trouble_for_opening(tmp_path: Path) -> None:
    (tmp_path / "state").write_text("a file where a folder should be")
    desk = Sitting(tmp_path)
    path = desk.write("a.bas", "10 END\n")
    desk.files.load_file(path)
    assert desk.lines == [10]
    assert desk.person.errors == []


def leave_copies(desk: Sitting, count: int) -> list[Path]:
    """Copies that sittings that ended badly have left, newest first."""
    desk.state.mkdir(exist_ok=True)
    paths = [desk.state / f"recovered-202601{day:02}-093000-7.bas" for day in range(1, count + 1)]
    for path in paths:
        path.write_text("10 REM LOST\n")
    return paths[::-1]


def test_recovered_copies_have_dates_and_do_not_push_programs_off_the_list(
    sitting: Sitting,
) -> None:
    paths = leave_copies(sitting, 9)
    sitting.answer(None)
    sitting.files.open()
    shelf = sitting.person.asked[0].shelves[0]
    assert shelf.title == "Recovered, the newest of 9"
    assert shelf.entries("") == [
        (path, f"2026-01-0{day} 09:30  recovered program")
        for path, day in zip(paths[:3], (9, 8, 7), strict=True)
    ]
    assert len(shelf.entries("2026-01")) == 9
    shelf.discard(paths[0])
    assert sitting.recovery.left_over() == paths[1:]


def test_a_copy_of_positions_says_so() -> None:
    path = Path("recovered-20260102-093000-7-taught.bas")
    assert copy_label(path) == "2026-01-02 09:30  recovered positions"
    assert copy_label(Path("recovered-odd.bas")) == "recovered-odd.bas"


@pytest.mark.parametrize(("answer", "left"), [("go", 0), ("stay", 4), (None, 4)])
def test_all_recovered_copies_are_removed_when_their_owner_says_so(
    sitting: Sitting, answer: str | None, left: int
) -> None:
    leave_copies(sitting, 4)
    sitting.answer(answer)
    sitting.files.discard_recovered()
    assert "4 recovered programs, the oldest of 2026-01-01 09:30" in sitting.person.asked[0].text
    assert len(sitting.recovery.left_over()) == left


def test_without_recovered_copies_nothing_is_asked(sitting: Sitting) -> None:
    sitting.files.discard_recovered()
    assert sitting.person.told == ["There are no recovered programs."]


def test_only_recovered_copies_can_be_discarded(sitting: Sitting) -> None:
    path = sitting.write("mine.bas", "10 END\n")
    sitting.recovery.discard(path)
    assert path.exists()


def test_a_cassette_of_machine_code_is_put_in_and_it_is_told_how_it_is_loaded(
    sitting: Sitting,
) -> None:
    sitting.type("10 REM MINE")
    sitting.files.load_file(PROGRAMS / "catch.cas")
    assert sitting.person.told[-1].startswith("Cassette catch is in: SYSTEM, then CATCH, loads it")
    assert sitting.lines == [10]
    assert not sitting.session.keepsakes.unsaved
    sitting.type("SYSTEM")
    sitting.type("CATCH")
    sitting.session.run_for(30)
    lines = [line for line in sitting.session.rig.screen() if line]
    assert lines[-2].startswith("*? CATCH")
    assert lines[-1].startswith("*? ")


def test_machine_code_stands_behind_the_programs_that_come_along(sitting: Sitting) -> None:
    sitting.answer(None)
    sitting.files.open()
    question = sitting.person.asked[-1]
    assert isinstance(question, ProgramQuestion)
    programs, tapes = question.below
    assert {path.suffix for path in programs.files} == {".bas"}
    assert {path.suffix for path in tapes.files} == {".cas"}
