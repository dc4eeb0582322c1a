"""docs/api.md: its examples run, and its reference is what the docstrings say."""

from __future__ import annotations

import re
import runpy
from pathlib import Path

import pytest

DOCS = Path(__file__).parents[2] / "docs"
PAGE = (DOCS / "api.md").read_text(encoding="utf-8")


def test_the_examples_run_one_after_the_other(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    examples = list(re.finditer(r"```python\n(.*?)```", PAGE, re.DOTALL))
    for example in examples:
        line = PAGE[: example.start(1)].count("\n")
        exec(compile("\n" * line + example[1], str(DOCS / "api.md"), "exec"), names)
    assert len(examples) == 8
    assert (tmp_path / "moment.snapshot").is_file()


def test_the_reference_is_what_the_docstrings_say() -> None:
    assert runpy.run_path(str(DOCS / "make_api.py"))["page"]() == PAGE, "run docs/make_api.py"


def test_everything_public_of_a_rig_is_in_the_reference() -> None:
    from trs80arm.rig import Rig

    public = {name for name in vars(Rig) if not name.startswith("_")}
    assert public == set(re.findall(r"^### `Rig\.(\w+)", PAGE, re.MULTILINE))
