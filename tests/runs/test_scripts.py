"""Scripts of runs: what the operator does, and what is expected of the run."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from trs80arm.benches import bench_files
from trs80arm.cli.commands import cli
from trs80arm.operator import Hold, Operator, ScriptError
from trs80arm.rig import Key, Rig, Waiting
from trs80arm.script import read_script

BENCH = '[[part]]\nname = "cube"\nat = [0.0, 9.0]\nsize = [1.0, 1.0, 1.0]\nweight = 2.0\n'


def run(folder: Path, program: str, script: str, *options: str) -> Result:
    (folder / "p.bas").write_text(program)
    (folder / "p.run.toml").write_text(script)
    return CliRunner().invoke(cli, ["run", str(folder / "p.bas"), *options])


def test_a_script_beside_the_program_answers_and_jogs(tmp_path: Path) -> None:
    program = "10 INPUT A\n20 @SET\n30 @STEP 50,A\n40 PRINT A\n"
    script = 'inputs = ["7"]\nsets = ["0"]\n[expect]\nended = "end"\noutput = ["? 7", " 7"]\n'
    done = run(tmp_path, program, script)
    assert (done.exit_code, done.stdout, done.stderr) == (0, "? 7\n 7 \n", "")


def test_keys_are_held_at_their_times_whatever_goes_on(tmp_path: Path) -> None:
    program = '10 A$=INKEY$:IF A$="" THEN 10\n20 PRINT A$\n30 GOTO 30\n'
    script = (
        '[[keys]]\nat = 5\nhold = "BREAK"\n[[keys]]\nat = 2\nhold = "G"\n'
        '[expect]\nended = "break"\nline = 30\noutput = "G"\n'
    )
    done = run(tmp_path, program, script)
    assert (done.exit_code, done.stdout) == (0, "G\nBreak in 30\n")


def test_a_key_comes_while_the_machine_waits_for_an_answer() -> None:
    rig = Rig()
    rig.load_text("10 INPUT A\n")
    rig.type("RUN\r")
    keys = [(rig.time + 3.0, Hold((Key("BREAK"),), 0.1))]
    assert Operator(rig, keys=keys).run(10.0) is Waiting.COMMAND
    assert rig.outcome is not None
    assert rig.outcome.ending.value == "break"


def test_a_key_comes_in_the_middle_of_a_manual_mode() -> None:
    def registers(keys: list[tuple[float, Hold]]) -> int:
        rig = Rig()
        rig.load_text("10 @SET\n")
        rig.type("RUN\r")
        Operator(rig, sets=[[Hold((Key("Q"),), 4.0)]], keys=keys).run(6.0)
        return rig.registers[0]

    assert registers([(2.0, Hold((Key("1"),), 1.0))]) != registers([])


def test_an_error_that_is_expected_is_no_failure(tmp_path: Path) -> None:
    script = '[expect]\nended = "error"\nerror = "UL"\nline = 10\n'
    assert run(tmp_path, "10 GOTO 99\n", script).exit_code == 0
    assert run(tmp_path, "10 PRINT\n", script).exit_code == 1


@pytest.mark.parametrize(
    ("expected", "words"),
    [
        ('ended = "stop"', "ended: expected stop, not end in 20"),
        ("line = 10", "line: expected 10, not end in 20"),
        ('error = "SN"', "error: expected SN, not end in 20"),
        ('output = "BYE"', "output: 'BYE' is not there"),
        ('output = ["HELLO", "HELLO"]', "output: 'HELLO' is not there behind what was found"),
        ('screen = "BYE"', "screen: 'BYE' is not there"),
        ("registers = [99, 0, 0, 0, 0, 0]", "registers: expected 99 0 0 0 0 0, not 9000 0 0"),
        ("joints = [0, 0, 0, 0, 0, 0]", "joints: expected 0 0 0 0 0 0, not 8 0"),
        ("most_slips = 0", "slips: expected at most 0, not 1; "),
        ("goals = true", "goals: the bench has none"),
        ("[expect.pose]\nat = [0, 0, 0]\nwithin = 1", "the hand: expected at 0 0 0 within 1 in"),
        ('[[expect.part]]\nname = "cube"\nat = [0, 0, 0]', "cube: expected at 0 0 0 within 0.1"),
        ('[[expect.part]]\nname = "ball"\nat = [0, 0, 0]', "ball: there is no part of that name"),
        (
            '[[expect.part]]\nname = "cube"\nat = [0, 9, 0]\nwithin = 2\nheld = true',
            "cube: expected to be held",
        ),
    ],
)
def test_what_is_not_as_expected_is_one_line(tmp_path: Path, expected: str, words: str) -> None:
    (tmp_path / "p.toml").write_text(BENCH)
    program = '10 PRINT "HELLO"\n20 @STEP 10,9000\n'
    done = run(tmp_path, program, f"[expect]\n{expected}\n")
    assert done.exit_code == 1
    assert done.stdout == "HELLO\n"
    (line,) = done.stderr.splitlines()
    assert line.startswith(f"{tmp_path / 'p.bas'}: {words}")


def test_all_that_is_as_expected_is_silent(tmp_path: Path) -> None:
    (tmp_path / "p.toml").write_text(BENCH)
    script = """
    [expect]
    ended = "end"
    line = 10
    registers = [100, 0, 0, 0, 0, 0]
    joints = [100, 0, 0, 0, 0, 0]
    most_slips = 0
    screen = "READY"
    [[expect.part]]
    name = "cube"
    at = [0, 9, 0.5]
    within = 0.6
    held = false
    """
    done = run(tmp_path, "10 @STEP 50,100\n", script)
    assert (done.exit_code, done.stderr) == (0, "")


@pytest.mark.parametrize(
    ("script", "words"),
    [
        ("seconds = -1", "seconds: expected a number from 0"),
        ("second = 1", "second: expected nothing by that name"),
        ("inputs = 4", "inputs: expected a list"),
        ('sets = ["6:x"]', "sets: expected keys"),
        ("[[keys]]\nat = 1", "hold"),
        ('[[keys]]\nat = 1\nhold = "F9"', "keys[1].hold: expected keys"),
        ('[[keys]]\nat = nan\nhold = "A"', "keys[1].at: expected a number"),
        ("keys = 3", "keys: expected tables"),
        ("expect = 3", "expect: expected a table"),
        ('[expect]\nended = "well"', "expect.ended: expected one of"),
        ("[expect]\nregisters = [1]", "expect.registers: expected a list of 6"),
        ("[[expect.part]]\nat = [0, 0, 0]", "expect.part[1].name: expected a name"),
        ("[expect.pose]\nat = [0]", "expect.pose.at: expected 3 numbers"),
        ("a = ", "Invalid value"),
        ("a = 1" + "0" * 5000, ""),
        ("a = " + "[" * 5000, ""),
    ],
)
def test_a_wrong_script_is_one_line_that_names_file_and_key(
    tmp_path: Path, script: str, words: str
) -> None:
    done = run(tmp_path, "10 PRINT\n", script)
    assert done.exit_code == 2
    (line,) = done.stderr.splitlines()
    assert line.startswith(f"trs80arm: {tmp_path / 'p.run.toml'}: ")
    assert words in line


def test_a_script_that_is_no_text_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "p.run.toml"
    path.write_bytes(b"\xff\xfe")
    with pytest.raises(ScriptError, match="not a text file in UTF-8"):
        read_script(path)


def test_a_script_is_no_bench(tmp_path: Path) -> None:
    (tmp_path / "p.run.toml").write_text("")
    (tmp_path / "p.toml").write_text("")
    assert bench_files(tmp_path) == [tmp_path / "p.toml"]
