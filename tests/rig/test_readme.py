"""What the README shows works as it stands."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest
from click.testing import CliRunner

from trs80arm.bundled import described
from trs80arm.cli.commands import cli

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")


def test_the_python_example_prints_registers_and_place(capsys: pytest.CaptureFixture[str]) -> None:
    (example,) = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    exec(compile(example, "README.md", "exec"), {})
    registers, y = capsys.readouterr().out.rsplit(" ", 1)
    assert registers == "(100, 0, 0, 0, 0, 0)"
    assert float(y) == pytest.approx(0.53, abs=0.01)


def test_the_run_example_ends_well(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    (line,) = re.findall(r"^\.venv/bin/trs80arm (run .*)$", README, re.MULTILINE)
    empty = tmp_path / "settings.toml"
    empty.write_text("")
    monkeypatch.setenv("TRS80ARM_CONFIG", str(empty))
    monkeypatch.chdir(ROOT)
    done = CliRunner().invoke(cli, shlex.split(line))
    assert done.exit_code == 0
    assert len(done.stdout.splitlines()[-1].split()) == 6


def test_the_gallery_shows_every_task_in_the_words_of_the_list() -> None:
    page = (ROOT / "docs/gallery.md").read_text(encoding="utf-8").casefold()
    for bench in (ROOT / "programs").glob("*.toml"):
        if "[[goal]]" in bench.read_text(encoding="utf-8"):
            name = bench.stem
            assert f"## {name}\n\n{dict(described())[name]}".rstrip(".").casefold() in page
            assert f"](gallery/{name}.svg)" in page
            assert (ROOT / f"docs/gallery/{name}.svg").is_file()


def test_every_page_that_is_linked_is_there() -> None:
    for page in [ROOT / "README.md", *(ROOT / "docs").glob("*.md"), ROOT / "programs/README.md"]:
        text = page.read_text(encoding="utf-8")
        for target in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", text):
            assert (page.parent / target).exists(), f"{page.name} links {target}"
