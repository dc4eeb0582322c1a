"""`trs80arm run --json`: a whole run as one object."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result

from trs80arm.cli import cli


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
