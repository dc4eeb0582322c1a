"""No command shows a traceback, whatever files and options it is given."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from trs80arm.cli import cli, main

FILES = {
    "none": None,
    "empty": b"",
    "zeros": b"\0" * 64,
    "crunched": b"\xff\x01\x02",
    "cassette": b"\0\0\xa5\xd3\xd3\xd3A\x3c",
    "text": b"HELLO\n",
    "latin": bytes(range(1, 256)),
    "toml": b"[[part]]\nname = 3\n",
    "broken": b"a = [[[",
}
COMMANDS = (
    ["check", "{}"],
    ["check", "{}", "--format", "sarif"],
    ["run", "{}", "--seconds", "1"],
    ["run", "{}", "table2", "--seconds", "1", "--jobs", "1"],
    ["run", "{}", "--seconds", "1", "--junit", "{}/x.xml"],
    ["run", "table2", "--seconds", "1", "--bench", "{}"],
    ["run", "table2", "--seconds", "1", "--script", "{}"],
    ["run", "table2", "--seconds", "1", "--config", "{}"],
    ["run", "table2", "--seconds", "1", "--trace", "{}"],
    ["run", "table2", "--seconds", "1", "--trace-pose", "{}/t.npz"],
    ["convert", "{}", "{}.cas"],
    ["figure", "{}"],
    ["film", "{}", "-o", "{}.nonsense"],
)


def end_of(arguments: list[str], monkeypatch: pytest.MonkeyPatch) -> object:
    monkeypatch.setattr(sys, "argv", ["trs80arm", *arguments])
    try:
        main()
    except SystemExit as ending:
        return ending.code
    return 0


@pytest.fixture(autouse=True)
def no_settings(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    (tmp_path / "settings.toml").write_text("")
    monkeypatch.setenv("TRS80ARM_CONFIG", str(tmp_path / "settings.toml"))
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize("name", [*FILES, "folder"])
def test_wrong_files_are_told_in_lines(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / name
    for command in COMMANDS:
        content = FILES.get(name)
        if name == "folder":
            path.mkdir(exist_ok=True)
        elif content is not None:
            path.write_bytes(content)
        code = end_of([word.replace("{}", str(path)) for word in command], monkeypatch)
        told = capfd.readouterr()
        assert code in (0, 1, 2), command
        assert "Traceback" not in told.out + told.err, command
        assert not list(tmp_path.glob("**/*crash*")), command
        if code == 2:
            assert told.err.startswith("trs80arm: "), command


@pytest.mark.parametrize("command", sorted(cli.commands))
@pytest.mark.parametrize("option", ["--nonsense", "--option=x", "--jobs=x", "--format=7", "-o"])
def test_wrong_options_are_one_line_and_code_2(
    command: str, option: str, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    assert end_of([command, "table2", option], monkeypatch) == 2
    told = capfd.readouterr()
    assert told.err.startswith("trs80arm: ")
    assert told.err.count("\n") == 1
