"""`trs80arm sweep`: the grid, its errors in placing, what is told."""

from __future__ import annotations

import csv
import io
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result

from trs80arm.cli.commands import cli
from trs80arm.files import parse_program
from trs80arm.rig import RigSettings
from trs80arm.sweep.axes import Axis
from trs80arm.sweep.journal import Journal, mark
from trs80arm.sweep.placing import placed
from trs80arm.sweep.running import Case, Plan, run_all, run_case

KINDS = ("basic", "toml")
TURN = '10 D=50\n20 @STEP D,150\n30 PRINT "DONE"\n'
BENCH = """
[[part]]
name = "block"
at = [8, 0]
size = [0.5, 0.5, 1.0]
[[part]]
at = [8, 3]
size = [0.5, 0.5, 1.0]
[[goal]]
part = "block"
at = [8, 0]
tolerance = 0.1
"""


def sweep(folder: Path, *options: str, program: str = TURN, bench: str = "") -> Result:
    (folder / "p.bas").write_text(program)
    if bench:
        (folder / "p.toml").write_text(bench)
    return CliRunner().invoke(cli, ["sweep", str(folder / "p.bas"), "--jobs", "1", *options])


def rows(path: Path) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(path.read_text())))


def test_too_fast_a_motor_slips_and_the_table_says_so(tmp_path: Path) -> None:
    out = tmp_path / "runs.csv"
    done = sweep(tmp_path, "--vary", "D=0,60", "-o", str(out))
    assert done.exit_code == 0, done.stderr
    slow, fast = done.stdout.splitlines()[-1].split(), done.stdout.splitlines()[-2].split()
    assert (fast, slow) == (["0", "0", "%", "1", "1"], ["60", "100", "%", "1", "0"])
    fast_run, slow_run = rows(out)
    assert (fast_run["D"], fast_run["success"], fast_run["ended"]) == ("0", "0", "end")
    assert int(fast_run["lost_half_steps"]) > 0 == int(slow_run["slips"])


def test_goals_of_the_bench_are_what_a_run_is_for(tmp_path: Path) -> None:
    out = tmp_path / "runs.csv"
    done = sweep(tmp_path, "--vary", "block.dx=0,0.5", "-o", str(out), bench=BENCH)
    assert done.exit_code == 0, done.stderr
    assert [(row["success"], row["goals_met"], row["off"]) for row in rows(out)] == [
        ("1", "1", "0.0000"),
        ("0", "0", "0.5000"),
    ]


def test_two_things_varied_are_rows_and_columns_of_the_table_and_curves(tmp_path: Path) -> None:
    chart = tmp_path / "chart.svg"
    done = sweep(tmp_path, "--vary", "D=0,60", "--vary", "weight=1,8", "--plot", str(chart))
    assert done.exit_code == 0, done.stderr
    assert r"D \ weight" in done.stdout
    drawn = chart.read_text()
    assert "weight = 8" in drawn
    # Both are seen where they coincide.
    widths = {float(width) for width in re.findall(r"stroke-width: ([\d.]+); stroke-line", drawn)}
    assert {1.6, 3.0} <= widths


def test_the_seed_and_nothing_else_decides_the_errors(tmp_path: Path) -> None:
    told = []
    for seed in ("7", "7", "8"):
        out = tmp_path / f"{len(told)}.csv"
        options = ("--vary", "D=60", "--noise", "0.1", "--runs", "3", "--seed", seed)
        assert sweep(tmp_path, *options, "-o", str(out), bench=BENCH).exit_code == 0
        told.append(out.read_text())
    assert told[0] == told[1] != told[2]
    found = rows(tmp_path / "0.csv")
    assert len({row["off"] for row in found}) == 3
    assert {row["seed"] for row in found} == {"7"}


def test_a_run_has_the_same_errors_in_every_cell(tmp_path: Path) -> None:
    out = tmp_path / "runs.csv"
    options = ("--vary", "noise=0.1,0.2", "--vary", "D=50,60", "-o", str(out))
    assert sweep(tmp_path, *options, bench=BENCH).exit_code == 0
    offs = [float(row["off"]) for row in rows(out)]
    assert offs[0] == offs[1] == pytest.approx(offs[2] / 2, abs=1e-4)
    assert offs[2] == offs[3]


def test_parts_that_would_stand_in_one_another_are_drawn_again() -> None:
    near: dict[str, Any] = {
        "part": [{"at": [8 + 0.6 * place, 0], "size": [0.5, 0.5, 0.5]} for place in range(3)]
    }
    for run in range(20):
        assert len(placed("bench", near, 0.1, 1, run).parts) == 3


def test_other_processes_find_the_same() -> None:
    lines = tuple(parse_program(TURN.encode()))
    plan = Plan(lines, "bench", {"part": [{"name": "block", "at": [8, 0]}]}, noise=0.05)
    plan.bench["part"][0]["size"] = [0.5, 0.5, 0.5]
    axes = [Axis("D", (50.0,))]
    each = [Case((50.0,), run, RigSettings()) for run in (1, 2, 3)]
    assert list(run_all(plan, axes, each, 2)) == list(run_all(plan, axes, each, 1))


def test_a_sweep_that_was_broken_off_goes_on_where_it_was(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    options = ("--vary", "D=0,40,60", "--noise", "0.05", "-o", str(tmp_path / "runs.csv"))
    assert sweep(tmp_path, *options).exit_code == 0
    whole = (tmp_path / "runs.csv").read_bytes()
    (tmp_path / "runs.csv").unlink()
    done: list[Case] = []

    def tired(plan: Plan, axes: list[Axis], case: Case) -> object:
        if len(done) == 2:
            raise KeyboardInterrupt
        done.append(case)
        return run_case(plan, axes, case)

    with monkeypatch.context() as patched:
        patched.setattr("trs80arm.sweep.running.run_case", tired)
        broken = sweep(tmp_path, *options)
    assert broken.exit_code != 0
    assert "2 of 3 runs are in" in broken.stderr
    assert not (tmp_path / "runs.csv").exists()
    monkeypatch.setattr("trs80arm.sweep.running.run_case", tired)
    done.pop()
    again = sweep(tmp_path, *options)
    assert again.stderr == "trs80arm: 2 of 3 runs were done before\n"
    assert (tmp_path / "runs.csv").read_bytes() == whole
    assert not (tmp_path / "runs.csv.part").exists()


@pytest.mark.parametrize(
    "change", ["other options", "another program", "damaged", "half a line", "a run too many"]
)
def test_runs_of_another_sweep_and_damaged_ones_are_done_anew(tmp_path: Path, change: str) -> None:
    out, part = tmp_path / "runs.csv", tmp_path / "runs.csv.part"
    (tmp_path / "p.bas").write_text(TURN)
    axes = [Axis("D", (60.0,))]
    plan = Plan(tuple(parse_program(TURN.encode())), "the standard bench", {}, no_slip=True)
    each = [Case((60.0,), 1, RigSettings()), Case((60.0,), 2, RigSettings())]
    with Journal(out, mark(plan, axes, each), each).keep(iter(())) as kept:
        assert not list(kept)
        first = part.read_text()
    lie = run_case(plan, axes, each[0])
    with Journal(out, mark(plan, axes, each), each).keep([replace(lie, slips=99)]) as kept:
        assert len(list(kept)) == 1
        line = part.read_text().removeprefix(first)
    contents = {
        "other options": first.replace(first[:8], "00000000") + line,
        "another program": first + line,
        "damaged": first + '{"slips": "many"}\n',
        "half a line": first + line[:40],
        "a run too many": first + 3 * line,
    }
    part.write_text(contents[change])
    found = Journal(out, mark(plan, axes, each), each).results
    if change == "another program":
        part.write_text(contents[change])
        other = replace(plan, lines=tuple(parse_program(b"10 D=50\n")))
        assert not Journal(out, mark(other, axes, each), each).results
        assert [each.slips for each in found] == [99]
    else:
        assert len(found) == (change == "a run too many")


def test_an_expectation_has_to_be_printed(tmp_path: Path) -> None:
    done = sweep(tmp_path, "--vary", "D=60", "--expect", "DONE")
    assert "100 %" in done.stdout
    assert " 0 %" in sweep(tmp_path, "--vary", "D=60", "--expect", "OVER").stdout


def test_settings_can_be_varied(tmp_path: Path) -> None:
    done = sweep(tmp_path, "--vary", "machine.ram=16,48", "--expect", "DONE")
    assert done.stdout.count("100 %") == 2, done.stderr


def test_a_question_that_nobody_answers_is_a_failure_and_told(tmp_path: Path) -> None:
    program = "10 D=1\n20 INPUT A\n"
    done = sweep(tmp_path, "--vary", "D=1,2", program=program)
    assert "2 of 2 runs stopped at an INPUT that no --input answers" in done.stderr
    done = sweep(tmp_path, "--vary", "D=1,2", "--input", "5", program=program)
    assert (done.stdout.count("100 %"), done.stderr) == (2, "")


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--vary", "D"), "must be NAME="),
        (("--vary", "Z=1"), "no line gives Z"),
        (("--vary", "D=1", "--vary", "10#1=2"), "are one number"),
        (("--vary", "10-10#1=2", "--vary", "D=1"), "are one number"),
        (("--vary", "D=1", "--vary", "D=2"), "given twice"),
        (("--vary", "cup.weight=2"), "no such part"),
        (("--vary", "weight=-1"), "weight"),
        (("--vary", "dy=3"), "overlaps"),
        (("--vary", "arm.nothing=1"), "unknown key"),
        (("--vary", "machine.ram=5"), "ram must be"),
        (("--vary", "D=1", "--plot", "x.doc"), "saved as one of"),
        (("--vary", "D=1", "--vary", "dx=0", "--vary", "noise=0", "--plot", "x.svg"), "one or two"),
        (("--vary", "D=1", "--bench", "no-such.toml"), "cannot be read"),
        (("--vary", "D=1", "-o", "no/such/folder.csv"), "no/such"),
        (("--vary", "D=1", "--set", "?:1"), "KEYS"),
        (("--vary", "noise=-1"), "noise"),
    ],
)
def test_wrong_values_are_one_line(tmp_path: Path, options: tuple[str, ...], said: str) -> None:
    bench = BENCH.replace("[8, 3]", "[8, 0.6]")
    if "dy=3" in options:
        options = ("--vary", "block.dy=0.5")
    done = sweep(tmp_path, *options, bench=bench)
    assert (done.exit_code, done.stdout) == (2, ""), done.output
    assert said in done.stderr
    assert done.stderr.count("\n") == 1


def test_the_example_of_the_page_prints_what_the_page_says(tmp_path: Path) -> None:
    page = (Path(__file__).parents[2] / "docs/sweeps.md").read_text(encoding="utf-8")
    program, bench = (re.findall(rf"```{kind}\n(.*?)```", page, re.DOTALL)[0] for kind in KINDS)
    (line,) = re.findall(r"^\$ trs80arm sweep lift.bas (.*)$", page, re.MULTILINE)
    # Of the page's table two cells, one run each; all of it would take a minute.
    for part, less in (("D=20:140:20", "D=40,60"), ("1,4,8,12", "1"), ("--runs 4", "--runs 1")):
        assert part in line
        line = line.replace(part, less)
    options = line.partition(" -o")[0].split()
    done = sweep(tmp_path, *options, program=program, bench=bench)
    for row in done.stdout.splitlines()[-2:]:
        assert " ".join(row.split()) in re.sub(" +", " ", page)
