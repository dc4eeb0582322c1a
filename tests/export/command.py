"""`trs80arm export`, as it is typed."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from click.testing import CliRunner

from trs80arm.cli.commands import cli


def run(*words: str | Path) -> tuple[int, str]:
    """The command's exit code and what it said."""
    result = CliRunner().invoke(cli, ["export", *map(str, words)], catch_exceptions=False)
    return result.exit_code, result.output


def refusal(words: Iterable[str], folder: Path) -> str:
    """The one line that it refuses words with, which have a folder for each `{}`."""
    code, told = run(*(word.format(folder) for word in words))
    assert code == 2
    assert told.count("\n") == 1
    return told
