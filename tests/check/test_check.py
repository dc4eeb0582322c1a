"""`trs80arm check`: programs are read without running them."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from click.testing import CliRunner, Result
from hypothesis import given
from hypothesis import strategies as st

from tests.check.conftest import Check
from trs80arm.check.findings import RULES, Level, Rule
from trs80arm.check.program import check_bytes, check_program
from trs80arm.cli.commands import cli
from trs80arm.files import Kind, encode_program, parse_program, save_program
from trs80arm.rig import Rig

ROOT = Path(__file__).parents[2]
PERIOD = ROOT / "tests/programs_of_the_period/programs"
PROGRAMS = sorted(
    [
        *(ROOT / "programs").glob("*.bas"),
        *(ROOT / "benchmarks/basic").glob("*.bas"),
        *PERIOD.glob("*.bas"),
    ]
)
WRONG_ON_PURPOSE = {
    # It makes its line 201 with a POKE.
    "selfmod.bas": [(170, Rule.MISSING_LINE)],
    # It raises every error that a program can trap.
    "trapped.bas": [
        (160, Rule.MISSING_LINE),
        (200, Rule.TYPE),
        (240, Rule.SYNTAX),
        (250, Rule.DISK_BASIC),
    ],
}
NOTED = {
    # The shared lines turn the hand by AN, which these leave at 0.
    **{
        f"programs/{name}.bas": {"AN": 4010}
        for name in ("bridge", "carousel", "draughts", "hanoi", "pallet", "sort", "tending")
    },
    # Its numbers are to be set before it is started; programs/README.md says so.
    "programs/table2.bas": {
        **dict.fromkeys(("S", "P1", "P2", "P3", "P4", "P5"), 10),
        **dict.fromkeys(("Q1", "Q2", "Q3", "Q4", "Q5"), 40),
        **dict.fromkeys(("R1", "R2", "R3", "R4", "R5"), 50),
        "GR": 60,
    },
    # The misprints of the article (programs/README.md).
    "programs/table3-as-printed.bas": {"GC": 200},
    "programs/table4-as-printed.bas": {"S2": 230, "S5": 260},
    # "N T" is the name NT, blank or not.
    "tests/programs_of_the_period/programs/primes.bas": {"NT": 120},
}
"""Variables that nothing sets in programs that run, and where they are read first."""
UNREACHED = {"checks": [50]}


def command(*arguments: object) -> Result:
    return CliRunner().invoke(cli, ["check", *map(str, arguments)])


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: path.stem)
def test_programs_that_run_raise_no_false_alarm(path: Path) -> None:
    found = [(each.number, each.rule) for each in check_program(path)]
    noted = [(line, Rule.NEVER_SET) for line in NOTED.get(str(path.relative_to(ROOT)), {}).values()]
    noted += [(line, Rule.UNREACHED) for line in UNREACHED.get(path.stem, [])]
    assert found == [*WRONG_ON_PURPOSE.get(path.name, []), *noted]


@pytest.mark.parametrize("name", NOTED)
def test_what_is_noted_of_programs_that_run_are_names_that_nothing_sets(name: str) -> None:
    told = [each.text for each in check_program(ROOT / name) if each.rule is Rule.NEVER_SET]
    assert told == [f"nothing sets {variable}: it is 0" for variable in NOTED[name]]


@pytest.mark.parametrize(
    "statement",
    [
        "GOTO 99",
        "GOSUB 99",
        "RUN 99",
        "IF A THEN 99",
        "IF A GOTO 99",
        "IF A THEN GOSUB 99 ELSE PRINT",
        "IF A THEN 10 ELSE 99",
        "IF A THEN PRINT 1:PRINT 2 ELSE 99",
        "ON A GOTO 10,99",
        "ON A GOSUB 99,10",
        "ON ERROR GOTO 99",
        "RESUME 99",
        "INPUT A:GOTO 99",
        'PRINT "A:B":GOTO 99',
    ],
)
def test_every_jump_to_a_missing_line_is_found_once(check: Check, statement: str) -> None:
    told = check(f"5 A=1\n10 {statement}\n")
    (found,) = [each for each in told if each.level is Level.ERROR]
    assert (found.rule, found.place, found.number) == (Rule.MISSING_LINE, 2, 10)
    assert "no line 99" in found.text


@pytest.mark.parametrize(
    ("statement", "rule"),
    [
        ("PRIMT", Rule.SYNTAX),
        ("A=1 B=2", Rule.SYNTAX),
        ("A=(1", Rule.SYNTAX),
        ("A=1+", Rule.SYNTAX),
        ("RESTORE 10", Rule.SYNTAX),
        ("RETURN 5", Rule.SYNTAX),
        ("INPUT A,5", Rule.SYNTAX),
        ("READ A;B", Rule.SYNTAX),
        ("IF A INPUT 5", Rule.SYNTAX),
        ('INPUT "NAME" N$', Rule.SYNTAX),
        ("A$=1", Rule.TYPE),
        ("IF A$ THEN 10", Rule.TYPE),
        ("OPEN 1", Rule.DISK_BASIC),
        ("@HOME", Rule.SYNTAX),
        ("@STEP 50,1,2,3,4,5,6,7", Rule.STEP_VALUES),
        ("IF A @STEP 50,1,2,3,4,5,6,7,8", Rule.STEP_VALUES),
        ("@READ A$", Rule.TYPE),
    ],
)
def test_a_wrong_statement_is_found_once(check: Check, statement: str, rule: Rule) -> None:
    assert [each.rule for each in check(f'5 A=1:A$=""\n10 {statement}\n')] == [rule]


@pytest.mark.parametrize(
    "text",
    [
        "10 REM GOTO 99 : A=\n",
        "10 A=1 'GOTO 99\n",
        '10 DATA GOTO 99,A=,"X:Y",SPEED\n20 SPAN=1\n',
        "10 LIST 99\n20 DELETE 99\n",
        '10 DEFSTR A:A=CHR$(65)\n20 PRINT A+"B"\n',
        '10 INPUT "X";A,B$(3):INPUT #-1,C,D$\n',
        "10 @STEP 50,1,2,3,4,5,6:@READ A,B,C,D,E,F\n",
        '10 SPEED=1:SPEED$="A":SPAN(1)=2:SPEED=SP%\n',
        "10 A=1E5:B=.5E-3\n",
        "",
    ],
)
def test_what_the_machine_takes_is_not_told(check: Check, text: str) -> None:
    assert check(text) == []


def test_the_error_that_is_told_is_the_one_that_the_machine_shows(check: Check) -> None:
    for statement in ("GOTO 99", "A=1+", "A$=1", "OPEN 1", "PRIMT", "@STEP 1,1,1,1,1,1,1,1"):
        (found,) = check(f"10 {statement}\n")
        rig = Rig()
        rig.type(f"10 {statement}\rRUN\r")
        rig.run_until_waiting()
        shown = found.text[found.text.rindex("?") : -1]
        assert any(line.startswith(shown) for line in rig.screen()), statement


def test_names_that_are_one_variable_are_told_where_the_second_stands(check: Check) -> None:
    (found,) = check("10 SPEED=1\n20 PRINT SPEED\n30 SPAN=2:SPAN=3\n")
    assert (found.rule, found.number, found.column) == (Rule.SAME_VARIABLE, 30, 4)
    assert found.text == "SPAN is the same variable as SPEED in line 10: only SP counts"


def test_places_are_lines_of_the_file_and_columns_of_the_line(check: Check) -> None:
    found = check("\n10 PRINT\n\nHELLO\n10 GOTO 30\n")
    assert [(each.place, each.rule) for each in found] == [
        (4, Rule.NO_LINE),
        (5, Rule.LINE_TWICE),
        (5, Rule.MISSING_LINE),
    ]
    assert found[2].column == len("10 GOTO 30") + 1


def test_crunched_programs_and_cassettes_are_read_too(tmp_path: Path) -> None:
    lines = parse_program(b"10 PRINT\n20 GOTO 99\n")
    for name in ("p.bas", "p.cas"):
        save_program(tmp_path / name, lines)
        (found,) = check_program(tmp_path / name)
        assert (found.place, found.number) == (2, 20)


def test_a_program_too_large_for_any_machine_is_told_as_that(check: Check) -> None:
    text = "".join(f'{n} PRINT "{"X" * 200}":GOTO 9\n' for n in range(9, 309))
    assert [each.rule for each in check(text)] == [Rule.MEMORY]


@given(st.lists(st.binary(min_size=1, max_size=40), max_size=4))
def test_any_bytes_are_read_without_a_fault(texts: list[bytes]) -> None:
    lines = [(10 * n, text.replace(b"\0", b"A")) for n, text in enumerate(texts, start=1)]
    data = encode_program(lines, Kind.CRUNCHED)
    assert all(found.text for found in check_bytes(Path("p.bas"), data))


# -- the command -----------------------------------------------------------------------------------


@pytest.fixture
def wrong(tmp_path: Path) -> Path:
    path = tmp_path / "wrong.bas"
    path.write_text("10 SPEED=1:SPAN=2\n20 GOTO 99\n")
    return path


def test_lines_are_as_editors_read_them(wrong: Path) -> None:
    done = command(wrong)
    assert done.exit_code == 1
    assert done.stdout.splitlines() == [
        f"{wrong}:1: warning: SPAN is the same variable as SPEED in line 10: only SP counts"
        " [same-variable]",
        f"{wrong}:2: error: there is no line 99 (?UL) [missing-line]",
    ]


def test_nothing_is_said_of_a_program_in_order() -> None:
    done = command("table4", "table3")
    assert (done.exit_code, done.stdout, done.stderr) == (0, "", "")


def test_warnings_alone_are_no_failure_unless_strict(tmp_path: Path) -> None:
    path = tmp_path / "p.bas"
    path.write_text("10 SPEED=1:SPAN=2\n")
    assert command(path).exit_code == 0
    assert command(path, "--strict").exit_code == 1


def test_json_counts_and_places_the_findings(wrong: Path) -> None:
    told = json.loads(command(wrong, "--format", "json").stdout)
    assert (told["errors"], told["warnings"], told["notes"]) == (1, 1, 0)
    assert (told["files"], told["unusable"]) == ([str(wrong)], [])
    assert told["findings"][1] == {
        "file": str(wrong),
        "line": 2,
        "column": 11,
        "number": 20,
        "rule": "missing-line",
        "level": "error",
        "text": "there is no line 99 (?UL)",
    }


SCHEMA = json.loads((Path(__file__).parent / "sarif/sarif-2.1.0-rtm.5.json").read_text())
"""The schema of SARIF 2.1.0; where it is from and its licence stand beside it."""


@pytest.mark.parametrize("places", [["wrong.bas"], ["none.bas", "wrong.bas"], ["empty.bas"]])
def test_sarif_is_what_its_schema_says(
    wrong: Path, tmp_path: Path, places: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "empty.bas").write_text("")
    log: dict[str, Any] = json.loads(command(*places, "--format", "sarif").stdout)
    jsonschema.Draft7Validator(SCHEMA).validate(log)
    (run,) = log["runs"]
    rules = run["tool"]["driver"]["rules"]
    assert [rule["id"] for rule in rules] == list(RULES)
    for result in run["results"]:
        assert rules[result["ruleIndex"]]["id"] == result["ruleId"]
    (invocation,) = run["invocations"]
    assert invocation["executionSuccessful"] == ("none.bas" not in places)


@pytest.mark.parametrize("rule", RULES.values(), ids=RULES)
def test_a_code_host_can_show_what_a_rule_is(rule: Rule) -> None:
    """What GitHub asks of a rule beside the schema: two descriptions and a help."""
    assert re.fullmatch(r"[a-z]+(-[a-z]+)*", rule.label)
    assert rule.sentence.endswith((".", ")."))
    assert rule.remedy.endswith(".")
    assert f"| `{rule.label}` | {rule.level.value} |" in (ROOT / "docs/manual.md").read_text()


def test_a_relative_file_stays_relative_in_sarif(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("my arm.bas").write_text("10 GOTO 99\n")
    log = json.loads(command("my arm.bas", "--format", "sarif").stdout)
    place = log["runs"][0]["results"][0]["locations"][0]["physicalLocation"]
    assert place["artifactLocation"] == {"uri": "my%20arm.bas", "uriBaseId": "%SRCROOT%"}
    whole = json.loads(command(Path("my arm.bas").resolve(), "--format", "sarif").stdout)
    assert whole == log


@pytest.mark.parametrize(
    ("content", "options"),
    [
        (None, ()),
        (b"\x00\x01\x02\x00", ()),
        (b"\xff\x01", ()),
        (b"\xa5\xd3\xd3\xd3A", ()),
        (b"", ("--format", "xml")),
        (b"", ("--nonsense",)),
        (b"", ("--ignore", "nonsense")),
    ],
)
def test_a_wrong_file_or_option_is_one_line_and_code_2(
    tmp_path: Path, content: bytes | None, options: tuple[str, ...]
) -> None:
    path = tmp_path / "p.bas"
    if content is not None:
        path.write_bytes(content)
    done = command(path, *options)
    assert done.exit_code == 2
    assert "Traceback" not in done.output
    if not options:
        assert done.stderr.startswith("trs80arm: ")
        assert done.stderr.count("\n") == 1


def test_the_others_are_read_when_one_is_no_program(wrong: Path, tmp_path: Path) -> None:
    done = command(wrong, tmp_path / "none.bas", tmp_path / "none.bas" / "p.bas")
    assert done.exit_code == 2
    assert "no line 99" in done.stdout
    assert done.stderr.count("\n") == 2


def test_of_a_folder_all_programs_are_read(wrong: Path, tmp_path: Path) -> None:
    (tmp_path / "deep/.hidden").mkdir(parents=True)
    save_program(tmp_path / "deep/tape.CAS", parse_program(b"10 GOTO 5\n"))
    (tmp_path / "deep/.hidden/p.bas").write_text("10 GOTO 7\n")
    (tmp_path / "notes.txt").write_text("10 GOTO 8\n")
    told = json.loads(command(tmp_path, "--format", "json").stdout)
    assert told["files"] == [str(tmp_path / "deep/tape.CAS"), str(wrong)]


def test_a_folder_without_programs_is_told(tmp_path: Path) -> None:
    done = command(tmp_path)
    assert (done.exit_code, done.stdout) == (2, "")
    assert done.stderr == f"trs80arm: {tmp_path}: a folder without programs (.bas, .cas)\n"


def test_standard_input_is_a_program() -> None:
    done = CliRunner().invoke(cli, ["check", "-"], input="10 GOTO 99\n")
    assert (done.exit_code, done.stdout) == (
        1,
        "stdin:1: error: there is no line 99 (?UL) [missing-line]\n",
    )
    done = CliRunner().invoke(cli, ["check", "-"], input=b"\xff\x01")
    assert done.exit_code == 2
    assert done.stderr.startswith("trs80arm: stdin: ")


def test_a_rule_can_be_ignored(wrong: Path) -> None:
    done = command(wrong, "--ignore", "missing-line", "--ignore", "same-variable")
    assert (done.exit_code, done.output) == (0, "")


def test_notes_are_no_failure(tmp_path: Path) -> None:
    path = tmp_path / "p.bas"
    path.write_text("10 PRINT A\n")
    done = command(path, "--strict")
    assert (done.exit_code, "note: nothing sets A" in done.stdout) == (0, True)
