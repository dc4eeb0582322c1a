"""Several programs run at once, and what is told of them."""

from __future__ import annotations

import json
from pathlib import Path
from xml.etree import ElementTree

import pytest
from click.testing import CliRunner, Result

from trs80arm.cli.commands import cli


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    Path("good.bas").write_text('10 INPUT A\n20 PRINT "<DONE>"CHR$(34)\n')
    Path("good.run.toml").write_text('inputs = ["1"]\n[expect]\noutput = "DONE"\n')
    Path("bad.bas").write_text('10 @STEP 50,100\n20 PRINT "A"\n')
    Path("bad.run.toml").write_text("[expect]\nregisters = [5, 0, 0, 0, 0, 0]\n")
    Path("error.bas").write_text("10 GOTO 99\n")
    return tmp_path


def run(*arguments: str) -> Result:
    return CliRunner().invoke(cli, ["run", *arguments])


@pytest.mark.usefixtures("folder")
def test_a_table_tells_of_each_program_in_the_order_given() -> None:
    done = run("good.bas", "bad.bas", "error.bas", "none.bas", "--jobs", "1")
    assert done.exit_code == 2
    rows = [line.split("│")[1:-1] for line in done.stdout.splitlines() if "│" in line]
    assert [(row[0].strip(), row[1].strip(), row[6].strip()) for row in rows] == [
        ("good.bas", "end in 20", "passed"),
        ("bad.bas", "end in 20", "failed"),
        ("error.bas", "error ?UL in 10", "failed"),
        ("none.bas", "", "unusable"),
    ]
    assert done.stdout.endswith("1 of 4 passed\n")
    assert done.stderr.splitlines() == [
        "trs80arm: bad.bas: registers: expected 5 0 0 0 0 0, not 100 0 0 0 0 0",
        "trs80arm: error.bas: ?UL Error in 10",
        "trs80arm: none.bas: No such file or directory",
    ]


@pytest.mark.usefixtures("folder")
def test_the_exit_code_says_the_worst() -> None:
    assert run("good.bas", "good.bas", "--jobs", "1").exit_code == 0
    assert run("good.bas", "error.bas", "--jobs", "1").exit_code == 1


@pytest.mark.usefixtures("folder")
def test_at_once_comes_to_the_same_as_one_after_the_other() -> None:
    def told(jobs: str) -> object:
        runs = json.loads(run("good.bas", "bad.bas", "--json", "--jobs", jobs).stdout)["runs"]
        for each in runs:
            del each["seconds"]["wall"]
        return runs

    assert told("2") == told("1")


@pytest.mark.usefixtures("folder")
def test_json_of_several_is_one_object() -> None:
    told = json.loads(run("good.bas", "bad.bas", "none.bas", "--json", "--jobs", "1").stdout)
    assert (told["passed"], told["failed"]) == (1, 2)
    good, bad, none = told["runs"]
    assert good["passed"]
    assert good["output"] == '? 1\n<DONE>"\n'
    assert bad["unmet"] == ["registers: expected 5 0 0 0 0 0, not 100 0 0 0 0 0"]
    assert none == {
        "program": "none.bas",
        "passed": False,
        "unmet": [],
        "unusable": "none.bas: No such file or directory",
    }


@pytest.mark.usefixtures("folder")
def test_junit_xml_has_a_case_for_each_program() -> None:
    run("good.bas", "bad.bas", "none.bas", "--junit", "j.xml", "--jobs", "1")
    (suite,) = ElementTree.parse("j.xml").getroot()
    counts = {name: suite.get(name) for name in ("tests", "failures", "errors", "skipped")}
    assert counts == {"tests": "3", "failures": "1", "errors": "1", "skipped": "0"}
    good, bad, none = suite.findall("testcase")
    assert good.get("name") == "good.bas"
    assert good.findtext("system-out") == '? 1\n<DONE>"'
    failure, error = bad.find("failure"), none.find("error")
    assert failure is not None
    assert "not 100 0 0 0 0 0" in failure.get("message", "")
    assert error is not None
    assert "No such file" in error.get("message", "")


@pytest.mark.usefixtures("folder")
def test_one_program_has_junit_xml_too() -> None:
    assert run("good.bas", "--junit", "j.xml").exit_code == 0
    assert ElementTree.parse("j.xml").getroot()[0].get("tests") == "1"


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize(
    ("options", "words"),
    [
        (("--trace", "t.csv"), "--trace is for one program, not for 2"),
        (("--script", "good.run.toml"), "--script is for one program"),
        (("--registers",), "--screen, --registers and --pose are of one program"),
        (("--printer", "paper.txt"), "--printer is for one program"),
        (("--junit", "none/j.xml", "--jobs", "1"), "none/j.xml: No such file"),
    ],
)
def test_what_cannot_be_is_one_line(options: tuple[str, ...], words: str) -> None:
    done = run("good.bas", "good.bas", *options)
    assert done.exit_code == 2
    assert done.stderr.startswith(f"trs80arm: {words}")
    assert done.stderr.count("\n") == 1
