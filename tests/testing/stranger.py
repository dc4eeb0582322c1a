"""A stranger's small repository: the one that docs/testing.md leads to, file by file."""

from __future__ import annotations

import re
from pathlib import Path

WORKFLOW = ".github/workflows/arm.yml"
PAGE = Path(__file__).parents[2] / "docs/testing.md"
_FILE = re.compile(r"^`([\w./-]+)`:\n\n```\w*\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def files() -> dict[str, str]:
    """What the page has the reader write, by path."""
    return dict(_FILE.findall(PAGE.read_text(encoding="utf-8")))


def settle(folder: Path) -> None:
    """Write the repository into a folder."""
    for name, text in files().items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def steps() -> list[str]:
    """What the page's workflow does when trs80arm is installed."""
    commands: list[str] = re.findall(r"^ +- run: (.*)$", files()[WORKFLOW], re.MULTILINE)
    install, *others = commands
    assert install.startswith("pip install")
    return others


def hurry(folder: Path) -> None:
    """Change D from 50 to 5, as somebody would who finds the arm slow."""
    program = folder / "arm/fetch.bas"
    program.write_text(program.read_text().replace("D=50", "D=5"))
