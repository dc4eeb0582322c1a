"""Every example of the ARMBASIC manual prints what the manual says."""

from __future__ import annotations

import io
import re
from dataclasses import dataclass
from pathlib import Path

import pytest

from trs80arm.batch import BatchOptions, run_program

MANUAL = Path(__file__).parents[2] / "docs" / "armbasic.md"
EXAMPLE = re.compile(
    r"^```armbasic(?P<options>[^\n]*)\n(?P<program>.*?)^```\n\n^```output\n(?P<output>.*?)^```$",
    re.MULTILINE | re.DOTALL,
)
OPTION = re.compile(r'(\w+)="([^"]*)"')


@dataclass
class Example:
    """A program of the manual, what the operator does, and what it prints."""

    statement: str
    program: str
    sets: tuple[str, ...]
    output: str


def examples() -> list[Example]:
    text = MANUAL.read_text("utf-8")
    found = []
    for match in EXAMPLE.finditer(text):
        heading = re.findall(r"^## (@\w+)", text[: match.start()], re.MULTILINE)[-1]
        options = OPTION.findall(match["options"])
        assert all(name == "set" for name, _ in options)
        sets = tuple(value for _, value in options)
        found.append(Example(heading, match["program"], sets, match["output"]))
    return found


def test_each_statement_has_an_example_and_no_example_is_overlooked():
    text = MANUAL.read_text("utf-8")
    statements = [example.statement for example in examples()]
    assert statements == ["@STEP", "@CLOSE", "@SET", "@RESET", "@READ"]
    assert text.count("```armbasic") == len(statements)


@pytest.mark.parametrize("example", examples(), ids=lambda example: example.statement)
def test_example(example, tmp_path):
    program = tmp_path / "example.bas"
    program.write_text(example.program)
    printed = io.StringIO()
    code = run_program(BatchOptions(program=program, sets=example.sets, seconds=60), printed)
    assert [line.rstrip() for line in printed.getvalue().splitlines()] == [
        line.rstrip() for line in example.output.splitlines()
    ]
    assert code == 0
