"""What the screen has the line mode has: benches, hands, teaching, recordings, news at once."""

from __future__ import annotations

import io
from pathlib import Path

import pytest
from click.testing import CliRunner

from tests.own_places import PROGRAMS, own_places
from tests.test_plain import Opened, opened, talk
from trs80arm.cli.commands import cli
from trs80arm.desk.places import state_folder
from trs80arm.desk.session import Session
from trs80arm.desk.tour import STEPS
from trs80arm.machine.driver import DriverSettings
from trs80arm.plain import PlainMode
from trs80arm.plain.table import GROUPS
from trs80arm.rig import RigSettings, Waiting

__all__ = ["opened", "own_places"]


def test_no_two_commands_have_the_same_name() -> None:
    names = [command.name for group in GROUPS for command in group.commands]
    assert len(names) == len(set(names))


def test_every_command_is_in_the_help_and_explains_itself() -> None:
    for command in (command for group in GROUPS for command in group.commands):
        said = talk(".help", f".help {command.name}")
        assert f"  .{command.usage}" in said
        assert f"\n.{command.usage}: {command.help}\n" in said


def test_a_slip_is_told_when_it_happens_with_the_way_back() -> None:
    said = talk("@STEP 50,0,-3000", "PRINT 1")
    assert "* shoulder slipped" in said.partition("\n 1 \n")[0]
    assert ".recover says what is lost" in said


def test_the_effort_is_read_out_and_so_is_a_motor_near_its_limit() -> None:
    said = talk(
        ".hand elbow 0",
        ".hand pitch 0",
        ".hand shoulder 2",
        "@STEP 80,0,-60",
        ".effort",
        "@RESET",
        ".effort",
    )
    first, after = said.split("base: ")[-2:]
    assert "shoulder: 31 %, peak 92 %, standing, bears 195.1 oz in, 448.9 left" in first
    assert "grip: nothing between the fingers" in first
    assert "peak 92 %" not in after
    assert "shoulder: 52 %, peak 0 %, off" in after


def test_the_grip_is_read_out_beside_what_holding_takes() -> None:
    session = Session(bench=PROGRAMS / "table3.toml")
    said = talk("@CLOSE", "@STEP 100,0,0,0,0,0,-30", ".effort", session=session)
    line = next(line for line in said.splitlines() if line.startswith("grip: "))
    assert "lb, holding takes 0." in line


def test_the_way_back_is_that_of_the_screen() -> None:
    said = talk("@STEP 50,0,-3000", ".recover", "all", ".registers")
    assert "The joint ends there." in said
    assert "shoulder: 0, true 0\n" in said


def test_pick_ups_and_drops_are_told_as_they_happen() -> None:
    session = Session(bench=PROGRAMS / "table3.toml")
    said = talk("@CLOSE", "@STEP 60,0,-150,-150", "@STEP 60,0,0,0,0,0,400", session=session)
    news = [line for line in said.splitlines() if line.startswith("* ")]
    assert news[0] == "* part 1 in the hand"
    assert news[1].startswith("* part 1 fell 0.")


def test_the_arm_is_moved_by_hand_until_its_motors_are_on() -> None:
    said = talk(".hand base 20", ".hand 8 0 2 -90 0 1", ".hand base", ".hand ten", "@STEP 50,10")
    assert "base 20.0°" in said
    assert said.count("numbers are wanted") == 1
    assert "one figure for the joint" in said
    assert "RESET" in talk("@STEP 50,10", ".hand base 0")


def test_parts_are_listed_and_put_back() -> None:
    session = Session(bench=PROGRAMS / "table4.toml")
    said = talk(".parts", ".parts back", session=session)
    assert " oz, at X " in said
    assert "The parts are back" in said


def test_the_program_is_checked_and_a_line_of_it_listed() -> None:
    said = talk("10 GOTO 99", ".check", "1", "PRINT 1")
    assert "1 error" in said
    assert "10 error: there is no line 99 (?UL)" in said
    assert "\n10 GOTO 99\n" in said


def test_benches_are_chosen_by_name_or_from_a_list() -> None:
    said = talk(".bench tower", ".bench table", ".bench nowhere", ".bench", "1")
    assert "Bench: tower." in said
    assert said.count("Bench: table.") == 2
    assert "nowhere" in said


def test_positions_are_taught_and_made_a_program(tmp_path: Path) -> None:
    target = tmp_path / "taught.bas"
    said = talk(
        ".teach start",
        "@STEP 50,100",
        ".teach",
        "@STEP 50,0,100",
        ".teach third",
        ".move 3 1",
        ".rename 2 home",
        ".again 3",
        ".remove 3",
        f".write {target} data once",
        ".lesson steps once",
        ".remove 9",
        "LIST 10",
    )
    assert "Position 1, START, is taught." in said
    assert "1 THIRD: X" in said
    assert "2 HOME: X" in said
    assert "taught.bas is written." in said
    assert "DATA" in target.read_text()
    assert "The listing is loaded: RUN runs it." in said
    assert "Which position?" in said


def test_nothing_taught_writes_nothing(tmp_path: Path) -> None:
    said = talk(".positions", f".write {tmp_path / 'a.bas'}", ".lesson")
    assert "Nothing is taught yet" in said
    assert not (tmp_path / "a.bas").exists()


def test_what_was_done_is_recorded_and_played(tmp_path: Path) -> None:
    path = tmp_path / "a.jsonl"
    assert "Saved as a.jsonl." in talk("PRINT 6*7", f".record {path}")
    assert "\n 42 \n" in talk(f".play {path}")


def test_a_program_is_opened_with_its_bench() -> None:
    session = Session()
    talk(".open table4", session=session)
    assert session.bench_path is not None


def test_leaving_asks_about_what_is_unsaved() -> None:
    said = talk("10 REM", ".quit", "back", "PRINT 7*6", ".quit", "leave", "PRINT 1+8")
    assert said.count("is not saved") == 2
    assert "\n 42 \n" in said
    assert "\n 9 \n" not in said


def test_a_question_is_left_for_another_command() -> None:
    said = talk("10 REM", ".quit", ".pose", "PRINT 7*6")
    assert "X 5.00" in said
    assert "\n 42 \n" in said


def test_a_pipe_is_not_asked() -> None:
    out = io.StringIO()
    plain = PlainMode(Session(), out, echo=True, speed=None)
    plain.talk(iter(["10 REM\n", ".open table2\n", ".quit\n", "PRINT 7*6\n"]))
    assert "table2.bas is loaded" in out.getvalue()
    assert " 42 " not in out.getvalue()


def test_a_name_is_asked_for_and_one_that_exists_twice(tmp_path: Path) -> None:
    target = tmp_path / "a.bas"
    target.write_text("5 REM OLD\n")
    said = talk("10 REM NEW", ".save", str(target), ".", ".save", str(target), str(target))
    assert "a.bas exists" in said
    assert "Saved as a.bas." in said
    assert "NEW" in target.read_text()


@pytest.mark.parametrize("line", ['LPRINT "ON PAPER"', 'CSAVE "A"'])
def test_leaving_asks_about_cassettes_and_paper_in_memory(line: str) -> None:
    said = talk("10 REM", line, "NEW", ".quit", "back", "PRINT 7*6", ".quit", "leave", "PRINT 1+8")
    assert said.count("is in memory only") == 2
    assert "\n 42 \n" in said
    assert "\n 9 \n" not in said
    assert "Ctrl+C" not in said


def test_paper_is_saved_before_leaving(tmp_path: Path) -> None:
    talk('LPRINT "ON PAPER"', ".quit", "save", str(tmp_path / "kept"))
    assert "ON PAPER" in (tmp_path / "kept" / "paper.txt").read_text()


def test_who_ends_the_input_is_asked_and_asked_again_leaves_copies() -> None:
    said = talk('LPRINT "ON PAPER"')
    assert "is in memory only" in said
    assert "cassettes and paper are kept in" in said
    [copy] = state_folder().glob("recovered-*-tapes")
    assert "ON PAPER" in (copy / "paper.txt").read_text()


def test_who_has_nothing_unsaved_leaves_at_the_end_of_the_input() -> None:
    said = talk("PRINT 7*6")
    assert said.endswith(">\n")
    assert not state_folder().exists() or not list(state_folder().glob("recovered-*"))


@pytest.mark.parametrize(
    ("setting", "said", "line"),
    [("tape_folder", "cassette: ", 'CSAVE "A"'), ("printer_file", "printer: ", 'LPRINT "X"')],
)
def test_what_a_device_cannot_write_is_told_at_once(
    setting: str, said: str, line: str, tmp_path: Path
) -> None:
    (tmp_path / "file").write_text("")
    session = Session(RigSettings(**{setting: tmp_path / "file" / "none"}))
    told = talk("10 REM", line, "PRINT 7*6", session=session)
    assert told.index(said) < told.index("\n 42 \n")


def test_cassettes_and_paper_are_worked_in_lines(tmp_path: Path) -> None:
    target = tmp_path / "paper.txt"
    said = talk(
        *(".tapes", ".insert T1", "10 REM", 'CSAVE "A"', ".rewind", ".tapes", 'CLOAD? "A"'),
        *(".eject", ".eject", ".insert", "1", 'LPRINT "ONE":LPRINT "TWO"', ".paper", ".paper 1"),
        *(f".paper save {target}", ".tear", "throw", ".paper", ".paper x"),
    )
    assert "There are no cassettes" in said
    assert "* CSAVE on T1" in said
    assert "T1: program A" in said
    assert "* CLOAD?: program A" in said
    assert "In the recorder: T1, at 0:00 of 0:" in said
    assert "There is no cassette in the recorder." in said
    assert "\nONE\nTWO\n" in said
    assert "The last 1 of 2 lines:\nTWO\n" in said
    assert target.read_text() == "ONE\nTWO\n"
    assert "The paper is torn off." in said
    assert "How many lines, or save?" in said


def test_the_tour_is_followed_in_lines() -> None:
    said = talk(
        *(".tour", "@SET", "1:0.5", "0", "@CLOSE", "@STEP 60,0,-150,-150"),
        *(".open table4", ".run", "0", ".teach", "@STEP 50,300", ".teach"),
        *("@STEP 50,0,-3000", ".recover", "1", ".tour", "1"),
        session=Breaking(RigSettings(driver=DriverSettings(break_now=True))),
    )
    for number, step in enumerate(STEPS, 1):
        assert f"Tour {number}/{len(STEPS)}, {step.title}. {step.plain}" in said
    assert "That was the tour." in said


class Breaking(Session):
    """A sitting whose operator presses Ctrl+C when a program has picked its first part."""

    pressed = False

    def run_for(self, seconds: float) -> None:
        super().run_for(seconds)
        running = self.program and self.waiting is Waiting.NOTHING
        if running and not self.pressed and self.rig.state.held and self.rig.pose.z > 1:
            self.pressed = True
            raise KeyboardInterrupt


def test_the_command_line_begins_the_tour(opened: Opened) -> None:
    code, out, _ = opened("@SET\n", tour=True)
    assert code == 0
    assert "Tour 1/13" in out
    assert "Tour 2/13" in out


@pytest.mark.parametrize("words", [["--plain", "tour"], ["tour", "--plain"]])
def test_the_tour_in_lines_is_begun_from_the_shell(words: list[str]) -> None:
    done = CliRunner().invoke(cli, [*words, "--speed", "max"], input="@SET\n0\n")
    assert done.exit_code == 0
    assert "Tour 1/13" in done.output
    assert "Tour 2/13" in done.output


def test_sensors_are_told_with_bit_bank_and_what_they_say(tmp_path: Path) -> None:
    bench = tmp_path / "sensing.toml"
    bench.write_text(
        "[[part]]\nname='block'\nat=[8, 0]\nsize=[1, 1, 1]\n"
        "[[tactile]]\nname='plate'\nat=[8, 0]\nsize=[1, 1]\nbit=2\n"
        "[[home]]\njoint='base'\nat=5\nbit=3\n"
    )
    said = talk(".sensors", session=Session(bench=bench))
    assert "plate: bit 2, answers\nbase home: bit 3, idle\n" in said
    bench.write_text("[selector]\nbits=[0]\n[[home]]\njoint='base'\nat=-5\nbit=3\nbank=1\n")
    assert "base home: bit 3 in bank 1, answers\n" in talk(".sensors", session=Session(bench=bench))
    assert "There are no sensors." in talk(".sensors")


def test_the_score_is_told_when_a_program_ends_and_on_demand(tmp_path: Path) -> None:
    bench = tmp_path / "one.toml"
    bench.write_text(
        "[[part]]\nname='block'\nat=[8, 0]\nsize=[1, 1, 1]\n[[goal]]\npart='block'\nat=[8, 0.5]\n"
    )
    session = Session(bench=bench)
    said = talk("PRINT 1", "10 PRINT 2", "RUN", "PRINT 3", ".score", session=session)
    headline = "0 of 1 goal met; error 0.500 in on average, 0.500 in at most"
    assert said.count(f"* {headline}. .score says more.") == 1
    assert said.index(" 2") < said.index(f"* {headline}") < said.index(" 3")
    assert f"NOT  block at (8, 0.5)   0.500 in\n{headline}" in said
    assert "This bench has no goals." in talk("10 PRINT 2", "RUN", ".score")
