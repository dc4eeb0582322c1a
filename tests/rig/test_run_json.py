"""`trs80arm run --json`: a whole run as one object."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result

from trs80arm.cli.commands import cli


def run(folder: Path, program: str, *options: str, bench: str = "") -> tuple[Result, Any]:
    (folder / "p.bas").write_text(program)
    if bench:
        (folder / "p.toml").write_text(bench)
    done = CliRunner().invoke(cli, ["run", str(folder / "p.bas"), "--json", *options])
    return done, json.loads(done.stdout) if done.stdout else None


def test_the_object_is_all_that_is_printed_and_has_the_output_in_it(tmp_path: Path) -> None:
    done, told = run(tmp_path, '10 PRINT "HELLO"\n20 @STEP 50,100\n')
    assert done.exit_code == 0
    assert told["output"] == "HELLO\n"
    assert told["registers"] == told["joints"] == [100, 0, 0, 0, 0, 0]
    assert told["angles"]["base"] == pytest.approx(100 / 937.8 * 57.2958, abs=0.001)
    assert "READY" in told["screen"]
    assert told["ended"]["how"] == "end"
    assert 0 < told["seconds"]["virtual"] < 2
    assert told["seconds"]["wall"] > 0


@pytest.mark.parametrize(
    ("program", "options", "how", "line", "error", "code"),
    [
        ("10 STOP\n", (), "stop", 10, None, 0),
        ("10 X=1/0\n", (), "error", 10, "/0", 1),
        ("10 INPUT A\n", (), "input", None, None, 0),
        ("10 @SET\n", (), "set", None, None, 0),
        ("10 GOTO 10\n", ("--seconds", "1"), "limit", None, None, 0),
    ],
)
def test_how_a_run_ended(
    tmp_path: Path,
    program: str,
    options: tuple[str, ...],
    how: str,
    line: int | None,
    error: str | None,
    code: int,
) -> None:
    done, told = run(tmp_path, program, *options)
    assert done.exit_code == code
    assert told["ended"] == {"how": how, "line": line, "error": error}


PICK_UP = """
[arm]
at = [8, 0, 0.5]
pitch = -90
opening = 1
[[part]]
name = "block"
at = [8, 0]
size = [0.5, 0.5, 1.0]
weight = 4
"""


def test_parts_grip_and_margins_are_in_it(tmp_path: Path) -> None:
    program = "10 @CLOSE 100\n20 @STEP 100,0,0,0,0,0,-30\n30 @STEP 100,0,-200\n"
    _, told = run(tmp_path, program, bench=PICK_UP)
    (part,) = told["parts"]
    assert (part["name"], part["held"], part["weight"]) == ("block", True, 4.0)
    assert part["at"][2] > 1
    grip = told["grip"]
    assert grip["held"] == "block"
    assert grip["needed"] == pytest.approx(4 / 24, abs=1e-4)
    assert grip["used"] == pytest.approx(grip["needed"] / grip["force"], abs=1e-4)
    shoulder = told["motors"][1]
    assert shoulder["name"] == "shoulder"
    assert shoulder["margin"] == pytest.approx(1 - shoulder["used"], abs=1e-5)
    assert 0.85 < shoulder["peak"] < 1
    assert told["slips"] == []
    assert told["score"] is None


def test_slips_say_which_motor_when_and_why(tmp_path: Path) -> None:
    _, told = run(tmp_path, "10 @STEP 0,400\n")
    (slip,) = told["slips"]
    assert (slip["motor"], slip["reason"]) == ("base", "rate")
    assert told["slipped"][0] == slip["steps"] != 0
    assert told["joints"][0] != told["registers"][0] == 400
    assert told["motors"][0]["peak"] > 1


def test_a_bench_with_goals_has_its_score_in_it(tmp_path: Path) -> None:
    bench = PICK_UP + '[[goal]]\npart = "block"\nat = [8, 0]\ntolerance = 0.5\n'
    done, told = run(tmp_path, "10 END\n", bench=bench)
    assert done.exit_code == 0, done.stderr
    assert told["score"]["total"] == 1


def test_json_is_given_without_what_it_has_in_it(tmp_path: Path) -> None:
    done, told = run(tmp_path, "10 END\n", "--pose")
    assert (done.exit_code, told) == (2, None)
    assert done.stderr.count("\n") == 1


CELL = """
[[conveyor]]
name = "belt"
at = [8, -6]
length = 6
width = 2
speed = 1
run = 0
photocell = { bit = 2, along = -1 }
[[turntable]]
at = [8, 5]
radius = 1
drive = "pulse"
pulse = 3
[[part]]
at = [7, -6]
bottom = 1
size = [0.5, 0.5, 0.5]
"""


def test_devices_and_what_the_inputs_say_are_told(tmp_path: Path) -> None:
    program = "10 FOR I=1 TO 30:OUT 158,1:OUT 158,9:NEXT\n"
    done, told = run(tmp_path, program, bench=CELL)
    assert done.exit_code == 0
    belt, turntable = told["devices"]
    assert belt == {"name": "conveyor 'belt'", "does": "runs"}
    assert turntable["name"] == "turntable"
    assert told["sensors"] == [
        {"name": "belt photocell", "bit": 2, "bank": 0, "answers": True},
    ]


def test_a_turntable_that_slips_is_among_the_slips(tmp_path: Path) -> None:
    program = "10 OUT 158,5:FOR I=1 TO 99:OUT 158,2:OUT 158,8:OUT 158,1:OUT 158,4:NEXT\n"
    done, told = run(tmp_path, program, bench="[turntable]\nat = [8, 5]\nradius = 1\n")
    assert done.exit_code == 0
    assert {slip["motor"] for slip in told["slips"]} <= {"turntable"}
    assert told["slips"]
